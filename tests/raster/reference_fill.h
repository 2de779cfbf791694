// SPDX-License-Identifier: MIT
// The slow, obvious twin of the surface rasterizer: edge functions over every pixel.
#ifndef L3D_TESTS_RASTER_REFERENCE_FILL_H
#define L3D_TESTS_RASTER_REFERENCE_FILL_H

#include "raster/surface_part.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace reference {

using corners = std::vector<l3d_micro_vertex>;

/// Twice the area of a, b, c; positive if they turn right on the screen.
inline std::int64_t area2(const l3d_micro_vertex& a, const l3d_micro_vertex& b,
                          const l3d_micro_vertex& c) {
    return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
           (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

inline std::int64_t area2(const corners& v) {
    std::int64_t sum = 0;
    for (std::size_t i = 1; i + 1 < v.size(); ++i)
        sum += area2(v[0], v[i], v[i + 1]);
    return sum;
}

/// Whether a pixel centre is inside a convex polygon, or on a left or top edge.
inline bool covers(const corners& v, int column, int row) {
    const std::int64_t total = area2(v);
    if (total == 0)
        return false;
    l3d_micro_vertex centre;
    centre.x = 256 * column + 128;
    centre.y = 256 * row + 128;
    for (std::size_t i = 0; i < v.size(); ++i) {
        const l3d_micro_vertex& next = v[(i + 1) % v.size()];
        const l3d_micro_vertex& a = total > 0 ? v[i] : next; // clockwise on the screen
        const l3d_micro_vertex& b = total > 0 ? next : v[i];
        if (a.x == b.x && a.y == b.y)
            continue;
        const std::int64_t side = area2(a, b, centre);
        const bool left = b.y < a.y, top = b.y == a.y && b.x > a.x;
        if (side < 0 || (side == 0 && !left && !top))
            return false;
    }
    return true;
}

/// Whether the diagonals of a convex quad are far from halving each other: the differences of the
/// areas on either side of each, together, are more than half the quad.
inline bool is_skew(const corners& v) {
    if (v.size() != 4)
        return false;
    const std::int64_t across = area2(v[0], v[1], v[3]) - area2(v[1], v[2], v[3]);
    const std::int64_t along = area2(v[0], v[1], v[2]) - area2(v[0], v[2], v[3]);
    return 2 * (std::abs(across) + std::abs(along)) > std::abs(area2(v));
}

/// The two triangles whose smaller one is larger.
inline std::vector<corners> halves(const corners& v) {
    const auto smaller = [](const std::vector<corners>& two) {
        return std::min(std::abs(area2(two[0])), std::abs(area2(two[1])));
    };
    const std::vector<corners> one{{v[0], v[1], v[2]}, {v[0], v[2], v[3]}};
    const std::vector<corners> other{{v[1], v[2], v[3]}, {v[1], v[3], v[0]}};
    return smaller(other) > smaller(one) ? other : one;
}

/// The convex polygons that a triangle or quad is filled as: itself, or two triangles if it is
/// skew, or, if it turns both ways, four triangles around its weighted mean. Collinear corners are
/// nothing.
inline std::vector<corners> pieces(const corners& quad) {
    bool right = false, left = false;
    for (std::size_t i = 0; i < quad.size(); ++i) {
        const std::int64_t turn =
            area2(quad[i], quad[(i + 1) % quad.size()], quad[(i + 2) % quad.size()]);
        right = right || turn > 0;
        left = left || turn < 0;
    }
    if (!right && !left)
        return {};
    if (!(right && left))
        return is_skew(quad) ? halves(quad) : std::vector<corners>{quad};
    double sum = 0, x = 0, y = 0, normal[3] = {0, 0, 0};
    for (const l3d_micro_vertex& v : quad) {
        const double w = 1.0 / static_cast<double>(v.inv_w);
        sum += w;
        x += w * v.x;
        y += w * v.y;
        for (int i = 0; i < 3; ++i)
            normal[i] += w * static_cast<double>(v.normal[i]);
    }
    l3d_micro_vertex mean;
    mean.x = static_cast<std::int32_t>(std::nearbyint(x / sum));
    mean.y = static_cast<std::int32_t>(std::nearbyint(y / sum));
    mean.inv_w = static_cast<float>(4.0 / sum);
    for (int i = 0; i < 3; ++i)
        mean.normal[i] = static_cast<float>(normal[i] / sum);
    std::vector<corners> result;
    for (std::size_t i = 0; i < 4; ++i)
        result.push_back({quad[i], quad[(i + 1) % 4], mean});
    return result;
}

/// A number given at the corners, at a pixel centre: on the triangle's plane, or on the plane that
/// has the quad's differences along both diagonals and its mean.
///
/// The slopes are solved by Cramer's rule, the mean is taken at the mean of the corners.
inline long double at_centre(const corners& v, const std::vector<float>& number, int column,
                             int row) {
    const std::size_t last = v.size() - 1;
    const std::size_t from1 = 0, to1 = v.size() == 4 ? 2 : 1, from2 = v.size() == 4 ? 1 : 0;
    const long double x1 = static_cast<long double>(v[to1].x) - v[from1].x;
    const long double y1 = static_cast<long double>(v[to1].y) - v[from1].y;
    const long double x2 = static_cast<long double>(v[last].x) - v[from2].x;
    const long double y2 = static_cast<long double>(v[last].y) - v[from2].y;
    const long double n1 = static_cast<long double>(number[to1]) - number[from1];
    const long double n2 = static_cast<long double>(number[last]) - number[from2];
    const long double determinant = x1 * y2 - y1 * x2;
    long double mean_x = 0, mean_y = 0, mean = 0;
    for (std::size_t i = 0; i < v.size(); ++i) {
        mean_x += static_cast<long double>(v[i].x) / static_cast<long double>(v.size());
        mean_y += static_cast<long double>(v[i].y) / static_cast<long double>(v.size());
        mean += static_cast<long double>(number[i]) / static_cast<long double>(v.size());
    }
    const long double dx = 256 * column + 128 - mean_x, dy = 256 * row + 128 - mean_y;
    return mean + ((n1 * y2 - n2 * y1) * dx + (n2 * x1 - n1 * x2) * dy) / determinant;
}

} // namespace reference

#endif
