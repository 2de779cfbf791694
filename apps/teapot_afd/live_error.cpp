// SPDX-License-Identifier: MIT
// live_error: measures in a thread that lets others go first.
#include "live_error.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <limits>
#include <system_error>
#include <utility>

namespace {

/// The most distances that are measured: enough to find an error as large as the largest, few
/// enough for several results a second.
constexpr int most_distances = 500;

double largest_of(const std::vector<float>& values) {
    double largest = 0;
    for (const float value : values)
        if (std::isfinite(value))
            largest = std::max(largest, static_cast<double>(value));
    return largest;
}

live_result unknown(std::size_t pixels) {
    live_result result;
    result.is_known = false;
    const std::vector<float> nothing(pixels, std::numeric_limits<float>::quiet_NaN());
    result.map.depth = result.map.outline = nothing;
    result.map.holes.assign(pixels, false);
    return result;
}

std::vector<live_result> all_unknown(const live_task& task) {
    std::vector<live_result> results;
    for (const auto& distances : task.distances)
        results.push_back(unknown(distances.size()));
    return results;
}

} // namespace

bool has_exact_picture(const l3d_patch_model& model, const l3d_camera& camera,
                       const l3d_afd_settings& settings) {
    double farthest = 0;
    for (const double x : {model.least()[0], model.most()[0]})
        for (const double y : {model.least()[1], model.most()[1]})
            for (const double z : {model.least()[2], model.most()[2]})
                farthest = std::max(farthest, camera.depth_of({x, y, z}));
    return !settings.one_sided && !model.has_trims() && farthest < camera.far_z;
}

live_error::live_error(bool is_modest) {
    try {
        thread_ = std::jthread([this, is_modest](const std::stop_token& s) { run(s, is_modest); });
    } catch (const std::system_error&) {
        // Without a thread, begin() does nothing.
    }
}

bool live_error::is_idle() const {
    const std::lock_guard lock(mutex_);
    return !task_;
}

void live_error::begin(live_task task) {
    {
        const std::lock_guard lock(mutex_);
        if (!thread_.joinable()) {
            results_ = all_unknown(task);
            return;
        }
        task_ = std::move(task);
        begun_ = std::chrono::steady_clock::now();
    }
    changed_.notify_all();
}

int live_error::seconds() const {
    const std::lock_guard lock(mutex_);
    if (!task_)
        return 0;
    const auto passed = std::chrono::steady_clock::now() - begun_;
    return static_cast<int>(std::chrono::floor<std::chrono::seconds>(passed).count());
}

bool live_error::has_results() const {
    const std::lock_guard lock(mutex_);
    return !results_.empty();
}

std::vector<live_result> live_error::take_results() {
    const std::lock_guard lock(mutex_);
    return std::exchange(results_, {});
}

void live_error::wait() const {
    constexpr const char* erase = "\r\x1b[K"; // to the line's start, and all after it
    const bool is_told = ::isatty(STDERR_FILENO) == 1;
    const auto is_done = [this] { return !task_; };
    bool has_line = false;
    for (int seconds = 1;; ++seconds) {
        std::unique_lock lock(mutex_);
        if (changed_.wait_until(lock, begun_ + std::chrono::seconds(seconds), is_done))
            break;
        lock.unlock();
        if (is_told)
            std::cerr << erase << "measuring the error: " << seconds << " s" << std::flush;
        has_line = is_told;
    }
    if (has_line)
        std::cerr << erase << std::flush;
}

void live_error::run(const std::stop_token& stop, bool is_modest) {
    // Gives this thread a tenth of a frame thread's time where both want the same processor. Linux
    // keeps such a value for each thread; where that fails, frames are slower.
    constexpr int modest_nice = 10;
    if (is_modest)
        ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), modest_nice);
    for (std::unique_lock lock(mutex_);;) {
        if (!changed_.wait(lock, stop, [this] { return task_.has_value(); }))
            return;
        const live_task task = *task_;
        lock.unlock();
        std::vector<live_result> results;
        try {
            results = results_of(task, stop);
        } catch (const std::exception&) {
            // Memory is too short even for empty maps. A later task may have enough.
        }
        lock.lock();
        results_ = std::move(results);
        task_.reset();
        changed_.notify_all();
    }
}

/// Finds the results of a task. They are unknown if the exact renderer gives up. It does so if the
/// near plane cuts a patch whose farthest point is a million times as far away.
std::vector<live_result> live_error::results_of(const live_task& task,
                                                const std::stop_token& stop) {
    try {
        return measured(task, stop);
    } catch (const std::exception&) {
        return all_unknown(task);
    }
}

std::vector<live_result> live_error::measured(const live_task& task, const std::stop_token& stop) {
    const shown_model model{task.model};
    if (!view_ || view_->camera() != task.camera || view_->size() != task.size || viewed_ != model)
        view_.emplace("", task.model, task.camera, task.size, stop);
    viewed_ = model;
    std::vector<live_result> results;
    for (const auto& distances : task.distances) {
        auto errors = view_->errors(distances, most_distances);
        results.push_back({true, largest_of(errors.outline), largest_of(errors.depth),
                           errors.depth_share(), std::move(errors)});
    }
    return results;
}
