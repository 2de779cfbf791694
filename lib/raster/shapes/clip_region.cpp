// SPDX-License-Identifier: MIT
// l3d_clip_region: moves a line's ends along the line until they are inside.
#include "raster/rasterizer_2d.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

/// A coordinate as a whole pixel, for l3d_line_2d. It is clamped to the largest coordinate of
/// paths.
int whole(double at) {
    constexpr double most = 1 << 30;
    return static_cast<int>(std::floor(std::clamp(at, -most, most) + 0.5));
}

l3d_line_2d between_pixels(l3d_point_2d a, l3d_point_2d b) {
    return {whole(a.x), whole(a.y), whole(b.x), whole(b.y)};
}

} // namespace

bool l3d_clip_region::clip(l3d_point_2d& from, l3d_point_2d& to) const {
    // Each end is moved to at most two sides. Rounding at a corner could move it to and fro, so the
    // number of moves is limited.
    constexpr int most_slides = 8;
    for (int i = 0; i < most_slides; ++i) {
        const unsigned a = outcode(from), b = outcode(to);
        if ((a | b) == 0)
            return true;
        if ((a & b) != 0)
            return false;
        l3d_point_2d& out = a != 0 ? from : to;
        const l3d_point_2d in = a != 0 ? to : from;
        const unsigned beyond = a != 0 ? a : b;
        const auto at_height = [&](double y) {
            out = {out.x + (in.x - out.x) * ((y - out.y) / (in.y - out.y)), y};
        };
        const auto at_width = [&](double x) {
            out = {x, out.y + (in.y - out.y) * ((x - out.x) / (in.x - out.x))};
        };
        if ((beyond & above) != 0)
            at_height(least.y);
        else if ((beyond & below) != 0)
            at_height(most.y);
        else if ((beyond & right) != 0)
            at_width(most.x);
        else
            at_width(least.x);
    }
    return false; // the line touches a corner
}

void l3d_clip_region::draw_line(l3d_rasterizer_2d& rasterizer, l3d_point_2d from, l3d_point_2d to,
                                std::uint32_t color) const {
    if (!clip(from, to))
        return;
    const l3d_line_2d line = between_pixels(from, to);
    rasterizer.draw_lines({&line, 1}, color);
}

void l3d_clip_region::draw_border(l3d_rasterizer_2d& rasterizer, std::uint32_t color) const {
    const std::array<l3d_point_2d, 4> corners{
        {{least.x, least.y}, {most.x, least.y}, {most.x, most.y}, {least.x, most.y}}};
    for (std::size_t i = 0; i < 4; ++i) {
        const l3d_line_2d side = between_pixels(corners[i], corners[(i + 1) % 4]);
        rasterizer.draw_lines({&side, 1}, color);
    }
}
