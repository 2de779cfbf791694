// SPDX-License-Identifier: MIT
// l3d_find_halved_sides: looks up halves of sides in a table of sides.
#include "scene/sides/halved_sides.h"

#include "base/number_hash_p.h"

#include <algorithm>
#include <unordered_map>

namespace {

using patch = l3d_bezier_patch<double, 3>;
using curve = patch::curve;
using numbers = std::array<double, 12>;

/// An entry of the table of sides. It tells how many sides have the same control points, in either
/// direction, and which of these sides comes first.
struct met_sides {
    std::size_t count = 0;
    l3d_halved_side::place first{};
    bool forward = false; ///< whether the first side's points sort before their reverse
};

} // namespace

std::vector<l3d_halved_side> l3d_find_halved_sides(std::span<const patch> patches) {
    constexpr std::uint32_t sides = 4;
    std::unordered_map<numbers, met_sides, l3d_detail::number_hash> met;
    met.reserve(2 * patches.size() + 1);
    const auto key_of = [](const curve& c, bool& forward) {
        const numbers there = l3d_numbers_of(c), back = l3d_numbers_of(c.reversed());
        forward = there <= back;
        return forward ? there : back;
    };
    for (std::uint32_t i = 0; i < patches.size(); ++i)
        for (std::uint32_t side = 0; side < sides; ++side) {
            bool forward = false;
            met_sides& at = met[key_of(l3d_walked_side(patches[i], side), forward)];
            if (at.count++ == 0) {
                at.first = {i, side};
                at.forward = forward;
            }
        }
    std::vector<l3d_halved_side> result;
    for (std::uint32_t i = 0; i < patches.size(); ++i)
        for (std::uint32_t side = 0; side < sides; ++side) {
            bool forward = false;
            const curve whole = l3d_walked_side(patches[i], side);
            if (met.at(key_of(whole, forward)).count != 1)
                continue;
            const auto [low, high] = whole.split();
            l3d_halved_side halved{.of = {i, side}};
            const auto is_met = [&](std::size_t half, const curve& c) {
                bool runs_forward = false;
                const auto found = met.find(key_of(c, runs_forward));
                if (found == met.end() || found->second.count != 1 ||
                    found->second.first.patch == i)
                    return false;
                halved.beyond[half] = found->second.first;
                halved.turns[half] = found->second.forward == runs_forward;
                return true;
            };
            if (is_met(0, low) && is_met(1, high))
                result.push_back(halved);
        }
    return result;
}
