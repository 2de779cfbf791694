// SPDX-License-Identifier: MIT
// l3d_error_map: a bound of each pixel's difference from the exact picture.
#ifndef L3D_RASTER_ERROR_MAP_H
#define L3D_RASTER_ERROR_MAP_H

#include "base/public.h"
#include "tool_2d/pixels.h"

#include <cstddef>
#include <vector>

/// A number for each pixel: the certified bound of its error, in levels of 255.
///
/// The exact pixel is the mean of linear light over its square, encoded. It is not rounded to a
/// whole level.
class L3D_PUBLIC l3d_error_map {
public:
    /// All numbers 0.
    void begin(l3d_size size) {
        size_ = size;
        levels_.assign(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height),
                       0.0F);
    }

    /// Width and height, in pixels.
    l3d_size size() const { return size_; }

    /// The bound of a pixel. Expects: a pixel of the picture.
    float at(int x, int y) const { return levels_[place(x, y)]; }
    /// Sets the bound of a pixel. Expects: a pixel of the picture.
    void set(int x, int y, float level) { levels_[place(x, y)] = level; }

    /// All bounds, row by row from the top.
    const std::vector<float>& levels() const { return levels_; }

private:
    std::size_t place(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
               static_cast<std::size_t>(x);
    }

    l3d_size size_;
    std::vector<float> levels_;
};

#endif
