// SPDX-License-Identifier: MIT
// contour_mixer: light that is bright only beside a contour, where no pixel's centre shows it.
#include "raster/refine/contour_light_p.h"
#include "raster/refine/contour_mixer_p.h"
#include "raster/refine/find_jumps_p.h"

#include <algorithm>
#include <cstdint>

namespace l3d_detail {

namespace {

/// Levels that a pixel may be too dark by for a small share of light that is left out: no more than
/// neighbours on one surface differ by.
constexpr float most_left_out = jump_levels;

/// How far the bits of the channels are from a word's end.
constexpr int channels[] = {0, 8, 16};

float channel_of(std::uint32_t word, int shift) {
    return static_cast<float>(word >> shift & 255);
}

} // namespace

bool contour_mixer::shades_next(const contour_pixel& pixel, step& to) const {
    if (!shows_levels() || pixel.beside.part == nullptr)
        return false;
    to = to_right_of(pixel);
    const std::int32_t x = pixel.x + to.x, y = pixel.y + to.y;
    if (!inside(x, y))
        return false;
    return std::ranges::any_of(channels, [&](int shift) {
        return contour_level(pixel, shift) - channel_of(word_at(x, y), shift) > steep_rim;
    });
}

/// Whether the surface of a pixel on the right is much brighter at the contour, or in the next
/// pixel inside.
bool contour_mixer::is_steep(const contour_pixel& pixel, const surface_light& middle) const {
    const step inward = to_right_of(pixel);
    if (goes_on(pixel.x, pixel.y, inward) &&
        apart(word_at(pixel.x + inward.x, pixel.y + inward.y), middle.level,
              color_of(middle.material)) > steep_rim)
        return true;
    surface_light edge;
    return linear_light::level_of(pixel.level()) - middle.level > steep_rim &&
           find_light(pixel, place_on_right(pixel), edge) && edge.level - middle.level > steep_rim;
}

/// By how many levels a pixel is brighter if a share of it has the level `bright`, not `dark`, and
/// the others have the level `rest`.
float contour_mixer::rise(float share, float bright, float dark, float rest) const {
    const auto mixed = [&](float level) {
        return tables_.level_at_light(share * tables_.light_at_level(level) +
                                      (1 - share) * tables_.light_at_level(rest));
    };
    return bright > dark ? mixed(bright) - mixed(dark) : 0;
}

/// Whether a share that a contour cuts off at a corner may be seen, as the contour or a pixel
/// around is much brighter. Dark levels rise fast with a little light.
bool contour_mixer::corner_is_seen(const contour_pixel& pixel, float share) const {
    for (const int shift : channels) {
        float brightest = contour_level(pixel, shift);
        for (std::int32_t y = pixel.y - 1; y <= pixel.y + 1; ++y)
            for (std::int32_t x = pixel.x - 1; x <= pixel.x + 1; ++x)
                if (inside(x, y))
                    brightest = std::max(brightest, channel_of(word_at(x, y), shift));
        const float here = channel_of(word_at(pixel.x, pixel.y), shift);
        if (rise(share, brightest, here, here) > most_left_out)
            return true;
    }
    return false;
}

/// Whether the side on the right is much brighter at the contour than what is taken for it.
bool contour_mixer::rim_is_seen(const contour_pixel& pixel, float share, const side& right,
                                const side& left) const {
    return std::ranges::any_of(channels, [&](int shift) {
        return rise(share, contour_level(pixel, shift), right.level(shift), left.level(shift)) >
               most_left_out;
    });
}

/// A channel of the contour's own level; 0 if vertices have none.
float contour_mixer::contour_level(const contour_pixel& pixel, int shift) const {
    if (!shows_levels() || pixel.beside.part == nullptr)
        return 0;
    return in_color(linear_light::level_of(pixel.level()), color_of(pixel.beside.part->material),
                    shift);
}

/// Whether the centre is so near to a fold that the pixel may show the side that is not seen.
bool contour_mixer::may_show_a_sliver(const contour_pixel& pixel) {
    const auto part = [](std::int32_t units) {
        return static_cast<float>(units) * (1.0f / contour_pixel::whole);
    };
    const float along_x = part(pixel.along_x), along_y = part(pixel.along_y);
    const float square = along_x * along_x + along_y * along_y;
    const float product = part(pixel.to_centre);
    return pixel.folds && product * product < least_way * least_way * square;
}

} // namespace l3d_detail
