// SPDX-License-Identifier: MIT
// Transformations as matrices: turning in degrees, scaling, inverses; l3d_point, and their
// application to points; vectors and points as text.
#ifndef L3D_GEOM_TRANSFORM_H
#define L3D_GEOM_TRANSFORM_H

#include "base/public.h"
#include "geom/matrix.h"
#include "geom/vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <ios>
#include <numbers>
#include <optional>
#include <utility>

/// A place, held as its displacement from the origin.
///
/// The difference of two points is a vector, and a point moved by a vector is a point. Operations
/// without a meaning (the sum of two points, a vector minus a point) do not compile. So the type
/// takes the place of the fourth homogeneous coordinate, 1 for points and 0 for vectors.
template <class T> struct L3D_PUBLIC l3d_point {
    /// A difference of two points.
    using vector = l3d_vector<T, 3>;

    /// Uninitialised, as a number is; l3d_point<T>{} is the origin.
    l3d_point() = default;
    /// The point with these three coordinates.
    constexpr l3d_point(T x, T y, T z) noexcept : from_origin(x, y, z) {}
    /// The point that the vector leads to from the origin.
    explicit constexpr l3d_point(const vector& place) noexcept : from_origin(place) {}

    /// The point with coordinates rounded to T. This is a named function, since fixed point numbers
    /// are never made implicitly.
    static l3d_point of(double x, double y, double z) noexcept {
        return {l3d_from_double<T>(x), l3d_from_double<T>(y), l3d_from_double<T>(z)};
    }

    /// A coordinate, to be changed. Expects: 0 <= axis < 3.
    T& operator[](int axis) noexcept { return from_origin[axis]; }
    /// A coordinate. Expects: 0 <= axis < 3.
    const T& operator[](int axis) const noexcept { return from_origin[axis]; }

    /// Moves the point along the vector.
    l3d_point& operator+=(const vector& v) noexcept {
        from_origin += v;
        return *this;
    }
    /// The point moved along the vector.
    friend l3d_point operator+(const l3d_point& p, const vector& v) noexcept {
        return l3d_point(p.from_origin + v);
    }
    /// The point moved along the vector.
    friend l3d_point operator+(const vector& v, const l3d_point& p) noexcept { return p + v; }
    /// The point moved against the vector.
    friend l3d_point operator-(const l3d_point& p, const vector& v) noexcept {
        return l3d_point(p.from_origin - v);
    }
    /// The vector that leads from q to p.
    friend vector operator-(const l3d_point& p, const l3d_point& q) noexcept {
        return p.from_origin - q.from_origin;
    }
    /// Whether all coordinates are equal.
    friend bool operator==(const l3d_point& p, const l3d_point& q) noexcept {
        return p.from_origin == q.from_origin;
    }

    vector from_origin; ///< the coordinates
};

/// Cosine and sine of an angle.
struct L3D_PUBLIC l3d_turn {
    /// Each in [-1, 1]; exact at multiples of 90 degrees.
    double cosine = 1, sine = 0;
};

/// Cosine and sine of an angle. Units: degrees, any finite number; multiples of 90 are exact.
inline l3d_turn l3d_turn_by(double degrees) noexcept {
    // remquo leaves at most 45 degrees, where neither function suffers from pi being rounded.
    int quarters = 0;
    const double rest = std::remquo(degrees, 90, &quarters) * (std::numbers::pi / 180);
    const double c = std::cos(rest);
    const double s = std::sin(rest);
    switch (quarters & 3) {
    case 0:
        return {c, s};
    case 1:
        return {-s, c};
    case 2:
        return {-c, -s};
    default:
        return {s, -c};
    }
}

/// The map that multiplies the three coordinates by x, y and z.
template <class T> l3d_matrix<T> l3d_scaling(double x, double y, double z) noexcept {
    l3d_matrix<T> m = l3d_identity<T>();
    m(0, 0) = l3d_from_double<T>(x);
    m(1, 1) = l3d_from_double<T>(y);
    m(2, 2) = l3d_from_double<T>(z);
    return m;
}

namespace l3d_detail {

/// The map that turns the plane of the axes `from` and `to`, the first towards the second.
template <class T> l3d_matrix<T> turning(int from, int to, double degrees) noexcept {
    const l3d_turn turn = l3d_turn_by(degrees);
    l3d_matrix<T> m = l3d_identity<T>();
    m(from, from) = m(to, to) = l3d_from_double<T>(turn.cosine);
    m(to, from) = l3d_from_double<T>(turn.sine);
    m(from, to) = l3d_from_double<T>(-turn.sine);
    return m;
}

} // namespace l3d_detail

