// SPDX-License-Identifier: MIT
// linear_light: fills the tables of conversion.
#include "raster/color/linear_light_p.h"

#include "raster/color/srgb_light.h"

namespace l3d_detail {

template <class Real> linear_light_of<Real>::linear_light_of() {
    for (std::size_t level = 0; level < light_.size(); ++level) {
        const auto at = static_cast<double>(level);
        light_[level] = static_cast<Real>(l3d_light_of_level(at));
        begins_[level] = level == 0 ? Real(0) : static_cast<Real>(l3d_light_of_level(at - 0.5));
    }
    std::uint8_t level = 0;
    for (std::size_t i = 0; i < guesses; ++i) {
        // Each entry belongs to a value half a step lower, so a rounded index cannot give too large
        // a level.
        const Real least = (static_cast<Real>(i) - Real(0.5)) / (guesses - 1);
        while (level < 255 && begins_[level + 1u] <= least)
            ++level;
        first_[i] = level;
    }
}

const linear_light& linear_light_tables() {
    static const linear_light tables;
    return tables;
}

const linear_light_of<double>& exact_light_tables() {
    static const linear_light_of<double> tables;
    return tables;
}

} // namespace l3d_detail
