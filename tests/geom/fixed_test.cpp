// SPDX-License-Identifier: MIT
// l3d_fixed against plain integer arithmetic: every 8-bit pair, many random 32- and 64-bit ones.
#include "geom/real.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <type_traits>

namespace {

using l3d_detail::int128;
using enum l3d_overflow;

#if defined(__SANITIZE_ADDRESS__)
constexpr int random_pairs = 300'000;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr int random_pairs = 300'000;
#else
constexpr int random_pairs = 10'000'000;
#endif
#else
constexpr int random_pairs = 10'000'000;
#endif

/// numerator / denominator to nearest, ties to even, from the floor up.
int128 rounded(int128 numerator, int128 denominator) {
    if (denominator < 0) {
        numerator = -numerator;
        denominator = -denominator;
    }
    int128 floor = numerator / denominator;
    int128 rest = numerator % denominator;
    if (rest < 0) {
        --floor;
        rest += denominator;
    }
    const bool up = 2 * rest > denominator || (2 * rest == denominator && floor % 2 != 0);
    return up ? floor + 1 : floor;
}

/// The result of the model: a raw value, or nothing where the policy is to trap.
template <class Fixed> std::optional<int128> fitted(int128 exact) {
    const int128 low = Fixed::min().raw();
    const int128 high = Fixed::max().raw();
    if (exact >= low && exact <= high)
        return exact;
    if (Fixed::overflow == trap)
        return std::nullopt;
    if (Fixed::overflow == saturate)
        return exact < low ? low : high;
    const int128 modulus = high - low + 1;
    const int128 residue = ((exact - low) % modulus + modulus) % modulus;
    return low + residue;
}

template <class Fixed> std::optional<int128> quotient(int128 a, int128 b) {
    if (b != 0)
        return fitted<Fixed>(rounded(a * (int128{1} << Fixed::fraction_bits), b));
    if (Fixed::overflow == wrap)
        return 0;
    if (Fixed::overflow == trap)
        return std::nullopt;
    return a == 0 ? int128{0} : fitted<Fixed>(a < 0 ? Fixed::min().raw() : Fixed::max().raw());
}

/// Runs operations, keeps the first that is not what the model says.
template <class Fixed> class judge {
public:
    using storage = typename Fixed::storage;

    template <class Operation>
    void compare(const char* name, std::optional<int128> expected, Operation operation) {
        if (!expected)
            return;
        ++checked_;
        const Fixed result = operation();
        if (result.raw() != *expected && wrong_++ == 0)
            first_ = std::string(name) + " of raw " + std::to_string(a_) + " and " +
                     std::to_string(b_) + " is " + std::to_string(result.raw()) + ", not " +
                     std::to_string(static_cast<std::int64_t>(*expected));
    }

    void pair(storage a, storage b) {
        a_ = a;
        b_ = b;
        const Fixed x = Fixed::from_raw(a);
        const Fixed y = Fixed::from_raw(b);
        const int128 p = a;
        const int128 q = b;
        const int128 one = int128{1} << Fixed::fraction_bits;
        compare("sum", fitted<Fixed>(p + q), [&] { return x + y; });
        compare("difference", fitted<Fixed>(p - q), [&] { return x - y; });
        compare("product", fitted<Fixed>(rounded(p * q, one)), [&] { return x * y; });
        compare("quotient", quotient<Fixed>(p, q), [&] { return x / y; });
        compare("midpoint", rounded(p + q, 2), [&] { return l3d_midpoint(x, y); });
        compare("order", (p < q) + 2 * (p == q) + 4 * (p > q), [&] {
            return Fixed::from_raw(static_cast<storage>((x < y) + 2 * (x == y) + 4 * (x > y)));
        });
    }

    void single(storage a) {
        a_ = a;
        b_ = 0;
        const Fixed x = Fixed::from_raw(a);
        const int128 p = a;
        compare("negation", fitted<Fixed>(-p), [&] { return -x; });
        compare("half", rounded(p, 2), [&] { return x.halved(); });
        const int128 one = int128{1} << Fixed::fraction_bits;
        EXPECT_EQ(x.round_to_int(), static_cast<std::int64_t>(rounded(p, one)));
        EXPECT_EQ(x.floor_to_int(), static_cast<std::int64_t>((p - ((p % one + one) % one)) / one));
        for (int n = 0; n < static_cast<int>(8 * sizeof(storage)); ++n) {
            compare("left shift", fitted<Fixed>(p * (int128{1} << n)), [&] { return x << n; });
            compare("right shift", rounded(p, int128{1} << n), [&] { return x >> n; });
        }
    }

    void conclude(long least) const {
        EXPECT_EQ(wrong_, 0) << first_;
        EXPECT_GE(checked_, least);
    }

private:
    storage a_ = 0, b_ = 0;
    long checked_ = 0, wrong_ = 0;
    std::string first_;
};

template <class Fixed> class every_8_bit_value : public testing::Test {};
using formats_8 =
    testing::Types<l3d_fixed<std::int8_t, 1, wrap>, l3d_fixed<std::int8_t, 3, wrap>,
                   l3d_fixed<std::int8_t, 7, wrap>, l3d_fixed<std::int8_t, 1, saturate>,
                   l3d_fixed<std::int8_t, 3, saturate>, l3d_fixed<std::int8_t, 7, saturate>,
                   l3d_fixed<std::int8_t, 1, trap>, l3d_fixed<std::int8_t, 3, trap>,
                   l3d_fixed<std::int8_t, 7, trap>>;
TYPED_TEST_SUITE(every_8_bit_value, formats_8);

TYPED_TEST(every_8_bit_value, and_every_pair_agrees_with_integers) {
    judge<TypeParam> judge;
    for (int a = -128; a <= 127; ++a) {
        judge.single(static_cast<std::int8_t>(a));
        for (int b = -128; b <= 127; ++b)
            judge.pair(static_cast<std::int8_t>(a), static_cast<std::int8_t>(b));
    }
    judge.conclude(65536 * 3);
}

TYPED_TEST(every_8_bit_value, is_reached_from_doubles_with_the_stated_rounding) {
    const double step = static_cast<double>(TypeParam::epsilon());
    for (int eighths = -8 * 700; eighths <= 8 * 700; ++eighths) {
        const auto expected = fitted<TypeParam>(rounded(eighths, 8));
        if (expected) {
            EXPECT_EQ(TypeParam(eighths * step / 8).raw(), *expected) << eighths;
        }
    }
    for (int a = -128; a <= 127; ++a)
        EXPECT_EQ(static_cast<double>(TypeParam::from_raw(static_cast<std::int8_t>(a))), a * step);
}

TYPED_TEST(every_8_bit_value, is_reached_from_integers) {
    for (int a = -300; a <= 300; ++a) {
        const auto expected = fitted<TypeParam>(a * (1 << TypeParam::fraction_bits));
        if (expected) {
            EXPECT_EQ(TypeParam(a).raw(), *expected) << a;
        }
    }
}

template <class Fixed> class random_value : public testing::Test {};
using formats_large =
    testing::Types<l3d_fixed<std::int32_t, 16, wrap>, l3d_fixed<std::int32_t, 31, saturate>,
                   l3d_fixed<std::int32_t, 9, trap>, l3d_fixed<std::int64_t, 32, wrap>,
                   l3d_fixed<std::int64_t, 63, saturate>, l3d_fixed<std::int64_t, 17, trap>>;
TYPED_TEST_SUITE(random_value, formats_large);

TYPED_TEST(random_value, and_pair_agrees_with_wider_integers) {
    using storage = typename TypeParam::storage;
    constexpr unsigned seed = 20061;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    // All magnitudes alike: a random number of leading bits is dropped.
    const auto draw = [&] {
        const auto shift = random() % (8 * sizeof(storage));
        return static_cast<storage>(static_cast<storage>(random()) >> shift);
    };
    judge<TypeParam> judge;
    for (int i = 0; i < random_pairs; ++i)
        judge.pair(draw(), draw());
    for (int i = 0; i < 1000; ++i)
        judge.single(draw());
    judge.conclude(random_pairs * 3L);
}

TYPED_TEST(random_value, and_the_ends_of_the_range_agree_with_wider_integers) {
    using storage = typename TypeParam::storage;
    constexpr storage low = std::numeric_limits<storage>::min();
    constexpr storage high = std::numeric_limits<storage>::max();
    constexpr storage one = static_cast<storage>(storage{1} << (TypeParam::fraction_bits - 1));
    judge<TypeParam> judge;
    for (const storage a :
         {low, static_cast<storage>(low + 1), static_cast<storage>(-one), storage{-1}, storage{0},
          storage{1}, one, static_cast<storage>(high - 1), high}) {
        judge.single(a);
        for (const storage b :
             {low, static_cast<storage>(low + 1), static_cast<storage>(-one), storage{-1},
              storage{0}, storage{1}, one, static_cast<storage>(high - 1), high})
            judge.pair(a, b);
    }
    judge.conclude(81);
}

TEST(fixed, trap_stops_the_program) {
    using fixed = l3d_fixed<std::int32_t, 16, trap>;
    volatile double beyond = 32768.0;
    EXPECT_DEATH(static_cast<void>(fixed::max() + fixed::epsilon()), "");
    EXPECT_DEATH(static_cast<void>(-fixed::min()), "");
    EXPECT_DEATH(static_cast<void>(fixed(200) * fixed(-300)), "");
    EXPECT_DEATH(static_cast<void>(fixed::min() / fixed(-1)), "");
    EXPECT_DEATH(static_cast<void>(fixed(3) / fixed(0)), "");
    EXPECT_DEATH(static_cast<void>(fixed(beyond)), "");
    EXPECT_DEATH(static_cast<void>(fixed(beyond * std::nan(""))), "");
}

TEST(fixed, doubles_out_of_range_follow_the_policy) {
    using wrapping = l3d_fixed<std::int64_t, 32, wrap>;
    using saturating = l3d_fixed<std::int64_t, 32, saturate>;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double huge : {0x1p31, 0x1p62, 1e300, infinity}) {
        EXPECT_EQ(saturating(huge), saturating::max()) << huge;
        EXPECT_EQ(saturating(-huge), saturating::min()) << huge;
    }
    EXPECT_EQ(saturating(-0x1p31), saturating::min());
    EXPECT_EQ(saturating(nan).raw(), 0);
    EXPECT_EQ(wrapping(nan).raw(), 0);
    EXPECT_EQ(wrapping(infinity).raw(), 0);
    EXPECT_EQ(wrapping(-1e300).raw(), 0);
    EXPECT_EQ(wrapping(0x1p31), wrapping::min());
    EXPECT_EQ(wrapping(0x1p32 + 5.25), wrapping(5.25));
    EXPECT_EQ(wrapping(-0x1p32 - 5.25), wrapping(-5.25));
    EXPECT_EQ(wrapping(0x3p40 + 0x1p30 + 7), wrapping(0x1p30 + 7));
    EXPECT_EQ(wrapping(-0x3p40 + 0x1p31), wrapping::min());
    EXPECT_EQ((l3d_fixed<std::int32_t, 16>(0x1p50 + 0x1.8p0)), (l3d_fixed<std::int32_t, 16>(1.5)));
}

