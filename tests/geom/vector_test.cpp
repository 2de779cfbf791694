// SPDX-License-Identifier: MIT
// l3d_vector: one interface for all number types; sums of products rounded once in fixed point.
#include "geom/vector.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <type_traits>

namespace {

using l3d_detail::int128;
using fixed_16 = l3d_fixed<std::int32_t, 16>;
using fixed_32 = l3d_fixed<std::int64_t, 32, l3d_overflow::saturate>;

template <class T> l3d_vector<T, 3> of(double x, double y, double z) {
    return {l3d_from_double<T>(x), l3d_from_double<T>(y), l3d_from_double<T>(z)};
}

template <class T> class vector : public testing::Test {};
using numbers = testing::Types<float, double, fixed_16, fixed_32>;
TYPED_TEST_SUITE(vector, numbers);

TYPED_TEST(vector, has_components_sums_and_multiples) {
    using T = TypeParam;
    const auto a = of<T>(1.5, -2.25, 3);
    const auto b = of<T>(-0.5, 4, 2.75);
    EXPECT_EQ(l3d_to_double(a[1]), -2.25);
    EXPECT_EQ(a + b, of<T>(1, 1.75, 5.75));
    EXPECT_EQ(a - b, of<T>(2, -6.25, 0.25));
    EXPECT_EQ(-a, of<T>(-1.5, 2.25, -3));
    EXPECT_EQ(a * l3d_from_double<T>(2.5), of<T>(3.75, -5.625, 7.5));
    EXPECT_NE(a, b);
    EXPECT_EQ((l3d_vector<T, 3>{}), of<T>(0, 0, 0));
    const l3d_vector<T, 4> four{a, b[2]};
    EXPECT_EQ(-four, (l3d_vector<T, 4>{-a, -b[2]}));
}

TYPED_TEST(vector, is_that_of_glm_in_any_number_type) {
    using T = TypeParam;
    static_assert(std::is_same_v<l3d_vector<T, 3>, glm::vec<3, T>>);
    static_assert(sizeof(l3d_vector<T, 3>) == 3 * sizeof(T));
    const auto v = of<T>(1.5, -2.25, 3);
    EXPECT_EQ(v.x, v[0]);
    EXPECT_EQ(v.z, l3d_from_double<T>(3));
    if constexpr (!l3d_is_fixed<T>) {
        const glm::vec<3, T> w(-0.5, 4, 2.75);
        EXPECT_EQ(glm::dot(v, w), l3d_dot(v, w));
        EXPECT_EQ(glm::cross(v, w), l3d_cross(v, w));
        EXPECT_NEAR(glm::length(v), l3d_length(v), 1e-6);
    }
}

TYPED_TEST(vector, multiplies) {
    using T = TypeParam;
    const auto a = of<T>(1.5, -2.25, 3);
    const auto b = of<T>(-0.5, 4, 2.75);
    // 1.5 (-0.5) - 2.25 (4) + 3 (2.75) = -0.75 - 9 + 8.25; all exact in 16 fraction bits.
    EXPECT_EQ(l3d_to_double(l3d_dot(a, b)), -1.5);
    EXPECT_EQ(l3d_cross(a, b), of<T>(-18.1875, -5.625, 4.875));
    EXPECT_EQ(l3d_cross(b, a), of<T>(18.1875, 5.625, -4.875));
}

TYPED_TEST(vector, has_a_length_in_two_to_four_dimensions) {
    using T = TypeParam;
    const auto t = [](double value) { return l3d_from_double<T>(value); };
    EXPECT_EQ(l3d_to_double(l3d_length(l3d_vector<T, 2>{t(-1.25), t(3)})), 3.25);
    EXPECT_EQ(l3d_to_double(l3d_length(of<T>(2, -3, 6))), 7);
    EXPECT_EQ(l3d_to_double(l3d_length(l3d_vector<T, 4>{t(1), t(5), t(-7), t(5)})), 10);
    EXPECT_EQ(l3d_to_double(l3d_dot(l3d_vector<T, 4>{t(1), t(5), t(-7), t(5)},
                                    l3d_vector<T, 4>{t(2), t(3), t(4), t(0.5)})),
              -8.5);
}

TYPED_TEST(vector, is_normalized_to_length_one_or_stays_zero) {
    using T = TypeParam;
    using traits = l3d_real_traits<T>;
    const auto n = l3d_normalized(of<T>(2, -3, 6));
    const double tolerance = 1.5 * traits::half_ulp + 4 * traits::unit_roundoff;
    EXPECT_NEAR(l3d_to_double(n[0]), 2.0 / 7, tolerance);
    EXPECT_NEAR(l3d_to_double(n[1]), -3.0 / 7, tolerance);
    EXPECT_NEAR(l3d_to_double(n[2]), 6.0 / 7, tolerance);
    EXPECT_EQ(l3d_normalized(of<T>(0, 0, 0)), of<T>(0, 0, 0));
}

TYPED_TEST(vector, converts_to_another_number_type) {
    const auto a = of<TypeParam>(1.5, -2.25, 3);
    EXPECT_EQ(l3d_converted<double>(a), of<double>(1.5, -2.25, 3));
    EXPECT_EQ(l3d_converted<fixed_16>(a), of<fixed_16>(1.5, -2.25, 3));
}

TEST(fixed_vector, rounds_a_dot_product_once_and_not_each_product) {
    // Three products of 0.75, 0.5 and 0.5 steps: 1.75, to nearest 2; rounded one by one 1 + 0 + 0.
    const auto tiny = [](int raw) { return fixed_16::from_raw(raw); };
    const l3d_vector<fixed_16, 3> a{tiny(3), tiny(2), tiny(1)};
    const auto b = of<fixed_16>(0.25, 0.25, 0.5);
    EXPECT_EQ((a[0] * b[0] + a[1] * b[1] + a[2] * b[2]).raw(), 1);
    EXPECT_EQ(l3d_dot(a, b).raw(), 2);
}

TEST(fixed_vector, rounds_a_cross_product_once) {
    const auto tiny = [](int raw) { return fixed_16::from_raw(raw); };
    // y z' - z y' = 0.5 + 0.5 = 1 step; one by one 0 - 0.
    const l3d_vector<fixed_16, 3> a{tiny(9), tiny(2), tiny(1)};
    const auto b = of<fixed_16>(1, -0.5, 0.25);
    EXPECT_EQ(l3d_cross(a, b)[0].raw(), 1);
}

TEST(fixed_vector, dot_product_outlives_overflowing_partial_sums) {
    const auto end = fixed_32::max();
    const l3d_vector<fixed_32, 4> a{end, end, end, fixed_32(2.5)};
    const l3d_vector<fixed_32, 4> b{end, -end, fixed_32(0), fixed_32(-3)};
    EXPECT_EQ(l3d_dot(a, b), fixed_32(-7.5));
    const l3d_vector<fixed_32, 4> c{end, end, -end, fixed_32(-3)};
    EXPECT_EQ(l3d_dot(a, c), fixed_32::max());
    EXPECT_EQ(l3d_dot(a, -c), -fixed_32::max() - fixed_32::epsilon());
}

TEST(fixed_vector, length_is_the_nearest_there_is) {
    constexpr unsigned seed = 41;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    for (int i = 0; i < 100'000; ++i) {
        l3d_vector<l3d_fixed<std::int32_t, 11, l3d_overflow::saturate>, 3> v{};
        int128 squares = 0;
        for (int k = 0; k < 3; ++k) {
            const auto raw = static_cast<std::int32_t>(random()) >> (random() % 31);
            v[k] = v[k].from_raw(raw);
            squares += int128{raw} * raw;
        }
        const int128 length = l3d_length(v).raw();
        if (squares < int128{1} << 62) {
            // (2 length - 1)^2 <= 4 squares <= (2 length + 1)^2, in integers.
            ASSERT_LE(4 * length * length - 4 * length + 1, 4 * squares + (length == 0));
            ASSERT_GE(4 * length * length + 4 * length + 1, 4 * squares);
        } else if (squares > int128{1} << 63) {
            ASSERT_EQ(length, std::numeric_limits<std::int32_t>::max());
        }
    }
}

TEST(fixed_vector, length_is_right_at_the_ends_of_64_bits) {
    using fixed = l3d_fixed<std::int64_t, 20, l3d_overflow::saturate>;
    const auto raw = [](std::int64_t value) { return fixed::from_raw(value); };
    constexpr std::int64_t unit = std::int64_t{1} << 60;
    EXPECT_EQ(l3d_length(l3d_vector<fixed, 2>{raw(3 * unit), raw(-4 * unit)}).raw(), 5 * unit);
    EXPECT_EQ(l3d_length(l3d_vector<fixed, 3>{raw(2 * unit), raw(-6 * unit), raw(3 * unit)}).raw(),
              7 * unit);
    EXPECT_EQ(l3d_length(l3d_vector<fixed, 2>{raw(0), fixed::min()}), fixed::max());
    const l3d_vector<fixed, 4> corner{fixed::min(), fixed::min(), fixed::min(), fixed::min()};
    EXPECT_EQ(l3d_length(corner), fixed::max());
    EXPECT_EQ(l3d_normalized(corner)[2], fixed(-0.5));
    using wrapping = l3d_fixed<std::int64_t, 20>; // length 2^64 is 0 modulo 2^64
    EXPECT_EQ(l3d_length(l3d_vector<wrapping, 4>{wrapping::min(), wrapping::min(), wrapping::min(),
                                                 wrapping::min()})
                  .raw(),
              0);
}

template <class Fixed> void expect_exact_directions(int largest_shift) {
    constexpr unsigned seed = 9;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    for (int i = 0; i < 20'000; ++i) {
        l3d_vector<Fixed, 3> v{};
        long double exact[3];
        long double squares = 0;
        const auto shift = random() % static_cast<unsigned>(largest_shift);
        for (int k = 0; k < 3; ++k) {
            const auto raw = static_cast<typename Fixed::storage>(random());
            v[k] = Fixed::from_raw(static_cast<typename Fixed::storage>(raw >> shift));
            exact[k] = static_cast<long double>(v[k].raw());
            squares += exact[k] * exact[k];
        }
        if (squares == 0)
            continue;
        const auto n = l3d_normalized(v);
        for (int k = 0; k < 3; ++k) {
            const long double steps =
                std::ldexp(exact[k] / std::sqrt(squares), Fixed::fraction_bits);
            ASSERT_LE(std::abs(steps - static_cast<long double>(n[k].raw())), 0.51L) << i;
        }
    }
}

TEST(fixed_vector, normalized_is_as_good_for_vectors_of_a_few_steps) {
    expect_exact_directions<l3d_fixed<std::int32_t, 16>>(30);
    expect_exact_directions<l3d_fixed<std::int64_t, 32>>(62);
    expect_exact_directions<l3d_fixed<std::int8_t, 5>>(7);
}

} // namespace
