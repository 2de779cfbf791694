// SPDX-License-Identifier: MIT
// Normals of corners and smoothing groups become normals of vertices; and normals that are none.
#include "geom/files/model_file.h"

#include "model_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace {

using vector = l3d_polygon_mesh::vector;
using numbers = std::vector<std::uint32_t>;
using texts = std::vector<std::string>;

l3d_model_file read(std::string_view text) {
    return model_text::read_by(l3d_read_model, text, "name");
}

constexpr const char* odd_note = "normals that are zero or no numbers are computed from the faces";

/// Two squares that meet at a right angle, in the side from vertex 2 to vertex 3.
constexpr std::string_view corner = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 1\nv 1 1 1\n"
                                    "vn 0 0 1\nvn -1 0 0\n";

l3d_polygon_mesh corner_with(std::string_view faces) {
    return read(std::string(corner).append(faces)).mesh;
}

/// The normal that a face has at one of its corners.
vector normal_at(const l3d_polygon_mesh& mesh, std::size_t face, std::size_t k) {
    return mesh.vertex_normals.at(mesh.face(face)[k]);
}

TEST(corner_normals, of_a_vertex_that_has_several_make_several_vertices) {
    const l3d_polygon_mesh mesh =
        corner_with("f 1//1 2//1 3//1 4//1\nf 2//2 5//2 6//2 3//2\nf 4//1 3//1 2//1\n");
    EXPECT_EQ(mesh.vertices.size(), 8u);
    EXPECT_EQ(mesh.corners, (numbers{0, 1, 2, 3, 6, 4, 5, 7, 3, 2, 1}));
    EXPECT_EQ(mesh.vertices[6], mesh.vertices[1]);
    EXPECT_EQ(mesh.vertices[7], mesh.vertices[2]);
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(normal_at(mesh, 0, k), vector(0, 0, 1));
        EXPECT_EQ(normal_at(mesh, 1, k), vector(-1, 0, 0));
    }
    std::string why;
    const auto again = l3d_read_obj(l3d_write_obj({mesh, {}, {}}), "again", why);
    ASSERT_TRUE(again) << why;
    EXPECT_EQ(again->mesh, mesh);
}

/// Zero leaves it to the model, which finds creases by angles.
TEST(corner_normals, that_are_left_out_are_left_to_the_model) {
    const l3d_polygon_mesh mesh = corner_with("f 1//1 2//1 3//1 4//1\nf 2 5 6 3\n");
    EXPECT_EQ(mesh.vertices.size(), 8u);
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(normal_at(mesh, 0, k), vector(0, 0, 1));
        EXPECT_EQ(normal_at(mesh, 1, k), vector(0, 0, 0));
    }
    const l3d_model_file none = read(std::string(corner) + "f 1 2 3 4\nf 2 5 6 3\n");
    EXPECT_TRUE(none.mesh.vertex_normals.empty());
    EXPECT_EQ(none.mesh.vertices.size(), 6u);
    EXPECT_EQ(none.notes, texts{"name:11: normals are skipped: no face names them"});
}

TEST(smoothing_groups, are_smooth_within_and_sharp_between) {
    const std::string squares = "f 1 2 3 4\n", other = "f 2 5 6 3\n";
    const l3d_polygon_mesh one = corner_with("s 1\n" + squares + other);
    EXPECT_EQ(one.vertices.size(), 6u);
    for (const std::size_t k : {1u, 2u}) { // the mean of both faces, weighted by area
        EXPECT_NEAR(normal_at(one, 0, k)[2], std::sqrt(0.5), 1e-15);
        EXPECT_NEAR(normal_at(one, 0, k)[0], -std::sqrt(0.5), 1e-15);
    }
    EXPECT_EQ(normal_at(one, 0, 0), vector(0, 0, 1));
    for (const std::string none : {"off", "0"}) {
        const l3d_polygon_mesh flat = corner_with("s " + none + '\n' + squares + other);
        EXPECT_EQ(flat.vertices.size(), 8u);
        for (std::size_t k = 0; k < 4; ++k) {
            EXPECT_EQ(normal_at(flat, 0, k), vector(0, 0, 1));
            EXPECT_EQ(normal_at(flat, 1, k), vector(-1, 0, 0));
        }
    }
    const l3d_polygon_mesh two = corner_with("s 1\n" + squares + "s 2\n" + other);
    EXPECT_EQ(two.vertices.size(), 8u);
    EXPECT_EQ(normal_at(two, 0, 1), vector(0, 0, 1));
    EXPECT_EQ(normal_at(two, 1, 0), vector(-1, 0, 0));
    EXPECT_TRUE(corner_with(squares + other).vertex_normals.empty()) << "nothing is said";
}

