// SPDX-License-Identifier: MIT
// pixel_centroid: clip, then sum up triangles.
#include "raster/refine/pixel_centroid_p.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace l3d_detail {

namespace {

/// A convex polygon in a square; each of its four sides may add a corner to the four of before.
struct outline {
    std::array<pixel_place, 8> v{};
    std::size_t count = 0;

    void add(pixel_place p) { v[count++] = p; }
};

/// What lies on the side of a line where `inside` is not negative. Expects: `inside` is linear.
template <class Inside> outline clipped(const outline& all, const Inside& inside) {
    outline result;
    for (std::size_t i = 0; i < all.count; ++i) {
        const pixel_place a = all.v[i], b = all.v[(i + 1) % all.count];
        const double at_a = inside(a), at_b = inside(b);
        if (at_a >= 0)
            result.add(a);
        if ((at_a >= 0) != (at_b >= 0)) {
            const double part = at_a / (at_a - at_b);
            result.add({a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)});
        }
    }
    return result;
}

} // namespace

pixel_place centroid_in_pixel(const fragment_polygon& polygon, scan_point corner) {
    constexpr double side = l3d_subpixel_one;
    outline of;
    pixel_place mean{0, 0};
    for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.corners); ++i) {
        of.add({double(polygon.x[i] - corner.x), double(polygon.y[i] - corner.y)});
        mean.x += of.v[i].x / polygon.corners;
        mean.y += of.v[i].y / polygon.corners;
    }
    of = clipped(of, [](pixel_place p) { return p.x; });
    of = clipped(of, [](pixel_place p) { return side - p.x; });
    of = clipped(of, [](pixel_place p) { return p.y; });
    of = clipped(of, [](pixel_place p) { return side - p.y; });
    double area = 0, x = 0, y = 0;
    for (std::size_t i = 2; i < of.count; ++i) {
        const pixel_place a = of.v[0], b = of.v[i - 1], c = of.v[i];
        const double part = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        area += part;
        x += part * (a.x + b.x + c.x);
        y += part * (a.y + b.y + c.y);
    }
    pixel_place place{std::clamp(mean.x, 0.0, side), std::clamp(mean.y, 0.0, side)};
    if (area != 0)
        place = {std::clamp(x / (3 * area), 0.0, side), std::clamp(y / (3 * area), 0.0, side)};
    return {corner.x + place.x, corner.y + place.y};
}

} // namespace l3d_detail
