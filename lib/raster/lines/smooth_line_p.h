// SPDX-License-Identifier: MIT
// smooth_line: the pixels of an anti-aliased line, with their coverage.
#ifndef L3D_RASTER_LINES_SMOOTH_LINE_P_H
#define L3D_RASTER_LINES_SMOOTH_LINE_P_H

#include "raster/shapes/exact_steps_p.h"
#include "raster/rasterizer_2d.h"
#include "raster/shapes/scan_edge_p.h"

#include <algorithm>
#include <cstdint>

namespace l3d_detail {

/// An anti-aliased line, one step for each pixel along its longer axis. Each step covers at most
/// two neighbouring pixels across that axis.
///
/// The line's place is kept in whole numbers without rounding, so clipping changes no coverage.
class smooth_line {
public:
    /// Finds the steps of the line that have a pixel in a picture of this size.
    /// Expects: coordinates that are numbers.
    smooth_line(l3d_point_2d from, l3d_point_2d to, l3d_size size);

    /// Calls put(x, y, coverage) for each covered pixel of the picture; 0 < coverage <= 255.
    template <class Put> void for_each_pixel(const Put& put) const {
        if (seen_.first > seen_.last)
            return;
        const auto at = [&](std::int64_t major, std::int64_t minor, int coverage) {
            if (minor >= 0 && minor < minor_size_ && coverage > 0)
                put(static_cast<int>(x_major_ ? major : minor),
                    static_cast<int>(x_major_ ? minor : major), coverage);
        };
        const auto last = static_cast<std::int64_t>(seen_.last);
        exact_steps minors(start_ + seen_.first * slope_, slope_, denominator_);
        for (auto i = static_cast<std::int64_t>(seen_.first); i <= last; ++i, minors.step()) {
            const double second =
                static_cast<double>(minors.rest()) / static_cast<double>(denominator_);
            const double full = 255.0 / l3d_subpixel_one * pen_at(i);
            at(i, minors.floor(), static_cast<int>(full * (1 - second) + 0.5));
            at(i, minors.floor() + 1, static_cast<int>(full * second + 0.5));
        }
    }

private:
    /// The part of a step that lies between the ends of the pen's path. Units: 1/256 pixel.
    int pen_at(std::int64_t major) const {
        const std::int64_t here = l3d_subpixel_one * major;
        return static_cast<int>(l3d_subpixel_one + std::min(here, last_major_) -
                                std::max(here, first_major_));
    }

    bool x_major_;
    /// The ends of the line along its longer axis, in 1/256 pixel.
    std::int64_t first_major_, last_major_;
    std::int64_t minor_size_;
    wide_integer start_, slope_; ///< in step i the line is at (start + i slope) / denominator
    std::int64_t denominator_;
    whole_range seen_;
};

} // namespace l3d_detail

#endif
