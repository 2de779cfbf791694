// SPDX-License-Identifier: MIT
// NURBS surfaces as .obj text: the same numbers come back, and the same patches as by l3d_read_obj.

#include "geom/files/model_file.h"
#include "geom/nurbs_surface.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using vector = l3d_nurbs_surface::vector;

/// Polynomial and rational, clamped and periodic, with a part of its range, and numbers that need
/// all digits.
std::vector<l3d_nurbs_surface> some_surfaces() {
    std::vector<l3d_nurbs_surface> result = l3d_torus_surfaces();
    std::vector<vector> points;
    for (int i = 0; i < 7 * 4; ++i)
        points.push_back({i / 3.0, -0.1 * i, 1e-9 * i * i - 0.0});
    l3d_bspline_direction u = l3d_bspline_direction::periodic(2, 7);
    u.from = 0.1;
    result.push_back({u, l3d_bspline_direction::clamped(3, 4), points});
    result.push_back(
        {u, l3d_bspline_direction::clamped(1, 4), points, std::vector<double>(points.size(), 1)});
    return result;
}

void expect_equal(const l3d_bspline_direction& a, const l3d_bspline_direction& b) {
    EXPECT_EQ(a.degree, b.degree);
    EXPECT_EQ(a.knots, b.knots);
    EXPECT_EQ(a.from, b.from);
    EXPECT_EQ(a.to, b.to);
}

TEST(surface_file, what_is_written_is_read_bit_for_bit) {
    const std::vector<l3d_nurbs_surface> wanted = some_surfaces();
    std::string why;
    const auto found = l3d_read_obj_surfaces(l3d_write_obj_surfaces(wanted), "it", why);
    ASSERT_TRUE(found) << why;
    ASSERT_EQ(found->size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        expect_equal((*found)[i].u(), wanted[i].u());
        expect_equal((*found)[i].v(), wanted[i].v());
        EXPECT_EQ((*found)[i].points(), wanted[i].points());
        EXPECT_EQ((*found)[i].weights(), wanted[i].weights());
    }
}

TEST(surface_file, their_pieces_are_the_patches_of_the_model) {
    const std::string text = l3d_write_obj_surfaces(some_surfaces());
    std::string why;
    const auto model = l3d_read_obj(text, "it", why);
    ASSERT_TRUE(model) << why;
    std::vector<l3d_patch_points> pieces;
    for (const l3d_nurbs_surface& surface : some_surfaces())
        for (const l3d_patch_points& piece : surface.pieces())
            pieces.push_back(piece);
    EXPECT_EQ(model->patches, pieces);
    EXPECT_TRUE(model->mesh.vertices.empty());
}

TEST(surface_file, a_file_without_surfaces_has_none_and_a_bad_one_is_refused_by_line) {
    std::string why;
    const auto none = l3d_read_obj_surfaces("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "it", why);
    ASSERT_TRUE(none) << why;
    EXPECT_TRUE(none->empty());
    std::string text = l3d_write_obj_surfaces(some_surfaces());
    text += "surf 0 1\n";
    EXPECT_FALSE(l3d_read_obj_surfaces(text, "it", why));
    EXPECT_EQ(why.rfind("it:", 0), 0u) << why;
}

TEST(surface_file, a_patch_is_a_surface_of_one_span) {
    const l3d_patch_points patch{
        2,
        1,
        {{0, 0, 0}, {1, 0.1, 0}, {2, 0, 0.3}, {0, 1, 0}, {1, 1, 0}, {2, 1, 1e-5}},
        {1, 0.7, 1, 1, 2, 1}};
    const l3d_nurbs_surface surface = l3d_nurbs_surface::of_patch(patch);
    EXPECT_EQ(surface.pieces(), std::vector{patch});
}

TEST(surface_file, a_weight_makes_all_weights_numbers) {
    l3d_patch_points patch{1, 1, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {}};
    l3d_nurbs_surface surface = l3d_nurbs_surface::of_patch(patch);
    surface.set_point(2, {0, 2, 0}, 1);
    EXPECT_TRUE(surface.weights().empty());
    surface.set_point(1, {1, 0, 0}, 3);
    EXPECT_EQ(surface.weights(), (std::vector<double>{1, 3, 1, 1}));
    EXPECT_EQ(surface.points()[2], vector(0, 2, 0));
}

} // namespace
