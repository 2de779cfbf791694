// SPDX-License-Identifier: MIT
// l3d_cut_mesh: the row "Splitting objects" of the book's table; and import.
#include "geom/polygon_mesh.h"

#include "geom/files/model_file.h"
#include "geom/polygon_3d.h"
#include "geom/polygon_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>

namespace {

using plane = l3d_plane<double>;
using point = l3d_point<double>;

/// The book's pyramid with a colour for each face.
l3d_polygon_mesh pyramid() {
    l3d_polygon_mesh mesh = l3d_pyramid_mesh();
    mesh.face_colors = {0x10, 0x20, 0x30, 0x40};
    return mesh;
}

/// x + y + z = 3, the front towards the origin.
plane of_objcopy() {
    return plane::through(point(1, 1, 1), {-1, -1, -1});
}

std::map<std::size_t, int> sizes_of_faces(const l3d_polygon_mesh& mesh) {
    std::map<std::size_t, int> sizes;
    for (std::size_t i = 0; i < mesh.faces(); ++i)
        ++sizes[mesh.face(i).size()];
    return sizes;
}

/// Every edge once in each direction: no hole, no crack.
bool is_closed(const l3d_polygon_mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t i = 0; i < mesh.faces(); ++i) {
        const auto face = mesh.face(i);
        for (std::size_t k = 0; k < face.size(); ++k)
            ++edges[{face[k], face[(k + 1) % face.size()]}];
    }
    for (const auto& [ends, count] : edges)
        if (count != 1 || edges.count({ends.second, ends.first}) != 1)
            return false;
    return true;
}

double volume(const l3d_polygon_mesh& mesh) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.faces(); ++i) {
        const auto face = mesh.face(i);
        for (std::size_t k = 2; k < face.size(); ++k)
            sum += l3d_dot(mesh.vertices[face[0]],
                           l3d_cross(mesh.vertices[face[k - 1]], mesh.vertices[face[k]]));
    }
    return sum / 6;
}

TEST(book_mesh_cut, splitting_objects) {
    const auto mesh = pyramid();
    const auto tip = l3d_cut_mesh(mesh, of_objcopy());
    const auto rest = l3d_cut_mesh(mesh, of_objcopy().flipped());
    EXPECT_TRUE(tip.is_valid());
    EXPECT_TRUE(rest.is_valid());
    EXPECT_EQ(sizes_of_faces(tip), (std::map<std::size_t, int>{{3, 3}}));
    EXPECT_EQ(sizes_of_faces(rest), (std::map<std::size_t, int>{{3, 1}, {4, 3}}));
    EXPECT_EQ(tip.vertices.size(), 4u);  // welded: the book's has 7
    EXPECT_EQ(rest.vertices.size(), 6u); // the book's 9
    EXPECT_NEAR(l3d_area(tip) + l3d_area(rest), l3d_area(mesh), 1e-6);
    EXPECT_EQ(tip.face_colors, (std::vector<std::uint32_t>{0x10, 0x30, 0x40}));
    EXPECT_EQ(rest.face_colors, mesh.face_colors);
    EXPECT_FALSE(is_closed(tip));
    for (const auto& v : tip.vertices)
        EXPECT_LT(v[0] + v[1] + v[2], 3 + 1e-9);
}

TEST(book_mesh_cut, caps_close_both_parts) {
    const auto mesh = pyramid();
    const auto tip = l3d_cut_mesh(mesh, of_objcopy(), l3d_cut_end::capped);
    const auto rest = l3d_cut_mesh(mesh, of_objcopy().flipped(), l3d_cut_end::capped);
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_TRUE(is_closed(tip));
    EXPECT_TRUE(is_closed(rest));
    EXPECT_EQ(tip.faces(), 4u);
    EXPECT_EQ(rest.faces(), 5u);
    EXPECT_NEAR(volume(mesh), 1000 / 6., 1e-9);
    EXPECT_NEAR(volume(tip), 27 / 6., 1e-9);
    EXPECT_NEAR(volume(rest), (1000 - 27) / 6., 1e-9);
    EXPECT_EQ(tip.face_colors.size(), 4u);
}

