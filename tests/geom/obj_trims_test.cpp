// SPDX-License-Identifier: MIT
// Trims of .obj surfaces: what is read, written again, and refused by line.
#include "geom/files/model_file.h"
#include "geom/trims/trim_region.h"

#include "model_text.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

namespace {

const std::string surface = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
const std::string square = "vp 0.25 0.25\nvp 0.75 0.25\nvp 0.75 0.75\nvp 0.25 0.75\n"
                           "cstype bspline\ndeg 1\ncurv2 1 2 3 4 1\nparm u 0 0 1 2 3 4 4\nend\n";
const std::string begin = "cstype bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\nparm u 0 1\nparm v 0 1\n";

l3d_model_file read(const std::string& text) {
    return model_text::read_by(l3d_read_obj, text, "name");
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
    const l3d_model_file model = read(surface + square + begin + "hole 0 4 1\nend\n");
    EXPECT_TRUE(model.notes.empty());
    ASSERT_EQ(model.patches.size(), 1U);
    const l3d_trim_region region = region_of(model.patches[0]);
    EXPECT_TRUE(region.contains({0.1, 0.1}));
    EXPECT_FALSE(region.contains({0.5, 0.5}));
}

TEST(obj_trims, of_a_border_leave_what_is_in_it) {
    const l3d_model_file model = read(surface + square + begin + "trim 0 2 -1 2 4 1\nend\n");
    const l3d_trim_region region = region_of(model.patches.at(0));
    EXPECT_FALSE(region.contains({0.1, 0.1}));
    EXPECT_TRUE(region.contains({0.5, 0.5}));
}

TEST(obj_trims, are_shared_out_among_pieces) {
    std::string vertices;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 5; ++i)
            vertices += "v " + std::to_string(i) + ' ' + std::to_string(j) + " 0\n";
    const l3d_model_file model = read(vertices + square +
                                      "cstype bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4 5 6 7 8 9 10\n"
                                      "parm u 0 0.2 0.4 0.9 1\nparm v 0 1\nhole 0 4 1\nend\n");
    ASSERT_EQ(model.patches.size(), 4U);
    for (const std::size_t i : {0U, 3U}) // the hole is elsewhere
        EXPECT_TRUE(region_of(model.patches[i]).within({}).is_all_of({}));
    const l3d_trim_region second = region_of(model.patches[1]);
    EXPECT_TRUE(second.contains({0.2, 0.5})); // 0.24
    EXPECT_FALSE(second.contains({0.3, 0.5}));
}

TEST(obj_trims, are_written_and_read_again) {
    const l3d_model_file model = read(surface + square + begin + "hole 0 4 1\nend\n");
    EXPECT_EQ(read(l3d_write_obj(model)).patches, model.patches);
    const auto surfaces = [](const std::string& text) {
        return model_text::read_by(l3d_read_obj_surfaces, text, "name");
    };
    const auto whole = surfaces(surface + square + begin + "trim 0 4 1\nend\n");
    EXPECT_EQ(surfaces(l3d_write_obj_surfaces(whole)).at(0).trims(), whole.at(0).trims());
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
    for (const bool is_turned : {false, true}) {
        const l3d_model_file model =
            read(hinge + (is_turned ? "con 1 0 1 1 2 1 0 1\n" : "con 1 0 1 1 -1 0 1 -1\n"));
        EXPECT_TRUE(model.notes.empty());
        ASSERT_EQ(model.edges.size(), 1U);
        const l3d_model_edge& edge = model.edges[0];
        EXPECT_NEAR(edge.curve.evaluate(0)[0], 0.25, 1e-15);
        EXPECT_NEAR(edge.curve.evaluate(0.5)[0], 0.5, 1e-15);
        EXPECT_NEAR(edge.curve.evaluate(1)[0], 0.75, 1e-15);
        EXPECT_EQ(edge.curve.evaluate(0.3)[1], 0);
        EXPECT_LE(edge.tolerance, 1e-15);
        ASSERT_EQ(model.patches.size(), 2U);
        for (std::size_t i = 0; i < 2; ++i) {
            const l3d_trim_loop& loop = model.patches[i].trims.at(0);
            ASSERT_EQ(loop.size(), 4U);
            EXPECT_EQ(loop[0].edge, 0U);
            EXPECT_EQ(loop[0].from, is_turned && i == 1 ? 1 : 0);
            EXPECT_EQ(loop[0].to, is_turned && i == 1 ? 0 : 1);
            for (std::size_t k = 1; k < 4; ++k)
                EXPECT_EQ(loop[k], l3d_trim_curve{loop[k].points});
        }
    }
    EXPECT_EQ(read(hinge).patches.at(0).trims.at(0)[0].edge, l3d_no_edge);
}

