// SPDX-License-Identifier: MIT
// contour_pixels: edges walked from pixel to pixel.
#include "raster/refine/contour_pixels_p.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace l3d_detail {

namespace {

enum cut : std::uint32_t { cut_up = 1, cut_down = 2, cut_left = 4, cut_right = 8 };

constexpr double centre = 0.5;

std::uint32_t name_of(scan_point vertex) {
    // Two odd factors with bits all over the word, so that a sum is 0 by chance once in 2^32.
    return static_cast<std::uint32_t>(vertex.x) * 0x9e3779b1u ^
           static_cast<std::uint32_t>(vertex.y) * 0x85ebca77u;
}

} // namespace

/// Places are moved to the left and up by 2^-13 pixels. So no vertex is on a pixel's border, nor on
/// a line through centres: what is on these belongs where the fill rule says.
void contour_pixels::add(const contour_edge& edge, const drawn_depth& depth) {
    constexpr double unit = 1.0 / l3d_subpixel_one, moved = 1.0 / (1 << 13);
    const double from_x = edge.from.x * unit - moved, from_y = edge.from.y * unit - moved;
    const double to_x = edge.to.x * unit - moved, to_y = edge.to.y * unit - moved;
    auto x = static_cast<std::int32_t>(std::floor(from_x));
    auto y = static_cast<std::int32_t>(std::floor(from_y));
    const auto last_x = static_cast<std::int32_t>(std::floor(to_x));
    const auto last_y = static_cast<std::int32_t>(std::floor(to_y));
    if (std::min(y, last_y) >= band_.bottom || std::max(y, last_y) < band_.top ||
        std::min(x, last_x) >= band_.right || std::max(x, last_x) < band_.left)
        return;
    const double dx = to_x - from_x, dy = to_y - from_y;
    const std::int32_t step_x = dx > 0 ? 1 : -1, step_y = dy > 0 ? 1 : -1;
    const double side_x = dx > 0 ? 1 : 0, side_y = dy > 0 ? 1 : 0;
    const double slope = dx != 0 ? dy / dx : 0, steep = dy != 0 ? dx / dy : 0;
    place at{from_x - x, from_y - y};
    bool enters = false;
    std::uint32_t loose = name_of(edge.from);
    while (x != last_x || y != last_y) {
        // The way ends at the side that comes first.
        bool sideways = y == last_y;
        double y_there = at.y;
        if (x != last_x) {
            y_there = from_y + (x + side_x - from_x) * slope - y;
            sideways = sideways || (dy > 0 ? y_there < 1 : y_there > 0);
        }
        place to{};
        if (sideways)
            to = {side_x, std::clamp(y_there, 0.0, 1.0)};
        else
            to = {std::clamp(from_x + (y + side_y - from_y) * steep - x, 0.0, 1.0), side_y};
        pass(x, y, at, to, enters, true, loose, edge, depth);
        loose = 0;
        enters = true;
        if (sideways) {
            x += step_x;
            at = {1 - side_x, to.y};
        } else {
            y += step_y;
            at = {to.x, 1 - side_y};
        }
    }
    pass(x, y, at, {to_x - x, to_y - y}, enters, false, loose ^ name_of(edge.to), edge, depth);
}

void contour_pixels::pass(std::int32_t x, std::int32_t y, place from, place to, bool enters,
                          bool leaves, std::uint32_t loose, const contour_edge& edge,
                          const drawn_depth& depth) {
    const auto sign = [](std::int32_t n) { return (n > 0 ? 1 : 0) - (n < 0 ? 1 : 0); };
    const scan_point to_left{sign(edge.to.y - edge.from.y), sign(edge.from.x - edge.to.x)};
    if (y < band_.top || y >= band_.bottom || x < band_.left || x >= band_.right ||
        depth.hides(x, y, edge.nearest, to_left.x, to_left.y))
        return;
    // The way along the border on to corner (0, 0): the right side adds what is left of it.
    const auto beyond = [](place p) { return p.x >= 1 ? p.y : p.y <= 0 ? 0.0 : 1.0; };
    const auto past = [](place p) { return p.x >= 1 ? p.y > centre : p.y > 0; };
    const auto along = [](place p) {
        return static_cast<float>(p.y <= 0   ? p.x
                                  : p.x >= 1 ? 1 + p.y
                                  : p.y >= 1 ? 3 - p.x
                                             : 4 - p.y);
    };
    double area = 0.5 * (from.x + to.x) * (to.y - from.y);
    std::int32_t turns = 0, crossings = 0;
    if (enters) {
        area += beyond(from);
        turns += past(from) ? 1 : 0;
        ++crossings;
    }
    if (leaves) {
        area -= beyond(to);
        turns -= past(to) ? 1 : 0;
        ++crossings;
    }
    std::uint32_t cuts = 0;
    if ((from.y > centre) != (to.y > centre)) {
        const double there = from.x + (centre - from.y) / (to.y - from.y) * (to.x - from.x);
        cuts ^= there > centre ? cut_right : cut_left;
        if (there > centre)
            turns += to.y > from.y ? 1 : -1;
    }
    if ((from.x > centre) != (to.x > centre)) {
        const double there = from.y + (centre - from.x) / (to.x - from.x) * (to.y - from.y);
        cuts ^= there > centre ? cut_down : cut_up;
    }
    const auto units = [](double number) {
        return static_cast<std::int32_t>(std::lrint(number * contour_pixel::whole));
    };
    const double along_x = to.x - from.x, along_y = to.y - from.y;
    const double to_centre = along_x * (centre - from.y) - along_y * (centre - from.x);
    // Levels are less than 2^8, and few pieces are longer than 2: their sum has room.
    constexpr double length_units = 1 << 12;
    const auto length = static_cast<std::int32_t>(
        std::lrint(length_units * (std::abs(along_x) + std::abs(along_y))));
    const auto levels = static_cast<std::int32_t>(
        std::isfinite(edge.level) ? std::lrint(length * double{edge.level}) : 0);
    pairs_.push_back(
        {{x, y, units(area), turns, crossings, loose, false, units(along_x), units(along_y),
          units(to_centre), length, levels, edge.beside, edge.also, edge.fold},
         cuts,
         enters ? along(from) : -1,
         leaves ? along(to) : -1,
         0,
         0});
}

