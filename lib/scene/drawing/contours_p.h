// SPDX-License-Identifier: MIT
// contours_of: finds the contours of a piece of a surface, as polylines with a bound.
#ifndef L3D_SCENE_DRAWING_CONTOURS_P_H
#define L3D_SCENE_DRAWING_CONTOURS_P_H

#include "scene/drawing/image_piece_p.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace l3d_detail {

/// A vertex of a line on surfaces. It is a place on a piece, with the place where the picture shows
/// it.
struct surface_vertex {
    image_place at{};
    std::size_t piece = 0; ///< the piece's index among all pieces of the drawing
    double u = 0, v = 0;
};

using surface_line = std::vector<surface_vertex>;

/// The contours of a piece without its trims. Each contour runs from boundary to boundary of the
/// piece, or is closed and ends where it begins. `number` is the piece's index among all pieces of
/// the drawing. Vertices lie on the exact contour, and chords are within the tolerance of it in the
/// picture. Contours outside of the picture or behind the near plane may be left out.
///
/// The piece is halved until the contour in each part is certainly one arc that is nearly straight.
/// Source: Bernstein coefficients bound a polynomial; Descartes' rule of signs bounds its zeros.
std::vector<surface_line> contours_of(const image_piece& piece, std::size_t number,
                                      const drawing_view& view, double tolerance);

/// The place on a piece's contour that Newton's method finds when it begins at the parameters of
/// `near`. Nothing if it finds none.
std::optional<surface_vertex> on_contour(const image_piece& piece, const surface_vertex& near);

/// The shape of the surface around a place of its contour.
struct contour_shape {
    /// The unit direction in the picture across the contour, to the side on which the fold shows no
    /// surface.
    double out_x = 0, out_y = 0;
    /// How fast the polynomial image_piece::contour changes along the line of sight. The sign of
    /// `turn` changes at a cusp of the contour's picture.
    double turn = 0;
};
contour_shape shape_of_contour(const image_piece& piece, const surface_vertex& there);

} // namespace l3d_detail

#endif
