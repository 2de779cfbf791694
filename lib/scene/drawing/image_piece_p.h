// SPDX-License-Identifier: MIT
// image_piece: an exact piece of a surface as a camera sees it, and the polynomial of its contours.
#ifndef L3D_SCENE_DRAWING_IMAGE_PIECE_P_H
#define L3D_SCENE_DRAWING_IMAGE_PIECE_P_H

#include "geom/trims/trim_region.h"
#include "scene/camera.h"
#include "scene/patch_scene.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace l3d_detail {

/// A polynomial of any degrees in Bernstein form, with `dims` values at each place.
///
/// Shape: (m + 1) * (n + 1) places, u fastest, each with its values side by side.
struct bernstein_net {
    /// The largest degree: the degree of the contours' polynomial for patches of degree 15.
    static constexpr int most_degree = 44;

    int m = 0, n = 0, dims = 1;
    std::vector<double> c;

    bernstein_net() = default;
    bernstein_net(int of_m, int of_n, int of_dims)
        : m(of_m), n(of_n), dims(of_dims),
          c(static_cast<std::size_t>((of_m + 1) * (of_n + 1) * of_dims)) {}

    std::size_t index(int row, int column) const {
        return static_cast<std::size_t>((row * (m + 1) + column) * dims);
    }
    const double* at(int row, int column) const { return &c[index(row, column)]; }
    double* at(int row, int column) { return &c[index(row, column)]; }
    std::size_t places() const { return static_cast<std::size_t>((m + 1) * (n + 1)); }

    /// The halves of a net along u, or along v. The second half takes the whole net's memory.
    static std::pair<bernstein_net, bernstein_net> halves(bernstein_net whole, bool along_u);
    /// The derivative along u, or along v.
    bernstein_net derivative(bool along_u) const;
    /// The part of the polynomial where u runs from u0 to u1 and v from v0 to v1. The part's own
    /// parameters run from 0 to 1. u1 may be below u0.
    bernstein_net part(double u0, double u1, double v0, double v1) const;

    /// The values of a polynomial at a place, and their derivatives by u and v, for at most 4 dims.
    struct jet {
        std::array<double, 4> value{}, by_u{}, by_v{};
    };
    jet evaluate(double u, double v) const;
};

/// A place of the picture with a depth.
/// Units: pixels from the picture's centre, y down. The depth grows away from the eye, is linear in
///        the picture along straight lines, and is in pixels about the middle of the scene.
struct image_place {
    double x = 0, y = 0, z = 0;
};

/// The map from the world to homogeneous places of the picture: x w, y w, w, z w.
///
/// The picture is sheared by a tiny part of the depth. So no plane is seen exactly edge-on, and no
/// contour runs exactly along a seam.
class drawing_view {
public:
    static constexpr double shear = 0x1p-28;

    drawing_view(const l3d_camera& camera, l3d_size size, double middle_depth, double reach);

    std::array<double, 4> placed(const std::array<double, 4>& world) const;
    /// Tells on which side of the near plane a homogeneous place lies. The result is not negative
    /// in front of the plane. The result is linear in homogeneous places.
    double ahead(const double* p) const { return is_parallel_ ? 1 : p[3] - near_ * p[2]; }
    /// The distance along the view axis of a place with the depth z (image_place::z).
    double depth_of(double z) const;
    /// The length in pixels of a world unit across the line of sight, at the depth z
    /// (image_place::z).
    double scale_at(double z) const;
    l3d_size size() const { return size_; }
    /// The error that the shear adds, in pixels.
    double error() const { return error_; }

private:
    l3d_matrix<double> to_image_;
    l3d_vector<double, 4> depth_row_{0.0, 0.0, 0.0, 0.0};
    l3d_size size_;
    bool is_parallel_;
    double near_ = 0, middle_ = 0, scale_ = 1, error_ = 0;
};

/// Whether all, some or none of a net's places are in front of the near plane.
enum class ahead_of_near { all, some, none };

/// A box of the picture and of depths.
struct image_bounds {
    double left = 0, right = 0, top = 0, bottom = 0, near = 0, far = 0;

    double width() const { return right - left; }
    double height() const { return bottom - top; }
};

/// A region of parameters that answers many calls of contains() fast. It holds the sides of the
/// region's polygons in rows of equal height in v.
class region_rows {
public:
    region_rows() = default;
    explicit region_rows(const l3d_trim_region& region);

    /// Whether a place is inside, as l3d_trim_region::contains tells, except for rounding.
    bool contains(double u, double v) const;

private:
    using side = std::array<l3d_trim_place, 2>;

    std::size_t row_of(double v) const;

    std::vector<std::vector<side>> rows_;
};

/// A piece of a surface in the picture.
struct image_piece {
    bernstein_net net; ///< the surface in the picture: 4 dims, as drawing_view::placed
    /// A polynomial that is 0 at contours; its sign tells which side is seen.
    bernstein_net contour;
    bernstein_net world;    ///< the surface in the world: x w, y w, z w, w
    l3d_trim_region region; ///< the part of the piece that trims leave; empty without trims
    region_rows rows;       ///< the same region, as rows for many calls of contains()
    std::size_t instance = 0, number = 0;
    std::size_t first_edge = 0; ///< the index in the drawing of the first edge of the piece's model
    bool is_trimmed = false;

    image_piece(const l3d_patch_points& piece, const l3d_matrix<double>& placement,
                const drawing_view& view);

    /// Trims the piece. The region becomes polygons that approximate these loops, to within
    /// `wanted` if possible. Returns the largest distance between polygons and loops, which is no
    /// bound where the piece reaches the near plane.
    /// Units: pixels.
    double trim(std::span<const l3d_trim_loop> loops, double wanted, const drawing_view& view);

    image_place at(double u, double v) const;
    bool contains(double u, double v) const { return !is_trimmed || rows.contains(u, v); }
    /// The unit normal of the piece in the world; zero where there is none.
    l3d_vector<double, 3> normal(double u, double v) const;
};

ahead_of_near side_of_near(const bernstein_net& net, const drawing_view& view);
/// The box of a net, in the picture and in depth.
/// Expects: all in front of the near plane.
image_bounds bounds_of(const bernstein_net& net);
/// Whether all of a net is beyond one side of the picture, grown by a margin.
bool is_beside(const bernstein_net& net, const drawing_view& view);

/// A parallelogram in the picture that approximates a net, with a bound of its error.
struct flat_image {
    /// The parallelogram's middle and its two sides as vectors.
    image_place middle, along_u, along_v;
    double error = 0; ///< bound of the net's distance from the parallelogram, in pixels

    explicit flat_image(const bernstein_net& net);
    /// A bound of the distance between any two places of the net, in the picture.
    double reach() const {
        return std::hypot(along_u.x, along_u.y) + std::hypot(along_v.x, along_v.y) + 2 * error;
    }
    image_place at(double s, double t) const {
        return {middle.x + (s - 0.5) * along_u.x + (t - 0.5) * along_v.x,
                middle.y + (s - 0.5) * along_u.y + (t - 0.5) * along_v.y,
                middle.z + (s - 0.5) * along_u.z + (t - 0.5) * along_v.z};
    }
};

/// Whether to halve a net along u rather than along v, so that halves are nearer to parallelograms.
/// The better direction is the one in which the net bends more. If twist is larger than both bends,
/// the better direction is the one in which the net is longer.
/// Expects: all in front of the near plane.
bool bends_along_u(const bernstein_net& net);

/// The distance of the place p from the chord between the places `from` and `to`, in the picture.
double distance_from(const image_place& p, const image_place& from, const image_place& to);

} // namespace l3d_detail

#endif
