// SPDX-License-Identifier: MIT
// fill_group: polygons of a queue become a table of rows.
#if defined(L3D_RASTER_FILL_GROUP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_FILL_GROUP_INL_H
#undef L3D_RASTER_FILL_GROUP_INL_H
#else
#define L3D_RASTER_FILL_GROUP_INL_H
#endif

#include "raster/fill_pieces_p.h"
#include "raster/fill_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// A number of the grey scale from a cosine: round(255 (0.1 + 0.9 c)) = trunc(229.5 c + 26).
constexpr float grey_of_cosine = 229.5f;

/// How unlike the unit normals n of a polygon's corners are: half the sum of all squared
/// differences of two of a quad, which is |a - c|^2 + |b - d|^2 + |a + c - b - d|^2 / 2; of a
/// triangle the same with d = c, in whose middle the square is 1 - (|a - b|^2 + |b - c|^2 + |a -
/// c|^2) / 9, at least 1 - spread / 6.
///
/// Inside, the interpolated normal is shorter than 1. In the middle its square is 1 - spread / 8,
/// between any two corners at least 1 - spread / 4. Up to `flat` one factor for all pixels,
/// 1 + spread / 32, makes up for it within spread / 8 - spread / 32 = 0.002, half a grey level of
/// 229.5. Up to `bent` squares stay above 0.9, up to `smooth` above 0.75.
constexpr float flat_spread = 1.0f / 48, bent_spread = 0.4f, smooth_spread = 1.0f;

/// The product of a polygon's diagonals, in areas, from which on it counts as a sliver.
constexpr float sliver_ratio = 64;

/// A triangle's corners may be twice as unlike as those of the quad that it is a piece of.
constexpr float piece_spread = 0.49f * smooth_spread;

/// 1 / sqrt(q) over [0.9, 1.01] by a line and over [0.75, 1.02] by a parabola, both through their
/// Chebyshev points: within 7e-4 and 3e-4, that is 0.15 and 0.07 grey levels.
constexpr float unit_line[2] = {1.5361017f, -0.53630945f};
constexpr float unit_parabola[3] = {2.0041274f, -1.5196685f, 0.5155188f};

HWY_INLINE int_vec load(const std::int32_t* p) {
    return hn::LoadU(ints(), p);
}

HWY_INLINE float_vec load_float(const std::int32_t* p) {
    return hn::BitCast(floats(), load(p));
}

HWY_INLINE float_vec set(float value) {
    return hn::Set(floats(), value);
}

HWY_INLINE int_vec set(std::int32_t value) {
    return hn::Set(ints(), value);
}

