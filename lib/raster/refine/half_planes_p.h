// SPDX-License-Identifier: MIT
// half_planes: finds the samples of a square on one side of a straight line.
#ifndef L3D_RASTER_REFINE_HALF_PLANES_P_H
#define L3D_RASTER_REFINE_HALF_PLANES_P_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// A table for finding the samples of a pixel that a polygon covers. It tells which of 64 places in
/// a square of side 1 lie on one side of a line.
///
/// A line has a direction (dx, dy) with dy >= 0 and |dx| + dy = 1, and a distance e. A place (x,
/// y), measured from the square's middle, is on the line's side if e + dx y - dy x >= 0. So lines
/// with |e| > 1/2 miss the square.
///
/// Both dx and e are rounded to steps. Half a step is 1/128 in dx, which moves a line by less than
/// 1/128 within the square, and 1/252 in e. So the share of the square on one side has an error
/// with a root mean square of 1/126 / sqrt(12) = 0.0023. Counting 64 samples has five times this
/// error.
class half_planes {
public:
    static constexpr std::size_t turns = 128; ///< the number of steps of dx, from dx = -1 to dx = 1
    static constexpr std::size_t steps = 126; ///< the number of steps of e, from -1/2 to 1/2
    static constexpr std::size_t in_row = steps + 2;
    /// The index of e = 0 in a row of the table.
    static constexpr float middle = (steps + 1) / 2.0f;
    static constexpr float first_turn = turns / 2.0f; ///< the row of the table for dx = 0

    /// Makes the table. The square has `cells` x `cells` cells. A place is the middle of the cell
    /// in column x and row y.
    half_planes(std::span<const std::int16_t, 64> x, std::span<const std::int16_t, 64> y,
                int cells);

    /// The masks of places.
    /// Shape: a row for each direction, dx from -1 to 1. A row has an empty mask, then one for each
    ///        step of e from -1/2 to 1/2 (at its middle), and a full mask.
    const std::uint64_t* masks() const { return masks_.data(); }

    /// The places where a linear function is not negative. The function has the value `in_middle`
    /// in the square's middle, and grows by `right` and `down` over one side of the square.
    std::uint64_t not_negative(float in_middle, float right, float down) const {
        constexpr std::uint64_t all = ~std::uint64_t{0};
        const float size = (right < 0 ? -right : right) + (down < 0 ? -down : down);
        const float twice = in_middle + in_middle;
        if (twice >= size)
            return all;
        if (twice <= -size)
            return 0;
        const float scale = right > 0 ? -1 / size : 1 / size;
        const auto turn = static_cast<int>(down * scale * first_turn + (first_turn + 0.5f));
        const auto step = static_cast<int>(in_middle * scale * steps + (middle + 0.5f));
        const int place = turn * static_cast<int>(in_row) + step;
        return masks_[static_cast<unsigned>(place)] ^ (right > 0 ? all : 0);
    }

private:
    std::array<std::uint64_t, (turns + 1) * in_row> masks_{};
};

/// The table whose places are the samples of a pixel, made at the first call.
const half_planes& planes_of_samples();

/// The table whose places are the middles of the 8 x 8 pixels of a tile, row by row; made at the
/// first call.
const half_planes& planes_of_pixels();

} // namespace l3d_detail

#endif
