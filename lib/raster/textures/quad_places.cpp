// SPDX-License-Identifier: MIT
// quad_places: inverts bilinear quads in homogeneous space by Newton's method, in lanes.
#include "raster/textures/quad_places_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/textures/quad_places.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_integers-inl.h"
#include "raster/parallel/lane_pairs-inl.h"
#include "raster/parallel/simd_dispatch_p.h"

#include <algorithm>
#include <array>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE float_vec difference(float_vec a, float_vec b, float_vec c, float_vec d) {
    return hn::Sub(hn::Mul(a, b), hn::Mul(c, d));
}

/// A bilinear function of s and t in each lane, which is 0 at (0, 0).
struct bilinear {
    float_vec s, t, st;

    HWY_INLINE float_vec at(float_vec at_s, float_vec at_t) const {
        return hn::Add(hn::Mul(at_s, hn::Add(s, hn::Mul(at_t, st))), hn::Mul(at_t, t));
    }
    HWY_INLINE float_vec along_s(float_vec at_t) const { return hn::Add(s, hn::Mul(at_t, st)); }
    HWY_INLINE float_vec along_t(float_vec at_s) const { return hn::Add(t, hn::Mul(at_s, st)); }

    /// This function minus `factor` times the function `other`.
    HWY_INLINE bilinear less(float_vec factor, const bilinear& other) const {
        return {hn::Sub(s, hn::Mul(factor, other.s)), hn::Sub(t, hn::Mul(factor, other.t)),
                hn::Sub(st, hn::Mul(factor, other.st))};
    }
};

/// A step of Newton's method. It holds the offset of (w x, w y) at (s, t) from w times the pixel's
/// place. It also holds the derivatives of this offset by s and t, and the inverse of their
/// determinant.
struct lane_map {
    float_vec dx, dy, x_s, x_t, y_s, y_t, over;

    HWY_INLINE lane_map(const bilinear& x, const bilinear& y, float_vec left, float_vec top,
                        float_vec s, float_vec t)
        : dx(hn::Sub(x.at(s, t), left)), dy(hn::Sub(y.at(s, t), top)), x_s(x.along_s(t)),
          x_t(x.along_t(s)), y_s(y.along_s(t)), y_t(y.along_t(s)) {
        const float_vec area = difference(x_s, y_t, x_t, y_s);
        constexpr float least = 1e-20F; // square pixels: less is a line, as far as floats tell
        const auto has_area = hn::Gt(hn::Abs(area), set(least));
        over = hn::IfThenElseZero(has_area,
                                  hn::Div(set(1.0F), hn::IfThenElse(has_area, area, set(1.0F))));
    }
};

/// Clamps a parameter to a range beside the quad, where the map is nearly linear.
HWY_INLINE float_vec between(float_vec v, float least, float most) {
    return hn::Min(hn::Max(v, set(least)), set(most));
}

/// A quad: x, y, w and the places in the texture as bilinear functions of s and t from 0 to 1. x
/// and y are multiplied by w. At (0, 0), w is 1, and x and y are 0.
struct lane_quad {
    float_vec left, top; ///< the way from the quad's corner at (0, 0) to the pixel
    bilinear x, y, w;
    float_vec places[2]; ///< the place in the texture at (0, 0)
    bilinear ways[2];    ///< the change of this place from (0, 0) to (s, t)

    /// Sets x, y and w from the corners at (0, 0), (1, 0), (0, 1) and (1, 1). A triangle's last
    /// corner is not used.
    /// Shape: `xs` and `ys` are relative to the first corner.
    HWY_INLINE void set_corners(const float_vec (&xs)[4], const float_vec (&ys)[4],
                                const float_vec (&inv_w)[4], bool is_triangle) {
        const auto product = [&](int k, float_vec of)
                                 HWY_ATTR { return hn::Mul(of, hn::Div(inv_w[0], inv_w[k])); };
        const auto with = [&](float_vec at_s, float_vec at_t, float_vec at_both) HWY_ATTR {
            return bilinear{at_s, at_t,
                            is_triangle ? hn::Zero(floats())
                                        : hn::Sub(hn::Sub(at_both, at_t), at_s)};
        };
        x = with(product(1, xs[1]), product(2, xs[2]), product(3, xs[3]));
        y = with(product(1, ys[1]), product(2, ys[2]), product(3, ys[3]));
        const auto more = [&](int k) HWY_ATTR { return hn::Sub(product(k, set(1.0F)), set(1.0F)); };
        w = with(more(1), more(2), more(3));
    }
};

