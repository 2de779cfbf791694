// SPDX-License-Identifier: MIT
// fill_setup: finds the rows of polygons from their corners, one polygon a lane.
#if defined(L3D_RASTER_SURFACES_FILL_SETUP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_SURFACES_FILL_SETUP_INL_H
#undef L3D_RASTER_SURFACES_FILL_SETUP_INL_H
#else
#define L3D_RASTER_SURFACES_FILL_SETUP_INL_H
#endif

#include "raster/surfaces/fill_table-inl.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// The size of a pixel, in sub-pixels.
constexpr std::int32_t pixel = l3d_subpixel_one;

HWY_INLINE int_vec load(const std::int32_t* p) {
    return hn::LoadU(ints(), p);
}

HWY_INLINE float_vec load_float(const std::int32_t* p) {
    return hn::BitCast(floats(), load(p));
}

HWY_INLINE int_mask mask_of(hn::Mask<floats> mask) {
    return hn::RebindMask(ints(), mask);
}

/// The first pixel whose centre is at or after a position: first_centre of pixel_centres.h, in
/// lanes.
template <class D> HWY_INLINE hn::Vec<D> first_centre_of(D d, hn::Vec<D> position) {
    return hn::ShiftRight<l3d_subpixel_bits>(hn::Add(position, hn::Set(d, pixel / 2 - 1)));
}

HWY_INLINE int_vec cross_of(int_vec ax, int_vec ay, int_vec bx, int_vec by) {
    return hn::Sub(hn::Mul(ax, by), hn::Mul(ay, bx));
}

HWY_INLINE float_vec to_float(int_vec v) {
    return hn::ConvertTo(floats(), v);
}

HWY_INLINE int_vec blend(int_mask yes, int_vec if_yes, int_vec if_no) {
    return hn::IfThenElse(yes, if_yes, if_no);
}

/// Finds floor(n / d) and the remainder, where `inverse` is 1 / d.
/// Expects: d > 0, |n| < 2^30, |n / d| < 2^21.
///
/// The quotient of floats has an error of at most 3 roundings, 3 * 2^-24 * 2^21 < 1/2. Rounding it
/// after subtracting 1/2 adds at most 1/2. So the result is at most one too large or too small, and
/// the remainder shows which.
HWY_INLINE void divide(int_vec n, int_vec d, float_vec inverse, int_vec& quotient,
                       int_vec& remainder) {
    const floats df;
    const float_vec estimate = hn::Mul(to_float(n), inverse);
    const int_vec q = hn::NearestInt(hn::Sub(estimate, hn::Set(df, 0.5f)));
    const int_vec r = hn::Sub(n, hn::Mul(q, d));
    const int_mask less = hn::Lt(r, hn::Zero(ints()));
    const int_mask more = hn::Gt(r, hn::Sub(d, hn::Set(ints(), 1)));
    const int_vec one = hn::Set(ints(), 1);
    quotient = hn::Sub(hn::Add(q, hn::IfThenElseZero(more, one)), hn::IfThenElseZero(less, one));
    remainder = hn::Add(hn::Sub(r, hn::IfThenElseZero(more, d)), hn::IfThenElseZero(less, d));
}

/// One edge of each polygon in a vector, stepped from row to row like Bresenham's line. `column` is
/// exactly the first column whose centre is on the edge's line or right of it.
///
/// An edge also limits the rows above and below it, as a convex polygon lies on one side of the
/// edge's whole line. Where the line is nearly horizontal, the column changes by up to 2^14 a row,
/// and up to 2^20 in all.
struct lane_edge {
    int_vec column, column_step;
    /// `room` is `whole` - 1, less the remainder of the division by `whole` that gives `column`.
    /// `room_step` is the amount by which `room` falls from row to row.
    int_vec room, room_step, whole;
    int_vec left;   ///< all bits set if columns left of the edge are outside, else none
    int_vec beyond; ///< 0 if columns right of the edge are outside, else more than any column

    /// Sets up the edges from a to b.
    /// Units: corners from the centre of pixel (0, 0).
    /// Expects: |corners| <= 2^14 + 2^8.
    HWY_INLINE void set(int_vec ax, int_vec ay, int_vec bx, int_vec by, int_mask clockwise,
                        int_vec row) {
        const ints d;
        const int_mask down = hn::Lt(ay, by);
        const int_mask level = hn::Eq(ay, by);
        const int_mask is_left = hn::AndNot(level, hn::Xor(down, clockwise));
        left = hn::VecFromMask(d, is_left);
        beyond = hn::IfThenElseZero(hn::Or(is_left, level), hn::Set(d, 1 << 24));
        const int_vec ux = blend(down, ax, bx), uy = hn::Min(ay, by);
        const int_vec dx = hn::Sub(blend(down, bx, ax), ux);
        const int_vec dy = hn::Max(hn::Sub(hn::Max(ay, by), uy), hn::Set(d, 1));
        const float_vec inverse = hn::Div(hn::Set(floats(), 1.0f), to_float(dy));

        // ceil(n / whole) = floor((n + whole - 1) / whole)
        whole = hn::ShiftLeft<l3d_subpixel_bits>(dy);
        const int_vec down_to_row = hn::Sub(hn::ShiftLeft<l3d_subpixel_bits>(row), uy);
        const int_vec n = hn::Add(hn::Mul(ux, dy), hn::Mul(dx, down_to_row));
        const int_vec most = hn::Sub(whole, hn::Set(d, 1));
        int_vec rest;
        divide(hn::Add(n, most), whole, hn::Mul(inverse, hn::Set(floats(), 1.0f / pixel)), column,
               rest);
        room = hn::Sub(most, rest);
        divide(dx, dy, inverse, column_step, rest);
        room_step = hn::ShiftLeft<l3d_subpixel_bits>(rest);
    }

