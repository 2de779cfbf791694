// SPDX-License-Identifier: MIT
// l3d_doubt_verdict: bounds of the exact picture in a cell.
#ifndef L3D_DICE_CERTIFICATE_DOUBT_VERDICT_H
#define L3D_DICE_CERTIFICATE_DOUBT_VERDICT_H

#include "dice/certificate/light_bounds.h"

/// Bounds of a cell. Units: levels.
struct l3d_doubt_verdict {
    bool is_certain = false; ///< one surface of one colour, or the background, fills it
    bool is_covered = false; ///< and it is a surface, no background
    l3d_light_bounds light = l3d_light_bounds::any(); ///< the mean over the cell
    double spread = 0;                                ///< unknown spread of its levels
};

#endif
