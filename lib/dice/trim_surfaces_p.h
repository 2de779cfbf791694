// SPDX-License-Identifier: MIT
// Blends vertices at places where trims cut: in a quad of a grid, and in a triangle of a slit.
#ifndef L3D_DICE_TRIM_SURFACES_P_H
#define L3D_DICE_TRIM_SURFACES_P_H

#include "dice/grid_light.h"
#include "dice/snap.h"
#include "geom/trims/grid_trims.h"
#include "raster/surfaces/quad_cut_p.h"
#include "raster/textures/painted_part_p.h"
#include "scene/dice_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

/// The largest errors that cutting along trims adds to a piece (l3d_trim_cells).
struct l3d_trim_error {
    double places_px = 0; ///< error of places in the picture, and of depth along the normal
    double normals = 0;   ///< error of interpolated normals, where vertices have normals
    double levels = 0;    ///< error of shade levels, where vertices have levels

    void add(const l3d_trim_error& other);
};

/// Bounds how far rounding moves a new corner on a trim's border. The corner stands for a mean of
/// vertices. Units: pixels.
inline double l3d_trimmed_snap(const l3d_dice_view& view) {
    return l3d_snap_error<double>(l3d_guard_band) + view.depth_rounding();
}

namespace l3d_detail {

/// A point of the surface between `Corners` vertices. The point is a mean of these vertices, with a
/// weight for each.
template <std::size_t Corners> struct blended_point {
    std::array<double, Corners> shares{};
    l3d_micro_vertex vertex;
    l3d_patch_parameters uv;
    /// The point's shade level where vertices have levels. Elsewhere `vertex` has the point's
    /// normal.
    double level = 0;
};

/// Interpolates between the vertices of a quad or a triangle, as before their projection.
template <std::size_t Corners> struct corners {
    std::array<l3d_micro_vertex, Corners> at;
    std::array<double, Corners> w{};
    const l3d_dice_view* view = nullptr;

    corners(const std::array<l3d_micro_vertex, Corners>& of, const l3d_dice_view& in)
        : at(of), view(&in) {
        for (std::size_t i = 0; i < Corners; ++i)
            w[i] = in.w_at(at[i].inv_w);
    }

    /// The mean of the vertices with these shares. If one vertex has the share 1, the result is
    /// that vertex, bit for bit.
    l3d_micro_vertex place(const std::array<double, Corners>& shares) const {
        double sum = 0, x = 0, y = 0;
        for (std::size_t i = 0; i < Corners; ++i) {
            if (shares[i] == 1)
                return at[i];
            const double part = shares[i] * w[i];
            sum += part;
            x += part * at[i].x;
            y += part * at[i].y;
        }
        return {rounded(x / sum), rounded(y / sum), view->depth_at(sum), {}};
    }

    void set_normal(const std::array<double, Corners>& shares, l3d_micro_vertex& to) const {
        for (std::size_t k = 0; k < 3; ++k) {
            double sum = 0;
            for (std::size_t i = 0; i < Corners; ++i)
                sum += shares[i] * double{at[i].normal[k]};
            to.normal[k] = static_cast<float>(sum);
        }
        l3d_make_unit(to.normal);
    }
};

template <class Surface>
void put_by(const Surface& of, typename Surface::point& at, bool has_levels) {
    at.vertex = of.place(at.shares);
    if (has_levels)
        at.level = of.level(at.shares);
    else
        of.set_normal(at.shares, at.vertex);
}

/// The surface of a grid's quad, for points where trims cut it. Shares are in the order of the
/// corners p00, p10, p11 and p01.
struct quad_surface : corners<4> {
    using point = blended_point<4>;

    quad_bends bends;

    quad_surface(const std::array<l3d_micro_vertex, 4>& of, const l3d_dice_view& in)
        : corners<4>(of, in), bends(of) {}

    point point_at(const l3d_grid_trims::corner& p, bool has_levels) const {
        const auto [s, t] = p.part;
        point result{.shares = {(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t},
                     .vertex = {},
                     .uv = {p.at[0], p.at[1]}};
        put(result, has_levels);
        return result;
    }

    /// Sets a point's vertex and light from its shares.
    void put(point& one, bool has_levels) const { put_by(*this, one, has_levels); }

    /// The shade level of the point with these shares, by the rule of levels_shader.
    double level(const std::array<double, 4>& p) const {
        const double s = p[1] + p[2], t = p[2] + p[3];
        double result = 0;
        for (std::size_t i = 0; i < 4; ++i)
            result += p[i] * double{at[i].normal[0]};
        return result + 4 * s * (1 - s) * ((1 - t) * double{bends.ab} + t * double{bends.dc}) +
               4 * t * (1 - t) * ((1 - s) * double{bends.ad} + s * double{bends.bc});
    }

    /// Bounds the errors of drawing parts of this quad as triangles.
    ///
    /// About the middle of a part, a level is a parabola but for cubic terms. The factors of these
    /// terms are 4 times differences of bends. No point is farther from the middle than 2/3. A
    /// parabola through six points is at most 5/3 of the values at these points: 4 (2/3)^3 (1 +
    /// 5/3) < 3.2.
    l3d_trim_error error(bool has_levels) const {
        l3d_trim_error result{.places_px = l3d_trimmed_snap(*view)};
        if (has_levels) {
            result.levels = 3.2 * (std::abs(double{bends.ab} - double{bends.dc}) +
                                   std::abs(double{bends.ad} - double{bends.bc}));
            return result;
        }
        double twist = 0, shortest = 1;
        for (std::size_t k = 0; k < 3; ++k) {
            const double d = double{at[0].normal[k]} - double{at[1].normal[k]} +
                             double{at[2].normal[k]} - double{at[3].normal[k]};
            twist += d * d;
        }
        // A mean of unit vectors is at least as long as the cosine of half of the widest angle
        // between them. The square of that cosine is at least 1 - d^2 / 4 for a distance d.
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < i; ++j) {
                double square = 0;
                for (std::size_t k = 0; k < 3; ++k) {
                    const double d = double{at[i].normal[k]} - double{at[j].normal[k]};
                    square += d * d;
                }
                shortest = std::min(shortest, 1 - square / 2);
            }
        result.normals = shortest > 0 ? 2 * ((1 - shortest) + std::sqrt(twist) / 4) / shortest
                                      : std::numeric_limits<double>::infinity();
        return result;
    }
};

/// The surface of a slit's triangle, for points where trims cut it.
struct slit_surface : corners<3> {
    using point = blended_point<3>;

    using corners<3>::corners;

    /// Sets a point's vertex and light from its shares.
    void put(point& one, bool has_levels) const { put_by(*this, one, has_levels); }

    double level(const std::array<double, 3>& p) const {
        double result =
            4 * (p[0] * p[1] * double{at[0].normal[1]} + p[0] * p[2] * double{at[0].normal[2]} +
                 p[1] * p[2] * double{at[1].normal[2]});
        for (std::size_t i = 0; i < 3; ++i)
            result += p[i] * double{at[i].normal[0]};
        return result;
    }
};

} // namespace l3d_detail

#endif
