// SPDX-License-Identifier: MIT
// l3d_stroke: a pen along a path; the area that it covers is a path again.
#ifndef L3D_RASTER_PATHS_STROKE_H
#define L3D_RASTER_PATHS_STROKE_H

#include "base/public.h"
#include "raster/paths/path.h"

#include <vector>

/// The shape of the ends of open outlines and dashes.
enum class L3D_PUBLIC l3d_cap {
    butt,  ///< cut off where the outline ends
    round, ///< half a disc
    square ///< half a square
};

/// The shape of a corner where two pieces of an outline meet.
enum class L3D_PUBLIC l3d_join {
    miter, ///< their sides go on until they meet; beyond the limit, bevel
    round, ///< a disc
    bevel  ///< cut off from corner to corner
};

/// A pen.
struct L3D_PUBLIC l3d_stroke {
    double width = 1;                ///< in pixels; more than 2^30 counts as 2^30
    l3d_cap cap = l3d_cap::butt;     ///< shape of ends
    l3d_join join = l3d_join::miter; ///< shape of corners
    /// The longest miter, from the inner corner to the outer one, in widths of the pen.
    double miter_limit = 4;
    /// Lengths of a dash, of a gap, of a dash and so on, again and again; empty: no gaps. With an
    /// odd number of lengths, dashes and gaps change places each time. In pixels along the path.
    std::vector<double> dashes{};
    double dash_begin = 0; ///< distance into the dashes at which an outline begins, in pixels
};

/// The path that a pen covers, to be filled with l3d_winding::nonzero.
///
/// Curves become chords within l3d_flat_enough. Inside of a curve the chords meet in round joins,
/// so the covered area along it is within twice that distance. Ends of curves and of dashes on them
/// are square to the curve. Corners that turn so little that a disc's arc is within that distance
/// of its chord have one point on either side, whatever the join. Other round joins, and caps,
/// become chords that change the area of no pixel by more than l3d_flat_enough: arcs and chords
/// bound equal areas. An outline of a single point shows a round or a square cap. Where the lines
/// of a very short outline turn by half a turn, nothing is missing. Where a closed outline begins
/// within a dash, its first and last dash are one. A dash without length shows a cap as a single
/// point does; a square one is turned along the path.
/// Expects: numbers; width at least 0; lengths of dashes at least 0, with a sum of 1e-3 or more.
///          Otherwise the result is empty.
/// Cost:    linear in chords and dashes, of which there are at most 10^6. If a path may have more,
///          the first to be left out are those that no picture of the largest size shows.
L3D_PUBLIC l3d_path l3d_stroked(const l3d_path& path, const l3d_stroke& pen);

#endif
