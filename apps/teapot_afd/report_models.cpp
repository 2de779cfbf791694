// SPDX-License-Identifier: MIT
// Makes models of bicubic patches that approximate surfaces given as functions of two parameters.
#include "report_models.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace {

using std::numbers::pi;
using vector = l3d_patch_model::vector;
using surface = std::function<vector(double u, double v)>;

/// The part of a surface between two places of both parameters.
struct part {
    double u0, u1, v0, v1;
};

/// The bicubic patch with the part's corners, slopes and twists. Neighbours agree in these along
/// their common side. So they share the side bit for bit, and its tangent planes.
l3d_patch_model::patch patch_of(const surface& s, const part& of) {
    constexpr double step = 1e-4;
    const auto along_u = [&](double u, double v) {
        return (s(u + step, v) - s(u - step, v)) / (2 * step);
    };
    const auto along_v = [&](double u, double v) {
        return (s(u, v + step) - s(u, v - step)) / (2 * step);
    };
    const auto twist = [&](double u, double v) {
        return (along_u(u, v + step) - along_u(u, v - step)) / (2 * step);
    };
    const double third_u = (of.u1 - of.u0) / 3, third_v = (of.v1 - of.v0) / 3;
    l3d_patch_model::patch result;
    for (const int at_v : {0, 1})
        for (const int at_u : {0, 1}) {
            const double u = at_u ? of.u1 : of.u0, v = at_v ? of.v1 : of.v0;
            const vector corner = s(u, v);
            const vector du = along_u(u, v) * (at_u ? -third_u : third_u);
            const vector dv = along_v(u, v) * (at_v ? -third_v : third_v);
            const double both = third_u * third_v * (at_u == at_v ? 1 : -1);
            const auto point = [&](int row, int column) -> vector& {
                return result.points[static_cast<std::size_t>(4 * row + column)];
            };
            const int row = 3 * at_v, column = 3 * at_u;
            const int inner_row = 1 + at_v, inner_column = 1 + at_u;
            point(row, column) = corner;
            point(row, inner_column) = corner + du;
            point(inner_row, column) = corner + dv;
            point(inner_row, inner_column) = corner + du + dv + twist(u, v) * both;
        }
    return result;
}

/// Patches of a surface over parameters from 0 to 1, cut into along_u by along_v parts.
std::vector<l3d_patch_model::patch> patches_of(const surface& s, int along_u, int along_v) {
    std::vector<l3d_patch_model::patch> result;
    for (int j = 0; j < along_v; ++j)
        for (int i = 0; i < along_u; ++i)
            result.push_back(patch_of(s, {double(i) / along_u, double(i + 1) / along_u,
                                          double(j) / along_v, double(j + 1) / along_v}));
    return result;
}

/// Twelve patches, thirty times as long as wide, twisted five half turns.
l3d_patch_model band() {
    return l3d_patch_model(patches_of(
        [](double u, double v) {
            const double a = 2 * pi * u, turn = 5 * pi * u, wide = 0.2 * (v - 0.5);
            const double r = 1 + wide * std::cos(turn);
            return vector{r * std::cos(a), wide * std::sin(turn) + 0.25 * std::sin(2 * a),
                          r * std::sin(a)};
        },
        12, 1));
}

/// A pleated lampshade: 48 patches, a crease at each of the 16 sides between pleats.
l3d_patch_model lampshade() {
    constexpr int pleats = 16, storeys = 3;
    std::vector<l3d_patch_model::patch> result;
    for (int i = 0; i < pleats; ++i) {
        // The radius grows and shrinks by turns. It is linear within a pleat, and bends from pleat
        // to pleat.
        const double from = i % 2 ? 1 : 0.82, to = i % 2 ? 0.82 : 1;
        const auto pleat = [=](double u, double v) {
            const double a = 2 * pi * (i + u) / pleats;
            const double r = (from + (to - from) * u) * (0.55 + 0.45 * std::cos(1.9 * v));
            return vector{r * std::cos(a), 1.5 * v - 0.75, r * std::sin(a)};
        };
        for (const auto& patch : patches_of(pleat, 1, storeys))
            result.push_back(patch);
    }
    return l3d_patch_model(std::move(result));
}

/// A trefoil of 96 x 4 patches.
l3d_patch_model knot() {
    return l3d_patch_model(patches_of(
        [](double u, double v) {
            const double a = 2 * pi * u, b = 2 * pi * v;
            const auto centre = [](double t) {
                return vector{std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t),
                              -std::sin(3 * t)};
            };
            const vector here = centre(a), ahead = centre(a + 1e-3) - centre(a - 1e-3);
            // Two directions across the knot's curve: away from the knot's middle as far as
            // possible, and perpendicular to that.
            const vector forward = ahead / l3d_length(ahead);
            const vector outward = here - forward * l3d_dot(here, forward);
            const vector side = outward / l3d_length(outward);
            const vector third = l3d_cross(forward, side);
            return here * 0.4 + (side * std::cos(b) + third * std::sin(b)) * 0.17;
        },
        96, 4));
}

