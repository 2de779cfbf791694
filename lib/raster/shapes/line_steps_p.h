// SPDX-License-Identifier: MIT
// line_steps: the pixels of a line as steps along its longer axis, and which of them are seen.
#ifndef L3D_RASTER_SHAPES_LINE_STEPS_P_H
#define L3D_RASTER_SHAPES_LINE_STEPS_P_H

#include "raster/shapes/exact_steps_p.h"
#include "raster/rasterizer_2d.h"

#include <cstdint>
#include <cstdlib>

namespace l3d_detail {

/// A line as seen along its longer ("major") axis, from its smaller to its larger major end.
///
/// Pixel i of length + 1 is (major + i, minor + ceil(i rise / length - 1/2)): nearest, ties to the
/// smaller minor. As a floor: floor((2 i rise + length - 1) / (2 length)).
struct line_steps {
    bool x_major;
    std::int64_t major, minor;
    std::int64_t length, rise;         ///< 0 <= |rise| <= length < 2^32
    std::int64_t first = 0, last = -1; ///< steps first <= i <= last are in the target

    /// The floors above, from step `first` on.
    exact_steps minors() const {
        return {2 * wide_integer{first} * rise + length - 1, 2 * wide_integer{rise}, 2 * length};
    }
};

/// The same floors by an addition in fixed point for each step.
///
/// Each is (2 i rise + length - 1) / (2 length), whose fraction is at most 1 - 1 / (2 length).
/// Start and step have 40 fraction bits and are 1 to 3 units too large, whichever way double rounds
/// and truncates. After n steps that is at most 3 (n + 1) 2^-40. `serves` keeps it below 1 / (2
/// length), so no floor changes.
class swift_minors {
public:
    static bool serves(const line_steps& line) {
        const std::int64_t steps = line.last - line.first;
        return line.length < most && steps < most; // 3 * 2^18 * 2 * 2^18 < 2^40
    }

    /// Expects: serves(line).
    explicit swift_minors(const line_steps& line) {
        const std::int64_t full = 2 * line.length;
        std::int64_t whole = 0, rest = line.length - 1;
        if (line.first != 0) {
            const std::int64_t numerator = 2 * line.first * line.rise + rest;
            whole = static_cast<std::int64_t>(floor_quotient(numerator, full));
            rest = numerator - whole * full;
        }
        const double scale = static_cast<double>(one) / static_cast<double>(full);
        value_ = whole * one + static_cast<std::int64_t>(static_cast<double>(rest) * scale) + 2;
        step_ = static_cast<std::int64_t>(static_cast<double>(2 * line.rise) * scale) + 2;
    }

    std::int64_t floor() const { return value_ >> fraction_bits; }
    std::int64_t floor_after(int steps) const { return (value_ + steps * step_) >> fraction_bits; }
    void step() { value_ += step_; }

private:
    static constexpr int fraction_bits = 40;
    static constexpr std::int64_t one = std::int64_t{1} << fraction_bits, most = 1 << 18;

    std::int64_t value_, step_;
};

/// Marks the steps that are in a picture of that size, by arithmetic and not by stepping.
void mark_seen(line_steps& line, l3d_size size);

/// The steps of a line, those in a picture of that size marked. Expects: two different ends.
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

} // namespace l3d_detail

#endif
