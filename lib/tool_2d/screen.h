// SPDX-License-Identifier: MIT
// l3d_screen: where pixels become visible; the factory that makes one, and what it found out.
#ifndef L3D_TOOL_2D_SCREEN_H
#define L3D_TOOL_2D_SCREEN_H

#include "base/public.h"
#include "tool_2d/event.h"
#include "tool_2d/pixels.h"
#include "tool_2d/screen_info.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

/// One thing that --diagnose checks and prints a line about.
struct L3D_PUBLIC l3d_probe {
    /// How well the thing serves.
    enum class verdict {
        good,    ///< nothing is missing
        limited, ///< the thing serves, but not as well as it could
        bad      ///< the thing does not serve
    };

    std::string what;                ///< the thing, such as "MIT-SHM" or "visual"
    std::string result;              ///< the finding, or the reason why there is none
    verdict outcome = verdict::good; ///< how well the thing serves
    std::string remedy; ///< the thing to install, set or leave out; empty if nothing is wrong
};

/// The name of the probe of the display itself. If that probe is bad, no window can open.
inline constexpr auto l3d_display_probe = "display";

/// All probes, in the order in which they are printed.
using l3d_probes = std::vector<l3d_probe>;

/// The motion of the pointer that a program hears of.
enum class L3D_PUBLIC l3d_pointer {
    dragged,  ///< the pointer's motion while a button is held
    followed, ///< all of the pointer's motion over the window
    /// The pointer is hidden and kept in the window. Its motion, which has no end, is told by
    /// l3d_event::right and down. First-person views turn by this motion. A window without the
    /// keyboard lets the pointer go.
    held,
};

/// A passive output device: it owns pixels and shows them; it draws nothing itself.
///
/// Expects: all calls come from one thread, which for a window owns the connection to the display.
///          Other threads may write into the pixels while that thread is in no call.
class L3D_PUBLIC l3d_screen : public l3d_event_source {
public:
    /// The pixels to draw into. A resize event makes earlier views invalid.
    l3d_pixels pixels() { return do_pixels(); }

    /// The formats of this screen's pixel words and of its display's native pixels.
    const l3d_screen_info& info() const { return do_info(); }

    /// Makes the pixels visible.
    void show() { do_show(l3d_whole(pixels().size())); }

    /// Makes the pixels of a part visible; changes outside of the part stay unseen. An empty part
    /// shows nothing.
    void show(const l3d_pixel_box& part) {
        const l3d_pixel_box inside = part.intersected(l3d_whole(pixels().size()));
        if (!inside.empty())
            do_show(inside);
    }

    /// Whether the last picture shown has not reached the display yet. Another picture would only
    /// take its place.
    bool is_busy() const { return do_is_busy(); }

    /// Whether a close event has come that next_event has not yet given. Unlike next_event, it may
    /// be called while another thread draws: the pixels stay as they are.
    bool is_to_close() { return do_is_to_close(); }

    /// Whether the screen is a window that somebody sees. If so, events come, and animations run by
    /// the clock.
    bool is_window() const { return do_is_window(); }

    /// The rate at which new pictures make sense if the user names no rate.
    /// Units:   pictures per second.
    double usual_fps() const { return do_usual_fps(); }

    /// The factor by which text must be larger than on a display of 96 dots an inch to be read as
    /// easily; at least 1. The factor is 1.5 if the user has set 144 dots an inch and
    /// l3d_screen_request::scale is 1.
    double text_scale() const { return do_text_scale(); }

    /// Whether pictures travel over a slow line. If so, moving parts are coarse, and still parts
    /// cost nothing.
    bool is_slow() const { return do_is_slow(); }

    /// Tells where text stands, from the next picture on until the next call. Over a slow line
    /// these parts are sent first, and exactly.
    void set_text(std::vector<l3d_pixel_box> boxes) { do_set_text(std::move(boxes)); }

    /// Chooses which motion of the pointer makes events; at first `dragged`. A screen that is not a
    /// window has no pointer.
    void set_pointer(l3d_pointer how) { do_set_pointer(how); }

    /// Makes the window cover the whole display, or gives it its old place back. A screen that is
    /// not a window stays as it is.
    void set_fullscreen(bool on) { do_set_fullscreen(on); }
    /// Whether the window covers the whole display.
    bool is_fullscreen() const { return do_is_fullscreen(); }

