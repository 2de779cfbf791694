// SPDX-License-Identifier: MIT
// pixel_edges: places edges and counts fields in lanes, for every instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/paths/pixel_edges.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_doubles-inl.h"
#include "raster/parallel/simd_dispatch_p.h"
#include "raster/paths/pixel_edges_p.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// The numbers of rows and columns of fields in a pixel, and a margin far above rounding. An edge
/// within the margin of a field counts as in the field.
constexpr int rows = 8, columns = 8;
constexpr double margin = 1e-9;
constexpr std::uint64_t all_in_row = (1U << columns) - 1;

using mask = hn::Mask<eight_doubles>;
using lane_words = hn::Rebind<std::uint64_t, eight_doubles>;
using words = hn::Vec<lane_words>;

HWY_ATTR HWY_INLINE number smallest(number a, number b) {
    return {hn::Min(a.v, b.v)};
}
HWY_ATTR HWY_INLINE number only(mask where, number x) {
    return {hn::IfThenElseZero(where, x.v)};
}
HWY_ATTR HWY_INLINE number either(mask where, number yes, number no) {
    return {hn::IfThenElse(where, yes.v, no.v)};
}
HWY_ATTR HWY_INLINE mask is_less(number a, number b) {
    return hn::Lt(a.v, b.v);
}
HWY_ATTR HWY_INLINE hn::Mask<lane_words> words_of(mask m) {
    return hn::RebindMask(lane_words(), m);
}
/// The whole part of a number that is not negative.
HWY_ATTR HWY_INLINE words word_of(number x) {
    const auto demoted = hn::DemoteTo(hn::Rebind<std::int32_t, eight_doubles>(), x.v);
    return hn::BitCast(lane_words(),
                       hn::PromoteTo(hn::Rebind<std::int64_t, eight_doubles>(), demoted));
}
HWY_ATTR HWY_INLINE double sum(number x) {
    return hn::GetLane(hn::SumOfLanes(eight_doubles(), x.v));
}

/// Calls take(block, lane, valid) for each vector of edges.
template <class Take>
HWY_ATTR HWY_INLINE void visit_lanes(const pixel_edges& edges, const Take& take) {
    for (std::size_t i = 0; i < edges.count; i += lanes_at_once())
        take(edges.blocks[i / edge_block::size], i % edge_block::size,
             hn::FirstN(eight_doubles(), edges.count - i));
}

edge_sums place_in_lanes(const pixel_edges& edges, const l3d_point_2d& corner) {
    const eight_doubles d;
    const number left = same(corner.x), above = same(corner.y), zero = same(0), one = same(1);
    number own = zero, before = zero;
    visit_lanes(edges, [&](edge_block& b, std::size_t at, mask valid) HWY_ATTR {
        const number from_x = loaded(&b.x0[at]) - left, to_x = loaded(&b.x1[at]) - left;
        const number from_y = smallest(one, largest(zero, loaded(&b.y0[at]) - above));
        const number to_y = smallest(one, largest(zero, loaded(&b.y1[at]) - above));
        const words marks = hn::PromoteTo(
            lane_words(), hn::Load(hn::Rebind<std::uint32_t, eight_doubles>(), &b.edge[at]));
        const auto has = [&](std::uint64_t bits, std::uint64_t value) HWY_ATTR {
            const auto some = hn::And(marks, hn::Set(lane_words(), bits));
            return hn::RebindMask(d, hn::Eq(some, hn::Set(lane_words(), value)));
        };
        const mask enters = has(edge_record::begins, std::uint64_t(cell_begin::enters_left));
        const mask leaves = has(edge_record::leaves_left, edge_record::leaves_left);
        // An edge that leads upwards adds 1 on its right.
        const number adds = (from_y - to_y) * (one - (from_x + to_x) * same(0.5)) +
                            only(enters, one - from_y) - only(leaves, one - to_y);
        const mask rises = is_less(to_y, from_y), falls = is_less(from_y, to_y);
        const mask adds_1 = hn::Or(rises, hn::AndNot(falls, enters));
        const mask takes_1 = hn::Or(falls, hn::AndNot(rises, leaves));
        const number turns = only(adds_1, one) - only(takes_1, one);
        const number x0 = either(adds_1, to_x, from_x), x1 = either(adds_1, from_x, to_x);
        const number y0 = either(adds_1, to_y, from_y), y1 = either(adds_1, from_y, to_y);
        const number slope = only(is_less(y0, y1), (x1 - x0) / (y1 - y0));
        const mask up = hn::Or(hn::And(enters, falls), hn::And(leaves, rises));
        const number up_left = only(up, turns);
        const number down_left = only(hn::AndNot(up, hn::Or(enters, leaves)), turns);
        store(x0, &b.x0[at]);
        store(y0, &b.y0[at]);
        store(x1, &b.x1[at]);
        store(y1, &b.y1[at]);
        store(slope, &b.slope[at]);
        store(turns, &b.turns[at]);
        store(up_left, &b.up_left[at]);
        store(down_left, &b.down_left[at]);
        store(adds, &b.adds[at]);
        store(y0, &b.top[at]);
        store(y1, &b.bottom[at]);
        own = own + only(valid, adds);
        before = before - only(valid, up_left);
    });
    return {sum(own), sum(before)};
}

