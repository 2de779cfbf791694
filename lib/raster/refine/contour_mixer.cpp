// SPDX-License-Identifier: MIT
// contour_mixer: which neighbour shows the other side, and what the two make together.
#include "raster/refine/contour_mixer_p.h"

#include "raster/background.h"
#include "raster/refine/find_jumps_p.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace l3d_detail {

namespace {

int channel(std::uint32_t word, int shift) {
    return static_cast<int>(word >> shift & 255);
}

/// How transparent a pixel is counts as a channel where pixels are compared.
constexpr int channels_end = 32;

/// How far neighbours' levels go on as they change, and how far two on the other side of a contour
/// may be apart, being a diagonal's ends.
constexpr int steady = jump_levels, like = jump_levels;

/// Levels of the mixed pixel that a parabola may be wrong by, as a fourth level tells.
constexpr float most_doubt = 0.75f;

/// What the area beside a straight contour may differ by from the share.
constexpr float straight = 1.0f / 16;

/// A pixel whose centre is nearer to a contour than this may show a sliver of the other side.
constexpr float least_way = 0.1f;

/// Means over the part of a pixel on one side of a straight contour: of the way to the contour
/// along an axis, of its root and of its square. And that part's area.
struct share_means {
    float root = 0, way = 0, square = 0, area = 0;

