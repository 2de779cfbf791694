// SPDX-License-Identifier: MIT
// find_values: finds the coverage of pixels from the integrals of their winding numbers.
#ifndef L3D_RASTER_PATHS_AREA_VALUES_P_H
#define L3D_RASTER_PATHS_AREA_VALUES_P_H

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// The covered area of a pixel in which the winding number has two consecutive values. `sum` is the
/// integral of the winding number over the pixel. `is_nonzero` chooses the fill rule nonzero, else
/// even-odd.
inline double area_inside(double sum, bool is_nonzero) {
    return is_nonzero ? (std::abs(sum) < 1 ? std::abs(sum) : 1)
                      : std::abs(sum - 2 * std::rint(sum / 2));
}

/// Finds the coverage of `count` pixels: area_inside() of each sum, times `full`, rounded. `sums`
/// are the integrals of the winding number over the pixels. In each pixel, this number has two
/// consecutive values.
/// Expects: `count` is a multiple of 8; full is at most 255.
void find_values(const double* sums, std::size_t count, bool is_nonzero, double full,
                 std::uint8_t* values);

} // namespace l3d_detail

#endif
