// SPDX-License-Identifier: MIT
// l3d_matrix: four by four numbers that move and project points.
#ifndef L3D_GEOM_MATRIX_H
#define L3D_GEOM_MATRIX_H

#include "base/public.h"
#include "geom/vector.h"

#include <glm/mat4x4.hpp>

#include <cmath>
#include <numbers>

/// A linear map of homogeneous points: m * v with v a column, so (a * b) * v is a * (b * v).
///
/// Shape:   m(row, column), both 0 to 3; a translation is in column 3. Stored by columns, as OpenGL
///          does.
/// Cost:    in fixed point each component of a product is rounded once.
template <class T> class L3D_PUBLIC l3d_matrix {
public:
    /// Uninitialised, as a number is; l3d_matrix<T>{} is all zero.
    l3d_matrix() = default;

    /// The same map as a matrix of GLM, which is stored by columns, too. For fixed point, numbers
    /// are rounded.
    template <class Number> l3d_matrix(const glm::mat<4, 4, Number, glm::defaultp>& m) noexcept {
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                columns_[i][j] = l3d_from_double<T>(double(m[i][j]));
    }
    /// The same map for GLM.
    operator glm::mat<4, 4, T, glm::defaultp>() const noexcept {
        return {columns_[0], columns_[1], columns_[2], columns_[3]};
    }

    /// The number at a row and a column, to be changed. Expects: 0 <= row, column < 4.
    T& operator()(int row, int column) noexcept { return columns_[column][row]; }
    /// The number at a row and a column. Expects: 0 <= row, column < 4.
    const T& operator()(int row, int column) const noexcept { return columns_[column][row]; }

    /// The four numbers of a row. Expects: 0 <= i < 4.
    l3d_vector<T, 4> row(int i) const noexcept {
        return {columns_[0][i], columns_[1][i], columns_[2][i], columns_[3][i]};
    }
    /// The four numbers of a column: the image of axis i or, if i is 3, the image of the origin.
    /// Expects: 0 <= i < 4.
    l3d_vector<T, 4> column(int i) const noexcept { return columns_[i]; }

    /// Applies the map to a column of coordinates.
    friend l3d_vector<T, 4> operator*(const l3d_matrix& m, const l3d_vector<T, 4>& v) noexcept {
        if constexpr (l3d_is_fixed<T>) {
            l3d_vector<T, 4> result;
            for (int i = 0; i < 4; ++i)
                result[i] = l3d_dot<T, 4>(m.row(i), v);
            return result;
        } else {
            return (m.columns_[0] * v[0] + m.columns_[1] * v[1]) +
                   (m.columns_[2] * v[2] + m.columns_[3] * v[3]);
        }
    }

    /// The map that does b first, then a.
    friend l3d_matrix operator*(const l3d_matrix& a, const l3d_matrix& b) noexcept {
        l3d_matrix result;
        for (int i = 0; i < 4; ++i)
            result.columns_[i] = a * b.columns_[i];
        return result;
    }

    /// The map whose images are the sums of both maps' images.
    friend l3d_matrix operator+(const l3d_matrix& a, const l3d_matrix& b) noexcept {
        l3d_matrix result;
        for (int i = 0; i < 4; ++i)
            result.columns_[i] = a.columns_[i] + b.columns_[i];
        return result;
    }

    /// The map whose images are the differences of both maps' images.
    friend l3d_matrix operator-(const l3d_matrix& a, const l3d_matrix& b) noexcept {
        l3d_matrix result;
        for (int i = 0; i < 4; ++i)
            result.columns_[i] = a.columns_[i] - b.columns_[i];
        return result;
    }

    friend bool operator==(const l3d_matrix&, const l3d_matrix&) = default;

private:
    l3d_vector<T, 4> columns_[4];
};

/// The map that leaves every vector as it is.
template <class T> l3d_matrix<T> l3d_identity() noexcept {
    l3d_matrix<T> result{};
    for (int i = 0; i < 4; ++i)
        result(i, i) = l3d_from_double<T>(1);
    return result;
}

/// The map that adds (x, y, z) to points (w = 1), and nothing to directions (w = 0).
template <class T> l3d_matrix<T> l3d_translation(double x, double y, double z) noexcept {
    l3d_matrix<T> result = l3d_identity<T>();
    result(0, 3) = l3d_from_double<T>(x);
    result(1, 3) = l3d_from_double<T>(y);
    result(2, 3) = l3d_from_double<T>(z);
    return result;
}

/// The map that turns about an axis through the origin, counterclockwise as seen by someone at whom
/// the axis points.
///
/// Units:   degrees; the axis may have any length but zero.
/// Source:  Rodrigues' formula: R = c I + s [a]x + (1 - c) a a^T for a unit axis a.
template <class T>
l3d_matrix<T> l3d_rotation(const l3d_vector<double, 3>& axis, double degrees) noexcept {
    const l3d_vector<double, 3> a = l3d_normalized(axis);
    const double radians = degrees * (std::numbers::pi / 180);
    const double c = std::cos(radians);
    const double s = std::sin(radians);
    l3d_matrix<T> result = l3d_identity<T>();
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        result(i, i) = l3d_from_double<T>(c + (1 - c) * a[i] * a[i]);
        result(j, i) = l3d_from_double<T>((1 - c) * a[i] * a[j] + s * a[k]);
        result(i, j) = l3d_from_double<T>((1 - c) * a[i] * a[j] - s * a[k]);
    }
    return result;
}

#endif
