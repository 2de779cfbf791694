// SPDX-License-Identifier: MIT
// path_chains: cuts outlines into runs of edges that all lead down or all lead up.
#ifndef L3D_RASTER_PATHS_PATH_CHAINS_P_H
#define L3D_RASTER_PATHS_PATH_CHAINS_P_H

#include "raster/paths/covered_span_p.h"
#include "raster/paths/path.h"
#include "tool_2d/pixels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// A run of an outline's corners, in order from top to bottom.
struct corner_run {
    const l3d_point_2d* first = nullptr;
    /// Step in memory to the next corner: 1, or -1 if the outline leads up.
    std::ptrdiff_t step = 1;
    std::size_t count = 0;

    bool empty() const { return count == 0; }
    const l3d_point_2d& operator[](std::size_t i) const {
        return first[static_cast<std::ptrdiff_t>(i) * step];
    }
};

/// The part of a chain in one row of pixels. It goes from the place where the chain enters the row,
/// through the chain's corners in the row, to the place where the chain leaves the row.
/// Units:   pixels of the box, row r from y = r to r + 1.
struct row_piece {
    double left, right; ///< the least and the largest x of the piece
    l3d_point_2d enters, leaves;
    corner_run corners; ///< the corners between the piece's ends
    /// 1 if the outline leads up, adding 1 to the winding on the right; else -1.
    std::int8_t direction;

    /// Calls edge(from, to) for each edge of the piece from top to bottom; some edges are
    /// horizontal.
    template <class Edge> void visit(const Edge& edge) const {
        l3d_point_2d from = enters;
        for (std::size_t i = 0; i < corners.count; ++i) {
            edge(from, corners[i]);
            from = corners[i];
        }
        edge(from, leaves);
    }
};

/// A straight edge, to find its x at any height between its ends. Rounding never puts this x beyond
/// the ends.
struct straight_edge {
    double x0 = 0, y0 = 0, slope = 0, least = 0, most = 0;

    straight_edge() = default;
    /// Expects: from.y < to.y.
    straight_edge(l3d_point_2d from, l3d_point_2d to)
        : x0(from.x), y0(from.y), slope((to.x - from.x) / (to.y - from.y)),
          least(std::min(from.x, to.x)), most(std::max(from.x, to.x)) {}

    double x_at(double y) const { return std::clamp(x0 + (y - y0) * slope, least, most); }
};

/// A chain: consecutive edges of an outline that only lead down, or only up.
class chain {
public:
    /// Makes a chain of corners `first` to `last` of the array `all`, from top to bottom.
    /// Expects: the picture has rows 0 to height - 1, and the chain reaches at least one of them.
    chain(const l3d_point_2d* all, std::size_t first, std::size_t last, std::int32_t height);

    /// The first row that the chain reaches; bottom() is the row after the last row that it
    /// reaches.
    std::int32_t top() const { return top_; }
    std::int32_t bottom() const { return bottom_; }
    /// The place where the chain enters the picture.
    const l3d_point_2d& begin() const { return begin_; }
    /// 1 if the outline leads up along this chain, which adds 1 to the winding number on the right;
    /// else -1.
    std::int8_t direction() const { return static_cast<std::int8_t>(-step_); }
    /// The next corner to which the chain leads, the place behind its last corner, and the step in
    /// memory between corners.
    const l3d_point_2d* next_corner(const l3d_point_2d* all) const { return all + next_; }
    const l3d_point_2d* behind(const l3d_point_2d* all) const { return all + last_ + step_; }
    std::ptrdiff_t step() const { return step_; }

private:
    std::ptrdiff_t next_; ///< index of the next corner to which the chain leads
    std::ptrdiff_t last_, step_;
    std::int32_t top_ = 0, bottom_ = 0;
    l3d_point_2d begin_;
};

/// Takes outlines, and cuts them at the sides of a picture. An outline that turns only once upwards
/// and once downwards is also cut into two chains.
///
/// Corners outside of the picture move to its sides. So outlines stay closed, and windings inside
/// of the picture stay the same. Horizontal edges belong to the chain that comes before these edges
/// in the outline.
/// Cost:    linear in the corners; allocates when there are more corners than ever before.
class path_chains {
public:
    /// Removes all outlines. Corners that are added later are moved by `move`.
    void clear(std::int32_t width, std::int32_t height, l3d_point_2d move = {});

    /// These three functions begin an outline, add its corners, and close it.
    void begin(l3d_point_2d corner);
    void lines(std::span<const l3d_point_2d> corners);
    void end(std::uint8_t layer);

    /// All chains. corners() is the array of the chains' corners.
    std::span<const chain> chains() const { return chains_; }
    const l3d_point_2d* corners() const { return corners_.data(); }

    /// Consecutive edges of an outline, and the heights between which they lie. Edge i leads from
    /// corner i to corner i + 1.
    struct block {
        std::uint32_t first, end;
        double top, bottom;
    };
    /// The blocks of all outlines. Blocks of one outline follow each other in the order of its
    /// edges.
    const std::vector<block>& blocks() const { return blocks_; }

    /// An outline that reaches the picture.
    struct outline {
        l3d_pixel_box box; ///< the box of all pixels that the outline reaches
        /// Index of the outline's first block, and the number of its blocks.
        std::size_t first_block, blocks;
        /// Index of the outline's first chain, which its second chain follows; `none` if the
        /// outline is not cut into two chains.
        std::size_t chains;
        std::uint8_t layer; ///< 0: an outline of the filled path; 1: of its clip path
        bool apart;         ///< whether its box meets no other outline's box; find_apart sets it

        static constexpr std::size_t none = ~std::size_t{0};
        bool is_pair() const { return chains != none; }
    };
    std::span<const outline> outlines() const { return outlines_; }
    /// Sorts outlines by their tops.
    void sort();
    /// Finds the outlines whose boxes meet no other outline's box, and sets their `apart`. It
    /// searches only if one of these may be an outline of two chains. Expects: sorted.
    void find_apart();

private:
    /// The range of x that an outline reaches.
    struct columns {
        double least, most;
    };

    void cut_at_sides();
    void add_blocks(std::size_t last);
    bool add_pair(std::size_t last);
    void add_chain(std::size_t first, std::size_t last, bool down);

    double width_ = 0;
    std::int32_t height_ = 0;
    l3d_point_2d move_{};
    std::size_t outline_ = 0; ///< the index of the present outline's first corner
    columns reached_{};       ///< the range of x of the present outline's corners
    kept_list<l3d_point_2d> corners_;
    std::vector<l3d_point_2d> uncut_;
    std::vector<chain> chains_;
    std::vector<block> blocks_;
    std::vector<outline> outlines_;
    std::vector<outline*> active_;
};

} // namespace l3d_detail

#endif
