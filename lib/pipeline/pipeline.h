// SPDX-License-Identifier: MIT
// l3d_pipeline: the application, as the dispatcher sees it; the caption that explains it to people,
// and its steps of time.
#ifndef L3D_PIPELINE_PIPELINE_H
#define L3D_PIPELINE_PIPELINE_H

#include "base/public.h"
#include "geom/real.h" // whoever compiles a pipeline links with the library of the same numbers
#include "raster/text/panel.h"
#include "tool_2d/event.h"
#include "tool_2d/pixels.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

/// The times that a frame takes after it was drawn. Units: seconds.
struct L3D_PUBLIC l3d_frame_times {
    double show = 0;  ///< bringing the picture to the screen
    double write = 0; ///< writing picture files
};

/// The application. A program derives a class from this class, and the dispatcher calls the
/// functions of the derived class when events come from outside.
///
/// Order:   events first, then update_event, then draw_event, then frame_event, once per frame.
/// Lives:   borrowed by the dispatcher; owns (or borrows from main) its screen and rasterizer.
class L3D_PUBLIC l3d_pipeline {
public:
    l3d_pipeline() = default;
    l3d_pipeline(const l3d_pipeline&) = delete;
    l3d_pipeline& operator=(const l3d_pipeline&) = delete;
    virtual ~l3d_pipeline() = default;

    /// Set to true to ask the dispatcher to finish after the current frame.
    bool done = false;

    /// Called for each event. If key_event, pointer_event or resize_event is called for the event
    /// too, any_event is called before.
    virtual void any_event(const l3d_event& event) { static_cast<void>(event); }

    /// Called when a key was pressed; `key` is an ASCII code or an l3d_key. Some presses reach only
    /// any_event: those with Alt or Super held, letters with Ctrl held, the keys Shift, Ctrl and
    /// Alt themselves, and presses that only type text.
    virtual void key_event(int key) { static_cast<void>(key); }

    /// Called when a mouse button was pressed or released, or the pointer or the wheel moved.
    virtual void pointer_event(const l3d_event& event) { static_cast<void>(event); }

    /// Called when the screen has got a new size. Earlier l3d_pixels of the screen are invalid
    /// then.
    virtual void resize_event(l3d_size size) { static_cast<void>(size); }

    /// Lets time pass in the program's world.
    /// Units: seconds since the last call; without a display, a fixed step.
    virtual void update_event(double seconds) { static_cast<void>(seconds); }

    /// Draws into the screen's pixels. The dispatcher shows and stores them afterwards.
    /// Errors: throws l3d_interrupted if the function of interrupt_when returns true. The pixels
    ///         are no complete picture then.
    virtual void draw_event() {}

    /// Sets the function that a long draw_event calls now and then, to learn whether to stop. If
    /// `wanted` returns true, draw_event throws l3d_interrupted, and the next draw_event draws a
    /// whole picture again. Fast pipelines may ignore the function.
    virtual void interrupt_when(std::function<bool()> wanted) { static_cast<void>(wanted); }

    /// The box of the pixels that the last draw_event may have changed. The dispatcher brings only
    /// this box to the screen. The box may reach beyond the picture.
    virtual l3d_pixel_box changed() const {
        constexpr auto most = std::numeric_limits<std::int32_t>::max();
        return {0, 0, most, most};
    }

    /// Called when the picture of draw_event has been shown and stored.
    virtual void frame_event(const l3d_frame_times& times) { static_cast<void>(times); }

    /// Called in place of draw_event, after update_event, if nobody wants the frame's picture.
    /// Returns true if later pictures do not depend on this one. If it returns false, the
    /// dispatcher has the picture drawn all the same.
    virtual bool skip_event() { return false; }

    /// Whether nothing changes until the next event, however much time goes by. In a window the
    /// dispatcher then sleeps, without calls of update_event, once needs_redraw() is false, too.
    /// The next update_event does not count the time of the sleep.
    virtual bool is_at_rest() const { return false; }

