// SPDX-License-Identifier: MIT
// l3d_tessellation_dicer: Horner's scheme along each column.
#include "dice/tessellation_dicer.h"

#include <algorithm>
#include <array>

namespace {

/// A cubic's power coefficients.
std::array<l3d_image_point, 4> powers_of(const l3d_image_curve& curve) {
    const auto& p = curve.points;
    const l3d_image_point d1 = p[1] - p[0], d2 = (p[2] - p[1]) - d1;
    const l3d_image_point d3 = ((p[3] - p[2]) - (p[2] - p[1])) - d2;
    return {p[0], d1 * 3.0, d2 * 3.0, d3};
}

} // namespace

void l3d_tessellation_dicer::dice(const l3d_image_patch& net, const l3d_normal_net& normals,
                                  const l3d_dice_view& view, l3d_diced_pieces& out,
                                  l3d_dice_counts& counts) {
    l3d_diced_piece& piece = out.next();
    grid_.begin(normals, n_, n_, piece);
    l3d_micro_grid& grid = piece.part.grid;
    const auto scale = static_cast<float>(view.depth_scale);
    for (int column = 0; column <= n_; ++column) {
        const auto a = powers_of(net.curve_at_u(piece.u[static_cast<std::size_t>(column)]));
        for (int row = 0; row <= n_; ++row) {
            const double v = piece.v[static_cast<std::size_t>(row)];
            const l3d_image_point h = ((a[3] * v + a[2]) * v + a[1]) * v + a[0];
            const l3d_snapped s = l3d_snap(h[0], h[1], h[2]);
            const std::size_t at = grid.index(row, column);
            grid.x[at] = s.x + view.centre_x();
            grid.y[at] = s.y + view.centre_y();
            grid.inv_w[at] = s.inv_w * scale;
        }
    }
    l3d_vertex_accuracy accuracy = l3d_evaluated_accuracy(net, view);
    accuracy.error_xy += l3d_power_form_error(accuracy.reach * l3d_depth_range_of(net.points).most);
    accuracy.error_w += l3d_power_form_error(l3d_depth_range_of(net.points).most);
    piece.bound = l3d_uniform_bound(net, view, n_, n_, accuracy);
    ++counts.pieces;
    counts.samples += static_cast<std::int64_t>(piece.u.size() * piece.v.size());
    counts.bound_px = std::max(counts.bound_px, piece.bound);
}