/// The trims of a quarter of a cylinder are arcs in space.
TEST(obj_connections, have_edges_as_exact_as_they_say) {
    std::string text = hinge;
    text.replace(text.find("cstype bezier"), text.find("surf") - text.find("cstype bezier"),
                 "v 1 0 0\nv 1 1 0 0.70710678118654752\nv 0 1 0\nv 1 0 1\n"
                 "v 1 1 1 0.70710678118654752\nv 0 1 1\ncstype rat bezier\ndeg 2 1\n"
                 "surf 0 1 0 1 7 8 9 10 11 12\nparm u 0 1\nparm v 0 1\ntrim 0 4 1\nend\n"
                 "deg 1 1\n");
    const l3d_model_file model = read(text + "con 1 0 1 1 2 0 1 1\n");
    ASSERT_EQ(model.edges.size(), 1U);
    EXPECT_LT(model.edges[0].tolerance, 1e-8);
    for (int i = 0; i <= 50; ++i) {
        const auto p = model.edges[0].curve.evaluate(i / 50.0);
        EXPECT_NEAR(std::hypot(p[0], p[1]), 1, model.edges[0].tolerance + 1e-15);
        EXPECT_NEAR(p[2], 0, 1e-15);
    }
}

/// Along three sides of the square, each of which is straight in space.
TEST(obj_connections, have_a_cubic_from_knot_to_knot) {
    const l3d_model_edge edge = read(hinge + "con 1 0 3 1 2 0 3 1\n").edges.at(0);
    EXPECT_EQ(edge.curve.points().size(), 10U);
    EXPECT_LE(edge.tolerance, 1e-15);
}

/// A square tube is closed along u, from 0 to 4, and its hole lies across the seam.
TEST(obj_connections, go_across_the_seam) {
    const std::string tube = "surf 0 4 0 1 1 2 3 4 1 5 6 7 8 5\nparm u 0 0 1 2 3 4 4\n"
                             "parm v 0 0 1 1\nhole 0 4 1\nend\n";
    const std::string text =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
        "vp 3.5 0.25\nvp 4.5 0.25\nvp 4.5 0.75\nvp 3.5 0.75\ncstype bspline\ndeg 1\n"
        "curv2 1 2 3 4 1\nparm u 0 0 1 2 3 4 4\nend\ndeg 1 1\n" +
        tube + tube + "con 1 0 1 1 2 0 1 1\n";
    const l3d_model_edge edge = read(text).edges.at(0);
    for (const auto& [t, x, y] : {std::array{0.25, 0.0, 0.25}, {0.5, 0.0, 0.0}, {0.75, 0.25, 0.0}})
        EXPECT_LE(l3d_length(edge.curve.evaluate(t) - l3d_vector<double, 3>{x, y, 0.25}), 1e-12);
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
    const std::string second = "cstype bspline\ndeg 1\ncurv2 1 2 3 4 1\n"
                               "parm u 0 0 1 2 3 4 4\nend\n";
    EXPECT_EQ(complaint(hinge + second + "con 1 0 1 2 2 0 1 1\n"),
              "name:33: con names a range of curve 2 of surface 1 that no trim has, or that "
              "another con has");
    EXPECT_EQ(
        complaint(model_text::with(hinge, "v 1 0 0\n", "v 0 0 0\n") + "con 1 0 1 1 2 0 1 1\n"),
        "name:28: the edge of con is a point, or beyond 1e12");
    EXPECT_EQ(complaint(hinge + "surf 0 1 0 1 1 2 3 4\ncon 1 0 1 1 2 0 1 1\n"),
              "name:29: a connection before the end of a surface or curve");
}

} // namespace