TEST(book_mesh_cut, beside_the_mesh_nothing_changes) {
    auto mesh = pyramid();
    mesh.parts = {{"base", 0}, {"sides", 2}};
    mesh.vertex_normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    mesh.face_materials = {0, 0, 1, 1};
    mesh.materials = {"sand", "stone"};
    const auto far = plane::through(point(20, 20, 20), {-1, -1, -1});
    EXPECT_EQ(l3d_cut_mesh(mesh, far, l3d_cut_end::capped), mesh);
    EXPECT_EQ(l3d_cut_mesh(mesh, far.flipped()).faces(), 0u);
    EXPECT_TRUE(l3d_cut_mesh(mesh, of_objcopy(), l3d_cut_end::capped).is_valid());
    EXPECT_TRUE(l3d_cut_mesh(mesh, of_objcopy().flipped(), l3d_cut_end::capped).is_valid());
    // A face on the plane belongs to the part in which the solid is; no cap is needed there.
    const auto base = plane::through(point(3, 4, 0), {0, 0, 1});
    EXPECT_EQ(l3d_cut_mesh(mesh, base, l3d_cut_end::capped), mesh);
    EXPECT_EQ(l3d_cut_mesh(mesh, base.flipped(), l3d_cut_end::capped).faces(), 0u);
}

/// Random planes through a sphere and a torus: the parts have the volume together, are closed, and
/// each keeps to its side.
TEST(book_mesh_cut, random_cuts_of_closed_meshes) {
    std::mt19937 random(31);
    const auto uniform = [&random] { return static_cast<double>(random()) / 0x1p31 - 1; };
    const auto sphere = l3d_sphere_mesh(13, 9, 2.5);
    for (int i = 0; i < 300; ++i) {
        const auto cut = plane::through(point(uniform(), uniform(), 2 * uniform()),
                                        {uniform(), uniform(), 1.25 + uniform()});
        const auto front = l3d_cut_mesh(sphere, cut, l3d_cut_end::capped);
        const auto behind = l3d_cut_mesh(sphere, cut.flipped(), l3d_cut_end::capped);
        ASSERT_TRUE(is_closed(front) && is_closed(behind)) << "case " << i;
        ASSERT_NEAR(volume(front) + volume(behind), volume(sphere), 0.01) << "case " << i;
        for (const auto& v : front.vertices)
            ASSERT_GT(cut.side_of_point(point(v)), -l3d_plane_thickness - 1e-9);
    }
    // Two loops, one cap each.
    const auto torus = l3d_torus_mesh(24, 12);
    const auto across = plane::through(point(0.013, 0, 0), {1, 0.1, 0.05});
    const auto half = l3d_cut_mesh(torus, across, l3d_cut_end::capped);
    const auto open = l3d_cut_mesh(torus, across);
    EXPECT_EQ(half.faces(), open.faces() + 2);
    EXPECT_TRUE(is_closed(half));
}

