// SPDX-License-Identifier: MIT
// l3d_depth_buffer: reciprocal depth per pixel; and l3d_error_map, a bound of each pixel's error.
#ifndef L3D_RASTER_DEPTH_BUFFER_H
#define L3D_RASTER_DEPTH_BUFFER_H

#include "base/public.h"
#include "tool_2d/pixels.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <vector>

namespace l3d_detail {

/// Memory that begins where a cache line does.
template <class T> struct L3D_PUBLIC line_allocator {
    using value_type = T;
    static constexpr std::align_val_t line{64};

    line_allocator() = default;
    template <class U> line_allocator(const line_allocator<U>&) {}

    T* allocate(std::size_t count) {
        return static_cast<T*>(::operator new(count * sizeof(T), line));
    }
    void deallocate(T* memory, std::size_t) { ::operator delete(memory, line); }

    friend bool operator==(line_allocator, line_allocator) { return true; }
};

} // namespace l3d_detail

/// One float per pixel: 1 / (distance along the view axis); 0 where nothing is.
///
/// The depth is reciprocal, since that is linear in the picture for a plane, and 0, infinitely far,
/// marks an empty pixel.
///
/// Shape:   rows begin a cache line. They are `pitch` floats apart, an odd multiple of 64. With a
///          multiple of 1024, that is 4 KB, a row's loads would wait for stores to the row above:
///          processors tell addresses apart by their last 12 bits. A column's pixels would share a
///          set of the cache.
class L3D_PUBLIC l3d_depth_buffer {
public:
    /// Expects: width, height >= 0. Cost: allocates when larger than before, or when much smaller:
    ///          a window that was large once does not keep its memory.
    void resize(l3d_size size) {
        size_ = size;
        pitch_ = (size.width + 63) / 64 * 64 | 64;
        const auto count = static_cast<std::size_t>(pitch_) * static_cast<std::size_t>(size.height);
        constexpr std::size_t least_given_back = std::size_t{1} << 18; // a megabyte
        if (values_.size() > 4 * count + least_given_back) {
            values_.clear();
            values_.shrink_to_fit();
        }
        if (values_.size() < count)
            values_.resize(count);
    }

    /// Makes every pixel empty.
    void clear() { std::fill(values_.begin(), values_.end(), 0.0f); }

    /// Width and height, in pixels.
    l3d_size size() const { return size_; }

    /// The first row; others are at multiples of the pitch.
    float* data() { return values_.data(); }
    /// The distance between rows, in floats.
    std::ptrdiff_t pitch() const { return pitch_; }

    /// The values of a row, to be changed. Expects: 0 <= y < size().height.
    std::span<float> row(int y) {
        return {values_.data() + y * pitch_, static_cast<std::size_t>(size_.width)};
    }
    /// The values of a row. Expects: 0 <= y < size().height.
    std::span<const float> row(int y) const {
        return {values_.data() + y * pitch_, static_cast<std::size_t>(size_.width)};
    }

private:
    l3d_size size_;
    std::ptrdiff_t pitch_ = 0;
    std::vector<float, l3d_detail::line_allocator<float>> values_;
};

/// The number of pixels that are not empty.
L3D_PUBLIC std::int64_t l3d_covered(const l3d_depth_buffer& depth);

/// Distance along the view axis per pixel, +infinity where nothing is.
/// Shape: row by row from the top, width values each.
L3D_PUBLIC std::vector<float> l3d_distances(const l3d_depth_buffer& depth);

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
