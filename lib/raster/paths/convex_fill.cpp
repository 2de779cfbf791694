// SPDX-License-Identifier: MIT
// convex_fill: makes spans between two chains, a row in each lane, for every instruction set that
// the processor may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/paths/convex_fill.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_doubles-inl.h"
#include "raster/parallel/lane_places-inl.h"
#include "raster/parallel/simd_dispatch_p.h"
#include "raster/paths/convex_fill_p.h"
#include "raster/paths/side_windows-inl.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// The values of the pixels near two chains: a window for each chain and row.
struct row_windows {
    window left, right;
    alignas(64) double heights[rows];
    std::int32_t others[rows]; ///< for each row, not 0: the caller fills this row
    std::int32_t joint[rows];  ///< for each row, not 0: the chains' windows share columns
    /// The fields of each row's covered_span, if the chains share no columns.
    alignas(64) std::int32_t begins[rows][4]; ///< covered_span's row, first, between and beyond
    std::int32_t ends[rows][2];               ///< covered_span's last and value
    /// Whether each row has one group of values on either side, and a middle that is long enough
    /// for a span. If so, `groups` holds these values of the windows.
    bool alike = true;
    std::int32_t groups[rows][2];
};

/// The columns of a window's first value, and after its last. The values form whole groups.
struct window_ends {
    integers first, end;

    HWY_ATTR HWY_INLINE window_ends(const side_lanes& lanes, std::size_t at, window& result) {
        const lane_integers di;
        first = truncated(lanes.least);
        const integers columns = truncated({hn::Ceil(lanes.columns().v)});
        const auto one = hn::Set(di, group), rest = hn::Set(di, group - 1);
        const integers count = hn::Max(hn::AndNot(rest, hn::Add(columns, rest)), one);
        end = hn::Add(first, count);
        hn::Store(first, di, &result.first[at]);
        hn::Store(count, di, &result.used[at]);
    }
};

/// A span costs as much as this number of columns that have a value each.
constexpr std::int32_t few_columns = 32;

/// Finds the ends of the windows. Returns whether the two windows of any row share columns.
HWY_ATTR HWY_INLINE bool find_ends(const side_pair& pair, const row_heights& y,
                                   const side_lanes& left, const side_lanes& right,
                                   std::size_t lane, std::size_t at, row_windows& result) {
    const lane_integers di;
    const window_ends l(left, at, result.left), r(right, at, result.right);
    const auto width = hn::Set(di, pair.width), x = hn::Set(di, pair.x);
    const auto joint = hn::Gt(l.end, r.first);
    hn::Store(hn::VecFromMask(di, joint), di, result.joint + at);
    const integers row = places_from(di, pair.row + pair.y + static_cast<std::int32_t>(lane));
    hn::StoreInterleaved4(row, hn::Add(l.first, x), hn::Add(l.end, x),
                          hn::Add(hn::Min(r.first, width), x), di, result.begins[at]);
    hn::StoreInterleaved2(hn::Add(hn::Min(r.end, width), x),
                          truncated(y.height() * same(pair.full) + same(0.5)), di, result.ends[at]);
    result.alike &= hn::AllTrue(di, hn::Gt(hn::Sub(r.end, l.first), hn::Set(di, few_columns)));
    return !hn::AllFalse(di, joint);
}

