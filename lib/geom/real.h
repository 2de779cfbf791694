// SPDX-License-Identifier: MIT
// l3d_real: the number type of this build, and one interface to all number types.
#ifndef L3D_GEOM_REAL_H
#define L3D_GEOM_REAL_H

#include "base/public.h"
#include "geom/fixed.h"

#include <concepts>
#include <cstdint>
#include <type_traits>

#if defined(L3D_REAL_FLOAT) + defined(L3D_REAL_DOUBLE) + defined(L3D_REAL_FIXED) != 1
#error "define L3D_REAL_FLOAT, _DOUBLE or _FIXED, as `pkg-config --cflags l3d` does"
#endif

// Every object file refers to the symbol of its own number type, and the library defines only one
// of these symbols. So objects for another number type do not link. The pointers have different
// names, since otherwise the linker would keep one and drop the references of the others.
#if defined(L3D_REAL_FLOAT)
/// The number type of this build. A program must be compiled with the same type as the library.
using l3d_real = float;
/// A symbol that only libraries built for float define.
L3D_PUBLIC extern const char l3d_built_with_float_real;
/// Makes every program for float refer to l3d_built_with_float_real. So the program does not link
/// with a library that is built for another number type.
[[gnu::used]] inline constexpr const char* l3d_needs_float_real = &l3d_built_with_float_real;
#elif defined(L3D_REAL_DOUBLE)
using l3d_real = double;
L3D_PUBLIC extern const char l3d_built_with_double_real;
[[gnu::used]] inline constexpr const char* l3d_needs_double_real = &l3d_built_with_double_real;
#else
using l3d_real = l3d_fixed<std::int64_t, 32>;
L3D_PUBLIC extern const char l3d_built_with_fixed_real;
[[gnu::used]] inline constexpr const char* l3d_needs_fixed_real = &l3d_built_with_fixed_real;
#endif

/// The number type the library was built with: "float", "double" or "fixed".
L3D_PUBLIC const char* l3d_real_name();

/// The properties of a number type that algorithms need: conversions, and bounds of rounding.
///
/// Units: an operation errs by at most unit_roundoff * |result| + half_ulp, if the result is in
///        range.
template <class T> struct l3d_real_traits;

/// The properties of floating point numbers, whose rounding is in proportion to the result.
template <std::floating_point T> struct L3D_PUBLIC l3d_real_traits<T> {
    static constexpr double unit_roundoff =
        sizeof(T) == 4 ? 0x1p-24 : 0x1p-53; ///< largest relative error of an operation
    static constexpr double half_ulp = 0;   ///< 0: errors are in proportion to the result

    /// The nearest number of this type.
    static constexpr T from_double(double value) noexcept { return static_cast<T>(value); }
    /// The same number; exact.
    static constexpr double to_double(T value) noexcept { return value; }
};

/// The properties of fixed point numbers, whose rounding errors have one bound for all results.
template <class Storage, int FractionBits, l3d_overflow Overflow>
struct L3D_PUBLIC l3d_real_traits<l3d_fixed<Storage, FractionBits, Overflow>> {
    /// The number type itself.
    using fixed = l3d_fixed<Storage, FractionBits, Overflow>;
    /// Largest relative error: 0, since the bound of an error does not depend on the result's size.
    static constexpr double unit_roundoff = 0;
    /// Half of the step between neighbouring numbers.
    static constexpr double half_ulp = 0.5 / static_cast<double>(std::uint64_t{1} << FractionBits);

    /// The nearest number of this type.
    static constexpr fixed from_double(double value) noexcept { return fixed(value); }
    /// The number, rounded to 53 bits.
    static constexpr double to_double(fixed value) noexcept { return static_cast<double>(value); }
};

/// Converts a number of any type to double, by l3d_real_traits.
template <class T> constexpr double l3d_to_double(T value) noexcept {
    return l3d_real_traits<T>::to_double(value);
}

/// Converts a double to a number of any type, by l3d_real_traits.
template <class T> constexpr T l3d_from_double(double value) noexcept {
    return l3d_real_traits<T>::from_double(value);
}

/// The midpoint (a + b) / 2, rounded; the same bits if a and b are exchanged.
/// Expects: a + b is finite.
template <std::floating_point T> constexpr T l3d_midpoint(T a, T b) noexcept {
    return (a + b) / 2;
}

#endif
