// SPDX-License-Identifier: MIT
// fill_pieces: cuts folded quads at their projective centre, and skew ones into halves.
#include "raster/surfaces/fill_kernel_p.h"

#include "raster/surfaces/quad_cut_p.h"
#include "raster/shaders/surface_shader_p.h"

#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <vector>

namespace l3d_detail {
namespace {

/// Adds triangles that were cut from quads to the queue's pieces.
class piece_maker {
public:
    piece_maker(const fill_target& to, std::uint32_t material)
        : shading_(to.shading), pieces_(to.queue.pieces), material_(material),
          has_normals_(to.words.has_normals) {}

    void add(const std::array<l3d_micro_vertex, 3>& v) {
        const float of_all =
            shading_.mode == l3d_shade::flat ? 255 * polygon_intensity(v, shading_) : 0;
        fill_piece& piece = pieces_.emplace_back();
        piece.material = material_;
        for (std::size_t i = 0; i < v.size(); ++i) {
            const std::array<float, 3> light = light_of(v[i], of_all);
            piece.corners[i] = {v[i].x,         v[i].y,         bits(v[i].inv_w),
                                bits(light[0]), bits(light[1]), bits(light[2])};
        }
    }

private:
    static std::int32_t bits(float number) { return std::bit_cast<std::int32_t>(number); }

    std::array<float, 3> light_of(const l3d_micro_vertex& vertex, float of_all) const {
        switch (has_normals_ ? l3d_shade::lambert : shading_.mode) {
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
    std::uint32_t material_;
    bool has_normals_;
};

} // namespace

void fill_put_by(const fill_target& to, std::size_t i, bool in_pieces) {
    const fill_queue& queue = to.queue;
    const std::int32_t name = queue.name[i];
    assert(name != fill_queue::piece); // lanes take every piece
    const std::uint32_t material = to.words.has_materials ? queue.material[i] : 0;
    if (name < 0) {
        to.rest.triangles.push_back({static_cast<const l3d_micro_triangles*>(queue.source[i]),
                                     static_cast<std::size_t>(-1 - name), material});
        return;
    }
    const auto* const grid = static_cast<const l3d_micro_grid*>(queue.source[i]);
    const auto index = static_cast<std::size_t>(name);
    if (!in_pieces) {
        to.rest.quads.push_back({grid, index, material});
        return;
    }
    const quad_corners corners = corners_of(*grid, index);
    const quad_turns turns(corners);
    piece_maker pieces(to, material);
    const auto add = [&](auto piece, std::int64_t area2) {
        if (grid->shows_both)
            show_side(piece, area2);
        pieces.add(piece);
    };
    if (to.shading.mode == l3d_shade::levels)
        cut_folded_levels(corners, grid->is_parallel, turns, add);
    else
        cut_quad(corners, grid->is_parallel, turns, add);
}

} // namespace l3d_detail
