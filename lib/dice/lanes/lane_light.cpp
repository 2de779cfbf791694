// SPDX-License-Identifier: MIT
// normals_in_lanes, levels_in_lanes: make normals and levels of a grid's vertices in SIMD lanes.
#include "dice/lanes/lane_light_p.h"

#include "dice/facing_fix.h"
#include "scene/bends/surface_bends.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dice/lanes/lane_light.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using doubles = hn::CappedTag<double, lane_columns>;

/// Values of the Bernstein polynomials of degree 5 at a grid's parameters: [polynomial][parameter].
struct quintic_weights {
    static constexpr std::size_t order = 6;
    alignas(64) float at[order][lane_parameters::room];

    HWY_ATTR explicit quintic_weights(const lane_parameters& parameters) {
        const doubles d;
        const hn::Rebind<float, doubles> df;
        const auto five = hn::Set(d, 5.0), ten = hn::Set(d, 10.0);
        // The end of the last whole vector of floats.
        const std::size_t end =
            hwy::RoundUpTo(parameters.count, hn::Lanes(hn::CappedTag<float, lane_columns>()));
        for (std::size_t i = 0; i < end; i += hn::Lanes(d)) {
            const auto t = hn::Load(d, parameters.at + i), s = hn::Sub(hn::Set(d, 1.0), t);
            const auto s2 = hn::Mul(s, s), t2 = hn::Mul(t, t);
            const auto s4 = hn::Mul(s2, s2), t4 = hn::Mul(t2, t2);
            const auto st10 = hn::Mul(ten, hn::Mul(s2, t2));
            hn::Store(hn::DemoteTo(df, hn::Mul(s4, s)), df, at[0] + i);
            hn::Store(hn::DemoteTo(df, hn::Mul(five, hn::Mul(s4, t))), df, at[1] + i);
            hn::Store(hn::DemoteTo(df, hn::Mul(st10, s)), df, at[2] + i);
            hn::Store(hn::DemoteTo(df, hn::Mul(st10, t)), df, at[3] + i);
            hn::Store(hn::DemoteTo(df, hn::Mul(five, hn::Mul(t4, s))), df, at[4] + i);
            hn::Store(hn::DemoteTo(df, hn::Mul(t4, t)), df, at[5] + i);
        }
    }
};

using floats = hn::CappedTag<float, lane_columns>;
using float_lanes = hn::Vec<floats>;

using six_lanes = std::array<float_lanes, quintic_weights::order>;

/// Six vectors: at(0) to at(5).
template <class At> HWY_ATTR HWY_INLINE six_lanes six_of(const At& at) {
    return {at(0), at(1), at(2), at(3), at(4), at(5)};
}

HWY_ATTR HWY_INLINE float_lanes weighed(const six_lanes& a, const six_lanes& b) {
    const auto low =
        hn::Add(hn::Add(hn::Mul(a[0], b[0]), hn::Mul(a[1], b[1])), hn::Mul(a[2], b[2]));
    const auto high =
        hn::Add(hn::Add(hn::Mul(a[3], b[3]), hn::Mul(a[4], b[4])), hn::Mul(a[5], b[5]));
    return hn::Add(low, high);
}

using normal_lanes = std::array<float_lanes, 3>;

HWY_ATTR HWY_INLINE float_lanes dot(const normal_lanes& a, const normal_lanes& b) {
    return hn::Add(hn::Add(hn::Mul(a[0], b[0]), hn::Mul(a[1], b[1])), hn::Mul(a[2], b[2]));
}

HWY_ATTR HWY_INLINE normal_lanes direction_of(const std::array<float, 3>& v) {
    const floats d;
    return {hn::Set(d, v[0]), hn::Set(d, v[1]), hn::Set(d, v[2])};
}

/// 1 / length of normals, or 0 where a normal may be rounding alone.
HWY_ATTR HWY_INLINE float_lanes over_length(const normal_lanes& n) {
    const floats d;
    const auto square = dot(n, n), rounding = hn::Set(d, normal_rounding * normal_rounding);
    return hn::IfThenElseZero(hn::Gt(square, rounding),
                              hn::Div(hn::Set(d, 1.0F), hn::Sqrt(square)));
}

/// The normals along a vector of columns of a grid: Bernstein coefficients along v.
struct net_columns {
    static constexpr std::size_t order = quintic_weights::order;
    alignas(64) float at[3][order][lane_columns];

    net_columns() {} // no zeros, which take as long as a row of vertices: cut() sets the numbers

