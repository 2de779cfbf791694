// SPDX-License-Identifier: MIT
// Converts control points of a uniform bicubic B-spline to those of the Bezier patch.
#ifndef L3D_PLUGINS_SUBDIVISION_BSPLINE_BEZIER_H
#define L3D_PLUGINS_SUBDIVISION_BSPLINE_BEZIER_H

#include <array>
#include <cstddef>

namespace l3d_limit {

/// One coordinate of 4 x 4 control points. The index along u changes fastest.
using net = std::array<double, 16>;

/// A bit for each side of a face: v = 0, u = 1, v = 1, u = 0. A bit is set if its side has no
/// neighbour.
enum side_bits : unsigned { v_low = 1, u_high = 2, v_high = 4, u_low = 8 };

/// Computes the control points beyond sides without neighbours by reflection at the control points
/// on the side. Each lies as far outside as its counterpart lies inside. So the surface's boundary
/// is the B-spline curve of the control points on the side.
inline void reflect_at_boundaries(net& p, unsigned boundary) {
    for (std::size_t i = 0; i < 4; ++i) {
        if (boundary & v_low)
            p[i] = 2 * p[4 + i] - p[8 + i];
        if (boundary & v_high)
            p[12 + i] = 2 * p[8 + i] - p[4 + i];
    }
    for (std::size_t i = 0; i < 16; i += 4) {
        if (boundary & u_low)
            p[i] = 2 * p[i + 1] - p[i + 2];
        if (boundary & u_high)
            p[i + 3] = 2 * p[i + 2] - p[i + 1];
    }
}

/// The 4 x 4 control points of a uniform B-spline form 3 x 3 squares. Returns the Bezier points of
/// the patch that belongs to the middle square.
///
/// The order of additions does not depend on the direction in which control points are counted. So
/// two neighbours compute the same bits for their common side.
/// Source: knot insertion; each Bezier point is a product of (1 4 1) / 6 and (2 1) / 3.
inline net bezier_of(const net& p) {
    const auto at = [&](int row, int column) {
        return p[static_cast<std::size_t>(4 * row + column)];
    };
    const auto across = [](double a, double b, double c) { return ((a + c) + 4 * b) / 6; };
    const auto near = [](double a, double b) { return (2 * a + b) / 3; };
    net result{};
    for (const int r : {0, 1})
        for (const int c : {0, 1}) {
            // The corner at control point (row, column). `down` and `right` lead from there to
            // further rows and columns.
            const int row = 1 + r, column = 1 + c, down = r == 0 ? 1 : -1, right = c == 0 ? 1 : -1;
            const auto put = [&](int i, int k, double value) {
                const int to_row = r == 0 ? i : 3 - i, to_column = c == 0 ? k : 3 - k;
                result[static_cast<std::size_t>(4 * to_row + to_column)] = value;
            };
            const double beside = (at(row - 1, column) + at(row + 1, column)) +
                                  (at(row, column - 1) + at(row, column + 1));
            const double aslant = (at(row - 1, column - 1) + at(row + 1, column + 1)) +
                                  (at(row - 1, column + 1) + at(row + 1, column - 1));
            put(0, 0, (16 * at(row, column) + 4 * beside + aslant) / 36);
            const auto in_column = [&](int k) {
                return across(at(row - 1, k), at(row, k), at(row + 1, k));
            };
            const auto in_row = [&](int i) {
                return across(at(i, column - 1), at(i, column), at(i, column + 1));
            };
            put(0, 1, near(in_column(column), in_column(column + right)));
            put(1, 0, near(in_row(row), in_row(row + down)));
            put(1, 1,
                near(near(at(row, column), at(row, column + right)),
                     near(at(row + down, column), at(row + down, column + right))));
        }
    return result;
}

/// The control points of the two halves of a cubic Bezier curve: 7 in a row. Both halves share the
/// middle point. All are midpoints of midpoints, so the reversed curve gives the same points, bit
/// for bit.
inline std::array<double, 7> halves_of(double a, double b, double c, double d) {
    const double ab = (a + b) / 2, bc = (b + c) / 2, cd = (c + d) / 2;
    const double abc = (ab + bc) / 2, bcd = (bc + cd) / 2;
    return {a, ab, abc, (abc + bcd) / 2, bcd, cd, d};
}

/// The part of a Bezier patch from u0 to u0 + size and from v0 to v0 + size, by halving.
/// Expects: size is a power of 1/2, and u0 and v0 are multiples of size.
inline net part_of(net p, double u0, double v0, double size) {
    const auto halve = [](net& of, bool along_u, bool high) {
        const std::size_t step = along_u ? 1 : 4, line = along_u ? 4 : 1;
        for (std::size_t i = 0; i < 4; ++i) {
            double* const c = of.data() + i * line;
            const auto both = halves_of(c[0], c[step], c[2 * step], c[3 * step]);
            for (std::size_t k = 0; k < 4; ++k)
                c[k * step] = both[k + (high ? 3 : 0)];
        }
    };
    for (double half = 0.5; half >= size; half /= 2) {
        const bool right = u0 >= half, up = v0 >= half;
        halve(p, true, right);
        halve(p, false, up);
        u0 -= right ? half : 0;
        v0 -= up ? half : 0;
    }
    return p;
}

} // namespace l3d_limit

#endif
