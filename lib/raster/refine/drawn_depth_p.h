// SPDX-License-Identifier: MIT
// drawn_depth: what is hidden in a picture that has been drawn.
#ifndef L3D_RASTER_REFINE_DRAWN_DEPTH_P_H
#define L3D_RASTER_REFINE_DRAWN_DEPTH_P_H

#include "raster/surfaces/coarse_depth_p.h"
#include "tool_2d/pixels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace l3d_detail {

/// The depths of a picture that has been drawn. Where nothing was, they are not defined.
class drawn_depth {
public:
    drawn_depth() = default;
    drawn_depth(const float* first, std::ptrdiff_t pitch, const l3d_pixel_box& window,
                const coarse_depth& coarse)
        : first_(first), pitch_(pitch), window_(window), coarse_(&coarse) {}

    /// What is farther than this is hidden in a pixel; 0 if nothing is in it or in one around it.
    /// The farthest surface there may go on behind the others, as much farther as it is than the
    /// second farthest depth.
    float farthest(std::int32_t x, std::int32_t y) const;

    /// Whether something may be in all tiles around and in a box, and these lie in the window.
    bool drawn_in(const l3d_pixel_box& box) const;

    /// The same as farthest. Expects: drawn_in of a box with the pixel.
    float farthest_inside(std::int32_t x, std::int32_t y) const {
        two_depths depths;
        const float* row = first_ + (y - 1) * pitch_ + x;
        for (int i = 0; i < 3; ++i, row += pitch_)
            for (int column = -1; column < 2; ++column)
                depths.add(row[column]);
        return depths.bound();
    }

    /// Whether all pixels around one, and itself, show what is nearer than `inv_w`. It is fastest
    /// if the one at (x + to_x, y + to_y) does not.
    /// Expects: (x, y) lies in the window; |to_x|, |to_y| <= 1.
    bool hides(std::int32_t x, std::int32_t y, float inv_w, std::int32_t to_x,
               std::int32_t to_y) const {
        const std::int32_t first_x = std::clamp(x + to_x, window_.left, window_.right - 1);
        const std::int32_t first_y = std::clamp(y + to_y, window_.top, window_.bottom - 1);
        return coarse_->drawn_at(first_x, first_y) &&
               !(inv_w > first_[first_y * pitch_ + first_x]) && hides_around(x, y, inv_w);
    }

private:
    /// The two farthest of some depths.
    struct two_depths {
        float first = HUGE_VALF, second = HUGE_VALF;

        void add(float depth) {
            second = std::min(second, std::max(first, depth));
            first = std::min(first, depth);
        }
        float bound() const {
            if (first == 0)
                return 0;
            return std::max(first - (second - first), std::numeric_limits<float>::min());
        }
    };

    bool hides_around(std::int32_t x, std::int32_t y, float inv_w) const;

    const float* first_ = nullptr;
    std::ptrdiff_t pitch_ = 0;
    l3d_pixel_box window_;
    const coarse_depth* coarse_ = nullptr;
};

} // namespace l3d_detail

#endif