    HWY_ATTR HWY_INLINE void cut(const l3d_normal_net::float_net& net, const quintic_weights& in_u,
                                 std::size_t column) {
        const floats d;
        const auto weights =
            six_of([&](std::size_t i) HWY_ATTR { return hn::Load(d, in_u.at[i] + column); });
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t r = 0; r < order; ++r) {
                const auto& a = net[k][r];
                const auto row = six_of([&](std::size_t i) HWY_ATTR { return hn::Set(d, a[i]); });
                hn::Store(weighed(row, weights), d, at[k][r]);
            }
    }

    HWY_ATTR HWY_INLINE normal_lanes normals(const quintic_weights& in_v, std::size_t row) const {
        const floats d;
        const auto weights =
            six_of([&](std::size_t i) HWY_ATTR { return hn::Set(d, in_v.at[i][row]); });
        const auto component = [&](const float(&a)[order][lane_columns]) HWY_ATTR {
            const auto column = six_of([&](std::size_t i) HWY_ATTR { return hn::Load(d, a[i]); });
            return weighed(column, weights);
        };
        return {component(at[0]), component(at[1]), component(at[2])};
    }
};

/// The rays from the eye to vertices of a grid, by which normals are turned to the eye.
class eye_rays {
public:
    HWY_ATTR HWY_INLINE explicit eye_rays(const l3d_shading& shading)
        : ray_(direction_of(shading.ray)), right_(direction_of(shading.ray_right)),
          down_(direction_of(shading.ray_down)) {}

    /// How far normals point away from the eye. The operations are those of l3d_away_from_eye in
    /// the same order, so that results agree bit for bit.
    HWY_ATTR HWY_INLINE float_lanes away(const normal_lanes& n, const l3d_micro_grid& grid,
                                         std::size_t at) const {
        const floats d;
        const hn::Rebind<std::int32_t, floats> di;
        const auto pixels = hn::Set(d, 1.0F / l3d_subpixel_one);
        const auto x = hn::Mul(hn::ConvertTo(d, hn::LoadU(di, grid.x.data() + at)), pixels);
        const auto y = hn::Mul(hn::ConvertTo(d, hn::LoadU(di, grid.y.data() + at)), pixels);
        auto sum = hn::Zero(d);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto ray = hn::Add(hn::Add(ray_[k], hn::Mul(x, right_[k])), hn::Mul(y, down_[k]));
            sum = hn::Add(sum, hn::Mul(n[k], ray));
        }
        return sum;
    }

private:
    normal_lanes ray_, right_, down_;
};

/// Calls the writer for all vertices of a grid. Goes through one vector of columns after another,
/// each from top to bottom.
template <class Writer>
HWY_ATTR HWY_INLINE void for_vertices(const lane_parameters& u, const lane_parameters& v,
                                      const l3d_micro_grid& grid, Writer& writer) {
    for (std::size_t column = 0; column < u.count; column += hn::Lanes(floats())) {
        std::size_t at = column;
        writer.begin(column);
        for (std::size_t row = 0; row < v.count; ++row, at += static_cast<std::size_t>(grid.pitch))
            writer.vertex(row, at);
    }
}

struct normal_writer {
    const l3d_normal_net::float_net& net;
    const quintic_weights &in_u, &in_v;
    const eye_rays& rays;
    l3d_micro_grid& grid;
    float* away;
    net_columns columns;

    HWY_ATTR HWY_INLINE void begin(std::size_t column) { columns.cut(net, in_u, column); }
    HWY_ATTR HWY_INLINE void vertex(std::size_t row, std::size_t at) {
        const floats d;
        normal_lanes n = columns.normals(in_v, row);
        const auto scale = over_length(n);
        for (std::size_t k = 0; k < 3; ++k) {
            n[k] = hn::Mul(n[k], scale);
            hn::StoreU(n[k], d, grid.normal[k].data() + at);
        }
        hn::StoreU(rays.away(n, grid, at), d, away + at);
    }
};

HWY_ATTR void normals(const l3d_normal_net::float_net& net, const lane_parameters& u,
                      const lane_parameters& v, const l3d_shading& shading, vertex_numbers& memory,
                      l3d_micro_grid& grid) {
    const quintic_weights in_u(u), in_v(v);
    const eye_rays rays(shading);
    normal_writer writer{net, in_u, in_v, rays, grid, memory.away.data(), {}};
    for_vertices(u, v, grid, writer);
}

/// Writes the shade levels of vertices, and the levels of the middles of sides in place of bends.
struct level_writer {
    const l3d_normal_net::float_net& net;
    const quintic_weights &in_u, &in_v, &beside_u, &beside_v;
    const eye_rays& rays;
    const normal_lanes& light;
    l3d_micro_grid& grid;
    vertex_numbers& to;
    net_columns columns, beside;

