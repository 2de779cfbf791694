// SPDX-License-Identifier: MIT
// x11_extension: asks a server that may die meanwhile for an extension.
#ifndef L3D_TOOL_2D_X11_X11_EXTENSION_P_H
#define L3D_TOOL_2D_X11_X11_EXTENSION_P_H

namespace l3d_detail {

/// Sets the stack below the caller to 0: far more of it than Xlib's calls use.
void clear_stack_below();

/// Calls ask(), which has Xlib ask for an extension, and returns its result.
///
/// If there is no answer, libX11 1.8's XQueryExtension reads stale bytes of the stack instead.
/// Anything but 0 then counts as an extension, and Xlib may print a line for each of its events.
/// This still happens where libXext's names are bound late: the dynamic linker uses that stack,
/// too.
template <class Ask> auto ask_for_extension(Ask ask) {
    clear_stack_below();
    return ask();
}

} // namespace l3d_detail

#endif
