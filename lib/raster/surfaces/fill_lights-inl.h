// SPDX-License-Identifier: MIT
// fill_lights: makes arrays of the numbers that a mode needs for the light at corners, for the
// queue.
#if defined(L3D_RASTER_SURFACES_FILL_LIGHTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_SURFACES_FILL_LIGHTS_INL_H
#undef L3D_RASTER_SURFACES_FILL_LIGHTS_INL_H
#else
#define L3D_RASTER_SURFACES_FILL_LIGHTS_INL_H
#endif

#include "raster/surfaces/fill_grey-inl.h"
#include "raster/surfaces/fill_lambert-inl.h"
#include "raster/surfaces/fill_levels-inl.h"
#include "raster/surfaces/fill_normals-inl.h"

#include <algorithm>
#include <array>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// The arrays that hold vertices which are neighbours in memory.
///
/// Shape: `size` elements of each array may be read.
struct vertex_arrays {
    const std::int32_t* x;
    const std::int32_t* y;
    const float* inv_w;
    std::array<const float*, 3> normal;
    std::size_t size;

    /// Takes the arrays of an l3d_micro_grid, or of a corner of a block of l3d_micro_triangles.
    template <class Arrays>
    explicit vertex_arrays(const Arrays& of)
        : x(of.x.data()), y(of.y.data()),
          inv_w(of.inv_w.data()), normal{of.normal[0].data(), of.normal[1].data(),
                                         of.normal[2].data()},
          size(of.x.size()) {}
};

/// The arrays of the four corners of neighbouring polygons. A triangle has its last corner twice.
using corner_arrays = std::array<vertex_arrays, 4>;

/// For each of the four corners, the index of the first polygon's corner in its arrays.
using corner_places = std::array<std::size_t, 4>;

/// The numbers of the corners' light that the queue takes, in arrays. Each array may be read to the
/// same element as the corners' arrays (vertex_arrays::size).
template <std::size_t Count> struct light_arrays {
    std::array<std::array<const float*, Count>, 4> of;
    corner_places at;
};

/// Loads a vector of an array's elements from `at` on. If `Inside` is false, lanes beyond `size`
/// are zero.
template <bool Inside, class D, class T>
HWY_INLINE hn::Vec<D> load_within(D d, const T* array, std::size_t at, std::size_t size) {
    if constexpr (Inside)
        return hn::LoadU(d, array + at);
    HWY_ALIGN T part[hn::MaxLanes(D())] = {};
    std::copy(array + std::min(at, size), array + std::min(at + hn::MaxLanes(D()), size), part);
    return hn::Load(d, part);
}

/// Calls action(std::bool_constant, i) for each vector of `count` elements. The first argument
/// tells whether the vector is inside of the `size` that may be read; i is its first element.
template <class Action>
HWY_INLINE void for_vectors(std::size_t count, std::size_t size, const Action& action) {
    for (std::size_t i = 0; i < count; i += lanes)
        if (HWY_LIKELY(i + lanes <= size))
            action(std::true_type(), i);
        else
            action(std::false_type(), i);
}

/// The grey level for the cosine between a normal and the light. Where `away` is positive, the
/// normal points away from the eye, so the cosine's sign is turned.
HWY_INLINE float_vec level_of(float_vec cosine, float_vec away) {
    const float_vec zero = hn::Zero(floats()), one = set(1.0f);
    const float_vec turned = hn::IfThenElse(hn::Gt(away, zero), hn::Neg(cosine), cosine);
    const float_vec lit = hn::Min(hn::Max(turned, zero), one);
    return hn::Add(set(25.5f), hn::Mul(set(grey_of_cosine), lit));
}

/// The lanes whose quads turn to the right in the picture. The result may be wrong for quads that
/// are too large for the lanes.
template <class D>
HWY_INLINE hn::Mask<D> turns_right(D, const hn::Vec<D> (&x)[4], const hn::Vec<D> (&y)[4]) {
    return hn::Gt(hn::Mul(hn::Sub(x[2], x[0]), hn::Sub(y[3], y[1])),
                  hn::Mul(hn::Sub(y[2], y[0]), hn::Sub(x[3], x[1])));
}

/// The normals of a vector of vertices, and the results of away_from_eye for them.
struct lane_normals {
    float_vec normal[3], away;

    template <bool Inside>
    HWY_INLINE void load(const vertex_arrays& v, std::size_t at, const l3d_shading& shading) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            normal[axis] = load_within<Inside>(floats(), v.normal[axis], at, v.size);
        away = away_of(shading, load_within<Inside>(ints(), v.x, at, v.size),
                       load_within<Inside>(ints(), v.y, at, v.size), normal);
    }
};

/// Whether the normals of quads point away from the eye, in a grid that shows both sides: 1 or 0.
template <bool Inside>
HWY_INLINE float_vec away_of_quads(const corner_arrays& v, const corner_places& at, std::size_t i) {
    int_vec x[4], y[4];
    for (std::size_t k = 0; k < 4; ++k) {
        x[k] = load_within<Inside>(ints(), v[k].x, at[k] + i, v[k].size);
        y[k] = load_within<Inside>(ints(), v[k].y, at[k] + i, v[k].size);
    }
    return hn::IfThenElseZero(hn::RebindMask(floats(), turns_right(ints(), x, y)), set(1.0f));
}

