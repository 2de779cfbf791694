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

/// A line on surfaces, before the search for what hides it.
struct drawn_chain {
    l3d_line_kind kind = l3d_line_kind::contour;
    surface_line points;
    /// The pieces that meet along the whole line; none for contours inside of pieces.
    std::vector<std::size_t> sides{};
    std::vector<std::size_t> cusps{}; ///< vertices at which the picture of a contour turns back
    /// The edge of the model, if the line is one; then u of each vertex is the edge's parameter.
    std::optional<std::size_t> edge{};
};

/// Finds the lines along the sides of pieces and along their trims. Lines along edges of a model
/// are left out, since edge_joints finds them.
///
/// Two sides at the same places are one line, in either direction. So are a half of a side and a
/// whole side. The line is a crease if the normals of its pieces differ by two degrees or more at
/// any of the places that are tried. Else it is a contour wherever one piece shows its front and
/// the other its back. So contours of pieces that are not quite smooth join, too.
/// Shape: `contours` holds the lines of contours_of for each piece, trimmed.
std::vector<drawn_chain> borders_of(std::span<const image_piece> pieces,
                                    std::span<const std::vector<surface_line>> contours,
                                    const drawing_view& view, double tolerance);

/// Whether two unit normals differ by less than two degrees, or one of them is missing.
bool have_one_plane(const l3d_vector<double, 3>& n, const l3d_vector<double, 3>& o);

/// The parts of a line that the piece's trims leave.
std::vector<surface_line> trimmed(const image_piece& piece, const surface_line& line);

} // namespace l3d_detail

#endif
