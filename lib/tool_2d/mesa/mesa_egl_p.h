// SPDX-License-Identifier: MIT
// EGL as far as it is used here, declared by us, so that building needs no header of it.
#ifndef L3D_TOOL_2D_MESA_MESA_EGL_P_H
#define L3D_TOOL_2D_MESA_MESA_EGL_P_H

#include <cstdint>

namespace l3d_detail::egl {

inline constexpr unsigned platform_surfaceless = 0x31DD; ///< EGL_PLATFORM_SURFACELESS_MESA
inline constexpr unsigned platform_device = 0x313F;      ///< EGL_PLATFORM_DEVICE_EXT
inline constexpr unsigned opengl_api = 0x30A2;           ///< EGL_OPENGL_API
inline constexpr int extensions = 0x3055;                ///< EGL_EXTENSIONS
inline constexpr int none = 0x3038;                      ///< EGL_NONE

using boolean = unsigned;
using display = void*;
using config = void*;
using context = void*;
using surface = void*;
using device = void*;
using attribute = std::intptr_t;
using procedure = void (*)();

using get_platform_display = display(unsigned platform, void* native, const attribute*);
using initialize = boolean(display, int* major, int* minor);
using query_string = const char*(display, int name);
using bind_api = boolean(unsigned api);
using create_context = context(display, config, context share, const int* attributes);
using destroy_context = boolean(display, context);
using make_current = boolean(display, surface draw, surface read, context);
using get_current_context = context();
using get_error = int();
using get_proc_address = procedure(const char* name);
using query_devices = boolean(int most, device* devices, int* count);
using query_device_string = const char*(device, int name);

} // namespace l3d_detail::egl

#endif