/// The light of corners in modes that interpolate the vertices' own numbers: normals, or levels and
/// bends.
template <class Lanes> class corner_lights {
public:
    using lanes_type = Lanes;

    HWY_INLINE corner_lights(const fill_target&, const float*) {}

    HWY_INLINE light_arrays<3> quads(const corner_arrays& v, const corner_places& at, std::size_t,
                                     bool) const {
        return {{v[0].normal, v[1].normal, v[2].normal, v[3].normal}, at};
    }
    HWY_INLINE light_arrays<3> triangles(const corner_arrays& v, std::size_t first,
                                         std::size_t count) const {
        return quads(v, {first, first, first, first}, count, false);
    }
};

using normal_lights = corner_lights<lambert_lanes>;
using later_lights = corner_lights<normal_lanes>;
using level_lights = corner_lights<level_lanes>;

/// Finds the grey levels of `count` vertices from index `at` on. Expects: room for whole vectors.
HWY_INLINE void make_levels(const l3d_shading& shading, const vertex_arrays& v, std::size_t at,
                            std::size_t count, float* levels) {
    for_vectors(count, v.size - at, [&](auto inside, std::size_t i) HWY_ATTR {
        lane_normals n;
        n.load<inside()>(v, at + i, shading);
        hn::StoreU(level_of(lit_of(shading, n.normal), n.away), floats(), levels + i);
    });
}

/// The light of corners in mode `gouraud`: each vertex's grey level. The levels of a grid's
/// vertices are made before its quads are filled.
class vertex_lights {
public:
    using lanes_type = grey_lanes;

    HWY_INLINE vertex_lights(const fill_target& to, const float* of_grid)
        : to_(to), of_grid_(of_grid) {}

    HWY_INLINE light_arrays<1> quads(const corner_arrays& v, const corner_places& at,
                                     std::size_t count, bool shows_both) const {
        if (!shows_both)
            return {{{{of_grid_}, {of_grid_}, {of_grid_}, {of_grid_}}}, at};
        auto& levels = to_.queue.greys;
        for_vectors(count, v[3].size - at[2], [&](auto inside, std::size_t i) HWY_ATTR {
            lane_normals n;
            const float_vec away = away_of_quads<inside()>(v, at, i);
            for (std::size_t k = 0; k < 4; ++k) {
                n.load<inside()>(v[k], at[k] + i, to_.shading);
                hn::StoreU(level_of(lit_of(to_.shading, n.normal), away), floats(), levels[k] + i);
            }
        });
        return {{{{levels[0]}, {levels[1]}, {levels[2]}, {levels[3]}}}, {}};
    }
    HWY_INLINE light_arrays<1> triangles(const corner_arrays& v, std::size_t first,
                                         std::size_t count) const {
        auto& levels = to_.queue.greys;
        for (std::size_t k = 0; k < 3; ++k)
            make_levels(to_.shading, v[k], first, count, levels[k]);
        return {{{{levels[0]}, {levels[1]}, {levels[2]}, {levels[2]}}}, {}};
    }

private:
    const fill_target& to_;
    const float* of_grid_;
};

/// The light of corners in mode `flat`: all corners of a polygon have the grey level of the sum of
/// their normals.
class polygon_lights {
public:
    using lanes_type = grey_lanes;

    HWY_INLINE polygon_lights(const fill_target& to, const float*)
        : shading_(to.shading), levels_(to.queue.greys[0]) {}

    HWY_INLINE light_arrays<1> quads(const corner_arrays& v, const corner_places& at,
                                     std::size_t count, bool shows_both) const {
        return make<4>(v, at, count, shows_both);
    }
    HWY_INLINE light_arrays<1> triangles(const corner_arrays& v, std::size_t first,
                                         std::size_t count) const {
        return make<3>(v, {first, first, first, first}, count, false);
    }

private:
    template <std::size_t Corners>
    HWY_INLINE light_arrays<1> make(const corner_arrays& v, const corner_places& at,
                                    std::size_t count, bool shows_both) const {
        std::size_t size = v[0].size - at[0];
        for (std::size_t k = 1; k < Corners; ++k)
            size = std::min(size, v[k].size - at[k]);
        for_vectors(count, size, [&](auto inside, std::size_t i) HWY_ATTR {
            lane_normals sum, n;
            sum.load<inside()>(v[0], at[0] + i, shading_);
            for (std::size_t k = 1; k < Corners; ++k) {
                n.load<inside()>(v[k], at[k] + i, shading_);
                for (std::size_t axis = 0; axis < 3; ++axis)
                    sum.normal[axis] = hn::Add(sum.normal[axis], n.normal[axis]);
                sum.away = hn::Add(sum.away, n.away);
            }
            const float_vec square =
                hn::Add(hn::Add(square_of(sum.normal[0]), square_of(sum.normal[1])),
                        square_of(sum.normal[2]));
            const float_vec length = hn::Sqrt(hn::Max(square, set(least_square)));
            const float_vec cosine = hn::Div(lit_of(shading_, sum.normal), length);
            if (shows_both)
                sum.away = away_of_quads<inside()>(v, at, i);
            hn::Store(level_of(cosine, sum.away), floats(), levels_ + i);
        });
        return {{{{levels_}, {levels_}, {levels_}, {levels_}}}, {}};
    }

    /// A lower bound of the squared length of a sum of normals. If the normals cancel each other,
    /// the polygon gets only ambient light.
    static constexpr float least_square = 1e-30f;

    const l3d_shading& shading_;
    float* levels_;
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
