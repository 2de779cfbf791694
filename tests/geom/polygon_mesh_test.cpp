// SPDX-License-Identifier: MIT
// l3d_polygon_mesh and the generated shapes: counts, winding, closedness, and what is not valid.
#include "geom/polygon_shapes.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <map>
#include <utility>

namespace {

using vector = l3d_polygon_mesh::vector;

/// Six times the signed volume; positive if faces are counterclockwise from outside.
double volume6(const l3d_polygon_mesh& mesh) {
    double sum = 0;
    for (std::size_t f = 0; f < mesh.faces(); ++f) {
        const auto face = mesh.face(f);
        for (std::size_t i = 2; i < face.size(); ++i)
            sum += l3d_dot(mesh.vertices[face[0]],
                           l3d_cross(mesh.vertices[face[i - 1]], mesh.vertices[face[i]]));
    }
    return sum;
}

/// Whether each side is met once in each direction.
bool closed(const l3d_polygon_mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (std::size_t f = 0; f < mesh.faces(); ++f) {
        const auto face = mesh.face(f);
        for (std::size_t i = 0; i < face.size(); ++i)
            ++sides[{face[i], face[(i + 1) % face.size()]}];
    }
    for (const auto& [side, count] : sides)
        if (count != 1 || !sides.contains({side.second, side.first}))
            return false;
    return true;
}

TEST(polygon_mesh, a_torus_is_closed_and_faces_outwards) {
    const l3d_polygon_mesh torus = l3d_torus_mesh(12, 8);
    EXPECT_EQ(torus.faces(), 192u);
    EXPECT_TRUE(torus.is_valid());
    EXPECT_TRUE(closed(torus));
    EXPECT_GT(volume6(torus), 0);
    EXPECT_EQ(torus.bytes(), 28u * 192u);
}

TEST(polygon_mesh, a_sphere_is_closed_and_faces_outwards) {
    const l3d_polygon_mesh sphere = l3d_sphere_mesh(7, 5, 1.5);
    EXPECT_EQ(sphere.faces(), 2u * 7u * 4u);
    EXPECT_TRUE(sphere.is_valid());
    EXPECT_TRUE(closed(sphere));
    EXPECT_GT(volume6(sphere), 0);
}

TEST(polygon_mesh, a_grid_follows_its_height) {
    const l3d_polygon_mesh grid = l3d_grid_mesh(3, [](double x, double y) { return x - 2 * y; });
    EXPECT_EQ(grid.faces(), 18u);
    EXPECT_TRUE(grid.is_valid());
    for (const vector& v : grid.vertices)
        EXPECT_EQ(v[2], v[0] - 2 * v[1]);
}

TEST(polygon_mesh, numbers_beyond_32_bits_are_refused) {
    EXPECT_EQ(l3d_polygon_mesh::index_of(4294967295), 4294967295u);
    EXPECT_THROW(l3d_polygon_mesh::index_of(4294967296), std::length_error);
}

TEST(polygon_mesh, what_is_wrong_is_seen) {
    const l3d_polygon_mesh good = l3d_torus_mesh(3, 4);
    auto bad = good;
    bad.corners[5] = 12;
    EXPECT_FALSE(bad.is_valid());
    bad = good;
    bad.face_ends[2] = bad.face_ends[1] + 2;
    EXPECT_FALSE(bad.is_valid());
    bad = good;
    bad.corners.push_back(0);
    EXPECT_FALSE(bad.is_valid());
    bad = good;
    bad.vertices[7][1] = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(bad.is_valid());
    bad = good;
    bad.face_colors.resize(3);
    EXPECT_FALSE(bad.is_valid());
    bad = good;
    bad.face_materials.assign(good.faces(), 0);
    EXPECT_FALSE(bad.is_valid());
    bad.materials.emplace_back("red");
    EXPECT_TRUE(bad.is_valid());
    bad.parts = {{"b", 4}, {"a", 3}};
    EXPECT_FALSE(bad.is_valid());
}

} // namespace
