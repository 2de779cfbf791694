// SPDX-License-Identifier: MIT
// contour_mixer: which neighbour shows the other side, and what the two make together.
#include "raster/refine/contour_mixer_p.h"

#include "raster/background.h"
#include "raster/refine/contour_light_p.h"
#include "raster/refine/find_jumps_p.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace l3d_detail {

namespace {

/// How transparent a pixel is counts as a channel where pixels are compared.
constexpr int channels_end = 32, colors_end = 24;

/// Neighbours of one surface differ by no more levels, where these change steadily.
constexpr int steady = jump_levels;

/// A level that is taken from a surface's own polygons is no farther from what is drawn next to
/// it. Vertices beside a fold may have the level of the side that is not seen.
constexpr float most_change = 48;

/// The same surface has the same depth where it was drawn, but for rounding.
constexpr float same_depth = 1.0f / 1024;

/// A part of the square that no vertex decides: an edge is off by as much as vertices are. But an
/// eighth is seen: bright lines that are nearly level break where they go on in the next row.
constexpr float largest_small_share = 1.0f / 16;

/// Levels of the mixed pixel that a parabola may be wrong by, as a fourth level tells. Rounding
/// nearly makes 3/4. An edge between white and black that is off makes 255 levels a pixel, and a
/// thirtieth of that is not seen beside it. Nor is it to be more than the two levels that shades
/// are allowed.
float most_doubt(float place_error) {
    return std::clamp(255 * place_error / 30, 0.75f, 2.0f);
}

/// Whether two words' channels differ by more than `most`.
bool differ(std::uint32_t a, std::uint32_t b, int end, int most = steady) {
    for (int shift = 0; shift < end; shift += 8)
        if (std::abs(static_cast<int>(a >> shift & 255) - static_cast<int>(b >> shift & 255)) >
            most)
            return true;
    return false;
}

} // namespace

contour_mixer::contour_mixer(const drawn_picture& picture, const contour_cuts& cuts)
    : picture_(picture), cuts_(cuts), tables_(linear_light_tables()),
      small_share_(std::min(picture.place_error, largest_small_share)),
      doubt_(most_doubt(picture.place_error)) {}

bool contour_mixer::alike(std::uint32_t a, std::uint32_t b) const {
    return a == b || !differ(a, b, picture_.is_grey ? 8 : channels_end);
}

contour_mixer::surroundings contour_mixer::around(std::int32_t x, std::int32_t y) const {
    const l3d_pixel_box& window = picture_.window;
    const unsigned inside = (y > window.top ? 1u : 0u) | (y + 1 < window.bottom ? 2u : 0u) |
                            (x > window.left ? 4u : 0u) | (x + 1 < window.right ? 8u : 0u);
    const auto bit = [](bool set, unsigned place) { return set ? 1u << place : 0u; };
    unsigned cut = bit(cuts_.right.has(x, y), 3);
    if ((inside & 1) != 0)
        cut |= bit(cuts_.below(x, y - 1), 0);
    if ((inside & 2) != 0)
        cut |= bit(cuts_.below(x, y), 1);
    if ((inside & 4) != 0)
        cut |= bit(cuts_.on_right(x - 1, y), 2);
    return {x, y, inside & ~cut, inside & cut};
}

/// The neighbour on the other side: of those beside, above and below, one; else at a corner.
contour_mixer::others contour_mixer::find_other(const surroundings& here, step& to) const {
    const std::int32_t x = here.x, y = here.y;
    bool found = false;
    for (std::size_t i = 0; i < beside.size(); ++i) {
        if ((here.divided >> i & 1) == 0)
            continue;
        const step s = beside[i];
        if (found && !alike(word_at(x + to.x, y + to.y), word_at(x + s.x, y + s.y)))
            return others::unlike;
        to = s;
        found = true;
    }
    if (found)
        return others::one;
    // Round a corner of the contour, both ways to a diagonal neighbour are divided.
    for (const std::size_t row : {0u, 1u})
        for (const std::size_t column : {2u, 3u}) {
            if ((here.joined >> row & here.joined >> column & 1) == 0)
                continue;
            const std::int32_t dx = beside[column].x, dy = beside[row].y;
            if (cuts_.below(x + dx, std::min(y, y + dy)) &&
                cuts_.on_right(std::min(x, x + dx), y + dy)) {
                to = {dx, dy};
                return others::one;
            }
        }
    return others::none;
}

/// Whether the next pixel is in the window, and no contour divides the two.
bool contour_mixer::goes_on(std::int32_t x, std::int32_t y, step to) const {
    const std::int32_t next_x = x + to.x, next_y = y + to.y;
    return inside(next_x, next_y) && !(to.x != 0 && cuts_.on_right(std::min(x, next_x), y)) &&
           !(to.y != 0 && cuts_.below(next_x, std::min(y, next_y)));
}

