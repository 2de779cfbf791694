// SPDX-License-Identifier: MIT
// path_chains: outlines as runs of edges that all lead down or all lead up.
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

/// A run of an outline's corners, from top to bottom.
struct corner_run {
    const l3d_point_2d* first = nullptr;
    std::ptrdiff_t step = 1; ///< step in memory to the next corner: 1, or -1 where the outline
                             ///< leads up
    std::size_t count = 0;

    bool empty() const { return count == 0; }
    const l3d_point_2d& operator[](std::size_t i) const {
        return first[static_cast<std::ptrdiff_t>(i) * step];
    }
};

/// The part of a chain in one row of pixels. It goes from the place where the chain enters the row,
/// by its corners there, to the place where it leaves.
/// Units:   pixels of the box, row r from y = r to r + 1.
struct row_piece {
    double left, right; ///< the piece lies between these x
    l3d_point_2d enters, leaves;
    corner_run corners;    ///< corners between its ends
    std::int8_t direction; ///< 1 if the outline leads upwards here, which adds 1 to the winding on
                           ///< the right; else -1
    std::uint8_t layer;    ///< 0: an edge of the filled path; 1: of its clip path

    double height() const { return leaves.y - enters.y; }

    /// Calls edge(from, to) for each edge of the piece from top to bottom; some edges are level.
    template <class Edge> void visit(const Edge& edge) const {
        l3d_point_2d from = enters;
        for (std::size_t i = 0; i < corners.count; ++i) {
            edge(from, corners[i]);
            from = corners[i];
        }
        edge(from, leaves);
    }
};

/// A straight edge, for the x at any height within it. Rounding never puts x beyond its ends.
struct straight_edge {
    double x0 = 0, y0 = 0, slope = 0, least = 0, most = 0;

    straight_edge() = default;
    /// Expects: from.y < to.y.
    straight_edge(l3d_point_2d from, l3d_point_2d to)
        : x0(from.x), y0(from.y), slope((to.x - from.x) / (to.y - from.y)),
          least(std::min(from.x, to.x)), most(std::max(from.x, to.x)) {}

    double x_at(double y) const { return std::clamp(x0 + (y - y0) * slope, least, most); }
};

/// A chain: consecutive edges of an outline that only lead down, or only up. It is walked row by
/// row, from top to bottom.
class chain {
public:
    /// Makes a chain of corners `first` to `last` of the array `all`, from top to bottom.
    /// Expects: the picture has rows 0 to height - 1, and the chain reaches at least one of them.
    chain(const l3d_point_2d* all, std::size_t first, std::size_t last, std::int32_t height,
          std::uint8_t layer);

    /// The first row that the chain reaches, and the row after the last.
    std::int32_t top() const { return top_; }
    std::int32_t bottom() const { return bottom_; }

    /// Walks to the next row, whose piece is then piece().
    /// Expects: `all` has the same corners as before; rows from top() to bottom() - 1, in order.
    void enter(std::int32_t row, const l3d_point_2d* all);

    const row_piece& piece() const { return piece_; }

    /// Sets the piece of a row, for callers that walk the chain by themselves.
    void take_piece(const row_piece& piece) { piece_ = piece; }
    /// The next corner to which the chain leads, the place behind its last corner, and the step in
    /// memory between corners.
    const l3d_point_2d* next_corner(const l3d_point_2d* all) const { return all + next_; }
    const l3d_point_2d* behind(const l3d_point_2d* all) const { return all + last_ + step_; }
    std::ptrdiff_t step() const { return step_; }
    /// Makes the chain reach no rows.
    void leave_out() { bottom_ = top_; }

private:
    void enter_at_corners(std::int32_t row, const l3d_point_2d* all);

    std::ptrdiff_t next_; ///< index of the next corner to which the chain leads
    std::ptrdiff_t last_, step_;
    std::int32_t top_ = 0, bottom_ = 0;
    /// The edge by which the chain leaves the row, if this edge ends at `end_` in a later row.
    straight_edge edge_;
    double end_;
    row_piece piece_{};
};

inline void chain::enter(std::int32_t row, const l3d_point_2d* all) {
    const double row_end = row + 1;
    if (end_ <= row_end)
        return enter_at_corners(row, all);
    piece_.enters = piece_.leaves;
    piece_.leaves = {edge_.x_at(row_end), row_end};
    piece_.left = std::min(piece_.enters.x, piece_.leaves.x);
    piece_.right = std::max(piece_.enters.x, piece_.leaves.x);
    piece_.corners.count = 0;
}

/// Takes outlines, and cuts them into chains: at the sides of a picture, and where they turn up or
/// down.
///
/// Corners outside of the picture move to its sides. So outlines stay closed, and windings inside
/// of the picture stay the same. Level edges belong to the chain before them.
/// Cost:    linear in the corners; allocates when there are more than ever before.
class path_chains {
public:
    /// Removes all chains. Corners that are added later are moved by `move`.
    void clear(std::int32_t width, std::int32_t height, l3d_point_2d move = {});

    /// These three functions begin an outline, add its corners, and close it.
    void begin(l3d_point_2d corner);
    void lines(std::span<const l3d_point_2d> corners);
    void end(std::uint8_t layer);

    /// All chains, and the array of their corners.
    std::span<chain> chains() { return chains_; }
    const l3d_point_2d* corners() const { return corners_.data(); }

    /// An outline that reaches the picture.
    struct outline {
        l3d_pixel_box box;         ///< the box of all pixels that it reaches
        std::size_t first, chains; ///< its first chain, and how many
        bool apart;                ///< set by find_apart: its box meets no other outline's
    };
    std::span<const outline> outlines() const { return outlines_; }
    /// Finds the outlines whose boxes meet no other's. It searches only if an outline of two chains
    /// may be among them.
    void find_apart();

    /// Sorts the chains by their top rows. Returns the row after the last one reached.
    std::int32_t sort();
    /// The first row that a chain reaches. Expects: sorted.
    std::int32_t top() const { return top_; }
    /// The chains that begin in a row. Expects: sorted; top() or a later row.
    std::span<const std::uint32_t> begun_in(std::int32_t row) const;

private:
    /// The range of x that an outline reaches.
    struct columns {
        double least, most;
    };

    void cut_at_sides();
    void add_chain(std::size_t first, std::size_t last, bool down, std::uint8_t layer);
    void add_outline(std::size_t first);

    double width_ = 0;
    std::int32_t height_ = 0;
    std::int32_t top_ = 0;
    l3d_point_2d move_{};
    std::size_t outline_ = 0; ///< the index of the present outline's first corner
    columns reached_{};       ///< the range of the present outline's corners
    kept_list<l3d_point_2d> corners_;
    std::vector<l3d_point_2d> uncut_;
    std::vector<chain> chains_;
    std::vector<outline> outlines_;
    std::vector<outline*> active_;
    std::vector<std::uint32_t> order_;
    std::vector<std::size_t> begins_; ///< for each row, the index of its first chain in order_
};

} // namespace l3d_detail

#endif
