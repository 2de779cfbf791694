// SPDX-License-Identifier: MIT
// join_lines: finds lines that continue each other.
#ifndef L3D_SCENE_DRAWING_LINE_JOINTS_P_H
#define L3D_SCENE_DRAWING_LINE_JOINTS_P_H

#include "scene/drawing/image_piece_p.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace l3d_detail {

/// An end of a line, to be joined with the end of another line.
struct line_end {
    image_place at;
    double out_x = 0, out_y = 0; ///< the direction in which the line would go on, of any length
    std::size_t group = 0;       ///< only lines of the same group may continue this line
};

/// A line in a row of lines that continue each other. `is_back` tells whether the row runs through
/// the line from its end to its beginning.
struct joined_line {
    std::size_t line = 0;
    bool is_back = false;
};

/// Joins lines that end at the same place into rows. The straightest continuations are joined
/// first.
/// Shape: two ends for each line, the first and the last. The result is a list of rows; each line
///        is in one row.
std::vector<std::vector<joined_line>> join_lines(std::span<const std::array<line_end, 2>> lines);

} // namespace l3d_detail

#endif