/// The map that turns about the x axis, y towards z. The turn follows the right-hand rule in
/// right-handed axes, and the left-hand rule in left-handed ones.
/// Units:   degrees.
template <class T> l3d_matrix<T> l3d_rotation_x(double degrees) noexcept {
    return l3d_detail::turning<T>(1, 2, degrees);
}
/// The map that turns about the y axis, z towards x, as l3d_rotation_x says. Units: degrees.
template <class T> l3d_matrix<T> l3d_rotation_y(double degrees) noexcept {
    return l3d_detail::turning<T>(2, 0, degrees);
}
/// The map that turns about the z axis, x towards y, as l3d_rotation_x says. Units: degrees.
template <class T> l3d_matrix<T> l3d_rotation_z(double degrees) noexcept {
    return l3d_detail::turning<T>(0, 1, degrees);
}

/// The turn or scaling m with `centre` as its fixed point instead of the origin: T(c) m T(-c),
/// where T(c) moves points by c.
template <class T>
l3d_matrix<T> l3d_about(const l3d_point<double>& centre, const l3d_matrix<T>& m) noexcept {
    return l3d_translation<T>(centre[0], centre[1], centre[2]) * m *
           l3d_translation<T>(-centre[0], -centre[1], -centre[2]);
}

/// The matrix whose columns are three axes and an origin. The matrix turns coordinates along these
/// axes into coordinates of the system in which axes and origin are given.
template <class T>
l3d_matrix<T> l3d_from_axes(const l3d_vector<T, 3>& x, const l3d_vector<T, 3>& y,
                            const l3d_vector<T, 3>& z, const l3d_point<T>& origin) noexcept {
    l3d_matrix<T> m = l3d_identity<T>();
    for (int i = 0; i < 3; ++i) {
        m(i, 0) = x[i];
        m(i, 1) = y[i];
        m(i, 2) = z[i];
        m(i, 3) = origin[i];
    }
    return m;
}

/// The matrix with rows and columns exchanged.
template <class T> l3d_matrix<T> l3d_transposed(const l3d_matrix<T>& m) noexcept {
    l3d_matrix<T> result;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            result(i, j) = m(j, i);
    return result;
}

namespace l3d_detail {

/// Inverts a matrix and finds its determinant, by Gauss-Jordan elimination. Each row is first
/// scaled to a largest entry of 1, and pivots are sought down the column.
class elimination {
public:
    template <class T> explicit elimination(const l3d_matrix<T>& m) {
        for (std::size_t i = 0; i < 4; ++i) {
            double largest = 0;
            for (std::size_t j = 0; j < 4; ++j) {
                rows_[i][j] = l3d_to_double(m(static_cast<int>(i), static_cast<int>(j)));
                largest = std::max(largest, std::abs(rows_[i][j]));
            }
            rows_[i][4 + i] = 1;
            if (largest > 0) {
                divide(rows_[i], largest);
                determinant_ *= largest;
            }
        }
        for (std::size_t column = 0; column < 4 && regular_; ++column)
            clear(column);
    }

    bool regular() const { return regular_; }
    double determinant() const { return regular_ ? determinant_ : 0; }
    double inverse(int row, int column) const {
        return rows_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column) + 4];
    }

private:
    using wide_row = std::array<double, 8>;

    static void divide(wide_row& r, double by) {
        for (double& number : r)
            number /= by;
    }

    void clear(std::size_t column) {
        std::size_t pivot = column;
        for (std::size_t i = column + 1; i < 4; ++i)
            if (std::abs(rows_[i][column]) > std::abs(rows_[pivot][column]))
                pivot = i;
        // Entries are at most 1 at first. In each of three steps, they at most double, with some
        // 2^-53 of rounding. So an entry below 2^-46 may be nothing but rounding.
        if (!(std::abs(rows_[pivot][column]) > 0x1p-46)) {
            regular_ = false;
            return;
        }
        if (pivot != column) {
            std::swap(rows_[pivot], rows_[column]);
            determinant_ = -determinant_;
        }
        determinant_ *= rows_[column][column];
        divide(rows_[column], double{rows_[column][column]});
        for (std::size_t i = 0; i < 4; ++i) {
            const double factor = rows_[i][column];
            for (std::size_t j = 0; i != column && j < 8; ++j)
                rows_[i][j] -= factor * rows_[column][j];
        }
    }

    std::array<wide_row, 4> rows_{};
    double determinant_ = 1;
    bool regular_ = true;
};

} // namespace l3d_detail

/// The determinant: the factor by which an affine map multiplies volumes, negative if it mirrors. 0
/// for a matrix that l3d_inverted calls singular.
template <class T> double l3d_determinant(const l3d_matrix<T>& m) noexcept {
    return l3d_detail::elimination(m).determinant();
}

/// The matrix that undoes m.
///
/// Errors:  nothing if m is singular, or so near to it that rounding decides.
/// Cost:    computed in double for every T, then rounded.
template <class T> std::optional<l3d_matrix<T>> l3d_inverted(const l3d_matrix<T>& m) noexcept {
    const l3d_detail::elimination done(m);
    if (!done.regular())
        return std::nullopt;
    l3d_matrix<T> result;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            result(i, j) = l3d_from_double<T>(done.inverse(i, j));
    return result;
}

