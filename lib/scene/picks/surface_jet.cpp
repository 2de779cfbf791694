// SPDX-License-Identifier: MIT
// l3d_surface_jet: bounds derivatives by intervals.
#include "scene/picks/surface_jet.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace {

using patch_3 = l3d_bezier_patch<double, 3>;
using jet_vector = l3d_surface_jet::vector;

/// The control net of a patch's derivative of order `along_u` by u and `along_v` by v.
class derivative_net {
public:
    derivative_net(const patch_3& patch, int along_u, int along_v)
        : columns_(4 - along_u), rows_(4 - along_v), factor_(scale(along_u) * scale(along_v)),
          terms_(std::ldexp(factor_, along_u + along_v)) {
        net_ = patch.points;
        for (int pass = 0; pass < along_u; ++pass)
            for (int r = 0; r < 4; ++r)
                for (int c = 0; c < 3 - pass; ++c)
                    at(r, c) = at(r, c + 1) - at(r, c);
        for (int pass = 0; pass < along_v; ++pass)
            for (int c = 0; c < columns_; ++c)
                for (int r = 0; r < 3 - pass; ++r)
                    at(r, c) = at(r + 1, c) - at(r, c);
    }

    /// A bound of the magnitude of one of the derivative's coordinates, by its control points.
    double most(int coordinate) {
        double result = 0;
        for (int r = 0; r < rows_; ++r)
            for (int c = 0; c < columns_; ++c)
                result = std::max(result, std::abs(at(r, c)[coordinate]));
        return factor_ * result;
    }

    /// The most by which the derivative changes if control points err by 1.
    double terms() const { return terms_; }

    patch_3::point value(double u, double v) {
        std::array<patch_3::point, 4> column;
        for (int r = 0; r < rows_; ++r) {
            std::array<patch_3::point, 4> row;
            for (int c = 0; c < columns_; ++c)
                row[static_cast<std::size_t>(c)] = at(r, c);
            column[static_cast<std::size_t>(r)] = reduced(row, columns_, u);
        }
        return reduced(column, rows_, v) * factor_;
    }

private:
    /// The factor of differences of control points in a cubic's first, second or third derivative:
    /// 3, 6, 6; 1 for none.
    static double scale(int times) { return times == 0 ? 1 : times == 1 ? 3 : 6; }

    static patch_3::point reduced(std::array<patch_3::point, 4>& p, int count, double t) {
        for (int left = count - 1; left > 0; --left)
            for (std::size_t i = 0; i < static_cast<std::size_t>(left); ++i)
                p[i] = p[i] * (1 - t) + p[i + 1] * t;
        return p[0];
    }

    patch_3::point& at(int row, int column) { return net_[patch_3::index(row, column)]; }

    std::array<patch_3::point, 16> net_{};
    int columns_, rows_;
    double factor_, terms_;
};

/// All derivatives of a patch, as intervals that hold for all parameters within an error of a
/// place.
class around {
public:
    around(const patch_3& patch, double u, double v, double u_error, double v_error,
           double rounding) {
        // Derivatives of the highest order come first: each changes by at most the size of the next
        // ones, and those of the fourth are zero.
        for (std::size_t i = 4; i-- > 0;)
            for (std::size_t j = 4; j-- > 0;) {
                derivative_net net(patch, static_cast<int>(i), static_cast<int>(j));
                const patch_3::point middle = net.value(u, v);
                for (std::size_t k = 0; k < 3; ++k) {
                    const int coordinate = static_cast<int>(k);
                    const double radius = net.terms() * rounding + net.most(coordinate) * 0x1p-49 +
                                          u_error * most_[i + 1][j][k] +
                                          v_error * most_[i][j + 1][k];
                    derivatives_[i][j][k] = l3d_interval::around(middle[coordinate], radius);
                    most_[i][j][k] = std::abs(middle[coordinate]) + radius;
                }
            }
    }

    const jet_vector& derivative(std::size_t along_u, std::size_t along_v) const {
        return derivatives_[along_u][along_v];
    }

private:
    std::array<std::array<jet_vector, 4>, 4> derivatives_;
    /// Bounds of derivatives; 0 beyond order 3.
    std::array<std::array<std::array<double, 3>, 5>, 5> most_{};
};

l3d_interval dot(const jet_vector& a, const jet_vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

l3d_interval square(const jet_vector& a) {
    return a[0].squared() + a[1].squared() + a[2].squared();
}

jet_vector cross(const jet_vector& a, const jet_vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

} // namespace

l3d_surface_jet::l3d_surface_jet(const l3d_bezier_patch<double, 3>& patch, double u, double v,
                                 double u_error, double v_error, double rounding) {
    const around here(patch, u, v, u_error, v_error, rounding);
    *this = l3d_surface_jet({.point = here.derivative(0, 0),
                             .by_u = here.derivative(1, 0),
                             .by_v = here.derivative(0, 1),
                             .by_uu = here.derivative(2, 0),
                             .by_uv = here.derivative(1, 1),
                             .by_vv = here.derivative(0, 2)});
}

l3d_surface_jet::l3d_surface_jet(const derivatives& of) : point(of.point) {
    const vector n = cross(of.by_u, of.by_v);
    const l3d_interval length = square(n).root();
    if (!(length.low > 0))
        return;
    normal = vector{n[0] / length, n[1] / length, n[2] / length};
    const l3d_interval e = dot(of.by_uu, *normal), f = dot(of.by_uv, *normal);
    const l3d_interval g = dot(of.by_vv, *normal);
    const l3d_interval area = length.squared(); // E G - F^2
    const l3d_interval two{2, 2};
    gaussian = (e * g - f.squared()) / area;
    mean = (e * square(of.by_v) - two * f * dot(of.by_u, of.by_v) + g * square(of.by_u)) /
           (two * area);
}

l3d_vector<double, 3> l3d_middle(const l3d_surface_jet::vector& v) {
    return {v[0].middle(), v[1].middle(), v[2].middle()};
}

double l3d_radius(const l3d_surface_jet::vector& v) {
    return std::hypot(v[0].radius(), v[1].radius(), v[2].radius()) * (1 + 0x1p-50);
}
