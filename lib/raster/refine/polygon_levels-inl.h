// SPDX-License-Identifier: MIT
// polygon_levels: levels of light inside polygons, a place a lane.
#if defined(L3D_RASTER_REFINE_POLYGON_LEVELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_REFINE_POLYGON_LEVELS_INL_H
#undef L3D_RASTER_REFINE_POLYGON_LEVELS_INL_H
#else
#define L3D_RASTER_REFINE_POLYGON_LEVELS_INL_H
#endif

#include "raster/parallel/lane_integers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE float_vec set(float value) {
    return hn::Set(floats(), value);
}

HWY_INLINE float_vec within(float_vec v) {
    return hn::Min(hn::Max(v, hn::Zero(floats())), set(1.0f));
}

/// The levels at the corners of quads or triangles, and what sides bend by. A triangle's last
/// corner is there twice. Places are parts s, t of the diagonals from the mean of the corners.
struct polygon_levels {
    float_vec corner[4];
    float_vec ab, ad, bc, dc;

    /// The bilinear map of a quad's corners' levels, and its sides' bends, at the parameters that a
    /// parallelogram would have. As level_lanes, for one place.
    HWY_INLINE float_vec of_quad(float_vec s, float_vec t) const {
        const float_vec half = set(0.5f), one = set(1.0f), four = set(4.0f);
        const float_vec u = within(hn::Add(half, hn::Sub(s, t)));
        const float_vec v = within(hn::Add(half, hn::Add(s, t)));
        const float_vec u1 = hn::Sub(one, u), v1 = hn::Sub(one, v);
        const float_vec low = hn::Add(hn::Mul(u1, corner[0]), hn::Mul(u, corner[1]));
        const float_vec high = hn::Add(hn::Mul(u1, corner[3]), hn::Mul(u, corner[2]));
        const float_vec of_u =
            hn::Mul(hn::Mul(four, hn::Mul(u, u1)), hn::Add(hn::Mul(v1, ab), hn::Mul(v, dc)));
        const float_vec of_v =
            hn::Mul(hn::Mul(four, hn::Mul(v, v1)), hn::Add(hn::Mul(u1, ad), hn::Mul(u, bc)));
        return hn::Add(hn::Add(hn::Mul(v1, low), hn::Mul(v, high)), hn::Add(of_u, of_v));
    }

    /// The parabola through a triangle's corners and the middles of its sides. With d = c, the
    /// place is (1/4 - s) a + (1/4 - t) b + (1/2 + s + t) c.
    HWY_INLINE float_vec of_triangle(float_vec s, float_vec t) const {
        const float_vec b = within(hn::Sub(set(0.25f), t));
        const float_vec c = within(hn::Add(set(0.5f), hn::Add(s, t)));
        const float_vec a = hn::Sub(hn::Sub(set(1.0f), b), c);
        const float_vec bends =
            hn::Add(hn::Mul(hn::Mul(a, b), ab),
                    hn::Add(hn::Mul(hn::Mul(a, c), ad), hn::Mul(hn::Mul(b, c), bc)));
        return hn::Add(hn::Add(hn::Mul(a, corner[0]), hn::Mul(b, corner[1])),
                       hn::Add(hn::Mul(c, corner[2]), hn::Mul(set(4.0f), bends)));
    }
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
