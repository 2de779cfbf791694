// SPDX-License-Identifier: MIT
// Files of polygons, format by format: what is read, what is skipped, and how errors are said.
#include "geom/files/model_file.h"
#include "geom/polygon_shapes.h"

#include "model_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <map>
#include <tuple>
#include <utility>

namespace {

using model_text::with;

using vector = l3d_polygon_mesh::vector;
using numbers = std::vector<std::uint32_t>;

l3d_model_file read(std::string_view text) {
    return model_text::read_by(l3d_read_model, text, "name");
}

std::string complaint(std::string_view text) {
    return model_text::complaint_of(l3d_read_model, text, "name");
}

/// Whether every edge has a face on both sides, that run along it in opposite directions.
bool is_closed(const l3d_polygon_mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t i = 0; i < mesh.faces(); ++i)
        for (std::size_t k = 0; k < mesh.face(i).size(); ++k)
            ++edges[{mesh.face(i)[k], mesh.face(i)[(k + 1) % mesh.face(i).size()]}];
    return std::ranges::all_of(edges, [&edges](const auto& edge) {
        const auto back = edges.find({edge.first.second, edge.first.first});
        return edge.second == 1 && back != edges.end() && back->second == 1;
    });
}

// ---- 3D Studio

constexpr std::string_view asc_text = "Ambient light color: Red=0 Green=0 Blue=0\r\n"
                                      "\r\n"
                                      "Named object: \"The box\"\r\n"
                                      "Tri-mesh, Vertices: 4     Faces: 2\r\n"
                                      "Vertex list:\r\n"
                                      "Vertex 0:  X:1.5     Y:-2     Z:3\r\n"
                                      "Vertex 1: X: 4 Y: 5 Z: 6\r\n"
                                      "Vertex 2:  X:7     Y:8     Z:1e2\r\n"
                                      "Page 3\r\n"
                                      "Vertex 3:  X:10     Y:11     Z:12  U:0 V:1\r\n"
                                      "Face list:\r\n"
                                      "Face 0:    A:0 B:1 C:2 AB:1 BC:1 CA:1\r\n"
                                      "Face 1:    A:3 B:2 C:1\r\n"
                                      "Material:\"Gold\"\r\n"
                                      "Smoothing: 1\r\n";

TEST(asc_file, has_vertices_triangles_and_materials_of_named_objects) {
    const std::string two =
        std::string(asc_text) + std::string(asc_text.substr(asc_text.find("Named")));
    const l3d_polygon_mesh mesh = read(two).mesh;
    EXPECT_EQ(mesh.vertices[0], vector(1.5, -2, 3));
    EXPECT_EQ(mesh.vertices[1], vector(4, 5, 6));
    EXPECT_EQ(mesh.vertices[7], vector(10, 11, 12));
    // Of the two faces one has a smoothing group, so that they share no vertices.
    EXPECT_EQ(mesh.corners, (numbers{0, 1, 2, 3, 8, 9, 4, 5, 6, 7, 10, 11}));
    EXPECT_EQ(mesh.vertices.at(8), mesh.vertices[2]);
    EXPECT_EQ(mesh.face_ends, (numbers{3, 6, 9, 12}));
    EXPECT_EQ(mesh.parts, (std::vector<l3d_part_run>{{"The box", 0}, {"The box", 2}}));
    EXPECT_EQ(mesh.materials, (std::vector<std::string>{"Gold", ""}));
    EXPECT_EQ(mesh.face_materials, (numbers{1, 0, 1, 0}));
}

TEST(asc_file, has_cameras) {
    const std::string text = std::string(asc_text) + "Named object: \"Front\"\nCamera (18mm)\n"
                                                     "Position: X:1\tY:-20\tZ:3\n"
                                                     "Target: X:1\tY:2\tZ:3.5\n"
                                                     "Bank angle: 0.00 degrees\n"
                                                     "Named object: \"Plan\"\nCamera (50.000mm)\n"
                                                     "Position:  X:1   Y:2   Z:9\n"
                                                     "Target:  X:1   Y:2   Z:3\n";
    const l3d_model_file model = read(text);
    EXPECT_EQ(model.notes, std::vector<std::string>{});
    ASSERT_EQ(model.cameras.size(), 2u);
    const l3d_model_camera& front = model.cameras[0];
    EXPECT_EQ(front.name, "Front");
    EXPECT_EQ(front.eye, vector(1, -20, 3));
    EXPECT_EQ(front.target, vector(1, 2, 3.5));
    EXPECT_EQ(front.up, vector(0, 0, 1));
    EXPECT_DOUBLE_EQ(front.fov, 90); // the film is 36 mm wide, twice the lens
    const l3d_model_camera& plan = model.cameras[1];
    EXPECT_EQ(plan.eye, vector(1, 2, 9));
    EXPECT_EQ(plan.up, vector(0, 1, 0)); // z is the line of sight
    EXPECT_NEAR(plan.fov, 39.6, 0.01);
    EXPECT_EQ(model.mesh.parts.size(), 1u);
}

