// SPDX-License-Identifier: MIT
// l3d_height_patches: a smooth surface through a grid of heights.
#ifndef L3D_GEOM_HEIGHT_FIELD_H
#define L3D_GEOM_HEIGHT_FIELD_H

#include "base/public.h"
#include "geom/files/patch_file.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// The most heights that are read from a file: 1024 x 1024. Each becomes a patch, and the patches
/// of so many take 0.4 GB.
inline constexpr std::int64_t l3d_most_heights = std::int64_t{1} << 20;

/// Heights over a rectangle, `columns` to a row.
///
/// Shape:   row after row; the first row is the farthest, at the least z. Columns run along x.
struct L3D_PUBLIC l3d_height_field {
    std::size_t columns = 0;     ///< heights in each row
    std::vector<double> heights; ///< along y; NaN where there is none
    double spacing = 1;          ///< from one height to the next, along x and along z

    /// Why this is no height field, naming the value at fault; "" if it is one. It has 2 rows and
    /// columns at least and only whole rows. Heights are NaN or within l3d_bpt_largest_coordinate,
    /// and so is the rectangle. The spacing is positive.
    std::string complaint() const;
};

/// Bicubic patches through all heights, one for each four neighbours that are there. The middle of
/// the rectangle is at x = z = 0.
///
/// Neighbours share their border's control points bit for bit, and have the same tangent planes
/// there: the surface is C1. Seen from above, it is one side of dS/du x dS/dv.
/// Errors:  throws l3d_error(bad_input) with the text of complaint().
/// Source:  Catmull and Rom, A class of local interpolating splines, 1974: the slope at a height is
///          half of the difference between its neighbours. At a border or beside a missing height
///          it is the whole difference on the other side.
L3D_PUBLIC std::vector<l3d_patch_points> l3d_height_patches(const l3d_height_field& field);

#endif
