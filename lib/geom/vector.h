// SPDX-License-Identifier: MIT
// l3d_vector: two to four numbers of one type.
#ifndef L3D_GEOM_VECTOR_H
#define L3D_GEOM_VECTOR_H

#include "geom/real.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

/// A vector of N components of type T, which is GLM's own type: v[i] or v.x, v.y, v.z, v.w; +, -, *
/// and / by a number, ==. Functions of glm:: that take vectors accept it, and so do the functions
/// below.
///
/// Shape:   2 <= N <= 4. A vector holds nothing but the numbers, one after another. A new vector is
///          uninitialised, as a number is; l3d_vector<T, N>{} is all zero.
///
/// Vectors of fixed point have GLM's layout and operators, but are only for the functions below.
/// GLM's functions would round each product by itself.
template <class T, int N> using l3d_vector = glm::vec<N, T, glm::defaultp>;

/// The opposite vector. GLM's own operator needs numbers that an int converts to implicitly.
template <class Storage, int Fraction, l3d_overflow Overflow>
constexpr l3d_vector<l3d_fixed<Storage, Fraction, Overflow>, 4>
operator-(const l3d_vector<l3d_fixed<Storage, Fraction, Overflow>, 4>& v) noexcept {
    return {-v.x, -v.y, -v.z, -v.w};
}

namespace l3d_detail {

/// The square root, rounded down to a whole number.
/// Cost: some 7 divisions.
/// Source: Newton's iteration, from above.
template <class Unsigned> constexpr Unsigned integer_root(Unsigned value) noexcept {
    if (value == 0)
        return 0;
    int digits = 0; // base 4: value < 4^digits, so root < 2^digits
    for (Unsigned rest = value; rest != 0; rest >>= 2)
        ++digits;
    Unsigned root = Unsigned{1} << digits;
    for (;;) {
        const Unsigned better = (root + value / root) >> 1;
        if (better >= root)
            return root;
        root = better;
    }
}

/// The Euclidean length of raw numbers, rounded to nearest. Expects: N <= 4, each square fits Wide.
template <class Wide, int N> constexpr Wide raw_length(const Wide (&raw)[N]) noexcept {
    using wide_unsigned = std::conditional_t<sizeof(Wide) == 8, std::uint64_t, uint128>;
    wide_unsigned squares = 0;
    for (const Wide number : raw) {
        const auto square = static_cast<wide_unsigned>(number * number);
        // The sum overflows only for four components of -2^(half - 1), where half is half the bits
        // of Wide. Their length is 2^half.
        if (__builtin_add_overflow(squares, square, &squares))
            return Wide{1} << (4 * sizeof(Wide));
    }
    const auto root = integer_root(squares);
    const bool up = squares - root * root > root; // (root + 1/2)^2 is never an integer: no ties
    return static_cast<Wide>(root) + Wide{up};
}

} // namespace l3d_detail

/// The dot product. Fixed point rounds once, after the sum.
template <class T, int N> T l3d_dot(const l3d_vector<T, N>& a, const l3d_vector<T, N>& b) noexcept {
    if constexpr (l3d_is_fixed<T>) {
        l3d_fixed_sum<T> sum;
        for (int i = 0; i < N; ++i)
            sum.add_product(a[i], b[i]);
        return sum.rounded();
    } else if constexpr (N == 4) {
        return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]);
    } else {
        T sum = a[0] * b[0] + a[1] * b[1];
        if constexpr (N == 3)
            sum += a[2] * b[2];
        return sum;
    }
}

/// The cross product. Fixed point rounds once per component.
template <class T>
l3d_vector<T, 3> l3d_cross(const l3d_vector<T, 3>& a, const l3d_vector<T, 3>& b) noexcept {
    if constexpr (l3d_is_fixed<T>) {
        l3d_vector<T, 3> result;
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3;
            const int k = (i + 2) % 3;
            l3d_fixed_sum<T> sum;
            sum.add_product(a[j], b[k]);
            sum.subtract_product(a[k], b[j]);
            result[i] = sum.rounded();
        }
        return result;
    } else {
        return {a[1] * b[2] - b[1] * a[2], a[2] * b[0] - b[2] * a[0], a[0] * b[1] - b[0] * a[1]};
    }
}

/// The Euclidean length. Fixed point rounds only the root.
template <class T, int N> T l3d_length(const l3d_vector<T, N>& v) noexcept {
    if constexpr (l3d_is_fixed<T>) {
        using storage = typename T::storage;
        l3d_detail::wide<storage> raw[N];
        for (int i = 0; i < N; ++i)
            raw[i] = l3d_detail::wide<storage>{v[i].raw()};
        return T::from_raw(l3d_detail::narrowed<storage, T::overflow>(l3d_detail::raw_length(raw)));
    } else {
        return std::sqrt(l3d_dot(v, v));
    }
}

namespace l3d_detail {

template <class T, int N> l3d_vector<T, N> normalized_fixed(const l3d_vector<T, N>& v) noexcept {
    using wide = wide<typename T::storage>;
    wide raw[N];
    wide largest = 0;
    for (int i = 0; i < N; ++i) {
        raw[i] = wide{v[i].raw()};
        largest = std::max(largest, raw[i] < 0 ? -raw[i] : raw[i]);
    }
    if (largest == 0)
        return v;
    // A longer vector has the same direction, and a length with less relative rounding error.
    // Squares still fit: |raw| < 2^(half - 1), half being half the bits of wide.
    wide scale = 1;
    while (largest * scale < wide{1} << (4 * sizeof(wide) - 2))
        scale *= 2;
    for (wide& number : raw)
        number *= scale;
    const wide length = raw_length(raw);
    l3d_vector<T, N> result;
    for (int i = 0; i < N; ++i)
        result[i] = T::from_raw(narrowed<typename T::storage, T::overflow>(
            divided_to_nearest(raw[i] * (wide{1} << T::fraction_bits), length)));
    return result;
}

} // namespace l3d_detail

/// The unit vector along v; a vector of length zero is returned as it is.
///
/// Expects: in floating point, that the squares of the components neither overflow nor vanish.
///          Fixed point has no such limit, and short vectors lose no accuracy.
template <class T, int N> l3d_vector<T, N> l3d_normalized(const l3d_vector<T, N>& v) noexcept {
    if constexpr (l3d_is_fixed<T>) {
        return l3d_detail::normalized_fixed<T, N>(v);
    } else {
        const T length = l3d_length(v);
        return length > 0 ? v / length : v;
    }
}

/// The same vector in another number type.
template <class To, class From, int N>
l3d_vector<To, N> l3d_converted(const l3d_vector<From, N>& v) noexcept {
    l3d_vector<To, N> result;
    for (int i = 0; i < N; ++i)
        result[i] = l3d_from_double<To>(l3d_to_double(v[i]));
    return result;
}

#endif
