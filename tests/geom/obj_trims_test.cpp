// SPDX-License-Identifier: MIT
// Trims of .obj surfaces: what is read, written again, and refused by line.
#include "geom/files/model_file.h"
#include "geom/trims/trim_region.h"

#include "model_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

namespace {

const std::string surface = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
const std::string square = "vp 0.25 0.25\nvp 0.75 0.25\nvp 0.75 0.75\nvp 0.25 0.75\n"
                           "cstype bspline\ndeg 1\ncurv2 1 2 3 4 1\nparm u 0 0 1 2 3 4 4\nend\n";
const std::string begin = "cstype bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\nparm u 0 1\nparm v 0 1\n";

std::optional<l3d_model_file> read(const std::string& text, std::string& why) {
    return l3d_read_obj(text, "name", why);
}

l3d_trim_region region_of(const l3d_patch_points& patch) {
    l3d_trim_region result;
    l3d_flat_trims(patch.trims, {1, 1}, 1e-3, result);
    return result;
}

std::string complaint(const std::string& text) {
    return model_text::complaint_of(l3d_read_obj, text, "name");
}

TEST(obj_trims, of_a_hole_leave_the_surface_around_it) {
    std::string why;
    const auto model = read(surface + square + begin + "hole 0 4 1\nend\n", why);
    ASSERT_TRUE(model) << why;
    EXPECT_TRUE(model->notes.empty());
    ASSERT_EQ(model->patches.size(), 1U);
    const l3d_trim_region region = region_of(model->patches[0]);
    EXPECT_TRUE(region.contains({0.1, 0.1}));
    EXPECT_FALSE(region.contains({0.5, 0.5}));
}

TEST(obj_trims, of_a_border_leave_what_is_in_it) {
    std::string why;
    const auto model = read(surface + square + begin + "trim 0 2 -1 2 4 1\nend\n", why);
    ASSERT_TRUE(model) << why;
    const l3d_trim_region region = region_of(model->patches.at(0));
    EXPECT_FALSE(region.contains({0.1, 0.1}));
    EXPECT_TRUE(region.contains({0.5, 0.5}));
}

TEST(obj_trims, are_shared_out_among_pieces) {
    std::string why, vertices;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 5; ++i)
            vertices += "v " + std::to_string(i) + ' ' + std::to_string(j) + " 0\n";
    const auto model = read(vertices + square +
                                "cstype bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4 5 6 7 8 9 10\n"
                                "parm u 0 0.2 0.4 0.9 1\nparm v 0 1\nhole 0 4 1\nend\n",
                            why);
    ASSERT_TRUE(model) << why;
    ASSERT_EQ(model->patches.size(), 4U);
    for (const std::size_t i : {0U, 3U}) // the hole is elsewhere
        EXPECT_TRUE(region_of(model->patches[i]).within({}).is_all_of({}));
    const l3d_trim_region second = region_of(model->patches[1]);
    EXPECT_TRUE(second.contains({0.2, 0.5})); // 0.24
    EXPECT_FALSE(second.contains({0.3, 0.5}));
}

TEST(obj_trims, are_written_and_read_again) {
    std::string why;
    const auto model = read(surface + square + begin + "hole 0 4 1\nend\n", why);
    ASSERT_TRUE(model) << why;
    const auto again = read(l3d_write_obj(*model), why);
    ASSERT_TRUE(again) << why;
    EXPECT_EQ(again->patches, model->patches);
    const auto whole =
        l3d_read_obj_surfaces(surface + square + begin + "trim 0 4 1\nend\n", "name", why);
    ASSERT_TRUE(whole) << why;
    const auto rewritten = l3d_read_obj_surfaces(l3d_write_obj_surfaces(*whole), "name", why);
    ASSERT_TRUE(rewritten) << why;
    EXPECT_EQ(rewritten->at(0).trims(), whole->at(0).trims());
}

TEST(obj_trims, that_cannot_be_are_refused_by_line) {
    EXPECT_EQ(complaint(surface + square + begin + "hole 0 3 1\nend\n"),
              "name:19: trim 1 is open from (0.25, 0.75) to (0.25, 0.25)");
    EXPECT_EQ(complaint(surface + square + begin + "hole 0 4 2\nend\n"),
              "name:19: '2', an index, names none of the 1 before it");
    EXPECT_EQ(complaint(surface + square + begin + "hole 0 5 1\nend\n"),
              "name:19: the range of a curve of hole is not within its parameters");
    EXPECT_EQ(complaint(surface + square + begin + "trim 4 0 1\nend\n"),
              "name:19: the range of a curve of trim is empty");
    EXPECT_EQ(complaint(surface + square + begin + "trim 0 4\nend\n"),
              "name:19: the line ends where a curve of trim should be");
    EXPECT_EQ(complaint(surface + square + begin + "trim\nend\n"), "name:19: trim 1 has no curve");
    EXPECT_EQ(complaint(surface + square + "trim 0 4 1\n"), "name:14: trim outside of a surface");
    EXPECT_EQ(complaint("vp 0 x\n"), "name:1: 'x', a parameter, is not a number");
}

