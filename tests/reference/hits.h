// SPDX-License-Identifier: MIT
// All intersections of a piece of surface with the rays through a grid of picture points.
#ifndef L3D_REFERENCE_HITS_H
#define L3D_REFERENCE_HITS_H

#include "reference/net.h"

#include <functional>
#include <optional>
#include <stop_token>

namespace reference {

/// A grid of samples. Sample (i, j) lies at the picture position (x0 + i step, y0 + j step).
struct sample_grid {
    double x0 = 0.5, y0 = 0.5, step = 1;
    int columns = 0, rows = 0;

    rect box() const { return {x0, y0, x0 + (columns - 1) * step, y0 + (rows - 1) * step}; }
};

/// An intersection: the surface point (u, v) of the whole patch is seen exactly at sample (i, j).
struct hit {
    int i = 0, j = 0;
    double u = 0, v = 0, w = 0;
};

/// Proof that a piece maps one to one onto the picture.
///
/// For a picture point c in the piece's box and in `where`, let F_c(u, v) = (x - c_x w, y - c_y w).
/// It vanishes where the surface is seen at c. With inverse = DF(middle)^-1, |inverse DF_c - 1| <=
/// contraction in the maximum norm on the whole piece. Hence there is at most one zero, and no
/// silhouette.
struct chart {
    double inverse[2][2];
    double contraction;
};
/// Looks for a proof; the result is empty if none was found.
/// Expects: all w > 0; the box touches `where`.
std::optional<chart> make_chart(const net& piece, const rect& where);

/// Calls `found` for every intersection with w >= near. An intersection on a seam of pieces comes
/// twice.
/// Errors:  std::runtime_error after 20 million pieces, or if told to stop.
void find_hits(const net& piece, double near, const sample_grid& grid,
               const std::function<void(const hit&)>& found, const std::stop_token& stop = {});

} // namespace reference

#endif
