// SPDX-License-Identifier: MIT
// side_rows: a row a lane, for every instruction set that the processor may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/paths/side_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_doubles-inl.h"
#include "raster/parallel/simd_dispatch_p.h"
#include "raster/paths/side_rows_p.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// A window's values are in groups of columns, each a word. It has up to most_groups.
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

/// The byte of a word of four that is the i-th in memory.
constexpr int shift_of(int i) {
    return std::endian::native == std::endian::little ? 8 * i : 24 - 8 * i;
}

/// Rows of both chains: where they begin and end.
struct row_heights {
    number top, bottom;

    HWY_ATTR HWY_INLINE row_heights(const side_pair& pair, std::size_t at) {
        const number row = {hn::Iota(eight_doubles(), pair.row + static_cast<double>(at))};
        top = largest(row, same(pair.begin));
        bottom = smallest(row + same(1), same(pair.end));
    }
    HWY_ATTR HWY_INLINE number height() const { return bottom - top; }
};

HWY_ATTR HWY_INLINE number x_at(const straight_edge& edge, number y) {
    const number x = same(edge.x0) + (y - same(edge.y0)) * same(edge.slope);
    return smallest(largest(x, same(edge.least)), same(edge.most));
}

/// A chain in lanes.
struct side_lanes {
    number enters, leaves, corners, least, most;
    mask few; ///< rows that have few enough corners
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
        few = hn::Le(corners.v, hn::Set(d, block.straight ? 0 : block.few_corners));
        if (block.straight)
            return;
        most_corners = static_cast<std::size_t>(
            hn::GetLane(hn::MaxOfLanes(d, hn::IfThenElseZero(few, corners.v))));
        for (std::size_t i = 0; i < most_corners; ++i) {
            const mask some = has(i);
            const number x = loaded(&block.x[i][at]);
            least.v = hn::IfThenElse(some, hn::Min(least.v, x.v), least.v);
            most.v = hn::IfThenElse(some, hn::Max(most.v, x.v), most.v);
        }
    }

    /// Which rows have this corner.
    HWY_ATTR HWY_INLINE mask has(std::size_t i) const {
        return hn::Gt(corners.v, hn::Set(eight_doubles(), static_cast<double>(i)));
    }
    /// Of what it reaches.
    HWY_ATTR HWY_INLINE number columns() const { return most - floor_of(least); }
};

/// What a chain covers to its right in columns from `first` on.
struct window {
    alignas(64) double areas[most_groups * group][rows];
    std::int32_t words[most_groups][rows]; ///< of values
    std::int32_t first[rows];
    std::int32_t used[rows];  ///< columns that have values, some groups
    std::int32_t known[rows]; ///< columns that have areas; in all others it is the height
};

/// The sum over edges of height * G(x), where G(x) is the area right of an edge from l to r of
/// height 1, and left of x. It is 0 up to l, and (x - l)^2 / 2 (r - l) up to r. From there on it
/// grows by one a pixel. So it is b - i (1 - i / 2 (r - l)) for b = x - l or 0, and i = b or r - l.
template <std::size_t Columns> struct area_sum {
    number first;
    std::array<number, Columns> sums;

    HWY_ATTR HWY_INLINE void add(number x0, number x1, number height) {
        const number left = smallest(x0, x1), wide = largest(x0, x1) - left, zero = same(0);
        const number least = same(std::numeric_limits<double>::min());
        const number scale = height * (same(0.5) / largest(wide, least));
        number after_left = first - left;
        for (number& sum : sums) {
            after_left = after_left + same(1);
            const number beyond = largest(after_left, zero), in = smallest(beyond, wide);
            sum = sum + (height * beyond - in * (height - in * scale));
        }
    }
};

