// SPDX-License-Identifier: MIT
// line_cover: a picture of lines' coverage, before it has colours.
//
// Neighbouring triangles share a side, and each of them draws it. A pixel gets the largest of their
// coverages, so drawing a line twice changes nothing.
#ifndef L3D_RASTER_LINES_LINE_COVER_P_H
#define L3D_RASTER_LINES_LINE_COVER_P_H

#include "raster/depth_buffer.h"
#include "raster/surface_part.h"
#include "raster/shapes/blend_p.h"
#include "raster/lines/line_pixels_p.h"
#include "raster/shapes/scan_polygon_p.h"
#include "raster/lines/smooth_line_p.h"
#include "raster/surface_rasterizer.h"
#include "tool_2d/pixels.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// Calls visit(x, y, along, coverage) for the pixels of a line between two vertices. `along` goes
/// from 0 at the first vertex to 1 at the second vertex. Pixels of a line that is not smooth are
/// covered wholly.
/// Units:   coverage from 1 to 255.
template <class Visit>
void visit_side(const l3d_micro_vertex& a, const l3d_micro_vertex& b, l3d_size size, bool smooth,
                const Visit& visit) {
    if (!smooth)
        return visit_line(side_of(a, b), size,
                          [&](int x, int y, double along) { visit(x, y, along, 255); });
    const l3d_point_2d from = line_place(a.x, a.y), to = line_place(b.x, b.y);
    const double dx = to.x - from.x, dy = to.y - from.y, square = dx * dx + dy * dy;
    smooth_line(from, to, size).for_each_pixel([&](int x, int y, int coverage) {
        const double part = square > 0 ? ((x - from.x) * dx + (y - from.y) * dy) / square : 0;
        visit(x, y, std::clamp(part, 0.0, 1.0), coverage);
    });
}

/// Raises a pixel's word in a picture of coverage to a line's coverage, if the line's is larger.
inline void cover_pixel(std::uint32_t& word, int coverage) {
    word = std::max(word, static_cast<std::uint32_t>(coverage));
}

/// Raises a pixel's word in a picture of coverage to a line's coverage, if the line's is larger.
/// For fog, it also keeps the depth of the pixel's nearest line in `depth`, which has no meaning
/// while the coverage is 0.
inline void cover_pixel(std::uint32_t& word, float& depth, int coverage, double inv_w) {
    const auto here = static_cast<float>(inv_w);
    depth = word == 0 ? here : std::max(depth, here);
    cover_pixel(word, coverage);
}

/// Turns rows of a picture from coverage into colours. If the shading has fog, the depths tell the
/// amount of fog.
inline void color_cover(const l3d_pixels& picture, scan_rows rows, const l3d_shading& shading,
                        std::uint32_t line_color, const l3d_depth_buffer& depths) {
    const bool is_foggy = shading.fog.is_on();
    for (std::int32_t row = rows.top; row < rows.bottom; ++row) {
        const std::uint32_t ground = shading.background.word(row, picture.height);
        const std::uint32_t fog = shading.fog.in_row(shading.background, row, picture.height);
        const std::span<std::uint32_t> words = picture.row(row);
        for (std::size_t x = 0; x < words.size(); ++x) {
            const auto coverage = static_cast<int>(words[x] & 255);
            words[x] = ground;
            if (coverage > 0)
                words[x] = blended_over_gap(
                    ground,
                    is_foggy ? shading.fogged(line_color, fog, depths.row(row)[x]) : line_color,
                    coverage);
        }
    }
}

} // namespace l3d_detail

#endif
