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

/// In a slanted plane, so that no coordinate is the same for all.
l3d_polygon_mesh square(const std::vector<std::uint32_t>& corners) {
    l3d_polygon_mesh mesh;
    mesh.vertices = {{0, 0, 0}, {2, 0, 2}, {2, 2, 4}, {0, 2, 2}};
    mesh.add_face(corners);
    mesh.face_colors = {0xff0000};
    mesh.parts = {{"a", 0}, {"none", 1}};
    return mesh;
}

TEST(polygon_mesh, a_bow_tie_becomes_two_triangles_that_look_the_same_way) {
    for (const std::vector<std::uint32_t>& corners :
         std::vector<std::vector<std::uint32_t>>{{0, 2, 1, 3}, {0, 1, 3, 2}, {2, 0, 3, 1}}) {
        l3d_polygon_mesh mesh = square(corners);
        mesh.vertex_normals.assign(4, {0, 0, 1});
        mesh.add_face(std::vector<std::uint32_t>{0, 1, 2, 3});
        mesh.face_colors.push_back(0x00ff00);
        mesh.parts = {{"a", 0}, {"b", 1}, {"none", 2}};
        mesh.uncross_faces();
        ASSERT_EQ(mesh.faces(), 3u);
        EXPECT_TRUE(mesh.is_valid());
        EXPECT_EQ(mesh.vertices.at(4), vector(1, 1, 2));
        EXPECT_EQ(mesh.vertex_normals.at(4), vector(0, 0, 1));
        EXPECT_EQ(mesh.face_colors, (std::vector<std::uint32_t>{0xff0000, 0xff0000, 0x00ff00}));
        EXPECT_EQ(mesh.parts, (std::vector<l3d_part_run>{{"a", 0}, {"b", 2}, {"none", 3}}));
        const vector one = mesh.area_vector(mesh.face(0)), other = mesh.area_vector(mesh.face(1));
        EXPECT_NEAR(l3d_dot(one, other), 12, 1e-12) << "twice a quarter of the square";
    }
}

TEST(polygon_mesh, faces_that_do_not_cross_themselves_stay) {
    for (const std::vector<std::uint32_t>& corners : std::vector<std::vector<std::uint32_t>>{
             {0, 1, 2, 3}, {3, 2, 1, 0}, {0, 1, 1, 2}, {0, 1, 0, 1}, {0, 1, 2}}) {
        l3d_polygon_mesh mesh = square(corners);
        const l3d_polygon_mesh before = mesh;
        mesh.uncross_faces();
        EXPECT_EQ(mesh, before);
    }
    l3d_polygon_mesh twisted = square({0, 2, 1, 3});
    twisted.vertices[2] = {2, 2, 8}; // the sides pass each other
    const l3d_polygon_mesh before = twisted;
    twisted.uncross_faces();
    EXPECT_EQ(twisted, before);
    l3d_polygon_mesh concave = square({0, 1, 2, 3});
    concave.vertices[2] = {0.5, 0.5, 1};
    concave.uncross_faces();
    EXPECT_EQ(concave.faces(), 1u);
}

TEST(polygon_mesh, normals_are_kept_when_a_mesh_without_any_is_appended) {
    l3d_polygon_mesh all = square({0, 1, 2, 3}), plain = all;
    all.vertex_normals.assign(4, {0, 0, 1});
    const l3d_polygon_mesh with = all;
    all.append(plain);
    EXPECT_TRUE(all.is_valid());
    EXPECT_EQ(all.vertex_normals.at(3), vector(0, 0, 1));
    EXPECT_EQ(all.vertex_normals.at(4), vector(0)) << "to be computed";
    plain.append(with);
    EXPECT_TRUE(plain.is_valid());
    EXPECT_EQ(plain.vertex_normals.at(0), vector(0));
    EXPECT_EQ(plain.vertex_normals.at(7), vector(0, 0, 1));
    plain.vertex_normals.clear();
    plain.append(square({0, 1, 2, 3}));
    EXPECT_TRUE(plain.vertex_normals.empty());
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
