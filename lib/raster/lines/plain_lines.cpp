// SPDX-License-Identifier: MIT
// plain_lines: turns steps into words, and finds where a line enters and leaves a picture.
#include "raster/lines/line_steps_p.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace {

using namespace l3d_detail;

/// The number of pixels in a block. Pixels of a block are lit without a branch between them.
constexpr int block = 4;

/// The number of pixels between the pixel that is lit and the pixel whose memory is prefetched.
/// Each pixel of a steep line is in a row of its own, and so in a cache line of its own. Lines
/// shorter than fewest_for_ahead lose more by prefetching than they gain.
constexpr int pixels_ahead = 4;
constexpr std::int64_t fewest_for_ahead = 32 * pixels_ahead;

/// Walks along a line in memory; strides are in words.
template <bool x_major, class Minors> struct line_walk {
    std::uint32_t* at; ///< the next pixel's word, at the minor coordinate of the line's begin
    Minors minors;
    /// Offset from a pixel's word to that of the next pixel along the longer axis.
    std::ptrdiff_t along;
    std::ptrdiff_t stride;

    std::uint32_t* pixel() const { return at + across(minors.floor()); }
    /// The offset from the present pixel to the pixel this many steps later, or to a neighbour of
    /// that pixel.
    std::ptrdiff_t ahead(int pixels) const {
        return pixels * along + across(minors.floor_after(pixels) - minors.floor());
    }
    void step() {
        at += along;
        minors.step();
    }
    void skip(std::int64_t pixels) {
        at += pixels * along;
        minors.skip(pixels);
    }

private:
    std::ptrdiff_t across(std::int64_t minor) const { return x_major ? minor * stride : minor; }
};

/// Lights the pixels of a line one by one.
template <bool x_major, class Minors>
void light_singly(line_walk<x_major, Minors> walk, std::int64_t pixels, std::uint32_t color) {
    for (; pixels > 0; --pixels, walk.step())
        *walk.pixel() = color;
}

/// Lights pixels in blocks. The last block ends where the line does, so it may overlap the block
/// before it.
///
/// Not inlined: the loop takes all registers, and compilers would mix it with the code before it.
/// Expects: pixels >= block.
template <bool x_major, bool prefetches>
[[gnu::noinline]] void light_blocks(std::uint32_t* at, swift_minors minors, std::int64_t pixels,
                                    std::ptrdiff_t along, std::ptrdiff_t stride,
                                    std::uint32_t color) {
    line_walk<x_major, swift_minors> walk{at, minors, along, stride};
    const std::ptrdiff_t ahead = walk.ahead(pixels_ahead);
    const auto light_block = [&] {
        for (int i = 0; i < block; ++i, walk.step()) {
            std::uint32_t* const pixel = walk.pixel();
            if constexpr (prefetches)
                __builtin_prefetch(pixel + ahead, 1);
            *pixel = color;
        }
    };
    for (; pixels > block; pixels -= block)
        light_block();
    walk.skip(pixels - block);
    light_block();
}

/// Lights the visible steps of a line. Its arguments are separate numbers, as a struct would be
/// passed in memory. `at` is the word at the first step's major coordinate and at the minor
/// coordinate of the line's begin.
template <bool x_major>
void light_steps(std::uint32_t* at, std::int64_t length, std::int64_t rise, std::int64_t first,
                 std::int64_t pixels, std::ptrdiff_t along, std::ptrdiff_t stride,
                 std::uint32_t color) {
    if (x_major && rise == 0) {
        std::fill_n(along > 0 ? at : at - (pixels - 1), pixels, color);
        return;
    }
    if (!swift_minors::serve(length)) {
        const line_steps steps{x_major, 0, 0, length, rise, first};
        return light_singly<x_major, exact_steps>({at, steps.minors(), along, stride}, pixels,
                                                  color);
    }
    swift_minors minors = swift_minors::of(length, rise);
    minors.skip(first);
    if (pixels < block)
        light_singly<x_major, swift_minors>({at, minors, along, stride}, pixels, color);
    else if (!x_major && pixels >= fewest_for_ahead)
        light_blocks<x_major, true>(at, minors, pixels, along, stride, color);
    else
        light_blocks<x_major, false>(at, minors, pixels, along, stride, color);
}

