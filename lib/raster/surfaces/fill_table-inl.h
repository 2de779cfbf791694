// SPDX-License-Identifier: MIT
// fill_table: a vector of polygons, set up and cut into rows, as the pixel loops take them.
#if defined(L3D_RASTER_SURFACES_FILL_TABLE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_SURFACES_FILL_TABLE_INL_H
#undef L3D_RASTER_SURFACES_FILL_TABLE_INL_H
#else
#define L3D_RASTER_SURFACES_FILL_TABLE_INL_H
#endif

#include "raster/parallel/lane_integers-inl.h"
#include "raster/surfaces/fill_kernel_p.h"

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// Pixels of a row filled together. Fixed, because a pixel's bits depend on where its run begins.
constexpr std::int32_t run = 16;
static_assert(run <= fill_least_width);

/// 0, 1, 2 ... 15: the columns of a run.
alignas(64) constexpr std::int32_t run_columns[run] = {0, 1, 2,  3,  4,  5,  6,  7,
                                                       8, 9, 10, 11, 12, 13, 14, 15};

/// Larger polygons are not for the lanes, so they have at most so many rows and columns + 1.
constexpr std::int32_t most_pixels = 64;

/// Polygons are set up together, one in each lane of a vector.
static_assert(lanes <= fill_queue::widest_vector);

/// How a pixel's grey comes from `lit`, which is a plane over the polygon.
enum class fill_shape {
    grey,    ///< is the grey level, but between darkest and brightest
    flat,    ///< is the cosine times 229.5
    twisted, ///< the same times 1 / sqrt(bend), and turned round where facing < 0
    bent,    ///< is that, and a parabola instead of a plane
    normal   ///< is one of three numbers of a normal, all of them planes
};

/// A number of each polygon.
template <class T> struct alignas(lanes * sizeof(T)) lane_array {
    T of[lanes];

    HWY_INLINE T operator[](std::size_t i) const { return of[i]; }
};

/// A row of each polygon. Columns are counted from the polygon's first one. Numbers are those of
/// the pixel at `begin`; `_x` is what a column adds.
struct fill_row {
    lane_array<std::int32_t> from, pixels; ///< which are covered
    lane_array<std::int32_t> begin; ///< the first run's: `from`, unless that is at the edge or no
                                    ///< pixel is covered; a run fits there
    lane_array<float> inv_w, lit;
};

/// A row's further data for twisted polygons.
struct fill_row_twisted {
    lane_array<float> bend, bend_x, facing;
};

/// The other two numbers of a normal.
struct fill_row_normal {
    lane_array<float> y, z;
};

/// The data that the pixel loops need. Arrays for greys are only those that the shape needs.
///
/// A row's first run begins at its first covered pixel, the others follow. At the edge of the
/// picture, a run that would not fit begins further left.
struct fill_table {
    fill_words words;
    lane_array<std::uint32_t> material;         ///< as fill_words has it
    lane_array<std::int32_t> word_at, depth_at; ///< column 0 of the first row
    lane_array<std::int32_t> height;            ///< rows; 0 if there is none to fill
    lane_array<std::int32_t> longest;           ///< pixels of a row; > most_pixels at the edge
    lane_array<float> inv_w_x, lit_x, farthest, nearest;
    lane_array<float> darkest, brightest;
    lane_array<float> bend_xx, facing_x;
    lane_array<float> lit_xx;                 ///< for a parabola
    lane_array<float> normal_y_x, normal_z_x; ///< for a normal
    lane_array<std::int32_t> twisted;         ///< not 0: it is; others are flat
    fill_row rows[most_pixels + 1];
    fill_row_twisted twisted_rows[most_pixels + 1];
    lane_array<float> bent_rows[most_pixels + 1]; ///< the change of `lit` to the next column
    fill_row_normal normal_rows[most_pixels + 1];
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