    /// Limits the columns [from, to) of a row to the edge's inner side.
    /// Expects: from is not negative.
    HWY_INLINE void limit(int_vec& from, int_vec& to) const {
        from = hn::Max(from, hn::And(left, column));
        to = hn::Min(to, hn::Add(beyond, column));
    }

    HWY_INLINE void step() {
        room = hn::Sub(room, room_step);
        const int_vec over = hn::BroadcastSignBit(room); // -1 if negative
        room = hn::Add(room, hn::And(over, whole));
        column = hn::Sub(hn::Add(column, column_step), over);
    }
};

/// A linear function over a polygon: base + first s + second t. s and t are whole numbers: the
/// cross products of the vector from corner a to the place with the polygon's two differences
/// (lane_frame).
struct lane_plane {
    float_vec base, first, second;

    HWY_INLINE float_vec at(float_vec s, float_vec t) const {
        return hn::Add(base, hn::Add(hn::Mul(s, first), hn::Mul(t, second)));
    }
    HWY_INLINE float_vec along(float_vec s, float_vec t) const {
        return hn::Add(hn::Mul(s, first), hn::Mul(t, second));
    }
};

/// A quadratic function over a polygon. At (s1, t1) it is base + s s1 + t t1 + ss s1^2 + st s1 t1 +
/// tt t1^2.
struct lane_parabola {
    float_vec base, s, t, ss, st, tt;

    HWY_INLINE float_vec at(float_vec s1, float_vec t1) const {
        const float_vec along_s = hn::Add(s, hn::Add(hn::Mul(s1, ss), hn::Mul(t1, st)));
        const float_vec along_t = hn::Add(t, hn::Mul(t1, tt));
        return hn::Add(base, hn::Add(hn::Mul(s1, along_s), hn::Mul(t1, along_t)));
    }

    /// The change of the function over a step by (ds, dt) is slope() at the place, plus square(),
    /// in which the step is squared.
    HWY_INLINE lane_plane slope(float_vec ds, float_vec dt) const {
        const float_vec half_s = half_slope(ss, ds, dt), half_t = half_slope(tt, dt, ds);
        return {hn::Add(hn::Mul(s, ds), hn::Mul(t, dt)), hn::Add(half_s, half_s),
                hn::Add(half_t, half_t)};
    }
    HWY_INLINE float_vec square(float_vec ds, float_vec dt) const {
        return hn::Add(hn::Mul(half_slope(ss, ds, dt), ds), hn::Mul(half_slope(tt, dt, ds), dt));
    }

private:
    HWY_INLINE float_vec half_slope(float_vec own, float_vec step, float_vec other) const {
        return hn::Add(hn::Mul(own, step), hn::Mul(hn::Mul(hn::Set(floats(), 0.5f), st), other));
    }
};

/// The coefficients of a quadratic function over a polygon with corners a, b, c, d:
/// base + y y1 + z z1 + yy y1^2 + yz y1 z1 + zz z1^2. The coordinates (y1, z1) belong to the place
/// mean + y1 (c - a) + z1 (d - b), where mean is the mean of the corners.
struct mean_parabola {
    float_vec base, y, z, yy, yz, zz;
};

/// The coordinates of lane_plane in a polygon. The two differences go from corner a to c and from b
/// to d. Their cross product, area2, is twice the area, also for a triangle, whose d is c.
struct lane_frame {
    float_vec mean_s, mean_t; ///< s and t of the corners' mean, divided by area2
    float_vec inverse;        ///< 1 / area2, where area2 is twice the polygon's area

    HWY_INLINE lane_plane plane(const float_vec (&v)[4]) const {
        const float_vec d1 = hn::Sub(v[2], v[0]), d2 = hn::Sub(v[3], v[1]);
        const float_vec mean =
            hn::Mul(hn::Add(hn::Add(v[0], v[2]), hn::Add(v[1], v[3])), hn::Set(floats(), 0.25f));
        const float_vec base = hn::Sub(mean, hn::Add(hn::Mul(mean_s, d1), hn::Mul(mean_t, d2)));
        return {base, hn::Mul(d1, inverse), hn::Mul(d2, inverse)};
    }