/// Arrays for pixels' places in the texture, and for the changes from these to the places of the
/// pixels on the right and below.
struct place_rows {
    float *u, *v, *u_right, *v_right, *u_down, *v_down;
};

/// Finds the places of the texture that pixels show, and the changes from these places to the
/// places of the next pixels. Pixels outside of `shown` get changes of 0.
HWY_INLINE void put_places(const lane_quad& quad, hn::Mask<floats> shown, const place_rows& to) {
    const bilinear x = quad.x.less(quad.left, quad.w), y = quad.y.less(quad.top, quad.w);
    float_vec s = set(0.5F), t = set(0.5F);
    // The map is linear except for its terms in s t. The first step leaves an error in proportion
    // to these terms. A later step of length h leaves an error of about h^2 times these terms.
    const auto step = [&](hn::Mask<floats> moved) HWY_ATTR {
        const lane_map map(x, y, quad.left, quad.top, s, t);
        constexpr float beside = 0.25F; // how far a step may go beyond the quad
        const float_vec down = hn::Mul(difference(map.y_t, map.dx, map.x_t, map.dy), map.over);
        const float_vec across = hn::Mul(difference(map.x_s, map.dy, map.y_s, map.dx), map.over);
        s = hn::IfThenElse(moved, between(hn::Sub(s, down), -beside, 1 + beside), s);
        t = hn::IfThenElse(moved, between(hn::Sub(t, across), -beside, 1 + beside), t);
        return hn::Max(hn::Abs(down), hn::Abs(across));
    };
    const auto all = hn::Eq(s, s);
    step(all);
    // After a step of 1/16, the error is 1/256 of these terms, which are no more than some pixels.
    const auto is_rough = hn::Gt(step(all), set(1.0F / 16));
    if (!hn::AllFalse(floats(), is_rough))
        step(is_rough);
    s = between(s, 0, 1);
    t = between(t, 0, 1);
    // If the pixel moves by 1, w x or w y changes by w.
    const lane_map map(x, y, quad.left, quad.top, s, t);
    const float_vec per_pixel =
        hn::IfThenElseZero(shown, hn::Mul(map.over, hn::Add(set(1.0F), quad.w.at(s, t))));
    const auto put = [&](std::size_t axis, float* place, float* right, float* below) HWY_ATTR {
        const bilinear& of = quad.ways[axis];
        const float_vec of_s = hn::Mul(per_pixel, of.along_s(t));
        const float_vec of_t = hn::Mul(per_pixel, of.along_t(s));
        hn::StoreU(hn::Add(quad.places[axis], of.at(s, t)), floats(), place);
        hn::StoreU(difference(of_s, map.y_t, of_t, map.y_s), floats(), right);
        hn::StoreU(difference(of_t, map.x_s, of_s, map.x_t), floats(), below);
    };
    put(0, to.u, to.u_right, to.u_down);
    put(1, to.v, to.v_right, to.v_down);
}

/// A grid's vertices, and the map from parameters to the texture.
class lane_grid {
public:
    HWY_INLINE lane_grid(const painted_part& part, const float* parameters)
        : part_(part), columns_(parameters + part.columns), rows_(parameters + part.rows),
          pitch_(part.part->grid.pitch) {}

    /// The quads of some pixels. Expects: indices of the quads' first corners.
    HWY_INLINE lane_quad quad(int_vec index, float_vec x, float_vec y) const {
        const l3d_micro_grid& grid = part_.part->grid;
        const int_vec begins[2] = {index, hn::Add(index, set(pitch_))};
        lane_quad result;
        float_vec xs[4], ys[4], inv_w[4];
        for (std::size_t k = 0; k < 4; k += 2) {
            const lane_pairs of_x(ints(), grid.x.data(), begins[k / 2]);
            const lane_pairs of_y(ints(), grid.y.data(), begins[k / 2]);
            const lane_pairs of_inv_w(floats(), grid.inv_w.data(), begins[k / 2]);
            xs[k] = pixels_of(of_x.first);
            xs[k + 1] = pixels_of(of_x.second);
            ys[k] = pixels_of(of_y.first);
            ys[k + 1] = pixels_of(of_y.second);
            inv_w[k] = of_inv_w.first;
            inv_w[k + 1] = of_inv_w.second;
        }
        result.left = hn::Sub(x, xs[0]);
        result.top = hn::Sub(y, ys[0]);
        for (std::size_t k = 4; k-- > 0;) {
            xs[k] = hn::Sub(xs[k], xs[0]);
            ys[k] = hn::Sub(ys[k], ys[0]);
        }
        result.set_corners(xs, ys, inv_w, false);
        put_ways(index, result);
        return result;
    }

private:
    /// Converts places from 1/256 pixel to pixels. Places are below 2^15 pixels, so floats hold
    /// them exactly.
    static HWY_INLINE float_vec pixels_of(int_vec place) {
        return hn::Mul(hn::ConvertTo(floats(), place), set(1.0F / l3d_subpixel_one));
    }