    HWY_ATTR HWY_INLINE void begin(std::size_t column) {
        columns.cut(net, in_u, column);
        beside.cut(net, beside_u, column);
    }
    HWY_ATTR HWY_INLINE void vertex(std::size_t row, std::size_t at) {
        const floats d;
        const normal_lanes n = columns.normals(in_v, row);
        const auto scale = over_length(n);
        hn::StoreU(hn::Mul(dot(n, light), scale), d, to.level.data() + at);
        hn::StoreU(hn::Mul(rays.away(n, grid, at), scale), d, to.away.data() + at);
        const normal_lanes along_u = beside.normals(in_v, row);
        hn::StoreU(hn::Mul(dot(along_u, light), over_length(along_u)), d,
                   grid.normal[1].data() + at);
        const normal_lanes along_v = columns.normals(beside_v, row);
        hn::StoreU(hn::Mul(dot(along_v, light), over_length(along_v)), d,
                   grid.normal[2].data() + at);
    }
};

/// Writes what level_writer writes, for a grid of few columns. One vector holds the columns,
/// followed by the middles between neighbouring columns.
HWY_ATTR void levels_of_few(const l3d_normal_net::float_net& net, const lane_parameters& u,
                            const lane_parameters& middle_u, const quintic_weights& in_v,
                            const quintic_weights& beside_v, std::size_t rows, const eye_rays& rays,
                            const normal_lanes& light, vertex_numbers& to, l3d_micro_grid& grid) {
    const floats d;
    lane_parameters both;
    both.count = hn::Lanes(d);
    std::fill_n(both.at, both.count, 1.0);
    std::copy_n(u.at, u.count, both.at);
    std::copy_n(middle_u.at, u.count, both.at + u.count);
    net_columns columns;
    columns.cut(net, quintic_weights(both), 0);
    std::int32_t places[lane_columns];
    for (std::size_t i = 0; i < both.count; ++i)
        places[i] = static_cast<std::int32_t>(std::min(i + u.count, both.count - 1));
    const auto behind = hn::SetTableIndices(d, places);
    for (std::size_t row = 0, at = 0; row < rows;
         ++row, at += static_cast<std::size_t>(grid.pitch)) {
        const normal_lanes n = columns.normals(in_v, row);
        const auto scale = over_length(n);
        const auto level = hn::Mul(dot(n, light), scale);
        hn::StoreU(level, d, to.level.data() + at);
        hn::StoreU(hn::Mul(rays.away(n, grid, at), scale), d, to.away.data() + at);
        hn::StoreU(hn::TableLookupLanes(level, behind), d, grid.normal[1].data() + at);
        const normal_lanes along_v = columns.normals(beside_v, row);
        hn::StoreU(hn::Mul(dot(along_v, light), over_length(along_v)), d,
                   grid.normal[2].data() + at);
    }
}

HWY_ATTR void levels(const l3d_normal_net::float_net& net, const lane_parameters& u,
                     const lane_parameters& v, const l3d_shading& shading, vertex_numbers& memory,
                     l3d_micro_grid& grid) {
    const lane_parameters middle_u = u.middles(), middle_v = v.middles();
    const quintic_weights in_v(v), beside_v(middle_v);
    const eye_rays rays(shading);
    normal_lanes light = direction_of(shading.light);
    for (auto& component : light)
        component = hn::Mul(component, hn::Set(floats(), l3d_level_of_cosine));
    if (2 * u.count <= hn::Lanes(floats()))
        return levels_of_few(net, u, middle_u, in_v, beside_v, v.count, rays, light, memory, grid);
    const quintic_weights in_u(u), beside_u(middle_u);
    level_writer writer{net, in_u, in_v, beside_u, beside_v, rays, light, grid, memory, {}, {}};
    for_vertices(u, v, grid, writer);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(normals);
L3D_SIMD_TABLE(levels);

lane_parameters lane_parameters::middles() const {
    lane_parameters result;
    result.count = count;
    for (std::size_t i = 0; i + 1 < count; ++i)
        result.at[i] = (at[i] + at[i + 1]) / 2;
    std::fill(result.at + count - 1, result.at + padded(), at[count - 1]);
    return result;
}

void normals_in_lanes(const l3d_normal_net& net, const lane_parameters& u, const lane_parameters& v,
                      const l3d_shading& shading, vertex_numbers& memory, l3d_micro_grid& grid) {
    L3D_SIMD_CALL(normals)(net.in_floats(), u, v, shading, memory, grid);
    if (l3d_has_eye(shading))
        l3d_turn_normals(memory.away, grid);
}

void levels_in_lanes(const l3d_normal_net& net, const lane_parameters& u, const lane_parameters& v,
                     const l3d_shading& shading, vertex_numbers& memory, l3d_micro_grid& grid) {
    L3D_SIMD_CALL(levels)(net.in_floats(), u, v, shading, memory, grid);
    l3d_turn_levels(memory.away, memory.level, grid);
}

} // namespace l3d_detail
#endif
