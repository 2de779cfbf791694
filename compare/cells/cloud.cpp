// SPDX-License-Identifier: MIT
// l3d_cloud: finds the light along rays, and lays a cloud over pictures of polygons.
#include "compare/cells/cloud.h"

#include "compare/cells/cell_stride.h"
#include "scene/camera_shading.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

l3d_cloud::l3d_cloud(int side, const std::function<matter(const place&)>& of) : side_(side) {
    assert(side >= 1 && side <= 512);
    for (int z = 0; z < side; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const matter here = of({x + 0.5, y + 0.5, z + 0.5});
                density_.push_back(here.density);
                light_.push_back(static_cast<std::uint8_t>(
                    std::lround(std::clamp(here.light, 0.0f, 1.0f) * 255)));
            }
}

/// Adds up the light of the cells along a ray. Cells that a ray meets share faces, so the lengths
/// in them add up to the ray's whole length. The parts of light that they let through multiply to
/// that of one piece of the same density.
l3d_cloud::seen l3d_cloud::look(const place& origin, const place& direction, double from,
                                double to) const {
    constexpr double nothing = 1.0 / 1024;
    seen result;
    const auto [enters, leaves] = l3d_in_cube(origin, direction, side_, from);
    const double end = std::min(leaves, to);
    if (!(enters < end))
        return result;
    const double length = std::sqrt(direction[0] * direction[0] + direction[1] * direction[1] +
                                    direction[2] * direction[2]);
    for (l3d_cell_stride walk(origin, direction, enters, 1, side_);
         walk.t() < end && result.let_through > nothing; walk.go_on()) {
        const auto& cell = walk.cell();
        if (std::any_of(cell.begin(), cell.end(), [this](int i) { return i < 0 || i >= side_; }))
            break; // at the cube's end, rounding may do this
        ++result.cells;
        const std::size_t i = index(cell);
        if (density_[i] == 0)
            continue;
        const double way = (std::min(walk.leaves(), end) - walk.t()) * length;
        const double passes = std::exp(-double(density_[i]) * way);
        result.light += result.let_through * (1 - passes) * (light_[i] / 255.0);
        result.let_through *= passes;
    }
    return result;
}

/// Lays the cloud over the picture ray by ray. Rays are scaled so that one unit of t is one of
/// distance along the view axis, as depth is.
std::int64_t l3d_lay_over(l3d_pixels picture, const l3d_depth_buffer& depth,
                          const l3d_camera& camera, const l3d_cloud& cloud,
                          const l3d_cloud_place& at) {
    using vector = l3d_camera::vector;
    const l3d_shading view =
        l3d_camera_shading(camera, picture.size(), l3d_shade::lambert, l3d_usual_light);
    const vector ahead = camera.target - camera.eye;
    const vector axis = ahead / l3d_length(ahead);
    const double cells = cloud.side() / at.size; // a unit of length
    const vector origin = (camera.eye - at.corner) * cells;
    std::int64_t met = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            vector ray;
            for (int i = 0; i < 3; ++i) {
                const auto k = static_cast<std::size_t>(i);
                ray[i] = double(view.ray[k]) + (x + 0.5) * double(view.ray_right[k]) +
                         (y + 0.5) * double(view.ray_down[k]);
            }
            const vector direction = ray * (cells / l3d_dot(ray, axis));
            const auto column = static_cast<std::size_t>(x);
            const double inv_w = double(depth.row(y)[column]);
            const auto seen = cloud.look(
                {origin[0], origin[1], origin[2]}, {direction[0], direction[1], direction[2]},
                camera.near_z, inv_w > 0 ? 1 / inv_w : std::numeric_limits<double>::infinity());
            met += seen.cells;
            std::uint32_t& word = picture.row(y)[column];
            std::uint32_t mixed = 0;
            for (const int shift : {16, 8, 0}) {
                const double level = (word >> shift & 255) * seen.let_through + 255 * seen.light;
                mixed |= static_cast<std::uint32_t>(std::lround(std::min(level, 255.0))) << shift;
            }
            word = mixed;
        }
    return met;
}
