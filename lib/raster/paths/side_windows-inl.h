// SPDX-License-Identifier: MIT
// side_windows: finds the areas right of a chain in rows of pixels, one row in each lane.
#if defined(L3D_RASTER_PATHS_SIDE_WINDOWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_PATHS_SIDE_WINDOWS_INL_H
#undef L3D_RASTER_PATHS_SIDE_WINDOWS_INL_H
#else
#define L3D_RASTER_PATHS_SIDE_WINDOWS_INL_H
#endif

#include "raster/parallel/lane_doubles-inl.h"
#include "raster/paths/convex_fill_p.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// The values of a window's columns are stored in groups of four, a byte each, in one word. A
/// window has up to most_groups groups.
constexpr std::size_t group = sizeof(std::uint32_t), most_groups = 4;
constexpr std::size_t rows = side_block::rows;

using lane_integers = hn::Rebind<std::int32_t, eight_doubles>;
using integers = hn::Vec<lane_integers>;
using mask = hn::Mask<eight_doubles>;

HWY_ATTR HWY_INLINE number smallest(number a, number b) {
    return {hn::Min(a.v, b.v)};
}
HWY_ATTR HWY_INLINE number floor_of(number a) {
    return {hn::Floor(a.v)};
}
HWY_ATTR HWY_INLINE integers truncated(number x) {
    return hn::DemoteTo(lane_integers(), x.v);
}

/// The shift that takes a byte to place i of a word, where places count in the order of memory.
constexpr int shift_of(int i) {
    return std::endian::native == std::endian::little ? 8 * i : 24 - 8 * i;
}

/// The heights between which both chains run, in each row.
struct row_heights {
    number top, bottom;

    HWY_ATTR HWY_INLINE row_heights(const side_pair& pair, std::size_t lane) {
        const number row = {hn::Iota(eight_doubles(), pair.row + static_cast<double>(lane))};
        top = largest(row, same(pair.begin));
        bottom = smallest(row + same(1), same(pair.end));
    }
    HWY_ATTR HWY_INLINE number height() const { return bottom - top; }
};

HWY_ATTR HWY_INLINE number x_at(const straight_edge& edge, number y) {
    const number x = same(edge.x0) + (y - same(edge.y0)) * same(edge.slope);
    return smallest(largest(x, same(edge.least)), same(edge.most));
}

/// A chain in a block of rows. Each lane is a row.
struct side_lanes {
    number enters, leaves, corners, least, most;
    mask few; ///< rows with at most few_corners corners; unset if the chain is straight
    std::size_t most_corners = 0;

    HWY_ATTR HWY_INLINE side_lanes(const side_block& block, const row_heights& y, std::size_t at) {
        const eight_doubles d;
        if (block.straight) {
            enters = x_at(block.edge, y.top);
            leaves = x_at(block.edge, y.bottom);
            corners = same(0);
        } else {
            enters = loaded(&block.enters[at]);
            leaves = loaded(&block.leaves[at]);
            corners = loaded(&block.corners[at]);
        }
        least = smallest(enters, leaves);
        most = largest(enters, leaves);
        if (block.straight)
            return;
        few = hn::Le(corners.v, hn::Set(d, block.few_corners));
        most_corners = static_cast<std::size_t>(
            hn::GetLane(hn::MaxOfLanes(d, hn::IfThenElseZero(few, corners.v))));
        for (std::size_t i = 0; i < most_corners; ++i) {
            const mask some = has(i);
            const number x = loaded(&block.x[i][at]);
            least.v = hn::IfThenElse(some, hn::Min(least.v, x.v), least.v);
            most.v = hn::IfThenElse(some, hn::Max(most.v, x.v), most.v);
        }
    }

    /// The rows in which the chain has at least i + 1 corners.
    HWY_ATTR HWY_INLINE mask has(std::size_t i) const {
        return hn::Gt(corners.v, hn::Set(eight_doubles(), static_cast<double>(i)));
    }
    /// An upper bound of the number of columns that the chain reaches in each row.
    HWY_ATTR HWY_INLINE number columns() const { return most - floor_of(least); }
};

/// The columns near a chain, in each row of a block. `areas` holds how much of each pixel lies
/// right of the chain. Column 0 is the picture's column first[row].
struct window {
    alignas(64) double areas[most_groups * group][rows];
    std::int32_t words[most_groups][rows]; ///< values of the pixels' coverage, four in a word
    std::int32_t first[rows];
    std::int32_t used[rows]; ///< number of columns that have values, a multiple of `group`
    /// Number of columns that have areas; in columns after them, the area is the whole height.
    std::int32_t known[rows];
};

