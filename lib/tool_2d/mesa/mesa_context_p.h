// SPDX-License-Identifier: MIT
// mesa_context: GL on the CPU, without a window, by any installed library.
#ifndef L3D_TOOL_2D_MESA_MESA_CONTEXT_P_H
#define L3D_TOOL_2D_MESA_MESA_CONTEXT_P_H

#include "tool_2d/mesa/mesa_gl_p.h"
#include "tool_2d/mesa/mesa_platform_p.h"

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace l3d_detail {

/// The ways to open a context, in the order in which they are tried. EGL comes first, as Mesa has
/// no OSMesa from 25.1 on.
enum class mesa_way { egl_surfaceless, egl_device, osmesa };
inline constexpr std::array mesa_ways{mesa_way::egl_surfaceless, mesa_way::egl_device,
                                      mesa_way::osmesa};

const char* name_of(mesa_way way);

/// Whether the user's choice permits a way. `wish` is auto, egl or osmesa. An empty wish stands for
/// the variable L3D_MESA or, if that is empty or unset, for auto.
bool may_try(mesa_way way, const std::string& wish);

/// Whether the renderer with this GL_RENDERER text draws on the CPU.
bool is_software_renderer(std::string_view renderer);

/// The packages to install for a way, by Debian's names.
const char* packages_of(mesa_way way);

/// A GL context that belongs to the thread that made it.
///
/// Each context has GL objects and state of its own. A context that is made current stays so until
/// another one is made current, or until it ends.
class mesa_context {
public:
    /// Opens a context by the first way that serves and that `wish` permits, as may_try defines it.
    /// Errors:  null, with one line in `why`. The line has all reasons and the packages, or says
    ///          that the wish, or L3D_MESA, has an unknown value.
    /// Cost:    10 to 60 ms.
    static std::unique_ptr<mesa_context> open(const std::string& wish, std::string& why);

    /// Opens a context by this way.
    /// Errors:  null, with the reason in `why`: no library, no context, a graphics card, no GL 3.
    static std::unique_ptr<mesa_context> open(mesa_way way, std::string& why);

    /// Makes the context current in this thread, and gives the GL calls to use.
    const mesa_gl& make_current() {
        platform_->make_current();
        return gl_;
    }

    mesa_way way() const { return way_; }

    /// GL's text GL_RENDERER.
    const std::string& renderer() const { return renderer_; }

    /// The renderer, and the way by which the context was opened.
    std::string describe() const {
        return "GL by " + std::string(name_of(way_)) + ": " + renderer_;
    }

private:
    mesa_context(std::unique_ptr<mesa_platform> platform, mesa_way way)
        : platform_(std::move(platform)), way_(way) {}

    /// Finds the GL calls and the renderer. Errors: false, with the reason in `why`.
    bool load(std::string& why);

    std::unique_ptr<mesa_platform> platform_;
    mesa_way way_;
    mesa_gl gl_;
    std::string renderer_;
};

} // namespace l3d_detail

#endif
