// SPDX-License-Identifier: MIT
// painter_items: boxes, depths and pixels of triangles, before these are compared.
#ifndef L3D_PIPELINE_ZSORT_PAINTER_ITEMS_P_H
#define L3D_PIPELINE_ZSORT_PAINTER_ITEMS_P_H

#include "raster/zsort/painter.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// A triangle that is to be put into painting order: its box, depths and pixels.
struct painter_item {
    /// The box of the pixels whose centres are in the triangle's box. Right and bottom are
    /// excluded.
    std::int32_t left, top, right, bottom;
    /// The least and the largest 1/w of the triangle's corners.
    float farthest, nearest;
    /// The pixels that a small triangle covers: bit 8 r + c is set if the triangle covers pixel
    /// (left + c, top + r). It is 0 if the box has more than eight rows or columns or reaches out
    /// of the picture, or if sides are drawn.
    std::uint64_t cover;
    std::uint32_t triangle; ///< the triangle's index in the list of painter_items::begin

    static constexpr std::int32_t small_side = 8; ///< number of rows and of columns of `cover`

    bool box_meets(const painter_item& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

/// The items that are made of a list of triangles, in the list's order.
///
/// Shape: the list is divided into chunks. The items of a chunk begin at the index of the chunk's
///        first triangle, so there are gaps between the items of chunks. An item's number is its
///        index in the array of items, with the gaps.
class painter_items {
public:
    /// The usual number of triangles in a chunk. Workers take one chunk at a time, which costs some
    /// 10^5 cycles.
    static constexpr std::size_t usual_chunk = 1024;

    /// Forgets all items, and takes new triangles, whose chunks end at `ends`. If the triangles'
    /// sides are not drawn, small triangles that cover no pixel are left out.
    void begin(std::span<const l3d_painter_triangle> triangles, std::span<const std::size_t> ends,
               l3d_size size, bool with_sides);
    /// Makes items of the triangles of a chunk that have an area and a box that holds a pixel's
    /// centre. Threads may make different chunks at the same time.
    void make(std::size_t chunk);
    /// Counts all items. Expects: make() was called for all chunks.
    void finish();

    std::size_t chunks() const { return kept_.size(); }
    /// The number of a chunk's first item.
    std::size_t first(std::size_t chunk) const { return chunk > 0 ? ends_[chunk - 1] : 0; }
    std::span<const painter_item> of_chunk(std::size_t chunk) const {
        return {items_.data() + first(chunk), kept_[chunk]};
    }

    /// Whether triangles are drawn only in the pixels that they cover, without lines at their
    /// sides.
    bool are_pixels_all() const { return !with_sides_; }
    const std::array<l3d_micro_vertex, 3>& corners(const painter_item& item) const {
        return triangles_[item.triangle].v;
    }

    const painter_item& operator[](std::uint32_t number) const { return items_[number]; }
    /// A number that is greater than the number of any item.
    std::size_t numbers() const { return items_.size(); }
    std::size_t count() const { return count_; }

    /// The mean number of pixels in an item's box; 0 if there are no items.
    double mean_box() const { return count_ > 0 ? area_ / static_cast<double>(count_) : 0; }

private:
    std::span<const l3d_painter_triangle> triangles_;
    std::vector<std::size_t> ends_; ///< for each chunk, the index behind its last triangle
    l3d_size size_{};
    bool with_sides_ = true;
    std::vector<painter_item> items_;
    std::vector<std::size_t> kept_; ///< number of items in each chunk
    std::vector<double> areas_;     ///< for each chunk, the sum of its boxes' areas
    std::size_t count_ = 0;
    double area_ = 0;
};

} // namespace l3d_detail

#endif