TEST(asc_file, says_what_of_a_scene_it_skips_once_a_kind) {
    const std::string lamp = "Named object: \"Lamp\"\nDirect light\nPosition: X:1 Y:2 Z:3\n"
                             "Spotlight to: X:0 Y:0 Z:0\nHotspot size: 44 degrees\n"
                             "Falloff size: 45 degrees\nLight color: Red=1 Green=1 Blue=1\n";
    const std::string text =
        "Ambient light color: Red=0.1 Green=0.1 Blue=0.1\n"
        "Background image: \"sky.tga\"\nBackground dimmed\n"
        "Gradient top color: Red=1 Green=1 Blue=1\nFog settings: Near 0 Level 0 Far 9 Level: 1\n" +
        std::string(asc_text) + lamp + lamp +
        "Named object: \"Tilted\"\nCamera (35mm)\nPosition: X:0 Y:9 Z:0\nTarget: X:0 Y:0 Z:0\n"
        "Bank angle: 30 degrees\nUnheard of: 5\nSolid background color: Red=0 Green=0 Blue=0\n";
    const std::vector<std::string> notes{"name:1: ambient light is skipped",
                                         "name:2: the background is skipped",
                                         "name:3: fog is skipped",
                                         "name:22: lights are skipped",
                                         "name:39: bank angles are skipped: cameras stand upright",
                                         "name:40: the line 'Unheard of: 5' is skipped"};
    EXPECT_EQ(read(text).notes, notes);
    EXPECT_EQ(read(text).cameras.size(), 1u); // lights are none
    EXPECT_EQ(
        read("Solid background color: Red=0.5 Green=0 Blue=0\n" + std::string(asc_text)).notes,
        std::vector<std::string>{"name:1: the background is skipped"});
}

TEST(asc_file, skips_cameras_that_define_no_picture) {
    const auto camera = [](const char* lens, const char* eye, const char* target) {
        return std::string("Named object: \"C\"\nCamera (") + lens + "mm)\nPosition: " + eye +
               "\nTarget: " + target + "\n";
    };
    const char* const here = "X:1 Y:2 Z:3";
    const char* const there = "X:0 Y:0 Z:0";
    const std::string text = std::string(asc_text) + camera("0", here, there) +
                             camera("-5", here, there) + camera("wide", here, there) +
                             camera("35", here, here) + camera("35", "X:1 Y:2", there) +
                             camera("35", here, "X:1 Y:two Z:3") +
                             camera("35", "X:1e13 Y:0 Z:0", there) + camera("35", here, there);
    const l3d_model_file model = read(text);
    EXPECT_EQ(model.cameras.size(), 1u);
    ASSERT_EQ(model.notes.size(), 7u);
    for (std::size_t i = 0; i < model.notes.size(); ++i)
        EXPECT_EQ(model.notes[i], "name:" + std::to_string(17 + 4 * i) +
                                      ": the camera 'C' is skipped: its place, target or lens is "
                                      "missing");
}

TEST(asc_file, says_where_and_what_is_wrong) {
    EXPECT_EQ(complaint(with(asc_text, "Y: 5", "Y: five")),
              "name:7: 'five', a coordinate, is not a number");
    EXPECT_EQ(complaint(with(asc_text, "Y: 5", "Y: inf")),
              "name:7: 'inf', a coordinate, is not finite");
    EXPECT_EQ(complaint(with(asc_text, "Y: 5", "Y: 1e13")),
              "name:7: '1e13', a coordinate, is beyond 1e12");
    EXPECT_EQ(complaint(with(asc_text, "Z:3", "3")), "name:6: Z: is missing");
    EXPECT_EQ(complaint(with(asc_text, "Vertex 2:", "Vertex 3:")),
              "name:8: the number of a vertex is 3, not 2");
    EXPECT_EQ(complaint(with(asc_text, "A:3", "A:4")), "name:13: '4', a corner, is not in 0 to 3");
    EXPECT_EQ(complaint(with(asc_text, "Face 1:", "Edge 1:")),
              "name:16: 'The box' has 1 of 2 faces");
    EXPECT_EQ(complaint(with(asc_text, "Vertices: 4", "Vertices: 400")),
              "name:4: the text is too short for 400 vertices");
    EXPECT_EQ(complaint(with(asc_text, "Vertices: 4", "Vertices: 5")),
              "name:16: 'The box' has 4 of 5 vertices");
    EXPECT_EQ(complaint("Named object: \"x\"\n"), "name:2: the text ends without a triangle");
}

