// SPDX-License-Identifier: MIT
// join_lines: pairs ends, and walks from line to line.
#include "scene/drawing/line_joints_p.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace l3d_detail {

namespace {

/// The distances, in the picture and in depth, within which ends of lines are the same place. Ends
/// that coincide exactly differ by far less after rounding. Nobody sees gaps as small as these
/// distances.
constexpr double same_place = 1e-3, same_depth = 0.1;

constexpr std::size_t none = ~std::size_t{0};

struct pair_of_ends {
    double straight; ///< cosine of the angle by which the joined line turns
    std::size_t a, b;
};

} // namespace

std::vector<std::vector<joined_line>> join_lines(std::span<const std::array<line_end, 2>> lines) {
    const auto end = [&](std::size_t k) -> const line_end& { return lines[k / 2][k % 2]; };
    std::vector<std::size_t> order(2 * lines.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t k) { return std::pair(end(k).at.x, k); });
    std::vector<pair_of_ends> pairs;
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t k = i + 1; k < order.size(); ++k) {
            const line_end &a = end(order[i]), &b = end(order[k]);
            if (b.at.x - a.at.x > same_place)
                break;
            if (a.group != b.group || std::abs(a.at.y - b.at.y) > same_place ||
                std::abs(a.at.z - b.at.z) > same_depth)
                continue;
            const double product = std::hypot(a.out_x, a.out_y) * std::hypot(b.out_x, b.out_y);
            const double dot = a.out_x * b.out_x + a.out_y * b.out_y;
            pairs.push_back({product > 0 ? -dot / product : -1, order[i], order[k]});
        }
    std::ranges::stable_sort(pairs, std::ranges::greater(), &pair_of_ends::straight);
    std::vector<std::size_t> partner(2 * lines.size(), none);
    for (const pair_of_ends& p : pairs)
        if (partner[p.a] == none && partner[p.b] == none) {
            partner[p.a] = p.b;
            partner[p.b] = p.a;
        }
    std::vector<std::vector<joined_line>> result;
    std::vector<bool> is_used(lines.size(), false);
    const auto walk = [&](std::size_t from) {
        std::vector<joined_line>& row = result.emplace_back();
        for (std::size_t k = from; k != none && !is_used[k / 2]; k = partner[k ^ 1U]) {
            is_used[k / 2] = true;
            row.push_back({k / 2, k % 2 == 1});
        }
    };
    for (std::size_t k = 0; k < partner.size(); ++k)
        if (partner[k] == none && !is_used[k / 2])
            walk(k);
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (!is_used[i])
            walk(2 * i); // all others are closed
    return result;
}

} // namespace l3d_detail
