// SPDX-License-Identifier: MIT
// Makes weights that turn Bernstein coefficients of a patch into Taylor coefficients about the
// middles of its parts.
#ifndef L3D_SCENE_BENDS_BEND_WEIGHTS_P_H
#define L3D_SCENE_BENDS_BEND_WEIGHTS_P_H

#include "scene/bends/surface_bends_p.h"

#include <array>
#include <cstddef>

namespace l3d_detail {

constexpr double choose(std::size_t n, std::size_t k) {
    return k == 0 ? 1 : choose(n - 1, k - 1) * static_cast<double>(n) / static_cast<double>(k);
}

/// The weight of Bernstein coefficient `from` in the Taylor coefficient of t^power about the middle
/// of a part. t runs from -1 to 1 across the part.
///
/// De Casteljau's scheme at the middle computes the weight, with `power` steps of differences,
/// times a binomial coefficient. The coefficient is degree! / (degree - power)! for the derivative,
/// over power! for Taylor's series. A part is 1/8 of the patch, and t from 0 to 1 covers half of
/// the part. The weight is a multiple of 2^-20, hence exact: for degree 5 it takes five products
/// with sixteenths.
template <std::size_t Degree>
constexpr double taylor_weight(std::size_t part, std::size_t power, std::size_t from) {
    constexpr double half = 0.5 / bend_parts;
    const double middle = static_cast<double>(2 * part + 1) * half;
    std::array<double, Degree + 1> p{};
    p[from] = 1;
    for (std::size_t level = 0; level < Degree; ++level)
        for (std::size_t i = 0; i + level < Degree; ++i)
            p[i] =
                level < power ? (p[i + 1] - p[i]) * half : (1 - middle) * p[i] + middle * p[i + 1];
    return p[0] * choose(Degree, power);
}

template <std::size_t Degree> struct taylor_weights {
    alignas(64) double at[Degree + 1][Degree + 1][bend_parts]; ///< [power][from][part]

    constexpr taylor_weights() : at{} {
        for (std::size_t power = 0; power <= Degree; ++power)
            for (std::size_t from = 0; from <= Degree; ++from)
                for (std::size_t part = 0; part < bend_parts; ++part)
                    at[power][from][part] = taylor_weight<Degree>(part, power, from);
    }
};
template <std::size_t Degree> inline constexpr taylor_weights<Degree> weights_of_taylor;

} // namespace l3d_detail

#endif
