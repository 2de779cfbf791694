// SPDX-License-Identifier: MIT
// Curved cases: control points in a studio, weights of any size, poles and needles.
#include "curved_cases.h"
#include "studio.h"

#include "geom/nurbs/bicubic_approximation.h"
#include "scene/levels/curved_pieces.h"

#include <array>
#include <cmath>
#include <utility>

namespace stability {
namespace {

/// What a curved case begins with, and how far its control points are thrown about, as a part of
/// the distance between them.
struct curved_kind {
    const char* name;
    double thrown;
    double most_weight; ///< weights are from 1 / most_weight to this
    bool has_pole, is_needle;
};
constexpr std::array<curved_kind, 8> kinds{{{"gentle", 0.3, 2, false, false},
                                            {"wild", 3, 10, false, false},
                                            {"weights", 0.3, 1e3, false, false},
                                            {"pole", 0.3, 10, true, false},
                                            {"needle", 0.3, 10, false, true},
                                            {"pole with weights", 1, 1e3, true, false},
                                            {"needle with weights", 1, 1e3, false, true},
                                            {"nearly flat", 1e-3, 1.1, false, false}}};

/// A part of a patch, which has weights that are less far apart.
l3d_patch_points part_of(const l3d_patch_points& patch, std::size_t halvings, numbers& random) {
    l3d_rational_piece piece(patch);
    for (std::size_t i = 0; i < 2 * halvings; ++i) {
        const auto [first, second] = piece.halves(i % 2 == 0);
        piece = random.below(2) == 0 ? first : second;
    }
    l3d_patch_points result{patch.degree_u, patch.degree_v, {}, {}};
    for (const l3d_rational_piece::point& p : piece.points) {
        result.points.push_back({p[0] / p[3], p[1] / p[3], p[2] / p[3]});
        if (!patch.weights.empty())
            result.weights.push_back(p[3]);
    }
    return result;
}

/// A patch, or a part of it that has few cells. Whole patches with wild weights have 10^5, and take
/// seconds. So do parts at a cusp, unless they are left for a part beside it.
l3d_patch_points plain_part_of(l3d_patch_points patch, std::size_t halvings, numbers& random) {
    constexpr double most_cells = 512;
    constexpr int most_cuts = 8;
    patch = part_of(patch, halvings, random);
    const auto cells = [&] {
        const l3d_curved_pieces pieces({patch});
        l3d_found_cells found;
        return pieces.cuts_for({.places = pieces.place_target(0)}, {}, found).cells;
    };
    for (int i = 0; i < most_cuts && cells() > most_cells; ++i)
        patch = part_of(patch, 1, random);
    return patch;
}

} // namespace

test_case curved_case(std::uint64_t seed) {
    numbers random(seed);
    const curved_kind& kind = kinds[(seed / 2) % kinds.size()];
    constexpr std::array<reference::picture_size, 4> sizes{
        {{64, 48}, {97, 61}, {160, 120}, {317, 241}}};
    const auto unit = [&] { return random.between(-1, 1); };
    studio in;
    in.eye.eye = {5 * unit(), 5 * unit(), 5 * unit()};
    in.eye.target = {unit(), unit(), unit()};
    in.eye.up = {unit(), unit(), unit()};
    in.eye.fov_degrees = random.between(15, 90);
    in.eye.near = random.of_any_size(0.01, 1);
    in.size = sizes[random.below(sizes.size())];

    l3d_patch_points patch;
    const bool is_high = seed % 2 == 0;
    const auto degree = [&] {
        return is_high ? 4 + static_cast<int>(random.below(12))
                       : 1 + static_cast<int>(random.below(3));
    };
    patch.degree_u = degree();
    patch.degree_v = degree();
    const bool is_rational = !is_high || random.below(2) == 0;
    const double size = random.of_any_size(0.05, 1), width = kind.is_needle ? 1e-3 * size : size;
    const double depth = in.eye.near * random.between(4, 40);
    const double left = random.between(0, 1), top = random.between(0, 1);
    const reference::camera_frame frame(in.eye, in.size);
    for (int row = 0; row <= patch.degree_v; ++row)
        for (int column = 0; column <= patch.degree_u; ++column) {
            const double u = (column + kind.thrown * unit()) / patch.degree_u - 0.5;
            const double v = (row + kind.thrown * unit()) / patch.degree_v - 0.5;
            const reference::vec3 p = frame.unproject((left + size * u) * in.size.width,
                                                      (top + width * v) * in.size.height,
                                                      depth * std::exp(0.3 * kind.thrown * unit()));
            patch.points.push_back({p.x, p.y, p.z});
            if (is_rational)
                patch.weights.push_back(random.of_any_size(1 / kind.most_weight, kind.most_weight));
        }
    if (kind.has_pole)
        for (int column = 1; column <= patch.degree_u; ++column)
            patch.points[static_cast<std::size_t>(column)] = patch.points[0];

    test_case result;
    result.group = kind.name;
    result.name = "curved seed " + std::to_string(seed);
    result.eye = in.eye;
    patch = plain_part_of(std::move(patch), 1 + random.below(4), random);
    const auto& [x, y, z] = patch.points[patch.points.size() / 2];
    result.eye.target = {x, y, z};
    result.curved.push_back(std::move(patch));
    result.size = in.size;
    result.tolerance = random.of_any_size(0.02, 2);
    return result;
}

std::vector<seen_part> parts_of(const l3d_patch_model& model) {
    std::vector<seen_part> result;
    for (std::size_t i = 0; i < model.patches().size(); ++i) {
        const l3d_parameter_range at = model.range_in_piece(i);
        result.push_back({model.piece_of(i), at.u0, at.v0, at.u1 - at.u0, at.v1 - at.v0});
    }
    return result;
}

} // namespace stability