TEST(smoothing_groups, count_where_a_corner_names_no_normal) {
    const l3d_polygon_mesh mesh = corner_with("s 1\nf 1//2 2 3 4\nf 2 5 6 3\ns off\n");
    EXPECT_EQ(normal_at(mesh, 0, 0), vector(-1, 0, 0));
    EXPECT_NEAR(normal_at(mesh, 0, 1)[2], std::sqrt(0.5), 1e-15);
}

/// A fan of flat faces about one vertex: as many vertices, found in linear time.
TEST(smoothing_groups, of_many_flat_faces_about_one_vertex_are_quick) {
    constexpr int sides = 100000;
    std::string text = "v 0 0 1\n";
    for (int i = 0; i < sides; ++i)
        text += "v " + std::to_string(i) + " " + std::to_string(i % 7) + " 0\n";
    text += "s off\n";
    for (int i = 2; i <= sides; ++i)
        text += "f 1 " + std::to_string(i) + ' ' + std::to_string(i + 1) + '\n';
    EXPECT_EQ(read(text).mesh.vertices.size(), 3u * (sides - 1));
}

/// A face may be in several groups, and shares its normal with all that are in one of them.
TEST(smoothing_groups, of_3d_studio_are_heeded) {
    const std::string head = "Named object: \"a\"\nTri-mesh, Vertices: 5 Faces: 3\nVertex list:\n"
                             "Vertex 0: X:0 Y:0 Z:0\nVertex 1: X:0 Y:1 Z:0\nVertex 2: X:1 Y:0 Z:0\n"
                             "Vertex 3: X:0 Y:0 Z:1\nVertex 4: X:-1 Y:0 Z:0\nFace list:\n"
                             "Face 0: A:0 B:2 C:1\n";
    const std::string rest = "Face 1: A:0 B:1 C:3\nSmoothing: 1, 2\nFace 2: A:0 B:3 C:4\n";
    const l3d_polygon_mesh mesh = read(head + "Smoothing: 1\n" + rest + "Smoothing:  2,3\n").mesh;
    EXPECT_NEAR(normal_at(mesh, 0, 0)[0], std::sqrt(0.5), 1e-15);     // of faces 0 and 1
    EXPECT_NEAR(normal_at(mesh, 1, 0)[0], std::sqrt(1 / 3.0), 1e-15); // of all
    EXPECT_NEAR(normal_at(mesh, 2, 0)[1], -std::sqrt(0.5), 1e-15);    // of faces 1 and 2
    EXPECT_EQ(model_text::complaint_of(l3d_read_asc, head + "Smoothing: 33\n", "name"),
              "name:11: '33', a smoothing group, is not in 0 to 32");
}

TEST(odd_normals, are_computed_with_one_note) {
    const auto expect = [](const std::string& text, const vector& kept, const char* line) {
        const l3d_model_file file = read(text);
        EXPECT_EQ(file.notes, texts{std::string("name") + line + ": " + odd_note}) << text;
        ASSERT_EQ(file.mesh.vertex_normals.size(), file.mesh.vertices.size()) << text;
        EXPECT_EQ(normal_at(file.mesh, 0, 0), kept) << text;
        EXPECT_EQ(normal_at(file.mesh, 0, 1), vector(0)) << text;
        EXPECT_EQ(normal_at(file.mesh, 0, 2), vector(0)) << text;
        EXPECT_TRUE(file.mesh.is_valid());
    };
    expect("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 3\nvn 0 0 0\nvn nan 0 1\nf 1//1 2//2 3//3\n",
           {0, 0, 3}, ":7");
    expect("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 3\nvn 1.#IND00 0 0\nvn -1.#INF 0 1\n"
           "f 1//1 2//2 3//3\n",
           {0, 0, 3}, ":7");
    expect("NOFF\n3 1 0\n0 0 0 0 0 3\n1 0 0 0 0 0\n0 1 0 -inf 0 1\n3 0 1 2\n", {0, 0, 3}, ":4");
    expect("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
           "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
           "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
           "0 0 0 0 0 3\n1 0 0 0 0 0\n0 1 0 nan nan nan\n3 0 1 2\n",
           {0, 0, 3}, ":14");
}

TEST(odd_normals, of_all_corners_are_as_none) {
    EXPECT_TRUE(read("NOFF\n4 1 0\n0 0 0 0 0 0\n1 0 0 0 0 0\n0 1 0 0 0 0\n5 5 5 0 0 1\n3 0 1 2\n")
                    .mesh.vertex_normals.empty());
    const l3d_model_file file = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nf 1//1 2//1 3//1\n");
    EXPECT_TRUE(file.mesh.vertex_normals.empty());
    EXPECT_EQ(file.notes, texts{std::string("name:5: ") + odd_note});
}

} // namespace
