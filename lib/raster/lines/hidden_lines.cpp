// SPDX-License-Identifier: MIT
// l3d_draw_seen_sides: tests depth along lines.
#include "raster/lines/hidden_lines.h"

#include "raster/lines/line_cover_p.h"
#include "raster/shapes/picture_plane.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

void l3d_draw_seen_sides(l3d_pixels target, const l3d_depth_buffer& depth,
                         std::span<const l3d_painter_triangle> triangles,
                         const l3d_shading& shading, const l3d_line_look& look) {
    assert(target.size() == depth.size());
    constexpr double rounding = 0x1p-20; // a few ulps of a float
    constexpr double in_lanes = 1e-5;    // relative to the corners' range, see docs/POLYGONS.md
    l3d_background().fill(target);
    l3d_depth_buffer line_depths;
    line_depths.resize(shading.fog.is_on() ? target.size() : l3d_size{});
    for (const l3d_painter_triangle& t : triangles) {
        const l3d_picture_plane plane(t.v);
        const double rise = l3d_subpixel_one * (std::abs(plane.along_x) + std::abs(plane.along_y));
        if (!std::isfinite(rise))
            continue; // a triangle without area is seen from its edge
        const auto [far, near] = std::minmax({t.v[0].inv_w, t.v[1].inv_w, t.v[2].inv_w});
        const double nearest = near + in_lanes * (double(near) - far);
        for (std::size_t k = 0; k < t.v.size(); ++k) {
            if (!(t.sides >> k & 1))
                continue;
            const l3d_micro_vertex &a = t.v[k], &b = t.v[(k + 1) % 3];
            const double from = a.inv_w, change = double(b.inv_w) - a.inv_w;
            const auto draw = [&](int x, int y, double along, int coverage) {
                const double here = from + along * change, inv_w = std::min(here + rise, nearest);
                const auto column = static_cast<std::size_t>(x);
                if (inv_w * (1 + rounding) < depth.row(y)[column])
                    return;
                std::uint32_t& word = target.row(y)[column];
                if (shading.fog.is_on())
                    l3d_detail::cover_pixel(word, line_depths.row(y)[column], coverage, here);
                else
                    l3d_detail::cover_pixel(word, coverage);
            };
            l3d_detail::visit_side(a, b, target.size(), look.smooth, draw);
        }
    }
    l3d_detail::color_cover(target, {0, target.height}, shading, look.color, line_depths);
}
