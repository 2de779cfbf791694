// SPDX-License-Identifier: MIT
// line_steps: the pixels of a line as steps along its longer axis, and the range that is seen.
#ifndef L3D_RASTER_LINES_LINE_STEPS_P_H
#define L3D_RASTER_LINES_LINE_STEPS_P_H

#include "raster/shapes/exact_steps_p.h"
#include "raster/rasterizer_2d.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace l3d_detail {

/// A line in steps along its longer ("major") axis, from its smaller to its larger major end.
///
/// The line has length + 1 pixels. Pixel i is (major + i, minor + ceil(i rise / length - 1/2)), the
/// pixel nearest to the line. If two pixels are equally near, it is the pixel with the smaller
/// minor coordinate. The ceil() equals floor((2 i rise + length - 1) / (2 length)).
struct line_steps {
    bool x_major;
    std::int64_t major, minor;
    /// The line's extent along its major axis, and its signed extent along the other axis; |rise|
    /// <= length < 2^32.
    std::int64_t length, rise;
    std::int64_t first = 0, last = -1; ///< steps first <= i <= last are in the picture

    /// The minor coordinates of the pixels, from step `first` on.
    exact_steps minors() const {
        return {2 * wide_integer{first} * rise + length - 1, 2 * wide_integer{rise}, 2 * length};
    }
};

/// The minor coordinates of line_steps, found by one addition in fixed point for each step, from
/// step 0 on.
///
/// In step i, the coordinate is the floor of (2 i rise + length - 1) / (2 length). The fraction of
/// this number is at most 1 - 1 / (2 length). At i = 0 the number is (length - 1) / (2 length),
/// which is 1/2 less a half of 1 / length.
///
/// Start and step have 40 fraction bits. Both are too large by more than 0 and less than `excess`
/// units, whichever way double rounds and truncates. At step i, the error is less than excess (i +
/// 1) 2^-40. As i is at most `length`, this is below 1 / (2 length), so no floor changes.
class swift_minors {
public:
    /// Whether this class serves lines of this length.
    static bool serve(std::int64_t length) { return length > 0 && length < std::int64_t{1} << 18; }

    /// The minor coordinates of a line, by one division. The class's `excess` is below 4 here, and
    /// 4 * 2^18 * 2 * 2^18 < 2^40.
    /// Expects: serve(length), |rise| <= length.
    static swift_minors of(std::int64_t length, std::int64_t rise) {
        const double unit = static_cast<double>(one) / static_cast<double>(length);
        return {one / 2 + 2 - static_cast<std::int64_t>(unit / 2),
                static_cast<std::int64_t>(unit * static_cast<double>(rise)) + 2};
    }

    /// Lines below this length need no division.
    static constexpr std::int32_t short_length = 16;

    /// The minor coordinates of a line shorter than short_length, with a table in place of a
    /// division. The class's `excess` is below 32 here, and 32 * 2^4 * 2 * 2^4 < 2^40.
    /// Expects: 0 <= length < short_length, |rise| <= length.
    static swift_minors of_short(std::int32_t length, std::int32_t rise) {
        const std::int64_t unit = units[static_cast<std::size_t>(length)];
        return {one / 2 + short_length - (unit >> 1), unit * rise + short_length};
    }

    std::int64_t floor() const { return value_ >> fraction_bits; }
    std::int64_t floor_after(int steps) const { return (value_ + steps * step_) >> fraction_bits; }
    void step() { value_ += step_; }
    /// Moves on by this number of steps, or back if the number is negative.
    /// Expects: the place reached is between step 0 and step `length`.
    void skip(std::int64_t steps) { value_ += steps * step_; }

private:
    static constexpr int fraction_bits = 40;
    static constexpr std::int64_t one = std::int64_t{1} << fraction_bits;

    /// A table for short lines, by their lengths: entry `length` is floor(2^40 / length). Entry 0
    /// is 0, as a line of length 0 has one pixel.
    static constexpr auto units = [] {
        std::array<std::int64_t, short_length> result{};
        for (std::size_t length = 1; length < result.size(); ++length)
            result[length] = one / static_cast<std::int64_t>(length);
        return result;
    }();

    swift_minors(std::int64_t value, std::int64_t step) : value_(value), step_(step) {}

    std::int64_t value_, step_;
};

/// Marks the steps of a line that lie in a picture of this size, by arithmetic and not by stepping.
void mark_seen(line_steps& line, l3d_size size);

/// The steps of a line. Steps that lie in a picture of this size are marked.
/// Expects: two different ends.
inline line_steps steps_of(const l3d_line_2d& line, l3d_size size) {
    const std::int64_t dx = std::int64_t{line.x1} - line.x0, dy = std::int64_t{line.y1} - line.y0;
    const bool x_major = std::abs(dx) >= std::abs(dy);
    const bool backwards = (x_major ? dx : dy) < 0;
    const std::int64_t x = backwards ? line.x1 : line.x0, y = backwards ? line.y1 : line.y0;
    const std::int64_t sign = backwards ? -1 : 1;
    line_steps steps = x_major ? line_steps{true, x, y, sign * dx, sign * dy}
                               : line_steps{false, y, x, sign * dy, sign * dx};
    const auto inside = [](int a, int b, int end) {
        return a >= 0 && b >= 0 && a < end && b < end;
    };
    if (inside(line.x0, line.x1, size.width) && inside(line.y0, line.y1, size.height))
        steps.last = steps.length;
    else
        mark_seen(steps, size);
    return steps;
}

/// Draws a line by the rule of l3d_rasterizer_2d::draw_line, between any whole numbers.
void draw_plain_line(const l3d_pixels& target, int x0, int y0, int x1, int y1, std::uint32_t color);

} // namespace l3d_detail

#endif
