// SPDX-License-Identifier: MIT
// l3d_screen_factory_mesa: screens for pictures that Mesa's software GL draws.
#ifndef L3D_TOOL_2D_MESA_SCREEN_MESA_H
#define L3D_TOOL_2D_MESA_SCREEN_MESA_H

#include "tool_2d/screen.h"
#include "tool_2d/screen_memory.h"
#include "tool_2d/x11/screen_x11.h"

#include <string>
#include <utility>

/// Makes windows where a display can show them, otherwise screens that nobody sees.
///
/// GL draws off-screen and its picture is copied, so any screen serves. This kind of screen needs a
/// software GL.
class l3d_screen_factory_mesa final : public l3d_screen_factory {
public:
    /// Asks for the GL of `library`: auto, egl or osmesa. If `library` is empty, L3D_MESA names the
    /// library.
    explicit l3d_screen_factory_mesa(std::string library = {}) : library_(std::move(library)) {}

private:
    /// Opens GL for a try, and asks whether windows can be shown.
    /// Errors:  not_here, with one line of all reasons and of the packages to install;
    ///          display_lost.
    /// Cost:    opens and closes a GL context, and asks as l3d_screen_factory_xshm does.
    l3d_service do_service() const override;

    /// Makes a window or a screen in memory. The function does not look for GL, since do_service()
    /// did. Each rasterizer opens its own GL context, and throws if none can be opened.
    /// Errors:  null: no memory, display lost.
    std::unique_ptr<l3d_screen> do_create(const l3d_screen_request& request,
                                          l3d_service& refusal) const override;

    void do_release() const override { windows_.release(); }

    /// Adds one probe for each way to GL, with the renderer. Other back-ends tell of the display.
    void do_diagnose(l3d_probes& probes) const override;

    std::string library_;
    l3d_screen_factory_xshm windows_;
    l3d_screen_factory_memory memory_;
};

#endif