/// Finds a lower bound of the winding number in each field, by counting the edges on the field's
/// left. An edge that lowers the number on its right counts from the first field that it may reach.
/// An edge that raises it counts only in fields right of the last field that it may reach.
///
/// The bounds of all fields are counted at once: word i has bit i of each field's counter.
std::uint64_t find_open_in_lanes(const pixel_edges& edges, int beside, int sign) {
    const lane_words du;
    const std::size_t most = edges.count + static_cast<std::size_t>(std::abs(beside));
    const auto high = static_cast<std::size_t>(std::bit_width(most));
    const number zero = same(0), one = same(1), fields = same(columns);
    const words all = hn::Set(du, ~std::uint64_t{0});
    const words first_column = hn::Set(du, ~std::uint64_t{0} / all_in_row);
    std::array<std::array<std::uint64_t, edge_block::size>, 64> bits;
    for (std::size_t i = 0; i <= high; ++i)
        hn::StoreU(hn::Zero(du), du, bits[i].data());
    visit_lanes(edges, [&](const edge_block& b, std::size_t at, mask valid) HWY_ATTR {
        const number x0 = loaded(&b.x0[at]), x1 = loaded(&b.x1[at]);
        const mask falls = is_less(loaded(&b.turns[at]) * same(sign), zero);
        const mask up = hn::Ne(loaded(&b.up_left[at]).v, zero.v);
        const mask down = hn::Ne(loaded(&b.down_left[at]).v, zero.v);
        const auto whole = [&](mask to_less, number y) HWY_ATTR {
            const number scaled = y * fields;
            return word_of(either(to_less, {hn::Floor(scaled.v)}, {hn::Ceil(scaled.v)}));
        };
        const auto rows_from = [&](words row) HWY_ATTR {
            const words half = hn::ShiftLeft<2>(row); // two shifts, as none may be by 64 bits
            return hn::Shl(hn::Shl(all, half), half);
        };
        const words from = rows_from(whole(hn::Xor(falls, up), loaded(&b.y0[at])));
        const words below = rows_from(whole(hn::Not(hn::Xor(falls, down)), loaded(&b.y1[at])));
        const number column = either(falls, largest(smallest(x0, x1) - same(margin), zero),
                                     smallest(largest(x0, x1) + same(margin), one));
        // Each byte has the bits of the columns before this one.
        const words before = hn::Sub(hn::Shl(first_column, whole(falls, column)), first_column);
        words where = hn::AndNot(hn::Or(before, below), from);
        where = hn::Or(where, hn::IfThenElseZero(words_of(up), hn::Not(from)));
        where = hn::Or(where, hn::IfThenElseZero(words_of(down), below));
        where = hn::IfThenElseZero(words_of(valid), where);
        const words borrow = hn::IfThenElseZero(words_of(falls), all);
        for (std::size_t i = 0; i <= high; ++i) {
            const words counter = hn::LoadU(du, bits[i].data());
            hn::StoreU(hn::Xor(counter, where), du, bits[i].data());
            where = hn::And(where, hn::Xor(counter, borrow));
        }
    });
    // The sum of all lanes' counters. Its highest bit is set if a bound is above 0.
    const std::uint64_t begin =
        (std::uint64_t{1} << high) - 1 + static_cast<std::uint64_t>(sign * beside);
    std::array<std::uint64_t, 64> total;
    for (std::size_t i = 0; i <= high; ++i)
        total[i] = (begin >> i & 1) != 0 ? ~std::uint64_t{0} : 0;
    for (std::size_t lane = 0; lane < lanes_at_once(); ++lane) {
        std::uint64_t carry = 0;
        for (std::size_t i = 0; i <= high; ++i) {
            const std::uint64_t one_more = bits[i][lane], both = total[i] ^ one_more;
            const std::uint64_t next = (total[i] & one_more) | (both & carry);
            total[i] = both ^ carry;
            carry = next;
        }
    }
    return ~total[high];
}

