// SPDX-License-Identifier: MIT
// Whether there is a display at all.
#ifndef L3D_SYSTEM_DISPLAY_X11_H
#define L3D_SYSTEM_DISPLAY_X11_H

#include <string>

/// One line on why no display can be opened, which names DISPLAY and its value; empty if one can.
///
/// Cost:    one connection, closed again; at most some seconds if a remote machine is silent.
std::string l3d_display_problem();

#endif
