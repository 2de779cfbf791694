// SPDX-License-Identifier: MIT
// sampled_pixel: samples that are covered, samples that are seen.
#include "raster/refine/sampled_pixel_p.h"

#include "raster/refine/mean_level_p.h"

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

/// A bit for each of 8 x 8 cells that has a sample, as pair_measures has them.
std::uint64_t cells_of(const coverage& samples) {
    std::uint64_t cells = 0;
    for (std::size_t column = 0; column < sample_pattern::columns; ++column) {
        std::uint64_t rows = samples.word[column / 2] >> sample_pattern::rows * (column % 2);
        rows &= 0xffffffff;
        rows |= rows >> 1 | rows >> 2 | rows >> 3; // bit 4 r: a row from 4 r to 4 r + 3 has one
        rows &= 0x11111111;
        rows = (rows | rows << 16) & 0x0000ffff0000ffff; // to bit 8 r
        rows = (rows | rows << 8) & 0x00ff00ff00ff00ff;
        rows = (rows | rows << 4) & 0x0101010101010101;
        cells |= rows << column;
    }
    return cells;
}

} // namespace

/// In mode l3d_shade::levels: the mean light where the polygon is seen.
light_sum sampled_pixel::light_of_levels(const fragment& of, bool has_color) const {
    constexpr std::uint32_t white = 0xffffff;
    return light_sum::of_level(mean_level(*of.polygon, corner_, cells_of(of.seen)),
                               has_color ? of.polygon->color : white, linear_light_tables());
}

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