    /// Describes the screen in one line for --verbose and --diagnose: kind, depth, bits per pixel,
    /// byte order.
    std::string describe() const { return do_describe(); }

    /// Gives one line for the user if something has become worse since the last call; else an empty
    /// text.
    std::string take_remark() { return do_take_remark(); }

private:
    virtual l3d_pixels do_pixels() = 0;
    virtual const l3d_screen_info& do_info() const = 0;
    /// Shows a part of the pixels. Expects: the part is not empty and lies in the picture.
    virtual void do_show(const l3d_pixel_box& part) = 0;
    virtual bool do_is_busy() const { return false; }
    virtual bool do_is_to_close() { return false; }
    virtual bool do_is_window() const { return false; }
    virtual double do_usual_fps() const { return 60; }
    virtual double do_text_scale() const { return 1; }
    virtual bool do_is_slow() const { return false; }
    virtual void do_set_text(std::vector<l3d_pixel_box>) {}
    virtual void do_set_pointer(l3d_pointer) {}
    virtual void do_set_fullscreen(bool) {}
    virtual bool do_is_fullscreen() const { return false; }
    virtual std::string do_describe() const = 0;
    virtual std::string do_take_remark() { return {}; }
};

/// Largest l3d_screen_request::scale. No display is eight times as fine as 96 dots an inch.
inline constexpr int l3d_largest_scale = 8;

/// Whether a screen sends few pixels at the cost of detail, for a slow line.
enum class L3D_PUBLIC l3d_remote {
    automatic, ///< as `on` if the display is reached over a network, else as `off`
    on,        ///< only changed pixels, coarse while many change; no memory is shared
    off,       ///< whole pictures, as to a display of this machine
};

/// Settings of a screen that a program asks for.
struct L3D_PUBLIC l3d_screen_request {
    l3d_size size{1024, 768};  ///< size of the picture, in pixels of the program; see scale
    std::string title = "l3d"; ///< title of the window, in UTF-8
    std::string name = "l3d";  ///< name of the program, for window managers and their rules
    /// The side, in display pixels, of the square that shows a pixel of the picture. 0 stands for 1
    /// with a larger picture: `size` is then multiplied by the factor by which the display is finer
    /// than 96 dots an inch.
    int scale = 0;
    /// How pictures travel to a display. Screens that are not windows ignore it.
    l3d_remote remote = l3d_remote::automatic;
};

/// How well a kind of screen can serve here and now.
struct L3D_PUBLIC l3d_service {
    /// How well the kind of screen serves, from best to worst.
    enum class level {
        fully,        ///< the screens serve as the name of the kind says
        partly,       ///< the screens serve, but in another way than the name says
        not_here,     ///< no screen can serve, and another display would not help
        no_display,   ///< there is no display that answers
        display_lost, ///< the display went away while it was asked
    };

    level how = level::fully; ///< the answer in one word
    std::string why{};        ///< the reason in one line, naming values; empty if `fully`
    bool is_seen = true;      ///< whether somebody sees pictures that are not written to files

    /// Whether screens of this kind can show pictures, fully or partly.
    bool serves() const { return how == level::fully || how == level::partly; }
};

/// Makes screens of one kind.
class L3D_PUBLIC l3d_screen_factory {
public:
    l3d_screen_factory() = default;
    l3d_screen_factory(const l3d_screen_factory&) = delete;
    l3d_screen_factory& operator=(const l3d_screen_factory&) = delete;
    virtual ~l3d_screen_factory() = default;

    /// Whether this kind can serve here and now. The result tells of errors.
    l3d_service service() const { return do_service(); }

    /// Makes a screen.
    /// Errors:  null, with the reason in `refusal`, if this kind cannot serve here.
    std::unique_ptr<l3d_screen> create(const l3d_screen_request& request,
                                       l3d_service& refusal) const {
        return do_create(request, refusal);
    }

    /// Frees resources that service() kept for create(). Call it if another kind of screen was
    /// chosen.
    void release() const { do_release(); }

    /// Adds a probe for each thing that this kind depends on, with outcome and remedy.
    void diagnose(l3d_probes& probes) const { do_diagnose(probes); }

private:
    virtual l3d_service do_service() const = 0;
    virtual std::unique_ptr<l3d_screen> do_create(const l3d_screen_request& request,
                                                  l3d_service& refusal) const = 0;
    virtual void do_release() const {}
    virtual void do_diagnose(l3d_probes&) const {}
};

#endif
