// SPDX-License-Identifier: MIT
// painter_tiles: for each tile of the picture the triangles that reach it.
#ifndef L3D_PIPELINE_POLYGONS_PAINTER_TILES_P_H
#define L3D_PIPELINE_POLYGONS_PAINTER_TILES_P_H

#include "raster/micro_grid.h"
#include "raster/parallel/workers.h"
#include "tool_2d/pixels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// The pixels whose centres are in a triangle's box, ends excluded, and its range of 1/w.
struct pixel_range {
    std::int32_t left, top, right, bottom;
    float farthest, nearest;

    bool empty() const { return left >= right || top >= bottom; }
    bool meets(const pixel_range& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

pixel_range range_of(const std::array<l3d_micro_vertex, 3>& v, l3d_size size);

/// A tile of the picture, and where it lies among tiles.
struct painter_tile {
    std::size_t index;
    int column, row;
};

/// For each tile of the picture the triangles whose boxes reach it, in rising order.
class painter_tiles {
public:
    /// Squares about twice as wide as the mean triangle: fewer would list each triangle often,
    /// larger ones would list together what does not meet.
    /// Expects: ranges that are not empty.
    void make(std::span<const pixel_range> ranges, l3d_size size, l3d_workers& workers);

    int rows() const { return rows_; }
    int columns() const { return columns_; }
    painter_tile tile(int column, int row) const {
        return {static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                    static_cast<std::size_t>(column),
                column, row};
    }

    /// Calls visit(tile) for each that a range reaches.
    template <class Visit> void for_each(const pixel_range& r, const Visit& visit) const {
        for (int row = r.top >> shift_; row <= (r.bottom - 1) >> shift_; ++row)
            for (int column = r.left >> shift_; column <= (r.right - 1) >> shift_; ++column)
                visit(tile(column, row));
    }

    std::span<const std::uint32_t> members(const painter_tile& of) const {
        return {entries_.data() + begins_[of.index], entries_.data() + begins_[of.index + 1]};
    }

    /// The members of a tile. Those at its beginning for which `skip` is true are dropped for good.
    template <class Skip>
    std::span<const std::uint32_t> rest(const painter_tile& of, const Skip& skip) {
        std::uint32_t& head = heads_[of.index];
        const std::uint32_t end = begins_[of.index + 1];
        while (head < end && skip(entries_[head]))
            ++head;
        return {entries_.data() + head, end - head};
    }

    /// Whether two ranges meet, and this tile is the first of those that both reach. So each pair
    /// is found once.
    bool first_meet(const painter_tile& here, const pixel_range& a, const pixel_range& b) const {
        return a.meets(b) && here.column == std::max(a.left, b.left) >> shift_ &&
               here.row == std::max(a.top, b.top) >> shift_;
    }

private:
    int shift_ = 0, columns_ = 0, rows_ = 0;
    std::vector<std::uint32_t> begins_, heads_, entries_;
    std::vector<std::vector<std::uint32_t>> ends_; ///< of each share of triangles, by tile
};

} // namespace l3d_detail

#endif