TEST(fixed, converts_between_formats) {
    using coarse = l3d_fixed<std::int32_t, 8, saturate>;
    using fine = l3d_fixed<std::int64_t, 32, saturate>;
    EXPECT_EQ(fine(coarse(-3.25)), fine(-3.25));
    EXPECT_EQ(coarse(fine(0x1.01p0 + 0x1p-9)).raw(), 258);      // 257.5: to even
    EXPECT_EQ(coarse(fine(-1 - 0x1p-9)).raw(), -256);           // -256.5: to even
    EXPECT_EQ(coarse(fine(-1 - 0x1p-9 - 0x1p-32)).raw(), -257); // just beyond the tie
    EXPECT_EQ(coarse(fine(0x1p30)), coarse::max());
    EXPECT_EQ((l3d_fixed<std::int64_t, 60, saturate>(coarse(-9))), // 8 is the range
              (l3d_fixed<std::int64_t, 60, saturate>::min()));
}

TEST(fixed, is_a_trivial_type_usable_at_compile_time) {
    using fixed = l3d_fixed<std::int64_t, 32>;
    static_assert(std::is_trivially_default_constructible_v<fixed>);
    static_assert(std::is_trivially_copyable_v<fixed>);
    static_assert(sizeof(fixed) == 8);
    static_assert(!std::is_convertible_v<int, fixed> && !std::is_convertible_v<double, fixed>);
    static_assert(!std::numeric_limits<fixed>::is_specialized);
    static_assert(fixed(2.5) * fixed(-3) / fixed(4) == fixed(-1.875));
    static_assert(l3d_midpoint(fixed(1), fixed(4)) == fixed(2.5));
    static_assert(fixed(-2.5).floor_to_int() == -3 && fixed(-2.5).round_to_int() == -2);
    static_assert(static_cast<double>(fixed(-0.375)) == -0.375);
    fixed value(3);
    value += fixed(2);
    value *= fixed(1.5);
    value -= fixed(0.5);
    value /= fixed(2);
    value <<= 2;
    value >>= 1;
    EXPECT_EQ(value, fixed(7));
}

