// SPDX-License-Identifier: MIT
// The price of a pixel in the original.
#include "book_raster.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace bench {
namespace {

/// From its first row on, an edge steps x by dx/dy.
struct book_edge {
    float x, step;
    int row, end;
};

book_edge edge_between(const std::array<float, 2>& top, const std::array<float, 2>& bottom) {
    const int row = static_cast<int>(std::ceil(top[1] - 0.5f));
    const int end = static_cast<int>(std::ceil(bottom[1] - 0.5f));
    const float height = bottom[1] - top[1];
    const float step = height > 0 ? (bottom[0] - top[0]) / height : 0;
    return {top[0] + (static_cast<float>(row) + 0.5f - top[1]) * step, step, row, end};
}

} // namespace

book_raster::book_raster(const l3d_pixels& pixels) {
    own_.bytes = reinterpret_cast<unsigned char*>(pixels.words);
    width = static_cast<int>(pixels.stride);
    target = &own_;
}

void book_raster::draw_point(int x, int y, std::uint32_t color) {
    unsigned char* at = target->bytes + (x + y * width) * target->bytes_per_pixel;
    std::uint32_t mask = 0xff;
    for (int shift = 0, i = 0; i < target->bytes_per_pixel; ++i, shift += 8, mask <<= 8)
        *at++ = static_cast<unsigned char>((color & mask) >> shift);
}

void book_raster::draw_line(int x0, int y0, int x1, int y1, std::uint32_t color) {
    const int dx = x1 - x0, dy = y1 - y0;
    const int steps = std::max(std::abs(dx), std::abs(dy));
    if (steps == 0)
        return draw_point(x0, y0, color);
    const float step_x = static_cast<float>(dx) / static_cast<float>(steps);
    const float step_y = static_cast<float>(dy) / static_cast<float>(steps);
    float x = static_cast<float>(x0) + 0.5f, y = static_cast<float>(y0) + 0.5f;
    for (int i = 0; i <= steps; ++i, x += step_x, y += step_y)
        draw_point(static_cast<int>(x), static_cast<int>(y), color);
}

void book_raster::draw_span(int y, int from, int to, std::uint32_t color) {
    for (int x = from; x < to; ++x)
        draw_point(x, y, color);
}

void book_raster::draw_triangle(const std::array<std::array<float, 2>, 3>& corners,
                                std::uint32_t color) {
    auto v = corners;
    std::ranges::sort(v, {}, [](const std::array<float, 2>& p) { return p[1]; });
    book_edge whole = edge_between(v[0], v[2]);
    for (const book_edge half : {edge_between(v[0], v[1]), edge_between(v[1], v[2])})
        for (float x = half.x; whole.row < half.end; ++whole.row) {
            const auto [left, right] = std::minmax(x, whole.x);
            draw_span(whole.row, static_cast<int>(std::ceil(left - 0.5f)),
                      static_cast<int>(std::ceil(right - 0.5f)), color);
            x += half.step;
            whole.x += whole.step;
        }
}

} // namespace bench
