// SPDX-License-Identifier: MIT
// mesa_platform: GL's connection to the system, by EGL or by OSMesa.
#ifndef L3D_TOOL_2D_MESA_MESA_PLATFORM_P_H
#define L3D_TOOL_2D_MESA_MESA_PLATFORM_P_H

#include <memory>
#include <string>

namespace l3d_detail {

/// Owns one GL context without a window; there is a picture only once one is made in GL.
class mesa_platform {
public:
    mesa_platform() = default;
    mesa_platform(const mesa_platform&) = delete;
    mesa_platform& operator=(const mesa_platform&) = delete;
    virtual ~mesa_platform() = default;

    /// GL calls of this thread go to this context from now on. Errors: false if it refuses.
    bool make_current() { return do_make_current(); }

    /// Errors:  null for some names of no GL call; a pointer that must not be called for others.
    void* find(const char* name) { return do_find(name); }

private:
    virtual bool do_make_current() = 0;
    virtual void* do_find(const char* name) = 0;
};

/// EGL's platform for pictures without any window system.
/// Errors:  null, with the reason in `why`.
std::unique_ptr<mesa_platform> open_mesa_egl_surfaceless(std::string& why);

/// The EGL device that says of itself that it is software.
/// Errors:  null, with the reason in `why`.
std::unique_ptr<mesa_platform> open_mesa_egl_device(std::string& why);

/// The library that Mesa had for this until 25.1.
/// Errors:  null, with the reason in `why`.
std::unique_ptr<mesa_platform> open_mesa_osmesa(std::string& why);

} // namespace l3d_detail

#endif
