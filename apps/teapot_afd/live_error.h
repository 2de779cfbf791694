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

/// The errors found in one picture. Units: pixels.
struct live_result {
    /// Whether the errors are known. If the exact renderer gave up, they are not, and the map has
    /// nothing but NaN.
    bool is_known = true;
    /// The largest error of an outline.
    double outline_px = 0;
    /// The largest error of a depth, as reference::depth_error_px counts it.
    double depth_px = 0;
    /// The share of the exact picture's pixels whose depth was compared.
    double judged = 0;
    /// All errors, pixel by pixel.
    reference::error_map map;
};

/// A model. It equals its copies, and no other model.
struct shown_model {
    std::optional<l3d_patch_model> model;

    friend bool operator==(const shown_model& a, const shown_model& b) {
        return a.identity() == b.identity();
    }

private:
    const void* identity() const { return model ? model->identity() : nullptr; }
};

/// The settings for which the error of a picture is measured.
struct live_subject {
    shown_model model;
    l3d_camera camera;
    l3d_size size;
    double tolerance = 0;
    std::string method;

    friend bool operator==(const live_subject&, const live_subject&) = default;
};

/// Pictures of one view, drawn in several ways.
struct live_task {
    l3d_patch_model model;
    l3d_camera camera;
    l3d_size size;
    /// The distances of each picture, row by row.
    std::vector<std::vector<float>> distances;
};

/// Whether the exact renderer can draw the same picture. It always draws both sides of a model, and
/// everything beyond the near plane.
bool has_exact_picture(const l3d_patch_model& model, const l3d_camera& camera,
                       const l3d_afd_settings& settings);

/// Compares pictures with the exact picture, on a thread of its own.
///
/// Lives:   shares the data of a task's model. The destructor gives up a comparison that is under
///          way.
class live_error {
public:
    /// Starts the thread. A modest thread leaves most of a busy processor to others, so that frames
    /// take as long as without it. A thread that is not modest has its results soon, for callers
    /// who wait. If the system makes no thread, or memory runs out, errors stay unknown.
    explicit live_error(bool is_modest);
    live_error(const live_error&) = delete;
    live_error& operator=(const live_error&) = delete;

    /// Whether a task would be begun at once.
    bool is_idle() const;
    /// Begins a task. Expects: is_idle().
    void begin(live_task task);
    /// The whole seconds for which the task has been measured; 0 without a task.
    int seconds() const;
    /// Gives the results of a task once, one for each picture; empty while there are none.
    std::vector<live_result> take_results();
    /// Whether take_results() would give results.
    bool has_results() const;
    /// Waits for the task that was begun last. A line on a terminal tells how long it has taken.
    void wait() const;

private:
    void run(const std::stop_token& stop, bool is_modest);
    std::vector<live_result> results_of(const live_task& task, const std::stop_token& stop);
    std::vector<live_result> measured(const live_task& task, const std::stop_token& stop);

    /// The thread's own view, and the model that it shows.
    std::optional<measured_view> view_;
    shown_model viewed_;
    mutable std::mutex mutex_;
    mutable std::condition_variable_any changed_;
    /// The present task, until it is done.
    std::optional<live_task> task_;
    std::chrono::steady_clock::time_point begun_; ///< the time of begin()
    std::vector<live_result> results_;
    std::jthread thread_;
};

#endif
