// SPDX-License-Identifier: MIT
// l3d_forward_difference_surface: one coordinate of a bicubic patch as a tensor of differences.
#ifndef L3D_TESTS_GEOM_FORWARD_DIFFERENCE_SURFACE_H
#define L3D_TESTS_GEOM_FORWARD_DIFFERENCE_SURFACE_H

#include "geom/forward_difference.h"

#include <array>
#include <cstddef>

/// One coordinate of a bicubic patch held in 16 registers and walked in u and v by additions.
///
/// Shape:  in_v[i] walks the i-th difference in u along v.
/// Errors: rounding errors of both directions multiply: with f fraction bits and one rounding a
///         register up to 2^-(f + 1) S(n) S(m), S(n) = 1 + n + C(n, 2) + C(n, 3). Short walks only;
///         the patch pipeline restarts each strip exactly instead and never runs this form across
///         a patch.
/// Source: Shantz, Chang, Rendering Trimmed NURBS with Adaptive Forward Differencing, 1988.
template <class T> struct l3d_forward_difference_surface {
    std::array<l3d_forward_difference<T, 3>, 4> in_v;

    /// From 16 Bernstein coefficients, index 4 * row + column, for steps_u by steps_v steps.
    static l3d_forward_difference_surface build(const std::array<double, 16>& b, int steps_u,
                                                int steps_v) {
        using in_double = l3d_forward_difference<double, 3>;
        std::array<in_double, 4> rows;
        for (std::size_t r = 0; r < 4; ++r)
            rows[r] =
                in_double::build({b[4 * r], b[4 * r + 1], b[4 * r + 2], b[4 * r + 3]}, steps_u);
        l3d_forward_difference_surface result;
        for (std::size_t i = 0; i < 4; ++i)
            result.in_v[i] = l3d_forward_difference<T, 3>::build(
                {rows[0].d[i], rows[1].d[i], rows[2].d[i], rows[3].d[i]}, steps_v);
        return result;
    }

    T value() const { return in_v[0].value(); }

    /// The isocurve through the current point, to be walked along u.
    l3d_forward_difference<T, 3> row() const {
        return {{in_v[0].d[0], in_v[1].d[0], in_v[2].d[0], in_v[3].d[0]}};
    }

    void step_v() {
        for (auto& difference : in_v)
            difference.step();
    }

    void step_u() {
        for (std::size_t i = 0; i + 1 < in_v.size(); ++i)
            for (std::size_t j = 0; j < 4; ++j)
                in_v[i].d[j] = in_v[i].d[j] + in_v[i + 1].d[j];
    }

    void halve_v() {
        for (auto& difference : in_v)
            difference.halve();
    }

    void double_v() {
        for (auto& difference : in_v)
            difference.double_step();
    }

    void halve_u() {
        along_u([](auto& difference) { difference.halve(); });
    }

    void double_u() {
        along_u([](auto& difference) { difference.double_step(); });
    }

private:
    template <class Change> void along_u(Change change) {
        for (std::size_t j = 0; j < 4; ++j) {
            l3d_forward_difference<T, 3> difference{
                {in_v[0].d[j], in_v[1].d[j], in_v[2].d[j], in_v[3].d[j]}};
            change(difference);
            for (std::size_t i = 0; i < 4; ++i)
                in_v[i].d[j] = difference.d[i];
        }
    }
};

#endif
