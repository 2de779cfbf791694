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

/// The base of the factories of windows. It keeps the connection on which service() asked, and
/// create() goes on with it. Connecting takes as long as all else together.
class l3d_screen_factory_x11 : public l3d_screen_factory {
public:
    l3d_screen_factory_x11();
    ~l3d_screen_factory_x11() override;

protected:
    void keep(std::unique_ptr<l3d_detail::x11_connection> connection) const;

    /// The kept connection if DISPLAY still names it, else a new one.
    /// Errors:  null, with one line in `why` that gives the value of DISPLAY.
    std::unique_ptr<l3d_detail::x11_connection> connect(std::string& why) const;

private:
    void do_release() const override;

    mutable std::unique_ptr<l3d_detail::x11_connection> kept_;
};

/// Makes windows whose pixels travel over the connection (XPutImage): any display, remote too.
///
/// A screen belongs to the thread that made it.
class l3d_screen_factory_ximage final : public l3d_screen_factory_x11 {
private:
    /// Errors:  no_display, with one line that gives the value of DISPLAY; not_here if the display
    ///          has no usable visual; display_lost.
    /// Cost:    one connection.
    l3d_service do_service() const override;

    /// Errors:  null: no display, no usable visual, no memory, display lost.
    /// Lives:   the screen owns connection, window and pixels.
    /// Cost:    returns once the window is on the screen, or after two seconds.
    std::unique_ptr<l3d_screen> do_create(const l3d_screen_request& request,
                                          l3d_service& refusal) const override;

    void do_diagnose(l3d_probes& probes) const override;
};

/// Makes windows whose pixels the server reads from memory that it shares with us (MIT-SHM): a
/// local display, the fast way. Where sharing fails, now or later, the same window gets its pixels
/// over the connection, and the screen has a remark.
class l3d_screen_factory_xshm final : public l3d_screen_factory_x11 {
private:
    /// Errors:  partly if memory cannot be shared; else as l3d_screen_factory_ximage.
    /// Cost:    one connection, and one small segment.
    l3d_service do_service() const override;

    /// Errors, Lives, Cost: as l3d_screen_factory_ximage.
    std::unique_ptr<l3d_screen> do_create(const l3d_screen_request& request,
                                          l3d_service& refusal) const override;

    void do_diagnose(l3d_probes& probes) const override;
};

#endif
