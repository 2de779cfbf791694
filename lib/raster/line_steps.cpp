// SPDX-License-Identifier: MIT
// steps_of: lines clipped by arithmetic and not by stepping.
#include "raster/line_steps_p.h"

#include <algorithm>
#include <cstdlib>

namespace {

using namespace l3d_detail;

void mark_seen(line_steps& line, std::int64_t major_size, std::int64_t minor_size) {
    const std::int64_t other_end = line.minor + line.rise;
    if (line.major >= 0 && line.major + line.length < major_size &&
        std::min(line.minor, other_end) >= 0 && std::max(line.minor, other_end) < minor_size) {
        line.last = line.length;
        return;
    }
    const whole_range among{std::max<std::int64_t>(0, -line.major),
                            std::min<std::int64_t>(line.length, major_size - 1 - line.major)};
    // 0 <= pixel's minor < minor_size, with the floor written out
    const wide_integer length = line.length;
    const whole_range seen =
        where_within(among, 2 * wide_integer{line.rise}, -2 * length * line.minor - length + 1,
                     2 * length * (minor_size - line.minor) - length);
    if (seen.first > seen.last)
        return;
    line.first = static_cast<std::int64_t>(seen.first);
    line.last = static_cast<std::int64_t>(seen.last);
}

} // namespace

l3d_detail::line_steps l3d_detail::steps_of(const l3d_line_2d& line, l3d_size size) {
    const std::int64_t dx = std::int64_t{line.x1} - line.x0, dy = std::int64_t{line.y1} - line.y0;
    const bool x_major = std::abs(dx) >= std::abs(dy);
    const bool backwards = (x_major ? dx : dy) < 0;
    const std::int64_t x = backwards ? line.x1 : line.x0, y = backwards ? line.y1 : line.y0;
    const std::int64_t sign = backwards ? -1 : 1;
    if (x_major) {
        line_steps steps{true, x, y, sign * dx, sign * dy};
        mark_seen(steps, size.width, size.height);
        return steps;
    }
    line_steps steps{false, y, x, sign * dy, sign * dx};
    mark_seen(steps, size.height, size.width);
    return steps;
}
