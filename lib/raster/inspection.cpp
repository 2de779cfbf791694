// SPDX-License-Identifier: MIT
// l3d_inspection: colours of numbers and of stripes.
#include "raster/inspection.h"

#include "raster/refine/linear_light_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace {

using l3d_detail::linear_light;
using l3d_detail::linear_light_tables;

/// Five stops from -scale to scale.
constexpr std::array<std::uint32_t, 5> of_curvature{0x001f3fb4, 0x0048a8dc, 0x00f4f4f4, 0x00f0a040,
                                                    0x00b81f24};
/// Red does not leave the mould, yellow hardly does.
constexpr std::array<std::uint32_t, 5> of_draft{0x00a81c1c, 0x00e06a30, 0x00f6e468, 0x006cb84c,
                                                0x001c7038};
constexpr std::uint32_t no_number = 0x00808080;
constexpr std::uint32_t dark = 0x1c, bright = 0xf0;

std::span<const std::uint32_t> stops_of(l3d_shade shade) {
    return shade == l3d_shade::draft ? std::span(of_draft) : std::span(of_curvature);
}

/// The part of [0, t] that is bright, in widths of a stripe; the first one is bright.
double bright_until(double t) {
    const double pairs = std::floor(t / 2);
    return pairs + std::min(t - 2 * pairs, 1.0);
}

} // namespace

std::uint32_t l3d_inspection_color(l3d_shade shade, double number, double scale) {
    if (std::isnan(number))
        return no_number;
    const auto stops = stops_of(shade);
    const auto last = static_cast<double>(stops.size() - 1);
    const double at = std::clamp((number / scale + 1) / 2, 0.0, 1.0) * last;
    const double first = std::min(std::floor(at), last - 1), way = at - first;
    const auto i = static_cast<std::size_t>(first);
    std::uint32_t word = 0;
    for (int shift = 0; shift < 24; shift += 8) {
        const double from = stops[i] >> shift & 255, to = stops[i + 1] >> shift & 255;
        word |= static_cast<std::uint32_t>(from + way * (to - from) + 0.5) << shift;
    }
    return word;
}

std::uint32_t l3d_stripe_color(double angle, double width, double stripe) {
    if (std::isnan(angle) || std::isnan(width))
        return no_number;
    // No angle is below 0 or above 180 degrees. A narrower part is as good as a point.
    constexpr double least = 1e-6, most_angle = 180;
    const double part = std::max(width, least * stripe);
    const double begin = std::max(angle - part / 2, 0.0) / stripe;
    const double end = std::min(angle + part / 2, most_angle) / stripe;
    const double share =
        end > begin ? (bright_until(end) - bright_until(begin)) / (end - begin) : 0;
    const linear_light& tables = linear_light_tables();
    const float light = tables.light(dark) + static_cast<float>(std::clamp(share, 0.0, 1.0)) *
                                                 (tables.light(bright) - tables.light(dark));
    return tables.level(light) * 0x010101u;
}

std::vector<std::uint32_t> l3d_inspection_colors(l3d_shade shade,
                                                 const l3d_inspection& inspection) {
    if (shade != l3d_shade::zebra && shade != l3d_shade::isophotes) {
        const auto stops = stops_of(shade);
        return {stops.begin(), stops.end()};
    }
    constexpr int steps = 720; // a quarter of a degree each
    std::vector<std::uint32_t> colors;
    for (int i = 0; i <= steps; ++i)
        colors.push_back(l3d_stripe_color(180.0 * i / steps, 0, inspection.stripe));
    return colors;
}
