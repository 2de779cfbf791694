// SPDX-License-Identifier: MIT
// l3d_rasterizer_2d_sw_imp: exact lines, exact polygons, clipped by arithmetic and not by stepping.
#include "raster/rasterizer_2d_sw.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace {

using namespace l3d_detail;

/// 2 i d below reaches 2 * 2^32 * 2^32.
__extension__ typedef __int128 wide;

wide floor_quotient(wide n, wide d) {
    return n / d - (n % d < 0 ? 1 : 0);
}
wide ceil_quotient(wide n, wide d) {
    return n / d + (n % d > 0 ? 1 : 0);
}

/// A line as seen along its longer ("major") axis, from its smaller to its larger major end.
///
/// Pixel i of length + 1 is (major + i, minor + ceil(i rise / length - 1/2)): nearest, ties to the
/// smaller minor. As a floor: floor((2 i rise + length - 1) / (2 length)).
struct major_line {
    std::int64_t major, minor;
    std::int64_t length, rise; ///< 0 <= |rise| <= length < 2^32
};

/// Steps first <= i <= last.
struct step_range {
    std::int64_t first, last;
};

/// The steps whose pixels lie in [0, major_size) x [0, minor_size). Expects: length > 0.
step_range visible_steps(const major_line& line, std::int64_t major_size, std::int64_t minor_size) {
    const std::int64_t other_end = line.minor + line.rise;
    if (line.major >= 0 && line.major + line.length < major_size &&
        std::min(line.minor, other_end) >= 0 && std::max(line.minor, other_end) < minor_size)
        return {0, line.length};

    wide first = std::max<std::int64_t>(0, -line.major);
    wide last = std::min<std::int64_t>(line.length, major_size - 1 - line.major);
    const wide length = line.length;
    // 0 <= pixel's minor < minor_size says low <= 2 i rise <= high:
    const wide low = -2 * length * line.minor - length + 1;
    const wide high = 2 * length * (minor_size - line.minor) - length;
    if (line.rise > 0) {
        first = std::max(first, ceil_quotient(low, 2 * wide{line.rise}));
        last = std::min(last, floor_quotient(high, 2 * wide{line.rise}));
    } else if (line.rise < 0) {
        first = std::max(first, ceil_quotient(-high, -2 * wide{line.rise}));
        last = std::min(last, floor_quotient(-low, -2 * wide{line.rise}));
    } else if (line.minor < 0 || line.minor >= minor_size) {
        return {0, -1};
    }
    if (first > last)
        return {0, -1};
    return {static_cast<std::int64_t>(first), static_cast<std::int64_t>(last)};
}

/// Lights the pixels of steps first .. last; strides are in words.
void light(const major_line& line, step_range steps, std::uint32_t* words, std::ptrdiff_t along,
           std::ptrdiff_t across, std::uint32_t color) {
    const std::int64_t full = 2 * line.length;
    const wide start = 2 * wide{steps.first} * line.rise + line.length - 1;
    const wide moved = steps.first == 0 ? 0 : floor_quotient(start, full);
    auto rest = static_cast<std::int64_t>(start - moved * full);
    std::ptrdiff_t at = (line.major + steps.first) * along +
                        (line.minor + static_cast<std::int64_t>(moved)) * across;
    for (std::int64_t i = steps.first;; ++i) {
        words[at] = color;
        if (i == steps.last)
            break;
        at += along;
        rest += 2 * line.rise;
        if (rest >= full) {
            rest -= full;
            at += across;
        } else if (rest < 0) {
            rest += full;
            at -= across;
        }
    }
}

/// Further out the scan would not be exact; one pixel is kept for the shift by half a pixel below.
constexpr double farthest_corner = (scan_limit >> l3d_subpixel_bits) - 1;

bool is_near(const l3d_point_2d& p) { // NaN compares false
    return std::abs(p.x) <= farthest_corner && std::abs(p.y) <= farthest_corner;
}

/// The scan samples pixel (x, y) at x + 1/2, y + 1/2; here it is sampled at x, y.
scan_point to_scan(const l3d_point_2d& p) {
    const auto rounded = [](double v) {
        return static_cast<std::int32_t>(std::lrint(v * l3d_subpixel_one)) + l3d_subpixel_one / 2;
    };
    return {rounded(p.x), rounded(p.y)};
}

/// Twice the area; positive if clockwise on the screen.
wide signed_area(std::span<const scan_point> corners) {
    wide sum = 0;
    scan_point from = corners.back();
    for (const scan_point to : corners) {
        sum += wide{from.x} * to.y - wide{from.y} * to.x;
        from = to;
    }
    return sum;
}

} // namespace

void l3d_rasterizer_2d_sw_imp::do_set_target(l3d_pixels target) {
    target_ = target;
    scan_.set_height(target.height);
}

void l3d_rasterizer_2d_sw_imp::do_clear_buffer() {
    for (int y = 0; y < target_.height; ++y)
        std::ranges::fill(target_.row(y), 0u);
}

void l3d_rasterizer_2d_sw_imp::do_draw_point(int x, int y, std::uint32_t color) {
    if (x >= 0 && x < target_.width && y >= 0 && y < target_.height)
        target_.row(y)[static_cast<std::size_t>(x)] = color;
}

void l3d_rasterizer_2d_sw_imp::do_draw_lines(std::span<const l3d_line_2d> lines,
                                             std::uint32_t color) {
    for (const l3d_line_2d& line : lines)
        draw_line(line, color);
}

void l3d_rasterizer_2d_sw_imp::draw_line(const l3d_line_2d& line, std::uint32_t color) {
    const std::int64_t dx = std::int64_t{line.x1} - line.x0, dy = std::int64_t{line.y1} - line.y0;
    if (dx == 0 && dy == 0)
        return do_draw_point(line.x0, line.y0, color);

    const bool x_major = std::abs(dx) >= std::abs(dy);
    const bool backwards = (x_major ? dx : dy) < 0;
    const std::int64_t x = backwards ? line.x1 : line.x0, y = backwards ? line.y1 : line.y0;
    const std::int64_t sign = backwards ? -1 : 1;
    const major_line walk =
        x_major ? major_line{x, y, sign * dx, sign * dy} : major_line{y, x, sign * dy, sign * dx};
    const step_range steps = x_major ? visible_steps(walk, target_.width, target_.height)
                                     : visible_steps(walk, target_.height, target_.width);
    if (steps.first > steps.last)
        return;
    light(walk, steps, target_.words, x_major ? 1 : target_.stride, x_major ? target_.stride : 1,
          color);
}

void l3d_rasterizer_2d_sw_imp::do_draw_polygon_flatshaded(std::span<const l3d_point_2d> corners,
                                                          std::uint32_t color) {
    if (corners.size() < 3 || !std::ranges::all_of(corners, is_near))
        return;
    corners_.clear();
    std::ranges::transform(corners, std::back_inserter(corners_), to_scan);
    const wide area = signed_area(corners_);
    if (area == 0)
        return;
    const scan_rows rows = scan_.convert(std::span<const scan_point>(corners_), area > 0);
    for (int y = rows.top; y < rows.bottom; ++y) {
        const int first = std::max(scan_.first(y), 0);
        const int last = std::min(scan_.last(y), target_.width);
        if (first < last)
            std::ranges::fill(target_.row(y).subspan(static_cast<std::size_t>(first),
                                                     static_cast<std::size_t>(last - first)),
                              color);
    }
}