/// A pixel's area is the difference of the sums at its ends.
template <std::size_t Columns, bool is_left>
HWY_ATTR HWY_INLINE void find_window(const side_block& block, const side_lanes& lanes,
                                     const row_heights& y, double full, std::size_t at, bool joint,
                                     window& result) {
    const lane_integers di;
    area_sum<Columns> sum;
    sum.first = floor_of(lanes.least);
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
    const number height = y.height();
    const auto value = [&](number covered)
                           HWY_ATTR { return truncated(covered * same(full) + same(0.5)); };
    // Behind the columns that are known, all is right of the chain.
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

template <bool is_left>
HWY_ATTR HWY_INLINE void find_window(const side_block& block, const side_lanes& lanes,
                                     const row_heights& y, double full, std::size_t at,
                                     double columns, bool joint, window& result) {
    if (columns <= group / 2)
        find_window<group / 2, is_left>(block, lanes, y, full, at, joint, result);
    else if (columns <= group - 1)
        find_window<group - 1, is_left>(block, lanes, y, full, at, joint, result);
    else if (columns <= group)
        find_window<group, is_left>(block, lanes, y, full, at, joint, result);
    else if (columns <= 2 * group)
        find_window<2 * group, is_left>(block, lanes, y, full, at, joint, result);
    else
        find_window<most_groups * group, is_left>(block, lanes, y, full, at, joint, result);
}

/// All rows of both chains.
struct row_windows {
    window left, right;
    alignas(64) double heights[rows];
    std::int32_t middle[rows]; ///< the value between both
    std::int32_t others[rows]; ///< not 0: the row is left to others
    std::int32_t joint[rows];  ///< not 0: they share columns
    /// Columns of the picture, as covered_span has them, if they do not.
    std::int32_t first[rows], between[rows], beyond[rows], last[rows];
};

/// Where a window's values begin and end. They are whole groups.
struct window_ends {
    integers first, end;

    HWY_ATTR HWY_INLINE window_ends(const side_lanes& lanes, std::size_t at, window& result) {
        const lane_integers di;
        first = truncated(lanes.least);
        const number groups = lanes.columns() * same(1.0 / group);
        const number used = largest({hn::Ceil(groups.v)}, same(1)) * same(group);
        const integers count = truncated(used);
        end = hn::Add(first, count);
        hn::Store(first, di, &result.first[at]);
        hn::Store(count, di, &result.used[at]);
    }
};

/// Gives whether windows share columns in any row.
HWY_ATTR HWY_INLINE bool find_ends(const side_pair& pair, const side_lanes& left,
                                   const side_lanes& right, std::size_t at, row_windows& result) {
    const lane_integers di;
    const window_ends l(left, at, result.left), r(right, at, result.right);
    const auto width = hn::Set(di, pair.width), x = hn::Set(di, pair.x);
    const auto joint = hn::Gt(l.end, r.first);
    hn::Store(hn::VecFromMask(di, joint), di, result.joint + at);
    hn::Store(hn::Add(l.first, x), di, result.first + at);
    hn::Store(hn::Add(l.end, x), di, result.between + at);
    hn::Store(hn::Add(hn::Min(r.first, width), x), di, result.beyond + at);
    hn::Store(hn::Add(hn::Min(r.end, width), x), di, result.last + at);
    return !hn::AllFalse(di, joint);
}

HWY_ATTR HWY_INLINE void find_windows(const side_pair& pair, std::size_t at, row_windows& result) {
    const eight_doubles d;
    const row_heights y(pair, at);
    const side_lanes left(*pair.blocks[0], y, at), right(*pair.blocks[1], y, at);
    // Straight pieces between the same heights do not cross if their ends do not.
    const mask straight = hn::Eq((left.corners + right.corners).v, hn::Zero(d));
    const mask ends =
        hn::And(hn::Le(left.enters.v, right.enters.v), hn::Le(left.leaves.v, right.leaves.v));
    const mask apart = hn::Or(hn::Le(left.most.v, right.least.v), hn::And(straight, ends));
    const mask narrow =
        hn::Le(largest(left.columns(), right.columns()).v, hn::Set(d, most_groups * group));
    const mask wanted =
        hn::Lt(hn::Iota(d, static_cast<double>(at)), hn::Set(d, static_cast<double>(pair.count)));
    const mask done =
        hn::And(hn::And(apart, narrow), hn::And(hn::And(left.few, right.few), wanted));
    const number other = {hn::IfThenZeroElse(done, hn::Set(d, 1))};
    hn::Store(truncated(other), lane_integers(), result.others + at);
    store(y.height(), result.heights + at);
    hn::Store(truncated(y.height() * same(pair.full) + same(0.5)), lane_integers(),
              result.middle + at);
    const auto most = [&](number columns) HWY_ATTR {
        return hn::GetLane(hn::MaxOfLanes(d, hn::IfThenElseZero(done, columns.v)));
    };
    const bool joint = find_ends(pair, left, right, at, result);
    find_window<true>(*pair.blocks[0], left, y, pair.full, at, most(left.columns()), joint,
                      result.left);
    find_window<false>(*pair.blocks[1], right, y, pair.full, at, most(right.columns()), joint,
                       result.right);
}

/// Copies a row's values.
HWY_INLINE void put_words(const window& from, std::size_t row, std::uint8_t* values) {
    std::memcpy(values, &from.words[0][row], group);
    for (std::size_t used = group; used < static_cast<std::size_t>(from.used[row]); used += group)
        std::memcpy(values + used, &from.words[used / group][row], group);
}

/// Windows that share columns. Gives how many columns they are together.
HWY_INLINE std::int32_t put_joint(const row_windows& windows, std::size_t row, double full,
                                  std::uint8_t* values) {
    const window &left = windows.left, &right = windows.right;
    const std::int32_t later = right.first[row] - left.first[row];
    const std::int32_t count = std::max(left.known[row], later + right.known[row]);
    const auto area = [&](const window& of, std::int32_t column) {
        return column < 0               ? 0
               : column < of.known[row] ? of.areas[column][row]
                                        : windows.heights[row];
    };
    for (std::int32_t c = 0; c < count; ++c)
        values[c] = static_cast<std::uint8_t>(
            static_cast<std::int32_t>((area(left, c) - area(right, c - later)) * full + 0.5));
    return count;
}

/// Rows become spans.
std::uint32_t put_rows(const side_pair& pair, const row_windows& windows, pair_spans& to) {
    // A span costs what some columns of values do.
    constexpr std::int32_t few = 32;
    const side_pair p = pair; // values may be anywhere, for all the compiler knows
    covered_span* span = to.spans + to.span_count;
    std::uint8_t* values = to.values + to.value_count;
    std::size_t place = to.values_before + to.value_count;
    std::uint32_t others = 0;
    for (std::size_t i = 0; i < p.count; ++i) {
        if (windows.others[i] != 0) {
            others |= 1U << i;
            continue;
        }
        const std::int32_t row = p.row + static_cast<std::int32_t>(i) + p.y;
        const std::int32_t first = windows.first[i], second = p.x + windows.right.first[i];
        const std::int32_t end = second + windows.right.used[i];
        if (windows.joint[i] == 0 && end - first > few) {
            put_words(windows.left, i, values);
            const std::int32_t before = windows.left.used[i];
            put_words(windows.right, i, values + before);
            *span++ = {row,
                       first,
                       windows.between[i],
                       windows.beyond[i],
                       windows.last[i],
                       windows.middle[i],
                       place};
            const std::int32_t count = before + windows.right.used[i];
            values += count;
            place += static_cast<std::size_t>(count);
            continue;
        }
        std::int32_t count = end - first;
        if (windows.joint[i] == 0) {
            std::memset(values, windows.middle[i], few);
            put_words(windows.left, i, values);
            put_words(windows.right, i, values + (second - first));
        } else {
            count = put_joint(windows, i, p.full, values);
        }
        const std::int32_t last = std::min(first + count, p.x + p.width);
        if (first < last) {
            *span++ = {row, first, last, last, last, 0, place};
            values += count;
            place += static_cast<std::size_t>(count);
        }
    }
    to.span_count = static_cast<std::size_t>(span - to.spans);
    to.value_count = place - to.values_before;
    return others;
}

std::uint32_t cover_rows_in_lanes(const side_pair& pair, pair_spans& result) {
    static_assert(hn::MaxLanes(eight_doubles()) <= rows);
    row_windows windows;
    for (std::size_t at = 0; at < pair.count; at += lanes_at_once())
        find_windows(pair, at, windows);
    return put_rows(pair, windows, result);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(cover_rows_in_lanes);

std::uint32_t cover_rows(const side_pair& pair, pair_spans& result) {
    return L3D_SIMD_CALL(cover_rows_in_lanes)(pair, result);
}

} // namespace l3d_detail
#endif