/// One polygon a lane, from its corners to its rows.
class fill_group {
public:
    /// Returns whether there is anything to fill.
    /// Expects: room for a vector of polygons in the queue from `at` on, the first `valid` in use.
    HWY_INLINE bool set_up(const fill_target& to, std::size_t at, std::size_t valid,
                           fill_table& table) {
        const ints d;
        place(to.band, to.queue, at);
        const int_mask fits = classify(to, at, hn::And(live_, hn::FirstN(d, valid)));
        const int_vec height = hn::IfThenElseZero(fits, hn::Sub(to_row_, from_row_));
        const std::int32_t highest = hn::GetLane(hn::MaxOfLanes(d, height));
        if (highest == 0)
            return false;
        attributes(to.shading, to.queue, at, fits, table);
        rows(to, height, highest, table);
        return true;
    }

private:
    /// The part of each polygon's box that is in the band, and corners relative to the box.
    HWY_INLINE void place(const fill_band& band, const fill_queue& queue, std::size_t at) {
        for (int i = 0; i < 4; ++i) {
            x_[i] = load(queue.corner[i][0] + at);
            y_[i] = load(queue.corner[i][1] + at);
        }
        int_vec least_x = x_[0], least_y = y_[0], most_x = x_[0], most_y = y_[0];
        for (int i = 1; i < 4; ++i) {
            least_x = hn::Min(least_x, x_[i]);
            least_y = hn::Min(least_y, y_[i]);
            most_x = hn::Max(most_x, x_[i]);
            most_y = hn::Max(most_y, y_[i]);
        }
        const int_vec zero = hn::Zero(ints());
        column_ = first_centre_of(ints(), least_x);
        row_ = first_centre_of(ints(), least_y);
        from_column_ = hn::Max(zero, hn::Sub(zero, column_));
        to_column_ = hn::Sub(hn::Min(first_centre_of(ints(), most_x), set(band.width)), column_);
        from_row_ = hn::Max(zero, hn::Sub(set(band.top), row_));
        to_row_ = hn::Sub(hn::Min(first_centre_of(ints(), most_y), set(band.bottom)), row_);
        live_ = hn::And(hn::Lt(from_column_, to_column_), hn::Lt(from_row_, to_row_));
        const int_vec extent = hn::Max(hn::Sub(most_x, least_x), hn::Sub(most_y, least_y));
        large_ = hn::Gt(extent, set(most_pixels * pixel - 1));
        for (int i = 0; i < 4; ++i) {
            absolute_x_[i] = x_[i];
            absolute_y_[i] = y_[i];
            x_[i] = hn::Sub(x_[i], centre_of(column_));
            y_[i] = hn::Sub(y_[i], centre_of(row_));
        }
    }

    static HWY_INLINE int_vec centre_of(int_vec index) {
        return hn::Add(hn::ShiftLeft<l3d_subpixel_bits>(index), set(pixel / 2));
    }

    /// Which polygons are filled here. The others are written down, whole or in pieces.
    HWY_INLINE int_mask classify(const fill_target& to, std::size_t at, int_mask candidates) {
        spread_ = hn::Zero(floats());
        for (std::size_t k = 0; k < 3; ++k) {
            auto& n = normal_[k];
            for (int i = 0; i < 4; ++i)
                n[i] = load_float(to.queue.corner[i][3 + k] + at);
            const float_vec across = square_of(hn::Sub(hn::Add(n[0], n[2]), hn::Add(n[1], n[3])));
            spread_ =
                hn::Add(hn::Add(spread_, hn::Mul(set(0.5f), across)),
                        hn::Add(square_of(hn::Sub(n[2], n[0])), square_of(hn::Sub(n[3], n[1]))));
        }
        along1_x_ = hn::Sub(x_[2], x_[0]);
        along1_y_ = hn::Sub(y_[2], y_[0]);
        along2_x_ = hn::Sub(x_[3], x_[1]);
        along2_y_ = hn::Sub(y_[3], y_[1]);
        area2_ = cross_of(along1_x_, along1_y_, along2_x_, along2_y_);
        turn_a_ = turn(3, 0, 1);
        turn_b_ = turn(0, 1, 2);
        const int_vec turn_c = hn::Sub(area2_, turn_a_);
        turn_d_ = hn::Sub(area2_, turn_b_);

        const int_vec zero = hn::Zero(ints());
        const int_vec least = hn::Min(hn::Min(turn_a_, turn_b_), hn::Min(turn_c, turn_d_));
        const int_vec most = hn::Max(hn::Max(turn_a_, turn_b_), hn::Max(turn_c, turn_d_));
        const int_mask left = hn::Lt(least, zero), right = hn::Gt(most, zero);
        const int_mask level = hn::Not(hn::Or(left, right)); // all on one line: covers nothing
        const int_mask folded = hn::Or(hn::And(left, right), hn::Eq(area2_, zero));
        // 2 skew > |area2|, without leaving 32 bits; what is skew about a triangle is its d
        const int_vec skew =
            hn::Add(hn::Abs(hn::Sub(turn_a_, turn_c)), hn::Abs(hn::Sub(turn_b_, turn_d_)));
        const int_mask is_quad = hn::Not(hn::Lt(load(to.queue.name + at), zero));
        const int_mask skewed = hn::And(is_quad, hn::Gt(skew, hn::ShiftRight<1>(hn::Abs(area2_))));
        const int_mask rough = mask_of(hn::Gt(spread_, set(smooth_spread)));
        const int_mask unfit = hn::Or(large_, hn::Or(rough, slivers_at_the_edge(to, at)));
        const int_mask others = hn::Or(unfit, hn::Or(folded, skewed));
        candidates = hn::AndNot(hn::AndNot(large_, level), candidates);
        const int_mask left_over = hn::And(others, candidates);
        if (!hn::AllFalse(ints(), left_over))
            put_by(to, at, left_over,
                   hn::AndNot(unfit, mask_of(hn::Le(spread_, set(piece_spread)))));
        return hn::AndNot(others, candidates);
    }

