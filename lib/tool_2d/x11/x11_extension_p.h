// SPDX-License-Identifier: MIT
// x11_extension: asking for an extension a server that may die meanwhile.
#ifndef L3D_TOOL_2D_X11_X11_EXTENSION_P_H
#define L3D_TOOL_2D_X11_X11_EXTENSION_P_H

namespace l3d_detail {

/// Sets the stack below the caller to 0: far more of it than Xlib's calls use.
void clear_stack_below();

/// Calls ask(), which has Xlib ask for an extension, and returns what it does.
///
/// If there is no answer, libX11 1.8's XQueryExtension takes for it what lies on the stack.
/// Anything but 0 is then an extension, and for each of its events Xlib may print a line of its
/// own. It still may where libXext's names are bound late: the dynamic linker uses that stack, too.
template <class Ask> auto ask_for_extension(Ask ask) {
    clear_stack_below();
    return ask();
}

} // namespace l3d_detail

#endif
