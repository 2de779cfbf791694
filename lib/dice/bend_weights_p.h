// SPDX-License-Identifier: MIT
// Weights of Bernstein coefficients in the parts of a patch and on a lattice of its points.
#ifndef L3D_DICE_BEND_WEIGHTS_P_H
#define L3D_DICE_BEND_WEIGHTS_P_H

#include "dice/surface_bends_p.h"

#include <array>
#include <cstddef>

namespace l3d_detail {

/// Points of the lattice along a side: the ends of parts, and their middles.
inline constexpr std::size_t lattice_points = 2 * bend_parts + 1;

/// The lattice along u in lanes: all parts' left ends, all middles, all right ends, so that a
/// part's three points are three lanes a group apart, and its inner ends are there twice.
inline constexpr std::size_t lattice_lanes = 3 * bend_parts;
constexpr std::size_t point_of_lane(std::size_t lane) {
    return 2 * (lane % bend_parts) + lane / bend_parts;
}

/// n (n - 1) ... of k factors: what k derivatives take out of t^n.
constexpr double falling(int n, int k) {
    return k == 0 ? 1 : n * falling(n - 1, k - 1);
}

/// How much of Bernstein coefficient `from` is in the derivative of this order at t, by a parameter
/// that runs over one part while t runs over 1 / bend_parts. A multiple of 2^-20, hence exact: for
/// degree 5 five products with sixteenths.
template <int Degree> constexpr double lattice_weight(int order, double t, std::size_t from) {
    std::array<double, Degree + 1> p{};
    p[from] = 1;
    for (int level = 0; level < Degree; ++level)
        for (std::size_t i = 0; i + static_cast<std::size_t>(level) < Degree; ++i)
            p[i] = level < order ? p[i + 1] - p[i] : (1 - t) * p[i] + t * p[i + 1];
    double result = p[0] * falling(Degree, order);
    for (int k = 0; k < order; ++k)
        result /= bend_parts;
    return result;
}

/// How much of coefficient `from` is in coefficient `to` of a part: see quarter_weight.
template <int Degree>
constexpr double part_weight(std::size_t part, std::size_t to, std::size_t from) {
    std::array<double, Degree + 1> p{};
    p[from] = 1;
    for (std::size_t level = 0; level < Degree; ++level) {
        const double t = static_cast<double>(level < to ? part + 1 : part) / bend_parts;
        for (std::size_t i = 0; i + level < Degree; ++i)
            p[i] = (1 - t) * p[i] + t * p[i + 1];
    }
    return p[0];
}

template <int Degree> struct bend_weights {
    static constexpr std::size_t order = Degree + 1;
    static constexpr int derivatives = 4; ///< of order 0 to 3

    alignas(64) double parts[order][order][bend_parts];             ///< [to][from][part]
    alignas(64) double along_u[derivatives][order][lattice_lanes];  ///< [order][from][lane]
    alignas(64) double along_v[derivatives][order][lattice_points]; ///< [order][from][point]

    constexpr bend_weights() : parts{}, along_u{}, along_v{} {
        for (std::size_t from = 0; from < order; ++from) {
            for (std::size_t to = 0; to < order; ++to)
                for (std::size_t part = 0; part < bend_parts; ++part)
                    parts[to][from][part] = part_weight<Degree>(part, to, from);
            for (int k = 0; k < derivatives; ++k) {
                for (std::size_t lane = 0; lane < lattice_lanes; ++lane)
                    along_u[k][from][lane] = at(k, point_of_lane(lane), from);
                for (std::size_t point = 0; point < lattice_points; ++point)
                    along_v[k][from][point] = at(k, point, from);
            }
        }
    }

private:
    static constexpr double at(int k, std::size_t point, std::size_t from) {
        return lattice_weight<Degree>(k, static_cast<double>(point) / (lattice_points - 1), from);
    }
};
template <int Degree> inline constexpr bend_weights<Degree> weights_of_bends;

} // namespace l3d_detail

#endif
