// SPDX-License-Identifier: MIT
// l3d_error_color: the colours of mode `error`.
#ifndef L3D_DICE_ERROR_COLOR_H
#define L3D_DICE_ERROR_COLOR_H

#include <algorithm>
#include <cstdint>

/// Makes the pixel word that shows a certified error in mode `error`. The colour is green for no
/// error, yellow at half of the tolerance, and red from the tolerance on.
///
/// Units:   both arguments in the same unit, such as pixels.
/// Expects: neither is NaN; the tolerance is positive and finite.
inline std::uint32_t l3d_error_color(double bound, double tolerance) {
    const double part = std::clamp(bound / tolerance, 0.0, 1.0);
    const auto red = static_cast<std::uint32_t>(255 * std::min(1.0, 2 * part));
    const auto green = static_cast<std::uint32_t>(255 * std::min(1.0, 2 - 2 * part));
    return red << 16 | green << 8;
}

#endif
