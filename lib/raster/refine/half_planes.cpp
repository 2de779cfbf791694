// SPDX-License-Identifier: MIT
// half_planes: tests each line against each place.
#include "raster/refine/half_planes_p.h"

#include "raster/refine/sample_places_p.h"

#include <algorithm>
#include <cmath>

namespace l3d_detail {

half_planes::half_planes(std::span<const std::int16_t, 64> x, std::span<const std::int16_t, 64> y,
                         int cells) {
    for (std::size_t turn = 0; turn <= turns; ++turn) {
        const double dx = 2.0 * static_cast<double>(turn) / turns - 1, dy = 1 - std::abs(dx);
        std::uint64_t* const row = masks_.data() + turn * in_row;
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double right = (x[i] + 0.5) / cells - 0.5, down = (y[i] + 0.5) / cells - 0.5;
            // The place is on the line's side from a first step on. That is the first one whose
            // middle e has e + dx y - dy x >= 0.
            const double first = std::ceil((0.5 + dy * right - dx * down) * steps - 0.5);
            if (first < steps)
                row[static_cast<std::size_t>(std::max(first, 0.0)) + 1] |= std::uint64_t{1} << i;
        }
        for (std::size_t step = 1; step < steps; ++step)
            row[step + 1] |= row[step];
        row[steps + 1] = ~std::uint64_t{0};
    }
}

const half_planes& planes_of_samples() {
    static const half_planes table(the_samples.x, the_samples.y, sample_places::cells);
    return table;
}

const half_planes& planes_of_pixels() {
    static const half_planes table = [] {
        constexpr std::int16_t side = 8;
        std::array<std::int16_t, 64> x{}, y{};
        for (std::int16_t i = 0; i < side * side; ++i) {
            x[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(i % side);
            y[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(i / side);
        }
        return half_planes(x, y, side);
    }();
    return table;
}

} // namespace l3d_detail