    /// Sets the texture places of quads, and their changes, from the rows and columns of the first
    /// corners.
    ///
    /// Rows begin at multiples of 16 m vertices, for a whole m. With n = floor(index / 16), the
    /// quotient (n + 1/2) / m is at least 1/(2 m) away from any whole number. So floats round it
    /// down to the right row for n below 2^20.
    HWY_INLINE void put_ways(int_vec index, lane_quad& to) const {
        const float_vec sixteenth =
            hn::Add(hn::ConvertTo(floats(), hn::ShiftRight<4>(index)), set(0.5F));
        const int_vec row =
            hn::ConvertTo(ints(), hn::Mul(sixteenth, set(16.0F / static_cast<float>(pitch_))));
        const int_vec column = hn::Sub(index, hn::Mul(row, set(pitch_)));
        const lane_pairs us(floats(), columns_, column), vs(floats(), rows_, row);
        const float_vec u = us.first, du = hn::Sub(us.second, u);
        const float_vec v = vs.first, dv = hn::Sub(vs.second, v);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const near_map& near = part_.near;
            const float_vec both = set(near.along_both[axis]);
            const float_vec along_u = hn::Add(set(near.along_u[axis]), hn::Mul(v, both));
            const float_vec along_v = set(near.along_v[axis]);
            to.places[axis] =
                hn::Add(set(near.at[axis]), hn::Add(hn::Mul(u, along_u), hn::Mul(v, along_v)));
            to.ways[axis] = {hn::Mul(du, along_u), hn::Mul(dv, hn::Add(along_v, hn::Mul(u, both))),
                             hn::Mul(hn::Mul(du, dv), both)};
        }
    }

    const painted_part& part_;
    const float *columns_, *rows_;
    std::int32_t pitch_;
};

part_run find_quad_places(const painted_part& part, const float* parameters,
                          const named_pixels& from, std::size_t begin, painted_pixels& pixels) {
    const auto quads = static_cast<std::int32_t>(painted_part::quads(*part.part));
    const auto all = quads + static_cast<std::int32_t>(part.part->triangles.count);
    const lane_grid grid(part, parameters);
    const auto left = static_cast<float>(from.x), y = static_cast<float>(from.y);
    part_run result;
    for (result.end = begin; result.end < from.count;) {
        const std::size_t i = result.end;
        const int_vec name =
            hn::LoadU(ints(), reinterpret_cast<const std::int32_t*>(&from.names[i]));
        const int_vec index = hn::Sub(name, set(static_cast<std::int32_t>(part.first)));
        const int_vec zero = hn::Zero(ints());
        const auto is_of_part = hn::AndNot(hn::Lt(index, zero), hn::Lt(index, set(all)));
        const auto is_quad = hn::And(is_of_part, hn::Lt(index, set(quads)));
        const auto is_other = hn::Not(hn::Or(is_of_part, hn::Lt(name, zero)));
        const float_vec x = hn::Add(hn::Iota(floats(), static_cast<float>(i)), set(left));
        put_places(grid.quad(hn::IfThenElseZero(is_quad, index), x, set(y)),
                   hn::RebindMask(floats(), is_quad),
                   {&pixels.u[i], &pixels.v[i], &pixels.u_right[i], &pixels.v_right[i],
                    &pixels.u_down[i], &pixels.v_down[i]});
        result.has_triangles =
            result.has_triangles || !hn::AllFalse(ints(), hn::AndNot(is_quad, is_of_part));
        if (!hn::AllFalse(ints(), is_other)) {
            result.end += static_cast<std::size_t>(hn::FindFirstTrue(ints(), is_other));
            return result;
        }
        result.end += hn::Lanes(ints());
    }
    result.end = std::min(result.end, from.count);
    return result;
}

