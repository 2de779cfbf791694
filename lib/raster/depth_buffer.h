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

/// An allocator for arrays that begin at the start of a cache line.
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

/// The depth of each pixel as a float: 1 / (distance along the view axis), and 0 where no surface
/// is.
///
/// For a plane, the reciprocal of the distance is a linear function of the place in the picture. A
/// depth of 0 means infinitely far, so it marks an empty pixel.
///
/// Shape:   each row begins at a cache line. Rows are `pitch` floats apart, an odd multiple of 64.
///          A multiple of 1024 floats, 4 KB, would be slow. Processors tell addresses apart by
///          their last 12 bits, so a row's loads would wait for stores to the row above. Besides, a
///          column's pixels would share a set of the cache.
class L3D_PUBLIC l3d_depth_buffer {
public:
    /// Sets the width and the height.
    /// Expects: width, height >= 0.
    /// Cost:    allocates if the new size is larger than any before, or much smaller. So a window
    ///          that was large once gives back memory.
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

    /// The first value of the first row; row y begins y * pitch() floats later.
    float* data() { return values_.data(); }
    /// The distance between rows, in floats.
    std::ptrdiff_t pitch() const { return pitch_; }

    /// The values of a row, which the caller may change. Expects: 0 <= y < size().height.
    std::span<float> row(int y) {
        return {values_.data() + y * pitch_, static_cast<std::size_t>(size_.width)};
    }
    /// The values of a row, for reading. Expects: 0 <= y < size().height.
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

/// The distance of each pixel along the view axis; +infinity where no surface is.
/// Shape: row by row from the top, size().width values in each.
L3D_PUBLIC std::vector<float> l3d_distances(const l3d_depth_buffer& depth);

/// A certified bound for the error of each pixel, in levels of 255.
///
/// The error is the difference from the exact pixel: the mean of linear light over the pixel's
/// square, encoded but not rounded to a whole level.
class L3D_PUBLIC l3d_error_map {
public:
    /// Takes the picture's size, and sets all bounds to 0.
    void begin(l3d_size size) {
        size_ = size;
        levels_.assign(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height),
                       0.0F);
    }

    /// Width and height, in pixels.
    l3d_size size() const { return size_; }

    /// The bound of a pixel. Expects: the pixel lies in the picture.
    float at(int x, int y) const { return levels_[place(x, y)]; }
    /// Sets the bound of a pixel. Expects: the pixel lies in the picture.
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
