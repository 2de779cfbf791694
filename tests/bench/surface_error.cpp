// SPDX-License-Identifier: MIT
// surface_error: sampling drawn pieces.
#include "bench/surface_error.h"

#include <algorithm>
#include <cmath>

surface_error::surface_error(const l3d_camera& camera, l3d_size size)
    : matrix_(camera.image_matrix(size)), window_{-size.width / 2.0, -size.height / 2.0,
                                                  size.width / 2.0, size.height / 2.0} {}

void surface_error::add_point(const l3d_patch_model::patch& patch, const l3d_image_point& drawn,
                              double u, double v) {
    const double x = drawn[0] / drawn[2], y = drawn[1] / drawn[2];
    if (x < window_.left || x > window_.right || y < window_.top || y > window_.bottom)
        return;
    const auto p = patch.evaluate(u, v);
    const l3d_vector<double, 4> h = matrix_ * l3d_vector<double, 4>(p[0], p[1], p[2], 1.0);
    largest_ = std::max(largest_, std::hypot(x - h[0] / h[3], y - h[1] / h[3]));
}

namespace {

l3d_image_point placed(const l3d_micro_vertex& vertex, const l3d_dice_view& view) {
    const double w = 1.0 / static_cast<double>(vertex.inv_w);
    return {(vertex.x - view.centre_x()) * w / l3d_subpixel_one,
            (vertex.y - view.centre_y()) * w / l3d_subpixel_one, w};
}

void add_grid(surface_error& error, const l3d_patch_model::patch& patch,
              const l3d_diced_piece& piece, const l3d_dice_view& view) {
    const l3d_micro_grid& g = piece.part.grid;
    const auto at = [&](int r, int c) { return placed(g.vertex(r, c), view); };
    for (int r = 0; r + 1 < g.rows; ++r)
        for (int c = 0; c + 1 < g.columns; ++c) {
            const l3d_image_point p00 = at(r, c), p10 = at(r, c + 1);
            const l3d_image_point p01 = at(r + 1, c), p11 = at(r + 1, c + 1);
            const double* u = &piece.u[static_cast<std::size_t>(c)];
            const double* v = &piece.v[static_cast<std::size_t>(r)];
            for (int i = 0; i <= error_lattice; ++i)
                for (int j = 0; j <= error_lattice; ++j) {
                    const double s = i / double{error_lattice}, t = j / double{error_lattice};
                    error.add_point(
                        patch, (p00 * (1 - s) + p10 * s) * (1 - t) + (p01 * (1 - s) + p11 * s) * t,
                        u[0] + s * (u[1] - u[0]), v[0] + t * (v[1] - v[0]));
                }
        }
}

void add_triangles(surface_error& error, const l3d_patch_model::patch& patch,
                   const l3d_diced_piece& piece, const l3d_dice_view& view) {
    const auto& triangles = piece.part.triangles;
    for (std::size_t i = 0; i < triangles.count; ++i) {
        const l3d_image_point a = placed(triangles.vertex(i, 0), view);
        const l3d_image_point b = placed(triangles.vertex(i, 1), view);
        const l3d_image_point c = placed(triangles.vertex(i, 2), view);
        const auto &at_a = piece.triangle_uv[0][i], &at_b = piece.triangle_uv[1][i];
        const auto& at_c = piece.triangle_uv[2][i];
        for_triangle_lattice([&](double p, double q, double r) {
            error.add_point(patch, a * p + b * q + c * r, at_a.u * p + at_b.u * q + at_c.u * r,
                            at_a.v * p + at_b.v * q + at_c.v * r);
        });
    }
}

} // namespace

void add_pieces(surface_error& error, const l3d_patch_model::patch& patch,
                std::span<const l3d_diced_piece> pieces, const l3d_dice_view& view) {
    for (const l3d_diced_piece& piece : pieces) {
        add_grid(error, patch, piece, view);
        add_triangles(error, patch, piece, view);
    }
}
