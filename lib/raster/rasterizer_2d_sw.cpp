// SPDX-License-Identifier: MIT
// l3d_rasterizer_2d_sw_imp: from steps and spans to words.
#include "raster/rasterizer_2d_sw.h"

#include "raster/flat_polygon_p.h"
#include "raster/line_steps_p.h"

#include <algorithm>
#include <cstddef>

namespace {

using namespace l3d_detail;

/// Lights the pixels of the steps seen; strides are in words.
void light(const line_steps& line, std::uint32_t* words, std::ptrdiff_t along,
           std::ptrdiff_t across, std::uint32_t color) {
    const std::int64_t full = 2 * line.length;
    const wide_integer start = 2 * wide_integer{line.first} * line.rise + line.length - 1;
    const wide_integer moved = line.first == 0 ? 0 : floor_quotient(start, full);
    auto rest = static_cast<std::int64_t>(start - moved * full);
    std::ptrdiff_t at = (line.major + line.first) * along +
                        (line.minor + static_cast<std::int64_t>(moved)) * across;
    for (std::int64_t i = line.first;; ++i) {
        words[at] = color;
        if (i == line.last)
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

} // namespace

void l3d_rasterizer_2d_sw_imp::do_set_target(l3d_pixels target) {
    target_ = target;
    scan_.set_rows({0, target.height});
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
    if (line.x0 == line.x1 && line.y0 == line.y1)
        return do_draw_point(line.x0, line.y0, color);
    const line_steps steps = steps_of(line, target_.size());
    if (steps.first > steps.last)
        return;
    light(steps, target_.words, steps.x_major ? 1 : target_.stride,
          steps.x_major ? target_.stride : 1, color);
}

void l3d_rasterizer_2d_sw_imp::do_draw_polygon_flatshaded(std::span<const l3d_point_2d> corners,
                                                          std::uint32_t color) {
    const int turn = to_scan(corners, corners_);
    if (turn == 0)
        return;
    const scan_rows rows = scan_.convert(std::span<const scan_point>(corners_), turn > 0);
    for (int y = rows.top; y < rows.bottom; ++y) {
        const int first = std::max(scan_.first(y), 0);
        const int last = std::min(scan_.last(y), target_.width);
        if (first < last)
            std::ranges::fill(target_.row(y).subspan(static_cast<std::size_t>(first),
                                                     static_cast<std::size_t>(last - first)),
                              color);
    }
}
