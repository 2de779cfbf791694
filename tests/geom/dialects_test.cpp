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
    EXPECT_EQ(read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1// 2// 3//\n"), plain);
    EXPECT_EQ(read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/ 2/ 3/\n"), plain);
}

TEST(dialects, obj_vertices_may_have_seven_numbers_and_any_colour) {
    const auto model = read("v 0 0 0 1 0.5 0.5 0.5\nv 1 0 0 1 nan 2 -inf\nv 0 1 0 nan nan nan\n"
                            "f 1 2 3\n");
    EXPECT_EQ(model.mesh.vertices, (std::vector<vector>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(model.notes.size(), 1u);
    EXPECT_EQ(read("v 0 0 0 1 1 0 0\nv 1 0 0 0 1 0 1\nv 0 1 0 0 0 1\nf 1 2 3\n").mesh.face_colors,
              numbers{0x555555});
    EXPECT_EQ(complaint("v 0 0 0 1 1 1 1 1\n"), "name:1: '1' at the end of a statement");
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

// ---- .off

TEST(dialects, off_may_leave_out_the_number_of_edges) {
    const auto plain = read(off_text);
    EXPECT_EQ(read("OFF\n3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), plain);
    EXPECT_EQ(read("OFF 3 1\n\n# corners\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), plain);
    EXPECT_EQ(read("OFF\n3\n1\n0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), plain);
    EXPECT_EQ(read("OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2"), plain);
}

TEST(dialects, off_colours_of_vertices_may_have_three_components) {
    // The mean of red, green and blue.
    const auto expect_grey = [](std::string_view text) {
        const auto mesh = read(text).mesh;
        EXPECT_EQ(mesh.vertices, read(off_text).mesh.vertices) << text;
        EXPECT_EQ(mesh.corners, read(off_text).mesh.corners) << text;
        EXPECT_EQ(mesh.face_colors, numbers{0x555555}) << text;
    };
    expect_grey("COFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n");
    expect_grey("COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 0 1 0 1\n0 1 0 0 0 1 nan\n3 0 1 2\n");
    expect_grey("COFF\n3 1 0\n0 0 0\n1 0 0 1\n1 0 0 0 1 0 1\n0 1 0 0 0 1 1\n3 0 1 2\n");
    expect_grey("STCOFF\n3 1 0\n0 0 0 1 0 0 .5 .5\n1 0 0 0 1 0 1 .5 .5\n0 1 0 0 0 1 0 0\n"
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
    EXPECT_EQ(complaint("ply\nformat ascii 1.0\n" + header + "0 nan 0 0 0\n1 0 0 0 0\n0 1 0 1 0\n")
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
