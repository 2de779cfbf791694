// SPDX-License-Identifier: MIT
// l3d_method_choice: the choice of a drawing method, and the table of all.
#ifndef L3D_COMPARE_METHOD_CHOICE_H
#define L3D_COMPARE_METHOD_CHOICE_H

#include "compare/arithmetic.h"
#include "pipeline/surface_method.h"

#include <optional>
#include <string>
#include <string_view>

/// Ways to draw bicubic patches.
enum class l3d_method {
    afd,            ///< adaptive forward differencing with a certified bound; the product
    fd,             ///< each patch walked with one fixed forward difference step
    isocurves,      ///< curves on the surface, stepped by a fraction of a pixel
    subdivision,    ///< patches halved until flat, by de Casteljau's scheme
    tessellation,   ///< n x n quads a patch, as a polygon model
    micropolygons,  ///< quads smaller than a pixel
    kept,           ///< micropolygons that are diced again only where they no longer fit
    scanline,       ///< each pixel solved by Newton's iteration along scan lines
    whitted,        ///< scan lines between curved edges that are tracked from line to line
    blinn,          ///< scan lines on which each pixel starts from the one before
    lane_carpenter, ///< patches halved into polygons, as in Lane's and Carpenter's paper
    voxels,         ///< a cubic frame buffer, looked into by rays
    mesa,           ///< triangles through GL
};

/// A method and its parameters.
struct l3d_method_choice {
    l3d_method method = l3d_method::afd;
    /// The number in the method's name: quads along a patch for tessellation and fd, cells along
    /// the model for voxels, points or quads along a pixel for isocurves, kept and micropolygons. 0
    /// for fd lets the tolerance choose.
    int resolution = 0;
    /// The numbers that fd and afd walk in. afd has no fixed_16_16.
    l3d_arithmetic arithmetic = l3d_real_arithmetic();

    /// The name on the command line: "fd", "tessellation:16".
    std::string name() const;

    /// Reads a name. Without a number, a method takes its usual one.
    /// Errors:  nothing, with the reason in `why`: unknown name, or a number that makes no sense or
    ///          is out of range.
    static std::optional<l3d_method_choice> from_name(std::string_view name, std::string& why);

    /// The method after this one in the table, at its usual resolution; afd after the last.
    l3d_method_choice next() const;

    /// All names, with ":N" where a number may follow, separated by ", ".
    static std::string all_names();

    /// Whether a frame has a certified bound of its error, which the mode `error` shows.
    bool has_bound() const;

    /// Names of the methods with a bound, separated by ", ".
    static std::string names_with_bound();

    /// Whether the method obeys the settings' tolerance. Other methods have fixed steps, or take
    /// their number from the name.
    bool keeps_tolerance() const;

    /// Whether the method draws parallel projections.
    bool draws_parallel() const;

    /// Names of the methods that draw parallel projections, separated by ", ".
    static std::string names_with_parallel();

    /// Names of the methods that obey the tolerance, separated by ", ".
    static std::string names_with_tolerance();

    /// Makes the method, for a pipeline's settings.
    /// Errors: creating `mesa` throws l3d_error(no_backend) where there is no software GL.
    l3d_method_factory factory() const;
};

#endif
