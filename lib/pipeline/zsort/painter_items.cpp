// SPDX-License-Identifier: MIT
// painter_items: boxes, depths, and the pixels of small triangles, a triangle a lane.
#include "pipeline/zsort/painter_items_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/zsort/painter_items.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_integers-inl.h"
#include "raster/parallel/simd_dispatch_p.h"

#include <algorithm>
#include <bit>
#include <numeric>

#ifndef L3D_PIPELINE_PAINTER_ITEMS_ONCE
#define L3D_PIPELINE_PAINTER_ITEMS_ONCE
namespace l3d_detail {

/// What items are made of.
struct item_input {
    std::span<const l3d_painter_triangle> triangles;
    l3d_size size;
    bool with_sides;
};

/// Items that were made, and the pixels in their boxes.
struct made_items {
    std::size_t count = 0;
    double area = 0;
};

} // namespace l3d_detail
#endif

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

constexpr std::int32_t side = painter_item::small_side;

HWY_INLINE int_vec least_of(const int_vec (&v)[3]) {
    return hn::Min(hn::Min(v[0], v[1]), v[2]);
}
HWY_INLINE int_vec most_of(const int_vec (&v)[3]) {
    return hn::Max(hn::Max(v[0], v[1]), v[2]);
}
/// first_centre, in lanes.
HWY_INLINE int_vec first_centre_of(int_vec position) {
    return hn::ShiftRight<l3d_subpixel_bits>(hn::Add(position, set(l3d_subpixel_one / 2 - 1)));
}
HWY_INLINE int_vec centre_of(int_vec index) {
    return hn::Add(hn::ShiftLeft<l3d_subpixel_bits>(index), set(l3d_subpixel_one / 2));
}

/// The edge functions of small triangles: none is negative at a pixel that is covered.
///
/// Corners are less than 9 pixels from the first pixel's centre, so products stay below 2^23. What
/// is made of larger triangles means nothing.
class edge_functions {
public:
    /// Expects: corners from the first pixel's centre.
    HWY_INLINE edge_functions(const int_vec (&x)[3], const int_vec (&y)[3]) {
        const int_vec area = hn::Sub(hn::Mul(hn::Sub(x[1], x[0]), hn::Sub(y[2], y[0])),
                                     hn::Mul(hn::Sub(y[1], y[0]), hn::Sub(x[2], x[0])));
        has_area = hn::Ne(area, hn::Zero(ints()));
        const int_vec turn = hn::BroadcastSignBit(area); // -1 if the corners turn to the left
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t next = (i + 1) % 3;
            const int_vec dx = hn::Sub(hn::Xor(hn::Sub(x[next], x[i]), turn), turn);
            const int_vec dy = hn::Sub(hn::Xor(hn::Sub(y[next], y[i]), turn), turn);
            // On a left or top edge, where dy < 0, or dy = 0 and dx > 0, a centre is inside.
            const int_vec zero = hn::Zero(ints());
            const int_mask is_inside =
                hn::Or(hn::Lt(dy, zero), hn::And(hn::Eq(dy, zero), hn::Gt(dx, zero)));
            row_[i] = hn::Sub(hn::Sub(hn::Mul(dy, x[i]), hn::Mul(dx, y[i])),
                              hn::IfThenZeroElse(is_inside, set(1)));
            per_column_[i] = hn::Neg(hn::ShiftLeft<l3d_subpixel_bits>(dy));
            per_row_[i] = hn::ShiftLeft<l3d_subpixel_bits>(dx);
        }
    }

    /// The pixels of the next row that are covered, of so many columns, as bits from `shift` on.
    HWY_INLINE int_vec next_row(std::int32_t columns, int shift) {
        int_vec at[3] = {row_[0], row_[1], row_[2]};
        int_vec covered = hn::Zero(ints());
        for (std::int32_t column = 0; column < columns; ++column) {
            const int_vec outside = hn::BroadcastSignBit(hn::Or(hn::Or(at[0], at[1]), at[2]));
            const auto bit = static_cast<std::int32_t>(1U << (shift + column));
            covered = hn::Or(covered, hn::AndNot(outside, set(bit)));
            for (std::size_t i = 0; i < 3; ++i)
                at[i] = hn::Add(at[i], per_column_[i]);
        }
        for (std::size_t i = 0; i < 3; ++i)
            row_[i] = hn::Add(row_[i], per_row_[i]);
        return covered;
    }

    int_mask has_area;