    /// Polygons so thin that left of them, where a run begins that would not fit the picture,
    /// numbers are some hundred times the corners'. Pieces of quads are left as they are.
    HWY_INLINE int_mask slivers_at_the_edge(const fill_target& to, std::size_t at) const {
        const int_mask at_edge = hn::Gt(hn::Add(column_, to_column_), set(to.band.width - run + 1));
        if (hn::AllFalse(ints(), at_edge))
            return at_edge;
        const float_vec square1 =
            hn::Add(square_of(to_float(along1_x_)), square_of(to_float(along1_y_)));
        const float_vec square2 =
            hn::Add(square_of(to_float(along2_x_)), square_of(to_float(along2_y_)));
        const float_vec limit = hn::Mul(to_float(area2_), set(sliver_ratio));
        const auto thin = hn::Gt(hn::Mul(square1, square2), square_of(limit));
        const int_mask piece = hn::Eq(load(to.queue.name + at), set(fill_queue::piece));
        return hn::AndNot(piece, hn::And(at_edge, hn::RebindMask(ints(), thin)));
    }

    HWY_INLINE int_vec turn(int before, int i, int next) const {
        return cross_of(hn::Sub(x_[i], x_[before]), hn::Sub(y_[i], y_[before]),
                        hn::Sub(x_[next], x_[i]), hn::Sub(y_[next], y_[i]));
    }

    static HWY_INLINE int_mask mask_of(hn::Mask<floats> mask) {
        return hn::RebindMask(ints(), mask);
    }

    static HWY_NOINLINE void put_by(const fill_target& to, std::size_t at, int_mask left_over,
                                    int_mask in_pieces) {
        HWY_ALIGN std::int32_t is_left_over[lanes], is_in_pieces[lanes];
        hn::Store(hn::IfThenElseZero(left_over, set(1)), ints(), is_left_over);
        hn::Store(hn::IfThenElseZero(in_pieces, set(1)), ints(), is_in_pieces);
        for (std::size_t i = 0; i < lanes; ++i)
            if (is_left_over[i] != 0)
                fill_put_by(to, at + i, is_in_pieces[i] != 0);
    }