/// Makes the axes of m, its first three columns, unit vectors at right angles. This undoes the
/// rounding of long products of turns. The first axis keeps its direction. The second axis stays in
/// the plane of the first two. Column 3, the origin, and row 3 stay.
///
/// Errors:  nothing if the axes lie in a plane, or so near to it that rounding decides.
/// Cost:    in double for every T, then rounded.
/// Source:  Gram and Schmidt.
template <class T>
std::optional<l3d_matrix<T>> l3d_orthonormalized(const l3d_matrix<T>& m) noexcept {
    // With a smaller sine of the angle between axes, the rounding of floats, 2^-24, is more than a
    // 16th of that sine.
    constexpr double least_sine = 0x1p-20;
    l3d_matrix<T> result = m;
    l3d_vector<double, 3> axes[3];
    for (int i = 0; i < 3; ++i) {
        l3d_vector<double, 3>& axis = axes[i];
        double largest = 0;
        for (int k = 0; k < 3; ++k) {
            axis[k] = l3d_to_double(m(k, i));
            largest = std::max(largest, std::abs(axis[k]));
        }
        if (!(largest > 0) || !std::isfinite(largest))
            return std::nullopt;
        axis = l3d_normalized(axis / largest); // squares then neither overflow nor vanish
        for (int earlier = 0; earlier < i; ++earlier)
            axis = axis - axes[earlier] * l3d_dot(axes[earlier], axis);
        if (!(l3d_length(axis) > least_sine))
            return std::nullopt;
        axis = l3d_normalized(axis);
        for (int k = 0; k < 3; ++k)
            result(k, i) = l3d_from_double<T>(axis[k]);
    }
    return result;
}

/// The matrix that takes coordinates of the system `from` to those of the system `to`. Each system
/// is given by the matrix that leads from it to the world.
/// Errors:  nothing if `to` is singular.
template <class T>
std::optional<l3d_matrix<T>> l3d_coordinate_change(const l3d_matrix<T>& from,
                                                   const l3d_matrix<T>& to) noexcept {
    const auto back = l3d_inverted(to);
    if (!back)
        return std::nullopt;
    return *back * from;
}

/// Applies m to a point, without a division by w. Expects: the last row of m is 0 0 0 1.
template <class T>
l3d_point<T> l3d_transformed(const l3d_matrix<T>& m, const l3d_point<T>& p) noexcept {
    const auto moved = m * l3d_vector<T, 4>(p[0], p[1], p[2], l3d_from_double<T>(1));
    return {moved[0], moved[1], moved[2]};
}

/// Applies m to a displacement, which no translation changes.
template <class T>
l3d_vector<T, 3> l3d_transformed(const l3d_matrix<T>& m, const l3d_vector<T, 3>& v) noexcept {
    const auto moved = m * l3d_vector<T, 4>(v[0], v[1], v[2], l3d_from_double<T>(0));
    return {moved[0], moved[1], moved[2]};
}

/// The point that homogeneous coordinates stand for. Errors: nothing for a direction, whose w is 0.
template <class T> std::optional<l3d_point<T>> l3d_homogenized(const l3d_vector<T, 4>& p) noexcept {
    if (p[3] == l3d_from_double<T>(0))
        return std::nullopt;
    return l3d_point<T>(p[0] / p[3], p[1] / p[3], p[2] / p[3]);
}

/// The unit normal of a plane that m has moved. The inverse transpose of m gives it, and keeps the
/// normal perpendicular however unequally m scales.
/// Errors:  nothing if m is singular.
template <class T>
std::optional<l3d_vector<T, 3>> l3d_transformed_normal(const l3d_matrix<T>& m,
                                                       const l3d_vector<T, 3>& normal) noexcept {
    const auto inverse = l3d_inverted(m);
    if (!inverse)
        return std::nullopt;
    return l3d_normalized(l3d_transformed(l3d_transposed(*inverse), normal));
}

namespace glm {

/// Writes a vector as "(1, 2.5, -3)", in the stream's own format of numbers. Where GLM's gtx/io.hpp
/// is included, its format holds.
template <std::derived_from<std::ios_base> Stream, length_t N, class T, qualifier Q>
Stream& operator<<(Stream& stream, const vec<N, T, Q>& v) {
    for (length_t i = 0; i < N; ++i) {
        stream << (i == 0 ? "(" : ", ");
        if constexpr (l3d_is_fixed<T>)
            stream << l3d_to_double(v[i]);
        else
            stream << v[i];
    }
    stream << ')';
    return stream;
}

} // namespace glm

/// Writes a point as its vector from the origin.
template <std::derived_from<std::ios_base> Stream, class T>
Stream& operator<<(Stream& stream, const l3d_point<T>& p) {
    return stream << p.from_origin;
}

#endif