/// Finds the windows of the rows in lanes from begin + at on. `begin` is above 0 only for straight
/// chains.
HWY_ATTR HWY_INLINE void find_windows(const side_pair& pair, std::size_t begin, std::size_t at,
                                      row_windows& result) {
    const eight_doubles d;
    const row_heights y(pair, begin + at);
    const side_lanes left(*pair.blocks[0], y, at), right(*pair.blocks[1], y, at);
    // Straight pieces between the same heights do not cross if their ends do not.
    const mask ends =
        hn::And(hn::Le(left.enters.v, right.enters.v), hn::Le(left.leaves.v, right.leaves.v));
    const mask narrow =
        hn::Le(largest(left.columns(), right.columns()).v, hn::Set(d, most_groups * group));
    const mask wanted = hn::Lt(hn::Iota(d, static_cast<double>(begin + at)),
                               hn::Set(d, static_cast<double>(pair.count)));
    mask done = hn::And(hn::And(ends, narrow), wanted);
    const side_block &left_block = *pair.blocks[0], &right_block = *pair.blocks[1];
    if (!left_block.straight || !right_block.straight) {
        const mask straight = hn::Eq((left.corners + right.corners).v, hn::Zero(d));
        const mask apart = hn::Or(hn::Le(left.most.v, right.least.v), straight);
        done = hn::And(done, apart);
        if (!left_block.straight)
            done = hn::And(done, left.few);
        if (!right_block.straight)
            done = hn::And(done, right.few);
    }
    const number other = {hn::IfThenZeroElse(done, hn::Set(d, 1))};
    hn::Store(truncated(other), lane_integers(), result.others + at);
    store(y.height(), result.heights + at);
    const auto columns = [&](const side_lanes& lanes) HWY_ATTR {
        return number{hn::IfThenElseZero(done, lanes.columns().v)};
    };
    const bool joint = find_ends(pair, y, left, right, begin + at, at, result);
    const bool left_group =
        find_window<true>(left_block, left, y, pair.full, at, columns(left), joint, result.left);
    const bool right_group = find_window<false>(right_block, right, y, pair.full, at,
                                                columns(right), joint, result.right);
    result.alike &= left_group && right_group && !joint && hn::AllTrue(d, done);
    const lane_integers di;
    hn::StoreInterleaved2(hn::Load(di, &result.left.words[0][at]),
                          hn::Load(di, &result.right.words[0][at]), di, result.groups[at]);
}

/// Copies the values of a window's row to `values`.
HWY_INLINE void put_words(const window& from, std::size_t row, std::uint8_t* values) {
    std::memcpy(values, &from.words[0][row], group);
    for (std::size_t used = group; used < static_cast<std::size_t>(from.used[row]); used += group)
        std::memcpy(values + used, &from.words[used / group][row], group);
}

/// Stores the values of two windows of a row that share columns. Returns the number of columns that
/// both windows cover together.
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

/// Makes the span of a row whose windows share no columns.
HWY_INLINE covered_span span_of(const row_windows& windows, std::size_t row, std::size_t place) {
    const auto& [y, first, between, beyond] = windows.begins[row];
    const auto& [last, value] = windows.ends[row];
    return {y, first, between, beyond, last, value, place};
}

/// Makes the spans of all rows, if row_windows::alike.
HWY_INLINE void put_alike(const row_windows& windows, pair_spans& to) {
    std::memcpy(to.values + to.value_count, windows.groups, sizeof(windows.groups));
    covered_span* const span = to.spans + to.span_count;
    const std::size_t place = to.values_before + to.value_count;
    for (std::size_t i = 0; i < rows; ++i)
        span[i] = span_of(windows, i, place + 2 * group * i);
    to.span_count += rows;
    to.value_count += sizeof(windows.groups);
}

/// Makes the spans of the rows from a lane on. Returns the rows that the caller fills, as bits.
std::uint32_t put_rows(const side_pair& pair, std::size_t begin, const row_windows& windows,
                       pair_spans& to) {
    const side_pair p = pair; // a copy: for the compiler, `values` may overlap `pair`
    covered_span* span = to.spans + to.span_count;
    std::uint8_t* values = to.values + to.value_count;
    std::size_t place = to.values_before + to.value_count;
    std::uint32_t others = 0;
    const std::size_t count_here = std::min(p.count - begin, rows);
    for (std::size_t i = 0; i < count_here; ++i) {
        if (windows.others[i] != 0) {
            others |= 1U << (begin + i);
            continue;
        }
        const std::int32_t row = windows.begins[i][0], first = windows.begins[i][1];
        const std::int32_t second = p.x + windows.right.first[i];
        const std::int32_t end = second + windows.right.used[i];
        if (windows.joint[i] == 0 && end - first > few_columns) {
            put_words(windows.left, i, values);
            const std::int32_t before = windows.left.used[i];
            put_words(windows.right, i, values + before);
            *span++ = span_of(windows, i, place);
            const std::int32_t count = before + windows.right.used[i];
            values += count;
            place += static_cast<std::size_t>(count);
            continue;
        }
        std::int32_t count = end - first;
        if (windows.joint[i] == 0) {
            std::memset(values, windows.ends[i][1], few_columns);
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
    std::uint32_t others = 0;
    for (std::size_t begin = 0; begin < pair.count; begin += rows) {
        const std::size_t end = std::min(pair.count - begin, rows);
        windows.alike = end == rows;
        for (std::size_t at = 0; at < end; at += lanes_at_once())
            find_windows(pair, begin, at, windows);
        if (windows.alike)
            put_alike(windows, result);
        else
            others |= put_rows(pair, begin, windows, result);
    }
    return others;
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
