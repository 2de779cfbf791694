// SPDX-License-Identifier: MIT
// live_error: measures how far pictures are off while others are drawn.
#ifndef L3D_APPS_TEAPOT_AFD_LIVE_ERROR_H
#define L3D_APPS_TEAPOT_AFD_LIVE_ERROR_H

#include "frame_measure.h"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

/// What was found about one picture. Units: pixels.
struct live_result {
    double outline_px = 0; ///< the largest error of an outline
    double depth_px = 0;   ///< the largest error of a depth, as reference::depth_error_px counts it
    double judged = 0;     ///< the part of the exact picture's pixels whose depth was compared
};

/// Pictures of one view, drawn in several ways.
struct live_task {
    l3d_camera camera;
    l3d_size size;
    std::vector<std::vector<float>> distances; ///< of each picture, row by row
};

/// Compares pictures with the exact one, on a thread of its own.
///
/// Lives: shares the model's data. Its end waits for the comparison that is being made.
class live_error {
public:
    /// A modest one leaves most of a busy processor to others, so frames take as long as without
    /// it. One that is not has its results soon, for those who wait for them.
    live_error(const l3d_patch_model& model, bool is_modest);
    live_error(const live_error&) = delete;
    live_error& operator=(const live_error&) = delete;
    ~live_error();

    /// Whether a task would be begun at once.
    bool is_idle() const;
    /// Expects: is_idle().
    void begin(live_task task);
    /// The results of a task, a picture each, once; empty while there are none.
    std::vector<live_result> take_results();
    /// Whether take_results() has some.
    bool has_results() const;
    /// Waits for the task that was begun last.
    void wait() const;

private:
    void run(bool is_modest);

    l3d_patch_model model_;
    std::optional<measured_view> view_; ///< the thread's own
    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    std::optional<live_task> task_; ///< until it is done
    std::vector<live_result> results_;
    bool ends_ = false;
    std::thread thread_;
};

#endif
