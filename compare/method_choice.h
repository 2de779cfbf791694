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
    fd,             ///< one fixed forward difference step a patch
    isocurves,      ///< curves on the surface, stepped by parts of a pixel
    subdivision,    ///< halved until flat, by de Casteljau's scheme
    tessellation,   ///< n x n quads a patch, as a model of polygons
    micropolygons,  ///< quads of a part of a pixel
    kept,           ///< micropolygons that are diced again only where they no longer fit
    scanline,       ///< by Newton's iteration along scan lines
    whitted,        ///< scan lines between curved edges that are tracked
    blinn,          ///< scan lines whose pixels are solved one from the other
    lane_carpenter, ///< halved into polygons, as its paper has it
    voxels,         ///< a cubic frame buffer, looked into by rays
    mesa,           ///< triangles through GL
};

/// A method and its parameters.
struct l3d_method_choice {
    l3d_method method = l3d_method::afd;
    int resolution = 0; ///< tessellation, fd: quads along a patch (fd: 0 is the tolerance's
                        ///< choice); voxels: cells along the model; isocurves, kept and
                        ///< micropolygons: points or quads along a pixel
    l3d_arithmetic arithmetic = l3d_real_arithmetic(); ///< for afd (but 32-bit fixed) and fd

    /// The name as the command line has it: "fd", "tessellation:16".
    std::string name() const;

    /// Reads a name; without a number methods take their usual one.
    /// Errors: nothing, with the reason in `why`: unknown name, number missing sense or range.
    static std::optional<l3d_method_choice> from_name(std::string_view name, std::string& why);

    /// The method after this one in the table, at its usual resolution; afd after the last.
    l3d_method_choice next() const;

    /// All names, with ":N" where a number may follow, separated by ", ".
    static std::string all_names();

    /// Whether frames have a certified bound of their error, which mode `error` shows.
    bool has_bound() const;

    /// Names of the methods with a bound, separated by ", ".
    static std::string names_with_bound();

    /// Whether the method obeys the settings' tolerance. Else it has steps of its own, or takes a
    /// number of them.
    bool keeps_tolerance() const;

    /// Whether it draws parallel projections.
    bool draws_parallel() const;

    /// Names of the methods that do, separated by ", ".
    static std::string names_with_parallel();

    /// Names of the methods that obey the tolerance, separated by ", ".
    static std::string names_with_tolerance();

    /// For a pipeline's settings.
    /// Errors: creating `mesa` throws l3d_error(no_backend) where there is no software GL.
    l3d_method_factory factory() const;
};

#endif