TEST(fixed_sum, rounds_once) {
    using fixed = l3d_fixed<std::int32_t, 16>;
    const fixed tiny = fixed::from_raw(3);
    const fixed half = fixed(0.25); // each product is 0.75 steps: rounded alone, 1
    l3d_fixed_sum<fixed> sum;
    for (int i = 0; i < 5; ++i)
        sum.add_product(tiny, half);
    EXPECT_EQ(sum.rounded().raw(), 4); // 3.75
    sum.subtract_product(tiny, half);
    EXPECT_EQ(sum.rounded().raw(), 3);
}

template <class Fixed> class long_sum : public testing::Test {};
using formats_32 =
    testing::Types<l3d_fixed<std::int32_t, 16, wrap>, l3d_fixed<std::int32_t, 31, wrap>,
                   l3d_fixed<std::int32_t, 31, saturate>>;
TYPED_TEST_SUITE(long_sum, formats_32);

TYPED_TEST(long_sum, of_large_products_agrees_with_128_bits) {
    constexpr unsigned seed = 775;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    long turned = 0;
    for (int i = 0; i < 100'000; ++i) {
        l3d_fixed_sum<TypeParam> sum;
        int128 exact = 0;
        for (int k = 0; k < 7; ++k) {
            // Half of the numbers are at the lower end, so that partial sums leave 64 bits.
            const auto draw = [&] {
                return random() % 2 ? std::numeric_limits<std::int32_t>::min()
                                    : static_cast<std::int32_t>(random());
            };
            const std::int32_t a = draw();
            const std::int32_t b = draw();
            if (random() % 3) {
                sum.add_product(TypeParam::from_raw(a), TypeParam::from_raw(b));
                exact += int128{a} * b;
            } else {
                sum.subtract_product(TypeParam::from_raw(a), TypeParam::from_raw(b));
                exact -= int128{a} * b;
            }
            turned += exact > std::numeric_limits<std::int64_t>::max();
        }
        const int128 one = int128{1} << TypeParam::fraction_bits;
        ASSERT_EQ(sum.rounded().raw(), *fitted<TypeParam>(rounded(exact, one))) << i;
    }
    EXPECT_GT(turned, 1000);
}

