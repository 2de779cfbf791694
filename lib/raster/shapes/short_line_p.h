// SPDX-License-Identifier: MIT
// short_line: lines of a few pixels, whose set-up costs more than their pixels.
#ifndef L3D_RASTER_SHAPES_SHORT_LINE_P_H
#define L3D_RASTER_SHAPES_SHORT_LINE_P_H

#include "raster/rasterizer_2d.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace l3d_detail {

/// The pixels of line_steps and swift_minors, set up without a division and in 32 bits.
///
/// Pixel i is at floor((2 i rise + length - 1) / d) with d = 2 length <= 30. The numerator, n, gets
/// 16 d more, so it is not negative, and at most 31 d + length - 1 <= 944. It is multiplied by
/// m = ceil(2^16 / d) instead of divided. Since m d - 2^16 <= 29 and 29 n < 2^16, the floor stays.
class short_line {
public:
    static constexpr int pixels = 16; ///< the most that a line may have

    /// Whether both ends are in the picture, and the line is short.
    static bool serves(const l3d_line_2d& line, l3d_size size) {
        const auto in = [](int at, int end) {
            return static_cast<unsigned>(at) < static_cast<unsigned>(end);
        };
        const auto near = [](int from, int to) {
            return static_cast<unsigned>(to) - static_cast<unsigned>(from) + (pixels - 1) <
                   2 * pixels - 1;
        };
        return in(line.x0, size.width) && in(line.x1, size.width) && in(line.y0, size.height) &&
               in(line.y1, size.height) && near(line.x0, line.x1) && near(line.y0, line.y1);
    }

    /// Expects: serves(line); two different ends.
    static void draw(const l3d_line_2d& line, const l3d_pixels& target, std::uint32_t color) {
        const std::int32_t dx = line.x1 - line.x0, dy = line.y1 - line.y0;
        const bool x_major = std::abs(dx) >= std::abs(dy);
        const std::int32_t major = x_major ? dx : dy, minor = x_major ? dy : dx;
        const std::ptrdiff_t along = x_major ? 1 : target.stride;
        const std::ptrdiff_t across = x_major ? target.stride : 1;
        const bool backwards = major < 0;
        const std::ptrdiff_t x = backwards ? line.x1 : line.x0, y = backwards ? line.y1 : line.y0;
        const std::int32_t length = backwards ? -major : major;
        const std::int32_t m = reciprocals[static_cast<std::size_t>(length)];
        const std::int32_t step = 2 * (backwards ? -minor : minor) * m;
        std::uint32_t* at = target.words + y * target.stride + x;
        std::int32_t value = (2 * length * pixels + length - 1) * m;
        for (std::int32_t left = length; left >= 0; --left, at += along) {
            at[((value >> fraction_bits) - pixels) * across] = color;
            value += step;
        }
    }

private:
    static constexpr int fraction_bits = 16;

    /// ceil(2^16 / d) for each length but 0.
    static constexpr std::array<std::int32_t, pixels> reciprocals = [] {
        std::array<std::int32_t, pixels> result{};
        for (std::int32_t length = 1; length < pixels; ++length) {
            const std::int32_t d = 2 * length;
            result[static_cast<std::size_t>(length)] = ((1 << fraction_bits) + d - 1) / d;
        }
        return result;
    }();
};

} // namespace l3d_detail

#endif
