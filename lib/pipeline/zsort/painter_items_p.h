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

/// A triangle that is to be put into an order.
struct painter_item {
    /// The pixels whose centres are in the triangle's box, ends excluded.
    std::int32_t left, top, right, bottom;
    /// The range of the triangle's 1/w.
    float farthest, nearest;
    /// If not 0, the box has at most eight rows and columns and lies in the picture. Bit 8 r + c is
    /// then set if pixel (left + c, top + r) is covered.
    std::uint64_t cover;
    std::uint32_t triangle; ///< its index in the given triangles

    static constexpr std::int32_t small_side = 8; ///< rows and columns of `cover`

    bool box_meets(const painter_item& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

/// The items of a list of triangles, in its order.
///
/// Shape: triangles come in chunks, side by side. The items of a chunk begin at the index of its
///        first triangle, so there are gaps between chunks. An item's number is its index, gaps
///        included.
class painter_items {
public:
    /// The usual number of triangles in a chunk. A worker takes a chunk at a time, for some 10^5
    /// cycles.
    static constexpr std::size_t usual_chunk = 1024;

    /// Forgets all items, and takes new triangles, whose chunks end at `ends`. Small triangles that
    /// cover no pixel will be left out, unless sides are drawn.
    void begin(std::span<const l3d_painter_triangle> triangles, std::span<const std::size_t> ends,
               l3d_size size, bool with_sides);
    /// Makes items of those triangles of a chunk that have an area and a box that holds a pixel's
    /// centre. Threads may make chunks side by side.
    void make(std::size_t chunk);
    /// Expects: all chunks are made.
    void finish();

    std::size_t chunks() const { return kept_.size(); }
    /// The number of a chunk's first item.
    std::size_t first(std::size_t chunk) const { return chunk > 0 ? ends_[chunk - 1] : 0; }
    std::span<const painter_item> of_chunk(std::size_t chunk) const {
        return {items_.data() + first(chunk), kept_[chunk]};
    }

    /// Whether items draw only the pixels that they cover, and no sides.
    bool are_pixels_all() const { return !with_sides_; }
    const std::array<l3d_micro_vertex, 3>& corners(const painter_item& item) const {
        return triangles_[item.triangle].v;
    }

    const painter_item& operator[](std::uint32_t number) const { return items_[number]; }
    /// A number greater than that of any item.
    std::size_t numbers() const { return items_.size(); }
    std::size_t count() const { return count_; }

    /// The mean number of pixels in a box; 0 if there are no items.
    double mean_box() const { return count_ > 0 ? area_ / static_cast<double>(count_) : 0; }

private:
    std::span<const l3d_painter_triangle> triangles_;
    std::vector<std::size_t> ends_; ///< the ends of chunks
    l3d_size size_{};
    bool with_sides_ = true;
    std::vector<painter_item> items_;
    std::vector<std::size_t> kept_; ///< number of items in each chunk
    std::vector<double> areas_;     ///< areas of each chunk's boxes
    std::size_t count_ = 0;
    double area_ = 0;
};

} // namespace l3d_detail

#endif