    HWY_INLINE void attributes(const fill_shading& shading, const fill_queue& queue, std::size_t at,
                               int_mask fits, fill_table& table) {
        const floats d;
        frame_.inverse = hn::Div(set(1.0f), to_float(area2_));
        // m - a = (ab + ac + ad) / 4, ad = ab + bd, and ab x bd = turn_a, ac x ab = -turn_b,
        // ac x ad = turn_d
        const float_vec half = hn::Mul(frame_.inverse, set(0.5f));
        frame_.mean_s = hn::Add(set(0.25f), hn::Mul(to_float(turn_a_), half));
        frame_.mean_t = hn::Mul(to_float(hn::Sub(turn_d_, turn_b_)), hn::Mul(half, set(0.5f)));
        const float_vec column_s = to_float(hn::ShiftLeft<l3d_subpixel_bits>(along2_y_));
        const float_vec column_t = hn::Neg(to_float(hn::ShiftLeft<l3d_subpixel_bits>(along1_y_)));

        float_vec inv_w[4], lit[4], away[4];
        float_vec least_away = hn::Zero(d), most_away = hn::Zero(d);
        for (int i = 0; i < 4; ++i) {
            inv_w[i] = load_float(queue.corner[i][2] + at);
            lit[i] = hn::Add(hn::Add(hn::Mul(normal_[0][i], set(shading.light[0])),
                                     hn::Mul(normal_[1][i], set(shading.light[1]))),
                             hn::Mul(normal_[2][i], set(shading.light[2])));
            away[i] = away_of(shading, i);
            least_away = i == 0 ? away[i] : hn::Min(least_away, away[i]);
            most_away = i == 0 ? away[i] : hn::Max(most_away, away[i]);
        }
        float_vec farthest = inv_w[0], nearest = inv_w[0];
        for (int i = 1; i < 4; ++i) {
            farthest = hn::Min(farthest, inv_w[i]);
            nearest = hn::Max(nearest, inv_w[i]);
        }
        hn::Store(farthest, d, table.farthest);
        hn::Store(nearest, d, table.nearest);
        inv_w_ = frame_.plane(inv_w);
        hn::Store(inv_w_.along(column_s, column_t), d, table.inv_w_x);

        // All corners away: turned round as a whole. Some: pixel by pixel.
        const auto some_away = hn::Gt(most_away, hn::Zero(d));
        const auto all_away = hn::Gt(least_away, hn::Zero(d));
        const auto mixed = hn::AndNot(all_away, some_away);
        // A piece's centre has a shorter normal than its corners.
        const auto piece = hn::RebindMask(d, hn::Eq(load(queue.name + at), set(fill_queue::piece)));
        const auto flat = hn::AndNot(hn::Or(mixed, piece), hn::Le(spread_, set(flat_spread)));
        const auto twisted = hn::Or(mixed, hn::Gt(spread_, set(bent_spread)));
        const float_vec raised = hn::Add(set(1.0f), hn::Mul(spread_, set(1.0f / 32)));
        float_vec scale = hn::Mul(set(grey_of_cosine), hn::IfThenElse(flat, raised, set(1.0f)));
        scale = hn::IfThenElse(all_away, hn::Neg(scale), scale);
        for (float_vec& l : lit)
            l = hn::Mul(l, scale);
        lit_ = frame_.plane(lit);
        hn::Store(lit_.along(column_s, column_t), d, table.lit_x);

        const auto any = [&](hn::Mask<floats> mask) HWY_ATTR {
            return !hn::AllFalse(ints(), hn::And(fits, mask_of(mask)));
        };
        table.shape = any(twisted)         ? fill_shape::twisted
                      : any(hn::Not(flat)) ? fill_shape::bent
                                           : fill_shape::flat;
        if (table.shape != fill_shape::flat)
            bend(flat, twisted, column_s, column_t, table);
        if (table.shape != fill_shape::twisted)
            return;
        const float_vec zero = hn::Zero(d), one = set(1.0f);
        const auto unit_at = [&](float value, float_vec otherwise) HWY_ATTR {
            return hn::IfThenElse(twisted, set(value), otherwise);
        };
        hn::Store(unit_at(unit_parabola[0], zero), d, table.unit0);
        hn::Store(unit_at(unit_parabola[1], one), d, table.unit1);
        hn::Store(unit_at(unit_parabola[2], zero), d, table.unit2);
        facing_ = frame_.plane(away);
        facing_.base = hn::IfThenElse(mixed, hn::Neg(facing_.base), one);
        facing_.first = hn::IfThenElse(mixed, hn::Neg(facing_.first), zero);
        facing_.second = hn::IfThenElse(mixed, hn::Neg(facing_.second), zero);
        hn::Store(facing_.along(column_s, column_t), d, table.facing_x);
    }

