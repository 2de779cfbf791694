// SPDX-License-Identifier: MIT
// fill_pieces: folded quads round their projective centre, skew ones in halves.
#include "raster/fill_pieces_p.h"

#include "raster/attribute_plane_p.h"
#include "raster/projective_centre_p.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <cstdlib>

namespace l3d_detail {
namespace {

using quad_corners = std::array<l3d_micro_vertex, 4>;

l3d_micro_vertex corner_of(const fill_queue& queue, std::size_t k, std::size_t i) {
    const auto& c = queue.corner[k];
    const auto number = [&](std::size_t component) {
        return std::bit_cast<float>(c[component][i]);
    };
    return {c[0][i], c[1][i], number(2), {number(3), number(4), number(5)}};
}

scan_point position(const l3d_micro_vertex& v) {
    return {v.x, v.y};
}

/// Twice the area of the triangle that a corner makes with its neighbours.
std::int64_t turn_at(const quad_corners& v, std::size_t i) {
    const scan_point at = position(v[i]);
    return cross(at - position(v[(i + 3) % 4]), position(v[(i + 1) % 4]) - at);
}

void cut(const quad_corners& v, std::vector<std::array<l3d_micro_vertex, 3>>& pieces) {
    const std::array<std::int64_t, 4> turns{turn_at(v, 0), turn_at(v, 1), turn_at(v, 2),
                                            turn_at(v, 3)};
    const auto [least, most] = std::minmax_element(turns.begin(), turns.end());
    if ((*least < 0 && *most > 0) || turns[0] + turns[2] == 0) {
        const l3d_micro_vertex centre = projective_centre(v);
        for (std::size_t i = 0; i < 4; ++i)
            pieces.push_back({v[i], v[(i + 1) % 4], centre});
        return;
    }
    const auto smaller = [&](std::size_t i) {
        return std::min(std::abs(turns[i]), std::abs(turns[i + 2]));
    };
    const std::size_t first = smaller(0) > smaller(1) ? 1 : 0;
    pieces.push_back({v[first], v[first + 1], v[first + 2]});
    pieces.push_back({v[first], v[first + 2], v[(first + 3) % 4]});
}

} // namespace

void fill_put_by(const fill_target& to, std::size_t i, bool in_pieces) {
    const fill_queue& queue = to.queue;
    const std::int32_t name = queue.name[i];
    assert(name != fill_queue::piece); // pieces are no more unlike than lanes take
    if (name < 0)
        to.rest.triangles.push_back({static_cast<const l3d_micro_triangles*>(queue.source[i]),
                                     static_cast<std::size_t>(-1 - name)});
    else if (in_pieces)
        cut({corner_of(queue, 0, i), corner_of(queue, 1, i), corner_of(queue, 2, i),
             corner_of(queue, 3, i)},
            to.queue.pieces);
    else
        to.rest.quads.push_back(
            {static_cast<const l3d_micro_grid*>(queue.source[i]), static_cast<std::size_t>(name)});
}

} // namespace l3d_detail
