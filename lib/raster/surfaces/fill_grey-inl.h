// SPDX-License-Identifier: MIT
// fill_grey: makes grey in the corners and interpolates it, one polygon a lane.
#if defined(L3D_RASTER_SURFACES_FILL_GREY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_SURFACES_FILL_GREY_INL_H
#undef L3D_RASTER_SURFACES_FILL_GREY_INL_H
#else
#define L3D_RASTER_SURFACES_FILL_GREY_INL_H
#endif

#include "raster/surfaces/fill_pixels-inl.h"
#include "raster/surfaces/fill_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// Computes the light of a vector of polygons from grey levels of their corners, which are in the
/// queue.
class grey_lanes {
public:
    /// The number of inputs of light that each corner has in the queue.
    static constexpr std::size_t numbers = 1;

    HWY_INLINE void load(const fill_queue& queue, std::size_t at) {
        for (int i = 0; i < 4; ++i)
            grey_[i] = load_float(queue.corner[i][3] + at);
    }

    /// Returns the polygons that the lanes do not take. They are `unfit`, the polygons that are
    /// unfit already, as lanes can interpolate any greys.
    HWY_INLINE int_mask with_unfit(int_mask unfit, int_mask) const { return unfit; }
    HWY_INLINE int_mask fit_in_pieces(int_mask polygons) const { return polygons; }

    /// Sets up planes of grey. If the greys of four corners do not lie in one plane, the plane that
    /// is used may exceed them near a corner. So greys are clamped to the corners' range.
    HWY_INLINE void set_up(const l3d_shading&, const lane_places& at, fill_table& table,
                           fill_counts&) {
        const floats d;
        plane_ = at.frame.plane(grey_);
        hn::Store(plane_.along(at.column_s, at.column_t), d, table.lit_x.of);
        hn::Store(least_of(grey_), d, table.darkest.of);
        hn::Store(most_of(grey_), d, table.brightest.of);
    }

    HWY_INLINE void put(float_vec s, float_vec t, fill_table& table, std::int32_t row) const {
        hn::Store(plane_.at(s, t), floats(), table.rows[row].lit.of);
    }

    HWY_INLINE std::int64_t fill(const fill_band& band, const fill_table& table) const {
        return fill_pixels<fill_shape::grey>(band, table);
    }

private:
    float_vec grey_[4];
    lane_plane plane_;
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
