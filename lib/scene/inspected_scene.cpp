// SPDX-License-Identifier: MIT
// l3d_inspected_scene, l3d_usual_curvature: take nets to eye coordinates, and scale curvature.
#include "scene/inspected_scene.h"

#include "geom/patch_jet.h"
#include "scene/placed_net.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace {

using vector = l3d_camera::vector;

/// The rows of a matrix that l3d_placed_net takes for coordinates 0, 1 and 2.
constexpr std::array<int, 3> rows{0, 1, 3};

/// The matrix from the world to coordinates along `axes`, counted from `origin`.
l3d_matrix<double> to_axes(const std::array<vector, 3>& axes, const vector& origin) {
    l3d_matrix<double> result = l3d_identity<double>();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (int k = 0; k < 3; ++k)
            result(rows[i], k) = axes[i][k];
        result(rows[i], 3) = -l3d_dot(axes[i], origin);
    }
    return result;
}

std::array<vector, 3> axes_of(const l3d_camera& camera) {
    const l3d_camera::frame axes = camera.axes();
    return {axes.right, -axes.up, axes.forward};
}

vector along(const std::array<vector, 3>& axes, const vector& direction) {
    return l3d_normalized(vector{l3d_dot(axes[0], direction), l3d_dot(axes[1], direction),
                                 l3d_dot(axes[2], direction)});
}

/// Rounds a number up to 1, 2 or 5 times a power of ten.
/// Expects: a positive finite number.
double rounded_up(double number) {
    const double power = std::pow(10.0, std::floor(std::log10(number)));
    for (const double step : {1.0, 2.0, 5.0})
        if (number <= step * power * (1 + 1e-9))
            return step * power;
    return 10 * power;
}

} // namespace

void l3d_inspected_scene::begin(const l3d_camera& camera, const l3d_dice_view& view,
                                const l3d_shading& shading) {
    const l3d_size size = view.size;
    const auto axes = axes_of(camera);
    patches_.eye = camera.eye;
    patches_.focal = camera.focal_length(size);
    if (camera.is_parallel()) { // dicing uses a far eye, too
        const double distance = view.w_middle / view.depth_scale;
        patches_.eye = camera.target - axes[2] * distance;
        patches_.focal = view.focal;
    }
    to_eye_ = to_axes(axes, patches_.eye);
    patches_.centre_x = size.width / 2.0;
    patches_.centre_y = size.height / 2.0;
    const auto& light = shading.light;
    patches_.light = along(axes, {double{light[0]}, double{light[1]}, double{light[2]}});
    patches_.direction = along(axes, shading.inspection.direction);
    patches_.nets.clear();
    patches_.materials.clear();
    patches_.axes = axes;
    with_materials_ = shading.mode == l3d_shade::own;
}

void l3d_inspected_scene::add(const l3d_patch_scene& scene,
                              std::span<const l3d_placed_patch> batch) {
    for (const l3d_placed_patch& p : batch) {
        const l3d_patch_instance& instance = scene.instances()[p.instance];
        patches_.nets.push_back(
            l3d_placed_net(to_eye_ * instance.placement(), instance.model().patches()[p.patch]));
        if (with_materials_) {
            const auto all = scene.materials();
            patches_.materials.push_back(all.empty() ? l3d_material()
                                                     : all[scene.material_of(p.instance, p.patch)]);
        }
    }
}

double l3d_usual_curvature(const l3d_patch_scene& scene, l3d_shade shade) {
    // The most patches that are sampled, at 25 places each.
    constexpr std::int64_t most_patches = 2048;
    constexpr std::array<double, 5> places{0.1, 0.3, 0.5, 0.7, 0.9};
    const std::int64_t step = std::max<std::int64_t>(1, scene.patch_count() / most_patches);
    const l3d_matrix<double> axes = to_axes(
        {vector{1.0, 0.0, 0.0}, vector{0.0, 1.0, 0.0}, vector{0.0, 0.0, 1.0}}, {0.0, 0.0, 0.0});
    std::vector<std::pair<double, double>> found; // curvature, and the area that has it
    std::int64_t index = 0;
    for (const l3d_patch_instance& instance : scene.instances()) {
        const l3d_matrix<double> placed = axes * instance.placement();
        for (const l3d_patch_model::patch& patch : instance.model().patches()) {
            if (index++ % step != 0)
                continue;
            const l3d_image_patch net = l3d_placed_net(placed, patch);
            for (const double u : places)
                for (const double v : places) {
                    const l3d_patch_jet jet = l3d_jet_of(net, u, v);
                    const auto bend = l3d_bend_of(jet);
                    if (!bend)
                        continue;
                    const double bent =
                        std::abs(shade == l3d_shade::gaussian ? bend->gaussian : bend->mean);
                    const double area = l3d_length(l3d_cross(jet.along_u, jet.along_v));
                    if (std::isfinite(bent) && std::isfinite(area))
                        found.emplace_back(bent, area);
                }
        }
    }
    std::sort(found.begin(), found.end());
    double left = 0;
    for (const auto& [bent, area] : found)
        left += 0.9 * area;
    double most = 0;
    for (const auto& [bent, area] : found) {
        most = bent;
        left -= area;
        if (left < 0)
            break;
    }
    // Rounding gives a plane some curvature, which does not count.
    const double size = std::max(scene.reach(), std::numeric_limits<double>::min());
    const double least = 1e-9 / (shade == l3d_shade::gaussian ? size * size : size);
    return most > least && std::isfinite(rounded_up(most)) ? rounded_up(most) : 1;
}
