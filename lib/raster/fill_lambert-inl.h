// SPDX-License-Identifier: MIT
// fill_lambert: grey from a unit normal in every pixel, one polygon a lane.
#if defined(L3D_RASTER_FILL_LAMBERT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_FILL_LAMBERT_INL_H
#undef L3D_RASTER_FILL_LAMBERT_INL_H
#else
#define L3D_RASTER_FILL_LAMBERT_INL_H
#endif

#include "raster/fill_pixels-inl.h"
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

/// A triangle's corners may be twice as unlike as those of the quad that it is a piece of.
constexpr float piece_spread = 0.49f * smooth_spread;

/// 1 / sqrt(q) over [0.9, 1.01] by a line and over [0.75, 1.02] by a parabola, both through their
/// Chebyshev points: within 7e-4 and 3e-4, that is 0.15 and 0.07 grey levels.
constexpr float unit_line[2] = {1.5361017f, -0.53630945f};
constexpr float unit_parabola[3] = {2.0041274f, -1.5196685f, 0.5155188f};

/// The light of a group's polygons. The queue has their corners' normals.
class lambert_lanes {
public:
    static constexpr std::size_t numbers = 3; ///< in the queue, of each corner

    HWY_INLINE void load(const fill_queue& queue, std::size_t at) {
        spread_ = hn::Zero(floats());
        for (std::size_t k = 0; k < 3; ++k) {
            auto& n = normal_[k];
            for (int i = 0; i < 4; ++i)
                n[i] = load_float(queue.corner[i][3 + k] + at);
            const float_vec across = square_of(hn::Sub(hn::Add(n[0], n[2]), hn::Add(n[1], n[3])));
            spread_ =
                hn::Add(hn::Add(spread_, hn::Mul(set(0.5f), across)),
                        hn::Add(square_of(hn::Sub(n[2], n[0])), square_of(hn::Sub(n[3], n[1]))));
        }
    }

    /// Adds those whose normals are too unlike.
    HWY_INLINE int_mask with_unfit(int_mask unfit) const {
        return hn::Or(unfit, mask_of(hn::Gt(spread_, set(smooth_spread))));
    }
    /// Leaves those whose pieces will be fit.
    HWY_INLINE int_mask fit_in_pieces(int_mask polygons) const {
        return hn::And(polygons, mask_of(hn::Le(spread_, set(piece_spread))));
    }

    HWY_INLINE void set_up(const l3d_shading& shading, const lane_places& at, fill_table& table) {
        const floats d;
        float_vec lit[4], away[4];
        float_vec least_away = hn::Zero(d), most_away = hn::Zero(d);
        for (int i = 0; i < 4; ++i) {
            const float_vec normal[3] = {normal_[0][i], normal_[1][i], normal_[2][i]};
            lit[i] = lit_of(shading, normal);
            away[i] = away_of(shading, at.x[i], at.y[i], normal);
            least_away = i == 0 ? away[i] : hn::Min(least_away, away[i]);
            most_away = i == 0 ? away[i] : hn::Max(most_away, away[i]);
        }
        // All corners away: turned round as a whole. Some: pixel by pixel.
        const auto some_away = hn::Gt(most_away, hn::Zero(d));
        const auto all_away = hn::Gt(least_away, hn::Zero(d));
        const auto mixed = hn::AndNot(all_away, some_away);
        // A piece's centre has a shorter normal than its corners.
        const auto piece = hn::RebindMask(d, at.piece);
        const auto flat = hn::AndNot(hn::Or(mixed, piece), hn::Le(spread_, set(flat_spread)));
        const auto twisted = hn::Or(mixed, hn::Gt(spread_, set(bent_spread)));
        const float_vec raised = hn::Add(set(1.0f), hn::Mul(spread_, set(1.0f / 32)));
        float_vec scale = hn::Mul(set(grey_of_cosine), hn::IfThenElse(flat, raised, set(1.0f)));
        scale = hn::IfThenElse(all_away, hn::Neg(scale), scale);
        for (float_vec& l : lit)
            l = hn::Mul(l, scale);
        lit_ = at.frame.plane(lit);
        hn::Store(lit_.along(at.column_s, at.column_t), d, table.lit_x);

        const auto any = [&](hn::Mask<floats> mask) HWY_ATTR {
            return !hn::AllFalse(ints(), hn::And(at.fits, mask_of(mask)));
        };
        shape_ = any(twisted)         ? fill_shape::twisted
                 : any(hn::Not(flat)) ? fill_shape::bent
                                      : fill_shape::flat;
        if (shape_ != fill_shape::flat)
            bend(flat, twisted, at, table);
        if (shape_ == fill_shape::twisted)
            twist(twisted, mixed, away, at, table);
    }