    /// A text that a panel in the window shows until the text changes; \n divides its lines. ""
    /// shows no panel.
    virtual std::string message() const { return {}; }

    /// The longest time that the program stays at rest without an event. rest_event is called after
    /// this time, or at the next event if that comes first.
    /// Units:   seconds, more than 0.
    /// Expects: is_at_rest(), and needs_redraw() is false.
    virtual double rest_left() const { return std::numeric_limits<double>::infinity(); }

    /// Called at the end of a rest, in place of update_event, with the time that the rest took.
    /// Units: seconds.
    virtual void rest_event(double seconds) { static_cast<void>(seconds); }

    /// Whether draw_event would now draw another picture than the last one. While this is false and
    /// no event came, the dispatcher neither draws nor shows. As it is here, a program never rests.
    virtual bool needs_redraw() const { return true; }

    /// A remark of one line that the user should read once, such as that fewer threads draw than
    /// wanted. It is "" if there is no remark. The dispatcher asks after each frame.
    virtual std::string take_remark() { return {}; }
};

/// A row of the help: keys and their effect.
struct L3D_PUBLIC l3d_caption_row {
    std::string keys; ///< such as "h j k l"
    std::string text; ///< such as "left, down, up, right"
};

/// Text on a program and its keys. The program's --help shows this text. A panel in the window
/// shows it, too: for some seconds after the start, and whenever the user asks for help.
///
///     l3d_program program("dot", l3d_caption{.what = "A dot moves.", .keys = {{"p", "rest"}}},
///                         {320, 200});
///
/// Lives: a value.
struct L3D_PUBLIC l3d_caption {
    /// One or two sentences on what the program shows.
    std::string what;

    /// The lesson that the program teaches, in one or two sentences. If it is not empty, the
    /// program is a lesson of the book.
    std::string teaches{};

    /// The program's own keys. The keys of every program are added automatically.
    std::vector<l3d_caption_row> keys{};

    /// The keys that show and hide the help, each a character. A program that uses h or ? for
    /// itself leaves that key out here.
    std::string help = "h?";

    /// The corner in which the window shows its caption for some seconds, or until a button is
    /// pressed. Choose a corner where the program draws nothing.
    l3d_corner corner = l3d_corner::bottom_left;

    /// All keys: the program's own keys, F11, the help keys, and the keys that end the program.
    std::vector<l3d_caption_row> all_keys() const;

    /// The text of --help: `what` and `teaches`, and a list of all keys below.
    std::string text() const;
};

/// Turns seconds into whole steps. So a world that moves step by step moves equally fast at any
/// frame rate. For example, with 60 steps a second and 30 frames a second, two steps are due per
/// frame. With 300 frames a second, one step is due in every fifth frame.
class L3D_PUBLIC l3d_ticker {
public:
    /// Makes a ticker of `per_second` steps a second. Expects: per_second > 0.
    explicit l3d_ticker(double per_second = 60) : per_second_(per_second) {}

    /// The number of whole steps that are due `seconds` after the last call. The fraction of a step
    /// that remains is kept for the next call.
    ///
    /// The result is at most the number of steps in one second. So a program that was stopped for
    /// hours does not make the steps of these hours.
    int due(double seconds) {
        // A step is not put off because of a rounding error. 1/60 s, as a double, times 60 is 1,
        // but a sum of many need not be whole. 2^-20 of a step exceeds the error of 2^30 steps, and
        // nobody sees it.
        constexpr double slack = 0x1p-20;
        steps_ = std::min(steps_ + std::max(seconds, 0.0) * per_second_, per_second_);
        const double whole = std::floor(steps_ + slack);
        steps_ -= whole;
        return static_cast<int>(whole);
    }

private:
    double per_second_;
    /// The number of steps that have passed but were not returned yet, with a fraction. It is at
    /// least -slack, since due() rounds up by as much.
    double steps_ = 0;
};

#endif
