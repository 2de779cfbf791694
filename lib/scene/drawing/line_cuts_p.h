// SPDX-License-Identifier: MIT
// cut_lines: the places at which lines may begin or end to be seen.
#ifndef L3D_SCENE_DRAWING_LINE_CUTS_P_H
#define L3D_SCENE_DRAWING_LINE_CUTS_P_H

#include "scene/drawing/borders_p.h"
#include "scene/drawing/image_piece_p.h"

#include <cstddef>
#include <span>
#include <vector>

namespace l3d_detail {

/// For each vertex of a line, the length of the line from its first vertex, in the picture.
std::vector<double> lengths_along(const surface_line& line);

/// Finds places that cut lines into stretches. A stretch is seen or hidden as a whole, unless it
/// passes through a surface. A line is cut where another line that may be nearer crosses it or ends
/// on it, and at the picture's border. Places are lengths in the picture from the line's beginning.
/// Shape: for each chain, the places in their order, with the chain's two ends.
std::vector<std::vector<double>> cut_lines(std::span<const drawn_chain> chains,
                                           const drawing_view& view, double tolerance);

} // namespace l3d_detail

#endif
