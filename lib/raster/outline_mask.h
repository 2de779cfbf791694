// SPDX-License-Identifier: MIT
// l3d_outline_mask: the pixels of a picture within a distance of given places.
#ifndef L3D_RASTER_OUTLINE_MASK_H
#define L3D_RASTER_OUTLINE_MASK_H

#include "tool_2d/pixels.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// A place in the picture. Units: pixels from its top left corner.
struct l3d_picture_place {
    double x = 0, y = 0;
};

/// A bit for each pixel.
///
/// Shape: rows of whole words, 64 pixels each, from the top.
/// Cost:  allocates only when larger than ever before.
class l3d_outline_mask {
public:
    /// All bits 0.
    void begin(l3d_size size);

    /// Sets the bits of pixels whose centres are no farther than `radius` from the line between
    /// two places.
    void add(const l3d_picture_place& from, const l3d_picture_place& to, double radius);

    void set(int x, int y) { words_[word_of(x, y)] |= std::uint64_t{1} << (x % 64); }
    bool at(int x, int y) const { return words_[word_of(x, y)] >> (x % 64) & 1; }

    /// The number of bits that are 1.
    std::int64_t count() const;

    l3d_size size() const { return size_; }

    friend bool operator==(const l3d_outline_mask&, const l3d_outline_mask&) = default;

private:
    std::size_t word_of(int x, int y) const {
        return static_cast<std::size_t>(y) * row_words_ + static_cast<std::size_t>(x / 64);
    }

    l3d_size size_;
    std::size_t row_words_ = 0;
    std::vector<std::uint64_t> words_;
};

#endif
