// SPDX-License-Identifier: MIT
// find_values: finds the values of pixels from the integrals of their windings.
#ifndef L3D_RASTER_PATHS_AREA_VALUES_P_H
#define L3D_RASTER_PATHS_AREA_VALUES_P_H

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// The area inside of a pixel, if windings there take two consecutive values. `sum` is their
/// integral, `is_nonzero` the rule.
inline double area_inside(double sum, bool is_nonzero) {
    return is_nonzero ? (std::abs(sum) < 1 ? std::abs(sum) : 1)
                      : std::abs(sum - 2 * std::rint(sum / 2));
}

/// Finds the values of such pixels: the areas times `full`, rounded.
/// Expects: `count` is a multiple of 8; full is at most 255.
void find_values(const double* sums, std::size_t count, bool is_nonzero, double full,
                 std::uint8_t* values);

} // namespace l3d_detail

#endif
