// SPDX-License-Identifier: MIT
// drawn_depth: nine depths of a tile or of several.
#include "raster/refine/drawn_depth_p.h"

#include <algorithm>

namespace l3d_detail {

namespace {

/// A pixel and those around it, so far as they are in the window.
struct neighbourhood {
    std::int32_t left, top, right, bottom; ///< ends included

    neighbourhood(std::int32_t x, std::int32_t y, const l3d_pixel_box& window)
        : left(std::max(x - 1, window.left)), top(std::max(y - 1, window.top)),
          right(std::min(x + 1, window.right - 1)), bottom(std::min(y + 1, window.bottom - 1)) {}

    /// Whether something may be in each of their tiles, of which there are four at most.
    bool drawn(const coarse_depth& coarse) const {
        const bool wide = left / depth_tile::width != right / depth_tile::width;
        const bool high = top / depth_tile::height != bottom / depth_tile::height;
        return coarse.drawn_at(left, top) && (!wide || coarse.drawn_at(right, top)) &&
               (!high ||
                (coarse.drawn_at(left, bottom) && (!wide || coarse.drawn_at(right, bottom))));
    }
};

} // namespace

float drawn_depth::farthest(std::int32_t x, std::int32_t y) const {
    const neighbourhood near(x, y, window_);
    if (!near.drawn(*coarse_))
        return 0;
    two_depths depths;
    const float* row = first_ + near.top * pitch_;
    for (std::int32_t i = near.top; i <= near.bottom; ++i, row += pitch_)
        for (std::int32_t column = near.left; column <= near.right; ++column)
            depths.add(row[column]);
    return depths.bound();
}

bool drawn_depth::drawn_in(const l3d_pixel_box& box) const {
    const l3d_pixel_box around = box.grown(1);
    if (around.intersected(window_) != around)
        return false;
    for (std::int32_t y = around.top; y < around.bottom + depth_tile::height;
         y += depth_tile::height)
        for (std::int32_t x = around.left; x < around.right + depth_tile::width;
             x += depth_tile::width)
            if (!coarse_->drawn_at(std::min(x, around.right - 1), std::min(y, around.bottom - 1)))
                return false;
    return true;
}

bool drawn_depth::hides_around(std::int32_t x, std::int32_t y, float inv_w) const {
    const neighbourhood near(x, y, window_);
    if (!near.drawn(*coarse_))
        return false;
    const float* row = first_ + near.top * pitch_;
    for (std::int32_t i = near.top; i <= near.bottom; ++i, row += pitch_)
        for (std::int32_t column = near.left; column <= near.right; ++column)
            if (inv_w > row[column])
                return false;
    return true;
}

} // namespace l3d_detail
