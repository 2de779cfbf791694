// SPDX-License-Identifier: MIT
// drawn_depth: tells what the depths of a drawn picture hide.
#ifndef L3D_RASTER_REFINE_DRAWN_DEPTH_P_H
#define L3D_RASTER_REFINE_DRAWN_DEPTH_P_H

#include "raster/surfaces/coarse_depth_p.h"
#include "tool_2d/pixels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// The depths of a picture after drawing, to find which polygons can be seen. Depths are undefined
/// in tiles into which nothing was drawn.
class drawn_depth {
public:
    drawn_depth() = default;
    drawn_depth(const float* first, std::ptrdiff_t pitch, const l3d_pixel_box& window,
                const coarse_depth& coarse)
        : first_(first), pitch_(pitch), window_(window), coarse_(&coarse) {}

    /// The farthest depth in a pixel and its eight neighbours; 0 if one of these nine pixels is
    /// empty.
    /// Expects: (x, y) lies in the window.
    float farthest(std::int32_t x, std::int32_t y) const {
        const std::int32_t left = std::max(x - 1, window_.left), top = std::max(y - 1, window_.top),
                           right = std::min(x + 1, window_.right - 1),
                           bottom = std::min(y + 1, window_.bottom - 1);
        // The pixels lie in at most four tiles.
        const bool is_wide = left / depth_tile::width != right / depth_tile::width;
        const bool is_high = top / depth_tile::height != bottom / depth_tile::height;
        if (!coarse_->drawn_at(left, top) || (is_wide && !coarse_->drawn_at(right, top)) ||
            (is_high &&
             (!coarse_->drawn_at(left, bottom) || (is_wide && !coarse_->drawn_at(right, bottom)))))
            return 0;
        float result = HUGE_VALF;
        for (const std::int32_t row : {top, y, bottom}) {
            const float* const depths = first_ + row * pitch_;
            result = std::min({result, depths[left], depths[x], depths[right]});
        }
        return result;
    }

    /// Whether a pixel and all its neighbours show surfaces at least as near as `inv_w`. The
    /// neighbour (x + to_x, y + to_y) is tested first: choose a neighbour that likely shows a
    /// farther surface or none.
    /// Expects: (x, y) lies in the window; |to_x|, |to_y| <= 1.
    bool hides(std::int32_t x, std::int32_t y, float inv_w, std::int32_t to_x,
               std::int32_t to_y) const {
        const std::int32_t first_x = std::clamp(x + to_x, window_.left, window_.right - 1);
        const std::int32_t first_y = std::clamp(y + to_y, window_.top, window_.bottom - 1);
        return coarse_->drawn_at(first_x, first_y) &&
               !(inv_w > first_[first_y * pitch_ + first_x]) && !(inv_w > farthest(x, y));
    }

private:
    const float* first_ = nullptr;
    std::ptrdiff_t pitch_ = 0;
    l3d_pixel_box window_;
    const coarse_depth* coarse_ = nullptr;
};

} // namespace l3d_detail

#endif