bool contour_pixels::pair::coincides(const pair& other) const {
    return of.loose == other.of.loose && of.area == other.of.area &&
           of.along_x == other.of.along_x && of.along_y == other.of.along_y &&
           of.to_centre == other.of.to_centre && enters_at == other.enters_at &&
           leaves_at == other.leaves_at;
}

/// Whether the same piece of a contour has been in the pixel: a surface may be given twice. Its
/// contours count once, as two equal ones would tell nothing of what is on their sides.
bool contour_pixels::is_again(pair& p) {
    // Those of a whole far model would take the square of their number to compare.
    constexpr std::uint32_t most_compared = 32;
    if (count_[p.pixel] > most_compared)
        return false;
    for (std::uint32_t i = last_[p.pixel]; i != 0; i = pairs_[i - 1].before)
        if (pairs_[i - 1].coincides(p))
            return true;
    p.before = last_[p.pixel];
    last_[p.pixel] = static_cast<std::uint32_t>(&p - pairs_.data() + 1);
    return false;
}

void contour_pixels::finish(contour_cuts& cuts, pixel_bits& seen) {
    pixels_.clear();
    if (pairs_.empty())
        return;
    for (const pair& p : pairs_)
        seen.set(p.of.x, p.of.y);
    before_.clear();
    std::uint32_t count = 0;
    const std::size_t words = seen.row_words();
    for (std::int32_t y = band_.top; y < band_.bottom; ++y)
        for (std::size_t w = 0; w < words; ++w) {
            before_.push_back(count);
            count += static_cast<std::uint32_t>(bits_in(seen.row(y)[w]));
        }
    pixels_.assign(count, {});
    last_.assign(count, 0);
    count_.assign(count, 0);
    for (pair& p : pairs_) {
        const std::size_t word = pixel_bits::word_of(p.of.x);
        const std::uint64_t below = (std::uint64_t{1} << pixel_bits::bit_of(p.of.x)) - 1;
        const auto row = static_cast<std::size_t>(p.of.y - band_.top);
        p.pixel = before_[row * words + word] +
                  static_cast<std::uint32_t>(bits_in(seen.row(p.of.y)[word] & below));
        ++count_[p.pixel];
    }
    for (pair& p : pairs_) {
        const std::size_t word = pixel_bits::word_of(p.of.x);
        const auto bit = pixel_bits::bit_of(p.of.x);
        if (is_again(p)) {
            p.enters_at = p.leaves_at = -1;
            continue;
        }
        contour_pixel& to = pixels_[p.pixel];
        to = {p.of.x,
              p.of.y,
              to.area + p.of.area,
              to.turns + p.of.turns,
              to.crossings + p.of.crossings,
              to.loose ^ p.of.loose,
              false,
              to.along_x + p.of.along_x,
              to.along_y + p.of.along_y,
              to.to_centre + p.of.to_centre,
              to.length + p.of.length,
              to.levels + p.of.levels,
              p.of.beside,
              p.of.also,
              to.folds && p.of.folds};
        const auto flip = [&](pixel_bits& of, std::uint32_t which) {
            if ((p.cuts & which) != 0)
                of.row(p.of.y)[word] ^= std::uint64_t{1} << bit;
        };
        flip(cuts.up, cut_up);
        flip(cuts.down, cut_down);
        flip(cuts.right, cut_right);
        if ((p.cuts & cut_left) != 0 && p.of.x > 0)
            cuts.right.flip(p.of.x - 1, p.of.y);
    }
    find_turns();
}

/// Sorts the ends of the contours in pixels of more than one along the border.
void contour_pixels::find_turns() {
    ends_.clear();
    for (const pair& p : pairs_) {
        const contour_pixel& of = pixels_[p.pixel];
        if (of.crossings <= 2 || of.loose != 0)
            continue;
        if (p.enters_at >= 0)
            ends_.push_back({p.pixel, p.enters_at, true});
        if (p.leaves_at >= 0)
            ends_.push_back({p.pixel, p.leaves_at, false});
    }
    std::ranges::sort(ends_);
    for (std::size_t i = 0, next = 0; i < ends_.size(); i = next) {
        bool alternate = true;
        for (next = i + 1; next < ends_.size() && ends_[next].pixel == ends_[i].pixel; ++next)
            alternate = alternate && ends_[next].enters != ends_[next - 1].enters;
        pixels_[ends_[i].pixel].takes_turns =
            alternate && ends_[next - 1].enters != ends_[i].enters;
    }
}

} // namespace l3d_detail
