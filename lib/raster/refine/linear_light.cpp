// SPDX-License-Identifier: MIT
// linear_light: the tables.
#include "raster/refine/linear_light_p.h"

#include "raster/srgb_light.h"

namespace l3d_detail {

linear_light::linear_light() {
    for (std::size_t level = 0; level < light_.size(); ++level) {
        const auto at = static_cast<double>(level);
        light_[level] = static_cast<float>(l3d_light_of_level(at));
        begins_[level] = level == 0 ? 0.0f : static_cast<float>(l3d_light_of_level(at - 0.5));
    }
    std::uint8_t level = 0;
    for (std::size_t i = 0; i < guesses; ++i) {
        // Half a guess less, so that rounding of the index cannot make it too large.
        const float least = (static_cast<float>(i) - 0.5f) / (guesses - 1);
        while (level < 255 && begins_[level + 1u] <= least)
            ++level;
        first_[i] = level;
    }
}

const linear_light& linear_light_tables() {
    static const linear_light tables;
    return tables;
}

} // namespace l3d_detail
