// SPDX-License-Identifier: MIT
// Creases of polygon models: which faces share a normal at a vertex.
#include "geom/polygon_shapes.h"
#include "geom/random.h"
#include "pipeline/polygons/polygon_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

using vector = l3d_polygon_model::vector;
using direction = l3d_polygon_model::direction;

l3d_polygon_mesh cube() {
    l3d_polygon_mesh mesh;
    for (unsigned i = 0; i < 8; ++i)
        mesh.vertices.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
    for (const std::array<std::uint32_t, 4>& face : std::vector<std::array<std::uint32_t, 4>>{
             {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
        mesh.add_face(face);
    return mesh;
}

/// A round body with flat ends: so many sides, an end of one face each.
l3d_polygon_mesh prism(std::uint32_t sides) {
    l3d_polygon_mesh mesh;
    std::vector<std::uint32_t> bottom, top;
    for (std::uint32_t i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        for (const double z : {-1.0, 1.0})
            mesh.vertices.push_back({std::cos(angle), std::sin(angle), z});
        const std::uint32_t next = (i + 1) % sides;
        mesh.add_face(std::array{2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
        bottom.insert(bottom.begin(), 2 * i);
        top.push_back(2 * i + 1);
    }
    mesh.add_face(bottom);
    mesh.add_face(top);
    return mesh;
}

double between(const direction& a, const vector& b) {
    return l3d_dot(l3d_converted<double>(a), b);
}

TEST(crease_normals, a_cube_has_the_normal_of_each_face_in_its_corners) {
    const l3d_polygon_model model(cube());
    EXPECT_TRUE(model.has_creases());
    for (std::size_t t = 0; t < model.triangles().size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(model.corner_normal(t, k), model.face_normals()[model.triangles()[t].face]);
}

TEST(crease_normals, an_angle_of_180_degrees_makes_no_crease) {
    const l3d_polygon_model model(cube(), false, 180);
    EXPECT_FALSE(model.has_creases());
    for (std::size_t t = 0; t < model.triangles().size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(model.corner_normal(t, k),
                      model.vertex_normals()[model.triangles()[t].corners[k]]);
}

TEST(crease_normals, a_prism_of_twelve_sides_is_round_and_has_flat_ends) {
    for (const std::uint32_t sides : {11U, 12U, 24U}) {
        const l3d_polygon_model model(prism(sides));
        for (std::size_t t = 0; t < model.triangles().size(); ++t) {
            const l3d_model_triangle& triangle = model.triangles()[t];
            for (std::size_t k = 0; k < 3; ++k) {
                vector place = model.mesh().vertices[triangle.corners[k]];
                const bool is_end = triangle.face >= sides;
                const vector round = vector{place[0], place[1], 0.0};
                const vector expected = is_end ? vector{0.0, 0.0, place[2]} : round;
                if (is_end || sides >= 12)
                    EXPECT_NEAR(between(model.corner_normal(t, k), expected), 1, 1e-6) << sides;
                else // half the angle between two sides away
                    EXPECT_NEAR(between(model.corner_normal(t, k), expected),
                                std::cos(std::numbers::pi / sides), 1e-6);
            }
        }
    }
}

TEST(crease_normals, normals_of_a_mesh_count_whatever_the_angle) {
    l3d_polygon_mesh mesh = cube();
    mesh.vertex_normals = mesh.vertices;
    EXPECT_FALSE(l3d_polygon_model(mesh, false, 0).has_creases());
}

/// The normal of a corner by going from face to face over smooth edges until nothing is added.
vector plain_normal(const l3d_polygon_model& model, std::uint32_t vertex, std::uint32_t from,
                    double crease_angle) {
    const l3d_polygon_mesh& mesh = model.mesh();
    const auto neighbours = [&](std::uint32_t f) {
        const auto face = mesh.face(f);
        const auto at = static_cast<std::size_t>(std::ranges::find(face, vertex) - face.begin());
        return std::array{face[(at + 1) % face.size()], face[(at + face.size() - 1) % face.size()]};
    };
    const auto has = [&](std::uint32_t f) {
        return std::ranges::find(mesh.face(f), vertex) != mesh.face(f).end();
    };
    const auto unit = [&](std::uint32_t f) {
        return l3d_converted<double>(model.face_normals()[f]);
    };
    std::vector<std::uint32_t> group{from};
    for (std::size_t i = 0; i < group.size(); ++i)
        for (std::uint32_t f = 0; f < mesh.faces(); ++f) {
            if (!has(f) || std::ranges::find(group, f) != group.end())
                continue;
            const auto a = neighbours(group[i]), b = neighbours(f);
            const bool shares = a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
            if (shares &&
                l3d_dot(unit(group[i]), unit(f)) >= std::cos(crease_angle * std::numbers::pi / 180))
                group.push_back(f);
        }
    vector sum{0.0, 0.0, 0.0};
    for (const std::uint32_t f : group) {
        const auto face = mesh.face(f);
        const vector& first = mesh.vertices[face[0]];
        for (std::size_t i = 2; i < face.size(); ++i)
            sum += l3d_cross(mesh.vertices[face[i - 1]] - first, mesh.vertices[face[i]] - first);
    }
    return l3d_normalized(sum);
}

/// Random bumps on a grid: edges of every angle. Two grids back to back hang together at borders.
TEST(crease_normals, are_those_of_a_plain_search_on_random_meshes) {
    l3d_random random(7);
    for (int round = 0; round < 20; ++round) {
        constexpr std::uint32_t n = 6;
        l3d_polygon_mesh mesh;
        for (std::uint32_t i = 0; i < n * n; ++i)
            mesh.vertices.push_back({double(i % n), double(i / n), random.fraction() - 0.5});
        for (std::uint32_t y = 0; y + 1 < n; ++y)
            for (std::uint32_t x = 0; x + 1 < n; ++x) {
                const std::uint32_t a = y * n + x;
                mesh.add_face(std::array{a, a + 1, a + n});
                mesh.add_face(std::array{a + 1, a + n + 1, a + n});
            }
        const double angle = 10.0 + 7 * round;
        const l3d_polygon_model model(mesh, false, angle);
        for (std::size_t t = 0; t < model.triangles().size(); ++t)
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_GT(between(model.corner_normal(t, k),
                                  plain_normal(model, model.triangles()[t].corners[k],
                                               model.triangles()[t].face, angle)),
                          1 - 1e-6)
                    << angle;
    }
}

} // namespace
