// SPDX-License-Identifier: MIT
// Clipping makes corners whose normals are of length 1, as the shading takes for granted, and
// leaves nothing of what lies in a plane.
#include "dice/near_clip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

l3d_dice_view view_of() {
    l3d_dice_view view;
    view.size = {100, 100};
    view.near = 1;
    view.far = 9;
    return view;
}

l3d_clip_vertex vertex(double x, double y, double w, float nx, float ny, float nz) {
    l3d_clip_vertex result = l3d_canonical_vertex({x, y, w}, view_of());
    result.dice.vertex.normal[0] = nx;
    result.dice.vertex.normal[1] = ny;
    result.dice.vertex.normal[2] = nz;
    return result;
}

/// Their lengths, of all corners of what is left of a triangle with one corner behind near.
std::vector<double> lengths(const float (&behind)[3], const float (&before)[3]) {
    l3d_diced_piece out;
    l3d_clip_triangle(vertex(0, 0, -3, behind[0], behind[1], behind[2]),
                      vertex(30, 0, 5, before[0], before[1], before[2]),
                      vertex(0, 30, 4, before[0], before[1], before[2]), view_of(), out);
    std::vector<double> result;
    for (std::size_t i = 0; i < out.part.triangles.count; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto v = out.part.triangles.vertex(i, k);
            result.push_back(std::sqrt(double{v.normal[0]} * v.normal[0] +
                                       double{v.normal[1]} * v.normal[1] +
                                       double{v.normal[2]} * v.normal[2]));
        }
    return result;
}

TEST(near_clip, makes_unit_normals_of_unit_normals) {
    const auto all = lengths({1, 0, 0}, {0, 0.6F, 0.8F});
    ASSERT_EQ(all.size(), 6u);
    for (const double length : all)
        EXPECT_NEAR(length, 1, 1e-6);
}

TEST(near_clip, makes_no_normal_where_there_is_none) {
    for (const double length : lengths({0, 0, 0}, {0, 0.6F, 0.8F}))
        EXPECT_LE(length, 1 + 1e-6);
    for (const double length : lengths({0, -0.6F, -0.8F}, {0, 0.6F, 0.8F}))
        EXPECT_TRUE(std::isfinite(length));
}

std::size_t triangles_left(double w0, double w1, double w2) {
    l3d_diced_piece out;
    l3d_clip_triangle(vertex(0, 0, w0, 0, 0, 1), vertex(30, 0, w1, 0, 0, 1),
                      vertex(0, 30, w2, 0, 0, 1), view_of(), out);
    return out.part.triangles.count;
}

/// Edges in the near or the far plane are chords of any length: slits there would show them.
TEST(near_clip, leaves_nothing_that_lies_in_a_plane) {
    for (const double in : {1.0, 9.0}) {
        EXPECT_EQ(triangles_left(in, in, in), 0u) << in;
        EXPECT_EQ(triangles_left(in, in, in < 5 ? -3 : 12), 0u) << in;
        EXPECT_GT(triangles_left(in, in, 5), 0u) << in;
    }
}

} // namespace