TEST(asc_file, the_shipped_models_are_closed) {
    for (const auto& [name, vertices, faces] :
         {std::tuple("thing.asc", 26u, 48u), std::tuple("ball.asc", 114u, 224u)}) {
        const l3d_model_file model = read(model_text::of_file("data/" + std::string(name)));
        EXPECT_EQ(model.mesh.vertices.size(), vertices) << name;
        EXPECT_EQ(model.mesh.faces(), faces) << name;
        EXPECT_TRUE(is_closed(model.mesh)) << name;
        EXPECT_EQ(model.notes, std::vector<std::string>{"name:1: ambient light is skipped"})
            << name;
    }
}

// ---- geomview

TEST(off_file, has_faces_of_any_number_of_corners_with_colours) {
    const l3d_polygon_mesh mesh = read("OFF 4 3 6 # counts\n1.5 2 3\n4 5 6 7 8 9\n-1 -2 -3\n"
                                       "3 0 1 2 255 128 0\n4 3 2 1 0\n3 1 2 3 0 0.5 1.0 0.25")
                                      .mesh;
    ASSERT_EQ(mesh.vertices.size(), 4u);
    EXPECT_EQ(mesh.vertices[2], vector(7, 8, 9));
    EXPECT_EQ(mesh.corners, (numbers{0, 1, 2, 3, 2, 1, 0, 1, 2, 3}));
    EXPECT_EQ(mesh.face_ends, (numbers{3, 7, 10}));
    EXPECT_EQ(mesh.face_colors, (numbers{0xff8000, 0xaaaaaa, 0x0080ff}));
}

