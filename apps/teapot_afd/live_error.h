// SPDX-License-Identifier: MIT
// live_error: measures the errors of pictures while others are drawn.
#ifndef L3D_APPS_TEAPOT_AFD_LIVE_ERROR_H
#define L3D_APPS_TEAPOT_AFD_LIVE_ERROR_H

#include "frame_measure.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

/// The measured errors of one picture. Units: pixels.
struct live_result {
    /// Whether the errors are known. They are unknown if the exact renderer gave up; then the map
    /// has nothing but NaN.
    bool is_known = true;
    /// The largest error of a place on an outline.
    double outline_px = 0;
    /// The largest error of a depth, as reference::depth_error_px counts it.
    double depth_px = 0;
    /// The share of the exact picture's pixels in which depths could be compared.
    double judged = 0;
    /// The error of each pixel.
    reference::error_map map;
};

/// A model, to be compared: it equals its copies, and no other model.
struct shown_model {
    std::optional<l3d_patch_model> model;

    friend bool operator==(const shown_model& a, const shown_model& b) {
        return a.identity() == b.identity();
    }

private:
    const void* identity() const { return model ? model->identity() : nullptr; }
};

/// All that the error of a picture depends on. If a later picture has an equal subject, its error
/// need not be measured again.
struct live_subject {
    shown_model model;
    l3d_camera camera;
    l3d_size size;
    double tolerance = 0;
    std::string method;

    friend bool operator==(const live_subject&, const live_subject&) = default;
};

/// A task for live_error: pictures of one view, drawn in several ways, whose errors are to be
/// measured.
struct live_task {
    l3d_patch_model model;
    l3d_camera camera;
    l3d_size size;
    /// For each picture, the distances of its pixels, row by row.
    std::vector<std::vector<float>> distances;
};

/// Whether the exact renderer can draw the picture that these settings ask for. It always draws
/// both sides of a model, and everything beyond the near plane.
bool has_exact_picture(const l3d_patch_model& model, const l3d_camera& camera,
                       const l3d_afd_settings& settings);

/// Measures the errors of pictures, by the exact picture, on a thread of its own while other
/// pictures are drawn.
///
/// Lives:   shares the data of a task's model. The destructor ends a measurement that is under way.
class live_error {
public:
    /// Starts the thread. A modest thread leaves most of a busy processor to other threads, so that
    /// frames take as long as without measuring. A thread that is not modest has its results soon,
    /// for callers who wait. If the system gives no thread, or memory runs out, errors stay
    /// unknown.
    explicit live_error(bool is_modest);
    live_error(const live_error&) = delete;
    live_error& operator=(const live_error&) = delete;

    /// Whether no task is under way, so that begin() may be called.
    bool is_idle() const;
    /// Begins a task. Expects: is_idle().
    void begin(live_task task);
    /// The time for which the present task has been measured, in whole seconds; 0 without a task.
    int seconds() const;
    /// Hands over the results of the last task, one for each picture. It is empty if the results
    /// are not there yet, or were taken before.
    std::vector<live_result> take_results();
    /// Whether take_results() would give results.
    bool has_results() const;
    /// Waits until the last task is done. A line on a terminal tells how long it has taken so far.
    void wait() const;

private:
    void run(const std::stop_token& stop, bool is_modest);
    std::vector<live_result> results_of(const live_task& task, const std::stop_token& stop);
    std::vector<live_result> measured(const live_task& task, const std::stop_token& stop);

    /// The thread's view of the last task, and the view's model.
    std::optional<measured_view> view_;
    shown_model viewed_;
    mutable std::mutex mutex_;
    mutable std::condition_variable_any changed_;
    /// The present task, until it is done.
    std::optional<live_task> task_;
    std::chrono::steady_clock::time_point begun_; ///< the time at which begin() was called
    std::vector<live_result> results_;
    std::jthread thread_;
};

#endif
