// SPDX-License-Identifier: MIT
// Tags of cages in .obj files.
#include "geom/files/model_file.h"

#include "model_text.h"

#include <gtest/gtest.h>

#include <string>

namespace {

constexpr std::string_view square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

l3d_model_file read_after(std::string_view statements) {
    return model_text::read_by(l3d_read_obj, std::string(square).append(statements), "name");
}

std::string complaint_after(std::string_view statements) {
    return model_text::complaint_of(l3d_read_obj, std::string(square).append(statements), "name");
}

TEST(obj_tags, are_creases_corners_holes_and_boundaries) {
    const l3d_cage_tags tags = read_after("t crease 2/1/0 0 1 2.5\nt crease 3/2/0 1 2 3 1 20\n"
                                          "t corner 2/1/0 0 3 4\nt hole 1/0/0 0\n"
                                          "t interpolateboundary 1/0/0 2\n")
                                   .tags;
    using crease = l3d_cage_tags::crease;
    using corner = l3d_cage_tags::corner;
    EXPECT_EQ(tags.creases, (std::vector<crease>{{0, 1, 2.5F}, {1, 2, 1.0F}, {2, 3, 10.0F}}));
    EXPECT_EQ(tags.corners, (std::vector<corner>{{0, 4.0F}, {3, 4.0F}}));
    EXPECT_EQ(tags.holes, (std::vector<std::uint32_t>{0}));
    EXPECT_EQ(tags.keeps_corners, false);
}

TEST(obj_tags, are_read_as_they_were_written) {
    const l3d_model_file file =
        read_after("t crease 2/1/0 0 1 2.7\nt corner 1/1/0 3 0.1\nt hole 1/0/0 0\n"
                   "t interpolateboundary 1/0/0 1\n");
    EXPECT_EQ(model_text::read_by(l3d_read_obj, l3d_write_obj(file), "name"), file);
}

TEST(obj_tags, keep_their_vertices_where_control_points_are_left_out) {
    const l3d_model_file file = model_text::read_by(
        l3d_read_obj,
        "v 9 0 0\nv 9 1 0\nv 9 0 1\nv 9 1 1\ncstype bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\n"
        "parm u 0 1\nparm v 0 1\nend\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 5 6 7\nt crease 2/1/0 5 6 3\n",
        "name");
    EXPECT_EQ(file.mesh.vertices.size(), 3U);
    EXPECT_EQ(file.tags.creases[0].from, 1U);
    EXPECT_EQ(file.tags.creases[0].to, 2U);
}

TEST(obj_tags, that_are_unknown_make_a_note) {
    EXPECT_EQ(read_after("t creasemethod 0/0/1 chaikin\n").notes[0],
              "name:6: tags 'creasemethod' are skipped");
}

TEST(obj_tags, that_are_wrong_are_refused_in_their_line) {
    for (const auto& [tag, what] : {
             std::pair("t", "name:6: the line ends where a tag's name should be"),
             {"t crease 2/1", "name:6: '2/1' is not INTEGERS/REALS/WORDS"},
             {"t crease 1/1/0 0 1", "name:6: a tag 'crease' has fewer than two vertices"},
             {"t crease 2/1/0 0 1", "name:6: the line ends where a sharpness should be"},
             {"t crease 2/1/0 0 1 -1", "name:6: a sharpness of -1 is negative"},
             {"t crease 2/1/0 0 1 2 3", "name:6: '3' at the end of a tag"},
             {"t corner 3/2/0 0 1 2 1 1", "name:6: a tag 'corner' of 3 corners has 2 numbers"},
         })
        EXPECT_EQ(complaint_after(tag), what);
    EXPECT_EQ(complaint_after("t crease 2/1/0 0 4 1"),
              "name:6: '4', a vertex counted from 0, is not in 0 to 3");
    EXPECT_EQ(complaint_after("t hole 1/0/0 1"),
              "name:6: '1', a face counted from 0, is not in 0 to 0");
}

} // namespace
