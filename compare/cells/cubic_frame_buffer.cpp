// SPDX-License-Identifier: MIT
// l3d_cubic_frame_buffer: stores cells in bricks, and follows rays through them.
#include "compare/cells/cubic_frame_buffer.h"

#include "compare/cells/cell_stride.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace {

constexpr std::uint32_t occupied = 1u << 30;

/// Packs a normal: its components, from -1 to 1, in steps of 1/511.
std::uint32_t packed(const std::array<float, 3>& normal) {
    std::uint32_t word = occupied;
    for (std::size_t i = 0; i < 3; ++i)
        word |= static_cast<std::uint32_t>(static_cast<int>(std::lround(normal[i] * 511)) + 511)
                << (10 * i);
    return word;
}

std::array<float, 3> unpacked(std::uint32_t word) {
    std::array<float, 3> normal;
    for (std::size_t i = 0; i < 3; ++i)
        normal[i] = static_cast<float>(static_cast<int>(word >> (10 * i) & 1023) - 511) / 511;
    return normal;
}

} // namespace

void l3d_cubic_frame_buffer::reset(int resolution) {
    assert(resolution >= 1);
    resolution_ = resolution;
    filled_ = 0;
    const auto along = static_cast<std::size_t>(bricks());
    index_.assign(along * along * along, 0);
    bricks_.clear();
}

void l3d_cubic_frame_buffer::fill(const place& at, const std::array<float, 3>& normal) {
    std::size_t of = 0, in = 0;
    for (std::size_t i = 3; i-- > 0;) {
        if (!(at[i] >= 0 && at[i] < resolution_))
            return;
        const auto where = static_cast<std::size_t>(at[i]);
        of = of * static_cast<std::size_t>(bricks()) + where / side;
        in = in * side + where % side;
    }
    std::uint32_t& index = index_[of];
    if (index == 0) {
        bricks_.emplace_back().fill(0);
        index = static_cast<std::uint32_t>(bricks_.size());
    }
    cell& here = bricks_[index - 1][in];
    filled_ += here == 0;
    if (here == 0)
        here = packed(normal);
}

const l3d_cubic_frame_buffer::brick*
l3d_cubic_frame_buffer::brick_at(const std::array<int, 3>& of) const {
    const auto at = static_cast<std::size_t>((of[2] * bricks() + of[1]) * bricks() + of[0]);
    return index_[at] == 0 ? nullptr : &bricks_[index_[at] - 1];
}

std::optional<l3d_cubic_frame_buffer::hit>
l3d_cubic_frame_buffer::first(const place& origin, const place& direction, double least_t) const {
    const auto [t, end] = l3d_in_cube(origin, direction, resolution_, least_t);
    if (!(t < end))
        return std::nullopt;
    const auto inside = [this](const std::array<int, 3>& of) {
        return std::all_of(of.begin(), of.end(), [this](int i) { return i >= 0 && i < bricks(); });
    };
    for (l3d_cell_stride outer(origin, direction, t, side, bricks()); inside(outer.cell());
         outer.go_on()) {
        const brick* const here = brick_at(outer.cell());
        if (!here)
            continue;
        const double leaves = std::min(outer.leaves(), end); // the last bricks may stick out
        const auto& corner = outer.cell();
        for (l3d_cell_stride inner(origin, direction, outer.t(), 1, resolution_);
             inner.t() < leaves; inner.go_on()) {
            std::size_t in = 0;
            bool within = true;
            for (std::size_t i = 3; i-- > 0;) {
                const int at = inner.cell()[i] - corner[i] * side;
                within = within && at >= 0 && at < side;
                in = in * side + static_cast<std::size_t>(at & (side - 1));
            }
            if (!within || (*here)[in] == 0)
                continue;
            double along = 0, length = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                along += (inner.cell()[i] + 0.5 - origin[i]) * direction[i];
                length += direction[i] * direction[i];
            }
            if (along / length >= least_t)
                return hit{along / length, unpacked((*here)[in])};
        }
    }
    return std::nullopt;
}

bool l3d_cubic_frame_buffer::is_filled(const std::array<int, 3>& of) const {
    const brick* const here = brick_at({of[0] / side, of[1] / side, of[2] / side});
    std::size_t in = 0;
    for (std::size_t i = 3; i-- > 0;)
        in = in * side + static_cast<std::size_t>(of[i] % side);
    return here && (*here)[in] != 0;
}
