// SPDX-License-Identifier: MIT
// fill_levels: interpolates levels that were made with the surface, one polygon a lane.
#if defined(L3D_RASTER_SURFACES_FILL_LEVELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_SURFACES_FILL_LEVELS_INL_H
#undef L3D_RASTER_SURFACES_FILL_LEVELS_INL_H
#else
#define L3D_RASTER_SURFACES_FILL_LEVELS_INL_H
#endif

#include "raster/surfaces/fill_pixels-inl.h"
#include "raster/surfaces/fill_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// Computes the light of a vector of polygons from the levels of their corners and the bends of
/// their sides, which are in the queue.
///
/// The level is a parabola over the polygon. It has the corners' levels. In the middle of each
/// side, it exceeds the mean of the side's ends by the side's bend. Opposite sides of a quad get
/// the mean of their bends. See NUMERICS, section 14.
class level_lanes {
public:
    /// The number of inputs of light that each corner has in the queue.
    static constexpr std::size_t numbers = 3;

    HWY_INLINE void load(const fill_queue& queue, std::size_t at) {
        for (int i = 0; i < 4; ++i)
            level_[i] = load_float(queue.corner[i][3] + at);
        side_ab_ = load_float(queue.corner[0][4] + at);
        side_ad_ = load_float(queue.corner[0][5] + at);
        side_bc_ = load_float(queue.corner[1][5] + at);
        side_dc_ = load_float(queue.corner[3][4] + at);
    }

    /// Returns the polygons that the lanes do not take: the unfit ones and the skewed quads. In a
    /// skewed quad, a parabola in its parameters is far from a parabola in the picture.
    HWY_INLINE int_mask with_unfit(int_mask unfit, int_mask skewed) const {
        return hn::Or(unfit, skewed);
    }
    HWY_INLINE int_mask fit_in_pieces(int_mask polygons) const { return polygons; }

    HWY_INLINE void set_up(const l3d_shading&, const lane_places& at, fill_table& table,
                           fill_counts& counts) {
        const floats d;
        const auto triangle = hn::RebindMask(d, at.triangle);
        const float_vec along1 = hn::Sub(level_[2], level_[0]);
        const float_vec along2 = hn::Sub(level_[3], level_[1]);
        const float_vec mean = hn::Mul(
            set(0.25f), hn::Add(hn::Add(level_[0], level_[2]), hn::Add(level_[1], level_[3])));
        const mean_parabola of_quad = quad(at, mean, along1, along2);
        const mean_parabola of_triangle = this->triangle(mean, along1, along2);
        const auto choose = [&](float_vec mean_parabola::*number) HWY_ATTR {
            return hn::IfThenElse(triangle, of_triangle.*number, of_quad.*number);
        };
        level_of_ = at.frame.parabola({choose(&mean_parabola::base), choose(&mean_parabola::y),
                                       choose(&mean_parabola::z), choose(&mean_parabola::yy),
                                       choose(&mean_parabola::yz), choose(&mean_parabola::zz)});
        slope_ = level_of_.slope(at.column_s, at.column_t);
        hn::Store(level_of_.square(at.column_s, at.column_t), d, table.lit_xx.of);
        note_error(at, table, counts);
    }

    HWY_INLINE void put(float_vec s, float_vec t, fill_table& table, std::int32_t row) const {
        const floats d;
        hn::Store(level_of_.at(s, t), d, table.rows[row].lit.of);
        hn::Store(slope_.at(s, t), d, table.bent_rows[row].of);
    }

    HWY_INLINE std::int64_t fill(const fill_band& band, const fill_table& table) const {
        return fill_pixels<fill_shape::bent>(band, table);
    }

private:
    /// The parabola of a quad. Let (y, z) be the place from the corners' mean, in parts of the
    /// diagonals. The parameters along the sides are then y - z and y + z, from -1/2 to 1/2. The
    /// corners' distance from their plane is weighted by the product of both parameters, and the
    /// sides' bends by the parameters' squares.
    HWY_INLINE mean_parabola quad(const lane_places& at, float_vec mean, float_vec along1,
                                  float_vec along2) {
        const float_vec four = set(4.0f), half = set(0.5f);
        const float_vec on_plane = hn::Sub(
            mean, hn::Add(hn::Mul(at.frame.mean_s, along1), hn::Mul(at.frame.mean_t, along2)));
        off_plane_ = hn::Sub(level_[0], on_plane);
        const float_vec bend_u = hn::Mul(half, hn::Add(side_ab_, side_dc_));
        const float_vec bend_v = hn::Mul(half, hn::Add(side_ad_, side_bc_));
        const float_vec both = hn::Add(bend_u, bend_v);
        return {hn::Add(mean, both),
                along1,
                along2,
                hn::Mul(four, hn::Sub(off_plane_, both)),
                hn::Mul(set(8.0f), hn::Sub(bend_u, bend_v)),
                hn::Neg(hn::Mul(four, hn::Add(off_plane_, both)))};
    }

    /// The parabola through the corners and the middles of the sides of a triangle; corner d is c.
    HWY_INLINE mean_parabola triangle(float_vec mean, float_vec along1, float_vec along2) const {
        const float_vec four = set(4.0f), half = set(0.5f);
        const float_vec to_c = hn::Add(side_ad_, side_bc_), unlike = hn::Sub(side_bc_, side_ad_);
        return {hn::Add(mean, hn::Add(hn::Mul(half, to_c), hn::Mul(set(0.25f), side_ab_))),
                hn::Add(along1, hn::Sub(unlike, side_ab_)),
                hn::Sub(along2, hn::Add(unlike, side_ab_)),
                hn::Neg(hn::Mul(four, side_ad_)),
                hn::Mul(four, hn::Sub(side_ab_, to_c)),
                hn::Neg(hn::Mul(four, side_bc_))};
    }

    /// Notes a bound for the error of the parabola, compared with the levels at the same
    /// parameters. Errors arise if the quad is not a parallelogram in the picture, and if w changes
    /// over it.
    HWY_INLINE void note_error(const lane_places& at, const fill_table& table,
                               fill_counts& counts) const {
        const floats d;
        const auto quads = hn::Not(hn::RebindMask(d, at.triangle));
        const auto size = [](float_vec a) HWY_ATTR { return hn::Abs(a); };
        const float_vec bends =
            hn::Mul(set(0.5f), hn::Add(hn::Add(size(side_ab_), size(side_dc_)),
                                       hn::Add(size(side_ad_), size(side_bc_))));
        const float_vec uneven = hn::Mul(set(4.0f), at.uneven);
        const float_vec grown = hn::Add(uneven, hn::Mul(set(0.25f), square_of(uneven)));
        const float_vec of_shape =
            hn::IfThenElseZero(quads, hn::Mul(grown, hn::Add(size(off_plane_), bends)));
        const float_vec range =
            hn::Add(hn::Sub(most_of(level_), least_of(level_)), hn::Add(bends, bends));
        const float_vec of_depth = hn::Mul(share_of_depth(table), range);
        const float_vec error =
            hn::IfThenElseZero(hn::RebindMask(d, at.fits), hn::Add(of_shape, of_depth));
        note_errors(error, l3d_most_level_error, counts.level_error, counts.unproven_levels);
    }

    float_vec level_[4];
    /// The bend of each side: the level in its middle, less the mean of the levels at its ends.
    float_vec side_ab_, side_ad_, side_bc_, side_dc_;
    /// The levels of corners a and c are above the quad's plane of levels by this amount. The
    /// levels of b and d are below the plane by the same amount.
    float_vec off_plane_;
    lane_parabola level_of_;
    lane_plane slope_;
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
