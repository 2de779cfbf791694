// SPDX-License-Identifier: MIT
// mark_seen: finds where a line enters and leaves a picture.
#include "raster/lines/line_steps_p.h"

#include <algorithm>

void l3d_detail::mark_seen(line_steps& line, l3d_size size) {
    const std::int64_t major_size = line.x_major ? size.width : size.height;
    const std::int64_t minor_size = line.x_major ? size.height : size.width;
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