/// Hills of n x n patches in a square of 2 units.
l3d_patch_model hills(int n) {
    return l3d_patch_model(patches_of(
        [](double u, double v) {
            const double x = 2 * u - 1, z = 1 - 2 * v;
            const double height = 0.06 * std::sin(9 * x + 2 * z) * std::cos(7 * z - x) +
                                  0.03 * std::sin(23 * x - 5 * z) * std::sin(19 * z);
            return vector{x, height, z};
        },
        n, n));
}

/// A curtain of 3 x 2 patches that folds over itself. Seen from the front, each wave hides a part
/// of its neighbour, and folds begin in cusps where the waves rise.
l3d_patch_model folds() {
    return l3d_patch_model(patches_of(
        [](double u, double v) {
            const double wave = 3 * pi * u + 0.6 * v, rise = std::sin(0.5 * pi * v);
            return vector{2 * u - 1 + 0.42 * rise * std::sin(2 * wave),
                          0.8 - 1.6 * v + 0.08 * std::cos(wave), 0.3 * rise * std::cos(2 * wave)};
        },
        3, 2));
}

l3d_camera camera_at(const vector& eye, const vector& target, double fov) {
    return {eye, target, {0.0, 1.0, 0.0}, fov, 0.01, 1e13};
}

std::vector<report_view> three_views(const l3d_camera& full, const l3d_camera& closeup,
                                     const l3d_camera& top) {
    return {{"full", full}, {"closeup", closeup}, {"top", top}};
}

} // namespace

std::vector<report_model> report_models() {
    std::vector<report_model> result;
    const l3d_camera far{{3.2, 3.6, 7.4}, {0.2, 1.3, 0.0}, {0.0, 1.0, 0.0}, 38, 0.1, 1e13};
    const l3d_camera near{{1.2, 2.6, 4.4}, {-0.3, 1.5, 0.0}, {0.0, 1.0, 0.0}, 45, 0.1, 1e13};
    const l3d_camera above{{1.5, 7.5, 3.0}, {0.2, 1.2, 0.0}, {0.0, 1.0, 0.0}, 35, 0.1, 1e13};
    result.push_back({"teapot", l3d_patch_model::teapot(), three_views(far, near, above)});
    result.push_back({"band", band(),
                      three_views(camera_at({1.1, 1.6, 2.9}, {0.0, 0.0, 0.0}, 38),
                                  camera_at({1.3, 0.5, 1.5}, {0.5, 0.0, 0.5}, 40),
                                  camera_at({0.3, 3.2, 0.9}, {0.0, 0.0, 0.0}, 40))});
    result.push_back({"lampshade", lampshade(),
                      three_views(camera_at({1.3, 1.0, 2.9}, {0.0, 0.0, 0.0}, 36),
                                  camera_at({0.7, 0.3, 1.6}, {0.1, 0.05, 0.0}, 42),
                                  camera_at({0.4, 3.0, 0.9}, {0.0, 0.0, 0.0}, 36))});
    result.push_back({"knot", knot(),
                      three_views(camera_at({1.0, 1.2, 4.1}, {0.0, 0.0, 0.0}, 38),
                                  camera_at({0.8, 0.6, 2.3}, {0.2, 0.1, 0.0}, 42),
                                  camera_at({0.5, 4.0, 1.0}, {0.0, 0.0, 0.0}, 38))});
    result.push_back({"hills", hills(48),
                      three_views(camera_at({0.13, 0.35, 1.5}, {0.0, -0.05, 0.0}, 42),
                                  camera_at({0.11, 0.16, 0.95}, {0.0, 0.0, 0.0}, 50),
                                  camera_at({0.2, 2.3, 0.9}, {0.0, 0.0, 0.0}, 48))});
    return result;
}

std::vector<report_model> report_scenes() {
    std::vector<report_model> result;
    for (const int n : {2, 4, 8, 16, 32, 64})
        result.push_back({"hills of " + std::to_string(n * n),
                          hills(n),
                          {{"full", camera_at({0.13, 0.35, 1.5}, {0.0, -0.05, 0.0}, 42)}}});
    return result;
}

report_model report_folds() {
    return {"folds", folds(),
            three_views(camera_at({0.2, 0.3, 3.1}, {0.05, 0.0, 0.0}, 45),
                        camera_at({0.5, -0.3, 1.7}, {0.2, -0.2, 0.0}, 42),
                        camera_at({0.3, 2.6, 2.0}, {0.0, 0.0, 0.0}, 36))};
}
