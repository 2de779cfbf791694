// SPDX-License-Identifier: MIT
// l3d_normal_net: the exact normal of a bicubic patch as a polynomial of degree 5 by 5.
#ifndef L3D_GEOM_NORMAL_NET_H
#define L3D_GEOM_NORMAL_NET_H

#include "geom/bezier_patch.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

/// A polynomial of degree 5 by 5 in Bernstein form, which holds a bicubic patch's normals.
/// Shape: index 6 * row + column, columns along u.
struct l3d_normal_polynomial {
    using vector = l3d_vector<double, 3>;
    static constexpr std::size_t order = 6;
    std::array<vector, order * order> points{};

    /// The halves along u (split_u) or along v (split_v), the lower one first.
    std::pair<l3d_normal_polynomial, l3d_normal_polynomial> split_u() const {
        return split(1, order);
    }
    std::pair<l3d_normal_polynomial, l3d_normal_polynomial> split_v() const {
        return split(order, 1);
    }

private:
    std::pair<l3d_normal_polynomial, l3d_normal_polynomial> split(std::size_t along,
                                                                  std::size_t across) const;
};

/// The normal dS/du x dS/dv of a bicubic patch in Bernstein form, not normalised.
///
/// Where an edge of the patch is collapsed, the cross product vanishes along the edge although the
/// tangent plane exists. The cross product then has a factor u, 1 - u, v or 1 - v. The net holds
/// the quotient by this factor, divided as often as needed. The quotient has the cross product's
/// direction inside the patch, and the limit of that direction on the edge. If the normal vanishes
/// everywhere, as far as rounding can tell, the net is 0.
///
/// Shape:  36 vectors, index 6 * row + column, columns along u.
/// Units:  scaled so that the largest component is 1 (direction is all that counts).
/// Source: product of Bernstein polynomials as in Farin, Curves and Surfaces for CAGD, section 6.6.
///         dS/du has degree 2 by 3, dS/dv 3 by 2, so the product has degree 5 by 5.
class l3d_normal_net {
public:
    using vector = l3d_vector<double, 3>;

    l3d_normal_net() = default;
    explicit l3d_normal_net(const l3d_bezier_patch<double, 3>& patch);
    /// Makes the net of given normals. Factors that vanish on an edge are divided out, as by the
    /// constructor for a patch.
    explicit l3d_normal_net(const l3d_normal_polynomial& normals);
    /// Takes over a finished net, and the same coefficients as floats.
    /// Expects: a largest component of 1, and no factor that vanishes on an edge.
    l3d_normal_net(const l3d_normal_polynomial& normals, const float (&in_floats)[3][6][6])
        : net_(normals) {
        std::copy_n(&in_floats[0][0][0], 3 * 6 * 6, &in_floats_[0][0][0]);
    }

    static constexpr std::size_t index(int row, int column) {
        return 6 * static_cast<std::size_t>(row) + static_cast<std::size_t>(column);
    }
    const vector& at(int row, int column) const { return net_.points[index(row, column)]; }
    const l3d_normal_polynomial& polynomial() const { return net_; }

    /// A vector of any length along the normal at (u, v). Source: de Casteljau.
    vector evaluate(double u, double v) const;

    /// The coefficients as floats, one array per component: [component][row][column].
    using float_net = float[3][6][6];
    const float_net& in_floats() const { return in_floats_; }

private:
    void finish();
    void scale_to_one();
    void fill_floats();
    bool divide_by_vanishing_factor();

    l3d_normal_polynomial net_;
    float_net in_floats_{};
};

#endif
