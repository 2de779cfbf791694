// SPDX-License-Identifier: MIT
// to_scan: rounding, and the reasons to draw nothing.
#include "raster/flat_polygon_p.h"

#include "raster/line_steps_p.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace {

using namespace l3d_detail;

/// Further out the scan would not be exact; one pixel is kept for the shift by half a pixel below.
constexpr double farthest_corner = (scan_limit >> l3d_subpixel_bits) - 1;

bool is_near(const l3d_point_2d& p) { // NaN compares false
    return std::abs(p.x) <= farthest_corner && std::abs(p.y) <= farthest_corner;
}

/// The scan samples pixel (x, y) at x + 1/2, y + 1/2; here it is sampled at x, y.
scan_point rounded(const l3d_point_2d& p) {
    const auto shifted = [](double v) {
        return static_cast<std::int32_t>(std::lrint(v * l3d_subpixel_one)) + l3d_subpixel_one / 2;
    };
    return {shifted(p.x), shifted(p.y)};
}

} // namespace

int l3d_detail::to_scan(std::span<const l3d_point_2d> corners, std::vector<scan_point>& result) {
    if (corners.size() < 3 || !std::ranges::all_of(corners, is_near))
        return 0;
    result.clear();
    std::ranges::transform(corners, std::back_inserter(result), rounded);
    wide_integer area = 0;
    scan_point from = result.back();
    for (const scan_point to : result) {
        area += wide_integer{from.x} * to.y - wide_integer{from.y} * to.x;
        from = to;
    }
    return area > 0 ? 1 : area < 0 ? -1 : 0;
}
