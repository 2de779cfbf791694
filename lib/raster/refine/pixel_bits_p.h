// SPDX-License-Identifier: MIT
// pixel_bits: a bit for each pixel of a picture.
#ifndef L3D_RASTER_REFINE_PIXEL_BITS_P_H
#define L3D_RASTER_REFINE_PIXEL_BITS_P_H

#include "tool_2d/pixels.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace l3d_detail {

/// How many bits are set, without the instruction for it, which not all processors have.
constexpr int bits_in(std::uint64_t word) {
    word -= word >> 1 & 0x5555555555555555;
    word = (word & 0x3333333333333333) + (word >> 2 & 0x3333333333333333);
    word = (word + (word >> 4)) & 0x0f0f0f0f0f0f0f0f;
    return static_cast<int>(word * 0x0101010101010101 >> 56);
}

/// A bit for each pixel of a picture.
///
/// Shape: rows of whole words, 64 pixels each. Threads that change different rows do not meet.
/// Cost:  allocates only when larger than ever before.
class pixel_bits {
public:
    static constexpr std::int32_t word_pixels = 64;

    /// The bits mean nothing until each row is cleared.
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

    /// Where a column's bit is in the words of a row. Expects: x >= 0.
    static std::size_t word_of(std::int32_t x) { return static_cast<std::uint32_t>(x) / word_bits; }
    static unsigned bit_of(std::int32_t x) { return static_cast<std::uint32_t>(x) % word_bits; }

    void set(std::int32_t x, std::int32_t y) {
        row(y)[word_of(x)] |= std::uint64_t{1} << bit_of(x);
    }

    void flip(std::int32_t x, std::int32_t y) {
        row(y)[word_of(x)] ^= std::uint64_t{1} << bit_of(x);
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

    /// Calls visit(x, y) for every pixel of the box whose bit is set, row by row.
    template <class Visit> void for_each_in(const l3d_pixel_box& box, const Visit& visit) const;

    /// Pixels of rows [top, bottom) whose bits are set.
    std::int64_t count(std::int32_t top, std::int32_t bottom) const {
        std::int64_t result = 0;
        for (const std::uint64_t* word = row(top); word != row(top) + place(bottom - top); ++word)
            result += bits_in(*word);
        return result;
    }

    /// Whether any pixel of the box has its bit set.
    bool any(const l3d_pixel_box& box) const {
        for (std::int32_t y = box.top; y < box.bottom; ++y)
            for (std::int32_t w = box.left / word_pixels; w * word_pixels < box.right; ++w)
                if ((row(y)[w] & within(w, box.left, box.right)) != 0)
                    return true;
        return false;
    }

    /// The smallest box of those pixels of a box whose bits are set; empty if there are none.
    l3d_pixel_box bounds(const l3d_pixel_box& box) const {
        l3d_pixel_box result;
        const std::int32_t first = box.left / word_pixels;
        for (std::int32_t y = box.top; y < box.bottom; ++y)
            for (std::int32_t w = first; w * word_pixels < box.right; ++w) {
                const std::uint64_t bits = row(y)[w] & within(w, box.left, box.right);
                if (bits == 0)
                    continue;
                const std::int32_t left = w * word_pixels + std::countr_zero(bits);
                const std::int32_t right = (w + 1) * word_pixels - std::countl_zero(bits);
                result = result.united({left, y, right, y + 1});
            }
        return result;
    }

private:
    static constexpr std::uint32_t word_bits = word_pixels;

    std::size_t place(std::int32_t y) const { return static_cast<std::size_t>(y) * row_words_; }

    std::size_t row_words_ = 0;
    std::vector<std::uint64_t> words_;
};

template <class Visit>
void pixel_bits::for_each_in(const l3d_pixel_box& box, const Visit& visit) const {
    for (std::int32_t y = box.top; y < box.bottom; ++y)
        for (std::int32_t w = box.left / word_pixels; w * word_pixels < box.right; ++w) {
            std::uint64_t bits = row(y)[w] & within(w, box.left, box.right);
            for (; bits != 0; bits &= bits - 1)
                visit(w * word_pixels + std::countr_zero(bits), y);
        }
}

} // namespace l3d_detail

#endif
