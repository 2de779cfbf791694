// SPDX-License-Identifier: MIT
// The factory of screens that are X11 windows.
#ifndef L3D_TOOL_2D_SCREEN_X11_H
#define L3D_TOOL_2D_SCREEN_X11_H

#include "tool_2d/screen.h"

/// Makes windows whose pixels travel over the connection (XPutImage): any display, remote too.
///
/// Every TrueColor visual of 8, 16, 24 or 32 bits per pixel and either byte order is served.
/// A screen belongs to the thread that made it.
class l3d_screen_factory_ximage final : public l3d_screen_factory {
private:
    /// Errors:  no_display, with one line that gives the value of DISPLAY; not_here if the display
    ///          has no usable visual.
    /// Cost:    one connection, closed again.
    l3d_service do_service() const override;

    /// Errors:  null: no display, no usable visual, no memory, display lost.
    /// Lives:   the screen owns connection, window and pixels.
    /// Cost:    returns once the window is on the screen, or after two seconds.
    std::unique_ptr<l3d_screen> do_create(const l3d_screen_request& request,
                                          l3d_service& refusal) const override;
};

#endif
