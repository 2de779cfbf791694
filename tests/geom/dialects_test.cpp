// SPDX-License-Identifier: MIT
// What other programs write though no description of the format has it, or few readers take it.
#include "geom/files/model_file.h"

#include "model_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace {

using numbers = std::vector<std::uint32_t>;
using vector = l3d_polygon_mesh::vector;

l3d_model_file read(std::string_view text) {
    return model_text::read_by(l3d_read_model, text, "name");
}

std::string complaint(std::string_view text) {
    return model_text::complaint_of(l3d_read_model, text, "name");
}

std::string with_carriage_returns(std::string text) {
    std::ranges::replace(text, '\n', '\r');
    return text;
}

template <class T> void append_bits(std::string& text, T value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    text.append(bytes, sizeof value);
}

// ---- every format

constexpr std::string_view off_text = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
constexpr std::string_view obj_text = "# a comment\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
constexpr std::string_view ply_text =
    "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 3\nproperty float x\n"
    "property float y\nproperty float z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
constexpr std::string_view bpt_text = "1\n1 1\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n";

TEST(dialects, a_byte_order_mark_is_passed_over) {
    for (const std::string_view text : {off_text, obj_text, ply_text, bpt_text})
        EXPECT_EQ(read("\xEF\xBB\xBF" + std::string(text)), read(text)) << text;
}

TEST(dialects, lines_may_end_with_carriage_returns) {
    for (const std::string_view text : {off_text, obj_text, ply_text, bpt_text}) {
        EXPECT_EQ(read(with_carriage_returns(std::string(text))), read(text)) << text;
        const std::string dos = [&] {
            std::string result;
            for (const char c : text)
                result += c == '\n' ? "\r\n" : std::string(1, c);
            return result;
        }();
        EXPECT_EQ(read(dos), read(text)) << text;
    }
    EXPECT_EQ(read(with_carriage_returns("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 \\\n3\n")).mesh.faces(),
              1u);
    EXPECT_EQ(complaint(with_carriage_returns("v 0 0 0\nv 1 0 0\nf 1 2 3\n")).substr(0, 7),
              "name:3:");
}

TEST(dialects, a_stray_carriage_return_ends_no_line_of_unix) {
    EXPECT_EQ(read("# by\rhand\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").mesh.vertices.size(), 3u);
}

TEST(dialects, binary_bytes_follow_a_header_with_carriage_returns) {
    std::string text = with_carriage_returns(
        "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\n"
        "property uchar y\nproperty uchar z\nend_header\n");
    text += "\n\r\n";
    EXPECT_EQ(read(text).mesh.vertices, (std::vector<vector>{{10, 13, 10}}));
}

TEST(dialects, names_in_messages_cannot_steer_a_terminal) {
    std::string why;
    EXPECT_FALSE(l3d_read_model("v 1", "evil\x1b[2J\n.obj", why));
    EXPECT_EQ(why.substr(0, 23), "evil\\x1b[2J\\x0a.obj:1: ");
    EXPECT_FALSE(l3d_read_model("v 1", "gr\xC3\xBC\xC3\x9F.obj", why));
    EXPECT_EQ(why.substr(0, 14), "gr\xC3\xBC\xC3\x9F.obj:1: ");
}

// ---- .obj