TEST(fixed_sum, of_64_bits_comes_back_from_beyond_128) {
    using fixed = l3d_fixed<std::int64_t, 63, saturate>;
    l3d_fixed_sum<fixed> sum;
    for (int i = 0; i < 3; ++i)
        sum.add_product(fixed::min(), fixed::min()); // 3 * 2^126
    EXPECT_EQ(sum.rounded(), fixed::max());
    for (int i = 0; i < 3; ++i)
        sum.subtract_product(fixed::min(), fixed::min());
    sum.add_product(fixed(0.5), fixed(-0.25));
    EXPECT_EQ(sum.rounded(), fixed(-0.125));
    for (int i = 0; i < 3; ++i)
        sum.subtract_product(fixed::min(), fixed::min());
    EXPECT_EQ(sum.rounded(), fixed::min());
}

TEST(real, traits_describe_each_type) {
    using small = l3d_fixed<std::int32_t, 16, saturate>;
    using large = l3d_fixed<std::int64_t, 32>;
    EXPECT_EQ(l3d_real_traits<float>::unit_roundoff, std::numeric_limits<float>::epsilon() / 2);
    EXPECT_EQ(l3d_real_traits<double>::unit_roundoff, std::numeric_limits<double>::epsilon() / 2);
    EXPECT_EQ(l3d_real_traits<small>::half_ulp, static_cast<double>(small::epsilon()) / 2);
    EXPECT_EQ(l3d_real_traits<large>::half_ulp, static_cast<double>(large::epsilon()) / 2);
    EXPECT_EQ(l3d_from_double<float>(0.1), 0.1f);
    EXPECT_EQ(l3d_from_double<small>(-7.75), small(-7.75));
    EXPECT_EQ(l3d_to_double(small(-7.75)), -7.75);
    EXPECT_EQ(l3d_midpoint(3.0f, 4.5f), 3.75f);
    EXPECT_EQ(l3d_midpoint(-3.0, 4.5), 0.75);
}

TEST(real, name_is_that_of_the_type) {
    const std::string_view name = l3d_real_name();
    EXPECT_EQ(name == "float", (std::is_same_v<l3d_real, float>));
    EXPECT_EQ(name == "double", (std::is_same_v<l3d_real, double>));
    EXPECT_EQ(name == "fixed", (std::is_same_v<l3d_real, l3d_fixed<std::int64_t, 32>>));
}

} // namespace
