// SPDX-License-Identifier: MIT
// pixel_bits: a bit for each pixel of a picture.
#ifndef L3D_RASTER_REFINE_PIXEL_BITS_P_H
#define L3D_RASTER_REFINE_PIXEL_BITS_P_H

#include "tool_2d/pixels.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace l3d_detail {

/// A bit for each pixel of a picture.
///
/// Shape: rows of whole words, 64 pixels each. Threads that change different rows do not meet.
/// Cost:  allocates only when larger than ever before.
class pixel_bits {
public:
    static constexpr std::int32_t word_pixels = 64;

    /// Sets the size. The bits mean nothing until each row is cleared.
    void resize(l3d_size size) {
        row_words_ = (static_cast<std::size_t>(size.width) + word_pixels - 1) / word_pixels;
        const std::size_t needed = row_words_ * static_cast<std::size_t>(size.height);
        if (words_.size() < needed)
            words_.resize(needed);
    }

    /// Clears rows [top, bottom).
    void clear(std::int32_t top, std::int32_t bottom) {
        std::fill(row(top), row(top) + place(bottom - top), std::uint64_t{0});
    }

    std::size_t row_words() const { return row_words_; }
    std::uint64_t* row(std::int32_t y) { return words_.data() + place(y); }
    const std::uint64_t* row(std::int32_t y) const { return words_.data() + place(y); }

    /// The index of the word that has a column's bit. Expects: x >= 0.
    static std::size_t word_of(std::int32_t x) { return static_cast<std::uint32_t>(x) / word_bits; }
    static unsigned bit_of(std::int32_t x) { return static_cast<std::uint32_t>(x) % word_bits; }

    void set(std::int32_t x, std::int32_t y) {
        row(y)[word_of(x)] |= std::uint64_t{1} << bit_of(x);
    }

    bool has(std::int32_t x, std::int32_t y) const {
        return (row(y)[word_of(x)] >> bit_of(x) & 1) != 0;
    }

    /// The bits of columns [left, right) that are in the word with index `word`.
    static std::uint64_t within(std::int32_t word, std::int32_t left, std::int32_t right) {
        const std::int32_t begin = std::max(left - word * word_pixels, 0);
        const std::int32_t end = std::min(right - word * word_pixels, word_pixels);
        if (begin >= end)
            return 0;
        const std::uint64_t all = ~std::uint64_t{0};
        return (all >> (word_pixels - (end - begin))) << begin;
    }

private:
    static constexpr std::uint32_t word_bits = word_pixels;

    std::size_t place(std::int32_t y) const { return static_cast<std::size_t>(y) * row_words_; }

    std::size_t row_words_ = 0;
    std::vector<std::uint64_t> words_;
};

} // namespace l3d_detail

#endif
