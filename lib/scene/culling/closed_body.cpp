// SPDX-License-Identifier: MIT
// l3d_orientation_of: pairs equal edges, and tests whether all normals turn away from one point.
#include "scene/culling/closed_body.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace {

using patch = l3d_bezier_patch<double, 3>;
using curve = patch::curve;
using vector = l3d_facing_cones::vector;

/// Whether each edge of each patch meets exactly one other edge, which runs in the opposite
/// direction.
bool has_no_boundary(std::span<const patch> patches, std::span<const l3d_halved_side> halved) {
    std::vector<std::array<double, 12>> there, back;
    const auto add = [&](const curve& edge) {
        there.push_back(l3d_numbers_of(edge));
        back.push_back(l3d_numbers_of(edge.reversed()));
    };
    auto next = halved.begin(); // in the order of patches and sides
    for (std::size_t i = 0; i < patches.size(); ++i)
        for (std::size_t side = 0; side < 4; ++side) {
            const curve edge = l3d_walked_side(patches[i], side);
            if (next != halved.end() && next->of.patch == i && next->of.side == side) {
                const auto [low, high] = edge.split();
                add(low);
                add(high);
                ++next;
            } else if (!std::all_of(edge.points.begin(), edge.points.end(),
                                    [&](const vector& q) { return q == edge.points[0]; })) {
                add(edge);
            }
        }
    std::sort(there.begin(), there.end());
    std::sort(back.begin(), back.end());
    return there == back && std::adjacent_find(there.begin(), there.end()) == there.end();
}

} // namespace

int l3d_orientation_of(std::span<const patch> patches, std::span<const l3d_facing_cones> cones,
                       std::span<const l3d_halved_side> halved) {
    if (patches.empty() || !has_no_boundary(patches, halved))
        return 0;
    auto [least, most] = patches[0].bounds();
    for (const patch& p : patches) {
        const auto [low, high] = p.bounds();
        for (int k = 0; k < 3; ++k) {
            least[k] = std::min(least[k], low[k]);
            most[k] = std::max(most[k], high[k]);
        }
    }
    const vector middle = (least + most) * 0.5;
    for (const int side : {1, -1})
        if (std::all_of(cones.begin(), cones.end(), [&](const l3d_facing_cones& c) {
                return c.away_from(middle, side) == l3d_facing_cones::all;
            }))
            return side;
    return 0;
}