    /// The way to the centre, negative on the other side; its change from one end of the pixel to
    /// the other.
    share_means(float to_centre, float slope) {
        // Two places that give the mean of a cubic.
        constexpr float place = 0.28867513f;
        for (const float aside : {-place, place}) {
            const float far = std::max(to_centre + 0.5f + aside * slope, 0.0f);
            const float near = std::max(to_centre - 0.5f + aside * slope, 0.0f);
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
};

/// Whether a surface's word has a single level. A transparent word has none.
bool is_grey(std::uint32_t word) {
    return word == (word & 255) * 0x010101;
}

bool within(int levels, std::uint32_t a, std::uint32_t b) {
    for (int shift = 0; shift < channels_end; shift += 8)
        if (std::abs(channel(a, shift) - channel(b, shift)) > levels)
            return false;
    return true;
}

} // namespace

/// Whether a contour divides the centres of a pixel and of one beside, above or below it.
bool contour_mixer::divided(std::int32_t x, std::int32_t y, step to) const {
    if (to.x != 0)
        return cuts_.on_right(std::min(x, x + to.x), y);
    return cuts_.below(x, std::min(y, y + to.y));
}

/// The neighbour on the other side: of those beside, above and below it, one; else at a corner.
/// False if there is none, or if they show more than one surface.
bool contour_mixer::find_other(const contour_pixel& pixel, step& to) const {
    const std::int32_t x = pixel.x, y = pixel.y;
    bool found = false;
    for (const step s : beside)
        if (inside(x + s.x, y + s.y) && divided(x, y, s)) {
            if (found && !within(like, word_at(x + to.x, y + to.y), word_at(x + s.x, y + s.y)))
                return false;
            to = s;
            found = true;
        }
    if (found)
        return true;
    constexpr step corners[] = {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
    for (const step s : corners)
        if (inside(x + s.x, y + s.y) && divided(x + s.x, y, {0, s.y}) &&
            divided(x, y + s.y, {s.x, 0})) {
            to = s;
            return true;
        }
    return false;
}

/// Whether no contour divides a pixel from the next one.
bool contour_mixer::goes_on(std::int32_t x, std::int32_t y, step to) const {
    return inside(x + to.x, y + to.y) && !(to.x != 0 && divided(x, y, {to.x, 0})) &&
           !(to.y != 0 && divided(x + to.x, y, {0, to.y}));
}

/// Whether a neighbour shows the same surface at a level that is far from the one here. A centre
/// beside a fold may have met a sliver of the other side.
bool contour_mixer::is_odd(std::int32_t x, std::int32_t y) const {
    return std::ranges::any_of(beside, [&](step s) {
        return inside(x + s.x, y + s.y) && !divided(x, y, s) &&
               !within(like, word_at(x + s.x, y + s.y), word_at(x, y));
    });
}

/// A side whose levels change steadily: on a straight line from a pixel of it on to the next one.
/// `way` of that leads to the middle of the share.
bool contour_mixer::find_steady(std::int32_t x, std::int32_t y, step away, float way,
                                side& found) const {
    if (!goes_on(x, y, away) || is_odd(x, y))
        return false;
    const std::uint32_t here = word_at(x, y), next = word_at(x + away.x, y + away.y);
    found = {{here, next, 0}, {1 - way, way, 0}};
    return within(steady, here, next);
}

/// A side whose levels change fast: on a curve through three levels. Where a surface folds over,
/// this is a parabola over the root of the way to the fold. Pixels beside a fold may show a sliver
/// of the other side, so the level at the contour takes the place of the pixel that is mixed.
bool contour_mixer::find_steep(const contour_pixel& pixel, step away, bool is_own, bool is_right,
                               float share, side& found) const {
    // What is seen behind a contour would have to be carried on from too far.
    if (!has_levels_ || pixel.crossings != 2 || (away.x != 0 && away.y != 0) ||
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
        if (is_own && !goes_on(x, y, away))
            return false;
        x += away.x;
        y += away.y;
        way += 1;
    }
    std::array<float, 4> places{}, levels{};
    std::size_t count = 0;
    if (folds)
        ++count; // the level at the contour
    const std::uint32_t first = word_at(x, y);
    for (std::int32_t px = x, py = y; count < places.size(); px += away.x, py += away.y, way += 1) {
        const std::uint32_t word = word_at(px, py);
        if (!is_grey_ && !is_grey(word))
            return false;
        places[count] = way;
        levels[count++] = static_cast<float>(channel(word, 0));
        if (count < places.size() && !goes_on(px, py, away))
            return false;
    }
    const step aside{away.y, away.x};
    const float rise = std::abs(levels[3] - levels[2]) + std::abs(levels[2] - levels[1]);
    for (const step s : {aside, -aside})
        if (inside(x + s.x, y + s.y) && !divided(x, y, s) &&
            std::abs(channel(word_at(x + s.x, y + s.y), 0) - channel(first, 0)) >
                like + static_cast<int>(rise))
            return false;
    if (folds)
        for (float& place : places)
            place = std::sqrt(place);
    if (folds) {
        // The level at the contour is that of the side that is seen, or of the other one, which is
        // as far below 0 as this is above.
        constexpr float ambient = 25.5f, darkest = 26;
        if (std::min({levels[1], levels[2], levels[3]}) <= darkest)
            return false; // where light begins, there is a corner in the curve
        const float guess =
            levels[1] - places[1] * (levels[2] - levels[1]) / (places[2] - places[1]);
        levels[0] = ambient + (guess > ambient + 0.5f * pixel.level() ? pixel.level() : 0.0f);
    }
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
    found = {};
    found.constant = levels[0] + (mean - places[0]) * rise01 + second * bend02;
    return std::abs(second * (mean - places[2]) * twist) * share < most_doubt;
}

/// The way across a contour at which a surface folds over, to the side where this is seen.
bool contour_mixer::find_fold(const contour_pixel& pixel, step& to) const {
    if (pixel.crossings != 2 || !pixel.folds || pixel.centre() != 0)
        return false;
    if (std::abs(pixel.along_x) > std::abs(pixel.along_y))
        to = {0, pixel.along_x > 0 ? 1 : -1};
    else
        to = {pixel.along_y > 0 ? -1 : 1, 0};
    return inside(pixel.x + to.x, pixel.y + to.y) && divided(pixel.x, pixel.y, to);
}

bool contour_mixer::mix(const contour_pixel& pixel, std::uint32_t& word) const {
    const std::int32_t x = pixel.x, y = pixel.y;
    step to{};
    const std::int32_t centre = pixel.centre();
    if (centre != 0 && centre != 1)
        return false;
    // Beside a fold, neighbours of the same surface may be unlike.
    const bool is_plain = find_other(pixel, to);
    if (!is_plain && !find_fold(pixel, to))
        return false;
    const float right = static_cast<float>(pixel.share()) / contour_pixel::whole;
    const float own = centre == 1 ? right : 1 - right, rest = 1 - own;
    const std::uint32_t here = word_at(x, y), there = word_at(x + to.x, y + to.y);
    if (is_plain && here == there) {
        word = here;
        return true;
    }
    // A straight contour across the way to the neighbour lies own - 1/2 from the centre. The middle
    // of the own share lies rest / 2 before it, that of the other share (1 + rest) / 2 nearer than
    // the neighbour's.
    side of_own, of_rest;
    if (!find_steady(x, y, -to, 0.5f * rest, of_own) &&
        !find_steep(pixel, -to, true, centre == 1, own, of_own))
        return false;
    if (!(is_plain && find_steady(x + to.x, y + to.y, to, -0.5f * (1 + rest), of_rest)) &&
        !find_steep(pixel, to, false, centre == 0, rest, of_rest))
        return false;
    if (here == l3d_pixels::transparent || there == l3d_pixels::transparent) {
        const bool is_there = here == l3d_pixels::transparent;
        const side& seen = is_there ? of_rest : of_own;
        const auto level = [&](int shift) {
            return tables_.level(tables_.light_at_level(seen.level(shift)));
        };
        word =
            l3d_transparency_of(is_there ? own : rest) | level(16) << 16 | level(8) << 8 | level(0);
        return true;
    }
    const auto mixed = [&](int shift) {
        return tables_.level(own * tables_.light_at_level(of_own.level(shift)) +
                             rest * tables_.light_at_level(of_rest.level(shift)));
    };
    constexpr std::uint32_t all_channels = 0x010101;
    word = is_grey_ ? all_channels * mixed(0) : mixed(16) << 16 | mixed(8) << 8 | mixed(0);
    return true;
}

} // namespace l3d_detail
