// SPDX-License-Identifier: MIT
// x11_window: a window, and everything that other programs want to know about it.
#ifndef L3D_TOOL_2D_X11_X11_WINDOW_P_H
#define L3D_TOOL_2D_X11_X11_WINDOW_P_H

#include "tool_2d/screen.h"
#include "tool_2d/x11/x11_colormap_p.h"
#include "tool_2d/x11/x11_connection_p.h"
#include "tool_2d/x11/x11_visual_p.h"

#include <memory>
#include <string>

namespace l3d_detail {

/// X's numbers for these names of properties and messages.
struct x11_atoms {
    Atom wm_protocols = 0;
    Atom wm_delete_window = 0;
    Atom net_wm_ping = 0;
    Atom net_wm_name = 0;
    Atom utf8_string = 0;
};

/// A window on the display. Owns its connection, colormap and graphics context.
class x11_window {
public:
    /// Makes a window that is not on the screen yet.
    /// Errors:  null, with the reason in `refusal`.
    static std::unique_ptr<x11_window> open(std::unique_ptr<x11_connection> connection,
                                            const x11_visual& visual,
                                            const l3d_screen_request& request,
                                            l3d_service& refusal);

    x11_window(const x11_window&) = delete;
    x11_window& operator=(const x11_window&) = delete;
    ~x11_window();

    x11_connection& connection() const { return *connection_; }
    Display* display() const { return connection_->display(); }
    Window id() const { return window_; }
    GC graphics() const { return graphics_; }
    Visual* visual() const { return visual_.visual; }
    const x11_atoms& atoms() const { return atoms_; }
    const l3d_screen_info& info() const { return colormap_->info(); }
    const x11_colormap& colormap() const { return *colormap_; }

    /// The side, in display pixels, of the square that shows a pixel of our pictures.
    int scale() const { return scale_; }

    /// Notes the display's fineness, as x11_fineness gives it. Returns whether text_scale()
    /// changes.
    bool set_fineness(double fineness);

    /// See l3d_screen::text_scale.
    double text_scale() const { return text_scale_; }

    /// Converts a place from display pixels to pixels of our pictures, rounded down. Sizes are
    /// rounded up, so the last pixel may be cut.
    int ours(int native) const { return (native < 0 ? native - scale_ + 1 : native) / scale_; }
    l3d_size ours(l3d_size native) const {
        return {ours(native.width + scale_ - 1), ours(native.height + scale_ - 1)};
    }

    /// Whether a window manager looked after the display's windows when this window was made.
    bool was_managed() const { return managed_; }

    void map() { XMapWindow(display(), window_); }

    /// Sets the colour, a pixel word, that new parts of a growing window show until their picture
    /// comes.
    void set_ground(std::uint32_t word);

    /// The parts of this program that may want all motion of the pointer.
    enum class watcher : unsigned { fullscreen = 1, program = 2 };

    /// Sets whether `who` needs all motion of the pointer, or only motion while a button is held.
    /// The server reports all motion as long as one watcher needs it.
    void watch_pointer(watcher who, bool always);

    /// A cursor without any pixel. Lives: until it is freed, or the connection ends.
    Cursor make_empty_cursor() const;

    /// Takes the keyboard and shows our colours, as a window manager would do it for us.
    /// Expects: the window is on the screen.
    void take_focus();

    /// Sets the properties that can wait until the first picture is shown, which then comes sooner.
    void set_process_and_icon(Atom net_wm_pid, Atom net_wm_icon) const;

    /// Sets one of the window's properties: an array of bytes if `format` is 8, or of longs if it
    /// is 32.
    void set_property(Atom name, Atom type, int format, const void* data, std::size_t count) const;

private:
    x11_window(std::unique_ptr<x11_connection> connection, std::unique_ptr<x11_colormap> colormap,
               const x11_visual& visual, int scale);

    void create(l3d_size native);
    void set_title(std::string title);
    void set_names(const l3d_screen_request& request);
    void set_machine() const;
    void set_hints(l3d_size native);
    void set_protocols();

    std::unique_ptr<x11_connection> connection_;
    std::unique_ptr<x11_colormap> colormap_;
    x11_visual visual_;
    x11_atoms atoms_;
    int scale_;
    double text_scale_ = 1;
    bool managed_ = false;
    unsigned watchers_ = 0; ///< the bits of the watchers that need all motion of the pointer
    Window window_ = 0;
    GC graphics_ = nullptr;
    unsigned long ground_ = 0; ///< the window's background, as a native pixel
};

} // namespace l3d_detail

#endif
