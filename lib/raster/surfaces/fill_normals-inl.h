// SPDX-License-Identifier: MIT
// fill_normals: normals that are shaded when all is filled, one polygon a lane.
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

/// The normals of a group's polygons, as planes. The queue has their corners' normals.
class normal_lanes {
public:
    static constexpr std::size_t numbers = 3; ///< in the queue, of each corner

    HWY_INLINE void load(const fill_queue& queue, std::size_t at) {
        for (std::size_t k = 0; k < numbers; ++k)
            for (int i = 0; i < 4; ++i)
                normal_[k][i] =
                    hn::Mul(set(normal_code::scale), load_float(queue.corner[i][3 + k] + at));
    }

    /// Normals may be as unlike as they like: pixels make them as long as they should be.
    HWY_INLINE int_mask with_unfit(int_mask unfit, int_mask) const { return unfit; }
    HWY_INLINE int_mask fit_in_pieces(int_mask polygons) const { return polygons; }

    HWY_INLINE void set_up(const l3d_shading&, const lane_places& at, fill_table& table,
                           fill_counts&) {
        const floats d;
        float* const along[numbers] = {table.lit_x.of, table.normal_y_x.of, table.normal_z_x.of};
        for (std::size_t k = 0; k < numbers; ++k) {
            plane_[k] = at.frame.plane(normal_[k]);
            hn::Store(plane_[k].along(at.column_s, at.column_t), d, along[k]);
        }
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
    float_vec normal_[numbers][4]; ///< times normal_code::scale
    lane_plane plane_[numbers];
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
