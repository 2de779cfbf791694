// SPDX-License-Identifier: MIT
// l3d_matrix: rows and columns where they are said to be, and products in the right order.
#include "geom/matrix.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace {

using fixed_16 = l3d_fixed<std::int32_t, 16>;
using fixed_32 = l3d_fixed<std::int64_t, 32>;

template <class T> l3d_vector<T, 4> of(double x, double y, double z, double w) {
    return {l3d_from_double<T>(x), l3d_from_double<T>(y), l3d_from_double<T>(z),
            l3d_from_double<T>(w)};
}

/// Row i, column j: 10 i + j + 1/4. No two entries, and no sums of rows and columns, are alike.
template <class T> l3d_matrix<T> counting() {
    l3d_matrix<T> m;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            m(i, j) = l3d_from_double<T>(10 * i + j + 0.25);
    return m;
}

template <class T>
void expect_near(const l3d_vector<T, 4>& v, double x, double y, double z, double w) {
    using traits = l3d_real_traits<T>;
    const double tolerance = 20 * traits::half_ulp + 50 * traits::unit_roundoff;
    EXPECT_NEAR(l3d_to_double(v[0]), x, tolerance);
    EXPECT_NEAR(l3d_to_double(v[1]), y, tolerance);
    EXPECT_NEAR(l3d_to_double(v[2]), z, tolerance);
    EXPECT_NEAR(l3d_to_double(v[3]), w, tolerance);
}

template <class T> class matrix : public testing::Test {};
using number_types = testing::Types<float, double, fixed_16, fixed_32>;
TYPED_TEST_SUITE(matrix, number_types);

TYPED_TEST(matrix, has_rows_and_columns) {
    using T = TypeParam;
    const auto m = counting<T>();
    EXPECT_EQ(l3d_to_double(m(1, 3)), 13.25);
    EXPECT_EQ(m.row(1), of<T>(10.25, 11.25, 12.25, 13.25));
    EXPECT_EQ(m.column(1), of<T>(1.25, 11.25, 21.25, 31.25));
}

TYPED_TEST(matrix, is_made_of_glms_and_gives_it_back) {
    using T = TypeParam;
    const glm::dmat4 moved = glm::translate(glm::dmat4(1), glm::dvec3(2, -3, 4.25));
    const l3d_matrix<T> m = moved;
    EXPECT_EQ(m, l3d_translation<T>(2, -3, 4.25));
    const glm::mat<4, 4, T> back = counting<T>();
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(back[i], counting<T>().column(i));
}

TYPED_TEST(matrix, multiplies_a_column_vector) {
    using T = TypeParam;
    // The sum of v_j is 1/2, that of j v_j is -1 + 6 - 1.5 = 3.5; row i: (10 i + 1/4) / 2 + 3.5.
    EXPECT_EQ(counting<T>() * of<T>(-1, -1, 3, -0.5), of<T>(3.625, 8.625, 13.625, 18.625));
}

TYPED_TEST(matrix, product_applies_the_right_factor_first) {
    using T = TypeParam;
    const auto turn = l3d_rotation<T>({0, 0, 2}, 90);
    const auto move = l3d_translation<T>(3, -1, 0.5);
    const auto p = of<T>(2, 5, 7, 1);
    expect_near((move * turn) * p, -5 + 3, 2 - 1, 7.5, 1);
    expect_near((turn * move) * p, -(5 - 1), 2 + 3, 7.5, 1);
    expect_near(move * (turn * p), -2, 1, 7.5, 1);
    EXPECT_NE(move * turn, turn * move);
}

TYPED_TEST(matrix, identity_and_translation) {
    using T = TypeParam;
    EXPECT_EQ(l3d_identity<T>() * counting<T>(), counting<T>());
    EXPECT_EQ(counting<T>() * l3d_identity<T>(), counting<T>());
    const auto move = l3d_translation<T>(3, -1, 0.5);
    EXPECT_EQ(move.column(3), of<T>(3, -1, 0.5, 1));
    EXPECT_EQ(move * of<T>(2, 5, 7, 1), of<T>(5, 4, 7.5, 1));
    EXPECT_EQ(move * of<T>(2, 5, 7, 0), of<T>(2, 5, 7, 0)); // a direction
}

TYPED_TEST(matrix, rotation_is_counterclockwise_about_each_axis) {
    using T = TypeParam;
    expect_near(l3d_rotation<T>({5, 0, 0}, 90) * of<T>(2, 3, 4, 1), 2, -4, 3, 1);
    expect_near(l3d_rotation<T>({0, 5, 0}, 90) * of<T>(2, 3, 4, 1), 4, 3, -2, 1);
    expect_near(l3d_rotation<T>({0, 0, 5}, 90) * of<T>(2, 3, 4, 1), -3, 2, 4, 1);
    // A third of a turn about the diagonal exchanges the axes x -> y -> z -> x.
    expect_near(l3d_rotation<T>({1, 1, 1}, 120) * of<T>(2, 3, 4, 1), 4, 2, 3, 1);
}

TYPED_TEST(matrix, rotation_keeps_its_axis_and_all_lengths) {
    using T = TypeParam;
    const auto turn = l3d_rotation<T>({1, -2, 3}, 40);
    expect_near(turn * of<T>(1, -2, 3, 1), 1, -2, 3, 1);
    const auto p = turn * of<T>(2, -3, 6, 0);
    expect_near(of<T>(l3d_to_double(l3d_length(p)), 0, 0, 0), 7, 0, 0, 0);
}

TEST(fixed_matrix, rounds_each_component_of_a_product_once) {
    l3d_matrix<fixed_16> m{};
    m(2, 0) = m(2, 1) = m(2, 3) = fixed_16(0.5);
    const auto odd = fixed_16::from_raw(1);
    // Three halves of a step are 1.5, to even 2; each alone is 0.
    EXPECT_EQ((m * l3d_vector<fixed_16, 4>{odd, odd, odd, odd})[2].raw(), 2);
    l3d_matrix<fixed_16> b{};
    b(0, 1) = b(1, 1) = b(3, 1) = odd;
    EXPECT_EQ((m * b)(2, 1).raw(), 2);
}

TYPED_TEST(matrix, adds_and_subtracts) {
    using T = TypeParam;
    const auto m = counting<T>(), one = l3d_identity<T>();
    EXPECT_EQ(l3d_to_double((m + one)(2, 2)), 23.25);
    EXPECT_EQ(l3d_to_double((m - one)(2, 2)), 21.25);
    EXPECT_EQ(m + one - m, one);
}

} // namespace
