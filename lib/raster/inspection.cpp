// SPDX-License-Identifier: MIT
// l3d_inspection: finds the colours of numbers and of stripes.
#include "raster/shade.h"

#include "raster/color/linear_light_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace {

using l3d_detail::linear_light;
using l3d_detail::linear_light_tables;

/// The colours of curvature: five stops from -scale to scale.
constexpr std::array<std::uint32_t, 5> of_curvature{0x001f3fb4, 0x0048a8dc, 0x00f4f4f4, 0x00f0a040,
                                                    0x00b81f24};
/// The colours of draft angles. A part that is shown red does not leave its mould; a yellow part
/// hardly leaves it.
constexpr std::array<std::uint32_t, 5> of_draft{0x00a81c1c, 0x00e06a30, 0x00f6e468, 0x006cb84c,
                                                0x001c7038};
constexpr std::uint32_t no_number = 0x00808080;
constexpr std::uint32_t dark = 0x1c, bright = 0xf0;

std::span<const std::uint32_t> stops_of(l3d_shade shade) {
    return shade == l3d_shade::draft ? std::span(of_draft) : std::span(of_curvature);
}

/// Integrals over bright and dark stripes by turns, which begin at 0 with a bright stripe. Units:
/// widths of a stripe.
///
/// `first` is the length of the bright part of [0, t], and `second` is the integral of `first`. At
/// both ends, the stripes go on as in a mirror.
class stripe_sums {
public:
    explicit stripe_sums(double end) : end_(end) {}

    /// The integral of `first` from 0 to t. Expects: t from -end to twice the end.
    double second(double t) const {
        if (t <= end_)
            return second_within(std::abs(t));
        const double beyond = t - end_;
        return 2 * first(end_) * beyond + second_within(end_ - beyond);
    }

private:
    static double first(double t) {
        const double pairs = std::floor(t / 2);
        return pairs + std::min(t - 2 * pairs, 1.0);
    }

    /// The integral of `first` from 0 to t, for t from 0 to the end of the stripes. Over a pair of
    /// stripes with k pairs before it, `first` rises from k to k + 1 and then stays. So the pair
    /// adds 2 k + 1/2 + 1.
    static double second_within(double t) {
        const double pairs = std::floor(t / 2), rest = t - 2 * pairs, rising = std::min(rest, 1.0);
        return pairs * (pairs + 0.5) + pairs * rest + rising * rising / 2 + (rest - rising);
    }

    double end_;
};

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

std::uint32_t l3d_stripe_color(double angle, double across, double down, double stripe) {
    if (std::isnan(angle) || std::isnan(across) || std::isnan(down))
        return no_number;
    // Angles lie between 0 and 180 degrees. A change of less than 1/10 000 of a stripe counts as
    // that much, so that the differences keep enough digits.
    constexpr double least = 1e-4, most_angle = 180;
    const double a = std::clamp(across, least * stripe, most_angle) / stripe;
    const double d = std::clamp(down, least * stripe, most_angle) / stripe;
    const double middle = std::clamp(angle, 0.0, most_angle) / stripe;
    const stripe_sums sums(most_angle / stripe);
    const double share = (sums.second(middle + (a + d) / 2) - sums.second(middle + (a - d) / 2) -
                          sums.second(middle - (a - d) / 2) + sums.second(middle - (a + d) / 2)) /
                         (a * d);
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
        colors.push_back(l3d_stripe_color(180.0 * i / steps, 0, 0, inspection.stripe));
    return colors;
}
