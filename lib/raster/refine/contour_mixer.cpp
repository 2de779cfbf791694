// SPDX-License-Identifier: MIT
// contour_mixer: which neighbour shows the other side, and what the two make together.
#include "raster/refine/contour_mixer_p.h"

#include "raster/background.h"
#include "raster/refine/find_jumps_p.h"

#include <algorithm>
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
        return to.x > 0 ? cuts_.right.has(x, y) != cuts_.left.has(x + 1, y)
                        : cuts_.left.has(x, y) != cuts_.right.has(x - 1, y);
    return to.y > 0 ? cuts_.down.has(x, y) != cuts_.up.has(x, y + 1)
                    : cuts_.up.has(x, y) != cuts_.down.has(x, y - 1);
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

/// Finds the next pixel's word. False if it does not show the same steady surface.
bool contour_mixer::find_behind(std::int32_t x, std::int32_t y, step to, std::uint32_t here,
                                std::uint32_t& word) const {
    if (!inside(x + to.x, y + to.y) || (to.x != 0 && divided(x, y, {to.x, 0})) ||
        (to.y != 0 && divided(x + to.x, y, {0, to.y})))
        return false;
    word = word_at(x + to.x, y + to.y);
    return within(steady, word, here);
}

/// Whether a neighbour shows the same surface at a level that is far from the one here. A centre
/// beside a fold may have met a sliver of the other side.
bool contour_mixer::is_odd(std::int32_t x, std::int32_t y) const {
    return std::ranges::any_of(beside, [&](step s) {
        return inside(x + s.x, y + s.y) && !divided(x, y, s) &&
               !within(like, word_at(x + s.x, y + s.y), word_at(x, y));
    });
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
    if (is_odd(x, y) || is_odd(x + to.x, y + to.y))
        return false;
    std::uint32_t before = 0, after = 0;
    if (!find_behind(x, y, {-to.x, -to.y}, here, before) ||
        !find_behind(x + to.x, y + to.y, to, there, after))
        return false;
    // A straight contour across the way to the neighbour lies own - 1/2 from the centre. The middle
    // of the own share lies rest / 2 before it, that of the other share (1 + rest) / 2 nearer than
    // the neighbour's.
    const float to_own = 0.5f * rest, to_rest = 0.5f * (1 + rest);
    const auto light = [&](int shift, std::uint32_t at, std::uint32_t next, float way) {
        const auto a = static_cast<float>(channel(at, shift));
        const auto b = static_cast<float>(channel(next, shift));
        return tables_.light_at_level(a + way * (b - a));
    };
    if (here == l3d_pixels::transparent || there == l3d_pixels::transparent) {
        const bool is_there = here == l3d_pixels::transparent;
        const auto level = [&](int shift) {
            return tables_.level(is_there ? light(shift, there, after, -to_rest)
                                          : light(shift, here, before, to_own));
        };
        word =
            l3d_transparency_of(is_there ? own : rest) | level(16) << 16 | level(8) << 8 | level(0);
        return true;
    }
    const auto mixed = [&](int shift) {
        return tables_.level(own * light(shift, here, before, to_own) +
                             rest * light(shift, there, after, -to_rest));
    };
    constexpr std::uint32_t all_channels = 0x010101;
    word = is_grey_ ? all_channels * mixed(0) : mixed(16) << 16 | mixed(8) << 8 | mixed(0);
    return true;
}

} // namespace l3d_detail
