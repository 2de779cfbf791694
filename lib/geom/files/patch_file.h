// SPDX-License-Identifier: MIT
// l3d_patch_points: the contents of a .bpt file of Bezier patches, reader and writer of its text;
// and l3d_height_patches, a smooth surface through a grid of heights.
#ifndef L3D_GEOM_FILES_PATCH_FILE_H
#define L3D_GEOM_FILES_PATCH_FILE_H

#include "base/public.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The value of l3d_trim_curve::edge for a curve that follows no edge.
inline constexpr std::uint32_t l3d_no_edge = 0xffffffff;

/// A rational Bezier curve in the plane of a surface's parameters. The curve may follow an edge of
/// the model, which is a curve in space at which several faces end.
///
/// Shape: 2 to 16 control points; their number is the degree plus 1. Each point has u, v and a
///        weight; u and v are not multiplied by the weight.
struct L3D_PUBLIC l3d_trim_curve {
    std::vector<std::array<double, 3>> points; ///< u, v, weight
    /// The index of the edge that the curve follows, or l3d_no_edge.
    std::uint32_t edge = l3d_no_edge;
    /// The edge's parameters at the beginning and at the end of this curve. Between the ends, the
    /// edge's parameter changes in proportion to this curve's own parameter.
    double from = 0, to = 1;

    friend bool operator==(const l3d_trim_curve&, const l3d_trim_curve&) = default;
};

/// A closed loop of curves in (u, v). Each curve begins where the one before it ends, and the first
/// where the last ends. Straight lines close gaps that rounding left.
using l3d_trim_loop = std::vector<l3d_trim_curve>;

/// The error message for invalid loops, which names the loop at fault; "" if all are valid. A valid
/// loop has a curve or more. Its coordinates are finite and at most 1e12, and its weights satisfy
/// l3d_is_weight. The gap between two curves is at most 2^-20 of the loop's extent.
L3D_PUBLIC std::string l3d_trims_complaint(std::span<const l3d_trim_loop> loops);

/// The control points of one Bezier patch of any degrees, rational if it has weights.
///
/// Shape: (degree_u + 1) * (degree_v + 1) points; index = row * (degree_u + 1) + column, columns
///        along u, rows along v.
struct L3D_PUBLIC l3d_patch_points {
    /// The degrees of the polynomials along u and v; 3 and 3 for a bicubic patch.
    int degree_u = 0, degree_v = 0;
    std::vector<std::array<double, 3>> points; ///< the control points, row by row: x, y, z
    /// The weights of a rational patch: positive, one per point. Empty for a polynomial patch.
    std::vector<double> weights = {};
    /// Loops in (u, v), each from 0 to 1, that trim the patch. A point is part of the patch if an
    /// odd number of loops winds around it an odd number of times. Without loops, all points are.
    std::vector<l3d_trim_loop> trims = {};

    friend bool operator==(const l3d_patch_points&, const l3d_patch_points&) = default;
};

/// Largest degree that l3d_read_bpt accepts: a patch of 16 by 16 points.
inline constexpr int l3d_bpt_largest_degree = 15;

/// Largest magnitude of a coordinate that l3d_read_bpt accepts. The pipeline refuses homogeneous
/// coordinates from 1e12 on; a reader's message can name the line of such a coordinate.
inline constexpr double l3d_bpt_largest_coordinate = 1e12;

/// Whether a number may be the weight of a control point. With smaller weights, products would lose
/// digits, as they would be too small for a double.
constexpr bool l3d_is_weight(double w) {
    return w >= 1e-100 && w <= 1e12;
}

/// Reads a .bpt text: the number of patches, then for each patch its two degrees and its points, u
/// fastest.
///
/// The word `rational` in the line of the two degrees says that each point has a fourth number, the
/// point's weight. The coordinates are not multiplied by the weight.
/// Numbers stand apart by white space of any kind and amount, whatever the locale. A # begins a
/// comment, which ends with its line.
/// Errors:  nothing, and `why` = "name:line: what is wrong". Numbers are wrong if they are missing,
///          malformed, NaN, infinite or out of range. Degrees must be from 1 to 15, weights from
///          1e-100 to 1e12. The count must be positive and no more than the text can hold. Nothing
///          may follow the last patch.
/// Cost:    memory in proportion to the text, whatever the counts in it promise.
/// Source:  R. Holmes' patch files. The two numbers of each patch are degrees, as his examples
///          show.
L3D_PUBLIC std::optional<std::vector<l3d_patch_points>>
l3d_read_bpt(std::string_view text, std::string_view name, std::string& why);

/// Returns the text of a .bpt file. Reading the text gives the same patches, bit for bit.
/// Expects: patches that l3d_read_bpt would accept.
L3D_PUBLIC std::string l3d_write_bpt(std::span<const l3d_patch_points> patches);

/// The same surface with degrees 3 and 3. Lower degrees are raised. Higher degrees are reduced if
/// the surface is no more than bicubic.
///
/// Two patches that share a boundary still share it bit for bit, whichever way each runs along it.
/// Shape:   index = 4 * row (v) + column (u).
/// Errors:  nothing if a degree is outside 1 to 15, the number of points does not fit the degrees,
///          or weights differ. Nothing also if the surface is not bicubic, to within a rounding of
///          2^-46 of the largest coordinate.
L3D_PUBLIC std::optional<std::array<std::array<double, 3>, 16>>
l3d_as_bicubic(const l3d_patch_points& patch);

/// The most heights that are read from a file: 1024 x 1024. Each height becomes a patch, and all
/// patches together take 0.4 GB.
inline constexpr std::int64_t l3d_most_heights = std::int64_t{1} << 20;

/// A grid of heights over a rectangle, with `columns` heights in each row.
///
/// Shape:   row after row; the first row is the farthest, at the least z. Columns run along x.
struct L3D_PUBLIC l3d_height_field {
    std::size_t columns = 0;     ///< heights in each row
    std::vector<double> heights; ///< the heights, along y; NaN where one is missing
    double spacing = 1;          ///< distance from one height to the next, along x and along z

    /// The error message for an invalid field, which names the value at fault; "" if the field is
    /// valid. A valid field has at least 2 rows and 2 columns, and only whole rows. Heights are NaN
    /// or within l3d_bpt_largest_coordinate, and so is the rectangle. The spacing is positive.
    std::string complaint() const;
};

/// Makes a smooth surface through all heights: a bicubic patch for each four neighbours, unless one
/// is missing. The middle of the rectangle is at x = z = 0.
///
/// Neighbouring patches share control points on their border, bit for bit, and have the same
/// tangent planes there: the surface is C1. Its normals dS/du x dS/dv point upwards.
/// Errors:  throws l3d_error(bad_input) with the text of complaint().
/// Source:  Catmull and Rom, A class of local interpolating splines, 1974. The slope at a height is
///          half of the difference between the heights before and after it. At a border or beside a
///          missing height, the slope is the whole difference to the one neighbour.
L3D_PUBLIC std::vector<l3d_patch_points> l3d_height_patches(const l3d_height_field& field);

#endif