/// Lights a long line. Not inlined, so that short lines need not save the registers that blocks
/// take.
template <bool x_major>
[[gnu::noinline]] void light_long(std::uint32_t* at, std::int32_t length, std::int32_t rise,
                                  std::ptrdiff_t along, std::ptrdiff_t stride,
                                  std::uint32_t color) {
    light_steps<x_major>(at, length, rise, 0, std::int64_t{length} + 1, along, stride, color);
}

/// Lights a line from its first end on, even backwards. By the rule of
/// l3d_rasterizer_2d::draw_line, both directions give the same pixels.
template <bool x_major>
void light_whole(std::uint32_t* at, std::int32_t length, std::int32_t rise, std::ptrdiff_t along,
                 std::ptrdiff_t stride, std::uint32_t color) {
    if (length >= swift_minors::short_length)
        return light_long<x_major>(at, length, rise, along, stride, color);
    light_singly<x_major, swift_minors>({at, swift_minors::of_short(length, rise), along, stride},
                                        length + 1, color);
}

[[gnu::noinline]] void draw_clipped(const l3d_pixels& target, int x0, int y0, int x1, int y1,
                                    std::uint32_t color) {
    if (x0 == x1 && y0 == y1)
        return;
    const line_steps steps = steps_of({x0, y0, x1, y1}, target.size());
    if (steps.first > steps.last)
        return;
    const std::int64_t major = steps.major + steps.first, pixels = steps.last - steps.first + 1;
    const std::ptrdiff_t stride = target.stride;
    if (steps.x_major)
        light_steps<true>(target.words + steps.minor * stride + major, steps.length, steps.rise,
                          steps.first, pixels, 1, stride, color);
    else
        light_steps<false>(target.words + major * stride + steps.minor, steps.length, steps.rise,
                           steps.first, pixels, stride, stride, color);
}

} // namespace

void l3d_detail::draw_plain_line(const l3d_pixels& target, int x0, int y0, int x1, int y1,
                                 std::uint32_t color) {
    const auto is_in = [](int at, int end) {
        return static_cast<unsigned>(at) < static_cast<unsigned>(end);
    };
    if (!is_in(x0, target.width) || !is_in(x1, target.width) || !is_in(y0, target.height) ||
        !is_in(y1, target.height))
        return draw_clipped(target, x0, y0, x1, y1, color);
    const std::int32_t dx = x1 - x0, dy = y1 - y0, columns = std::abs(dx), rows = std::abs(dy);
    const std::ptrdiff_t stride = target.stride;
    std::uint32_t* const at = target.words + y0 * stride + x0;
    if (columns >= rows)
        light_whole<true>(at, columns, dy, dx < 0 ? -1 : 1, stride, color);
    else
        light_whole<false>(at, rows, dx, dy < 0 ? -stride : stride, stride, color);
}

void l3d_detail::mark_seen(line_steps& line, l3d_size size) {
    const std::int64_t major_size = line.x_major ? size.width : size.height;
    const std::int64_t minor_size = line.x_major ? size.height : size.width;
    const whole_range among{std::max<std::int64_t>(0, -line.major),
                            std::min<std::int64_t>(line.length, major_size - 1 - line.major)};
    // The pixels for which 0 <= minor < minor_size, where minor is the floor of a quotient.
    const wide_integer length = line.length;
    const whole_range seen =
        where_within(among, 2 * wide_integer{line.rise}, -2 * length * line.minor - length + 1,
                     2 * length * (minor_size - line.minor) - length);
    if (seen.first > seen.last)
        return;
    line.first = static_cast<std::int64_t>(seen.first);
    line.last = static_cast<std::int64_t>(seen.last);
}
