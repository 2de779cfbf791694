// SPDX-License-Identifier: MIT
// drawn_depth: nine depths of a tile or of several.
#include "raster/refine/drawn_depth_p.h"

#include <algorithm>

namespace l3d_detail {

namespace {

/// A pixel and those around it, so far as they are in the window.
struct neighbourhood {
    std::int32_t left, top, right, bottom; ///< ends included
    bool one_tile;

    neighbourhood(std::int32_t x, std::int32_t y, const l3d_pixel_box& window)
        : left(std::max(x - 1, window.left)), top(std::max(y - 1, window.top)),
          right(std::min(x + 1, window.right - 1)), bottom(std::min(y + 1, window.bottom - 1)),
          one_tile(left / depth_tile::width == right / depth_tile::width &&
                   top / depth_tile::height == bottom / depth_tile::height) {}
};

} // namespace

float drawn_depth::at(std::int32_t x, std::int32_t y) const {
    return coarse_->drawn_at(x, y) ? first_[y * pitch_ + x] : 0.0f;
}

float drawn_depth::farthest(std::int32_t x, std::int32_t y) const {
    const neighbourhood near(x, y, window_);
    if (near.one_tile && !coarse_->drawn_at(x, y))
        return 0;
    float result = at(x, y);
    for (std::int32_t row = near.top; row <= near.bottom; ++row)
        for (std::int32_t column = near.left; column <= near.right; ++column)
            result =
                std::min(result, near.one_tile ? first_[row * pitch_ + column] : at(column, row));
    return result;
}

bool drawn_depth::hides(std::int32_t x, std::int32_t y, float inv_w, std::int32_t to_x,
                        std::int32_t to_y) const {
    const neighbourhood near(x, y, window_);
    if (near.one_tile && !coarse_->drawn_at(x, y))
        return false;
    if (inv_w > at(std::clamp(x + to_x, near.left, near.right),
                   std::clamp(y + to_y, near.top, near.bottom)))
        return false;
    for (std::int32_t row = near.top; row <= near.bottom; ++row)
        for (std::int32_t column = near.left; column <= near.right; ++column)
            if (inv_w > (near.one_tile ? first_[row * pitch_ + column] : at(column, row)))
                return false;
    return true;
}

} // namespace l3d_detail
