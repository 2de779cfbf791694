// SPDX-License-Identifier: MIT
// fill_table: a vector of polygons, set up and cut into rows, as the pixel loops take them.
#if defined(L3D_RASTER_FILL_TABLE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_FILL_TABLE_INL_H
#undef L3D_RASTER_FILL_TABLE_INL_H
#else
#define L3D_RASTER_FILL_TABLE_INL_H
#endif

#include "raster/fill_kernel_p.h"

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Pixels of a row filled together. Fixed, because a pixel's bits depend on where its run begins.
constexpr std::int32_t run = 16;
static_assert(run <= fill_least_width);

/// Larger polygons are not for the lanes, so they have at most so many rows and columns + 1.
constexpr std::int32_t most_pixels = 64;

using ints = hn::CappedTag<std::int32_t, 16>;
using words = hn::RebindToUnsigned<ints>;
using floats = hn::RebindToFloat<ints>;
using int_vec = hn::Vec<ints>;
using float_vec = hn::Vec<floats>;
using int_mask = hn::Mask<ints>;

/// Polygons set up together, one in each lane of a vector.
constexpr std::size_t lanes = hn::MaxLanes(ints());
static_assert(lanes <= fill_queue::widest_vector);

/// How a pixel's grey comes from `lit`, which is a plane over the polygon.
enum class fill_shape {
    grey,   ///< is the grey level, but between darkest and brightest
    flat,   ///< is the cosine times 229.5
    twisted ///< the same times 1 / sqrt(bend), and turned round where facing < 0
};

/// The first run of a row of each polygon. Numbers are those of the run's first pixel; `_x` is what
/// a column adds.
struct fill_row {
    alignas(64) std::int32_t word_at[lanes], depth_at[lanes];
    alignas(64) std::int32_t mask[lanes]; ///< covered pixels
    alignas(64) std::int32_t last[lanes]; ///< where the row ends, from the run's first pixel on
    alignas(64) float inv_w[lanes], lit[lanes];
    alignas(64) float bend[lanes], bend_x[lanes], facing[lanes];
};

/// What the pixel loops need; of the arrays for greys, what the shape does.
///
/// A run begins at its row's first covered pixel, or further left where it would not fit the
/// picture.
struct fill_table {
    fill_row rows[most_pixels + 1];
    alignas(64) std::int32_t height[lanes];  ///< rows; 0 if there is nothing to fill
    alignas(64) std::int32_t longest[lanes]; ///< `last` of the longest row
    alignas(64) float inv_w_x[lanes], lit_x[lanes], farthest[lanes], nearest[lanes];
    alignas(64) float darkest[lanes], brightest[lanes];
    alignas(64) float bend_xx[lanes], facing_x[lanes];
    alignas(64) std::int32_t twisted[lanes]; ///< not 0: it is; others are flat
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
