// SPDX-License-Identifier: MIT
// borders_of: creases and borders of pieces, and the stretches of smooth sides that are contours.
#ifndef L3D_SCENE_DRAWING_BORDERS_P_H
#define L3D_SCENE_DRAWING_BORDERS_P_H

#include "scene/drawing/contours_p.h"
#include "scene/line_drawing.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace l3d_detail {

/// A line on surfaces, before the search for surfaces that hide it.
struct drawn_chain {
    l3d_line_kind kind = l3d_line_kind::contour;
    surface_line points;
    /// The pieces that meet along the whole line; none for contours inside of pieces.
    std::vector<std::size_t> sides{};
    std::vector<std::size_t> cusps{}; ///< vertices at which the picture of a contour turns back
    /// The edge's index among all edges of the drawing, if the line runs along an edge of a model.
    /// Then u of each vertex is the edge's parameter.
    std::optional<std::size_t> edge{};
};

/// Finds the lines along the sides of pieces and along their trims. Lines along edges of a model
/// are left out, since edge_joints finds them.
///
/// Sides that coincide, in either direction, make one line. A half of a side may coincide with a
/// whole side. A lone side is a border. Three or more sides make a crease. Two sides make a crease
/// if their normals differ by two degrees or more at any of the places that are tried. Else the
/// line is a contour wherever one piece shows its front and the other its back. So contours join
/// across sides that are not quite smooth.
/// Shape: `contours` holds the lines of contours_of for each piece, trimmed.
std::vector<drawn_chain> borders_of(std::span<const image_piece> pieces,
                                    std::span<const std::vector<surface_line>> contours,
                                    const drawing_view& view, double tolerance);

/// Whether two unit normals differ by less than two degrees, or one of them is missing.
bool have_one_plane(const l3d_vector<double, 3>& n, const l3d_vector<double, 3>& o);

/// The parts of a line on a piece that the piece's trims leave.
std::vector<surface_line> trimmed(const image_piece& piece, const surface_line& line);

} // namespace l3d_detail

#endif
