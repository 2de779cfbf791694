// SPDX-License-Identifier: MIT
// l3d_plane: sides, crossings, and planes that three points do not make.
#include "geom/plane.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using fixed_32 = l3d_fixed<std::int64_t, 32>;

template <class T> class book_plane : public testing::Test {};
using number_types = testing::Types<float, double, fixed_32>;
TYPED_TEST_SUITE(book_plane, number_types);

TYPED_TEST(book_plane, plane) {
    using T = TypeParam;
    using point = l3d_point<T>;
    const l3d_plane<T> at_5{point::of(0, 0, 1).from_origin, l3d_from_double<T>(-5)};
    EXPECT_EQ(l3d_to_double(at_5.side_of_point(point::of(0, 0, 8))), 3);
    EXPECT_EQ(l3d_to_double(at_5.side_of_point(point::of(7, -9, 1))), -4);
    EXPECT_EQ(l3d_to_double(at_5.flipped().side_of_point(point::of(7, -9, 1))), 4);

    EXPECT_FALSE(at_5.crossing(point::of(1, 2, 3), point::of(-4, 9, 3)).has_value());
    const auto inside = at_5.crossing(point::of(1, 2, 9), point::of(5, -6, 1));
    ASSERT_TRUE(inside.has_value());
    EXPECT_EQ(l3d_to_double(inside->t), 0.5);
    EXPECT_EQ(inside->at, point::of(3, -2, 5));
    EXPECT_TRUE(inside->from_front);
    const auto before = at_5.crossing(point::of(1, 2, 3), point::of(2, 2, 1));
    ASSERT_TRUE(before.has_value());
    EXPECT_EQ(l3d_to_double(before->t), -1); // a line, not a segment
    EXPECT_EQ(before->at, point::of(0, 2, 5));
    EXPECT_FALSE(before->from_front);
}

TYPED_TEST(book_plane, through_a_point_and_through_three) {
    using T = TypeParam;
    using point = l3d_point<T>;
    const auto slanted = l3d_plane<T>::through(point::of(4, 1, 2), point::of(2, -3, 6).from_origin);
    EXPECT_NEAR(l3d_to_double(l3d_length(slanted.normal)), 1, 1e-6);
    EXPECT_NEAR(l3d_to_double(slanted.side_of_point(point::of(4, 1, 2))), 0, 1e-6);
    EXPECT_NEAR(l3d_to_double(slanted.side_of_point(point::of(6, -2, 8))), 7, 1e-6);
    // d is the way from the plane to the origin: -(8 - 3 + 12) / 7.
    EXPECT_NEAR(l3d_to_double(slanted.d), -17 / 7., 1e-6);

    // Clockwise for one who looks along +z in left-handed axes: he sees the front.
    const auto three =
        l3d_plane<T>::through(point::of(1, 1, 5), point::of(1, 3, 5), point::of(4, 1, 5));
    ASSERT_TRUE(three.has_value());
    EXPECT_EQ(three->normal, point::of(0, 0, -1).from_origin);
    EXPECT_EQ(l3d_to_double(three->side_of_point(point::of(0, 0, 0))), 5);
}

/// Row "Degenerate polygons", of three corners.
TYPED_TEST(book_plane, collinear_points_make_none) {
    using T = TypeParam;
    using point = l3d_point<T>;
    const auto through = [](const point& a, const point& b, const point& c) {
        return l3d_plane<T>::through(a, b, c).has_value();
    };
    EXPECT_FALSE(through(point::of(1, 2, 3), point::of(2, 4, 5), point::of(5, 10, 11)));
    EXPECT_FALSE(through(point::of(1, 2, 3), point::of(1, 2, 3), point::of(5, 1, 1)));
    EXPECT_FALSE(through(point::of(1, 2, 3), point::of(1, 2, 3), point::of(1, 2, 3)));
    EXPECT_TRUE(through(point::of(1, 2, 3), point::of(2, 4, 5), point::of(5, 10, 11.1)));
    EXPECT_TRUE(through(point::of(1000, 0, 0), point::of(1000, 0.01, 0), point::of(1000, 0, 9)));
}

} // namespace
