// SPDX-License-Identifier: MIT
// A screen and a pipeline that write down what is asked of them.
#ifndef L3D_TESTS_SYSTEM_FAKES_H
#define L3D_TESTS_SYSTEM_FAKES_H

#include "tool_2d/image.h"
#include "tool_2d/screen.h"
#include "pipeline/pipeline.h"
#include "raster/parallel/workers.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using call_log = std::vector<std::string>;

inline auto count_of(const call_log& log, const std::string& call) {
    return std::count(log.begin(), log.end(), call);
}

inline l3d_event make_event(l3d_event_type type) {
    l3d_event event;
    event.type = type;
    return event;
}

inline l3d_event make_key(int key) {
    l3d_event event = make_event(l3d_event_type::key_press);
    event.key = key;
    return event;
}

/// A screen whose events the test prepares. Logs "show", "show part", "fullscreen" and "window
/// again".
class fake_screen final : public l3d_screen {
public:
    explicit fake_screen(call_log& log) : log_(log) {}

    std::deque<l3d_event> pending;               ///< there before the dispatcher starts
    std::deque<std::vector<l3d_event>> arrivals; ///< each comes during one wait
    std::chrono::nanoseconds longest_wait{0};
    int waits = 0;
    bool window = true;
    bool busy = false;
    double fps = 60;
    std::string remark;              ///< told once
    bool naps_until_arrival = false; ///< long waits end at once as long as something is to arrive
    std::function<void()> on_wait = [] {};

private:
    l3d_pixels do_pixels() override { return image_.pixels(); }
    const l3d_screen_info& do_info() const override { return info_; }
    void do_show(const l3d_pixel_box& part) override {
        log_.push_back(part == l3d_whole(image_.pixels().size()) ? "show" : "show part");
    }
    std::string do_describe() const override { return "fake"; }
    bool do_is_busy() const override { return busy; }
    bool do_is_to_close() override {
        return std::ranges::any_of(
            pending, [](const l3d_event& event) { return event.type == l3d_event_type::close; });
    }
    bool do_is_window() const override { return window; }
    double do_usual_fps() const override { return fps; }
    bool do_is_fullscreen() const override { return fullscreen_; }
    void do_set_fullscreen(bool on) override {
        log_.push_back(on ? "fullscreen" : "window again");
        fullscreen_ = on;
    }
    std::string do_take_remark() override { return std::exchange(remark, {}); }

    bool do_next_event(l3d_event& event) override {
        if (pending.empty())
            return false;
        event = pending.front();
        pending.pop_front();
        return true;
    }

    void do_wait(std::chrono::nanoseconds longest, int) override {
        ++waits;
        longest_wait = std::max(longest_wait, longest);
        on_wait();
        if (arrivals.empty() || (naps_until_arrival && longest < std::chrono::seconds(1))) {
            std::this_thread::sleep_for(longest);
            return;
        }
        pending.insert(pending.end(), arrivals.front().begin(), arrivals.front().end());
        arrivals.pop_front();
    }

    call_log& log_;
    bool fullscreen_ = false;
    l3d_image image_{{37, 23}, 41};
    l3d_screen_info info_;
};

/// Logs "key C", "pointer", "resize WxH", "update", "draw" and "frame"; 'q' ends it. Each
/// draw_event leaves the number of frames drawn in pixel (5, 3).
class fake_pipeline final : public l3d_pipeline {
public:
    fake_pipeline(call_log& log, l3d_screen& screen) : log_(log), screen_(screen) {}

    bool lazy = false;                                     ///< never needs to be redrawn
    bool rests = false;                                    ///< time changes nothing
    double rest = std::numeric_limits<double>::infinity(); ///< but for the end of so many seconds
    double rested = 0;                                     ///< seconds that it was told of
    bool skips = false;                   ///< its pictures do not depend on each other
    std::string remark;                   ///< told once
    std::optional<l3d_pixel_box> changes; ///< in every frame; else all
    std::vector<double> steps;
    std::vector<l3d_frame_times> times;
    std::function<void(int update)> on_update = [](int) {};
    std::function<void()> on_draw = [] {}; ///< in the middle of a picture

    void key_event(int key) override {
        log_.push_back(std::string("key ") + static_cast<char>(key));
        done |= key == 'q';
    }
    void pointer_event(const l3d_event& event) override {
        log_.push_back("pointer " + std::to_string(event.x) + ',' + std::to_string(event.y));
    }
    void resize_event(l3d_size size) override {
        log_.push_back("resize " + std::to_string(size.width) + 'x' + std::to_string(size.height));
    }
    void update_event(double seconds) override {
        log_.push_back("update");
        steps.push_back(seconds);
        on_update(static_cast<int>(steps.size()));
    }
    void draw_event() override {
        log_.push_back("draw");
        on_draw();
        if (is_unwanted_ && is_unwanted_())
            throw l3d_interrupted();
        screen_.pixels().row(3)[5] = ++drawn_;
    }
    void interrupt_when(std::function<bool()> wanted) override { is_unwanted_ = std::move(wanted); }
    l3d_pixel_box changed() const override { return changes.value_or(l3d_pipeline::changed()); }
    bool skip_event() override {
        log_.push_back("skip");
        return skips;
    }
    bool needs_redraw() const override { return !lazy; }
    std::string take_remark() override { return std::exchange(remark, {}); }
    bool is_at_rest() const override { return rests; }
    double rest_left() const override { return rest - rested; }
    void rest_event(double seconds) override {
        log_.push_back("rest");
        rested += seconds;
        lazy = rested < rest;
    }
    void frame_event(const l3d_frame_times& frame) override {
        log_.push_back("frame");
        times.push_back(frame);
    }

private:
    call_log& log_;
    l3d_screen& screen_;
    std::function<bool()> is_unwanted_;
    std::uint32_t drawn_ = 0;
};

#endif
