// SPDX-License-Identifier: MIT
// l3d_outline_mask: thick lines of bits.
#include "raster/outline_mask.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace {

/// Pixels whose centres are in [low, high], of `count`. Units: pixels.
struct pixel_range {
    int first, end;

    pixel_range(double low, double high, int count)
        : first(static_cast<int>(std::clamp(std::ceil(low - 0.5), 0.0, double(count)))),
          end(static_cast<int>(std::clamp(std::floor(high - 0.5) + 1, 0.0, double(count)))) {}
};

} // namespace

void l3d_outline_mask::begin(l3d_size size) {
    size_ = size;
    row_words_ = (static_cast<std::size_t>(size.width) + 63) / 64;
    words_.assign(row_words_ * static_cast<std::size_t>(size.height), 0);
}

void l3d_outline_mask::add(const l3d_picture_place& from, const l3d_picture_place& to,
                           double radius) {
    const double dx = to.x - from.x, dy = to.y - from.y;
    const double square = dx * dx + dy * dy;
    const pixel_range rows(std::min(from.y, to.y) - radius, std::max(from.y, to.y) + radius,
                           size_.height);
    const pixel_range columns(std::min(from.x, to.x) - radius, std::max(from.x, to.x) + radius,
                              size_.width);
    for (int y = rows.first; y < rows.end; ++y)
        for (int x = columns.first; x < columns.end; ++x) {
            const double px = x + 0.5 - from.x, py = y + 0.5 - from.y;
            const double t = square > 0 ? std::clamp((px * dx + py * dy) / square, 0.0, 1.0) : 0.0;
            const double qx = px - t * dx, qy = py - t * dy;
            if (qx * qx + qy * qy <= radius * radius)
                set(x, y);
        }
}

std::int64_t l3d_outline_mask::count() const {
    std::int64_t result = 0;
    for (const std::uint64_t word : words_)
        result += std::popcount(word);
    return result;
}
