// SPDX-License-Identifier: MIT
// Computes with power series in two variables, cut off at a total order, with bounds of the rest.
#if defined(L3D_SCENE_BENDS_BEND_SERIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_SCENE_BENDS_BEND_SERIES_INL_H
#undef L3D_SCENE_BENDS_BEND_SERIES_INL_H
#else
#define L3D_SCENE_BENDS_BEND_SERIES_INL_H
#endif

#include "raster/parallel/lane_doubles-inl.h"

#include <algorithm>
#include <cstddef>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// Coefficients of normals' series are exact below this order. For mixed third derivatives on the
/// teapot, without quartering, the median of bound / exact is 3.2 with order 6, 1.9 with order 7
/// and 1.5 with order 8. Order 8 takes a quarter more time than order 7.
constexpr std::size_t series_order = 7;

/// Derivatives are bounded up to this order, inclusive.
constexpr std::size_t wanted_order = 3;

/// The coefficients of a series: [power of u][power of v]. The sum of both powers is less than
/// series_order.
using series = number[series_order][series_order];

/// Calls f(k, l) with all powers whose sum is at most `most`, smaller sums first.
template <class F> HWY_ATTR HWY_INLINE void for_powers(std::size_t most, const F& f) {
    for (std::size_t order = 0; order <= most; ++order)
        for (std::size_t k = 0; k <= order; ++k)
            f(k, order - k);
}

/// Computes the product of two series, up to the order `most`.
HWY_ATTR HWY_INLINE void multiply(const series& a, const series& b, std::size_t most,
                                  series& product) {
    for_powers(most, [&](std::size_t k, std::size_t l) HWY_ATTR {
        number sum = same(0);
        for (std::size_t i = 0; i <= k; ++i)
            for (std::size_t j = 0; j <= l; ++j)
                sum = sum + a[i][j] * b[k - i][l - j];
        product[k][l] = sum;
    });
}

/// Computes g = 1 / sqrt(x), up to the order `most`. Let E be the operator that multiplies each
/// coefficient by its order: the sum of the derivatives by both variables, each times its variable.
/// Then x E g = - g E x / 2 gives one coefficient of g after another.
HWY_ATTR HWY_INLINE void inverse_root(const series& x, std::size_t most, series& g) {
    const number inverse = same(1) / x[0][0];
    for_powers(most, [&](std::size_t k, std::size_t l) HWY_ATTR {
        if (k + l == 0) {
            g[0][0] = root(inverse);
            return;
        }
        number sum = same(0);
        for (std::size_t i = 0; i <= k; ++i)
            for (std::size_t j = i == 0; j <= l; ++j) {
                const auto of_x = static_cast<double>(i + j), all = static_cast<double>(k + l);
                sum = sum + x[i][j] * g[k - i][l - j] * same((of_x / 2 - all) / all);
            }
        g[k][l] = sum * inverse;
    });
}

/// Computes g = 1 / x, up to the order `most`.
HWY_ATTR HWY_INLINE void invert(const series& x, std::size_t most, series& g) {
    const number inverse = same(1) / x[0][0];
    for_powers(most, [&](std::size_t k, std::size_t l) HWY_ATTR {
        number sum = same(k + l == 0 ? 1 : 0);
        for (std::size_t i = 0; i <= k; ++i)
            for (std::size_t j = i == 0; j <= l; ++j)
                sum = sum - x[i][j] * g[k - i][l - j];
        g[k][l] = sum * inverse;
    });
}

/// Moves the centre of a series from (0, 0) to (1, 1), up to wanted_order, by Horner's scheme.
/// `columns_of_row` gives the number of coefficients in each row.
template <std::size_t N, class Size>
HWY_ATTR HWY_INLINE void move_to_corner(number (&a)[N][N], const Size& columns_of_row) {
    for (std::size_t l = 0; l < N; ++l)
        for (std::size_t k = 0; k <= wanted_order; ++k)
            for (std::size_t i = columns_of_row(l); i-- > k + 1;)
                a[i - 1][l] = a[i - 1][l] + a[i][l];
    for (std::size_t k = 0; k <= wanted_order; ++k)
        for (std::size_t l = 0; l <= wanted_order; ++l)
            for (std::size_t j = columns_of_row(k); j-- > l + 1;)
                a[k][j - 1] = a[k][j - 1] + a[k][j];
}
HWY_ATTR HWY_INLINE void move_to_corner(series& a) {
    move_to_corner(a, [](std::size_t row) { return series_order - row; });
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
