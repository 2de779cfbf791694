// SPDX-License-Identifier: MIT
// .stl files: text and binary, told apart by what is in them.
#include "geom/files/model_file.h"

#include "model_text.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace {

const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                          "vertex 0 1 0\nendloop\nendfacet\n"; // seven lines

std::string binary_of(const std::string& header, std::uint32_t promised,
                      const std::vector<std::array<float, 9>>& triangles, std::uint16_t more = 0) {
    std::string text = header;
    text.resize(80);
    const auto add = [&text](auto value) {
        char bytes[sizeof value];
        std::memcpy(bytes, &value, sizeof value);
        text.append(bytes, sizeof value); // on a machine whose words begin with their least byte
    };
    add(promised);
    for (const std::array<float, 9>& triangle : triangles) {
        for (int i = 0; i < 3; ++i)
            add(std::numeric_limits<float>::quiet_NaN());
        for (const float coordinate : triangle)
            add(coordinate);
        add(more);
    }
    return text;
}

std::string complaint(std::string_view text) {
    return model_text::complaint_of(l3d_read_model, text, "name");
}

l3d_model_file read(std::string_view text) {
    return model_text::read_by(l3d_read_model, text, "name");
}

TEST(stl_file, of_text_has_solids_as_parts_and_shares_vertices) {
    const l3d_model_file file =
        read("solid lower half\n" + facet +
             "FACET normal 0 0 1 OUTER LOOP\nvertex 1 0 0\n"
             "vertex 1 1 0\nvertex -0 1 0\nendloop endfacet\nendsolid lower half\n"
             "solid\n" +
             facet + "endsolid\n");
    EXPECT_EQ(file.mesh.vertices.size(), 4u);
    EXPECT_EQ(file.mesh.corners, (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2, 0, 1, 2}));
    EXPECT_EQ(file.mesh.parts, (std::vector<l3d_part_run>{{"lower half", 0}, {"", 2}}));
    EXPECT_TRUE(file.notes.empty());
}

TEST(stl_file, of_bytes_is_known_by_its_size_also_if_it_begins_with_solid) {
    const std::vector<std::array<float, 9>> triangles{{0, 0, 0, 1, 0, 0, 0, 1, 0},
                                                      {1, 0, 0, 1, 1, 0, 0, 1, 0}};
    for (const char* const header : {"solid facet normal", "OFF 3 1 0", ""}) {
        const l3d_model_file file = read(binary_of(header, 2, triangles));
        EXPECT_EQ(file.mesh.vertices.size(), 4u);
        EXPECT_EQ(file.mesh.corners, (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2}));
        EXPECT_TRUE(file.notes.empty());
    }
    const l3d_model_file colored = read(binary_of("", 2, triangles, 0x8123));
    ASSERT_EQ(colored.notes.size(), 1u);
    EXPECT_EQ(colored.notes[0],
              "name:1: what stands behind triangles, such as colours, is skipped");
    EXPECT_EQ(read(binary_of("", 0, {})).mesh.faces(), 0u);
}

TEST(stl_file, may_have_more_than_its_triangles) {
    const std::string text = binary_of("made by a program", 1, {{0, 0, 0, 1, 0, 0, 0, 1, 0}});
    const l3d_model_file file = read(text + "more");
    EXPECT_EQ(file.mesh, read(text).mesh);
    EXPECT_EQ(file.notes,
              std::vector<std::string>{"name:1: what follows the last triangle is skipped"});
    EXPECT_EQ(read("solid a\nfacet normal 0 0 1 outer loop\nvertex 0 0 0\nendloop endfacet\n"
                   "endsolid\n")
                  .notes,
              std::vector<std::string>{"name:4: a facet of 1 corner is skipped"});
}

TEST(stl_file, says_where_and_what_is_wrong) {
    EXPECT_EQ(complaint("solid a\n" + facet),
              "name:9: the text ends in a solid, before its endsolid");
    EXPECT_EQ(complaint("solid a\nfacets"),
              "name:2: 'facets' where 'facet' or 'endsolid' should be");
    EXPECT_EQ(complaint("solid a\nendsolid\nsolids"),
              "name:3: 'solids' where a solid should begin");
    EXPECT_EQ(complaint("solid a\nfacet normal 0 0\n1 inner"),
              "name:3: 'inner' where 'outer' should be");
    EXPECT_NE(complaint("solid a\nfacet normal 0 0 1 outer loop\nvertex 0 0 inf").find("name:3: "),
              std::string::npos);
    EXPECT_NE(complaint("solid a\nfacet normal 0 0 1 outer loop\nvertex 0 0 2e12").find("name:3: "),
              std::string::npos);
    EXPECT_EQ(complaint(binary_of("solid", 2, {{}})),
              "name:1: 2 triangles take 100 bytes; there are 50 (byte 84)");
    EXPECT_EQ(complaint(binary_of("solid", 0xffffffff, {})),
              "name:1: 4294967295 triangles take 214748364750 bytes; there are 0 (byte 84)");
    EXPECT_EQ(
        complaint(
            binary_of("", 2, {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 0, 1, 0, 0, 0, 0x1p41F, 0}})),
        "name:1: '2199023255552', a coordinate of triangle 2 of 2, is beyond 1e12 (byte 178)");
}

} // namespace
