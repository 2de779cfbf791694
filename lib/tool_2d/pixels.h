// SPDX-License-Identifier: MIT
// l3d_pixels: a borrowed block of 32-bit pixels.
#ifndef L3D_TOOL_2D_PIXELS_H
#define L3D_TOOL_2D_PIXELS_H

#include "base/public.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>

/// Width and height of a picture or window, in pixels.
struct L3D_PUBLIC l3d_size {
    int width = 0;  ///< number of columns
    int height = 0; ///< number of rows
    friend bool operator==(const l3d_size&, const l3d_size&) = default;
};

/// The largest width and height that a picture may have. A picture of this size takes 1 GiB. X11
/// counts window sizes in 16 bits, and l3d_guard_band, the range of the rasterizer, is as wide.
inline constexpr int l3d_largest_side = 16384;

/// A view of the pixels that rasterizers write and screens show.
///
/// Shape:   height rows of `stride` words, the first `width` of each the picture; row 0 on top.
/// Units:   one word is 0x00RRGGBB in host byte order, whatever the display; screens convert
///          when they show. The highest byte has a meaning only in a picture without background: it
///          says how transparent the pixel is, 0 for not at all. Red, green and blue are then those
///          of the covered part, as in PNG files.
/// Lives:   borrows; the screen or image that made the view owns the words.
struct L3D_PUBLIC l3d_pixels {
    std::uint32_t* words = nullptr; ///< the first word of the top row
    int width = 0;                  ///< number of columns
    int height = 0;                 ///< number of rows
    std::ptrdiff_t stride = 0;      ///< words from one row to the next

    /// The word of an empty pixel in a picture without background.
    static constexpr std::uint32_t transparent = 0xff000000;

    /// Width and height, in pixels.
    l3d_size size() const { return {width, height}; }

    /// The words of a row of the picture. Expects: 0 <= y < height.
    std::span<std::uint32_t> row(int y) const {
        assert(y >= 0 && y < height);
        return {words + y * stride, static_cast<std::size_t>(width)};
    }

    /// Whether both are views of the same words in memory, in the same shape.
    friend bool operator==(const l3d_pixels&, const l3d_pixels&) = default;
};

/// A rectangle of a picture: columns [left, right) of rows [top, bottom).
struct L3D_PUBLIC l3d_pixel_box {
    /// The first column and row inside the box, and the first column and row beyond it.
    std::int32_t left = 0, top = 0, right = 0, bottom = 0;

    /// Whether the box holds no pixel.
    bool empty() const { return left >= right || top >= bottom; }

    /// The box with `by` more pixels on each side. It may reach beyond the picture.
    l3d_pixel_box grown(std::int32_t by) const {
        return {left - by, top - by, right + by, bottom + by};
    }

    /// The number of pixels in the box.
    std::int64_t area() const {
        return empty() ? 0 : (std::int64_t{right} - left) * (std::int64_t{bottom} - top);
    }

    /// The part that both boxes share; empty if they do not meet.
    l3d_pixel_box intersected(const l3d_pixel_box& other) const {
        return {std::max(left, other.left), std::max(top, other.top), std::min(right, other.right),
                std::min(bottom, other.bottom)};
    }

    /// The smallest box that holds both boxes.
    l3d_pixel_box united(const l3d_pixel_box& other) const {
        if (empty() || other.empty())
            return empty() ? other : *this;
        return {std::min(left, other.left), std::min(top, other.top), std::max(right, other.right),
                std::max(bottom, other.bottom)};
    }

    /// The place of this box in an enlarged picture, where each pixel is a square of scale x scale.
    l3d_pixel_box scaled(int scale) const {
        return {scale * left, scale * top, scale * right, scale * bottom};
    }

    friend bool operator==(const l3d_pixel_box&, const l3d_pixel_box&) = default;
};

/// The box that holds a whole picture of this size.
inline l3d_pixel_box l3d_whole(l3d_size size) {
    return {0, 0, size.width, size.height};
}

/// The part of row y that lies in a box. Expects: both lie in the picture.
inline std::span<std::uint32_t> l3d_row(const l3d_pixels& pixels, int y, const l3d_pixel_box& box) {
    return pixels.row(y).subspan(static_cast<std::size_t>(box.left),
                                 static_cast<std::size_t>(box.right - box.left));
}

#endif