/// The sums that give a chain's areas: for each column, the area right of the chain and left of the
/// column's end x.
///
/// An edge of height 1 from l to r adds G(x). G is 0 up to l, (x - l)^2 / (2 (r - l)) up to r, and
/// then grows by 1 for each pixel. So G(x) is b - i (1 - i / (2 (r - l))). Here b is the larger one
/// of x - l and 0, and i the smaller one of b and r - l. Edges of other heights add height * G(x).
template <std::size_t Columns> struct area_sum {
    number first;
    std::array<number, Columns> sums;

    /// Sets the sums to those of a single edge. The edge begins in the first column, so x - l is
    /// never negative.
    HWY_ATTR HWY_INLINE void set(number x0, number x1, number height) {
        const edge e(x0, x1, height);
        number beyond = first - e.left;
        for (number& sum : sums) {
            beyond = beyond + same(1);
            sum = e.area(beyond);
        }
    }
    /// Adds an edge of a chain that has several.
    HWY_ATTR HWY_INLINE void add(number x0, number x1, number height) {
        const edge e(x0, x1, height);
        number after_left = first - e.left;
        for (number& sum : sums) {
            after_left = after_left + same(1);
            sum = sum + e.area(largest(after_left, same(0)));
        }
    }

private:
    struct edge {
        number left, wide, height, scale;

        HWY_ATTR HWY_INLINE edge(number x0, number x1, number h)
            : left(smallest(x0, x1)), wide(largest(x0, x1) - left), height(h) {
            const number least = same(std::numeric_limits<double>::min());
            scale = height * (same(0.5) / largest(wide, least));
        }
        HWY_ATTR HWY_INLINE number area(number beyond) const {
            const number in = smallest(beyond, wide);
            return height * beyond - in * (height - in * scale);
        }
    };
};

/// Finds the window of a chain with this number of columns, for the rows in lanes from row `at` of
/// the block on. It finds the values of the coverage. If `joint`, it also stores the areas, which
/// are differences of area_sum from column to column.
template <std::size_t Columns, bool is_left>
HWY_ATTR HWY_INLINE void find_window(const side_block& block, const side_lanes& lanes,
                                     const row_heights& y, double full, std::size_t at, bool joint,
                                     window& result) {
    const lane_integers di;
    area_sum<Columns> sum;
    sum.first = floor_of(lanes.least);
    const number height = y.height();
    if (lanes.most_corners == 0) {
        sum.set(lanes.enters, lanes.leaves, height);
    } else {
        sum.sums.fill(same(0));
        number x = lanes.enters, from = y.top;
        for (std::size_t i = 0; i < lanes.most_corners; ++i) {
            const mask some = lanes.has(i);
            const number next = {hn::IfThenElse(some, loaded(&block.x[i][at]).v, lanes.leaves.v)};
            const number to = {hn::IfThenElse(some, loaded(&block.y[i][at]).v, y.bottom.v)};
            sum.add(x, next, to - from);
            x = next;
            from = to;
        }
        sum.add(x, lanes.leaves, y.bottom - from);
    }
    const auto value = [&](number covered)
                           HWY_ATTR { return truncated(covered * same(full) + same(0.5)); };
    // Columns after the known ones lie wholly right of the chain.
    const integers rest = value(is_left ? height : same(0));
    number before = same(0);
    integers word = hn::Zero(di);
    constexpr std::size_t all = (Columns + group - 1) / group * group;
    for (std::size_t c = 0; c < all; ++c) {
        integers one = rest;
        if (c < Columns) {
            const number area = sum.sums[c] - before;
            before = sum.sums[c];
            if (joint)
                store(area, &result.areas[c][at]);
            one = value(is_left ? area : height - area);
        }
        word = hn::Or(word, hn::ShiftLeftSame(one, shift_of(static_cast<int>(c % group))));
        if (c % group == group - 1) {
            hn::Store(word, di, &result.words[c / group][at]);
            word = hn::Zero(di);
        }
    }
    hn::Store(hn::Set(di, static_cast<std::int32_t>(Columns)), di, &result.known[at]);
}

/// Finds the windows of a chain, with as few groups of columns as suffice. Returns whether one
/// group suffices for all rows.
template <bool is_left>
HWY_ATTR HWY_INLINE bool find_window(const side_block& block, const side_lanes& lanes,
                                     const row_heights& y, double full, std::size_t at,
                                     number columns, bool joint, window& result) {
    const auto are_within = [&](std::size_t most) HWY_ATTR {
        const eight_doubles d;
        return hn::AllTrue(d, hn::Le(columns.v, hn::Set(d, static_cast<double>(most))));
    };
    const bool one_group = are_within(group);
    if (!one_group) {
        if (are_within(2 * group))
            find_window<2 * group, is_left>(block, lanes, y, full, at, joint, result);
        else
            find_window<most_groups * group, is_left>(block, lanes, y, full, at, joint, result);
    } else if (are_within(group / 2)) {
        find_window<group / 2, is_left>(block, lanes, y, full, at, joint, result);
    } else if (are_within(group - 1)) {
        find_window<group - 1, is_left>(block, lanes, y, full, at, joint, result);
    } else {
        find_window<group, is_left>(block, lanes, y, full, at, joint, result);
    }
    return one_group;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