/// Two squares at a right angle, trimmed to a rectangle that begins where they meet.
const std::string hinge =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\n"
    "vp 0.25 0\nvp 0.75 0\nvp 0.75 0.75\nvp 0.25 0.75\n"
    "cstype bspline\ndeg 1\ncurv2 1 2 3 4 1\nparm u 0 0 1 2 3 4 4\nend\n"
    "cstype bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\nparm u 0 1\nparm v 0 1\ntrim 0 4 1\nend\n"
    "surf 0 1 0 1 1 2 5 6\nparm u 0 1\nparm v 0 1\ntrim 0 4 1\nend\n";

TEST(obj_connections, are_edges_that_trims_follow) {
    std::string why;
    for (const bool is_turned : {false, true}) {
        const auto model =
            read(hinge + (is_turned ? "con 1 0 1 1 2 1 0 1\n" : "con 1 0 1 1 -1 0 1 -1\n"), why);
        ASSERT_TRUE(model) << why;
        EXPECT_TRUE(model->notes.empty());
        ASSERT_EQ(model->edges.size(), 1U);
        const l3d_model_edge& edge = model->edges[0];
        EXPECT_NEAR(edge.curve.evaluate(0)[0], 0.25, 1e-15);
        EXPECT_NEAR(edge.curve.evaluate(0.5)[0], 0.5, 1e-15);
        EXPECT_NEAR(edge.curve.evaluate(1)[0], 0.75, 1e-15);
        EXPECT_EQ(edge.curve.evaluate(0.3)[1], 0);
        EXPECT_LE(edge.tolerance, 1e-15);
        ASSERT_EQ(model->patches.size(), 2U);
        for (std::size_t i = 0; i < 2; ++i) {
            const l3d_trim_loop& loop = model->patches[i].trims.at(0);
            ASSERT_EQ(loop.size(), 4U);
            EXPECT_EQ(loop[0].edge, 0U);
            EXPECT_EQ(loop[0].from, is_turned && i == 1 ? 1 : 0);
            EXPECT_EQ(loop[0].to, is_turned && i == 1 ? 0 : 1);
            for (std::size_t k = 1; k < 4; ++k)
                EXPECT_EQ(loop[k], l3d_trim_curve{loop[k].points});
        }
    }
    EXPECT_EQ(read(hinge, why)->patches.at(0).trims.at(0)[0].edge, l3d_no_edge);
}

/// The trims of a quarter of a cylinder are arcs in space.
TEST(obj_connections, have_edges_as_exact_as_they_say) {
    std::string text = hinge;
    text.replace(text.find("cstype bezier"), text.find("surf") - text.find("cstype bezier"),
                 "v 1 0 0\nv 1 1 0 0.70710678118654752\nv 0 1 0\nv 1 0 1\n"
                 "v 1 1 1 0.70710678118654752\nv 0 1 1\ncstype rat bezier\ndeg 2 1\n"
                 "surf 0 1 0 1 7 8 9 10 11 12\nparm u 0 1\nparm v 0 1\ntrim 0 4 1\nend\n"
                 "deg 1 1\n");
    std::string why;
    const auto model = read(text + "con 1 0 1 1 2 0 1 1\n", why);
    ASSERT_TRUE(model) << why;
    ASSERT_EQ(model->edges.size(), 1U);
    EXPECT_LT(model->edges[0].tolerance, 1e-8);
    for (int i = 0; i <= 50; ++i) {
        const auto p = model->edges[0].curve.evaluate(i / 50.0);
        EXPECT_NEAR(std::hypot(p[0], p[1]), 1, model->edges[0].tolerance + 1e-15);
        EXPECT_NEAR(p[2], 0, 1e-15);
    }
}

TEST(obj_connections, are_refused_by_line) {
    EXPECT_EQ(complaint(hinge + "con 1 0 1 1 3 0 1 1\n"),
              "name:28: '3', an index, names none of the 2 before it");
    EXPECT_EQ(complaint(hinge + "con 1 0 1 2 2 0 1 1\n"),
              "name:28: '2', an index, names none of the 1 before it");
    EXPECT_EQ(complaint(hinge + "con 1 0 1 1 2 0\n"),
              "name:28: the line ends where the range of a curve should be");
    EXPECT_EQ(complaint(hinge + "con 1 1 1 1 2 0 1 1\n"),
              "name:28: the range of a curve of con is empty");
    EXPECT_EQ(complaint(hinge + "con 1 0 0.5 1 2 0 1 1\n"),
              "name:28: con begins or ends between the knots of curve 1 of surface 1");
    EXPECT_EQ(complaint(hinge + "con 1 0 1 1 2 5 6 1\n"),
              "name:28: con names a range of curve 1 of surface 2 that no trim has, or that "
              "another con has");
}

} // namespace
