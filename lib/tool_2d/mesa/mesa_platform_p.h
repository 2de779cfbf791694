// SPDX-License-Identifier: MIT
// mesa_platform: GL's connection to the system, by EGL or by OSMesa.
#ifndef L3D_TOOL_2D_MESA_MESA_PLATFORM_P_H
#define L3D_TOOL_2D_MESA_MESA_PLATFORM_P_H

#include <memory>
#include <string>

namespace l3d_detail {

/// Owns one GL context without a window. GL itself has to make the framebuffers to draw into.
class mesa_platform {
public:
    mesa_platform() = default;
    mesa_platform(const mesa_platform&) = delete;
    mesa_platform& operator=(const mesa_platform&) = delete;
    virtual ~mesa_platform() = default;

    /// Makes this the context of this thread's GL calls. Errors: false if the library refuses.
    bool make_current() { return do_make_current(); }

    /// The address of a GL call. Errors: for a name of no GL call, null or a pointer that must not
    /// be called.
    void* find(const char* name) { return do_find(name); }

private:
    virtual bool do_make_current() = 0;
    virtual void* do_find(const char* name) = 0;
};

/// Opens a context on EGL's platform for pictures without any window system.
/// Errors:  null, with the reason in `why`.
std::unique_ptr<mesa_platform> open_mesa_egl_surfaceless(std::string& why);

/// Opens a context on the EGL device that declares itself to be software.
/// Errors:  null, with the reason in `why`.
std::unique_ptr<mesa_platform> open_mesa_egl_device(std::string& why);

/// Opens a context by OSMesa, a library for pictures in memory that Mesa had until 25.1.
/// Errors:  null, with the reason in `why`.
std::unique_ptr<mesa_platform> open_mesa_osmesa(std::string& why);

} // namespace l3d_detail

#endif
