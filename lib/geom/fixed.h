// SPDX-License-Identifier: MIT
// l3d_fixed: binary fixed point with wide products and a stated behaviour on overflow.
#ifndef L3D_GEOM_FIXED_H
#define L3D_GEOM_FIXED_H

#include "base/public.h"

#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

/// The treatment of a result that is outside of a number type's range.
enum class L3D_PUBLIC l3d_overflow {
    wrap,     ///< the result is taken modulo 2^bits, as for unsigned integers; the fastest
    saturate, ///< the result becomes the nearest end of the range
    trap,     ///< the program stops at once: __builtin_trap()
};

namespace l3d_detail {

__extension__ typedef __int128 int128;
__extension__ typedef unsigned __int128 uint128;

/// An integer at least twice as wide as Storage. It holds the product of any two stored integers,
/// and the dividend of any quotient.
template <class Storage>
using wide = std::conditional_t<(sizeof(Storage) < 8), std::int64_t, int128>;

template <class Storage>
using wide_unsigned = std::conditional_t<(sizeof(Storage) < 8), std::uint64_t, uint128>;

/// Divides by 2^bits and rounds to the nearest, ties to even. Expects: 0 < bits < width of Wide.
template <class Wide> constexpr Wide shifted_to_nearest(Wide value, int bits) noexcept {
    const Wide below = value >> bits;
    const Wide rest = value - below * (Wide{1} << bits);
    // At a tie, an odd quotient is rounded up. Unlike value + half, no term can overflow.
    return below + Wide{rest + (below & 1) > (Wide{1} << (bits - 1))};
}

/// Divides and rounds to nearest, ties to even.
/// Expects: a divisor that is not 0 and has at most half of Wide's bits.
template <class Wide> constexpr Wide divided_to_nearest(Wide dividend, Wide divisor) noexcept {
    const Wide toward_zero = dividend / divisor;
    const Wide rest = dividend % divisor;
    const Wide twice = rest < 0 ? -2 * rest : 2 * rest;
    const Wide whole = divisor < 0 ? -divisor : divisor;
    if (twice + (toward_zero & 1) <= whole)
        return toward_zero;
    return (dividend < 0) == (divisor < 0) ? toward_zero + 1 : toward_zero - 1;
}

/// The end of Storage's range beyond which a value lies: the lower end if `negative`. With
/// l3d_overflow::trap, the function stops the program instead.
template <class Storage, l3d_overflow Overflow> constexpr Storage beyond(bool negative) noexcept {
    if constexpr (Overflow == l3d_overflow::trap)
        __builtin_trap();
    return negative ? std::numeric_limits<Storage>::min() : std::numeric_limits<Storage>::max();
}

/// Brings a wide value into Storage. A value out of range is treated as Overflow says.
template <class Storage, l3d_overflow Overflow, class Wide>
constexpr Storage narrowed(Wide value) noexcept {
    if constexpr (Overflow != l3d_overflow::wrap)
        if (value < std::numeric_limits<Storage>::min() ||
            value > std::numeric_limits<Storage>::max())
            return beyond<Storage, Overflow>(value < 0);
    return static_cast<Storage>(value);
}

/// Reduces a double modulo 2^64.
/// Expects: a whole number outside of int64, or infinity or NaN, for which the result is 0.
constexpr std::uint64_t wrapped(double value) noexcept {
    constexpr double modulus = 18446744073709551616.0;   // 2^64
    constexpr double all_multiples = 9007199254740992.0; // 2^53: from here on ulp(value) >= 2^64
    const double quotient = value / modulus;
    if (!(quotient > -all_multiples && quotient < all_multiples))
        return 0;
    const double rest = value - static_cast<double>(static_cast<std::int64_t>(quotient)) * modulus;
    return rest < 0 ? 0 - static_cast<std::uint64_t>(-rest) : static_cast<std::uint64_t>(rest);
}

} // namespace l3d_detail

