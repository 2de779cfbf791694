// SPDX-License-Identifier: MIT
// fill_lambert: makes grey from a unit normal in every pixel, one polygon a lane.
#if defined(L3D_RASTER_SURFACES_FILL_LAMBERT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_SURFACES_FILL_LAMBERT_INL_H
#undef L3D_RASTER_SURFACES_FILL_LAMBERT_INL_H
#else
#define L3D_RASTER_SURFACES_FILL_LAMBERT_INL_H
#endif

#include "raster/surfaces/fill_pixels-inl.h"
#include "raster/surfaces/fill_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// The factor from a cosine c to the grey scale: round(255 (0.1 + 0.9 c)) = trunc(229.5 c + 26).
constexpr float grey_of_cosine = 229.5f;

/// The limit of a polygon's spread, up to which its normals can be interpolated in lanes. The
/// spread measures how much the unit normals at its corners differ.
///
/// For a quad it is half the sum of the squared differences of any two normals, |a - c|^2 +
/// |b - d|^2 + |a + c - b - d|^2 / 2. For a triangle, d = c.
///
/// The interpolated normal is shorter than 1. In the middle of a quad, its square is 1 - spread /
/// 8; between two corners it is at least 1 - spread / 4. In the middle of a triangle, its square is
/// 1 - (|a - b|^2 + |b - c|^2 + |a - c|^2) / 9, at least 1 - spread / 6. So up to this limit,
/// squares stay above 0.75.
constexpr float smooth_spread = 1.0f;

/// Limits up to which one factor, 1 + spread / 32, replaces 1 / (a normal's length) for all normals
/// of a polygon. The error must be at most flat_error grey levels. The spread must be at most
/// flat_spread, where the squares of these errors are a tenth of a grey level.
constexpr float flat_error = 0.9f, flat_spread = 0.25f;

/// The limit of a quad's spread (smooth_spread explains it) up to which its pieces are filled in
/// lanes. A triangle's spread may be twice its quad's.
constexpr float piece_spread = 0.49f * smooth_spread;

/// Computes the light of a vector of polygons from normals of their corners, which are in the
/// queue.
class lambert_lanes {
public:
    /// The number of inputs of light that each corner has in the queue.
    static constexpr std::size_t numbers = 3;

    HWY_INLINE void load(const fill_queue& queue, std::size_t at) {
        square1_ = square2_ = hn::Zero(floats());
        float_vec across = square1_, lean1 = square1_, lean2 = square1_;
        for (std::size_t k = 0; k < 3; ++k) {
            auto& n = normal_[k];
            for (int i = 0; i < 4; ++i)
                n[i] = load_float(queue.corner[i][3 + k] + at);
            const float_vec d1 = hn::Sub(n[2], n[0]), d2 = hn::Sub(n[3], n[1]);
            const float_vec twist = hn::Sub(hn::Add(n[0], n[2]), hn::Add(n[1], n[3]));
            across = hn::Add(across, square_of(twist));
            square1_ = hn::Add(square1_, square_of(d1));
            square2_ = hn::Add(square2_, square_of(d2));
            lean1 = hn::Add(lean1, hn::Mul(twist, d1));
            lean2 = hn::Add(lean2, hn::Mul(twist, d2));
        }
        lean_ = hn::Add(hn::Abs(lean1), hn::Abs(lean2));
        spread_ = hn::Add(hn::Add(square1_, square2_), hn::Mul(set(0.5f), across));
    }

    /// Returns the polygons that the lanes do not take: the unfit ones, and those whose normals
    /// differ too much.
    HWY_INLINE int_mask with_unfit(int_mask unfit, int_mask) const {
        return hn::Or(unfit, mask_of(hn::Gt(spread_, set(smooth_spread))));
    }
    /// Returns the polygons among `polygons` whose pieces the lanes can fill.
    HWY_INLINE int_mask fit_in_pieces(int_mask polygons) const {
        return hn::And(polygons, mask_of(hn::Le(spread_, set(piece_spread))));
    }

    HWY_INLINE void set_up(const l3d_shading& shading, const lane_places& at, fill_table& table,
                           fill_counts& counts) {
        const floats d;
        float_vec lit[4], away[4];
        for (int i = 0; i < 4; ++i) {
            const float_vec normal[3] = {normal_[0][i], normal_[1][i], normal_[2][i]};
            lit[i] = hn::Mul(set(grey_of_cosine), lit_of(shading, normal));
            away[i] = away_of(shading, at.x[i], at.y[i], normal);
        }
        // Normals are turned round as a whole if all corners face away, and pixel by pixel if some
        // do.
        const auto some_away = hn::Gt(most_of(away), hn::Zero(d));
        const auto all_away = hn::Gt(least_of(away), hn::Zero(d));
        const auto mixed = hn::AndNot(all_away, some_away);
        // A piece's centre has a shorter normal than its corners.
        const auto unfit =
            hn::Or(hn::Or(mixed, hn::RebindMask(d, at.piece)), hn::Gt(spread_, set(flat_spread)));
        const auto flat = shading.keep_unit_normals
                              ? hn::FirstN(d, 0)
                              : hn::AndNot(unfit, hn::Le(error_of_plane(lit, at), set(flat_error)));
        const int_mask twisted = hn::AndNot(mask_of(flat), at.fits);
        const int_mask planes = hn::And(mask_of(flat), at.fits);
        counts.by_plane += static_cast<std::int64_t>(hn::CountTrue(ints(), planes));
        shape_ = hn::AllFalse(ints(), twisted) ? fill_shape::flat : fill_shape::twisted;

        const float_vec raised = hn::Add(set(1.0f), hn::Mul(spread_, set(1.0f / 32)));
        float_vec scale = hn::IfThenElse(flat, raised, set(1.0f));
        scale = hn::IfThenElse(all_away, hn::Neg(scale), scale);
        for (float_vec& l : lit)
            l = hn::Mul(l, scale);
        lit_ = at.frame.plane(lit);
        hn::Store(lit_.along(at.column_s, at.column_t), d, table.lit_x.of);
        if (shape_ == fill_shape::flat)
            return;
        hn::Store(hn::IfThenElseZero(twisted, set(1)), ints(), table.twisted.of);
        bend(at, table);
        face(mixed, away, at, table);
    }

