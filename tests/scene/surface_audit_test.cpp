// SPDX-License-Identifier: MIT
// l3d_surface_audit: against closed forms, and against samples of both sides.
#include "scene/audit/surface_audit.h"

#include "geom/nurbs_surface.h"
#include "geom/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace {

using vector = l3d_surface_audit::vector;
using triangles = std::vector<l3d_surface_audit::triangle>;

/// An octahedron halved some times, with its corners on the unit sphere.
triangles sphere_mesh(int halvings) {
    triangles result;
    for (int i = 0; i < 8; ++i)
        result.push_back({vector(i & 1 ? -1.0 : 1.0, 0.0, 0.0),
                          vector(0.0, i & 2 ? -1.0 : 1.0, 0.0),
                          vector(0.0, 0.0, i & 4 ? -1.0 : 1.0)});
    for (; halvings > 0; --halvings) {
        triangles finer;
        for (const auto& [a, b, c] : result) {
            const vector ab = l3d_normalized(a + b), bc = l3d_normalized(b + c),
                         ca = l3d_normalized(c + a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        result = std::move(finer);
    }
    return result;
}

/// The largest distance of these triangles' planes from the unit sphere, which both ways have.
double sagitta(const triangles& mesh) {
    double result = 0;
    for (const auto& [a, b, c] : mesh)
        result =
            std::max(result, 1 - std::abs(l3d_dot(a, l3d_normalized(l3d_cross(b - a, c - a)))));
    return result;
}

void expect_holds(const l3d_audited_way& way, double exact, double tolerance) {
    EXPECT_LE(way.least, exact);
    EXPECT_GE(way.most, exact);
    EXPECT_LE(way.most - way.least, tolerance);
}

TEST(surface_audit, finds_the_sagitta_of_a_sphere) {
    const l3d_patch_model sphere = l3d_patch_model::from_surfaces(l3d_sphere_surfaces());
    for (const int halvings : {0, 2}) {
        const triangles mesh = sphere_mesh(halvings);
        for (const double tolerance : {1e-2, 1e-4}) {
            const auto found = l3d_surface_audit(sphere, tolerance).compare(mesh);
            expect_holds(found.from_mesh, sagitta(mesh), tolerance);
            expect_holds(found.from_surface, sagitta(mesh), tolerance);
            EXPECT_NEAR(1 - l3d_length(found.from_mesh.place), sagitta(mesh), tolerance);
            EXPECT_NEAR(l3d_length(found.from_surface.place), 1, tolerance);
        }
    }
}

/// The square from -2 to 2 in the plane z = 0, with a hole of radius 1 in the middle.
l3d_patch_model plate_with_hole() {
    const l3d_nurbs_surface square(l3d_bspline_direction::clamped(1, 2),
                                   l3d_bspline_direction::clamped(1, 2),
                                   {{-2, -2, 0}, {2, -2, 0}, {-2, 2, 0}, {2, 2, 0}});
    const auto circle = l3d_nurbs_curve::circle(0.25);
    std::vector<vector> points = circle.points();
    for (vector& p : points)
        p += vector(0.5, 0.5, 0.0);
    const l3d_nurbs_curve hole(circle.along(), points, circle.weights());
    const auto border =
        l3d_nurbs_curve::polyline({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}});
    const std::array loops{l3d_trim_loop_of(std::array{border}, {}),
                           l3d_trim_loop_of(std::array{hole}, {})};
    return l3d_patch_model::from_surfaces(std::array{square.trimmed(loops)});
}

/// Two triangles that fill the square at this height.
triangles square_mesh(double z) {
    const vector a(-2.0, -2.0, z), b(2.0, -2.0, z), c(2.0, 2.0, z), d(-2.0, 2.0, z);
    return {{a, b, c}, {a, c, d}};
}

TEST(surface_audit, finds_a_hole_that_is_filled_and_one_that_is_missing) {
    constexpr double tolerance = 1e-4;
    const l3d_surface_audit audit(plate_with_hole(), tolerance);
    const auto filled = audit.compare(square_mesh(0));
    expect_holds(filled.from_mesh, 1, tolerance); // from the hole's middle to its rim
    EXPECT_LT(l3d_length(filled.from_mesh.place), 1e-2);
    expect_holds(filled.from_surface, 0, tolerance);
    // Half of the square is missing: its corner is the farthest from the diagonal.
    const triangles half{square_mesh(0)[0]};
    const auto missing = audit.compare(half);
    expect_holds(missing.from_surface, std::sqrt(8.0), tolerance);
    EXPECT_LT(l3d_length(missing.from_surface.place - vector(-2.0, 2.0, 0.0)), 1e-3);
}

/// The plate in fans of long thin triangles, as meshes of CAD programs have them: from each corner
/// to so many chords of a quarter of the hole.
triangles fans(int chords) {
    triangles result;
    const auto corner = [](int k) {
        return vector(k == 1 || k == 2 ? -2.0 : 2.0, k >= 2 ? -2.0 : 2.0, 0.0);
    };
    const auto on_rim = [&](int i) {
        const double angle = std::numbers::pi / 2 * i / chords;
        return vector(std::cos(angle), std::sin(angle), 0.0);
    };
    for (int k = 0; k < 4; ++k) {
        for (int i = k * chords; i < (k + 1) * chords; ++i)
            result.push_back({corner(k), on_rim(i + 1), on_rim(i)});
        result.push_back({corner(k), corner((k + 1) % 4), on_rim((k + 1) * chords)});
    }
    return result;
}

TEST(surface_audit, ends_for_crowds_of_long_thin_triangles) {
    constexpr double tolerance = 1e-3;
    constexpr int chords = 200;
    const auto found = l3d_surface_audit(plate_with_hole(), tolerance).compare(fans(chords));
    expect_holds(found.from_mesh, 1 - std::cos(std::numbers::pi / (4 * chords)), tolerance);
    expect_holds(found.from_surface, 0, tolerance);
}

TEST(surface_audit, finds_a_mesh_that_is_moved) {
    const l3d_surface_audit audit(plate_with_hole(), 1e-5);
    const auto moved = audit.compare(square_mesh(0.25));
    expect_holds(moved.from_mesh, std::hypot(1, 0.25), 1e-5);
    expect_holds(moved.from_surface, 0.25, 1e-5);
}

TEST(surface_audit, finds_the_one_triangle_with_a_corner_that_is_off) {
    const l3d_patch_model sphere = l3d_patch_model::from_surfaces(l3d_sphere_surfaces());
    triangles mesh = sphere_mesh(2);
    mesh[77][1] = mesh[77][1] * 1.5; // the triangle is torn off its neighbours
    const auto found = l3d_surface_audit(sphere, 1e-3).compare(mesh);
    expect_holds(found.from_mesh, 0.5, 1e-3);
    EXPECT_EQ(found.from_mesh.index, 77u);
    EXPECT_LT(l3d_length(found.from_mesh.place - mesh[77][1]), 1e-2);
}

TEST(surface_audit, finds_the_sagitta_of_a_cylinder) {
    constexpr int sides = 24;
    triangles mesh;
    const auto at = [](int i, double y) {
        const double angle = 2 * std::numbers::pi * i / sides;
        return vector(std::cos(angle), y, -std::sin(angle));
    };
    for (int i = 0; i < sides; ++i) {
        mesh.push_back({at(i, -1), at(i + 1, -1), at(i + 1, 1)});
        mesh.push_back({at(i, -1), at(i + 1, 1), at(i, 1)});
        for (const double y : {-1.0, 1.0})
            mesh.push_back({vector(0.0, y, 0.0), at(i, y), at(i + 1, y)});
    }
    const l3d_patch_model cylinder = l3d_patch_model::from_surfaces(l3d_cylinder_surfaces());
    constexpr double tolerance = 1e-3;
    const auto found = l3d_surface_audit(cylinder, tolerance).compare(mesh);
    const double sagitta = 1 - std::cos(std::numbers::pi / sides);
    expect_holds(found.from_mesh, sagitta, tolerance);
    expect_holds(found.from_surface, sagitta, tolerance);
}

TEST(surface_audit, finds_meshes_of_another_size) {
    const l3d_patch_model sphere = l3d_patch_model::from_surfaces(l3d_sphere_surfaces());
    for (const double size : {1000.0, 1.01}) {
        triangles mesh = sphere_mesh(1);
        const double inside = 1 - size * (1 - sagitta(mesh));
        for (auto& triangle : mesh)
            for (vector& corner : triangle)
                corner *= size;
        const double tolerance = 1e-3 * size;
        const auto found = l3d_surface_audit(sphere, tolerance).compare(mesh);
        expect_holds(found.from_mesh, std::max(size - 1, inside), tolerance);
    }
}

/// The least distance of a place to many others.
double least_distance(const vector& from, const std::vector<vector>& to) {
    double result = std::numeric_limits<double>::infinity();
    for (const vector& p : to)
        result = std::min(result, l3d_length(p - from));
    return result;
}

/// The slow twin: dense samples of both sides, whose distances err by their spacing.
TEST(surface_audit, agrees_with_samples_of_the_teapot) {
    const l3d_patch_model teapot = l3d_patch_model::teapot();
    constexpr int facets = 3, fine = 24;
    triangles mesh;
    std::vector<vector> on_surface, on_mesh;
    double spacing = 0; // of samples
    for (const auto& patch : teapot.patches()) {
        const auto at = [&](int i, int k) {
            return patch.evaluate(double(i) / facets, double(k) / facets);
        };
        for (int i = 0; i < facets; ++i)
            for (int k = 0; k < facets; ++k) {
                mesh.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
                mesh.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
            }
        for (int i = 0; i <= fine; ++i)
            for (int k = 0; k <= fine; ++k) {
                on_surface.push_back(patch.evaluate(double(i) / fine, double(k) / fine));
                if (i > 0 && k > 0)
                    spacing =
                        std::max(spacing, l3d_length(on_surface.back() -
                                                     on_surface[on_surface.size() - fine - 3]));
            }
    }
    constexpr int parts = 8;
    for (const auto& [a, b, c] : mesh)
        for (int i = 0; i <= parts; ++i)
            for (int k = 0; k + i <= parts; ++k)
                on_mesh.push_back(a + (b - a) * (double(i) / parts) +
                                  (c - a) * (double(k) / parts));
    constexpr double tolerance = 1e-4;
    const l3d_surface_audit audit(teapot, tolerance);
    const auto found = audit.compare(mesh);
    EXPECT_LE(found.from_mesh.most - found.from_mesh.least, tolerance);
    EXPECT_LE(found.from_surface.most - found.from_surface.least, tolerance);
    const auto largest = [](const std::vector<vector>& from, const std::vector<vector>& to,
                            std::size_t step) {
        double result = 0;
        for (std::size_t i = 0; i < from.size(); i += step)
            result = std::max(result, least_distance(from[i], to));
        return result;
    };
    constexpr std::size_t step = 7; // of the places that are measured from
    EXPECT_LE(largest(on_mesh, on_surface, step), found.from_mesh.most + spacing);
    EXPECT_LE(largest(on_surface, on_mesh, step), found.from_surface.most + spacing);
    EXPECT_GE(least_distance(found.from_mesh.place, on_surface), found.from_mesh.least);
    EXPECT_GE(least_distance(found.from_surface.place, on_mesh), found.from_surface.least);
    for (std::size_t i = 0; i < on_mesh.size(); i += 997) {
        const auto [least, most] = audit.distance(on_mesh[i]);
        const double sampled = least_distance(on_mesh[i], on_surface);
        EXPECT_LE(least, sampled);
        EXPECT_GE(most + spacing, sampled);
    }
}

} // namespace