/// A number stored as an integer times 2^-FractionBits.
///
/// All rounding is to nearest, ties to even, so that -(a * b) == (-a) * b.
/// Units:   raw() counts steps of 2^-FractionBits, which is epsilon().
/// Expects: 0 < FractionBits < bits of Storage. A default-constructed value is uninitialised, as an
///          int is.
/// Errors:  Overflow decides on a result out of range, such as min() / -1 or -min(). x / 0 is 0
///          with wrap, and stops the program with trap. With saturate it is max() for x > 0, min()
///          for x < 0 and 0 for x = 0. NaN converts to 0, but stops the program with trap. Infinity
///          is out of range; wrap makes it 0.
/// Cost:    with wrap, + and - are one integer operation. * takes a wide product and four more
///          operations, / a wide division.
template <class Storage, int FractionBits, l3d_overflow Overflow = l3d_overflow::wrap>
class L3D_PUBLIC l3d_fixed {
    static_assert(std::signed_integral<Storage> && sizeof(Storage) <= 8);
    static_assert(FractionBits > 0 && FractionBits < static_cast<int>(8 * sizeof(Storage)));

    using wide = l3d_detail::wide<Storage>;
    using bits = std::make_unsigned_t<Storage>;
    static constexpr wide one = wide{1} << FractionBits;

public:
    /// The integer that holds a number.
    using storage = Storage;
    static constexpr int fraction_bits = FractionBits; ///< the binary digits after the point
    static constexpr l3d_overflow overflow = Overflow; ///< treatment of results out of range

    /// Uninitialised, as an int is.
    l3d_fixed() = default;

    /// A whole number. Errors: out of range as Overflow says.
    explicit constexpr l3d_fixed(int value) noexcept
        : l3d_fixed(of_wide(static_cast<l3d_detail::int128>(value) * one)) {}

    /// The number of this format that is nearest to `value`. Errors: out of range as Overflow says.
    explicit constexpr l3d_fixed(double value) noexcept : raw_(raw_of(value)) {}

    /// A number of another format: exact if it fits, else rounded.
    /// Errors: out of range as Overflow says.
    template <class S, int F, l3d_overflow O>
    explicit constexpr l3d_fixed(l3d_fixed<S, F, O> other) noexcept {
        const l3d_detail::int128 raw = other.raw();
        if constexpr (F > FractionBits)
            *this = of_wide(l3d_detail::shifted_to_nearest(raw, F - FractionBits));
        else
            *this = of_wide(raw * (l3d_detail::int128{1} << (FractionBits - F)));
    }

    /// The number that is stored as this integer.
    static constexpr l3d_fixed from_raw(Storage raw) noexcept {
        l3d_fixed result;
        result.raw_ = raw;
        return result;
    }
    /// The integer that the number is stored as.
    constexpr Storage raw() const noexcept { return raw_; }

    /// The number of this format that is farthest below zero.
    static constexpr l3d_fixed min() noexcept {
        return from_raw(std::numeric_limits<Storage>::min());
    }
    /// The largest number of this format.
    static constexpr l3d_fixed max() noexcept {
        return from_raw(std::numeric_limits<Storage>::max());
    }
    /// The step between neighbouring numbers, which is also the least positive number.
    static constexpr l3d_fixed epsilon() noexcept { return from_raw(1); }

    /// The number as a double: exact if raw() fits 53 bits, else rounded.
    explicit constexpr operator double() const noexcept {
        return static_cast<double>(raw_) / static_cast<double>(one);
    }
    /// The largest whole number that is not above this number.
    constexpr std::int64_t floor_to_int() const noexcept { return raw_ >> FractionBits; }
    /// The nearest whole number; the even one of two equally near.
    constexpr std::int64_t round_to_int() const noexcept {
        return static_cast<std::int64_t>(l3d_detail::shifted_to_nearest(wide{raw_}, FractionBits));
    }

