// SPDX-License-Identifier: MIT
// l3d_method_voxels: fills cells, and follows rays through them.
#include "compare/method_voxels.h"

#include "scene/dice_view.h"
#include "scene/placed_net.h"

#include "geom/forward_difference.h"
#include "geom/real.h"
#include "dice/normal_columns.h"
#include "pipeline/stopwatch_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace {

using vector = l3d_patch_model::vector;
using l3d_detail::stopwatch;

/// The number of points for each cell along both parameters. So they meet every cell that the
/// surface passes through by more than a corner.
constexpr double points_per_cell = 2;

/// The most steps of a patch, along each parameter; no patch in the cube needs more.
constexpr int most_steps = 1 << 13;

/// A rim of cells around the scene, so that nothing is outside by a rounding.
constexpr int rim = 1;

/// The number of steps that puts points half a cell apart. The derivative of a cubic is three times
/// a mean of the net's differences.
int steps_of(const l3d_patch_model::patch& p, bool along_u) {
    double longest = 0;
    for (int line = 0; line < 4; ++line)
        for (int i = 0; i < 3; ++i) {
            const vector d = along_u ? vector(p.at(line, i + 1) - p.at(line, i))
                                     : vector(p.at(i + 1, line) - p.at(i, line));
            longest = std::max({longest, std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
        }
    return std::clamp(static_cast<int>(std::ceil(3 * longest * points_per_cell)), 1, most_steps);
}

/// The camera's place: the point whose x, y and w are 0. Source: Cramer's rule.
vector eye_of(const l3d_matrix<double>& m) {
    const auto row = [&](int r) { return vector(m(r, 0), m(r, 1), m(r, 2)); };
    const vector a = row(0), b = row(1), c = row(3);
    const vector bc = l3d_cross<double>(b, c), ca = l3d_cross<double>(c, a),
                 ab = l3d_cross<double>(a, b);
    const double determinant = l3d_dot(a, bc);
    return (bc * m(0, 3) + ca * m(1, 3) + ab * m(3, 3)) * (-1 / determinant);
}

} // namespace

void l3d_method_voxels::fill(const l3d_patch_scene& scene) {
    cube_.reset(resolution_);
    filled_with_.remember(scene);
    double size = 0;
    for (int i = 0; i < 3; ++i)
        size = std::max(size, scene.most()[i] - scene.least()[i]);
    cells_per_unit_ = (resolution_ - 2 * rim) / std::max(size, 1e-300);
    const vector middle = (scene.most() + scene.least()) * 0.5;
    corner_ = middle - vector(1.0, 1.0, 1.0) * (resolution_ / (2 * cells_per_unit_));
    for (const l3d_patch_instance& instance : scene.instances()) {
        const l3d_matrix<double>& m = instance.placement();
        for (std::size_t i = 0; i < instance.model().patches().size(); ++i) {
            l3d_patch_model::patch p = instance.model().patches()[i];
            for (vector& point : p.points) {
                const l3d_vector<double, 4> h =
                    m * l3d_vector<double, 4>(point[0], point[1], point[2], 1.0);
                point = (vector(h[0], h[1], h[2]) - corner_) * cells_per_unit_;
            }
            const l3d_normal_net& normals = instance.model().normals(i);
            fill(p, instance.turns_normals() ? l3d_placed_normals(instance.normal_matrix(), normals)
                                             : normals);
        }
    }
}

void l3d_method_voxels::fill(const l3d_patch_model::patch& in_cells,
                             const l3d_normal_net& normals) {
    const int nu = steps_of(in_cells, true), nv = steps_of(in_cells, false);
    l3d_normal_columns column;
    column.resize(1);
    for (int c = 0; c <= nu; ++c) {
        const double u = static_cast<double>(c) / nu;
        const auto b = in_cells.curve_at_u(u).points;
        std::array<l3d_forward_difference<l3d_real, 3>, 3> walk;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto i = static_cast<int>(k);
            walk[k] = l3d_forward_difference<l3d_real, 3>::build(
                {b[0][i], b[1][i], b[2][i], b[3][i]}, nv);
        }
        column.set(0, normals, u);
        for (int r = 0; r <= nv; ++r) {
            std::array<float, 3> normal;
            column.emit(static_cast<double>(r) / nv, &normal[0], &normal[1], &normal[2]);
            cube_.fill({l3d_to_double(walk[0].value()), l3d_to_double(walk[1].value()),
                        l3d_to_double(walk[2].value())},
                       normal);
            for (auto& coordinate : walk)
                coordinate.step();
        }
    }
    counts_.samples += std::int64_t{nu + 1} * (nv + 1);
}

void l3d_method_voxels::do_draw(const l3d_method_frame& frame, l3d_stage_times& times) {
    const stopwatch filling;
    counts_ = {};
    if (!filled_with_.holds(frame.scene))
        fill(frame.scene);
    counts_.drawn = frame.scene.patch_count();
    counts_.bound_px = std::numeric_limits<double>::infinity();
    times.dice += filling.milliseconds();

    const stopwatch looking;
    frame.depth.resize(frame.view.size);
    frame.depth.clear();
    for (l3d_point_canvas& canvas : canvases_)
        canvas.begin(frame.target, frame.depth, frame.shading);
    const vector eye = eye_of(frame.to_image);
    workers_.for_each(frame.view.size.height, [&](int row, int worker) {
        std::ranges::fill(frame.target.row(row),
                          frame.shading.background.word(row, frame.view.size.height));
        look_along(row, frame, eye, canvases_[static_cast<std::size_t>(worker)]);
    });
    surface_counts_ = {};
    for (const l3d_point_canvas& canvas : canvases_) {
        surface_counts_.samples += canvas.counts().samples;
        surface_counts_.written += canvas.counts().written;
    }
    surface_counts_.covered = covered_of(frame, frame.depth);
    times.raster += looking.milliseconds();
}

/// Follows the rays of a row of pixels. They are scaled so that one unit of t is one of w.
void l3d_method_voxels::look_along(int row, const l3d_method_frame& frame, const vector& eye,
                                   l3d_point_canvas& canvas) const {
    const auto& m = frame.to_image;
    const vector origin = (eye - corner_) * cells_per_unit_;
    for (int x = 0; x < frame.view.size.width; ++x) {
        vector ray;
        for (int i = 0; i < 3; ++i) {
            const auto k = static_cast<std::size_t>(i);
            ray[i] = static_cast<double>(frame.shading.ray[k]) +
                     (x + 0.5) * static_cast<double>(frame.shading.ray_right[k]) +
                     (row + 0.5) * static_cast<double>(frame.shading.ray_down[k]);
        }
        const double w = m(3, 0) * ray[0] + m(3, 1) * ray[1] + m(3, 2) * ray[2];
        const vector direction = ray * (cells_per_unit_ / w);
        const auto hit = cube_.first({origin[0], origin[1], origin[2]},
                                     {direction[0], direction[1], direction[2]}, frame.view.near);
        if (!hit || hit->t > frame.view.far)
            continue;
        const auto inv_w = static_cast<float>(frame.view.depth_scale / hit->t);
        if (canvas.is_nearest(x, row, inv_w))
            canvas.put(x, row, inv_w, hit->normal);
    }
}