private:
    int_vec row_[3], per_column_[3], per_row_[3];
};

/// A vector of triangles.
class item_lanes {
public:
    HWY_INLINE item_lanes(const item_input& of, std::size_t first, std::size_t count)
        : of_(of), first_(first), count_(std::min(count, lanes)) {
        constexpr std::int32_t words = sizeof(l3d_painter_triangle) / sizeof(std::int32_t);
        constexpr std::size_t words_of_corner = sizeof(l3d_micro_vertex) / sizeof(std::int32_t);
        static_assert(offsetof(l3d_painter_triangle, v) == 0 && offsetof(l3d_micro_vertex, x) == 0);
        static_assert(offsetof(l3d_micro_vertex, y) == 4 && offsetof(l3d_micro_vertex, inv_w) == 8);
        const auto last = static_cast<std::int32_t>(count_ - 1);
        const int_vec index = hn::Mul(hn::Min(hn::Iota(ints(), 0), set(last)), set(words));
        const auto* corner = reinterpret_cast<const std::int32_t*>(&of.triangles[first]);
        for (std::size_t k = 0; k < 3; ++k, corner += words_of_corner) {
            x_[k] = hn::GatherIndex(ints(), corner, index);
            y_[k] = hn::GatherIndex(ints(), corner + 1, index);
            inv_w_[k] = hn::GatherIndex(ints(), corner + 2, index);
        }
    }

    /// Puts those that are wanted, and returns the place behind them.
    HWY_INLINE painter_item* put(painter_item* to, double& area) {
        const int_vec left = first_centre_of(least_of(x_)), top = first_centre_of(least_of(y_));
        const int_vec right = first_centre_of(most_of(x_)), bottom = first_centre_of(most_of(y_));
        const int_vec zero = hn::Zero(ints());
        const int_vec box[4] = {hn::Max(left, zero), hn::Max(top, zero),
                                hn::Min(right, set(of_.size.width)),
                                hn::Min(bottom, set(of_.size.height))};
        const int_mask seen = hn::And(hn::FirstN(ints(), count_),
                                      hn::And(hn::Lt(box[0], box[2]), hn::Lt(box[1], box[3])));
        if (hn::AllFalse(ints(), seen))
            return to;
        const int_vec columns = hn::Sub(right, left), rows = hn::Sub(bottom, top);
        const int_mask is_whole = hn::And(hn::And(hn::Eq(box[0], left), hn::Eq(box[1], top)),
                                          hn::And(hn::Eq(box[2], right), hn::Eq(box[3], bottom)));
        int_mask is_small = hn::And(hn::Lt(hn::Max(columns, rows), set(side + 1)), is_whole);
        is_small = of_.with_sides ? hn::FirstN(ints(), 0) : hn::And(is_small, seen);
        cover(left, top, hn::IfThenElseZero(is_small, columns), hn::IfThenElseZero(is_small, rows),
              is_small);
        for (std::size_t i = 0; i < 4; ++i)
            hn::Store(box[i], ints(), box_[i]);
        // Positive floats are ordered like their bits.
        hn::Store(least_of(inv_w_), ints(), farthest_);
        hn::Store(most_of(inv_w_), ints(), nearest_);
        hn::Store(hn::IfThenElseZero(seen, hn::IfThenElse(is_small, set(small), set(large))),
                  ints(), kind_);
        for (std::size_t i = 0; i < count_; ++i)
            to += put_one(i, *to, area);
        return to;
    }

private:
    static constexpr std::int32_t small = 1, large = 2; ///< kinds; 0: outside of the picture