    /// Compares the values.
    // The check takes the zero that the compiler compares with for a null pointer.
    // NOLINTNEXTLINE(modernize-use-nullptr)
    friend constexpr auto operator<=>(l3d_fixed, l3d_fixed) = default;

    /// The sum, exact if it is in range.
    friend constexpr l3d_fixed operator+(l3d_fixed a, l3d_fixed b) noexcept {
        if constexpr (Overflow == l3d_overflow::wrap)
            return of_bits(static_cast<bits>(a.raw_) + static_cast<bits>(b.raw_));
        return of_wide(wide{a.raw_} + b.raw_);
    }
    /// The difference, exact if it is in range.
    friend constexpr l3d_fixed operator-(l3d_fixed a, l3d_fixed b) noexcept {
        if constexpr (Overflow == l3d_overflow::wrap)
            return of_bits(static_cast<bits>(a.raw_) - static_cast<bits>(b.raw_));
        return of_wide(wide{a.raw_} - b.raw_);
    }
    /// The number with the opposite sign. Errors: -min() is out of range.
    constexpr l3d_fixed operator-() const noexcept { return from_raw(0) - *this; }

    /// The product, rounded to nearest.
    friend constexpr l3d_fixed operator*(l3d_fixed a, l3d_fixed b) noexcept {
        return of_wide(l3d_detail::shifted_to_nearest(wide{a.raw_} * b.raw_, FractionBits));
    }
    /// The quotient, rounded to nearest. Errors: division by zero as the class says.
    friend constexpr l3d_fixed operator/(l3d_fixed a, l3d_fixed b) noexcept {
        if (b.raw_ == 0)
            return divided_by_zero(a.raw_);
        return of_wide(l3d_detail::divided_to_nearest(wide{a.raw_} * one, wide{b.raw_}));
    }

    /// The number times 2^count.
    /// Errors: out of range as Overflow says.
    /// Expects: 0 <= count < bits of Storage.
    friend constexpr l3d_fixed operator<<(l3d_fixed a, int count) noexcept {
        if constexpr (Overflow == l3d_overflow::wrap)
            return of_bits(static_cast<wide>(a.raw_) * (wide{1} << count));
        return of_wide(a.raw_ * (wide{1} << count));
    }
    /// The number times 2^-count, rounded to nearest. Expects: 0 <= count < bits of Storage.
    friend constexpr l3d_fixed operator>>(l3d_fixed a, int count) noexcept {
        return count == 0 ? a : of_wide(l3d_detail::shifted_to_nearest(wide{a.raw_}, count));
    }
    /// Half of the number, rounded to nearest.
    constexpr l3d_fixed halved() const noexcept { return *this >> 1; }

    /// Adds, as + does.
    constexpr l3d_fixed& operator+=(l3d_fixed b) noexcept { return *this = *this + b; }
    /// Subtracts, as - does.
    constexpr l3d_fixed& operator-=(l3d_fixed b) noexcept { return *this = *this - b; }
    /// Multiplies, as * does.
    constexpr l3d_fixed& operator*=(l3d_fixed b) noexcept { return *this = *this * b; }
    /// Divides, as / does.
    constexpr l3d_fixed& operator/=(l3d_fixed b) noexcept { return *this = *this / b; }
    /// Doubles the number `count` times, as << does.
    constexpr l3d_fixed& operator<<=(int count) noexcept { return *this = *this << count; }
    /// Halves the number `count` times, and rounds once, as >> does.
    constexpr l3d_fixed& operator>>=(int count) noexcept { return *this = *this >> count; }

private:
    template <class Integer> static constexpr l3d_fixed of_bits(Integer value) noexcept {
        return from_raw(static_cast<Storage>(value));
    }
    template <class Wide> static constexpr l3d_fixed of_wide(Wide value) noexcept {
        return from_raw(l3d_detail::narrowed<Storage, Overflow>(value));
    }

