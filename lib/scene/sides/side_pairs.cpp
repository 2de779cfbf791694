// SPDX-License-Identifier: MIT
// l3d_side_pairs: pairs sides by their control points, in sorted order.
#include "scene/sides/side_pairs.h"

#include "scene/sides/halved_sides.h"

#include <algorithm>
#include <map>

namespace {

using curve = l3d_patch_model::patch::curve;
using numbers = std::array<double, 12>;

struct side_of {
    std::size_t patch, side;
    bool forward; ///< whether the side's points sort before their reverse
};

} // namespace

l3d_side_pairs::l3d_side_pairs(const l3d_patch_model& model) {
    const auto patches = model.patches();
    beyond_.resize(patches.size());
    std::map<numbers, std::vector<side_of>> by_place;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        for (std::size_t k = 0; k < sides; ++k) {
            const curve walked = l3d_walked_side(patches[i], k);
            const auto& points = walked.points;
            const numbers there = l3d_numbers_of(walked), back = l3d_numbers_of(walked.reversed());
            if (std::all_of(points.begin(), points.end(),
                            [&](const auto& q) { return q == points[0]; }))
                beyond_[i][k].is = kind::point;
            else if (there != back) // a curve that runs back on itself has no direction
                by_place[std::min(there, back)].push_back({i, k, there <= back});
        }
    }
    for (const auto& [place, met] : by_place)
        for (std::size_t k = 0; k < 2 && met.size() == 2; ++k) {
            const side_of &here = met[k], &there = met[1 - k];
            beyond_[here.patch][here.side] = {kind::paired, here.forward == there.forward,
                                              static_cast<std::uint32_t>(there.patch),
                                              static_cast<std::uint32_t>(there.side)};
        }
    for (const l3d_halved_side& side : model.halved_sides()) {
        beyond_[side.of.patch][side.of.side].is = kind::halved;
        for (std::uint32_t part = 0; part < 2; ++part)
            beyond_[side.beyond[part].patch][side.beyond[part].side] = {
                kind::half, side.turns[part], side.of.patch, side.of.side, part};
    }
}

std::array<double, 2> l3d_side_pairs::place_on(std::size_t side, double t) {
    switch (side) {
    case 0:
        return {t, 0};
    case 1:
        return {1, t};
    case 2:
        return {1 - t, 1};
    default:
        return {0, 1 - t};
    }
}
