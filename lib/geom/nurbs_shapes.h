// SPDX-License-Identifier: MIT
// Exact shapes as NURBS surfaces: of revolution, extruded, ruled; spheres, cylinders, cones, tori.
#ifndef L3D_GEOM_NURBS_SHAPES_H
#define L3D_GEOM_NURBS_SHAPES_H

#include "base/public.h"
#include "geom/nurbs_curve.h"
#include "geom/nurbs_surface.h"

#include <optional>
#include <string_view>
#include <vector>

/// The surface of a curve that turns once around the y axis, exact.
///
/// Shape: u runs around the axis, v along the curve. A curve beside the axis that runs upwards
///        makes a surface whose outside is away from the axis.
L3D_PUBLIC l3d_nurbs_surface l3d_revolved(const l3d_nurbs_curve& curve);

/// The surface of a curve that moves straight `by` a vector, exact. Shape: u runs along the curve,
/// v along the vector. Errors: throws l3d_error(bad_input) where the sum is beyond 1e12.
L3D_PUBLIC l3d_nurbs_surface l3d_extruded(const l3d_nurbs_curve& curve,
                                          const l3d_vector<double, 3>& by);

/// The surface of all lines between points of two curves of the same parameter, exact.
///
/// Shape:  u runs along the curves, v from the first to the second.
/// Errors: throws l3d_error(bad_input) for curves of different degrees or ranges of the parameter.
L3D_PUBLIC l3d_nurbs_surface l3d_ruled(l3d_nurbs_curve first, l3d_nurbs_curve second);

/// A pipe along a curve, and how well it is one.
struct L3D_PUBLIC l3d_pipe {
    l3d_nurbs_surface surface; ///< u runs around the curve, v along it
    /// The farthest that the surface is from the pipe's radius around the curve, in the plane
    /// across it, at 8 places of each span: measured, not proven.
    double measured = 0;
};

/// The surface at a distance from a curve: all circles around it, each in the plane across the
/// curve. A pipe is no NURBS surface. This one has exact circles, whose centres and axes are cubic
/// along the curve.
///
/// Expects: a curve whose first derivative vanishes nowhere; radius and tolerance > 0.
/// Errors:  throws l3d_error(bad_input) if 1024 spans do not keep the tolerance.
L3D_PUBLIC l3d_pipe l3d_pipe_along(const l3d_nurbs_curve& curve, double radius, double tolerance);

/// A sphere of radius 1 about the origin, poles on the y axis.
L3D_PUBLIC std::vector<l3d_nurbs_surface> l3d_sphere_surfaces();
/// A cylinder of radius 1 around the y axis, from y = -1 to 1, closed by discs.
L3D_PUBLIC std::vector<l3d_nurbs_surface> l3d_cylinder_surfaces();
/// A cone around the y axis, closed: radius 1 at y = -1, tip at y = 1.
L3D_PUBLIC std::vector<l3d_nurbs_surface> l3d_cone_surfaces();
/// A torus around the y axis: radius 1 to the middle of the tube, whose radius is 0.4.
L3D_PUBLIC std::vector<l3d_nurbs_surface> l3d_torus_surfaces();
/// A disc of radius 1 about the origin, its front towards the y axis.
L3D_PUBLIC std::vector<l3d_nurbs_surface> l3d_disc_surfaces();

/// The names of these five: cone, cylinder, disc, sphere, torus.
L3D_PUBLIC std::vector<std::string_view> l3d_exact_shape_names();
/// The one of this name; nothing if there is none.
L3D_PUBLIC std::optional<std::vector<l3d_nurbs_surface>> l3d_exact_shape(std::string_view name);

#endif
