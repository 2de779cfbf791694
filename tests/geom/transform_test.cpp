// SPDX-License-Identifier: MIT
// Transformations: the rows of the book's table on points, vectors and matrices.
#include "geom/transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <type_traits>

namespace {

using fixed_32 = l3d_fixed<std::int64_t, 32>;

template <class T> l3d_vector<T, 3> vec(double x, double y, double z) {
    return l3d_point<T>::of(x, y, z).from_origin;
}

template <class T>
void expect_near(const l3d_vector<T, 3>& v, double x, double y, double z, double tolerance) {
    EXPECT_NEAR(l3d_to_double(v[0]), x, tolerance);
    EXPECT_NEAR(l3d_to_double(v[1]), y, tolerance);
    EXPECT_NEAR(l3d_to_double(v[2]), z, tolerance);
}
template <class T>
void expect_near(const l3d_point<T>& p, double x, double y, double z, double tolerance) {
    expect_near(p.from_origin, x, y, z, tolerance);
}

template <class T> double largest_difference(const l3d_matrix<T>& a, const l3d_matrix<T>& b) {
    double largest = 0;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            largest = std::max(largest, std::abs(l3d_to_double(a(i, j)) - l3d_to_double(b(i, j))));
    return largest;
}

template <class T> class book_transform : public testing::Test {};
using number_types = testing::Types<float, double, fixed_32>;
TYPED_TEST_SUITE(book_transform, number_types);

/// Row "Point/vector types"; what must not compile is in tests/fail/point_plus_point.cpp and
/// vector_minus_point.cpp.
TYPED_TEST(book_transform, point_vector_types) {
    using T = TypeParam;
    const auto p = l3d_point<T>::of(2, 7, 3);
    const auto q = l3d_point<T>::of(-1, 4, 9);
    static_assert(std::is_same_v<decltype(p - q), l3d_vector<T, 3>>);
    static_assert(std::is_same_v<decltype(p + (p - q)), l3d_point<T>>);
    EXPECT_EQ(p - q, vec<T>(3, 3, -6));
    EXPECT_EQ(q + (p - q), p);
    EXPECT_EQ((p - q) + q, p);
    EXPECT_EQ(p - (p - q), q);
    const auto move = l3d_translation<T>(10, 20, 30);
    EXPECT_EQ(l3d_transformed(move, p), l3d_point<T>::of(12, 27, 33));
    EXPECT_EQ(l3d_transformed(move, p - q), p - q);
}

TYPED_TEST(book_transform, vector_products) {
    using T = TypeParam;
    EXPECT_EQ(l3d_cross(vec<T>(1, 0, 0), vec<T>(0, 1, 0)), vec<T>(0, 0, 1));
    EXPECT_EQ(l3d_cross(vec<T>(0, 1, 0), vec<T>(1, 0, 0)), vec<T>(0, 0, -1));
    EXPECT_EQ(l3d_to_double(l3d_dot(vec<T>(1, 0, 0), vec<T>(1, 1, 0))), 1);
    EXPECT_EQ(l3d_to_double(l3d_length(vec<T>(2, -3, 6))), 7);
    EXPECT_EQ(l3d_normalized(vec<T>(0, 0, 0)), vec<T>(0, 0, 0)); // as documented, never stale
    expect_near(l3d_normalized(vec<T>(0.002, -0.003, 0.006)), 2 / 7., -3 / 7., 6 / 7., 1e-6);
    expect_near(l3d_normalized(vec<T>(2000, -3000, 6000)), 2 / 7., -3 / 7., 6 / 7., 1e-6);
}

TYPED_TEST(book_transform, left_handed_rotation) {
    using T = TypeParam;
    // A quarter is exact: to the last bit.
    EXPECT_EQ(l3d_transformed(l3d_rotation_z<T>(90), vec<T>(1, 0, 0)), vec<T>(0, 1, 0));
    EXPECT_EQ(l3d_transformed(l3d_rotation_x<T>(90), vec<T>(0, 1, 0)), vec<T>(0, 0, 1));
    EXPECT_EQ(l3d_transformed(l3d_rotation_y<T>(90), vec<T>(0, 0, 1)), vec<T>(1, 0, 0));
    EXPECT_EQ(l3d_rotation_z<T>(-270), l3d_rotation_z<T>(90));
    EXPECT_EQ(l3d_rotation_y<T>(3600180), l3d_rotation_y<T>(180));
    // Any angle, not only whole degrees.
    expect_near(l3d_transformed(l3d_rotation_z<T>(-0.37), vec<T>(1, 0, 0)),
                std::cos(0.37 * std::numbers::pi / 180), -std::sin(0.37 * std::numbers::pi / 180),
                0, 1e-7);
    expect_near(l3d_transformed(l3d_rotation_z<T>(150), vec<T>(2, 0, 5)), -std::sqrt(3.), 1, 5,
                1e-6);
}

TYPED_TEST(book_transform, composition_order) {
    using T = TypeParam;
    const auto turn = l3d_rotation_z<T>(90);
    const auto move = l3d_translation<T>(10, 0, 0);
    const auto p = l3d_point<T>::of(1, 0, 0);
    EXPECT_EQ(l3d_transformed(move * turn, p), l3d_point<T>::of(10, 1, 0));
    EXPECT_EQ(l3d_transformed(turn * move, p), l3d_point<T>::of(0, 11, 0));
}

/// The book's matmul: a = diag(2, 2, 2, 1), b = 1.1 to 16.16 row by row, p = (5, 6, 7, 1).
TYPED_TEST(book_transform, full_4x4_products) {
    using T = TypeParam;
    const auto a = l3d_scaling<T>(2, 2, 2);
    l3d_matrix<T> b;
    for (int i = 0; i < 16; ++i) // 9.9 is followed by 10.10
        b(i / 4, i % 4) = l3d_from_double<T>(i + 1 + (i + 1) * (i < 9 ? 0.1 : 0.01));
    const l3d_vector<T, 4> p(l3d_from_double<T>(5), l3d_from_double<T>(6), l3d_from_double<T>(7),
                             l3d_from_double<T>(1));
    const auto expect = [](const l3d_vector<T, 4>& v, double x, double y, double z, double w) {
        const double wanted[4] = {x, y, z, w};
        for (int i = 0; i < 4; ++i)
            EXPECT_NEAR(l3d_to_double(v[i]), wanted[i], 1e-4) << "component " << i;
    };
    expect(a * p, 10, 12, 14, 1);
    expect(b * p, 46.2, 129.8, 199.99, 272.70);
    expect((a * b) * p, 92.4, 259.6, 399.98, 272.70);
    expect((b * a) * p, 88, 250.8, 387.86, 529.24);

    // The projection that keeps depth: (x, y, z) to (x / z, y / z, d + 1 / z) with d = 3.
    l3d_matrix<T> perspective{};
    perspective(0, 0) = perspective(1, 1) = perspective(2, 3) = perspective(3, 2) =
        l3d_from_double<T>(1);
    perspective(2, 2) = l3d_from_double<T>(3);
    const l3d_vector<T, 4> far(l3d_from_double<T>(5), l3d_from_double<T>(-6), l3d_from_double<T>(8),
                               l3d_from_double<T>(1));
    const auto seen = l3d_homogenized(perspective * far);
    ASSERT_TRUE(seen.has_value());
    expect_near(*seen, 0.625, -0.75, 3.125, 1e-6);
    EXPECT_FALSE(l3d_homogenized(l3d_vector<T, 4>(perspective.column(0))).has_value());
}

TYPED_TEST(book_transform, arbitrary_axis) {
    using T = TypeParam;
    for (const double degrees : {-123.4, 17.0, 90.0, 110.3, 215.0, 301.5}) {
        EXPECT_LT(
            largest_difference(l3d_rotation<T>({1, 0, 0}, degrees), l3d_rotation_x<T>(degrees)),
            1e-6);
        EXPECT_LT(
            largest_difference(l3d_rotation<T>({0, 1, 0}, degrees), l3d_rotation_y<T>(degrees)),
            1e-6);
        EXPECT_LT(
            largest_difference(l3d_rotation<T>({0, 0, 1}, degrees), l3d_rotation_z<T>(degrees)),
            1e-6);
    }
    std::mt19937 random(7);
    const auto number = [&random] { return static_cast<double>(random()) / 0x1p31 - 1; };
    for (int i = 0; i < 1000; ++i) {
        const auto m = l3d_rotation<T>({number(), number(), number() + 1.5}, 180 * number());
        const auto v = vec<T>(3 * number(), 5, number());
        EXPECT_NEAR(l3d_to_double(l3d_length(l3d_transformed(m, v))), l3d_to_double(l3d_length(v)),
                    4e-6);
    }
}

TYPED_TEST(book_transform, inverse_transpose_determinant) {
    using T = TypeParam;
    std::mt19937 random(11);
    const auto number = [&random] { return static_cast<double>(random()) / 0x1p31 - 1; };
    for (int i = 0; i < 1000; ++i) {
        const auto m = l3d_translation<T>(9 * number(), 7 * number(), 8 * number()) *
                       l3d_rotation<T>({number(), 1.25, number()}, 229 * number()) *
                       l3d_scaling<T>(1.5 + number(), 1.25 - number(), -0.5 + number() / 4);
        const auto inverse = l3d_inverted(m);
        ASSERT_TRUE(inverse.has_value());
        EXPECT_LT(largest_difference(m * *inverse, l3d_identity<T>()), 1e-5);
        EXPECT_LT(largest_difference(*inverse * m, l3d_identity<T>()), 1e-4);
    }
    const auto turn = l3d_rotation<T>({1, -2, 3}, 40);
    EXPECT_LT(largest_difference(l3d_transposed(turn), *l3d_inverted(turn)), 1e-6);
    EXPECT_NEAR(l3d_determinant(turn), 1, 1e-6);
    EXPECT_NEAR(l3d_determinant(turn * l3d_scaling<T>(2, -3, 4)), -24, 1e-5);
    // Swapped rows: no pivot on the diagonal.
    l3d_matrix<T> swap{};
    swap(0, 1) = swap(1, 0) = swap(2, 3) = l3d_from_double<T>(1);
    swap(3, 2) = l3d_from_double<T>(-5);
    EXPECT_NEAR(l3d_determinant(swap), -5, 1e-6);
    EXPECT_LT(largest_difference(swap * *l3d_inverted(swap), l3d_identity<T>()), 1e-6);

    EXPECT_FALSE(l3d_inverted(l3d_matrix<T>{}).has_value());
    EXPECT_FALSE(l3d_inverted(l3d_scaling<T>(3, 0, 2)).has_value());
    l3d_matrix<T> counting;
    for (int i = 0; i < 16; ++i) // rows are multiples of (1, 1, 1, 1) and (0, 1, 2, 3): rank 2
        counting(i / 4, i % 4) = l3d_from_double<T>(i + 1);
    EXPECT_FALSE(l3d_inverted(counting).has_value());
    EXPECT_EQ(l3d_determinant(counting), 0);
}

TYPED_TEST(book_transform, rotate_and_scale_about_a_point) {
    using T = TypeParam;
    const l3d_point<double> centre(3, -2, 7);
    const auto c = l3d_point<T>::of(3, -2, 7);
    const auto turn = l3d_about(centre, l3d_rotation<T>({1, 2, -1}, 63));
    const auto grow = l3d_about(centre, l3d_scaling<T>(2, 3, 0.5));
    expect_near(l3d_transformed(turn, c), 3, -2, 7, 2e-6); // float: 4 ulp of 7
    expect_near(l3d_transformed(grow, c), 3, -2, 7, 1e-6);
    expect_near(l3d_transformed(grow, l3d_point<T>::of(4, -1, 9)), 5, 1, 8, 1e-6);
    expect_near(
        l3d_transformed(l3d_about(centre, l3d_rotation_z<T>(90)), l3d_point<T>::of(4, -2, 1)), 3,
        -1, 1, 1e-6);
}

TYPED_TEST(book_transform, coordinate_change) {
    using T = TypeParam;
    // Two systems, in neither of which the other is simple.
    const auto c = l3d_translation<T>(5, -3, 2) * l3d_rotation<T>({1, 1, 3}, 46);
    const auto d =
        l3d_translation<T>(-1, 4, 6) * l3d_rotation<T>({2, -1, 1}, -109) * l3d_scaling<T>(2, 2, 2);
    const auto change = l3d_coordinate_change(c, d);
    ASSERT_TRUE(change.has_value());
    const auto p = l3d_point<T>::of(0.5, 2, -3);
    const auto world = l3d_transformed(c, p);
    const auto again = l3d_transformed(d, l3d_transformed(*change, p));
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(l3d_to_double(again[i]), l3d_to_double(world[i]), 1e-5);
    EXPECT_FALSE(l3d_coordinate_change(c, l3d_scaling<T>(1, 0, 1)).has_value());

    const auto axes = l3d_from_axes(vec<T>(0, 1, 0), vec<T>(0, 0, 1), vec<T>(1, 0, 0),
                                    l3d_point<T>::of(10, 20, 30));
    EXPECT_EQ(l3d_transformed(axes, l3d_point<T>::of(1, 2, 3)), l3d_point<T>::of(13, 21, 32));
}

/// Row "Normals", second half: a scaling that is not the same in all directions.
TYPED_TEST(book_transform, normals_by_inverse_transpose) {
    using T = TypeParam;
    const auto normal = l3d_normalized(vec<T>(1, 1, 0));
    const auto edge = vec<T>(1, -1, 3);
    const auto squeeze = l3d_scaling<T>(0.5, 1, 1);
    const auto squeezed = l3d_transformed_normal(squeeze, normal);
    ASSERT_TRUE(squeezed.has_value());
    EXPECT_NEAR(l3d_to_double(l3d_dot(*squeezed, l3d_transformed(squeeze, edge))), 0, 1e-6);
    EXPECT_NEAR(l3d_to_double(l3d_length(*squeezed)), 1, 1e-6);
    // By the matrix itself it would not: (0.5, 1, 0) . (0.5, -1, 3) = -0.75.
    EXPECT_FALSE(l3d_transformed_normal(l3d_scaling<T>(0, 1, 1), normal).has_value());
}

/// Some thousand turns in floats, one after another.
TYPED_TEST(book_transform, axes_are_made_orthonormal_again) {
    using T = TypeParam;
    l3d_matrix<T> m = l3d_translation<T>(2, 3, 4);
    for (int i = 0; i < 2000; ++i)
        m = m * l3d_rotation_x<T>(7) * l3d_rotation_y<T>(11);
    const auto better = l3d_orthonormalized(m);
    ASSERT_TRUE(better.has_value());
    const double unit = 8 * (l3d_real_traits<T>::half_ulp + l3d_real_traits<T>::unit_roundoff);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            double dot = 0;
            for (int k = 0; k < 3; ++k)
                dot += l3d_to_double((*better)(k, i)) * l3d_to_double((*better)(k, j));
            EXPECT_NEAR(dot, i == j, unit) << i << ", " << j;
        }
    EXPECT_EQ(better->column(3), m.column(3));
    EXPECT_FALSE(l3d_orthonormalized(l3d_scaling<T>(1, 0, 1)).has_value());
}

TYPED_TEST(book_transform, vectors_and_points_are_written_as_their_numbers) {
    using T = TypeParam;
    std::ostringstream text;
    text << vec<T>(1, -2.5, 3) << l3d_point<T>::of(0, 0.25, -4) << glm::ivec2(7, 8) << '.';
    EXPECT_EQ(text.str(), "(1, -2.5, 3)(0, 0.25, -4)(7, 8).");
}

} // namespace