    static constexpr l3d_fixed divided_by_zero(Storage dividend) noexcept {
        if (Overflow == l3d_overflow::wrap || (Overflow == l3d_overflow::saturate && dividend == 0))
            return from_raw(0);
        return from_raw(l3d_detail::beyond<Storage, Overflow>(dividend < 0));
    }

    static constexpr Storage raw_of(double value) noexcept {
        constexpr double end_of_int64 = 9223372036854775808.0;  // 2^63
        const double scaled = value * static_cast<double>(one); // exact, or infinite
        if (scaled >= -end_of_int64 && scaled < end_of_int64) {
            const auto toward_zero = static_cast<std::int64_t>(scaled);
            const double rest = scaled - static_cast<double>(toward_zero); // exact
            const bool odd = (toward_zero & 1) != 0;
            const int up = rest > 0.5 || (rest == 0.5 && odd);
            const int down = rest < -0.5 || (rest == -0.5 && odd);
            return l3d_detail::narrowed<Storage, Overflow>(toward_zero + up - down);
        }
        if constexpr (Overflow == l3d_overflow::wrap)
            return static_cast<Storage>(l3d_detail::wrapped(scaled));
        if (Overflow == l3d_overflow::saturate && value != value)
            return 0;
        return l3d_detail::beyond<Storage, Overflow>(scaled < 0);
    }

    Storage raw_;
};

/// Whether T is an l3d_fixed.
template <class T> inline constexpr bool l3d_is_fixed = false;
/// True for every l3d_fixed.
template <class S, int F, l3d_overflow O>
inline constexpr bool l3d_is_fixed<l3d_fixed<S, F, O>> = true;

/// The midpoint (a + b) / 2, rounded once. It has the same bits if a and b are exchanged, and is
/// never out of range.
template <class S, int F, l3d_overflow O>
constexpr l3d_fixed<S, F, O> l3d_midpoint(l3d_fixed<S, F, O> a, l3d_fixed<S, F, O> b) noexcept {
    const auto sum = l3d_detail::wide<S>{a.raw()} + b.raw();
    return l3d_fixed<S, F, O>::from_raw(static_cast<S>(l3d_detail::shifted_to_nearest(sum, 1)));
}

/// A sum of products that is rounded once, when it is read. The sum must be in range when it is
/// read; before, it need not be.
///
/// Expects: Fixed is an l3d_fixed; fewer than 2^31 products.
template <class Fixed> class L3D_PUBLIC l3d_fixed_sum {
    using wide = l3d_detail::wide<typename Fixed::storage>;

public:
    /// Adds a * b, unrounded.
    constexpr void add_product(Fixed a, Fixed b) noexcept {
        const wide product = wide{a.raw()} * b.raw();
        if (__builtin_add_overflow(low_, product, &low_))
            turns_ += product < 0 ? -1 : 1;
    }
    /// Subtracts a * b, unrounded.
    constexpr void subtract_product(Fixed a, Fixed b) noexcept {
        const wide product = wide{a.raw()} * b.raw();
        if (__builtin_sub_overflow(low_, product, &low_))
            turns_ += product < 0 ? 1 : -1;
    }

    /// The sum in Fixed's format, rounded to nearest. Errors: out of range as Overflow says.
    constexpr Fixed rounded() const noexcept {
        using storage = typename Fixed::storage;
        // Wrap needs no turns_: its bits, from fraction_bits up, are all in low_.
        if constexpr (Fixed::overflow != l3d_overflow::wrap)
            if (turns_ != 0)
                return Fixed::from_raw(l3d_detail::beyond<storage, Fixed::overflow>(turns_ < 0));
        return Fixed::from_raw(l3d_detail::narrowed<storage, Fixed::overflow>(
            l3d_detail::shifted_to_nearest(low_, Fixed::fraction_bits)));
    }

private:
    wide low_ = 0;  ///< the sum modulo 2^(bits of wide)
    int turns_ = 0; ///< how often low_ overflowed at the upper end, less how often at the lower
};

#endif
