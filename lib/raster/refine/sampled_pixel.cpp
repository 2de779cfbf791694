// SPDX-License-Identifier: MIT
// sampled_pixel: samples that are covered, samples that are seen.
#include "raster/refine/sampled_pixel_p.h"

#include <algorithm>
#include <array>

namespace l3d_detail {

namespace {

/// The samples of a pixel that a polygon covers.
coverage coverage_of(const fragment_polygon& polygon, scan_point pixel) {
    std::array<pixel_line, 4> lines;
    std::size_t crossing = 0;
    const auto corners = static_cast<std::size_t>(polygon.corners);
    const bool clockwise = polygon.area2() > 0;
    for (std::size_t i = 0; i < corners; ++i) {
        const std::size_t next = (i + 1) % corners;
        const scan_point a{polygon.x[i], polygon.y[i]}, b{polygon.x[next], polygon.y[next]};
        const pixel_line line =
            clockwise ? pixel_line::between(a, b, pixel) : pixel_line::between(b, a, pixel);
        if (line.holds_none())
            return {};
        if (!line.holds_all())
            lines[crossing++] = line;
    }
    return covered_by(lines.data(), crossing);
}

pixel_plane depth_of(const fragment_polygon& polygon, scan_point pixel) {
    const auto planes =
        planes_of<1>(polygon, [](const l3d_micro_vertex& v) { return std::array{v.inv_w}; });
    constexpr double half_unit = 0.5;
    return {planes.number(0, pixel.x, pixel.y), half_unit * planes.along_x(0),
            half_unit * planes.along_y(0)};
}

} // namespace

void sampled_pixel::add(const fragment_polygon& polygon) {
    fragments_.push_back({&polygon, {}});
    for (std::size_t at = fragments_.size() - 1;
         at > 0 && polygon.nearest > fragments_[at - 1].polygon->nearest; --at)
        std::swap(fragments_[at], fragments_[at - 1]);
}

/// Takes from each fragment the samples where another one is nearer. Samples of fragments behind a
/// pixel that is full are never looked for.
void sampled_pixel::hide() {
    coverage any;
    float farthest = 0;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < fragments_.size(); ++i) {
        fragment next = fragments_[i];
        if (any.full() && farthest >= next.polygon->nearest)
            break;
        next.seen = coverage_of(*next.polygon, corner_);
        if (next.seen.empty())
            continue;
        for (std::size_t k = 0; k < kept && !next.seen.empty(); ++k) {
            fragment& before = fragments_[k];
            const coverage both = next.seen & before.seen;
            if (both.empty())
                continue;
            if (before.polygon->farthest >= next.polygon->nearest) {
                next.seen = next.seen.without(both);
                continue;
            }
            const coverage nearer = both & above_zero(depth_of(*next.polygon, corner_) -
                                                      depth_of(*before.polygon, corner_));
            before.seen = before.seen.without(nearer);
            next.seen = next.seen.without(both.without(nearer));
        }
        any = any | next.seen;
        farthest = kept == 0 ? next.polygon->farthest : std::min(farthest, next.polygon->farthest);
        fragments_[kept++] = next;
    }
    fragments_.resize(kept);
}

} // namespace l3d_detail
