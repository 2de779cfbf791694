// SPDX-License-Identifier: MIT
// depth_lines: covers, depth-tests and paints wide lines.
#include "raster/lines/depth_lines_p.h"

#include "raster/color/color_mixer_p.h"

#include <algorithm>
#include <cmath>

namespace {

/// The change of depth per pixel on the surface that a pixel shows. It is the smaller one of the
/// changes from the pixel to its two neighbours. A change to another surface, or to none, is
/// larger.
double rise(double before, double here, double after) {
    return std::min(std::abs(here - before), std::abs(here - after));
}

/// Whether a surface in a pixel hides the point of a line that is at most `away` pixels from the
/// pixel's centre.
///
/// The line may lie on the surface. Over a pixel, the depth of the surface rises by g along an
/// axis. So the surface at the line's point may be farther by `away` times g. Besides, an error of
/// e pixels along the normal is e / cos a pixels along the view axis, where a is the angle between
/// the normal and this axis. Let p be the change of depth over a pixel's size. A plane of that
/// slope has g = p tan a, and the inverse of cos a is at most 1 + tan a. So the error is at most e
/// (p + g). Roundings of the floats add 4 ulps.
///
/// Where both neighbours show other surfaces, g is no slope. So g is limited to 8 p, the slope of a
/// surface that is seen within 7 degrees of its edge. On a sphere with a radius of r pixels, the
/// slope at d pixels from the outline is sqrt(r / (2 d)). For a radius of 100 pixels, the slope is
/// above 8 within 0.8 pixels of the outline. A line so close to the outline may be cut off.
bool is_hidden(const l3d_detail::depth_lines::line& of, int x, int y, double away, double depth) {
    constexpr double steepest = 8;
    const auto row = of.depth.row(y);
    const auto at = static_cast<std::size_t>(x);
    const double here = row[at];
    if (here <= depth)
        return false;
    const l3d_size size = of.depth.size();
    const auto near_row = [&](int step) -> double {
        const int other = y + step;
        return other >= 0 && other < size.height ? of.depth.row(other)[at] : 0.0F;
    };
    const double left = x > 0 ? row[at - 1] : 0.0F;
    const double right = x + 1 < size.width ? row[at + 1] : 0.0F;
    const double pixel = of.law.per_pixel(here);
    const double g =
        std::min(rise(left, here, right) + rise(near_row(-1), here, near_row(1)), steepest * pixel);
    const double bias = (away + of.error) * g + of.error * pixel + here * 0x1p-22;
    return here > depth + bias;
}

/// The first whole pixel whose centre is at or after a place, limited to 0 .. count. end_pixel()
/// gives the first whole pixel after a place, for the end of a range.
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
        // Measured along a row, the strip around the endless line is as wide as 2 reach over the
        // sine of the line's angle with the row.
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
            const double depth = from.depth + t * (to.depth - from.depth);
            if (is_hidden(of, x, y, away, depth))
                continue;
            if (here.cover == 0)
                covered_.push_back(static_cast<std::size_t>(&here - cells_.data()));
            here = {static_cast<float>(cover), static_cast<float>(depth)};
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
            seen = shading.fogged(color, shading.fog.in_row(shading.background, y, target.height),
                                  here.depth);
        word = mixer.over(word, mixer.color(seen), double{here.cover});
        cells_[index] = {};
    }
    covered_.clear();
}
