// SPDX-License-Identifier: MIT
// OSMesa as far as it is used here, declared by us: Mesa has no header of it from 25.1 on.
#ifndef L3D_TOOL_2D_MESA_MESA_OSMESA_P_H
#define L3D_TOOL_2D_MESA_MESA_OSMESA_P_H

namespace l3d_detail::osmesa {

inline constexpr unsigned bgra = 0x1; ///< OSMESA_BGRA, which is not GL_BGRA

using context = struct osmesa_context*;
using procedure = void (*)();

using create_context_ext = context(unsigned format, int depth_bits, int stencil_bits,
                                   int accumulation_bits, context share);
using destroy_context = void(context);
using make_current = unsigned char(context, void* words, unsigned type, int width, int height);
using get_current_context = context();
using get_proc_address = procedure(const char* name);

} // namespace l3d_detail::osmesa

#endif
