// SPDX-License-Identifier: MIT
// l3d_uniform_grid: makes the parameters, normals and bounds of a grid.
#include "compare/dicers/uniform_grid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

void l3d_uniform_grid::begin(const l3d_normal_net& normals, int nu, int nv, l3d_diced_piece& out) {
    const auto fill = [](std::vector<double>& parameters, l3d_block_starts& starts, int n) {
        parameters.resize(static_cast<std::size_t>(n) + 1);
        for (std::size_t i = 0; i < parameters.size(); ++i)
            parameters[i] = static_cast<double>(i) / n;
        starts = {1, {0, n}};
    };
    fill(out.u, out.part.block_columns, nu);
    fill(out.v, out.part.block_rows, nv);
    l3d_micro_grid& grid = out.part.grid;
    grid.resize(nu + 1, nv + 1);
    columns_.resize(out.u.size());
    for (std::size_t c = 0; c < out.u.size(); ++c)
        columns_.set(c, normals, out.u[c]);
    for (int row = 0; row <= nv; ++row) {
        const std::size_t at = grid.index(row, 0);
        columns_.emit(out.v[static_cast<std::size_t>(row)], &grid.normal[0][at],
                      &grid.normal[1][at], &grid.normal[2][at]);
    }
}

l3d_vertex_accuracy l3d_evaluated_accuracy(const l3d_image_patch& net, const l3d_dice_view& view) {
    double largest_xy = 0, largest_w = 0;
    for (const l3d_image_point& p : net.points) {
        largest_xy = std::max({largest_xy, std::abs(p[0]), std::abs(p[1])});
        largest_w = std::max(largest_w, p[2]);
    }
    const l3d_image_box hull = l3d_image_box_of(net.points);
    const l3d_image_box seen = hull.intersected(view.margin());
    l3d_vertex_accuracy accuracy;
    accuracy.error_xy = view.error_xy + l3d_evaluation_error(largest_xy);
    accuracy.error_w = view.error_w + l3d_evaluation_error(largest_w);
    accuracy.w_low = l3d_depth_range_of(net.points).least;
    accuracy.reach = hull.reach();
    accuracy.seen_reach = (seen.empty() ? view.margin() : seen).reach();
    // The centre of a folded quad is rounded to sub-pixels once more.
    accuracy.snap_error = l3d_snap_error<double>(accuracy.reach) + l3d_snap_error<double>(0);
    return accuracy;
}

double l3d_uniform_bound(const l3d_image_patch& net, const l3d_dice_view& view, int nu, int nv,
                         const l3d_vertex_accuracy& accuracy) {
    const l3d_image_box seen = l3d_image_box_of(net.points).intersected(view.margin());
    if (seen.empty())
        return 0;
    const l3d_second_bounds image = l3d_second_bounds_of(net, seen, accuracy.w_low);
    const l3d_second_bounds depth = l3d_depth_bounds_of(net);
    const double w_ratio =
        l3d_vertex_accuracy::in_front + depth.triangle_error(nu, nv) / accuracy.w_low;
    return image.quad_error(nu, nv) + accuracy.drawn_error(w_ratio);
}
