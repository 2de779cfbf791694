// SPDX-License-Identifier: MIT
// marked_pixels: rearranges rows of bits into tiles.
#include "raster/refine/marked_pixels_p.h"

#include "raster/refine/pixel_samples_p.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace l3d_detail {

void marked_pixels::begin(const l3d_pixel_bits& marks, const drawn_depth& depth,
                          const l3d_pixel_box& band, std::size_t most) {
    assert(band.top % side == 0);
    band_ = band;
    first_row_ = band.top / side;
    columns_ = marks.row_words() * (l3d_pixel_bits::word_pixels / side);
    tiles_.clear();
    pixels_.clear();
    for (std::int32_t top = band.top; top < band.bottom; top += side) {
        if (pixels_.size() >= most) {
            band_.bottom = top;
            break;
        }
        const std::size_t first = tiles_.size();
        tiles_.resize(first + columns_);
        gather_bits(marks, top);
        for (std::size_t i = 0; i < columns_; ++i)
            if (tiles_[first + i].bits != 0)
                list(tiles_[first + i], static_cast<std::int32_t>(i) * side, top, depth);
    }
}

bool marked_pixels::reopen() {
    l3d_pixel_box reached{band_.right, band_.bottom, band_.left, band_.top};
    for (tile& of : tiles_) {
        of.open = 0;
        std::uint32_t i = of.first;
        for (std::uint64_t bits = of.bits; bits != 0; bits &= bits - 1) {
            marked_pixel& pixel = pixels_[i++];
            if (!pixel.is_closed || pixel.covered == ~std::uint64_t{0})
                continue;
            of.open |= bits & -bits;
            pixel.farthest = 0;
            pixel.last = fragment::none;
            pixel.covered = 0;
            pixel.least = HUGE_VALF;
            reached = {std::min(reached.left, pixel.x), std::min(reached.top, pixel.y),
                       std::max(reached.right, pixel.x + 1), std::max(reached.bottom, pixel.y + 1)};
        }
    }
    band_ = reached;
    return !reached.empty();
}

/// Gathers the bits of marked pixels in a row of tiles, tile by tile. A word of a row of pixels has
/// the bits of eight neighbouring tiles in this row.
void marked_pixels::gather_bits(const l3d_pixel_bits& marks, std::int32_t top) {
    constexpr std::size_t in_word = l3d_pixel_bits::word_pixels / side;
    constexpr std::uint64_t row_bits = (1u << side) - 1;
    tile* const row = tiles_.data() + static_cast<std::size_t>(top / side - first_row_) * columns_;
    for (std::int32_t y = top; y < std::min(top + side, band_.bottom); ++y)
        for (std::size_t w = 0; w < marks.row_words(); ++w) {
            const std::uint64_t word = marks.row(y)[w];
            for (std::size_t i = 0; word >> (side * i) != 0; ++i) {
                row[in_word * w + i].bits |= (word >> (side * i) & row_bits) << (side * (y % side));
                if (i + 1 == in_word)
                    break;
            }
        }
}

void marked_pixels::list(tile& of, std::int32_t left, std::int32_t top, const drawn_depth& depth) {
    of.open = of.bits;
    of.first = static_cast<std::uint32_t>(pixels_.size());
    for (std::uint64_t bits = of.bits; bits != 0; bits &= bits - 1) {
        const int bit = std::countr_zero(bits);
        const std::int32_t x = left + bit % side, y = top + bit / side;
        const float farthest = depth.farthest(x, y);
        pixels_.push_back({x, y, fragment::none, farthest > 0, farthest, HUGE_VALF, 0});
    }
}

} // namespace l3d_detail
