// SPDX-License-Identifier: MIT
// surface_fill: quads and triangles into picture and depth buffer, pixel by pixel.
#ifndef L3D_RASTER_SURFACE_FILL_P_H
#define L3D_RASTER_SURFACE_FILL_P_H

#include "raster/attribute_plane_p.h"
#include "raster/projective_centre_p.h"
#include "raster/surface_target_p.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

namespace l3d_detail {

inline scan_point position(const l3d_micro_vertex& vertex) {
    return {vertex.x, vertex.y};
}

/// Fills polygons with one shader, known at compile time.
///
/// Lives: borrows the target for one call.
template <class Shader> class surface_fill {
public:
    surface_fill(surface_target& target, const Shader& shader) : target_(target), shader_(shader) {}

    /// Shape: corners p00 p10 p11 p01 of a grid cell.
    void quad(const std::array<l3d_micro_vertex, 4>& v) {
        const auto [a, b, c, d] = v;
        const scan_point ab = position(b) - position(a), bc = position(c) - position(b);
        const scan_point cd = position(d) - position(c), da = position(a) - position(d);
        const std::int64_t at_a = cross(da, ab), at_b = cross(ab, bc);
        const std::int64_t at_c = cross(bc, cd), at_d = cross(cd, da);
        const std::int64_t area2 = at_a + at_c;
        const bool turns_right = at_a >= 0 && at_b >= 0 && at_c >= 0 && at_d >= 0;
        const bool turns_left = at_a <= 0 && at_b <= 0 && at_c <= 0 && at_d <= 0;
        if (turns_right && turns_left)
            return; // all on one line: covers nothing
        if (!(turns_right || turns_left) || area2 == 0)
            return folded(v);
        // A plane of the corners' numbers is taken where the diagonals' middles are. The farther
        // these are apart, the farther it runs past the corners' numbers: by their range times
        // skew / area2 / 4, here at most an eighth.
        const std::int64_t skew = std::abs(at_a - at_c) + std::abs(at_b - at_d);
        if (2 * skew <= std::abs(area2))
            return convex(v, area2);
        if (std::min(std::abs(at_a), std::abs(at_c)) > std::min(std::abs(at_b), std::abs(at_d)))
            halves(v[1], v[2], v[3], v[0]);
        else
            halves(v[0], v[1], v[2], v[3]);
    }

    void triangle(const std::array<l3d_micro_vertex, 3>& v) {
        const std::int64_t area2 =
            cross(position(v[1]) - position(v[0]), position(v[2]) - position(v[0]));
        if (area2 != 0)
            convex(v, area2);
    }

private:
    static constexpr std::size_t count = 1 + Shader::components;
    using planes = attribute_planes<count>;
    using numbers = typename planes::numbers;

    /// Fills a quad as two triangles with the diagonal a c.
    void halves(const l3d_micro_vertex& a, const l3d_micro_vertex& b, const l3d_micro_vertex& c,
                const l3d_micro_vertex& d) {
        triangle({a, b, c});
        triangle({a, c, d});
    }

    void folded(const std::array<l3d_micro_vertex, 4>& v) {
        const l3d_micro_vertex centre = projective_centre(v);
        for (std::size_t i = 0; i < v.size(); ++i)
            triangle({v[i], v[(i + 1) % v.size()], centre});
    }

    template <std::size_t Corners>
    void convex(const std::array<l3d_micro_vertex, Corners>& v, std::int64_t area2) {
        std::array<scan_point, Corners> points;
        for (std::size_t i = 0; i < Corners; ++i)
            points[i] = position(v[i]);
        const scan_rows rows =
            target_.scan.convert(std::span<const scan_point, Corners>(points), area2 > 0);
        if (rows.top >= rows.bottom)
            return;

        shader_.begin_polygon(v);
        std::array<numbers, Corners> values;
        float farthest = v[0].inv_w, nearest = v[0].inv_w;
        for (std::size_t i = 0; i < Corners; ++i) {
            values[i][0] = v[i].inv_w;
            shader_.corner(v[i], values[i].data() + 1);
            farthest = std::min(farthest, v[i].inv_w);
            nearest = std::max(nearest, v[i].inv_w);
        }
        const planes plane(points, values, area2);
        const numbers step = plane.per_column();
        for (std::int32_t row = rows.top; row < rows.bottom; ++row)
            fill_row(row, plane, step, farthest, nearest);
    }

    /// Values are counted from the span's own start, clipped or not, so that a pixel's colour does
    /// not depend on where the picture ends.
    void fill_row(std::int32_t row, const planes& plane, const numbers& step, float farthest,
                  float nearest) {
        const std::int32_t start = target_.scan.first(row);
        const std::int32_t begin = std::max(start, 0);
        const std::int32_t end = std::min(target_.scan.last(row), target_.band.width);
        if (begin >= end)
            return;
        const numbers value = plane.at(start, row);
        float* const depths = target_.depths(row);
        std::uint32_t* const words = target_.words(row);
        std::int64_t written = 0;
        for (std::int32_t x = begin; x < end; ++x) {
            const auto k = static_cast<float>(x - start);
            const float inv_w = std::min(std::max(value[0] + step[0] * k, farthest), nearest);
            if (!(inv_w > depths[x]))
                continue;
            depths[x] = inv_w;
            std::array<float, count> here;
            for (std::size_t i = 1; i < count; ++i)
                here[i] = value[i] + step[i] * k;
            words[x] = shader_.word(here.data() + 1);
            ++written;
        }
        target_.counts.samples += end - begin;
        target_.counts.written += written;
    }

    surface_target& target_;
    Shader shader_;
};

} // namespace l3d_detail

#endif
