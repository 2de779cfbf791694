// SPDX-License-Identifier: MIT
// contour_mixer: which neighbour shows the other side, and what the two make together.
#include "raster/refine/contour_mixer_p.h"

#include "raster/refine/find_jumps_p.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace l3d_detail {

namespace {

int channel(std::uint32_t word, int shift) {
    return static_cast<int>(word >> shift & 255);
}

constexpr int channels_end = 24;

/// How far neighbours' levels go on as they change, and how far two on the other side of a contour
/// may be apart, being a diagonal's ends.
constexpr int steady = jump_levels, like = jump_levels;

constexpr float bend_limit = 3, rise_limit = 60;

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

/// A side that folds over at the contour: (x, y) is its first pixel beside the one that is mixed.
bool contour_mixer::find_steep(std::int32_t x, std::int32_t y, step away, float share,
                               side& found) const {
    const std::int32_t x1 = x + away.x, y1 = y + away.y, x2 = x1 + away.x, y2 = y1 + away.y;
    if (!goes_on(x, y, away) || !goes_on(x1, y1, away))
        return false;
    // Sizes of what a level is a parabola of: the root of the way to the fold.
    const float a = std::sqrt(share + 0.5f), b = std::sqrt(share + 1.5f),
                c = std::sqrt(share + 2.5f), at = 2.0f / 3 * std::sqrt(share);
    const auto weights = [&](float u) -> std::array<float, 3> {
        return {(u - b) * (u - c) / ((a - b) * (a - c)), (u - a) * (u - c) / ((b - a) * (b - c)),
                (u - a) * (u - b) / ((c - a) * (c - b))};
    };
    found = {{word_at(x, y), word_at(x1, y1), word_at(x2, y2)}, weights(at)};
    for (int shift = 0; shift < channels_end; shift += 8) {
        const auto at_a = static_cast<float>(channel(found.words[0], shift));
        const auto at_b = static_cast<float>(channel(found.words[1], shift));
        const auto at_c = static_cast<float>(channel(found.words[2], shift));
        const float guess = at_a + (at_b - at_a) * (c - a) / (b - a);
        if (std::abs(guess - at_c) > bend_limit || std::abs(at_b - at_a) > rise_limit)
            return false;
    }
    return true;
}

bool contour_mixer::mix(const contour_pixel& pixel, std::uint32_t& word) const {
    const std::int32_t x = pixel.x, y = pixel.y;
    step to{};
    const std::int32_t centre = pixel.centre();
    if ((centre != 0 && centre != 1) || !find_other(pixel, to))
        return false;
    const float right = static_cast<float>(pixel.share()) / contour_pixel::whole;
    const float own = centre == 1 ? right : 1 - right, rest = 1 - own;
    const std::uint32_t here = word_at(x, y), there = word_at(x + to.x, y + to.y);
    if (here == there) {
        word = here;
        return true;
    }
    // A straight contour across the way to the neighbour lies own - 1/2 from the centre. The middle
    // of the own share lies rest / 2 before it, that of the other share (1 + rest) / 2 nearer than
    // the neighbour's.
    side of_own, of_rest;
    const bool own_folds = pixel.folds && centre == 1, rest_folds = pixel.folds && centre == 0;
    if (!find_steady(x, y, -to, 0.5f * rest, of_own) &&
        !(own_folds && goes_on(x, y, -to) && find_steep(x - to.x, y - to.y, -to, own, of_own)))
        return false;
    if (!find_steady(x + to.x, y + to.y, to, -0.5f * (1 + rest), of_rest) &&
        !(rest_folds && find_steep(x + to.x, y + to.y, to, rest, of_rest)))
        return false;
    const auto mixed = [&](int shift) {
        return tables_.level(own * tables_.light_at_level(of_own.level(shift)) +
                             rest * tables_.light_at_level(of_rest.level(shift)));
    };
    constexpr std::uint32_t all_channels = 0x010101;
    word = is_grey_ ? all_channels * mixed(0) : mixed(16) << 16 | mixed(8) << 8 | mixed(0);
    return true;
}

} // namespace l3d_detail