    HWY_INLINE void put(float_vec s, float_vec t, fill_row& row) const {
        const floats d;
        hn::Store(lit_.at(s, t), d, row.lit);
        if (shape_ != fill_shape::flat) {
            hn::Store(bend_.at(s, t), d, row.bend);
            hn::Store(bend_x_.at(s, t), d, row.bend_x);
        }
        if (shape_ == fill_shape::twisted)
            hn::Store(facing_.at(s, t), d, row.facing);
    }

    HWY_INLINE std::int64_t fill(const fill_band& band, const fill_table& table) const {
        switch (shape_) {
        case fill_shape::flat:
            return fill_pixels<fill_shape::flat>(band, table);
        case fill_shape::bent:
            return fill_pixels<fill_shape::bent>(band, table);
        default:
            return fill_pixels<fill_shape::twisted>(band, table);
        }
    }

private:
    /// The square of the interpolated normal's length as a parabola over the polygon; then offset
    /// + scale times that, which is the factor itself where it is a line in the square.
    HWY_INLINE void bend(hn::Mask<floats> flat, hn::Mask<floats> twisted, const lane_places& at,
                         fill_table& table) {
        const floats d;
        const float_vec zero = hn::Zero(d), one = set(1.0f);
        const float_vec offset =
            hn::IfThenElse(twisted, zero, hn::IfThenElse(flat, one, set(unit_line[0])));
        const float_vec scale =
            hn::IfThenElse(twisted, one, hn::IfThenElse(flat, zero, set(unit_line[1])));
        float_vec bb = zero, bs = zero, bt = zero, ss = zero, st = zero, tt = zero;
        for (const auto& corners : normal_) {
            const lane_plane n = at.frame.plane(corners);
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
        const float_vec half_s = hn::Add(hn::Mul(bend_.ss, at.column_s),
                                         hn::Mul(hn::Mul(set(0.5f), bend_.st), at.column_t));
        const float_vec half_t = hn::Add(hn::Mul(hn::Mul(set(0.5f), bend_.st), at.column_s),
                                         hn::Mul(bend_.tt, at.column_t));
        bend_x_ = {hn::Add(hn::Mul(bend_.s, at.column_s), hn::Mul(bend_.t, at.column_t)),
                   hn::Add(half_s, half_s), hn::Add(half_t, half_t)};
        hn::Store(hn::Add(hn::Mul(half_s, at.column_s), hn::Mul(half_t, at.column_t)), d,
                  table.bend_xx);
    }

    HWY_INLINE void twist(hn::Mask<floats> twisted, hn::Mask<floats> mixed,
                          const float_vec (&away)[4], const lane_places& at, fill_table& table) {
        const floats d;
        const float_vec zero = hn::Zero(d), one = set(1.0f);
        const auto unit_at = [&](float value, float_vec otherwise) HWY_ATTR {
            return hn::IfThenElse(twisted, set(value), otherwise);
        };
        hn::Store(unit_at(unit_parabola[0], zero), d, table.unit0);
        hn::Store(unit_at(unit_parabola[1], one), d, table.unit1);
        hn::Store(unit_at(unit_parabola[2], zero), d, table.unit2);
        facing_ = at.frame.plane(away);
        facing_.base = hn::IfThenElse(mixed, hn::Neg(facing_.base), one);
        facing_.first = hn::IfThenElse(mixed, hn::Neg(facing_.first), zero);
        facing_.second = hn::IfThenElse(mixed, hn::Neg(facing_.second), zero);
        hn::Store(facing_.along(at.column_s, at.column_t), d, table.facing_x);
    }

    float_vec normal_[3][4], spread_;
    lane_plane lit_, facing_, bend_x_;
    lane_parabola bend_;
    fill_shape shape_;
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
