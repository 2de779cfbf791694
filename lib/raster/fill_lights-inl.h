// SPDX-License-Identifier: MIT
// fill_lights: what a mode needs of polygons' corners, as arrays that can be queued.
#if defined(L3D_RASTER_FILL_LIGHTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_FILL_LIGHTS_INL_H
#undef L3D_RASTER_FILL_LIGHTS_INL_H
#else
#define L3D_RASTER_FILL_LIGHTS_INL_H
#endif

#include "raster/fill_grey-inl.h"
#include "raster/fill_lambert-inl.h"

#include <algorithm>
#include <array>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// Vertices side by side in memory, from one on.
///
/// Shape: `size` elements in each array may be read.
struct vertex_arrays {
    const std::int32_t* x;
    const std::int32_t* y;
    const float* inv_w;
    std::array<const float*, 3> normal;
    std::size_t size;

    /// Of an l3d_micro_grid or a corner of l3d_micro_triangles.
    template <class Arrays> static vertex_arrays from(const Arrays& of, std::size_t at) {
        return {of.x.data() + at,
                of.y.data() + at,
                of.inv_w.data() + at,
                {of.normal[0].data() + at, of.normal[1].data() + at, of.normal[2].data() + at},
                of.x.size() - at};
    }
};

/// The four corners of polygons side by side; the last of a triangle is there twice.
using corner_arrays = std::array<vertex_arrays, 4>;

/// What is queued of the light of each of them; as many elements as of the corner may be read.
template <std::size_t Count> using light_arrays = std::array<std::array<const float*, Count>, 4>;

/// A vector from an array's element `at` on; unless it is all `inside`, zeros behind the end.
template <bool Inside, class D, class T>
HWY_INLINE hn::Vec<D> load_within(D d, const T* array, std::size_t at, std::size_t size) {
    if constexpr (Inside)
        return hn::LoadU(d, array + at);
    HWY_ALIGN T part[hn::MaxLanes(D())] = {};
    std::copy(array + std::min(at, size), array + std::min(at + hn::MaxLanes(D()), size), part);
    return hn::Load(d, part);
}

/// Calls action(std::bool_constant, i) for each vector of `count` elements: whether it is inside of
/// the `size` that may be read, and where it begins.
template <class Action>
HWY_INLINE void for_vectors(std::size_t count, std::size_t size, const Action& action) {
    for (std::size_t i = 0; i < count; i += lanes)
        if (HWY_LIKELY(i + lanes <= size))
            action(std::true_type(), i);
        else
            action(std::false_type(), i);
}

/// The grey level of a cosine, where the normal points to the eye or `away`.
HWY_INLINE float_vec level_of(float_vec cosine, float_vec away) {
    const float_vec zero = hn::Zero(floats()), one = set(1.0f);
    const float_vec turned = hn::IfThenElse(hn::Gt(away, zero), hn::Neg(cosine), cosine);
    const float_vec lit = hn::Min(hn::Max(turned, zero), one);
    return hn::Add(set(25.5f), hn::Mul(set(grey_of_cosine), lit));
}

/// Lambert: every corner's normal.
class normal_lights {
public:
    using lanes_type = lambert_lanes;

    HWY_INLINE explicit normal_lights(const fill_target&) {}

    HWY_INLINE void start(const vertex_arrays&, std::size_t) {}
    HWY_INLINE light_arrays<3> quads(const corner_arrays& v, std::size_t) const {
        return {v[0].normal, v[1].normal, v[2].normal, v[3].normal};
    }
    HWY_INLINE light_arrays<3> triangles(const corner_arrays& v, std::size_t n) const {
        return quads(v, n);
    }
};

/// Gouraud: every vertex's level, made once for a row of vertices.
class vertex_lights {
public:
    using lanes_type = grey_lanes;

    HWY_INLINE explicit vertex_lights(const fill_target& to)
        : shading_(to.shading), third_(to.queue.greys[2]), above_(to.queue.greys[0]),
          below_(to.queue.greys[1]) {}

