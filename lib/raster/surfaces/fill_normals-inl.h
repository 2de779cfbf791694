// SPDX-License-Identifier: MIT
// fill_normals: interpolates normals, which are lit after filling; one polygon a lane.
#if defined(L3D_RASTER_SURFACES_FILL_NORMALS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_SURFACES_FILL_NORMALS_INL_H
#undef L3D_RASTER_SURFACES_FILL_NORMALS_INL_H
#else
#define L3D_RASTER_SURFACES_FILL_NORMALS_INL_H
#endif

#include "raster/surfaces/fill_pixels-inl.h"
#include "raster/surfaces/fill_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// Interpolates the normals of a vector of polygons as planes. The corners' normals are in the
/// queue.
class normal_lanes {
public:
    /// The number of inputs of light that each corner has in the queue.
    static constexpr std::size_t numbers = 3;

    HWY_INLINE void load(const fill_queue& queue, std::size_t at) {
        for (std::size_t k = 0; k < numbers; ++k)
            for (int i = 0; i < 4; ++i)
                normal_[k][i] =
                    hn::Mul(set(normal_code::scale), load_float(queue.corner[i][3 + k] + at));
    }

    /// Returns the polygons that the lanes do not take. They are `unfit`, the polygons that are
    /// unfit already. Lanes can interpolate any normals, as lit_words normalizes each pixel's
    /// normal later.
    HWY_INLINE int_mask with_unfit(int_mask unfit, int_mask) const { return unfit; }
    HWY_INLINE int_mask fit_in_pieces(int_mask polygons) const { return polygons; }

    HWY_INLINE void set_up(const l3d_shading&, const lane_places& at, fill_table& table,
                           fill_counts& counts) {
        const floats d;
        float* const along[numbers] = {table.lit_x.of, table.normal_y_x.of, table.normal_z_x.of};
        for (std::size_t k = 0; k < numbers; ++k) {
            plane_[k] = at.frame.plane(normal_[k]);
            hn::Store(plane_[k].along(at.column_s, at.column_t), d, along[k]);
        }
        note_error(at, table, counts);
    }

    HWY_INLINE void put(float_vec s, float_vec t, fill_table& table, std::int32_t row) const {
        const floats d;
        hn::Store(plane_[0].at(s, t), d, table.rows[row].lit.of);
        hn::Store(plane_[1].at(s, t), d, table.normal_rows[row].y.of);
        hn::Store(plane_[2].at(s, t), d, table.normal_rows[row].z.of);
    }

    HWY_INLINE std::int64_t fill(const fill_band& band, const fill_table& table) const {
        return fill_pixels<fill_shape::normal>(band, table);
    }

private:
    /// Notes a bound for the error of normals, compared with the normals at the same parameters.
    /// Errors arise if the quad is not a parallelogram in the picture, and if w changes over it.
    /// See NUMERICS, section 24.
    HWY_INLINE void note_error(const lane_places& at, const fill_table& table,
                               fill_counts& counts) const {
        const floats d;
        float_vec along1 = hn::Zero(d), along2 = along1, twist = along1, beside = along1;
        const float_vec part1 = hn::Sub(at.frame.mean_s, set(0.5f)), part2 = at.frame.mean_t;
        for (const auto& n : normal_) {
            const float_vec d1 = hn::Sub(n[2], n[0]), d2 = hn::Sub(n[3], n[1]);
            along1 = hn::Add(along1, square_of(d1));
            along2 = hn::Add(along2, square_of(d2));
            twist = hn::Add(twist, square_of(hn::Sub(hn::Add(n[0], n[2]), hn::Add(n[1], n[3]))));
            beside = hn::Add(beside, square_of(hn::Add(hn::Mul(part1, d1), hn::Mul(part2, d2))));
        }
        const float_vec of_shape =
            hn::IfThenElseZero(hn::Not(hn::RebindMask(d, at.triangle)), hn::Sqrt(beside));
        const float_vec range =
            hn::Add(hn::Sqrt(hn::Max(along1, along2)), hn::Mul(set(0.5f), hn::Sqrt(twist)));
        const float_vec of_depth = hn::Mul(share_of_depth(table), range);
        const float_vec error =
            hn::IfThenElseZero(hn::RebindMask(d, at.fits),
                               hn::Mul(set(1 / normal_code::scale), hn::Add(of_shape, of_depth)));
        note_errors(error, l3d_most_normal_error, counts.normal_error, counts.unproven_levels);
    }

    float_vec normal_[numbers][4]; ///< the corners' normals, times normal_code::scale
    lane_plane plane_[numbers];
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
