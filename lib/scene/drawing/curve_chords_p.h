// SPDX-License-Identifier: MIT
// curve_chords: turns curves on surfaces into chords in the picture.
#ifndef L3D_SCENE_DRAWING_CURVE_CHORDS_P_H
#define L3D_SCENE_DRAWING_CURVE_CHORDS_P_H

#include "scene/drawing/contours_p.h"
#include "scene/drawing/image_piece_p.h"

#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace l3d_detail {

/// Turns curves on a piece into polylines of chords in the picture. A curve that begins where the
/// curve before ends continues its polyline. Parts behind the near plane or beside the picture are
/// left out.
///
/// A curve is halved until all control points of each part are within the tolerance of the part's
/// chord.
class curve_chords {
public:
    /// Lives: borrows the view.
    curve_chords(std::size_t piece, const drawing_view& view, double tolerance)
        : piece_(piece), view_(view), tolerance_(tolerance) {}

    /// Adds a curve. It is a net with n = 0. `place(t)` gives the parameters u and v on the piece
    /// for the curve's parameter t, from 0 to 1.
    void add(const bernstein_net& curve,
             const std::function<std::array<double, 2>(double)>& place) {
        add(curve, place, 0, 1, 0);
    }
    std::vector<surface_line> take() { return std::move(lines_); }

private:
    void add(const bernstein_net& curve, const std::function<std::array<double, 2>(double)>& place,
             double from, double to, int halvings);
    surface_vertex vertex(const double* p, const std::array<double, 2>& at) const {
        return {
            .at = {p[0] / p[2], p[1] / p[2], p[3] / p[2]}, .piece = piece_, .u = at[0], .v = at[1]};
    }
    bool is_flat(const bernstein_net& curve) const;

    std::size_t piece_;
    const drawing_view& view_;
    double tolerance_;
    std::vector<surface_line> lines_;
};

} // namespace l3d_detail

#endif
