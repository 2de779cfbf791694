// SPDX-License-Identifier: MIT
// line_steps: the pixels of a line as steps along its longer axis, and which of them are seen.
#ifndef L3D_RASTER_LINE_STEPS_P_H
#define L3D_RASTER_LINE_STEPS_P_H

#include "raster/exact_steps_p.h"
#include "raster/rasterizer_2d.h"

#include <cstdint>

namespace l3d_detail {

/// A line as seen along its longer ("major") axis, from its smaller to its larger major end.
///
/// Pixel i of length + 1 is (major + i, minor + ceil(i rise / length - 1/2)): nearest, ties to the
/// smaller minor. As a floor: floor((2 i rise + length - 1) / (2 length)).
struct line_steps {
    bool x_major;
    std::int64_t major, minor;
    std::int64_t length, rise;         ///< 0 <= |rise| <= length < 2^32
    std::int64_t first = 0, last = -1; ///< steps first <= i <= last are in the target

    /// The floors above, from step `first` on.
    exact_steps minors() const {
        return {2 * wide_integer{first} * rise + length - 1, 2 * wide_integer{rise}, 2 * length};
    }
};

/// The steps of a line, those in a target of the given size marked. Expects: two different ends.
line_steps steps_of(const l3d_line_2d& line, l3d_size size);

} // namespace l3d_detail

#endif
