// SPDX-License-Identifier: MIT
// Lines clipped to a window, against the plain way: cut off at one border after the other.
#include "geom/line_clip.h"

#include "geom/random.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace {

template <class T> class line_clip : public testing::Test {};
using numbers_tested = testing::Types<float, double, l3d_fixed<std::int64_t, 32>>;
TYPED_TEST_SUITE(line_clip, numbers_tested);

template <class T> l3d_position<T> position(double x, double y) {
    return {l3d_from_double<T>(x), l3d_from_double<T>(y)};
}

struct line {
    long double x[2], y[2];
};

/// Keeps what has sign * (coordinate - border) >= 0.
bool cut(long double (&coordinate)[2], long double (&other)[2], long double border, int sign) {
    const long double from = sign * (coordinate[0] - border);
    const long double to = sign * (coordinate[1] - border);
    if (from < 0 && to < 0)
        return false;
    if (from < 0 || to < 0) {
        const int end = from < 0 ? 0 : 1;
        other[end] = other[0] + (other[1] - other[0]) * from / (from - to);
        coordinate[end] = border;
    }
    return true;
}

} // namespace

TYPED_TEST(line_clip, is_the_part_in_the_window) {
    l3d_random random(31);
    const auto least = position<TypeParam>(3.25, 5.5);
    const auto most = position<TypeParam>(319.75, 199.5);
    const double unit =
        l3d_real_traits<TypeParam>::unit_roundoff * 1000 + 2 * l3d_real_traits<TypeParam>::half_ulp;
    int visible = 0;
    for (int i = 0; i < 100000; ++i) {
        const auto any = [&] {
            return position<TypeParam>(700 * random.fraction() - 200,
                                       500 * random.fraction() - 150);
        };
        const auto from = any();
        const auto to = i % 7 == 0 ? l3d_position<TypeParam>(from[0], any()[1]) : any();
        line slow{{l3d_to_double(from[0]), l3d_to_double(to[0])},
                  {l3d_to_double(from[1]), l3d_to_double(to[1])}};
        const bool wanted = cut(slow.x, slow.y, 3.25L, 1) && cut(slow.x, slow.y, 319.75L, -1) &&
                            cut(slow.y, slow.x, 5.5L, 1) && cut(slow.y, slow.x, 199.5L, -1);
        auto a = from;
        auto b = to;
        const bool found = l3d_clip_line<TypeParam>(a, b, least, most);
        ASSERT_EQ(found, wanted) << "line " << i;
        if (!found) {
            ASSERT_TRUE(a == from && b == to) << "line " << i;
            continue;
        }
        ++visible;
        for (const auto& end : {a, b})
            for (int axis = 0; axis < 2; ++axis)
                ASSERT_TRUE(end[axis] >= least[axis] && end[axis] <= most[axis]) << "line " << i;
        ASSERT_NEAR(l3d_to_double(a[0]), static_cast<double>(slow.x[0]), unit) << "line " << i;
        ASSERT_NEAR(l3d_to_double(a[1]), static_cast<double>(slow.y[0]), unit) << "line " << i;
        ASSERT_NEAR(l3d_to_double(b[0]), static_cast<double>(slow.x[1]), unit) << "line " << i;
        ASSERT_NEAR(l3d_to_double(b[1]), static_cast<double>(slow.y[1]), unit) << "line " << i;
    }
    EXPECT_GT(visible, 30000);
    EXPECT_LT(visible, 70000);
}

TYPED_TEST(line_clip, points_and_touching_lines) {
    const auto least = position<TypeParam>(2, 3);
    const auto most = position<TypeParam>(9, 7);
    const auto clipped = [&](double x0, double y0, double x1, double y1) {
        auto from = position<TypeParam>(x0, y0);
        auto to = position<TypeParam>(x1, y1);
        return l3d_clip_line<TypeParam>(from, to, least, most);
    };
    EXPECT_TRUE(clipped(5, 5, 5, 5));
    EXPECT_FALSE(clipped(1, 5, 1, 5));
    EXPECT_TRUE(clipped(2, 0, 2, 10));
    EXPECT_TRUE(clipped(1, 8, 3, 6)); // through the corner (2, 7)
    EXPECT_FALSE(clipped(1, 7.5, 2.5, 9));
    EXPECT_FALSE(clipped(0, 5, 1.5, 5));
}

TEST(line_clip_floating, what_is_not_finite_is_nowhere) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const l3d_position<double> least(2, 3), most(9, 7);
    constexpr double inf = std::numeric_limits<double>::infinity();
    for (const double value : {nan, inf, -inf})
        for (int odd = 0; odd < 4; ++odd) {
            double ends[4] = {3, 4, 5, 6};
            ends[odd] = value;
            l3d_position<double> from(ends[0], ends[1]), to(ends[2], ends[3]);
            EXPECT_FALSE(l3d_clip_line<double>(from, to, least, most)) << value << ' ' << odd;
        }
}
