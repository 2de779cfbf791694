// SPDX-License-Identifier: MIT
// The view that tests of one patch look with.
#ifndef L3D_TESTS_DICE_ODD_VIEW_H
#define L3D_TESTS_DICE_ODD_VIEW_H

#include "scene/dice_view.h"

namespace dice_tests {

/// Of a picture with an odd number of rows: its centre is a pixel's centre in one direction only.
inline l3d_dice_view odd_view(double tolerance, double near) {
    l3d_dice_view view;
    view.size = {640, 481};
    view.near = near;
    view.tolerance = tolerance;
    return view;
}

} // namespace dice_tests

#endif
