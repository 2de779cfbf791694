// SPDX-License-Identifier: MIT
// l3d_rasterizer_2d_imp: coverage for outputs that cannot mix colours, paths for all.
#include "raster/rasterizer_2d.h"

#include "raster/paths/path_scan_p.h"

#include <algorithm>
#include <cstddef>
#include <vector>

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

void l3d_rasterizer_2d_imp::do_draw_path(const l3d_path& path, const l3d_fill& fill) {
    l3d_detail::path_scan scan;
    const auto spans = scan.convert(
        l3d_detail::order_of(path, fill, l3d_whole({l3d_largest_side, l3d_largest_side})));
    std::vector<std::uint8_t> run;
    for (const l3d_detail::covered_span& s : spans) {
        const int count = s.last - s.first;
        if (s.value >= 0)
            run.assign(static_cast<std::size_t>(count), static_cast<std::uint8_t>(s.value));
        const std::uint8_t* values = s.value >= 0 ? run.data() : scan.values_of(s);
        do_draw_coverage({s.first, s.row, count, 1, values, 0}, fill.color);
    }
}
