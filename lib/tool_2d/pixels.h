// SPDX-License-Identifier: MIT
// l3d_pixels: a borrowed block of 32-bit pixels.
#ifndef L3D_TOOL_2D_PIXELS_H
#define L3D_TOOL_2D_PIXELS_H

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>

/// Width and height of a picture or window, in pixels.
struct l3d_size {
    int width = 0;
    int height = 0;
    friend bool operator==(const l3d_size&, const l3d_size&) = default;
};

/// A view of the pixels that rasterizers write and screens show.
///
/// Shape:   height rows of `stride` words, the first `width` of each the picture; row 0 on top.
/// Units:   one word is 0x00RRGGBB in host byte order, whatever the display; screens convert
///          when they show.
/// Lives:   borrows; the screen or image that made it owns the words.
struct l3d_pixels {
    std::uint32_t* words = nullptr;
    int width = 0;
    int height = 0;
    std::ptrdiff_t stride = 0;

    l3d_size size() const { return {width, height}; }

    /// Expects: 0 <= y < height.
    std::span<std::uint32_t> row(int y) const {
        assert(y >= 0 && y < height);
        return {words + y * stride, static_cast<std::size_t>(width)};
    }
};

#endif