    HWY_INLINE void put(float_vec s, float_vec t, fill_table& table, std::int32_t row) const {
        const floats d;
        hn::Store(lit_.at(s, t), d, table.rows[row].lit.of);
        if (shape_ == fill_shape::twisted) {
            fill_row_twisted& twisted = table.twisted_rows[row];
            hn::Store(bend_.at(s, t), d, twisted.bend.of);
            hn::Store(bend_x_.at(s, t), d, twisted.bend_x.of);
            hn::Store(facing_.at(s, t), d, twisted.facing.of);
        }
    }

    HWY_INLINE std::int64_t fill(const fill_band& band, const fill_table& table) const {
        return shape_ == fill_shape::flat ? fill_pixels<fill_shape::flat>(band, table)
                                          : fill_pixels<fill_shape::twisted>(band, table);
    }

private:
    /// A bound for the error of cosines if 1 / (a normal's length) is taken as 1 + spread / 32.
    /// Units: grey levels. See NUMERICS, section 14.
    HWY_INLINE float_vec error_of_plane(const float_vec (&lit)[4], const lane_places& at) const {
        const float_vec unlike = hn::Abs(hn::Sub(square1_, square2_));
        const float_vec part = hn::Add(set(1.0f / 32), hn::Mul(at.uneven, set(9.0f / 16)));
        const float_vec of_quad =
            hn::Add(hn::Mul(spread_, part),
                    hn::Add(hn::Mul(unlike, set(1.0f / 16)), hn::Mul(lean_, set(1.0f / 6))));
        const float_vec of_triangle = hn::Mul(spread_, set(1.0f / 8 - 1.0f / 32));
        const auto triangle = hn::RebindMask(floats(), at.triangle);
        const float_vec brightest = hn::Max(hn::Max(hn::Abs(lit[0]), hn::Abs(lit[1])),
                                            hn::Max(hn::Abs(lit[2]), hn::Abs(lit[3])));
        const float_vec past = hn::Abs(hn::Sub(hn::Add(lit[0], lit[2]), hn::Add(lit[1], lit[3])));
        return hn::Mul(hn::Add(brightest, hn::Mul(set(0.25f), past)),
                       hn::IfThenElse(triangle, of_triangle, of_quad));
    }

    /// Sets up which side of the surface is seen, for polygons whose normals point away from the
    /// eye at some corners only.
    HWY_INLINE void face(hn::Mask<floats> mixed, const float_vec (&away)[4], const lane_places& at,
                         fill_table& table) {
        const floats d;
        facing_ = {set(1.0f), hn::Zero(d), hn::Zero(d)};
        if (!hn::AllFalse(ints(), hn::And(at.fits, mask_of(mixed)))) {
            const lane_plane plane = at.frame.plane(away);
            facing_.base = hn::IfThenElse(mixed, hn::Neg(plane.base), facing_.base);
            facing_.first = hn::IfThenElseZero(mixed, hn::Neg(plane.first));
            facing_.second = hn::IfThenElseZero(mixed, hn::Neg(plane.second));
        }
        hn::Store(facing_.along(at.column_s, at.column_t), d, table.facing_x.of);
    }

    /// Sets up the squared length of the interpolated normal as a parabola over the polygon.
    HWY_INLINE void bend(const lane_places& at, fill_table& table) {
        const floats d;
        float_vec mean = hn::Zero(d), first = mean, second = mean, product = mean;
        for (const auto& n : normal_) {
            const float_vec sum = hn::Add(hn::Add(n[0], n[2]), hn::Add(n[1], n[3]));
            const float_vec d1 = hn::Sub(n[2], n[0]), d2 = hn::Sub(n[3], n[1]);
            mean = hn::Add(mean, square_of(sum));
            first = hn::Add(first, hn::Mul(sum, d1));
            second = hn::Add(second, hn::Mul(sum, d2));
            product = hn::Add(product, hn::Mul(d1, d2));
        }
        const float_vec half = set(0.5f);
        bend_ = at.frame.parabola({hn::Mul(mean, set(1.0f / 16)), hn::Mul(first, half),
                                   hn::Mul(second, half), square1_, hn::Add(product, product),
                                   square2_});
        bend_x_ = bend_.slope(at.column_s, at.column_t);
        hn::Store(bend_.square(at.column_s, at.column_t), d, table.bend_xx.of);
    }

    float_vec normal_[3][4], spread_;
    /// The squares of |c - a| and |d - b|, where a to d are the corners' normals.
    float_vec square1_, square2_;
    /// The sum of the sizes of two products. Each multiplies a difference of opposite corners'
    /// normals by the twist a - b + c - d of all four normals.
    float_vec lean_;
    lane_plane lit_, facing_, bend_x_;
    lane_parabola bend_;
    fill_shape shape_;
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