void set_heights_in_lanes(const pixel_edges& edges, std::uint64_t open) {
    const lane_words du;
    const number zero = same(0), last = same(columns - 1), fields = same(columns);
    visit_lanes(edges, [&](edge_block& b, std::size_t at, mask) HWY_ATTR {
        const number x0 = loaded(&b.x0[at]), slope = loaded(&b.slope[at]);
        const number y0 = loaded(&b.y0[at]), y1 = loaded(&b.y1[at]);
        // The field of a place, as a bit of a row.
        const auto field = [&](number x) HWY_ATTR {
            return hn::Shl(hn::Set(du, 1), word_of(smallest(largest(x * fields, zero), last)));
        };
        number top = same(1), bottom = zero;
        for (int row = 0; row < rows; ++row) {
            const std::uint64_t open_columns = open >> (row * columns) & all_in_row;
            if (open_columns == 0)
                continue;
            const number from = largest(y0, same(static_cast<double>(row) / rows));
            const number to = smallest(y1, same(static_cast<double>(row + 1) / rows));
            const number at_top = x0 + (from - y0) * slope, at_bottom = x0 + (to - y0) * slope;
            const words left = field(smallest(at_top, at_bottom) - same(margin));
            const words right = field(largest(at_top, at_bottom) + same(margin));
            const words passed = hn::Sub(hn::Add(right, right), left);
            const auto meets = hn::Ne(hn::And(passed, hn::Set(du, open_columns)), hn::Zero(du));
            const mask is_open = hn::And(is_less(from, to), hn::RebindMask(eight_doubles(), meets));
            top = either(is_open, smallest(top, from), top);
            bottom = either(is_open, to, bottom);
        }
        store(top, &b.top[at]);
        store(bottom, &b.bottom[at]);
    });
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(place_in_lanes);
L3D_SIMD_TABLE(find_open_in_lanes);
L3D_SIMD_TABLE(set_heights_in_lanes);

edge_sums place_edges(const pixel_edges& edges, const l3d_point_2d& corner) {
    return L3D_SIMD_CALL(place_in_lanes)(edges, corner);
}

std::uint64_t find_open(const pixel_edges& edges, int beside, int sign) {
    return L3D_SIMD_CALL(find_open_in_lanes)(edges, beside, sign);
}

void set_heights(const pixel_edges& edges, std::uint64_t open) {
    L3D_SIMD_CALL(set_heights_in_lanes)(edges, open);
}

} // namespace l3d_detail
#endif
