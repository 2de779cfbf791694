// SPDX-License-Identifier: MIT
// surface_error: sampling drawn pieces.
#include "bench/surface_error.h"

#include <algorithm>
#include <cmath>

surface_error::surface_error(const l3d_camera& camera, l3d_size size)
    : matrix_(camera.image_matrix(size)), window_{-size.width / 2.0, -size.height / 2.0,
                                                  size.width / 2.0, size.height / 2.0} {}

l3d_image_point surface_error::exact(const l3d_patch_model::patch& patch, double u,
                                     double v) const {
    const auto p = patch.evaluate(u, v);
    const l3d_vector<double, 4> h = matrix_ * l3d_vector<double, 4>(p[0], p[1], p[2], 1.0);
    return {h[0], h[1], h[3]};
}

void surface_error::add_point(const l3d_patch_model::patch& patch, const l3d_image_point& drawn,
                              double u, double v) {
    const double x = drawn[0] / drawn[2], y = drawn[1] / drawn[2];
    if (x < window_.left || x > window_.right || y < window_.top || y > window_.bottom)
        return;
    const l3d_image_point h = exact(patch, u, v);
    const double distance = std::hypot(x - h[0] / h[2], y - h[1] / h[2]);
    largest_ = std::max(largest_, distance);
    sum_ += distance;
    ++count_;
}

void surface_error::add_triangle(const l3d_patch_model::patch& patch, const double (&u)[3],
                                 const double (&v)[3]) {
    l3d_image_point p[3];
    for (int i = 0; i < 3; ++i)
        p[i] = exact(patch, u[i], v[i]);
    for (int i = 0; i < 3; ++i) {
        const int k = (i + 1) % 3;
        add_point(patch, (p[i] + p[k]) * 0.5, (u[i] + u[k]) / 2, (v[i] + v[k]) / 2);
    }
    add_point(patch, (p[0] + p[1] + p[2]) * (1.0 / 3), (u[0] + u[1] + u[2]) / 3,
              (v[0] + v[1] + v[2]) / 3);
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
            for (const double s : {0.0, 0.5, 1.0})
                for (const double t : {0.0, 0.5, 1.0})
                    error.add_point(
                        patch, (p00 * (1 - s) + p10 * s) * (1 - t) + (p01 * (1 - s) + p11 * s) * t,
                        u[0] + s * (u[1] - u[0]), v[0] + t * (v[1] - v[0]));
        }
}

void add_triangles(surface_error& error, const l3d_patch_model::patch& patch,
                   const l3d_diced_piece& piece, const l3d_dice_view& view) {
    for (std::size_t i = 0; i < piece.part.triangles.count; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            const auto &a = piece.triangle_uv[k][i], &b = piece.triangle_uv[next][i];
            error.add_point(patch,
                            (placed(piece.part.triangles.vertex(i, k), view) +
                             placed(piece.part.triangles.vertex(i, next), view)) *
                                0.5,
                            (a.u + b.u) / 2, (a.v + b.v) / 2);
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