    HWY_INLINE void cover(int_vec left, int_vec top, int_vec columns, int_vec rows,
                          int_mask is_small) {
        int_vec x[3], y[3];
        for (std::size_t k = 0; k < 3; ++k) {
            x[k] = hn::Sub(x_[k], centre_of(left));
            y[k] = hn::Sub(y_[k], centre_of(top));
        }
        edge_functions edges(x, y);
        const std::int32_t widest = hn::GetLane(hn::MaxOfLanes(ints(), columns));
        const std::int32_t highest = hn::GetLane(hn::MaxOfLanes(ints(), rows));
        int_vec halves[2] = {hn::Zero(ints()), hn::Zero(ints())};
        for (std::int32_t row = 0; row < highest; ++row) {
            int_vec& half = halves[row / (side / 2)];
            half = hn::Or(half, edges.next_row(widest, row % (side / 2) * side));
        }
        const int_mask valid = hn::And(is_small, edges.has_area);
        for (std::size_t i = 0; i < 2; ++i)
            hn::Store(hn::IfThenElseZero(valid, halves[i]), ints(), cover_[i]);
    }

    /// Returns 1 if the triangle of a lane is wanted, else 0.
    HWY_INLINE std::ptrdiff_t put_one(std::size_t i, painter_item& item, double& area) const {
        const std::uint64_t cover = static_cast<std::uint32_t>(cover_[0][i]) |
                                    std::uint64_t{static_cast<std::uint32_t>(cover_[1][i])} << 32;
        if (kind_[i] == 0 || (kind_[i] == small && cover == 0) ||
            (kind_[i] == large && !has_area(of_.triangles[first_ + i].v)))
            return 0;
        item = {.left = box_[0][i],
                .top = box_[1][i],
                .right = box_[2][i],
                .bottom = box_[3][i],
                .farthest = std::bit_cast<float>(farthest_[i]),
                .nearest = std::bit_cast<float>(nearest_[i]),
                .cover = cover,
                .triangle = static_cast<std::uint32_t>(first_ + i)};
        area += double(item.right - item.left) * (item.bottom - item.top);
        return 1;
    }

    static HWY_INLINE bool has_area(const std::array<l3d_micro_vertex, 3>& v) {
        return (std::int64_t{v[1].x} - v[0].x) * (std::int64_t{v[2].y} - v[0].y) !=
               (std::int64_t{v[1].y} - v[0].y) * (std::int64_t{v[2].x} - v[0].x);
    }

    const item_input& of_;
    std::size_t first_, count_;
    int_vec x_[3], y_[3], inv_w_[3];
    HWY_ALIGN std::int32_t box_[4][lanes], cover_[2][lanes], farthest_[lanes], nearest_[lanes],
        kind_[lanes];
};

/// Items of triangles [begin, end).
made_items make_items(const item_input& of, std::size_t begin, std::size_t end, painter_item* to) {
    made_items made;
    painter_item* next = to;
    for (std::size_t i = begin; i < end; i += lanes)
        next = item_lanes(of, i, end - i).put(next, made.area);
    made.count = static_cast<std::size_t>(next - to);
    return made;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(make_items);

void painter_items::begin(std::span<const l3d_painter_triangle> triangles,
                          std::span<const std::size_t> ends, l3d_size size, bool with_sides) {
    triangles_ = triangles;
    ends_.assign(ends.begin(), ends.end());
    size_ = size;
    with_sides_ = with_sides;
    items_.resize(triangles.size());
    kept_.resize(ends.size());
    areas_.resize(ends.size());
}

void painter_items::make(std::size_t chunk) {
    const made_items made = L3D_SIMD_CALL(make_items)(
        {triangles_, size_, with_sides_}, first(chunk), ends_[chunk], items_.data() + first(chunk));
    kept_[chunk] = made.count;
    areas_[chunk] = made.area;
}

void painter_items::finish() {
    count_ = std::accumulate(kept_.begin(), kept_.end(), std::size_t{0});
    area_ = std::accumulate(areas_.begin(), areas_.end(), 0.0);
}

} // namespace l3d_detail
#endif
