// SPDX-License-Identifier: MIT
// triangle_neighbours: pairs sides by a table of their ends.
#include "pipeline/polygons/triangle_neighbours_p.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <tuple>

namespace l3d_detail {

namespace {

std::uint64_t mixed(std::uint64_t key) {
    key *= 0x9e3779b97f4a7c15u;
    return key ^ key >> 32;
}

/// For each vertex, the index of the first vertex at its place.
std::vector<std::uint32_t> names_of_places(std::span<const l3d_polygon_model::vector> vertices) {
    std::vector<std::uint32_t> order(vertices.size()), names(vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto place = [&](std::uint32_t i) {
        return std::tuple(vertices[i][0], vertices[i][1], vertices[i][2]);
    };
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
        return std::tuple_cat(place(a), std::tuple(a)) < std::tuple_cat(place(b), std::tuple(b));
    });
    for (std::size_t i = 0; i < order.size(); ++i)
        names[order[i]] =
            i > 0 && place(order[i - 1]) == place(order[i]) ? names[order[i - 1]] : order[i];
    return names;
}

} // namespace

/// Finds the neighbours of a model's triangles. It compares the vertices' own indices first, since
/// most models have each place once.
void triangle_neighbours::make(const l3d_polygon_model& model) {
    if (model.triangles().data() == model_.triangles().data() &&
        across_.size() == model.triangles().size())
        return;
    model_ = model;
    std::vector<std::uint32_t> names(model.mesh().vertices.size());
    std::iota(names.begin(), names.end(), 0u);
    const bool is_matched = match(names) || match(names_of_places(model.mesh().vertices));
    are_closed_ = is_matched && face_outward();
}

/// Whether each body has a volume that is certainly positive. A body is a set of connected
/// triangles, and its volume a sum of determinants of three vectors from one corner. A
/// determinant's rounding is less than 16 times 2^-53 of the product of the vectors' lengths. Each
/// addition rounds by 2^-53 of less than the sum of these products.
bool triangle_neighbours::face_outward() const {
    const auto triangles = model_.triangles();
    const auto& vertices = model_.mesh().vertices;
    std::vector<bool> is_known(triangles.size(), false);
    std::vector<std::uint32_t> open;
    for (std::uint32_t first = 0; first < triangles.size(); ++first) {
        if (is_known[first] || across_[first][0] == none)
            continue;
        const l3d_polygon_model::vector origin = vertices[triangles[first].corners[0]];
        double volume = 0, lengths = 0, count = 16;
        is_known[first] = true;
        open.push_back(first);
        for (; !open.empty(); ++count) {
            const std::uint32_t t = open.back();
            open.pop_back();
            const auto corner = [&](std::size_t k) {
                return vertices[triangles[t].corners[k]] - origin;
            };
            volume += l3d_dot(corner(0), l3d_cross(corner(1), corner(2)));
            lengths += l3d_length(corner(0)) * l3d_length(corner(1)) * l3d_length(corner(2));
            for (const std::uint32_t other : across_[t])
                if (!is_known[other]) {
                    is_known[other] = true;
                    open.push_back(other);
                }
        }
        if (!(volume > count * 0x1p-53 * lengths))
            return false;
    }
    return true;
}

/// Finds neighbours by the names of sides' ends. Vertices with the same name count as one vertex.
/// Returns whether each side has a neighbour.
bool triangle_neighbours::match(std::span<const std::uint32_t> names) {
    const auto triangles = model_.triangles();
    across_.assign(triangles.size(), {none, none, none});
    std::vector<std::uint32_t> table(std::bit_ceil(6 * triangles.size() + 2), 0);
    const auto ends = [&](std::uint32_t side) {
        const auto& corners = triangles[side / 3].corners;
        return std::pair(names[corners[side % 3]], names[corners[(side + 1) % 3]]);
    };
    const auto has_no_inside = [&](std::uint32_t side) {
        const auto [a, b, c] = triangles[side / 3].corners;
        return names[a] == names[b] || names[b] == names[c] || names[c] == names[a];
    };
    std::size_t alone = 0;
    for (std::uint32_t side = 0; side < 3 * triangles.size(); ++side) {
        if (side % 3 == 0 && has_no_inside(side)) {
            side += 2;
            continue;
        }
        const auto [from, to] = ends(side);
        std::uint32_t& here = across_[side / 3][side % 3];
        std::size_t at = mixed(std::uint64_t{std::min(from, to)} << 32 | std::max(from, to));
        for (++alone;; ++at) {
            std::uint32_t& entry = table[at & (table.size() - 1)];
            if (entry == 0) {
                entry = side + 1;
                break;
            }
            const std::uint32_t before = entry - 1;
            const auto [first, second] = ends(before);
            if (std::minmax(first, second) != std::minmax(from, to))
                continue;
            std::uint32_t& there = across_[before / 3][before % 3];
            if (first == to && there == none) {
                here = before / 3;
                there = side / 3;
                alone -= 2;
            }
            break;
        }
    }
    return alone == 0;
}

} // namespace l3d_detail
