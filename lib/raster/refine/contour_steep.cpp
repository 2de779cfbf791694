// SPDX-License-Identifier: MIT
// contour_mixer: levels that change fast beside a contour.
#include "raster/refine/contour_mixer_p.h"

#include "raster/refine/contour_light_p.h"
#include "raster/refine/find_jumps_p.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace l3d_detail {

namespace {

/// The mean of levels that differ by no more has the mean of their light, within 1/8 level: near
/// the ambient level, light bends most.
constexpr float calm = 8;

/// What the area beside a straight contour may differ by from the share.
constexpr float straight = 1.0f / 16;

/// Means over the part of a pixel on one side of a straight contour: of the way to the contour
/// along an axis, of its root and of its square. And that part's area.
struct share_means {
    float root = 0, way = 0, square = 0, area = 0;
    std::array<float, 2> nearest{}, farthest{}; ///< ways in two columns, or rows

    /// The way to the centre, negative on the other side; its change from one end of the pixel to
    /// the other.
    share_means(float to_centre, float slope) {
        // Two places that give the mean of a cubic.
        constexpr float place = 0.28867513f;
        for (std::size_t i = 0; i < 2; ++i) {
            const float aside = i == 0 ? -place : place;
            const float far = std::max(to_centre + 0.5f + aside * slope, 0.0f);
            const float near = std::max(to_centre - 0.5f + aside * slope, 0.0f);
            farthest[i] = far;
            nearest[i] = near;
            area += 0.5f * (far - near);
            root += 1.0f / 3 * (far * std::sqrt(far) - near * std::sqrt(near));
            way += 0.25f * (far * far - near * near);
            square += 1.0f / 6 * (far * far * far - near * near * near);
        }
        if (area > 0) {
            root /= area;
            way /= area;
            square /= area;
        }
    }

    /// The mean of a function of the way: at three places of each column (Gauss).
    template <class Function> float mean(const Function& of) const {
        constexpr float aside = 0.7745967f, middle = 4.0f / 9, other = 5.0f / 18;
        float sum = 0;
        for (std::size_t i = 0; i < 2; ++i) {
            const float centre = 0.5f * (farthest[i] + nearest[i]);
            const float half = 0.5f * (farthest[i] - nearest[i]);
            if (half > 0)
                sum += half * (middle * of(centre) +
                               other * (of(centre - aside * half) + of(centre + aside * half)));
        }
        return sum / area;
    }
};

/// Whether a surface's word has a single level. A transparent word has none.
bool is_grey(std::uint32_t word) {
    constexpr std::uint32_t all_channels = 0x010101;
    return word == (word & 255) * all_channels;
}

} // namespace

/// A side whose levels change fast: on a curve through three levels. Where a surface folds over,
/// this is a parabola over the root of the way to the fold. Pixels beside a fold may show a sliver
/// of the other side, so the level at the contour takes the place of the pixel that is mixed.
/// A curve that may be wrong is returned, too, with false: it is a better guess than one pixel.
bool contour_mixer::find_steep(const contour_pixel& pixel, step away, bool is_own, bool is_right,
                               float share, side& found) const {
    // Where the curve runs. What is seen behind a contour would have to be carried on from too far.
    if (!shows_levels() || pixel.crossings != 2 || (away.x != 0 && away.y != 0) ||
        !(is_own || (is_right && pixel.folds)))
        return false;
    const auto across =
        static_cast<float>(std::abs(pixel.along_x * away.y - pixel.along_y * away.x));
    const auto along =
        static_cast<float>(std::abs(pixel.along_x * away.x + pixel.along_y * away.y));
    if (!(across > 0))
        return false;
    // Ways along `away` from the contour: to the centre, and its change across the pixel.
    const float to_centre =
        (is_own ? 1.0f : -1.0f) * std::abs(static_cast<float>(pixel.to_centre)) / across;
    const share_means means(to_centre, along / across);
    if (std::abs(means.area - share) > straight)
        return false; // it turns round a corner
    const bool folds = is_right && pixel.folds;
    std::int32_t x = pixel.x, y = pixel.y;
    float way = to_centre;
    if (!is_own || (folds && to_centre < least_way)) {
        if (is_own && (along > across || !goes_on(x, y, away)))
            return false; // the next one is not farther inside
        x += away.x;
        y += away.y;
        way += 1;
    }

    // Its levels: that of the contour, if the surface folds over there, and drawn ones.
    std::array<float, 4> places{}, levels{};
    std::size_t count = 0;
    if (folds)
        ++count; // the level at the contour
    const std::uint32_t first = word_at(x, y);
    for (std::int32_t px = x, py = y; count < places.size(); px += away.x, py += away.y, way += 1) {
        const std::uint32_t word = word_at(px, py);
        if (!picture_.is_grey && !is_grey(word))
            return false;
        places[count] = way;
        levels[count++] = static_cast<float>(word & 255);
        if (count < places.size() && !goes_on(px, py, away))
            return false;
    }
    const step aside{away.y, away.x};
    const float rise = std::abs(levels[3] - levels[2]) + std::abs(levels[2] - levels[1]);
    for (const step s : {aside, -aside})
        if (goes_on(x, y, s) &&
            std::abs(static_cast<int>(word_at(x + s.x, y + s.y) & 255) -
                     static_cast<int>(first & 255)) > jump_levels + static_cast<int>(rise))
            return false;
    if (folds) {
        for (float& place : places)
            place = std::sqrt(place);
        // The level at the contour is that of the side that is seen, or of the other one, which is
        // as far below 0 as this is above.
        constexpr float ambient = 25.5f, darkest = 26;
        if (std::min({levels[1], levels[2], levels[3]}) <= darkest)
            return false; // where light begins, there is a corner in the curve
        const float guess =
            levels[1] - places[1] * (levels[2] - levels[1]) / (places[2] - places[1]);
        const bool is_lit = guess > ambient + 0.5f * pixel.level();
        levels[0] = ambient + (is_lit ? pixel.level() : 0.0f);
        if (!is_lit && pixel.level() > steep_rim) {
            surface_light light;
            if (find_light(pixel, place_on_right(pixel), light) &&
                light.level > levels[1] + steep_rim)
                return false; // a bright rim, which is narrower than a pixel
        }
    }

    // The parabola through three of them, in Newton's form; the fourth tells its error.
    const float mean = folds ? means.root : means.way, squares = folds ? means.way : means.square;
    const auto slope = [&](float l1, float l0, std::size_t i, std::size_t k) {
        return (l1 - l0) / (places[i] - places[k]);
    };
    const float rise01 = slope(levels[1], levels[0], 1, 0),
                rise12 = slope(levels[2], levels[1], 2, 1),
                rise23 = slope(levels[3], levels[2], 3, 2);
    const float bend02 = slope(rise12, rise01, 2, 0), bend13 = slope(rise23, rise12, 3, 1);
    const float twist = slope(bend13, bend02, 3, 0);
    const float second = squares - (places[0] + places[1]) * mean + places[0] * places[1];
    found.all = levels[0] + (mean - places[0]) * rise01 + second * bend02;
    const float steep = *std::ranges::max_element(levels) - *std::ranges::min_element(levels);
    if (steep > calm && means.area > 0)
        found.all = tables_.level_at_light(means.mean([&](float at) {
            const float v = folds ? std::sqrt(at) : at;
            return tables_.light_at_level(levels[0] +
                                          (v - places[0]) * (rise01 + (v - places[1]) * bend02));
        }));
    return std::abs(second * (mean - places[2]) * twist) * share < doubt_;
}

} // namespace l3d_detail
