// SPDX-License-Identifier: MIT
// polygon_corners: rounds corners, and finds the polygons that cannot be drawn.
#include "raster/shapes/polygon_corners_p.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

namespace {

using namespace l3d_detail;

bool is_near(const far_point& p) {
    return std::abs(p.x) <= scan_limit && std::abs(p.y) <= scan_limit;
}

} // namespace

bool l3d_detail::is_number(l3d_point_2d position) {
    return !std::isnan(position.x) && !std::isnan(position.y);
}

l3d_detail::far_point l3d_detail::lattice_point(l3d_point_2d position) {
    const auto rounded = [](double v) {
        constexpr double most = far_limit - l3d_subpixel_one / 2;
        const double kept = std::clamp(v * l3d_subpixel_one, -most, most);
        return std::int64_t{std::llrint(kept)} + l3d_subpixel_one / 2;
    };
    return {rounded(position.x), rounded(position.y)};
}

bool l3d_detail::polygon_corners::set(std::span<const l3d_point_2d> corners) {
    if (corners.size() < 3 || !std::ranges::all_of(corners, is_number))
        return false;
    far_.clear();
    std::ranges::transform(corners, std::back_inserter(far_), lattice_point);
    wide_integer area = 0;
    far_point from = far_.back();
    for (const far_point to : far_) {
        area += wide_integer{from.x} * to.y - wide_integer{from.y} * to.x;
        from = to;
    }
    clockwise_ = area > 0;
    all_near_ = std::ranges::all_of(far_, is_near);
    near_.clear();
    if (all_near_)
        std::ranges::transform(far_, std::back_inserter(near_), [](const far_point& p) {
            return scan_point{static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y)};
        });
    return area != 0;
}
