// SPDX-License-Identifier: MIT
// fill_pieces: folded quads round their projective centre, skew ones in halves.
#include "raster/fill_pieces_p.h"

#include "raster/attribute_plane_p.h"
#include "raster/projective_centre_p.h"
#include "raster/surface_shader_p.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace l3d_detail {
namespace {

using quad_corners = std::array<l3d_micro_vertex, 4>;

quad_corners corners_of(const l3d_micro_grid& grid, std::size_t p00) {
    const std::size_t p01 = p00 + static_cast<std::size_t>(grid.pitch);
    const auto vertex = [&](std::size_t i) {
        return l3d_micro_vertex{grid.x[i],
                                grid.y[i],
                                grid.inv_w[i],
                                {grid.normal[0][i], grid.normal[1][i], grid.normal[2][i]}};
    };
    return {vertex(p00), vertex(p00 + 1), vertex(p01 + 1), vertex(p01)};
}

/// Adds a triangle to the queue's pieces.
class piece_maker {
public:
    explicit piece_maker(const fill_target& to) : shading_(to.shading), pieces_(to.queue.pieces) {}

    void add(const l3d_micro_vertex& a, const l3d_micro_vertex& b, const l3d_micro_vertex& c) {
        const std::array<l3d_micro_vertex, 3> v{a, b, c};
        const float of_all =
            shading_.mode == l3d_shade::flat ? 255 * polygon_intensity(v, shading_) : 0;
        fill_piece& piece = pieces_.emplace_back();
        for (std::size_t i = 0; i < v.size(); ++i) {
            const std::array<float, 3> light = light_of(v[i], of_all);
            piece[i] = {v[i].x,         v[i].y,         bits(v[i].inv_w),
                        bits(light[0]), bits(light[1]), bits(light[2])};
        }
    }

private:
    static std::int32_t bits(float number) { return std::bit_cast<std::int32_t>(number); }

    std::array<float, 3> light_of(const l3d_micro_vertex& vertex, float of_all) const {
        switch (shading_.mode) {
        case l3d_shade::gouraud:
            return {255 * vertex_intensity(vertex, shading_), 0, 0};
        case l3d_shade::flat:
            return {of_all, 0, 0};
        default:
            return {vertex.normal[0], vertex.normal[1], vertex.normal[2]};
        }
    }

    const l3d_shading& shading_;
    std::vector<fill_piece>& pieces_;
};

scan_point position(const l3d_micro_vertex& v) {
    return {v.x, v.y};
}

/// Twice the area of the triangle that a corner makes with its neighbours.
std::int64_t turn_at(const quad_corners& v, std::size_t i) {
    const scan_point at = position(v[i]);
    return cross(at - position(v[(i + 3) % 4]), position(v[(i + 1) % 4]) - at);
}

void cut(const quad_corners& v, piece_maker pieces) {
    const std::array<std::int64_t, 4> turns{turn_at(v, 0), turn_at(v, 1), turn_at(v, 2),
                                            turn_at(v, 3)};
    const auto [least, most] = std::minmax_element(turns.begin(), turns.end());
    if ((*least < 0 && *most > 0) || turns[0] + turns[2] == 0) {
        const l3d_micro_vertex centre = projective_centre(v);
        for (std::size_t i = 0; i < 4; ++i)
            pieces.add(v[i], v[(i + 1) % 4], centre);
        return;
    }
    const auto smaller = [&](std::size_t i) {
        return std::min(std::abs(turns[i]), std::abs(turns[i + 2]));
    };
    const std::size_t first = smaller(0) > smaller(1) ? 1 : 0;
    pieces.add(v[first], v[first + 1], v[first + 2]);
    pieces.add(v[first], v[first + 2], v[(first + 3) % 4]);
}

} // namespace

void fill_put_by(const fill_target& to, std::size_t i, bool in_pieces) {
    const fill_queue& queue = to.queue;
    const std::int32_t name = queue.name[i];
    assert(name != fill_queue::piece); // pieces are no more unlike than lanes take
    if (name < 0) {
        to.rest.triangles.push_back({static_cast<const l3d_micro_triangles*>(queue.source[i]),
                                     static_cast<std::size_t>(-1 - name)});
        return;
    }
    const auto* const grid = static_cast<const l3d_micro_grid*>(queue.source[i]);
    const auto index = static_cast<std::size_t>(name);
    if (in_pieces)
        cut(corners_of(*grid, index), piece_maker(to));
    else
        to.rest.quads.push_back({grid, index});
}

} // namespace l3d_detail