/// Whether a neighbour shows the same surface at a level that is far from the one here. A centre
/// beside a fold may have met a sliver of the other side.
bool contour_mixer::is_odd(const surroundings& here) const {
    const std::uint32_t word = word_at(here.x, here.y);
    for (std::size_t i = 0; i < beside.size(); ++i)
        if ((here.joined >> i & 1) != 0 &&
            !alike(word_at(here.x + beside[i].x, here.y + beside[i].y), word))
            return true;
    return false;
}

/// The way from a contour to what is on its right, nearly.
contour_mixer::step contour_mixer::to_right_of(const contour_pixel& pixel) {
    if (std::abs(pixel.along_x) > std::abs(pixel.along_y))
        return {0, pixel.along_x > 0 ? 1 : -1};
    return {pixel.along_y > 0 ? -1 : 1, 0};
}

/// Whether a contour divides a pixel from one beside it.
bool contour_mixer::is_divided(const surroundings& here, step to) {
    for (std::size_t i = 0; i < beside.size(); ++i)
        if (beside[i].x == to.x && beside[i].y == to.y)
            return (here.divided >> i & 1) != 0;
    return false;
}

/// A side whose levels change steadily: on a straight line from a pixel of it on to the next one.
/// `way` of that leads to the middle of the share. Expects: `found` has the pixel's word.
bool contour_mixer::find_steady(const surroundings& here, step away, float way, side& found) const {
    if (is_odd(here) || !goes_on(here.x, here.y, away))
        return false;
    const std::uint32_t next = word_at(here.x + away.x, here.y + away.y);
    if (!alike(found.first, next))
        return false;
    found.second = next;
    found.way = way;
    return true;
}

/// Whether the surface that a contour belongs to can be asked for its light.
bool contour_mixer::has_own_surface(const contour_pixel& pixel) const {
    return shows_levels() && pixel.crossings == 2 && pixel.beside.part != nullptr;
}

/// How far a word's channels are from those of a level in a colour, at most.
float contour_mixer::apart(std::uint32_t word, float level, std::uint32_t color) {
    float most = 0;
    for (const int shift : {0, 8, 16})
        most = std::max(most, std::abs(static_cast<float>(word >> shift & 255) -
                                       in_color(level, color, shift)));
    return most;
}

/// Whether a drawn pixel on the right may be of the surface at the contour: a rim that is thinner
/// than a pixel may lie between both, beyond a crease. Beside a fold, levels tell nothing, as they
/// are steep.
bool contour_mixer::is_of_contour(const contour_pixel& pixel, step to) const {
    if (!picture_.has_levels || pixel.folds || pixel.beside.part == nullptr)
        return true;
    const std::int32_t x = pixel.x + to.x, y = pixel.y + to.y;
    const std::uint32_t color = color_of(pixel.beside.part->material);
    const float level = linear_light::level_of(pixel.level());
    if (picture_.foggy == nullptr)
        return apart(word_at(x, y), level, color) <= 2 * steady;
    std::uint32_t clear = 0;
    for (const int shift : {0, 8, 16})
        clear |= static_cast<std::uint32_t>(std::lrint(in_color(level, color, shift))) << shift;
    const l3d_fog& fog = picture_.foggy->fog;
    const float depth = picture_.depth[y * picture_.pitch + x];
    if (!(depth > 0))
        return true; // what shows no surface has no fog
    const std::uint32_t behind = fog.in_row(picture_.foggy->background, y, picture_.words.height);
    return !differ(word_at(x, y), l3d_fog::word(clear, behind, fog.amount(depth)), colors_end,
                   2 * steady);
}

/// The colour of a material.
std::uint32_t contour_mixer::color_of(std::uint32_t material) const {
    constexpr std::uint32_t white = 0xffffff;
    return picture_.colors.empty() ? white : picture_.colors[material] & white;
}

/// Whether a neighbour of the same side is nearly as bright.
bool contour_mixer::is_near(const surroundings& here, float level, std::uint32_t color) const {
    for (std::size_t i = 0; i < beside.size(); ++i)
        if ((here.joined >> i & 1) != 0 &&
            apart(word_at(here.x + beside[i].x, here.y + beside[i].y), level, color) <= most_change)
            return true;
    return false;
}

