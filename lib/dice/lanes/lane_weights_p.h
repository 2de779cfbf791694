// SPDX-License-Identifier: MIT
// in_quarters: weights that make the control nets of blocks from a whole control net.
#ifndef L3D_DICE_LANES_LANE_WEIGHTS_P_H
#define L3D_DICE_LANES_LANE_WEIGHTS_P_H

#include <array>
#include <cstddef>

namespace l3d_detail {

/// The weight of a cubic's control point `from` in control point `to` of its part on [strip / 4,
/// (strip + 1) / 4].
///
/// A control point of the part is a value of the cubic's blossom. The blossom has three arguments:
/// the first `to` are the part's upper end, the remaining ones are the part's lower end. De
/// Casteljau's scheme computes the value, with one argument as the parameter of each step. The
/// weight is a multiple of 1/64, so it is exact in a float.
/// Source: Ramshaw, Blossoms are polar forms, CAGD 6, 1989.
constexpr float quarter_weight(int strip, int to, int from) {
    std::array<double, 4> p{};
    p[static_cast<std::size_t>(from)] = 1;
    for (int level = 0; level < 3; ++level) {
        const double t = (level < to ? strip + 1 : strip) / 4.0;
        for (std::size_t i = 0; i + static_cast<std::size_t>(level) < 3; ++i)
            p[i] = (1 - t) * p[i] + t * p[i + 1];
    }
    return static_cast<float>(p[0]);
}

/// The weights quarter_weight for all blocks, laid out for lanes. Lane 4 * b + a is the block in
/// u-strip a and v-strip b.
struct quarter_weights {
    static constexpr std::size_t lanes = 16;
    alignas(16) float u[4][4][4];     ///< [to][from][a]
    alignas(64) float v[4][4][lanes]; ///< [to][from][4 * b + a], the same for each a

    constexpr quarter_weights() : u{}, v{} {
        for (int to = 0; to < 4; ++to)
            for (int from = 0; from < 4; ++from)
                for (int lane = 0; lane < 16; ++lane) {
                    u[to][from][lane % 4] = quarter_weight(lane % 4, to, from);
                    v[to][from][lane] = quarter_weight(lane / 4, to, from);
                }
    }
};
inline constexpr quarter_weights in_quarters;

} // namespace l3d_detail

#endif
