// SPDX-License-Identifier: MIT
// Levels, outlines, sparks and holes of a drawn picture.
#include "reference/seen.h"
#include "reference/measure.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>
#include <numeric>

namespace reference {
namespace {

/// Calls visit(i, j) for the pixels of a square around (x, y) that exist.
template <class Visit> void around(picture_size size, int x, int y, int reach, Visit visit) {
    for (int j = std::max(0, y - reach); j <= std::min(size.height - 1, y + reach); ++j)
        for (int i = std::max(0, x - reach); i <= std::min(size.width - 1, x + reach); ++i)
            visit(i, j);
}

class seen_judge {
public:
    seen_judge(const exact_image& exact, const second_judge& outlines, seen_bounds bounds,
               vec3 light)
        : exact_(exact), outlines_(outlines), frame_(exact.view(), exact.size()), bounds_(bounds),
          light_(light), radius_(1.02 * bounds.place + 1e-3),
          reach_(static_cast<int>(std::ceil(radius_))) {}

    outline_kind outline(int x, int y) const {
        return outlines_.outline_within(x + 0.5, y + 0.5, radius_, 2 * bounds_.depth);
    }

    /// The neighbourhood of the pixel may hold an outline: coverage, depth or normals change.
    bool is_uneven(int x, int y) const {
        // The largest turn of normals in a pixel's step: 10 degrees, a radius of 6 pixels if
        // nothing is creased.
        constexpr double least_cosine = 0.985;
        constexpr double jump_px = 0.5;
        const exact_sample& middle = exact_.at(x, y);
        bool uneven = false;
        around(exact_.size(), x, y, reach_, [&](int i, int j) {
            const exact_sample& other = exact_.at(i, j);
            if (uneven || (!middle.covered() && !other.covered()))
                return;
            uneven = middle.covered() != other.covered() ||
                     std::abs(cosine(middle.normal, other.normal)) < least_cosine ||
                     !(tangent_distance_px(middle, x, y, frame_, other, i, j) <= jump_px) ||
                     !(tangent_distance_px(other, i, j, frame_, middle, x, y) <= jump_px);
        });
        return uneven;
    }

    /// The level lies between those of the exact picture within the bound of place, or is no more
    /// than far_levels beside them.
    bool is_near(int x, int y, int level) const {
        int low = 255, high = 0;
        around_within_bound(x, y, [&](int there) {
            low = std::min(low, there);
            high = std::max(high, there);
        });
        return level >= low - far_levels && level <= high + far_levels;
    }

    /// The exact picture has a level within far_levels of this one, within the bound of place.
    bool is_shown(int x, int y, int level) const {
        bool found = false;
        around_within_bound(
            x, y, [&](int there) { found = found || std::abs(there - level) <= far_levels; });
        return found;
    }

    double depth_px(int x, int y, double w) const {
        return depth_error_px(exact_.at(x, y), frame_, x, y, w);
    }

private:
    /// Calls visit(level) for places within the bound of place.
    template <class Visit> void around_within_bound(int x, int y, Visit visit) const {
        constexpr int ways = 16, rings = 4;
        for (int ring = 0; ring <= rings; ++ring)
            for (int k = 0; k < ways; ++k) {
                const double angle = 2 * std::numbers::pi * k / ways;
                const double distance = radius_ * ring / rings;
                const double at_x = x + 0.5 + distance * std::cos(angle);
                const double at_y = y + 0.5 + distance * std::sin(angle);
                visit(outlines_.grey(outlines_.look(at_x, at_y), at_x, at_y, light_));
            }
    }

    static double cosine(const vec3& p, const vec3& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }

    const exact_image& exact_;
    const second_judge& outlines_;
    camera_frame frame_;
    seen_bounds bounds_;
    vec3 light_;
    double radius_;
    int reach_;
};

double root_mean(double sum, std::int64_t count) {
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0;
}

} // namespace

std::int64_t seen_picture::outline_pixels() const {
    return std::accumulate(outlines.begin() + 1, outlines.end(), std::int64_t{0});
}

double seen_picture::judged_share() const {
    return reference::judged_share(judged, shown);
}

std::vector<std::size_t> sparks_of(std::span<const unsigned char> greys, picture_size size) {
    std::vector<std::size_t> result;
    for (int y = 1; y + 1 < size.height; ++y)
        for (int x = 1; x + 1 < size.width; ++x) {
            const auto place = [&](int i, int j) {
                return static_cast<std::size_t>(j) * static_cast<std::size_t>(size.width) +
                       static_cast<std::size_t>(i);
            };
            const std::size_t middle = place(x, y);
            bool alone = true;
            around(size, x, y, 1, [&](int i, int j) {
                alone = alone && (place(i, j) == middle ||
                                  std::abs(greys[place(i, j)] - greys[middle]) > spark_levels);
            });
            if (alone)
                result.push_back(middle);
        }
    return result;
}

seen_picture judge_seen(std::span<const unsigned char> greys, std::span<const float> distances,
                        const exact_image& exact, const second_judge& outlines, seen_bounds bounds,
                        vec3 light) {
    const picture_size size = exact.size();
    const std::vector<unsigned char> wanted = exact.lambert(light);
    assert(greys.size() == wanted.size() && distances.size() == wanted.size());
    const seen_judge by(exact, outlines, bounds, light);
    seen_picture result;
    double sum = 0, judged_sum = 0;
    std::size_t k = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x, ++k) {
            const bool is = std::isfinite(distances[k]) && distances[k] > 0;
            const bool should = exact.covered(x, y);
            if (!is && !should)
                continue;
            const int off = std::abs(greys[k] - wanted[k]);
            ++result.shown;
            ++result.histogram[static_cast<std::size_t>(off)];
            result.largest = std::max(result.largest, off);
            sum += off * off;
            const bool far = off > far_levels;
            const outline_kind kind =
                far || is != should || by.is_uneven(x, y) ? by.outline(x, y) : outline_kind::none;
            if (kind != outline_kind::none) {
                ++result.outlines[static_cast<std::size_t>(kind)];
                result.far_outlines += far;
                if (far && is && !by.is_shown(x, y, greys[k]))
                    result.strange.push_back({x, y, greys[k], wanted[k]});
                continue;
            }
            ++result.judged;
            judged_sum += off * off;
            result.judged_largest = std::max(result.judged_largest, off);
            result.holes += should && !is;
            if (is && should)
                result.judged_depth_px =
                    std::max(result.judged_depth_px, by.depth_px(x, y, distances[k]));
            if (far) {
                result.far.push_back({x, y, greys[k], wanted[k]});
                result.far_anywhere += !by.is_near(x, y, greys[k]);
            }
        }
    result.rms = root_mean(sum, result.shown);
    result.judged_rms = root_mean(judged_sum, result.judged);
    const auto drawn_sparks = sparks_of(greys, size), exact_sparks = sparks_of(wanted, size);
    result.drawn_sparks = static_cast<std::int64_t>(drawn_sparks.size());
    result.exact_sparks = static_cast<std::int64_t>(exact_sparks.size());
    for (const std::size_t place : drawn_sparks) {
        const auto at = std::div(static_cast<int>(place), size.width);
        if (!std::binary_search(exact_sparks.begin(), exact_sparks.end(), place) &&
            !by.is_near(at.rem, at.quot, greys[place]))
            result.sparks.push_back({at.rem, at.quot, greys[place], wanted[place]});
    }
    return result;
}

} // namespace reference
