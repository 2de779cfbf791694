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

/// Corners of an outline, from top to bottom.
struct corner_run {
    const l3d_point_2d* first = nullptr;
    std::ptrdiff_t step = 1; ///< to the next one: 1, or -1 where the outline leads up
    std::size_t count = 0;

    bool empty() const { return count == 0; }
    const l3d_point_2d& operator[](std::size_t i) const {
        return first[static_cast<std::ptrdiff_t>(i) * step];
    }
};

/// The part of a chain in one row of pixels: from where it enters, by its corners, to where it
/// leaves.
/// Units:   pixels of the box, row r from y = r to r + 1.
struct row_piece {
    double left, right; ///< the piece lies between
    l3d_point_2d enters, leaves;
    corner_run corners;    ///< corners between its ends
    std::int8_t direction; ///< 1 if it leads upwards, and adds 1 to the winding right of it
    std::uint8_t layer;    ///< 0: of what is filled; 1: of what clips it

    double height() const { return leaves.y - enters.y; }

    /// Calls edge(from, to) for each of its edges from top to bottom; some are level.
    template <class Edge> void visit(const Edge& edge) const {
        l3d_point_2d from = enters;
        for (std::size_t i = 0; i < corners.count; ++i) {
            edge(from, corners[i]);
            from = corners[i];
        }
        edge(from, leaves);
    }
};

/// The x of an edge at a height within it, never beyond its ends.
struct straight_edge {
    double x0 = 0, y0 = 0, slope = 0, least = 0, most = 0;

    straight_edge() = default;
    /// Expects: from.y < to.y.
    straight_edge(l3d_point_2d from, l3d_point_2d to)
        : x0(from.x), y0(from.y), slope((to.x - from.x) / (to.y - from.y)),
          least(std::min(from.x, to.x)), most(std::max(from.x, to.x)) {}

    double x_at(double y) const { return std::clamp(x0 + (y - y0) * slope, least, most); }
};

/// A run of edges of an outline that never turns back up. It is walked row by row.
class chain {
public:
    /// The corners are from `first` to `last` among all, from top to bottom.
    /// Expects: rows of the picture from 0 to height - 1; it reaches one of them.
    chain(const l3d_point_2d* all, std::size_t first, std::size_t last, std::int32_t height,
          std::uint8_t layer);

    /// The first row that the chain reaches, and the row behind the last.
    std::int32_t top() const { return top_; }
    std::int32_t bottom() const { return bottom_; }

    /// Goes to the next row.
    /// Expects: the same corners as before; rows from top() to bottom() - 1, in order.
    void enter(std::int32_t row, const l3d_point_2d* all);

    const row_piece& piece() const { return piece_; }

    /// Goes to a row with this piece, for callers that walk the chain by themselves.
    void take_piece(const row_piece& piece) { piece_ = piece; }
    /// The next corner that the chain leads to, the place behind the last one, and the step between
    /// corners.
    const l3d_point_2d* next_corner(const l3d_point_2d* all) const { return all + next_; }
    const l3d_point_2d* behind(const l3d_point_2d* all) const { return all + last_ + step_; }
    std::ptrdiff_t step() const { return step_; }
    /// Makes the chain reach no row any more.
    void leave_out() { bottom_ = top_; }

private:
    void enter_at_corners(std::int32_t row, const l3d_point_2d* all);

    std::ptrdiff_t next_; ///< the corner that it leads to
    std::ptrdiff_t last_, step_;
    std::int32_t top_ = 0, bottom_ = 0;
    /// The edge by which the chain leaves the row, if that goes on to `end_`.
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

/// Takes outlines, and cuts them at the sides of a picture and where they turn up or down.
///
/// Corners outside of the sides move to them: so the windings inside stay as they are, and outlines
/// closed. Level edges belong to the chain before them.
/// Cost:    linear in the corners; allocates when there are more than ever before.
class path_chains {
public:
    /// Removes all chains. All later corners are moved by `move`.
    void clear(std::int32_t width, std::int32_t height, l3d_point_2d move = {});

    /// Begins an outline, goes on with it, and closes it.
    void begin(l3d_point_2d corner);
    void lines(std::span<const l3d_point_2d> corners);
    void end(std::uint8_t layer);

    /// The chains, and the corners that they are made of.
    std::span<chain> chains() { return chains_; }
    const l3d_point_2d* corners() const { return corners_.data(); }

    /// An outline that is seen.
    struct outline {
        l3d_pixel_box box;         ///< box of all pixels that it reaches
        std::size_t first, chains; ///< its chains, and how many
        bool apart;                ///< by find_apart: its box meets no other's
    };
    std::span<const outline> outlines() const { return outlines_; }
    /// Finds outlines that are apart from all others, if one of two chains may be among them.
    void find_apart();

    /// Sorts the chains by their top rows. Gives the row behind the last.
    std::int32_t sort();
    /// The first row of all. Expects: sorted.
    std::int32_t top() const { return top_; }
    /// The chains that begin in a row. Expects: sorted; top() or a later row.
    std::span<const std::uint32_t> begun_in(std::int32_t row) const;

private:
    /// The columns that an outline reaches.
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
    std::size_t outline_ = 0; ///< the place of its first corner
    columns reached_{};       ///< by its corners
    kept_list<l3d_point_2d> corners_;
    std::vector<l3d_point_2d> uncut_;
    std::vector<chain> chains_;
    std::vector<outline> outlines_;
    std::vector<outline*> active_;
    std::vector<std::uint32_t> order_;
    std::vector<std::size_t> begins_; ///< each row's first place in order_
};

} // namespace l3d_detail

#endif
