// SPDX-License-Identifier: MIT
// depth_lines: coverage, depth test and paint of wide lines.
#include "raster/lines/depth_lines_p.h"

#include "raster/color/color_mixer_p.h"

#include <algorithm>
#include <cmath>

namespace {

/// The smaller step of depth to either neighbour. A step to another surface, or to none, is larger
/// than one along the surface, so this is the rise of the pixel's own surface.
double rise(double before, double here, double after) {
    return std::min(std::abs(here - before), std::abs(here - after));
}

/// Whether a surface in a pixel hides the point of a line that is at most `away` pixels from the
/// pixel's centre.
///
/// The line may lie on that surface. Over a pixel, 1 / w of the surface rises by g along an axis,
/// so the surface at the line's point may be farther by away g. Besides, an error of e pixels along
/// the normal is e w / focal in the world, or e w / (focal cos a) along the view axis, where a is
/// the angle between both. In 1 / w this is e / (focal w cos a). A plane of that slope has g = tan
/// a / (focal w), and 1 / cos a <= 1 + tan a, so the error is at most e (1 / (focal w) + g).
/// Roundings of the floats add 4 ulps.
bool is_hidden(const l3d_detail::depth_lines::line& of, int x, int y, double away, double inv_w) {
    const auto row = of.depth.row(y);
    const auto at = static_cast<std::size_t>(x);
    const double here = row[at];
    if (here <= inv_w)
        return false;
    const l3d_size size = of.depth.size();
    const auto near_row = [&](int step) -> double {
        const int other = y + step;
        return other >= 0 && other < size.height ? of.depth.row(other)[at] : 0.0F;
    };
    const double left = x > 0 ? row[at - 1] : 0.0F;
    const double right = x + 1 < size.width ? row[at + 1] : 0.0F;
    const double g = rise(left, here, right) + rise(near_row(-1), here, near_row(1));
    const double bias = (away + of.error) * g + of.error * here / of.focal + here * 0x1p-22;
    return here > inv_w + bias;
}

/// The whole pixels whose centres lie between two places, cut to 0 .. count.
int first_pixel(double from, int count) {
    return static_cast<int>(std::clamp(std::ceil(from - 0.5), 0.0, double(count)));
}
int end_pixel(double to, int count) {
    return static_cast<int>(std::clamp(std::floor(to - 0.5) + 1, 0.0, double(count)));
}

} // namespace

void l3d_detail::depth_lines::add(const line& of, const depth_point& from, const depth_point& to) {
    const l3d_size size = of.depth.size();
    const auto width = static_cast<std::size_t>(size.width);
    cells_.resize(width * static_cast<std::size_t>(size.height));
    const double reach = of.smooth ? of.width / 2 + 0.5 : std::max(of.width, 1.0) / 2;
    const double dx = to.x - from.x, dy = to.y - from.y, square = dx * dx + dy * dy;
    const int bottom = end_pixel(std::max(from.y, to.y) + reach, size.height);
    for (int y = first_pixel(std::min(from.y, to.y) - reach, size.height); y < bottom; ++y) {
        // A row crosses the strip of the endless line over 2 reach / sin of the angle between both.
        double left = std::min(from.x, to.x) - reach, right = std::max(from.x, to.x) + reach;
        if (std::abs(dy) > 0.01 * std::abs(dx)) { // else the row holds nearly all of the strip
            const double middle = from.x + (y + 0.5 - from.y) * dx / dy;
            const double half = reach * std::sqrt(square) / std::abs(dy);
            left = std::max(left, middle - half);
            right = std::min(right, middle + half);
        }
        const int end = end_pixel(right, size.width);
        for (int x = first_pixel(left, size.width); x < end; ++x) {
            const double ax = x + 0.5 - from.x, ay = y + 0.5 - from.y;
            const double t = square > 0 ? std::clamp((ax * dx + ay * dy) / square, 0.0, 1.0) : 0.0;
            const double away = std::hypot(ax - t * dx, ay - t * dy);
            const double cover =
                of.smooth ? std::min({reach - away, of.width, 1.0}) : (away <= reach ? 1.0 : 0.0);
            cell& here = cells_[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
            if (!(cover > double{here.cover}))
                continue;
            const double inv_w = from.inv_w + t * (to.inv_w - from.inv_w);
            if (is_hidden(of, x, y, away, inv_w))
                continue;
            if (here.cover == 0)
                covered_.push_back(static_cast<std::size_t>(&here - cells_.data()));
            here = {static_cast<float>(cover), static_cast<float>(inv_w)};
        }
    }
}

void l3d_detail::depth_lines::paint(const l3d_pixels& target, std::uint32_t color,
                                    const l3d_shading& shading) {
    const color_mixer mixer(l3d_blending::coded);
    const auto width = static_cast<std::size_t>(target.width);
    for (const std::size_t index : covered_) {
        const int y = static_cast<int>(index / width);
        std::uint32_t& word = target.row(y)[index % width];
        const cell here = cells_[index];
        std::uint32_t seen = color;
        if (shading.fog.is_on())
            seen = l3d_fog::word(color, shading.fog.in_row(shading.background, y, target.height),
                                 shading.fog.amount(1 / here.inv_w));
        word = mixer.over(word, mixer.color(seen), double{here.cover});
        cells_[index] = {};
    }
    covered_.clear();
}
