// SPDX-License-Identifier: MIT
// l3d_space_curve: cuts a NURBS curve into Bezier curves.
#include "scene/space_curve.h"

#include "base/error.h"
#include "base/formatted_p.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

/// Divides the curve into Bezier curves by means of a surface whose rows of points are all the
/// curve's points. The surface's border is the curve.
l3d_space_curve::l3d_space_curve(const l3d_nurbs_curve& curve, std::uint32_t color, double width)
    : color_(color), width_(width) {
    if (!(width > 0 && width <= most_width))
        throw l3d_error(l3d_exit::bad_input,
                        l3d_detail::formatted("space curve: width %g is not above 0 and at most "
                                              "%g pixels",
                                              width, most_width));
    std::vector<std::array<double, 3>> points;
    std::vector<double> weights;
    for (int row = 0; row < 2; ++row) {
        for (const l3d_nurbs_curve::vector& p : curve.points())
            points.push_back({p[0], p[1], p[2]});
        weights.insert(weights.end(), curve.weights().begin(), curve.weights().end());
    }
    const l3d_bspline_direction across{1, {0, 0, 1, 1}, 0, 1};
    for (const l3d_patch_points& patch :
         l3d_bezier_patches(curve.along(), across, points, weights)) {
        bezier& span = spans_.emplace_back();
        for (std::size_t i = 0; i <= static_cast<std::size_t>(patch.degree_u); ++i) {
            const std::array<double, 3>& p = patch.points[i];
            const double w = patch.weights.empty() ? 1 : patch.weights[i];
            span.push_back({p[0] * w, p[1] * w, p[2] * w, w});
        }
    }
}

l3d_space_curve l3d_space_curve::placed(const l3d_matrix<double>& placement) const {
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            if (!std::isfinite(placement(row, column)) ||
                (row == 3 && placement(row, column) != (column == 3 ? 1 : 0)))
                throw l3d_error(l3d_exit::bad_input,
                                l3d_detail::formatted("space curve: the placement has %g in row "
                                                      "%d, column %d",
                                                      placement(row, column), row, column));
    l3d_space_curve result = *this;
    result.placement_ = placement;
    return result;
}
