// SPDX-License-Identifier: MIT
// Errors of levels, and promises that are broken.
#include "reference/box_verdict.h"
#include "reference/measure.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace reference {
namespace {

constexpr double rounding = 0.5; // of a level
constexpr std::size_t most_worst = 16;

double mean(double sum, std::int64_t count) {
    return count > 0 ? sum / static_cast<double>(count) : 0;
}

/// No level from 0 to 255 would be too far off.
bool says_nothing(const box_pixel& exact, double allowed) {
    return allowed >= std::max(exact.level, 255 - exact.level);
}

} // namespace

double box_verdict::judged_share() const {
    return reference::judged_share(judged, pixels);
}

double box_verdict::judged_shown_share() const {
    return reference::judged_share(judged_shown, shown);
}

box_verdict judge_boxes(std::span<const double> drawn, const box_image& exact,
                        std::span<const float> bounds) {
    const std::span<const box_pixel> pixels = exact.pixels();
    assert(drawn.size() == pixels.size() && bounds.size() == pixels.size());
    box_verdict result;
    double sum = 0, edge_sum = 0;
    for (std::size_t k = 0; k < pixels.size(); ++k) {
        const box_pixel& known = pixels[k];
        const int x = static_cast<int>(k % static_cast<std::size_t>(exact.size().width));
        const int y = static_cast<int>(k / static_cast<std::size_t>(exact.size().width));
        const double off = std::abs(drawn[k] - known.level), bound = bounds[k];
        const bool shown =
            known.covered > 0 || std::abs(drawn[k] - exact.settings().background) > rounding;
        ++result.pixels;
        result.largest_unsure = std::max(result.largest_unsure, known.unsure);
        if (shown) {
            ++result.shown;
            sum += off * off;
            if (known.edge) {
                ++result.edges;
                edge_sum += off * off;
            }
        }
        if (!(off <= result.largest)) {
            result.largest = off;
            result.largest_x = x;
            result.largest_y = y;
        }
        if (!std::isfinite(bound))
            continue;
        const double allowed = bound + known.unsure + rounding;
        ++result.judged;
        result.vacuous += says_nothing(known, allowed);
        if (shown) {
            ++result.judged_shown;
            result.mean_bound += bound;
            result.mean_unsure += known.unsure;
        }
        if (!(off <= allowed)) {
            ++result.exceptions;
            result.worst.push_back(
                {x, y, drawn[k], known.level, bound, known.unsure, off - allowed});
        }
    }
    result.rms = std::sqrt(mean(sum, result.shown));
    result.edge_rms = std::sqrt(mean(edge_sum, result.edges));
    result.mean_bound = mean(result.mean_bound, result.judged_shown);
    result.mean_unsure = mean(result.mean_unsure, result.judged_shown);
    std::sort(result.worst.begin(), result.worst.end(),
              [](const broken_promise& p, const broken_promise& q) { return p.beyond > q.beyond; });
    result.worst.resize(std::min(result.worst.size(), most_worst));
    return result;
}

box_verdict judge_boxes(std::span<const unsigned char> drawn, const box_image& exact,
                        std::span<const float> bounds) {
    return judge_boxes(std::vector<double>(drawn.begin(), drawn.end()), exact, bounds);
}

} // namespace reference
