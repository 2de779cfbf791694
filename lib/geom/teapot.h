// SPDX-License-Identifier: MIT
// The teapot that is compiled into the library.
#ifndef L3D_GEOM_TEAPOT_H
#define L3D_GEOM_TEAPOT_H

#include "geom/parts.h"

#include <string_view>
#include <vector>

/// data/teapot.bpt, compiled in: 28 bicubic patches, y up, 3 units high, base at y = 0, no bottom.
/// Source: Newell 1975, in Crow, The Origins of the Teapot, IEEE CG&A 7, 1987.
std::string_view l3d_teapot_bpt();

/// The teapot's parts, in the order of its patches: body, handle, spout and lid. The rim belongs to
/// the body.
std::vector<l3d_part_run> l3d_teapot_parts();

#endif
