// SPDX-License-Identifier: MIT
// quad_places: bilinear quads in homogeneous space, and Newton's method in lanes.
#include "raster/textures/quad_places_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/textures/quad_places.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<float, 16> floats;
constexpr hn::RebindToSigned<decltype(floats)> integers;
using float_vec = hn::Vec<decltype(floats)>;
using int_vec = hn::Vec<decltype(integers)>;

HWY_INLINE float_vec set(float number) {
    return hn::Set(floats, number);
}

HWY_INLINE float_vec difference(float_vec a, float_vec b, float_vec c, float_vec d) {
    return hn::Sub(hn::Mul(a, b), hn::Mul(c, d));
}

/// A function that is 0, or any number, at (0, 0).
struct bilinear {
    float_vec s, t, st;

    HWY_INLINE float_vec at(float_vec at_s, float_vec at_t) const {
        return hn::Add(hn::Mul(at_s, hn::Add(s, hn::Mul(at_t, st))), hn::Mul(at_t, t));
    }
    HWY_INLINE float_vec along_s(float_vec at_t) const { return hn::Add(s, hn::Mul(at_t, st)); }
    HWY_INLINE float_vec along_t(float_vec at_s) const { return hn::Add(t, hn::Mul(at_s, st)); }

    /// Less a number times another function.
    HWY_INLINE bilinear less(float_vec factor, const bilinear& other) const {
        return {hn::Sub(s, hn::Mul(factor, other.s)), hn::Sub(t, hn::Mul(factor, other.t)),
                hn::Sub(st, hn::Mul(factor, other.st))};
    }
};

/// The map from (s, t) to the distance of w x and w y from the pixel, and its inverse.
struct lane_map {
    float_vec dx, dy, x_s, x_t, y_s, y_t, over;

    HWY_INLINE lane_map(const bilinear& x, const bilinear& y, float_vec left, float_vec top,
                        float_vec s, float_vec t)
        : dx(hn::Sub(x.at(s, t), left)), dy(hn::Sub(y.at(s, t), top)), x_s(x.along_s(t)),
          x_t(x.along_t(s)), y_s(y.along_s(t)), y_t(y.along_t(s)) {
        const float_vec area = difference(x_s, y_t, x_t, y_s);
        constexpr float least = 1e-20F; // square pixels: less is a line, as far as floats tell
        const auto has_area = hn::Gt(hn::Abs(area), set(least));
        over =
            hn::IfThenElseZero(has_area, hn::Div(set(1), hn::IfThenElse(has_area, area, set(1))));
    }
};

/// Parameters stay near the quad, where it is nearly linear.
HWY_INLINE float_vec between(float_vec v, float least, float most) {
    return hn::Min(hn::Max(v, set(least)), set(most));
}

