// SPDX-License-Identifier: MIT
// mesh_borders: finds parameters that run along common borders, in the same or in the opposite
// direction.
#include "raster/paths/mesh_steps_p.h"

#include "base/directed_sets_p.h"
#include "base/number_hash_p.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace l3d_detail {

namespace {

/// The x and y of a border's four control points.
using border = std::array<double, 8>;

border backwards(const border& of) {
    return {of[6], of[7], of[4], of[5], of[2], of[3], of[0], of[1]};
}

} // namespace

void agree_on_borders(std::span<const l3d_mesh_patch> patches, std::span<mesh_dicing> dicings) {
    // Parameter 2 i is u of patch i, and parameter 2 i + 1 is v of patch i.
    directed_sets sets(2 * patches.size());
    std::unordered_map<border, directed_sets::place, number_hash> first_with;
    first_with.reserve(4 * patches.size());
    const auto add = [&](std::size_t parameter, const border& of) {
        const border other = backwards(of);
        if (std::ranges::all_of(std::array{2, 4, 6}, [&](int i) {
                const auto k = static_cast<std::size_t>(i);
                return of[k] == of[0] && of[k + 1] == of[1];
            }))
            return; // one point, which needs no steps
        const bool is_backwards = other < of;
        const directed_sets::place here{parameter, is_backwards};
        sets.join(first_with.try_emplace(is_backwards ? other : of, here).first->second, here);
        if (other == of)
            sets.join(here, {parameter, !is_backwards});
    };
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const auto& p = patches[i].points;
        for (const std::size_t r : {0u, 3u}) {
            add(2 * i, {p[r][0].x, p[r][0].y, p[r][1].x, p[r][1].y, p[r][2].x, p[r][2].y, p[r][3].x,
                        p[r][3].y});
            add(2 * i + 1, {p[0][r].x, p[0][r].y, p[1][r].x, p[1][r].y, p[2][r].x, p[2][r].y,
                            p[3][r].x, p[3][r].y});
        }
    }
    const auto steps_of = [&](std::size_t parameter) -> mesh_steps& {
        mesh_dicing& of = dicings[parameter / 2];
        return parameter % 2 == 0 ? of.along : of.down;
    };
    std::vector<mesh_steps> needed(2 * patches.size());
    for (std::size_t i = 0; i < needed.size(); ++i) {
        const auto [set, is_backwards] = sets.find(i);
        needed[set].cover(is_backwards ? steps_of(i).backwards() : steps_of(i));
    }
    for (std::size_t i = 0; i < needed.size(); ++i)
        if (sets.find(i).line == i && sets.runs_both_ways(i))
            needed[i].cover(needed[i].backwards());
    for (std::size_t i = 0; i < needed.size(); ++i) {
        const auto [set, is_backwards] = sets.find(i);
        steps_of(i) = is_backwards ? needed[set].backwards() : needed[set];
    }
}

} // namespace l3d_detail
