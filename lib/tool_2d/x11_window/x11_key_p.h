// SPDX-License-Identifier: MIT
// x11_key: which key an event of the keyboard means, whatever the layout.
#ifndef L3D_TOOL_2D_X11_WINDOW_X11_KEY_P_H
#define L3D_TOOL_2D_X11_WINDOW_X11_KEY_P_H

#include <X11/Xlib.h>

namespace l3d_detail {

/// The key of an event, by its own group and level. Caps Lock makes no other keys. On a Greek or
/// Cyrillic layout the keys that type letters are Latin letters, even where they type a sign. ASCII
/// or an l3d_key; 0 for a key that is none of ours.
int key_of(XKeyEvent event);

} // namespace l3d_detail

#endif