/// Row "Videoscape import": a cube of z up and counterclockwise faces, as Blender writes it.
TEST(book_mesh_cut, videoscape_import) {
    const std::string text = "3DG1\n8\n1 2 3\n5 2 3\n5 6 3\n1 6 3\n1 2 7\n5 2 7\n5 6 7\n1 6 7\n"
                             "4 3 2 1 0 0x0000ff\n4 4 5 6 7 0x00ff00\n4 0 1 5 4 0xff0000\n"
                             "4 1 2 6 5 0x123456\n4 2 3 7 6 0xff\n4 3 0 4 7 0xff\n";
    std::string why;
    auto model = l3d_read_videoscape(text, "cube.obj", why);
    ASSERT_TRUE(model.has_value()) << why;
    l3d_polygon_mesh& mesh = model->mesh;
    EXPECT_NEAR(volume(mesh), 64, 1e-9); // right-handed: (p1 - p0) x (p2 - p0) is outward
    l3d_turn_left_handed(mesh);
    EXPECT_EQ(mesh.vertices[4], (l3d_vector<double, 3>(1, 7, 2))); // what was up is up
    EXPECT_EQ(mesh.face_colors[0], 0xff0000u);                     // blue is on top in the file
    EXPECT_EQ(mesh.face_colors[3], 0x563412u);
    std::vector<point> points;
    for (const auto& v : mesh.vertices)
        points.push_back(point(v));
    const point centre(3, 5, 4);
    for (std::size_t i = 0; i < mesh.faces(); ++i) {
        const l3d_polygon_3d<double> face{points, mesh.face(i)};
        EXPECT_NEAR(face.plane()->side_of_point(centre), -2, 1e-12);
    }
    // Cut in the middle of the first face: 7 + 8 * 6 bytes before it.
    EXPECT_FALSE(l3d_read_videoscape(text.substr(0, 59), "cube.obj", why).has_value());
    EXPECT_EQ(why.substr(0, 12), "cube.obj:11:");
}

/// Bodies are closed and their normals point outwards, before and after they become left-handed.
TEST(polygon_shapes, are_closed_bodies_of_their_volume) {
    const double pi = std::numbers::pi;
    // A regular polygon of n corners on a circle has n/2 sin(2 pi / n) of its square.
    const double ring = 10 * std::sin(pi / 10);
    struct body {
        const char* name;
        l3d_polygon_mesh mesh;
        double volume;
        std::size_t faces;
    };
    for (const body& b : {body{"box", l3d_box_mesh(2, 3, 5), 30, 6},
                          {"cylinder", l3d_cylinder_mesh(20, 2, 3), 12 * ring, 22},
                          {"cone", l3d_cone_mesh(20, 2, 3), 4 * ring, 21},
                          {"cone of three sides", l3d_cone_mesh(3), std::sqrt(3.0) / 2, 4},
                          {"sphere", l3d_sphere_mesh(256, 128), 4 * pi / 3, 2 * 256 * 127}}) {
        EXPECT_TRUE(is_closed(b.mesh)) << b.name;
        EXPECT_NEAR(volume(b.mesh), b.volume, 1e-3 * b.volume) << b.name;
        EXPECT_EQ(b.mesh.faces(), b.faces) << b.name;
        EXPECT_TRUE(b.mesh.is_valid()) << b.name;
        for (const auto up : {l3d_model_up::y, l3d_model_up::z}) {
            auto turned = b.mesh;
            l3d_turn_left_handed(turned, up);
            EXPECT_NEAR(volume(turned), b.volume, 1e-3 * b.volume) << b.name;
        }
    }
}

/// A flat L that is seen upright from the front stays an L, not a mirrored one: its foot points to
/// the right of one who looks at its front, before and after.
TEST(polygon_shapes, an_l_is_not_mirrored) {
    l3d_polygon_mesh mesh;
    mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
    mesh.add_face({{0, 1, 2, 3, 4, 5}}); // the front is towards z, where a right-handed viewer is
    l3d_turn_left_handed(mesh, l3d_model_up::y);
    // A left-handed viewer who sees the front stands at -z and looks along z: x is on his right.
    const auto& v = mesh.vertices;
    const auto face = mesh.face(0);
    const auto normal = l3d_cross(v[face[1]] - v[face[0]], v[face[2]] - v[face[0]]);
    EXPECT_LT(normal[2], 0);
    EXPECT_EQ(v[1], (l3d_polygon_mesh::vector(2, 0, 0)));
    EXPECT_EQ(v[5], (l3d_polygon_mesh::vector(0, 3, 0)));
}

} // namespace
