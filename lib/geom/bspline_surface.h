// SPDX-License-Identifier: MIT
// l3d_bspline_surface: a tensor-product B-spline, rational or not, and the Bezier patches that it
// consists of.
#ifndef L3D_GEOM_BSPLINE_SURFACE_H
#define L3D_GEOM_BSPLINE_SURFACE_H

#include "base/public.h"
#include "geom/files/patch_file.h"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

/// The knots of a B-spline surface along u or v, and the part of the surface that is wanted.
///
/// Shape: the number of control points along it is points(); knots do not decrease, and
///        knots[degree] <= from < to <= knots[points()].
struct L3D_PUBLIC l3d_bspline_direction {
    int degree = 0; ///< degree of the polynomials between knots; 3 for cubic ones
    /// Parameters where the polynomials meet; one of multiplicity m stands m times.
    std::vector<double> knots;
    /// The range of the parameter that is part of the surface.
    double from = 0, to = 0;

    /// The number of control points along this direction.
    std::size_t points() const { return knots.size() - static_cast<std::size_t>(degree) - 1; }

    /// Spans between different knots within [from, to]: the Bezier segments along this direction.
    std::size_t segments() const;

    /// Why this is no direction of a surface or curve, "" if it is one: degrees are from 1 to
    /// l3d_bpt_largest_degree. Knots are finite, of magnitude at most 1e12, and do not decrease. No
    /// knot between the ends is there more often than the degree says, or the surface would be
    /// torn. [from, to] lies within the knots that have enough control points.
    std::string complaint() const;

    /// Clamped, uniform knots for so many control points: the curve begins at the first and ends at
    /// the last. The parameter runs from 0 to 1. Expects: points > degree >= 1.
    static l3d_bspline_direction clamped(int degree, std::size_t points);

    /// Periodic, uniform knots: a curve that closes, as smooth where it closes as elsewhere, if its
    /// last `degree` control points are its first ones again. `points` counts these twice. The
    /// parameter runs from 0 to 1. Expects: points >= 2 degree + 1, degree >= 1.
    static l3d_bspline_direction periodic(int degree, std::size_t points);
};

/// The surface as Bezier patches, along u first, then v; the same points in space, up to rounding.
///
/// Control points that are Bezier points already, by the multiplicity of their knots, stay as they
/// are bit for bit. Neighbouring patches have the same points, bit for bit, on their boundary.
/// Shape:   points: u.points() * v.points(), u fastest; weights: as many, or none if all are 1.
///          Segments of both directions: one or more.
/// Expects: positive weights, degrees from 1 to l3d_bpt_largest_degree, directions as
///          l3d_bspline_direction expects.
/// Cost:    the square of a degree per control point and patch.
/// Source:  Ramshaw, Blossoming: A Connect-the-Dots Approach to Splines, 1987. The Bezier point i
///          of the span [a, b] is the blossom of n - i arguments a and i arguments b. That equals
///          inserting both knots to full multiplicity.
L3D_PUBLIC std::vector<l3d_patch_points>
l3d_bezier_patches(const l3d_bspline_direction& u, const l3d_bspline_direction& v,
                   const std::vector<std::array<double, 3>>& points,
                   std::span<const double> weights = {});

#endif