TEST(off_file, keeps_normals_and_skips_what_has_no_place) {
    const l3d_model_file model =
        read("STCNOFF\n3 2 3\n1 2 3 0 0 1 1 1 1 1 0 0\n4 5 6 0 1 0 1 1 1 1 0 0\n"
             "7 8 9 1 0 0 1 1 1 1 0 0\n3 0 1 2 5\n2 0 1\n");
    EXPECT_EQ(model.mesh.vertex_normals, (std::vector<vector>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
    EXPECT_EQ(model.mesh.faces(), 1u);
    const std::vector<std::string> notes{"name:1: texture coordinates are skipped",
                                         "name:6: colours by their place in a map are skipped",
                                         "name:7: a face of 2 corners is skipped"};
    EXPECT_EQ(model.notes, notes);
}

TEST(off_file, says_where_and_what_is_wrong) {
    const std::string_view text = "OFF\n3 1 0\n1 2 3\n4 5 6\n7 8 9\n3 0 1 2\n";
    EXPECT_EQ(complaint("4OFF 0 0 0"), "name:1: '4OFF' has vertices of other than 3 coordinates");
    EXPECT_EQ(complaint("BOFF 0 0 0"), "name:1: 'BOFF' is not a kind of OFF");
    EXPECT_EQ(complaint(with(text, "3 1 0", "4000000000 1 0")),
              "name:2: the text is too short for 4000000000 vertices");
    EXPECT_EQ(complaint(with(text, "3 1 0", "3 99 0")),
              "name:2: the text is too short for 99 faces");
    EXPECT_EQ(complaint(with(text, "3 1 0", "3 -1 0")),
              "name:2: '-1', the number of faces, is not in 0 to 4294967295");
    EXPECT_EQ(complaint(with(text, "5", "nan")),
              "name:4: 'nan', a coordinate of vertex 1 of 3, is not finite");
    EXPECT_EQ(complaint(with(text, "5", "5e12")),
              "name:4: '5e12', a coordinate of vertex 1 of 3, is beyond 1e12");
    EXPECT_EQ(complaint(with(text, "0 1 2", "0 1 3")),
              "name:6: '3', a corner of face 0 of 1, is not in 0 to 2");
    EXPECT_EQ(complaint(with(text, "3 0", "999 0")),
              "name:6: the text is too short for 999 corners");
}

void append_big(std::string& text, auto value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    if (std::endian::native == std::endian::little)
        std::reverse(std::begin(bytes), std::end(bytes));
    text.append(bytes, sizeof value);
}

TEST(off_file, binary_errors_name_the_byte) {
    std::string text = "OFF BINARY\n";
    for (const int number : {3, 1, 0})
        append_big(text, std::int32_t{number});
    for (const float number : {1.5f, 2.f, 3.f, 4.f, 5.f, 6.f, 7.f, 8.f, -9.f})
        append_big(text, number);
    for (const int number : {3, 2, 0, 1, 0})
        append_big(text, std::int32_t{number});
    const l3d_polygon_mesh mesh = read(text).mesh;
    ASSERT_EQ(mesh.vertices.size(), 3u);
    EXPECT_EQ(mesh.vertices[2], vector(7, 8, -9));
    EXPECT_EQ(mesh.corners, (numbers{2, 0, 1}));
    EXPECT_EQ(complaint(text.substr(0, 70)),
              "name:2: the text is too short for 3 corners (byte 63)");
    EXPECT_EQ(complaint(text.substr(0, 77)), "name:2: the text ends where the number of colour "
                                             "components of face 0 of 1 should be (byte 77)");
    text[66] = 9; // of the first corner, bytes 63 to 66
    EXPECT_EQ(complaint(text), "name:2: '9', a corner of face 0 of 1, is not in 0 to 2 (byte 67)");
}

// ---- Stanford

constexpr std::string_view ply_text = "ply\n"
                                      "format ascii 1.0\n"
                                      "comment property of nothing\n"
                                      "element vertex 3\n"
                                      "property float x\n"
                                      "property uchar quality\n"
                                      "property double z\n"
                                      "property float y\n"
                                      "element strip 1\n"
                                      "property list int int what\n"
                                      "element face 2\n"
                                      "property float red\n"
                                      "property float green\n"
                                      "property float blue\n"
                                      "property list uchar int vertex_index\n"
                                      "end_header\n"
                                      "1 9 3 2\n"
                                      "4 9 6 5\n"
                                      "7 9 9 8\n"
                                      "2 1 1\n"
                                      "1 0.5 0 3 0 1 2\n"
                                      "1 0 0 2 0 1";

TEST(ply_file, has_properties_in_any_order) {
    const l3d_model_file model = read(ply_text);
    EXPECT_EQ(model.mesh.vertices, (std::vector<vector>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
    EXPECT_EQ(model.mesh.corners, (numbers{0, 1, 2}));
    EXPECT_EQ(model.mesh.face_colors, (numbers{0xff8000}));
    const std::vector<std::string> notes{"name:16: the element 'strip' is skipped",
                                         "name:22: a face of 2 corners is skipped"};
    EXPECT_EQ(model.notes, notes);
}

TEST(ply_file, says_where_and_what_is_wrong) {
    EXPECT_EQ(complaint(with(ply_text, "ascii", "ebcdic")), "name:2: 'ebcdic' is no format of ply");
    EXPECT_EQ(complaint(with(ply_text, "1.0", "2.0")), "name:2: '2.0' is not version 1.0");
    EXPECT_EQ(complaint(with(ply_text, "vertex 3", "vertex 3000000000")),
              "name:16: the text is too short for 3000000000 of the element 'vertex'");
    EXPECT_EQ(complaint(with(ply_text, "double z", "double w")), "name:16: vertices have no z");
    EXPECT_EQ(complaint(with(ply_text, "double z", "double x")), "name:16: vertices have no z");
    EXPECT_EQ(complaint(with(ply_text, "float x", "quad x")), "name:5: 'quad' is no type of ply");
    EXPECT_EQ(complaint(with(ply_text, "uchar int vertex_index", "float int vertex_index")),
              "name:15: 'float' counts a list");
    EXPECT_EQ(complaint(with(ply_text, "uchar int vertex_index", "uchar float vertex_index")),
              "name:15: indices of vertices are not whole numbers");
    EXPECT_EQ(complaint(with(ply_text, "3 0 1 2", "3 0 1 5")),
              "name:21: '5', a corner of face 0 of 2, is not in 0 to 2");
    EXPECT_EQ(complaint("ply\nformat ascii 1.0\nelement x 1000000000\nend_header\n"),
              "name:4: the element 'x' has no properties");
}

/// Of vertices, or of the corners of faces; both from the picture's bottom left corner.
TEST(ply_file, lays_the_picture_that_a_comment_names) {
    const std::string head = "ply\nformat ascii 1.0\ncomment TextureFile  my wood.png\n"
                             "element vertex 3\nproperty float x\nproperty float y\n"
                             "property float z\n";
    const std::string of_vertices = head +
                                    "property float s\nproperty float t\n"
                                    "element face 1\nproperty list uchar int vertex_indices\n"
                                    "end_header\n"
                                    "0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 0.75\n3 2 0 1\n";
    const std::string of_corners = head + "element face 1\nproperty list uchar int vertex_indices\n"
                                          "property list uchar float texcoord\nend_header\n"
                                          "0 0 0\n1 0 0\n1 1 0\n3 2 0 1 6 1 0.75 0 0 1 0\n";
    for (const std::string& text : {of_vertices, of_corners}) {
        const l3d_model_file model = read(text);
        EXPECT_EQ(model.mesh.picture_places,
                  (std::vector<l3d_polygon_mesh::picture_place>{{1, 0.25F}, {0, 1}, {1, 1}}));
        ASSERT_EQ(model.mesh.pictures.size(), 1U);
        EXPECT_EQ(model.mesh.pictures[0].name, "my wood.png");
        EXPECT_EQ(model.mesh.look_of(0).picture, 0);
        EXPECT_TRUE(model.mesh.is_valid());
        EXPECT_TRUE(model.notes.empty());
    }
    EXPECT_EQ(read(with(of_corners, "TextureFile", "texture")).notes,
              std::vector<std::string>{"name:11: places in pictures are skipped: no comment "
                                       "TextureFile names a picture"});
    EXPECT_EQ(read(with(of_corners, "6 1 0.75 0 0 1 0", "2 1 0.75")).notes,
              std::vector<std::string>{
                  "name:15: lists texcoord without two numbers for each corner are skipped"});
    EXPECT_EQ(read(with(of_corners, "texcoord", "other")).notes[1],
              "name:11: the picture 'my wood.png' is skipped: no corner has a place in it");
}

TEST(ply_file, both_byte_orders_say_the_same_as_text) {
    const auto corpus = [](const std::string& name) {
        return read(model_text::of_file("data/../tests/fuzz/corpus/ply/" + name + ".ply")).mesh;
    };
    ASSERT_EQ(corpus("text").vertices.size(), 4u);
    EXPECT_EQ(corpus("little"), corpus("text"));
    EXPECT_EQ(corpus("big"), corpus("text"));
}

// ---- Videoscape

TEST(videoscape_file, has_colours_of_the_palette_or_of_bytes) {
    const l3d_model_file model = read("3DG1\n4\n1.5 2 3\n4 5 6\n7 8 9\n-1 -2 -3\n"
                                      "3 0 1 2 0x3322cc\n4 3 2 1 0 20\n2 0 1 7\n");
    EXPECT_EQ(model.mesh.corners, (numbers{0, 1, 2, 3, 2, 1, 0}));
    EXPECT_EQ(model.mesh.face_colors, (numbers{0xcc2233, 0xa00000})); // 20: red and glossy
    EXPECT_EQ(model.notes, (std::vector<std::string>{
                               "name:8: kinds of surface, such as glossy ones, are skipped: "
                               "faces have their colours",
                               "name:9: a face of 2 corners is skipped"}));
}

TEST(videoscape_file, says_where_and_what_is_wrong) {
    const std::string_view text = "3DG1\n3\n1 2 3\n4 5 6\n7 8 9\n3 0 1 2 7\n";
    EXPECT_EQ(complaint(with(text, "\n3\n", "\n99\n")),
              "name:2: the text is too short for 99 vertices");
    EXPECT_EQ(complaint(with(text, "8", "x")),
              "name:5: 'x', a coordinate of vertex 2 of 3, is not a number");
    EXPECT_EQ(complaint(with(text, "1 2 7", "1 3 7")),
              "name:6: '3', a corner of a face, is not in 0 to 2");
    EXPECT_EQ(complaint(with(text, "2 7", "2 0x")),
              "name:6: '0x', the colour of a face, is not a number");
    EXPECT_EQ(complaint(with(text, "2 7", "2 -7")),
              "name:6: '-7', the colour of a face, announces detail polygons, which are not read");
    EXPECT_EQ(complaint(with(text, " 7", "")),
              "name:7: the text ends where the colour of a face should be");
}

TEST(torus, is_what_the_writer_makes_of_the_shape) {
    const l3d_polygon_mesh torus = l3d_torus_mesh(12, 8);
    const std::string text = model_text::of_file("data/torus.off");
    const l3d_polygon_mesh mesh = read(text).mesh;
    EXPECT_EQ(mesh.faces(), 192u);
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_EQ(mesh.corners, torus.corners);
    EXPECT_EQ(l3d_write_off(mesh), text);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) // sine and cosine differ among systems
        EXPECT_LT(l3d_length(mesh.vertices[i] - torus.vertices.at(i)), 1e-14) << i;
}

} // namespace