void find_quad_places(const placed_quad* quads, const quad_pixels& from, painted_pixels& pixels) {
    const float* const numbers = quads->of.data();
    for (std::size_t i = 0; i < pixels.count; i += hn::Lanes(floats)) {
        const int_vec at = hn::Load(integers, &from.first[i]);
        const auto number = [&](int which)
                                HWY_ATTR { return hn::GatherIndex(floats, numbers + which, at); };
        const auto function = [&](int first) HWY_ATTR {
            return bilinear{number(first), number(first + 1), number(first + 2)};
        };
        using q = placed_quad;
        const float_vec left = hn::Sub(hn::Load(floats, &from.x[i]), number(q::left));
        const float_vec top = hn::Sub(hn::Load(floats, &from.y[i]), number(q::top));
        const bilinear w = function(q::w_s);
        const bilinear x = function(q::x_s).less(left, w), y = function(q::y_s).less(top, w);
        float_vec s = set(0.5F), t = set(0.5F);
        // The map is linear but for s t. So the first step leaves an error in proportion to that
        // term, and each of the others about the square of the error before.
        constexpr int steps = 3;
        for (int step = 0; step < steps; ++step) {
            const lane_map map(x, y, left, top, s, t);
            constexpr float beside = 0.25F; // how far a step may go beyond the quad
            const float_vec down = difference(map.y_t, map.dx, map.x_t, map.dy);
            const float_vec across = difference(map.x_s, map.dy, map.y_s, map.dx);
            s = between(hn::Sub(s, hn::Mul(down, map.over)), -beside, 1 + beside);
            t = between(hn::Sub(t, hn::Mul(across, map.over)), -beside, 1 + beside);
        }
        s = between(s, 0, 1);
        t = between(t, 0, 1);
        // A step of the pixel changes w x by w.
        const lane_map map(x, y, left, top, s, t);
        const float_vec per_pixel = hn::Mul(map.over, hn::Add(set(1), w.at(s, t)));
        const auto put = [&](int first, painted_pixels::numbers& place,
                             painted_pixels::numbers& right,
                             painted_pixels::numbers& below) HWY_ATTR {
            const bilinear of = function(first + 1);
            const float_vec of_s = hn::Mul(per_pixel, of.along_s(t));
            const float_vec of_t = hn::Mul(per_pixel, of.along_t(s));
            hn::Store(hn::Add(number(first), of.at(s, t)), floats, &place[i]);
            hn::Store(difference(of_s, map.y_t, of_t, map.y_s), floats, &right[i]);
            hn::Store(difference(of_t, map.x_s, of_s, map.x_t), floats, &below[i]);
        };
        put(q::u, pixels.u, pixels.u_right, pixels.u_down);
        put(q::v, pixels.v, pixels.v_right, pixels.v_down);
        for (int c = 0; c < 3; ++c)
            hn::Store(number(q::red + c), floats, &pixels.light[static_cast<std::size_t>(c)][i]);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

namespace {

/// A corner of a polygon.
struct placed_corner {
    double x, y, w;
    picture_map::place at;
};

/// Makes the picture's places small without a change of what is seen there: floats hold fractions
/// of pixels of the picture then.
void reduce(std::array<placed_corner, 4>& corners, std::size_t axis, l3d_texture_wrap wrap) {
    const double whole = corners[0].at[axis] - place_near_zero(corners[0].at[axis], wrap);
    for (placed_corner& corner : corners)
        corner.at[axis] -= whole;
}

} // namespace

L3D_SIMD_TABLE(find_quad_places);

/// A triangle is half of a quad whose functions are linear.
void placed_quad::set(const painted_part& part, std::uint32_t name) {
    std::array<placed_corner, 4> corners{};
    const std::size_t index = name - part.first, quads = painted_part::quads(*part.part);
    const auto corner_of = [&](const l3d_micro_vertex& vertex, const l3d_patch_parameters& at) {
        return placed_corner{static_cast<double>(vertex.x) / l3d_subpixel_one,
                             static_cast<double>(vertex.y) / l3d_subpixel_one,
                             1 / double{vertex.inv_w}, part.map.at(at)};
    };
    if (index < quads) {
        const l3d_micro_grid& grid = part.part->grid;
        const auto pitch = static_cast<std::size_t>(grid.pitch);
        const std::size_t row = index / pitch, column = index % pitch;
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t r = row + k / 2, c = column + k % 2;
            corners[k] = corner_of(grid.vertex(r * pitch + c), {part.u[c], part.v[r]});
        }
    } else {
        const std::size_t triangle = index - quads;
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] =
                corner_of(part.part->triangles.vertex(triangle, k), part.triangles[k][triangle]);
    }
    reduce(corners, 0, part.texture->wrap_u());
    reduce(corners, 1, part.texture->wrap_v());
    const double unit = 1 / corners[0].w, x = corners[0].x, y = corners[0].y;
    of[left] = static_cast<float>(x);
    of[top] = static_cast<float>(y);
    const auto put = [&](number first, const std::array<double, 4>& at) {
        of[first] = static_cast<float>(at[1] - at[0]);
        of[first + 1] = static_cast<float>(at[2] - at[0]);
        of[first + 2] = index < quads ? static_cast<float>(at[3] - at[2] - (at[1] - at[0])) : 0;
    };
    std::array<double, 4> xs{}, ys{}, ws{}, us{}, vs{};
    for (std::size_t k = 0; k < 4; ++k) {
        ws[k] = corners[k].w * unit;
        xs[k] = (corners[k].x - x) * ws[k];
        ys[k] = (corners[k].y - y) * ws[k];
        us[k] = corners[k].at[0];
        vs[k] = corners[k].at[1];
    }
    put(x_s, xs);
    put(y_s, ys);
    put(w_s, ws);
    of[u] = static_cast<float>(us[0]);
    of[v] = static_cast<float>(vs[0]);
    put(u_s, us);
    put(v_s, vs);
}

void find_quad_places(const placed_quad* quads, const quad_pixels& from, painted_pixels& pixels) {
    L3D_SIMD_CALL(find_quad_places)(quads, from, pixels);
}

} // namespace l3d_detail
#endif