    /// The square of the interpolated normal's length as a parabola over the polygon; then offset
    /// + scale times that, which is the factor itself where it is a line in the square.
    HWY_INLINE void bend(hn::Mask<floats> flat, hn::Mask<floats> twisted, float_vec column_s,
                         float_vec column_t, fill_table& table) {
        const floats d;
        const float_vec zero = hn::Zero(d), one = set(1.0f);
        const float_vec offset =
            hn::IfThenElse(twisted, zero, hn::IfThenElse(flat, one, set(unit_line[0])));
        const float_vec scale =
            hn::IfThenElse(twisted, one, hn::IfThenElse(flat, zero, set(unit_line[1])));
        float_vec bb = zero, bs = zero, bt = zero, ss = zero, st = zero, tt = zero;
        for (const auto& corners : normal_) {
            const lane_plane n = frame_.plane(corners);
            bb = hn::Add(bb, square_of(n.base));
            bs = hn::Add(bs, hn::Mul(n.base, n.first));
            bt = hn::Add(bt, hn::Mul(n.base, n.second));
            ss = hn::Add(ss, square_of(n.first));
            st = hn::Add(st, hn::Mul(n.first, n.second));
            tt = hn::Add(tt, square_of(n.second));
        }
        const float_vec twice = hn::Add(scale, scale);
        bend_ = {hn::Add(offset, hn::Mul(scale, bb)),
                 hn::Mul(twice, bs),
                 hn::Mul(twice, bt),
                 hn::Mul(scale, ss),
                 hn::Mul(twice, st),
                 hn::Mul(scale, tt)};
        const float_vec half_s =
            hn::Add(hn::Mul(bend_.ss, column_s), hn::Mul(hn::Mul(set(0.5f), bend_.st), column_t));
        const float_vec half_t =
            hn::Add(hn::Mul(hn::Mul(set(0.5f), bend_.st), column_s), hn::Mul(bend_.tt, column_t));
        bend_x_ = {hn::Add(hn::Mul(bend_.s, column_s), hn::Mul(bend_.t, column_t)),
                   hn::Add(half_s, half_s), hn::Add(half_t, half_t)};
        hn::Store(hn::Add(hn::Mul(half_s, column_s), hn::Mul(half_t, column_t)), d, table.bend_xx);
    }

    /// away_from_eye of a corner, operation by operation.
    HWY_INLINE float_vec away_of(const fill_shading& shading, int i) const {
        const float_vec x = hn::Mul(to_float(absolute_x_[i]), set(1.0f / pixel));
        const float_vec y = hn::Mul(to_float(absolute_y_[i]), set(1.0f / pixel));
        float_vec away = hn::Zero(floats());
        for (std::size_t k = 0; k < 3; ++k) {
            const float_vec ray =
                hn::Add(hn::Add(set(shading.ray[k]), hn::Mul(x, set(shading.ray_right[k]))),
                        hn::Mul(y, set(shading.ray_down[k])));
            away = hn::Add(away, hn::Mul(normal_[k][i], ray));
        }
        return away;
    }

