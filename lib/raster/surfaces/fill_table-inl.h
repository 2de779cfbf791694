// SPDX-License-Identifier: MIT
// fill_table: holds a vector of polygons, set up and cut into rows, as the pixel loops take them.
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

/// The number of pixels of a row that are filled together. This number is the same for all
/// instruction sets, as a pixel's bits depend on where its run begins.
constexpr std::int32_t run = 16;
static_assert(run <= fill_least_width);

/// The columns of a run: 0, 1, 2 ... 15.
alignas(64) constexpr std::int32_t run_columns[run] = {0, 1, 2,  3,  4,  5,  6,  7,
                                                       8, 9, 10, 11, 12, 13, 14, 15};

/// The limit of a polygon's width and height in pixels, beyond which the lanes do not take it. A
/// polygon within this limit covers at most most_pixels + 1 rows and columns.
constexpr std::int32_t most_pixels = 64;

/// Polygons are set up together, one in each lane of a vector. A queue has room for the widest
/// vector.
static_assert(lanes <= fill_queue::widest_vector);

/// The way in which a pixel's grey is found from `lit`, which is a plane over the polygon.
enum class fill_shape {
    grey,    ///< lit is the grey level, clamped between darkest and brightest
    flat,    ///< lit is the cosine times 229.5
    twisted, ///< lit / sqrt(bend) is the cosine times 229.5, with its sign turned where facing < 0
    bent,    ///< lit is the cosine times 229.5, as a parabola instead of a plane
    normal   ///< lit is the x of a normal; the normal's y and z are planes of their own
};

/// An array with a number for each polygon in a vector.
template <class T> struct alignas(lanes * sizeof(T)) lane_array {
    T of[lanes];

    HWY_INLINE T operator[](std::size_t i) const { return of[i]; }
};

/// One row of each polygon in a vector. Columns are counted from the polygon's first column.
/// Interpolated numbers are those of the pixel at `begin`; names with `_x` are changes from column
/// to column.
struct fill_row {
    /// The row's first covered column, and its number of covered pixels.
    lane_array<std::int32_t> from, pixels;
    /// The column at which the first run begins. It is `from`, except at the picture's right edge
    /// and in rows without pixels. There it is a column where a run fits.
    lane_array<std::int32_t> begin;
    lane_array<float> inv_w, lit;
};

/// Further numbers of a row of a twisted polygon (fill_shape).
struct fill_row_twisted {
    lane_array<float> bend, bend_x, facing;
};

/// Further numbers of a row if its `lit` is the x of normals: the y and z of these normals.
struct fill_row_normal {
    lane_array<float> y, z;
};

/// The rows of a vector of polygons, for the pixel loops. Only the arrays that a shape needs are
/// set.
///
/// A row's first run begins at its first covered pixel, and further runs follow to its right. At
/// the picture's right edge, a run that would not fit begins further left.
struct fill_table {
    fill_words words;
    lane_array<std::uint32_t> material; ///< as fill_words::of_material gives it
    /// Indices of column 0 of the polygon's first row, in band.words and band.depths.
    lane_array<std::int32_t> word_at, depth_at;
    lane_array<std::int32_t> height; ///< number of rows; 0 if there is nothing to fill
    /// The number of pixels in the longest row. At the picture's right edge it is more than
    /// most_pixels.
    lane_array<std::int32_t> longest;
    lane_array<float> inv_w_x, lit_x, farthest, nearest;
    lane_array<float> darkest, brightest;
    lane_array<float> bend_xx, facing_x;
    lane_array<float> lit_xx; ///< the factor of the column's square, if `lit` is a parabola
    /// The changes of a normal's y and z from column to column.
    lane_array<float> normal_y_x, normal_z_x;
    lane_array<std::int32_t> twisted; ///< in a table of twisted polygons, 0 for a flat one
    fill_row rows[most_pixels + 1];
    fill_row_twisted twisted_rows[most_pixels + 1];
    /// The slope of `lit` at `begin`, if it is a parabola.
    lane_array<float> bent_rows[most_pixels + 1];
    fill_row_normal normal_rows[most_pixels + 1];
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