void put_triangle_place(const seen_triangle& of, std::size_t pixel, painted_pixels& pixels) {
    lane_quad quad;
    quad.left = set(of.left);
    quad.top = set(of.top);
    const auto corners = [](const std::array<float, 3>& numbers, float_vec(&to)[4]) HWY_ATTR {
        for (std::size_t k = 0; k < 4; ++k)
            to[k] = set(numbers[k % 3]);
    };
    float_vec xs[4], ys[4], inv_w[4];
    corners(of.x, xs);
    corners(of.y, ys);
    corners(of.inv_w, inv_w);
    quad.set_corners(xs, ys, inv_w, true);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const float at = of.places[0][axis];
        quad.places[axis] = set(at);
        quad.ways[axis] = {set(of.places[1][axis] - at), set(of.places[2][axis] - at), set(0.0F)};
    }
    std::array<std::array<float, lanes>, 6> rows{};
    auto& [u, v, u_right, v_right, u_down, v_down] = rows;
    put_places(quad, hn::Eq(set(0.0F), set(0.0F)),
               {u.data(), v.data(), u_right.data(), v_right.data(), u_down.data(), v_down.data()});
    pixels.u[pixel] = u[0];
    pixels.v[pixel] = v[0];
    pixels.u_right[pixel] = u_right[0];
    pixels.v_right[pixel] = v_right[0];
    pixels.u_down[pixel] = u_down[0];
    pixels.v_down[pixel] = v_down[0];
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(find_quad_places);
L3D_SIMD_TABLE(put_triangle_place);

namespace {

/// The map from parameters to the texture, relative to the parameters `origin`. Places are moved by
/// whole periods of the texture, which changes nothing that is seen. So floats can hold fractions
/// of the texture's pixels.
near_map map_about(const picture_map& map, const l3d_patch_parameters& origin,
                   const l3d_texture& texture) {
    const picture_map::place at = map.at(origin);
    near_map result;
    for (std::size_t i = 0; i < 2; ++i) {
        const l3d_texture_wrap wrap = i == 0 ? texture.wrap_u() : texture.wrap_v();
        result.at[i] = static_cast<float>(place_near_zero(at[i], wrap));
        result.along_u[i] = static_cast<float>(map.along_u[i] + origin.v * map.along_both[i]);
        result.along_v[i] = static_cast<float>(map.along_v[i] + origin.u * map.along_both[i]);
        result.along_both[i] = static_cast<float>(map.along_both[i]);
    }
    return result;
}

} // namespace

void painted_parts::add(painted_part of, std::span<const double> u, std::span<const double> v) {
    if (!u.empty() && !v.empty())
        of.origin = {u.front(), v.front()};
    of.near = map_about(of.map, of.origin, *of.texture);
    const auto put = [&](std::span<const double> from, double origin) {
        const std::size_t begin = parameters.size();
        for (const double parameter : from)
            parameters.push_back(static_cast<float>(parameter - origin));
        return begin;
    };
    of.columns = put(u, of.origin.u);
    of.rows = put(v, of.origin.v);
    all.push_back(of);
}

part_run find_quad_places(const painted_part& part, const float* parameters,
                          const named_pixels& from, std::size_t begin, painted_pixels& pixels) {
    return L3D_SIMD_CALL(find_quad_places)(part, parameters, from, begin, pixels);
}

void find_triangle_place(const painted_part& part, std::size_t triangle, double x, double y,
                         std::size_t pixel, painted_pixels& pixels) {
    seen_triangle of{};
    const l3d_micro_vertex first = part.part->triangles.vertex(triangle, 0);
    const auto pixels_from = [](std::int32_t from, std::int32_t to) {
        return static_cast<float>(to - from) / l3d_subpixel_one;
    };
    of.left = static_cast<float>(x) - static_cast<float>(first.x) / l3d_subpixel_one;
    of.top = static_cast<float>(y) - static_cast<float>(first.y) / l3d_subpixel_one;
    for (std::size_t k = 0; k < 3; ++k) {
        const l3d_micro_vertex corner = part.part->triangles.vertex(triangle, k);
        of.x[k] = pixels_from(first.x, corner.x);
        of.y[k] = pixels_from(first.y, corner.y);
        of.inv_w[k] = corner.inv_w;
        const l3d_patch_parameters& at = part.triangles[k][triangle];
        const auto u = static_cast<float>(at.u - part.origin.u);
        const auto v = static_cast<float>(at.v - part.origin.v);
        const near_map& near = part.near;
        for (std::size_t i = 0; i < 2; ++i)
            of.places[k][i] =
                near.at[i] + u * (near.along_u[i] + v * near.along_both[i]) + v * near.along_v[i];
    }
    L3D_SIMD_CALL(put_triangle_place)(of, pixel, pixels);
}

} // namespace l3d_detail
#endif