    HWY_INLINE lane_parabola parabola(const mean_parabola& p) const {
        const float_vec yy = hn::Mul(p.yy, mean_s), zz = hn::Mul(p.zz, mean_t);
        const float_vec y = hn::Sub(p.y, hn::Add(yy, hn::Mul(p.yz, mean_t)));
        const float_vec z = hn::Sub(p.z, zz);
        const float_vec square = hn::Mul(inverse, inverse);
        return {hn::Sub(p.base, hn::Add(hn::Mul(mean_s, y), hn::Mul(mean_t, z))),
                hn::Mul(inverse, hn::Sub(y, yy)),
                hn::Mul(inverse, hn::Sub(hn::Sub(z, zz), hn::Mul(p.yz, mean_s))),
                hn::Mul(square, p.yy),
                hn::Mul(square, p.yz),
                hn::Mul(square, p.zz)};
    }
};

/// The corners of a vector of polygons, and the inputs of their light other than normals and greys.
struct lane_places {
    int_vec x[4], y[4]; ///< corners in the picture, in sub-pixels
    lane_frame frame;
    /// The change of s and t from a column of the picture to the next.
    float_vec column_s, column_t;
    int_mask fits, piece; ///< polygons that are filled with this vector, and pieces of quads
    int_mask triangle;    ///< polygons that are triangles: corner d is c again
    /// The distance between the middles of a quad's two diagonals, as a share of the diagonals.
    float_vec uneven;
};

HWY_INLINE float_vec square_of(float_vec v) {
    return hn::Mul(v, v);
}

template <class V> HWY_INLINE V least_of(const V (&v)[4]) {
    return hn::Min(hn::Min(hn::Min(v[0], v[1]), v[2]), v[3]);
}

template <class V> HWY_INLINE V most_of(const V (&v)[4]) {
    return hn::Max(hn::Max(hn::Max(v[0], v[1]), v[2]), v[3]);
}

/// The corners of a vector of polygons in a queue, and the box around each polygon. Units:
/// sub-pixels.
struct lane_corners {
    int_vec x[4], y[4];
    int_vec left, top, right, bottom;

    HWY_INLINE lane_corners(const fill_queue& queue, std::size_t at) {
        for (int i = 0; i < 4; ++i) {
            x[i] = load(queue.corner[i][0] + at);
            y[i] = load(queue.corner[i][1] + at);
        }
        left = least_of(x);
        top = least_of(y);
        right = most_of(x);
        bottom = most_of(y);
    }
};

/// A bound of the error of interpolated numbers that comes from the change of w over a polygon.
/// Units: a share of the difference between the largest and the least number at the corners.
HWY_INLINE float_vec share_of_depth(const fill_table& table) {
    const floats d;
    const float_vec ratio = hn::Div(hn::Load(d, table.nearest.of), hn::Load(d, table.farthest.of));
    return hn::Mul(set(0.25f), hn::Sub(ratio, set(1.0f)));
}

/// Notes the errors of a vector of polygons, as fill_counts keeps them: the largest error up to
/// `most`, and the number of larger errors.
HWY_INLINE void note_errors(float_vec error, double most, float& largest, std::int64_t& unproven) {
    const floats d;
    const auto tight = hn::Le(error, set(static_cast<float>(most)));
    largest = std::max(largest, hn::GetLane(hn::MaxOfLanes(d, hn::IfThenElseZero(tight, error))));
    unproven += static_cast<std::int64_t>(hn::CountTrue(d, hn::Not(tight)));
}

/// The cosine of the angle between a unit normal and the light.
HWY_INLINE float_vec lit_of(const l3d_shading& shading, const float_vec (&normal)[3]) {
    return hn::Add(hn::Add(hn::Mul(normal[0], set(shading.light[0])),
                           hn::Mul(normal[1], set(shading.light[1]))),
                   hn::Mul(normal[2], set(shading.light[2])));
}

/// The product of a normal with the ray from the eye: away_from_eye in lanes, operation by
/// operation.
HWY_INLINE float_vec away_of(const l3d_shading& shading, int_vec place_x, int_vec place_y,
                             const float_vec (&normal)[3]) {
    const float_vec x = hn::Mul(to_float(place_x), set(1.0f / pixel));
    const float_vec y = hn::Mul(to_float(place_y), set(1.0f / pixel));
    float_vec away = hn::Zero(floats());
    for (std::size_t k = 0; k < 3; ++k) {
        const float_vec ray =
            hn::Add(hn::Add(set(shading.ray[k]), hn::Mul(x, set(shading.ray_right[k]))),
                    hn::Mul(y, set(shading.ray_down[k])));
        away = hn::Add(away, hn::Mul(normal[k], ray));
    }
    return away;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
