// SPDX-License-Identifier: MIT
// Makes the gallery's models: bodies of revolution, a sheet, and the teapot in colour.
#include "shapes.h"
#include <l3d/material.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace {

using patch = l3d_patch_model::patch;
using vector = l3d_patch_model::vector;

/// Distance of the inner control points from the ends of a cubic curve that is nearly a quarter of
/// a unit circle, round to 2.7e-4.
/// Source: 4 (sqrt 2 - 1) / 3.
constexpr double quarter = 0.5522847498307936;

/// A point of a profile: its distance from the axis, and its height.
struct place {
    double radius, height;
};

/// Turns a profile of cubic curves, end to end, about the upright axis.
/// Shape: 3 n + 1 points, from bottom to top where the outside is to be the front.
l3d_patch_model revolved(std::span<const place> profile) {
    constexpr std::array<std::array<double, 2>, 4> arc{
        {{1, 0}, {1, quarter}, {quarter, 1}, {0, 1}}};
    std::vector<patch> patches;
    for (std::size_t first = 0; first + 3 < profile.size(); first += 3)
        for (int turn = 0; turn < 4; ++turn) {
            patch p;
            for (int row = 0; row < 4; ++row)
                for (int column = 0; column < 4; ++column) {
                    const auto [radius, height] = profile[first + static_cast<std::size_t>(row)];
                    double x = radius * arc[static_cast<std::size_t>(column)][0];
                    double z = -radius * arc[static_cast<std::size_t>(column)][1];
                    for (int i = 0; i < turn; ++i) {
                        const double old = x;
                        x = z;
                        z = -old;
                    }
                    p.at(row, column) = vector{x, height, z};
                }
            patches.push_back(p);
        }
    return l3d_patch_model(std::move(patches));
}

/// The material of each patch.
std::vector<l3d_material> materials_of(const l3d_patch_model& model) {
    std::vector<l3d_material> materials(model.patches().size());
    if (!model.materials().empty())
        for (std::size_t i = 0; i < materials.size(); ++i)
            materials[i] = model.materials()[model.material_of(i)];
    return materials;
}

} // namespace

l3d_patch_model ball() {
    return revolved(std::array<place, 7>{
        {{0, 0}, {quarter, 0}, {1, 1 - quarter}, {1, 1}, {1, 1 + quarter}, {quarter, 2}, {0, 2}}});
}

l3d_patch_model ring() {
    constexpr double middle = 0.7, thick = 0.3, bend = quarter * thick;
    return revolved(std::array<place, 13>{{{middle, 0},
                                           {middle + bend, 0},
                                           {middle + thick, thick - bend},
                                           {middle + thick, thick},
                                           {middle + thick, thick + bend},
                                           {middle + bend, 2 * thick},
                                           {middle, 2 * thick},
                                           {middle - bend, 2 * thick},
                                           {middle - thick, thick + bend},
                                           {middle - thick, thick},
                                           {middle - thick, thick - bend},
                                           {middle - bend, 0},
                                           {middle, 0}}});
}

l3d_patch_model vase() {
    return revolved(std::array<place, 10>{{{0, 0},
                                           {0.3, 0},
                                           {0.5, 0},
                                           {0.55, 0.1},
                                           {1.3, 1.6},
                                           {0.25, 1.5},
                                           {0.25, 2.2},
                                           {0.25, 2.45},
                                           {0.4, 2.6},
                                           {0.6, 2.7}}});
}

l3d_patch_model waves() {
    constexpr int patches_along = 4, knots = 3 * patches_along;
    // Control points at thirds of a patch, on the tangents of sin(x) sin(z) at the patches' ends.
    const auto along = [](int i) {
        const auto wave = [](double t) { return std::sin(2 * t); };
        const auto slope = [](double t) { return 2 * std::cos(2 * t); };
        const double step = 3.0 / patches_along, third = step / 3;
        const double begin = (i - i % 3) / 3 * step, next = begin + step;
        switch (i % 3) {
        case 0:
            return wave(begin);
        case 1:
            return wave(begin) + slope(begin) * third;
        default:
            return wave(next) - slope(next) * third;
        }
    };
    std::vector<patch> patches;
    for (int v = 0; v < patches_along; ++v)
        for (int u = 0; u < patches_along; ++u) {
            patch p;
            for (int row = 0; row < 4; ++row)
                for (int column = 0; column < 4; ++column) {
                    const int i = 3 * u + column, k = 3 * v + row;
                    p.at(row, column) =
                        vector{2.4 * i / knots - 1.2, 0.9 + 0.35 * along(i) * along(k),
                               1.2 - 2.4 * k / knots};
                }
            patches.push_back(p);
        }
    return l3d_patch_model(std::move(patches));
}

l3d_patch_model colored_teapot() {
    constexpr l3d_material body{0xe8dcc4, 0x505050, 60}, lid{0xc8452f, 0x606060, 60},
        handle{0x2f6f8f, 0x505050, 60};
    const l3d_patch_model teapot = l3d_patch_model::teapot();
    std::vector<l3d_material> materials;
    for (std::size_t i = 0; i < teapot.patches().size(); ++i) {
        const std::string_view part = teapot.parts().name_of(i);
        const bool is_beside = part == "handle" || part == "spout";
        materials.push_back(part == "lid" ? lid : is_beside ? handle : body);
    }
    return teapot.painted(materials);
}

l3d_patch_model in_teapots_place(const l3d_patch_model& model) {
    constexpr double width = 6.5; // the teapot's, from the handle to the spout
    const vector extent = model.most() - model.least();
    const double widest = std::max({extent[0], extent[1], extent[2]});
    const double scale = widest > 0 ? width / widest : 1;
    vector foot = (model.least() + model.most()) * 0.5;
    foot[1] = model.least()[1];
    std::vector<patch> patches(model.patches().begin(), model.patches().end());
    for (patch& p : patches)
        for (vector& point : p.points)
            point = (point - foot) * scale;
    return l3d_patch_model(std::move(patches))
        .with_parts(model.parts().runs())
        .painted(materials_of(model));
}

l3d_patch_model matt(const l3d_patch_model& model) {
    std::vector<l3d_material> materials = materials_of(model);
    for (l3d_material& material : materials)
        material = {.color = material.color, .opacity = material.opacity};
    return model.painted(materials);
}
