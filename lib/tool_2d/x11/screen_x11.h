// SPDX-License-Identifier: MIT
// The factories of screens that are X11 windows.
#ifndef L3D_TOOL_2D_X11_SCREEN_X11_H
#define L3D_TOOL_2D_X11_SCREEN_X11_H

#include "tool_2d/screen.h"

#include <memory>
#include <string>

namespace l3d_detail {
class x11_connection;
}

/// Makes windows. service() keeps its connection. create() uses this connection if DISPLAY still
/// names the same display. Connecting takes as long as all other steps together.
///
/// A screen belongs to the thread that made it.
class l3d_screen_factory_x11 : public l3d_screen_factory {
public:
    ~l3d_screen_factory_x11() override;

protected:
    explicit l3d_screen_factory_x11(bool shares_memory);

private:
    /// Connects to the display, and looks for a usable visual and for shared memory.
    /// Errors:  no_display, with one line that gives the value of DISPLAY; not_here if the display
    ///          has no usable visual; display_lost; partly if memory cannot be shared as it should.
    /// Cost:    one connection; one small segment where memory is shared.
    l3d_service do_service() const override;

    /// Makes a window, and waits until it is on the screen.
    /// Errors:  null: no display, no usable visual, no memory, display lost.
    /// Lives:   the screen owns connection, window and pixels.
    /// Cost:    returns once the window is on the screen, or after two seconds.
    std::unique_ptr<l3d_screen> do_create(const l3d_screen_request& request,
                                          l3d_service& refusal) const override;

    void do_release() const override;
    void do_diagnose(l3d_probes& probes) const override;

    bool shares_memory_;
    mutable std::unique_ptr<l3d_detail::x11_connection> kept_;
};

/// Makes windows whose pixels travel over the connection (XPutImage): any display, remote too.
struct l3d_screen_factory_ximage final : l3d_screen_factory_x11 {
    l3d_screen_factory_ximage() : l3d_screen_factory_x11(false) {}
};

/// Makes windows whose pixels the server reads from memory that it shares with us (MIT-SHM): the
/// fast way to a local display. If sharing fails, at once or later, the same window gets its pixels
/// over the connection, and l3d_screen::take_remark tells.
struct l3d_screen_factory_xshm final : l3d_screen_factory_x11 {
    l3d_screen_factory_xshm() : l3d_screen_factory_x11(true) {}
};

#endif