TEST(dialects, obj_corners_may_end_with_slashes) {
    const auto plain = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n");
    EXPECT_EQ(read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1/ 2/1/ 3/1/\n"), plain);
    const auto without = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1 2 3\n");
    EXPECT_EQ(read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1// 2// 3//\n"), without);
    EXPECT_EQ(read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/ 2/ 3/\n"), without);
    EXPECT_NE(without, plain);
}

TEST(dialects, obj_vertices_may_have_seven_numbers_and_any_colour) {
    const auto model = read("v 0 0 0 1 0.5 0.5 0.5\nv 1 0 0 1 nan 2 -inf\nv 0 1 0 nan nan nan\n"
                            "f 1 2 3\n");
    EXPECT_EQ(model.mesh.vertices, (std::vector<vector>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_TRUE(model.notes.empty());
    EXPECT_EQ(read("v 0 0 0 1 1 0 0\nv 1 0 0 0 1 0 1\nv 0 1 0 0 0 1\nf 1 2 3\n").mesh.vertex_colors,
              (numbers{0xff0000, 0x00ff00, 0x0000ff}));
    EXPECT_EQ(complaint("v 0 0 0 nan\n"), "name:1: 'nan', a weight, is not finite");
    EXPECT_EQ(complaint("v 0 0 0 1 x 1\n"), "name:1: 'x', a weight or colour, is not a number");
}

TEST(dialects, obj_faces_of_two_corners_are_skipped_with_a_note) {
    const auto model = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\nf 1 2 3\nf 3\n");
    EXPECT_EQ(model.mesh.corners, (numbers{0, 1, 2}));
    EXPECT_EQ(model.mesh.face_ends, numbers{3});
    EXPECT_EQ(model.notes, (std::vector<std::string>{"name:4: a face of 2 corners is skipped",
                                                     "name:6: a face of 1 corner is skipped"}));
}

TEST(dialects, obj_materials_without_a_file_are_noted) {
    const auto model = read("mtllib\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_TRUE(model.material_files.empty());
    EXPECT_EQ(model.notes, std::vector<std::string>{"name:1: mtllib names no file"});
}

/// Whatever a name has in it, it goes to the end of its line.
constexpr std::string_view names[] = {"Material #1",
                                      "Material #2",
                                      "#",
                                      "a  b",
                                      "a b",
                                      "a\tb",
                                      "\"quoted\" 'too'",
                                      "C:\\skins\\red",
                                      "ends with \\",
                                      "gr\xC3\xBC\xC3\x9F",
                                      "50%20off, a=b; -c",
                                      "\xC2\xA0"};

TEST(dialects, obj_names_may_have_any_character) {
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", mtl;
    int red = 0;
    for (const std::string_view name : names) {
        text.append("o ").append(name).append(" \r\nusemtl\t").append(name) += "\r\nf 1 2 3\r\n";
        mtl.append("newmtl ").append(name).append("  \nKd ") +=
            std::to_string(++red / 255.0) + '\n';
    }
    l3d_model_file file = read(text);
    std::vector<std::string> notes;
    const auto materials = l3d_read_mtl(mtl, "name", notes);
    l3d_give_looks(file.mesh, materials);
    EXPECT_EQ(notes, std::vector<std::string>{});
    EXPECT_EQ(file.notes, std::vector<std::string>{});
    ASSERT_EQ(file.mesh.parts.size(), std::size(names));
    for (std::uint32_t i = 0; i < std::size(names); ++i) {
        EXPECT_EQ(file.mesh.parts[i].name, names[i]);
        EXPECT_EQ(file.mesh.materials.at(i), names[i]);
        EXPECT_EQ(file.mesh.look_of(i).color, 0x010101u * (i + 1)) << names[i];
    }
    file.mesh.looks.clear();
    std::string why;
    EXPECT_EQ(l3d_read_obj(l3d_write_obj(file), "name", why), file);
}

TEST(dialects, names_of_other_formats_may_have_any_character) {
    for (const std::string_view name : names) {
        const std::string stl = "solid " + std::string(name) +
                                "\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                                "vertex 0 1 0\nendloop\nendfacet\nendsolid " +
                                std::string(name) + '\n';
        EXPECT_EQ(read(stl).mesh.parts.at(0).name, name);
        const std::string asc = "Named object: \"" + std::string(name) +
                                "\"\nTri-mesh, Vertices: 3 Faces: 1\nVertex list:\n"
                                "Vertex 0: X:0 Y:0 Z:0\nVertex 1: X:1 Y:0 Z:0\n"
                                "Vertex 2: X:0 Y:1 Z:0\nFace list:\nFace 0: A:0 B:1 C:2\n"
                                "Material:\"" +
                                std::string(name) + "\"\n";
        EXPECT_EQ(read(asc).mesh.parts.at(0).name, name);
        EXPECT_EQ(read(asc).mesh.materials.at(0), name);
        std::string bare = asc;
        std::erase(bare, '"');
        if (name.find('"') == name.npos) {
            EXPECT_EQ(read(bare).mesh.parts.at(0).name, name);
        }
    }
}

/// No face uses the second and the last vertex.
TEST(dialects, vertices_that_no_face_uses_may_be_nowhere) {
    const std::string note =
        "vertices that no face uses are not finite, or beyond 1e12: they are skipped";
    const std::string_view files[] = {
        "v 0 0 0\nv nan 0 inf\nv 1 0 0\nv 0 1 0\nv 1e300 0 0\nf 1 3 4\n",
        "OFF\n5 1 0\n0 0 0\nnan 0 inf\n1 0 0\n0 1 0\n1e300 0 0\n3 0 2 3\n",
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\nnan 0 inf\n1 0 0\n0 1 0\n1e300 0 0\n3 0 2 3\n",
        "3DG1\n5\n0 0 0\nnan 0 inf\n1 0 0\n0 1 0\n1e300 0 0\n3 0 2 3 5\n",
        "Named object: \"a\"\nTri-mesh, Vertices: 5 Faces: 1\nVertex list:\n"
        "Vertex 0: X:0 Y:0 Z:0\nVertex 1: X:nan Y:0 Z:inf\nVertex 2: X:1 Y:0 Z:0\n"
        "Vertex 3: X:0 Y:1 Z:0\nVertex 4: X:1e300 Y:0 Z:0\nFace list:\nFace 0: A:0 B:2 C:3\n"};
    for (const std::string_view text : files) {
        const l3d_model_file file = read(text);
        ASSERT_EQ(file.notes.size(), 1u) << text;
        EXPECT_TRUE(file.notes[0].ends_with(": " + note)) << file.notes[0];
        EXPECT_EQ(file.mesh.corners, (numbers{0, 2, 3})) << text;
        EXPECT_EQ(file.mesh.vertices[1], vector(0)) << text;
        EXPECT_EQ(file.mesh.vertices[4], vector(0)) << text;
    }
}

TEST(dialects, what_nobody_needs_is_skipped_with_a_note) {
    const auto notes_of = [](std::string_view text) { return read(text).notes; };
    using texts = std::vector<std::string>;
    const std::string obj(obj_text), off(off_text), ply(ply_text);
    EXPECT_EQ(notes_of(obj + "vv 1 2\nvv 3 4\nobjectid 7\n"),
              (texts{"name:6: statements 'vv' are skipped",
                     "name:8: statements 'objectid' are skipped"}));
    EXPECT_EQ(notes_of("v 0 0 0 1 1 1 1 1\nv 1 0 0\nv 0 1 0\nvn 0 0 1 0\nf 1 2 3\n").size(), 3u);
    EXPECT_EQ(notes_of(off + "\n8 9\n"), texts{"name:8: what follows the last face is skipped"});
    EXPECT_EQ(notes_of(model_text::with(off, "0 1 2", "0 1 2 1 2 3 4 5 6")),
              texts{"name:6: what follows the colour of a face is skipped"});
    EXPECT_EQ(notes_of(model_text::with(off, "0 1 2", "0 1 2 256 0 -1")),
              texts{"name:6: colours out of range are taken for the nearest"});
    EXPECT_EQ(read(model_text::with(off, "0 1 2", "0 1 2 256 0 -1")).mesh.face_colors,
              numbers{0xff0000});
    EXPECT_EQ(notes_of(ply + " 7"), texts{"name:15: what follows the last element is skipped"});
    EXPECT_EQ(notes_of(model_text::with(ply, "element vertex", "author me\nelement vertex")),
              texts{"name:4: lines 'author' of the header are skipped"});
    const std::string more = "float z\nproperty float x\nproperty float quality\n"
                             "property uchar alpha\n";
    EXPECT_EQ(
        notes_of("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                 "property float y\nproperty " +
                 more + "end_header\n1 2 3 nan 5 6\n"),
        (texts{"name:7: the property 'x' is skipped", "name:9: the property 'alpha' is skipped"}));
    EXPECT_EQ(read(model_text::with(obj, "v 0 0 0", "v 0 1e-999 -1E-400")), read(obj));
    for (const std::string_view text : {off_text, obj_text, ply_text, bpt_text})
        EXPECT_EQ(read(std::string(text) + "\x1a"), read(text)) << "DOS ends texts with this";
}

// ---- .off

TEST(dialects, off_may_leave_out_the_number_of_edges) {
    const auto plain = read(off_text);
    EXPECT_EQ(read("OFF\n3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), plain);
    EXPECT_EQ(read("OFF 3 1\n\n# corners\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), plain);
    EXPECT_EQ(read("OFF\n3\n1\n0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), plain);
    EXPECT_EQ(read("OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2"), plain);
}

TEST(dialects, off_colours_of_vertices_may_have_three_components) {
    const auto expect_three = [](std::string_view text) {
        const auto mesh = read(text).mesh;
        EXPECT_EQ(mesh.vertices, read(off_text).mesh.vertices) << text;
        EXPECT_EQ(mesh.corners, read(off_text).mesh.corners) << text;
        EXPECT_EQ(mesh.vertex_colors, (numbers{0xff0000, 0x00ff00, 0x0000ff})) << text;
    };
    expect_three("COFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n");
    expect_three("COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 0 1 0 1\n0 1 0 0 0 1 nan\n3 0 1 2\n");
    expect_three("COFF\n3 1 0\n0 0 0\n1 0 0 1\n1 0 0 0 1 0 1\n0 1 0 0 0 1 1\n3 0 1 2\n");
    expect_three("STCOFF\n3 1 0\n0 0 0 1 0 0 .5 .5\n1 0 0 0 1 0 1 .5 .5\n0 1 0 0 0 1 0 0\n"
                 "3 0 1 2\n");
    EXPECT_EQ(
        read("COFF\n3 1 0\n0 0 0 nan 0 1\n1 0 0 1 0 1\n0 1 0 1 0 1\n3 0 1 2\n").mesh.face_colors,
        numbers{0xff00ff});
}

// ---- .ply

/// As Blender wrote it until 2008.
TEST(dialects, ply_that_says_by_whom_it_was_created) {
    std::string text(ply_text);
    text.replace(text.find("comment"), 7, "Created");
    EXPECT_EQ(read(text).mesh, read(ply_text).mesh);
}

TEST(dialects, ply_properties_that_are_skipped_may_be_no_numbers) {
    const std::string header = "element vertex 3\nproperty float x\nproperty float y\n"
                               "property float z\nproperty float quality\n"
                               "property list uchar float weights\nelement face 1\n"
                               "property list uchar int vertex_indices\nend_header\n";
    EXPECT_EQ(read("ply\nformat ascii 1.0\n" + header +
                   "0 0 0 nan 1 inf\n1 0 0 -inf 0\n0 1 0 1 0\n3 0 1 2\n")
                  .mesh,
              read(ply_text).mesh);
    std::string binary = "ply\nformat binary_little_endian 1.0\n" + header;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const std::array<float, 3> v :
         {std::array{0.f, 0.f, 0.f}, {1.f, 0.f, 0.f}, {0.f, 1.f, 0.f}}) {
        for (const float value : {v[0], v[1], v[2], nan})
            append_bits(binary, value);
        append_bits(binary, std::uint8_t{1});
        append_bits(binary, nan);
    }
    append_bits(binary, std::uint8_t{3});
    for (const std::int32_t corner : {0, 1, 2})
        append_bits(binary, corner);
    EXPECT_EQ(read(binary).mesh, read(ply_text).mesh);
    EXPECT_EQ(complaint("ply\nformat ascii 1.0\n" + header +
                        "0 nan 0 0 0\n1 0 0 0 0\n0 1 0 1 0\n"
                        "3 0 1 2\n")
                  .substr(0, 13),
              "name:12: 'nan");
}

TEST(dialects, ply_strips_become_triangles) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
        "property float z\nelement tristrips 2\nproperty list int int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n"
        "10 0 1 2 3 -1 2 3 4 -1 0\n"
        "6 0 1 2 2 3 4\n";
    EXPECT_EQ(read(text).mesh.corners, (numbers{0, 1, 2, 2, 1, 3, 2, 3, 4, 0, 1, 2, 3, 2, 4}));
    EXPECT_TRUE(read(text).notes.empty());
    EXPECT_EQ(complaint(model_text::with(text, "-1 0\n", "-2 0\n")),
              "name:15: '-2', a corner of strip 0 of 2, is not in -1 to 4");
}

TEST(dialects, ply_strips_beside_coloured_faces_are_grey) {
    const auto mesh =
        read("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
             "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
             "element face 1\nproperty list uchar int vertex_indices\nproperty uchar red\n"
             "property uchar green\nproperty uchar blue\nend_header\n"
             "0 0 0\n1 0 0\n0 1 0\n1 1 0\n4 0 1 2 3\n3 0 1 2 255 0 0\n")
            .mesh;
    EXPECT_EQ(mesh.faces(), 3u);
    EXPECT_EQ(mesh.face_colors, (numbers{0xaaaaaa, 0xaaaaaa, 0xff0000}));
}

/// Elements of rising names, none of which has a row.
std::string ply_of_elements(int count) {
    std::string text = "ply\nformat ascii 1.0\n";
    for (int i = 0; i < count; ++i)
        text += "element e" + std::to_string(i) + " 0\n";
    return text + "element vertex 0\nproperty float x\nproperty float y\nproperty float z\n"
                  "end_header\n";
}

TEST(dialects, ply_headers_of_many_elements_are_read_and_a_second_name_is_found) {
    // Comparing each name with each would take 2 * 10^10 comparisons, and minutes.
    EXPECT_EQ(read(ply_of_elements(200000)).notes.size(), 21u);
    EXPECT_EQ(complaint(model_text::with(ply_of_elements(20), "element e13 ", "element e4 ")),
              "name:16: there is a second element 'e4'");
}

// ---- .bpt

TEST(dialects, bpt_may_have_comments) {
    EXPECT_EQ(read("# a patch\n" + std::string(bpt_text) + "# the end\n"), read(bpt_text));
    EXPECT_EQ(read("1 # patch\n1 1\n0 0 0 # corner\n1 0 0\n0 1 0\n1 1 1"), read(bpt_text));
}

} // namespace
