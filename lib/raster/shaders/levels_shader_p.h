// SPDX-License-Identifier: MIT
// levels_shader: grey from levels that were made with the surface; the slow twin of level_lanes.
#ifndef L3D_RASTER_SHADERS_LEVELS_SHADER_P_H
#define L3D_RASTER_SHADERS_LEVELS_SHADER_P_H

#include "raster/surfaces/quad_cut_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// Grey from a polygon's levels and bends, interpolated by the polygon's own parameters.
///
/// The bilinear map of a quad's corners gives each pixel its parameters (s, t), whatever the quad's
/// shape. Only the change of w over the quad is neglected; error() bounds the effect. In a
/// triangle, the level is the parabola through its corners and the middles of its sides.
class levels_shader {
public:
    static constexpr std::size_t components =
        2; ///< the place in the picture, relative to the first corner

    /// Begins a quad: the next polygons are pieces of this quad, until end_quad.
    void begin_quad(const quad_corners& v) {
        set_quad(v);
        in_quad_ = true;
    }
    void end_quad() { in_quad_ = false; }

    void begin_polygon(std::span<const l3d_micro_vertex> v) {
        if (in_quad_)
            return;
        if (v.size() == 4)
            set_quad({v[0], v[1], v[2], v[3]});
        else
            set_triangle(v);
    }

    void corner(const l3d_micro_vertex& vertex, float* out) const {
        out[0] = static_cast<float>(vertex.x - base_.x);
        out[1] = static_cast<float>(vertex.y - base_.y);
    }

    std::uint32_t word(const float* place) const {
        const double x = double{place[0]}, y = double{place[1]};
        const double level = is_quad_ ? in_quad(x, y) : in_triangle(x, y);
        const auto grey = static_cast<std::uint32_t>(26 + (level > 0 ? std::min(level, 229.5) : 0));
        return std::min(grey, 255u) * 0x010101u;
    }

    /// A bound for the error of levels, which comes from neglecting the change of w over the
    /// polygon. A level is a mean of the corners' numbers, with weights that add up to 1. This
    /// class uses weights that neglect w. The true weights are the used weights times the corners'
    /// w, scaled to add up to 1. True and used weights differ by (ratio - 1) / 4 at most, where
    /// ratio is the largest w divided by the least. So the error is at most (ratio - 1) / 4 times
    /// the range of the numbers.
    float error() const { return error_; }

private:
    struct direction {
        double x = 0, y = 0;
    };
    static double cross_of(direction a, direction b) { return a.x * b.y - a.y * b.x; }
    static direction between(const l3d_micro_vertex& a, const l3d_micro_vertex& b) {
        return {double(b.x) - a.x, double(b.y) - a.y};
    }

    void set_error(std::span<const l3d_micro_vertex> v, double bends) {
        float least = v[0].normal[0], most = least, farthest = v[0].inv_w, nearest = farthest;
        for (const l3d_micro_vertex& corner : v) {
            least = std::min(least, corner.normal[0]);
            most = std::max(most, corner.normal[0]);
            farthest = std::min(farthest, corner.inv_w);
            nearest = std::max(nearest, corner.inv_w);
        }
        error_ = 0.25f * (nearest / farthest - 1) * (most - least + 2 * static_cast<float>(bends));
    }

    void set_quad(const quad_corners& v) {
        is_quad_ = true;
        base_ = position(v[0]);
        along_u_ = between(v[0], v[1]);
        along_v_ = between(v[0], v[3]);
        const direction far = between(v[3], v[2]);
        twist_ = {far.x - along_u_.x, far.y - along_u_.y};
        for (std::size_t i = 0; i < 4; ++i)
            level_[i] = double{v[i].normal[0]};
        const quad_bends bends(v);
        bends_ = {double{bends.ab}, double{bends.bc}, double{bends.dc}, double{bends.ad}};
        set_error(v, 0.5 * (std::abs(bends_[0]) + std::abs(bends_[1]) + std::abs(bends_[2]) +
                            std::abs(bends_[3])));
    }

    void set_triangle(std::span<const l3d_micro_vertex> v) {
        is_quad_ = false;
        base_ = position(v[0]);
        along_u_ = between(v[0], v[1]);
        along_v_ = between(v[0], v[2]);
        for (std::size_t i = 0; i < 3; ++i)
            level_[i] = double{v[i].normal[0]};
        bends_ = {double{v[0].normal[1]}, double{v[0].normal[2]}, double{v[1].normal[2]}, 0};
        set_error(v, std::abs(bends_[0]) + std::abs(bends_[1]) + std::abs(bends_[2]));
    }

    /// The level in a triangle: the parabola's value at a place, by its barycentric coordinates.
    double in_triangle(double x, double y) const {
        const double area = cross_of(along_u_, along_v_);
        const double b = cross_of({x, y}, along_v_) / area, c = cross_of(along_u_, {x, y}) / area;
        const double a = 1 - b - c;
        return a * level_[0] + b * level_[1] + c * level_[2] +
               4 * (a * b * bends_[0] + a * c * bends_[1] + b * c * bends_[2]);
    }

    /// The level in a quad. Let h be the vector from corner a to the place, U and V the sides, and
    /// T the twist. Then h = s U + t V + s t T. So (h - t V) x (U + t T) = 0, which is a quadratic
    /// equation for t.
    double in_quad(double x, double y) const {
        const direction h{x, y};
        const double squared = cross_of(twist_, along_v_);
        const double linear = cross_of(h, twist_) + cross_of(along_u_, along_v_);
        const double constant = cross_of(h, along_u_);
        const double root = std::sqrt(std::max(0.0, linear * linear - 4 * squared * constant));
        const double sum = linear < 0 ? linear - root : linear + root;
        const double t = nearest_parameter(-2 * constant / sum, -sum / (2 * squared));
        const direction across{along_u_.x + t * twist_.x, along_u_.y + t * twist_.y};
        const direction rest{h.x - t * along_v_.x, h.y - t * along_v_.y};
        const double length = across.x * across.x + across.y * across.y;
        const double s = within((rest.x * across.x + rest.y * across.y) / length);
        const double low = (1 - s) * level_[0] + s * level_[1];
        const double high = (1 - s) * level_[3] + s * level_[2];
        return (1 - t) * low + t * high + 4 * s * (1 - s) * ((1 - t) * bends_[0] + t * bends_[2]) +
               4 * t * (1 - t) * ((1 - s) * bends_[3] + s * bends_[1]);
    }

    /// The root of a quadratic equation that is nearer to [0, 1], clamped to this range; 0 if
    /// neither root is a number.
    static double nearest_parameter(double a, double b) {
        const auto beside = [](double p) {
            return std::isfinite(p) ? std::max({-p, p - 1, 0.0}) : HUGE_VAL;
        };
        return within(beside(a) <= beside(b) ? a : b);
    }
    static double within(double parameter) {
        return std::isfinite(parameter) ? std::clamp(parameter, 0.0, 1.0) : 0;
    }

    bool in_quad_ = false, is_quad_ = false;
    scan_point base_{};
    direction along_u_, along_v_, twist_;
    /// Bends of sides ab, bc, dc, ad; in a triangle ab, ac, bc.
    std::array<double, 4> level_{}, bends_{};
    float error_ = 0;
};

} // namespace l3d_detail

#endif
