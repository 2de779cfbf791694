// SPDX-License-Identifier: MIT
// l3d_pixel_bits: a bit for each pixel of a picture.
#ifndef L3D_RASTER_PIXEL_BITS_H
#define L3D_RASTER_PIXEL_BITS_H

#include "tool_2d/pixels.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Marks pixels of a picture: a bit for each pixel.
///
/// Shape: rows of whole words, 64 pixels each. Threads may change different rows at the same time.
/// Cost:  allocates only when a picture is larger than ever before.
class l3d_pixel_bits {
public:
    static constexpr std::int32_t word_pixels = 64;

    /// Sets the size. The bits have no meaning until each row is cleared.
    void resize(l3d_size size) {
        size_ = size;
        row_words_ = (static_cast<std::size_t>(size.width) + word_pixels - 1) / word_pixels;
        words_.resize(std::max(words_.size(), place(size.height)));
    }

    /// Clears rows [top, bottom).
    void clear(std::int32_t top, std::int32_t bottom) {
        std::fill(row(top), row(top) + place(bottom - top), std::uint64_t{0});
    }

    /// Sets the size, and clears all bits.
    void begin(l3d_size size) {
        resize(size);
        clear(0, size.height);
    }

    l3d_size size() const { return size_; }
    std::size_t row_words() const { return row_words_; }
    std::uint64_t* row(std::int32_t y) { return words_.data() + place(y); }
    const std::uint64_t* row(std::int32_t y) const { return words_.data() + place(y); }

    /// The index, within a row, of the word that has a column's bit. Expects: x >= 0.
    static std::size_t word_of(std::int32_t x) { return static_cast<std::uint32_t>(x) / word_bits; }
    static unsigned bit_of(std::int32_t x) { return static_cast<std::uint32_t>(x) % word_bits; }

    void set(std::int32_t x, std::int32_t y) {
        row(y)[word_of(x)] |= std::uint64_t{1} << bit_of(x);
    }

    bool has(std::int32_t x, std::int32_t y) const {
        return (row(y)[word_of(x)] >> bit_of(x) & 1) != 0;
    }

    /// A mask for the word with index `word` in a row: the bits of its columns in [left, right).
    static std::uint64_t within(std::int32_t word, std::int32_t left, std::int32_t right) {
        const std::int32_t begin = std::max(left - word * word_pixels, 0);
        const std::int32_t end = std::min(right - word * word_pixels, word_pixels);
        if (begin >= end)
            return 0;
        const std::uint64_t all = ~std::uint64_t{0};
        return (all >> (word_pixels - (end - begin))) << begin;
    }

    /// Sets the bits of columns [left, right) of a row; has_all() tells whether all of them are
    /// set.
    /// Expects: these columns are in the picture, and there is at least one column.
    void set_all(std::int32_t y, std::int32_t left, std::int32_t right) {
        for (std::int32_t word = left / word_pixels; word * word_pixels < right; ++word)
            row(y)[word] |= within(word, left, right);
    }
    bool has_all(std::int32_t y, std::int32_t left, std::int32_t right) const {
        bool result = true;
        for (std::int32_t word = left / word_pixels; result && word * word_pixels < right; ++word)
            result = (~row(y)[word] & within(word, left, right)) == 0;
        return result;
    }

    /// The number of bits that are 1. Expects: all rows were cleared.
    std::int64_t count() const {
        std::int64_t result = 0;
        for (const std::uint64_t* word = row(0); word < row(size_.height); ++word)
            result += std::popcount(*word);
        return result;
    }

    friend bool operator==(const l3d_pixel_bits& a, const l3d_pixel_bits& b) {
        return a.size_ == b.size_ && std::equal(a.row(0), a.row(a.size_.height), b.row(0));
    }

private:
    static constexpr std::uint32_t word_bits = word_pixels;

    std::size_t place(std::int32_t y) const { return static_cast<std::size_t>(y) * row_words_; }

    l3d_size size_;
    std::size_t row_words_ = 0;
    std::vector<std::uint64_t> words_;
};

#endif
