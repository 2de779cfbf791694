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

l3d_image_point measuring_sink::placed(const l3d_micro_vertex& vertex) const {
    const double w = 1.0 / static_cast<double>(vertex.inv_w);
    return {(vertex.x - view_.centre_x()) * w / l3d_subpixel_one,
            (vertex.y - view_.centre_y()) * w / l3d_subpixel_one, w};
}

void measuring_sink::do_grid(const l3d_dice_grid& grid) {
    const l3d_micro_grid& g = grid.vertices;
    for (int r = 0; r + 1 < g.rows; ++r)
        for (int c = 0; c + 1 < g.columns; ++c) {
            const l3d_image_point p00 = placed(g.vertex(r, c)), p10 = placed(g.vertex(r, c + 1));
            const l3d_image_point p01 = placed(g.vertex(r + 1, c));
            const l3d_image_point p11 = placed(g.vertex(r + 1, c + 1));
            const auto row = static_cast<std::size_t>(r), column = static_cast<std::size_t>(c);
            for (const double s : {0.0, 0.5, 1.0})
                for (const double t : {0.0, 0.5, 1.0})
                    error_.add_point(*patch_,
                                     (p00 * (1 - s) + p10 * s) * (1 - t) +
                                         (p01 * (1 - s) + p11 * s) * t,
                                     grid.u[column] + s * (grid.u[column + 1] - grid.u[column]),
                                     grid.v[row] + t * (grid.v[row + 1] - grid.v[row]));
        }
}

void measuring_sink::do_triangles(std::span<const l3d_dice_vertex> corners, double) {
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const l3d_dice_vertex &a = corners[i + k], &b = corners[i + (k + 1) % 3];
            error_.add_point(*patch_, (placed(a.vertex) + placed(b.vertex)) * 0.5, (a.u + b.u) / 2,
                             (a.v + b.v) / 2);
        }
}
