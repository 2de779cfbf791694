// SPDX-License-Identifier: MIT
// l3d_rasterizer_2d_imp: coverage for outputs that cannot mix colours.
#include "raster/rasterizer_2d.h"

#include <algorithm>
#include <cstddef>

void l3d_rasterizer_2d_imp::do_draw_coverage(const l3d_coverage_2d& shape, std::uint32_t color) {
    constexpr int half = 128;
    const auto covers = [](std::uint8_t value) { return value >= half; };
    for (int y = 0; y < shape.height; ++y) {
        const auto row = shape.row(y);
        for (auto at = std::ranges::find_if(row, covers); at != row.end();) {
            const auto end = std::find_if_not(at, row.end(), covers);
            const l3d_line_2d run{shape.left + static_cast<int>(at - row.begin()), shape.top + y,
                                  shape.left + static_cast<int>(end - row.begin()) - 1,
                                  shape.top + y};
            do_draw_lines({&run, 1}, color);
            at = std::find_if(end, row.end(), covers);
        }
    }
}