    /// Before the first row of `count` quads: the vertices above it.
    HWY_INLINE void start(const vertex_arrays& above, std::size_t count) {
        make(above, count + 1, below_);
    }
    /// Expects: rows in their order.
    HWY_INLINE light_arrays<1> quads(const corner_arrays& v, std::size_t count) {
        std::swap(above_, below_);
        make(v[3], count + 1, below_);
        return {{{above_}, {above_ + 1}, {below_ + 1}, {below_}}};
    }
    HWY_INLINE light_arrays<1> triangles(const corner_arrays& v, std::size_t count) const {
        make(v[0], count, above_);
        make(v[1], count, below_);
        make(v[2], count, third_);
        return {{{above_}, {below_}, {third_}, {third_}}};
    }

private:
    HWY_INLINE void make(const vertex_arrays& v, std::size_t count, float* levels) const {
        for_vectors(count, v.size, [&](auto inside, std::size_t i) HWY_ATTR {
            const auto number = [&](const float* array) HWY_ATTR {
                return load_within<inside()>(floats(), array, i, v.size);
            };
            const float_vec normal[3] = {number(v.normal[0]), number(v.normal[1]),
                                         number(v.normal[2])};
            const float_vec away = away_of(shading_, load_within<inside()>(ints(), v.x, i, v.size),
                                           load_within<inside()>(ints(), v.y, i, v.size), normal);
            hn::Store(level_of(lit_of(shading_, normal), away), floats(), levels + i);
        });
    }

    const l3d_shading& shading_;
    float* third_;
    float* above_;
    float* below_;
};

/// Flat: every polygon's level, from the sum of its normals, at all its corners.
class polygon_lights {
public:
    using lanes_type = grey_lanes;

    HWY_INLINE explicit polygon_lights(const fill_target& to)
        : shading_(to.shading), levels_(to.queue.greys[0]) {}

    HWY_INLINE void start(const vertex_arrays&, std::size_t) {}
    HWY_INLINE light_arrays<1> quads(const corner_arrays& v, std::size_t count) const {
        return make<4>(v, count);
    }
    HWY_INLINE light_arrays<1> triangles(const corner_arrays& v, std::size_t count) const {
        return make<3>(v, count);
    }

private:
    template <std::size_t Corners>
    HWY_INLINE light_arrays<1> make(const corner_arrays& v, std::size_t count) const {
        std::size_t size = v[0].size;
        for (std::size_t k = 1; k < Corners; ++k)
            size = std::min(size, v[k].size);
        for_vectors(count, size, [&](auto inside, std::size_t i) HWY_ATTR {
            const floats d;
            float_vec sum[3] = {hn::Zero(d), hn::Zero(d), hn::Zero(d)}, away = hn::Zero(d);
            for (std::size_t k = 0; k < Corners; ++k) {
                float_vec normal[3];
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    normal[axis] = load_within<inside()>(d, v[k].normal[axis], i, v[k].size);
                    sum[axis] = hn::Add(sum[axis], normal[axis]);
                }
                const int_vec x = load_within<inside()>(ints(), v[k].x, i, v[k].size);
                const int_vec y = load_within<inside()>(ints(), v[k].y, i, v[k].size);
                away = hn::Add(away, away_of(shading_, x, y, normal));
            }
            const float_vec square =
                hn::Add(hn::Add(square_of(sum[0]), square_of(sum[1])), square_of(sum[2]));
            const float_vec cosine =
                hn::Div(lit_of(shading_, sum), hn::Sqrt(hn::Max(square, set(least_square))));
            hn::Store(level_of(cosine, away), d, levels_ + i);
        });
        return {{{levels_}, {levels_}, {levels_}, {levels_}}};
    }

    /// Of normals that cancel each other; no light comes of them.
    static constexpr float least_square = 1e-30f;

    const l3d_shading& shading_;
    float* levels_;
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