/// The level of the surface that the contour belongs to, from its polygons on the right. The drawn
/// pixel of that side tells that it is this surface that is seen.
bool contour_mixer::find_own_surface(const contour_pixel& pixel, step to, side& found) const {
    if (!has_own_surface(pixel))
        return false;
    const std::int32_t x = pixel.x + to.x, y = pixel.y + to.y;
    constexpr float centre = 0.5f;
    const bool is_own = to.x == 0 && to.y == 0;
    surface_light drawn, light;
    if (!find_light(pixel, {static_cast<float>(x) + centre, static_cast<float>(y) + centre}, drawn))
        return false;
    const float depth = picture_.depth[y * picture_.pitch + x];
    if (std::abs(drawn.inv_w - depth) > same_depth * depth ||
        apart(word_at(x, y), drawn.level, color_of(drawn.material)) > steady ||
        !find_light(pixel, middle_on_right(pixel), light) ||
        light.turns_right != drawn.turns_right ||
        std::abs(light.level - drawn.level) > most_change ||
        (is_own && !is_near(around(x, y), light.level, color_of(light.material))))
        return false;
    if (is_own && is_steep(pixel, light))
        return false; // the level in the middle is not that of the mean light
    found.all = light.level;
    found.color = color_of(light.material);
    return true;
}

bool contour_mixer::mix(const contour_pixel& pixel, std::uint32_t& word) const {
    const std::int32_t side_of_centre = pixel.centre();
    if (side_of_centre != 0 && side_of_centre != 1)
        return false;
    const bool is_right = side_of_centre == 1;
    const float right = static_cast<float>(pixel.share()) / contour_pixel::whole;
    const float own = is_right ? right : 1 - right, rest = 1 - own;
    const surroundings here = around(pixel.x, pixel.y);
    const std::uint32_t here_word = word_at(pixel.x, pixel.y);

    // Which neighbour shows the other side. Beside a fold, those of one surface may be unlike, and
    // behind it there may be several surfaces: the one across the contour stands for them.
    step to{};
    const others other = find_other(here, to);
    if (other == others::none) { // the contour cuts a corner off
        word = here_word;
        return rest < small_share_ && word != l3d_pixels::transparent && !is_odd(here) &&
               !corner_is_seen(pixel, rest);
    }
    if (other == others::unlike) {
        if (pixel.crossings != 2)
            return false;
        const step across = is_right ? -to_right_of(pixel) : to_right_of(pixel);
        if (is_divided(here, across))
            to = across;
    }
    const std::uint32_t there_word = word_at(pixel.x + to.x, pixel.y + to.y);
    if (!is_of_contour(pixel, is_right ? step{0, 0} : to))
        return false;
    const std::int32_t right_x = pixel.x + (is_right ? 0 : to.x);
    const std::int32_t right_y = pixel.y + (is_right ? 0 : to.y);
    if (!(picture_.depth[right_y * picture_.pitch + right_x] > 0))
        return false; // a surface that is thinner than a pixel: no centre shows it
    // A centre that met a sliver of the back may be as dark as what is behind: there is an edge.
    if (other == others::one && here_word == there_word && !is_odd(here)) {
        word = here_word;
        return true;
    }

    // A straight contour across the way to the neighbour lies own - 1/2 from the centre. The middle
    // of the own share lies rest / 2 before it, that of the other share (1 + rest) / 2 nearer than
    // the neighbour's.
    side of_own{here_word, here_word}, of_rest{there_word, there_word};
    if (!find_steady(here, -to, 0.5f * rest, of_own) &&
        !find_steep(pixel, -to, true, is_right, own, of_own) &&
        !(is_right && !may_show_a_sliver(pixel) && find_own_surface(pixel, {0, 0}, of_own)) &&
        !(own < 2 * small_share_ && !(is_right && rim_is_seen(pixel, own, of_own, of_rest))))
        return false;
    // What is behind the contour is known from that neighbour alone, if vertices are off at all.
    const float behind_limit = is_right && small_share_ > 0 ? 1 : small_share_;
    const surroundings there = around(pixel.x + to.x, pixel.y + to.y);
    if (!(other == others::one && find_steady(there, to, -0.5f * (1 + rest), of_rest)) &&
        !find_steep(pixel, to, false, !is_right, rest, of_rest) &&
        !(!is_right && find_own_surface(pixel, to, of_rest)) &&
        !((other == others::one || is_right) && rest < behind_limit &&
          !(!is_right && rim_is_seen(pixel, rest, of_rest, of_own))))
        return false;

    if (here_word == l3d_pixels::transparent || there_word == l3d_pixels::transparent) {
        const bool is_there = here_word == l3d_pixels::transparent;
        const side& seen = is_there ? of_rest : of_own;
        word = l3d_transparency_of(is_there ? own : rest) | mixed(seen, 1, seen);
        return true;
    }
    word = mixed(of_own, own, of_rest);
    return true;
}

/// The levels of the light of both sides, the first of which has that share.
std::uint32_t contour_mixer::mixed(const side& own, float share, const side& rest) const {
    const auto channel = [&](int shift) {
        return tables_.level(share * tables_.light_at_level(own.level(shift)) +
                             (1 - share) * tables_.light_at_level(rest.level(shift)));
    };
    constexpr std::uint32_t all_channels = 0x010101;
    if (picture_.is_grey)
        return all_channels * channel(0);
    return channel(16) << 16 | channel(8) << 8 | channel(0);
}

} // namespace l3d_detail
