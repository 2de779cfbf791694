// SPDX-License-Identifier: MIT
// The lines of --diagnose about an X11 display.
#ifndef L3D_TOOL_2D_X11_X11_DIAGNOSIS_P_H
#define L3D_TOOL_2D_X11_X11_DIAGNOSIS_P_H

#include "tool_2d/screen.h"

namespace l3d_detail {

/// Adds the display, its visual and its window manager, unless they are there already.
void diagnose_x11_display(l3d_probes& probes);

/// Adds the same probes, and whether memory can be shared with the display's server.
void diagnose_x11_shm(l3d_probes& probes);

} // namespace l3d_detail

#endif