    HWY_INLINE void rows(const fill_target& to, int_vec height, std::int32_t highest,
                         fill_table& table) {
        const ints d;
        const floats df;
        const int_vec zero = hn::Zero(d), one = set(1);
        const int_mask clockwise = hn::Gt(area2_, zero);
        lane_edge edges[4];
        for (int i = 0; i < 4; ++i)
            edges[i].set(x_[i], y_[i], x_[(i + 1) % 4], y_[(i + 1) % 4], clockwise, from_row_);

        const auto word_pitch = static_cast<std::int32_t>(to.band.word_pitch);
        const auto depth_pitch = static_cast<std::int32_t>(to.band.depth_pitch);
        const int_vec row = hn::Sub(hn::Add(row_, from_row_), set(to.band.top));
        int_vec word_at = hn::Add(column_, hn::Mul(row, set(word_pitch)));
        int_vec depth_at = hn::Add(column_, hn::Mul(row, set(depth_pitch)));
        const int_vec last_begin = hn::Sub(set(to.band.width - run), column_);

        const int_vec down = hn::Sub(hn::ShiftLeft<l3d_subpixel_bits>(from_row_), y_[0]);
        int_vec row_s = hn::Sub(hn::Sub(zero, hn::Mul(x_[0], along2_y_)), hn::Mul(down, along2_x_));
        int_vec row_t = hn::Add(hn::Mul(down, along1_x_), hn::Mul(x_[0], along1_y_));
        const int_vec down_s = hn::ShiftLeft<l3d_subpixel_bits>(along2_x_);
        const int_vec down_t = hn::ShiftLeft<l3d_subpixel_bits>(along1_x_);
        const int_vec column_s = hn::ShiftLeft<l3d_subpixel_bits>(along2_y_);
        const int_vec column_t = hn::ShiftLeft<l3d_subpixel_bits>(along1_y_);

        int_vec samples = zero, longest = zero;
        for (std::int32_t k = 0; k < highest; ++k) {
            fill_row& row_k = table.rows[k];
            int_vec from = from_column_, end = to_column_;
            for (lane_edge& edge : edges) {
                edge.limit(from, end);
                edge.step();
            }
            const int_vec begin = hn::Min(from, last_begin);
            const int_mask any = hn::And(hn::Lt(set(k), height), hn::Lt(from, end));
            const int_vec first = hn::IfThenElseZero(any, hn::Sub(from, begin)); // a shift below
            const int_vec last = hn::IfThenElseZero(any, hn::Sub(end, begin));
            const int_vec run_end = hn::Min(last, set(run));
            hn::Store(hn::Add(word_at, begin), d, row_k.word_at);
            hn::Store(hn::Add(depth_at, begin), d, row_k.depth_at);
            hn::Store(last, d, row_k.last);
            hn::Store(hn::IfThenElseZero(any, hn::Sub(hn::Shl(one, run_end), hn::Shl(one, first))),
                      d, row_k.mask);
            longest = hn::Max(longest, last);
            samples = hn::Add(samples, hn::IfThenElseZero(any, hn::Sub(end, from)));

            const float_vec s = to_float(hn::Add(row_s, hn::Mul(begin, column_s)));
            const float_vec t = to_float(hn::Sub(row_t, hn::Mul(begin, column_t)));
            hn::Store(inv_w_.at(s, t), df, row_k.inv_w);
            hn::Store(lit_.at(s, t), df, row_k.lit);
            if (table.shape != fill_shape::flat) {
                hn::Store(bend_.at(s, t), df, row_k.bend);
                hn::Store(bend_x_.at(s, t), df, row_k.bend_x);
            }
            if (table.shape == fill_shape::twisted)
                hn::Store(facing_.at(s, t), df, row_k.facing);
            word_at = hn::Add(word_at, set(word_pitch));
            depth_at = hn::Add(depth_at, set(depth_pitch));
            row_s = hn::Sub(row_s, down_s);
            row_t = hn::Add(row_t, down_t);
        }
        hn::Store(longest, d, table.longest);
        hn::Store(hn::IfThenElseZero(hn::Gt(samples, zero), height), d, table.height);
        to.counts.samples += hn::GetLane(hn::SumOfLanes(d, samples));
    }

    int_vec x_[4], y_[4]; ///< from the centre of pixel (column_, row_)
    int_vec absolute_x_[4], absolute_y_[4];
    int_vec column_, row_;
    int_vec from_column_, to_column_, from_row_, to_row_; ///< in the band; from (column_, row_)
    int_mask live_, large_;
    float_vec normal_[3][4], spread_;
    int_vec turn_a_, turn_b_, turn_d_; ///< cross products of the sides that meet in a corner
    int_vec along1_x_, along1_y_, along2_x_, along2_y_, area2_;
    lane_frame frame_;
    lane_plane inv_w_, lit_, facing_, bend_x_;
    lane_parabola bend_;
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
