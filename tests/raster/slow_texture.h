// SPDX-License-Identifier: MIT
// What l3d_texture's filters say, place by place in doubles: the slow twin of texture_lanes.
#ifndef L3D_TESTS_RASTER_SLOW_TEXTURE_H
#define L3D_TESTS_RASTER_SLOW_TEXTURE_H

#include "raster/textures/texture_lanes_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

/// Lives: borrows the texture.
class slow_texture {
public:
    using light = std::array<double, 3>;

    explicit slow_texture(const l3d_texture& of) : of_(of.view()) {}

    light seen(l3d_texture_filter filter, const l3d_texture_place& at) const {
        const double ru = at.u_right * of_.width, rv = at.v_right * of_.height;
        const double du = at.u_down * of_.width, dv = at.v_down * of_.height;
        switch (filter) {
        case l3d_texture_filter::nearest:
            return pixel(0, nearest(held(at.u, of_.wrap_u), of_.width),
                         nearest(held(at.v, of_.wrap_v), of_.height));
        case l3d_texture_filter::bilinear:
            return bilinear(0, at.u, at.v);
        case l3d_texture_filter::trilinear:
            return trilinear(std::max(std::hypot(ru, rv), std::hypot(du, dv)), at.u, at.v);
        default:
            return anisotropic(at, ru, rv, du, dv);
        }
    }

private:
    static light mix(const light& a, const light& b, double share) {
        return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]),
                a[2] + share * (b[2] - a[2])};
    }

    static double held(double place, l3d_texture_wrap wrap) {
        return wrap == l3d_texture_wrap::clamp ? std::clamp(place, 0.0, 1.0)
               : wrap == l3d_texture_wrap::repeat
                   ? place - std::floor(place)
                   : 1 - std::abs(1 - (place - 2 * std::floor(place / 2)));
    }

    static int nearest(double place, int size) {
        return std::min(static_cast<int>(place * size), size - 1);
    }

    int width(int level) const { return std::max(of_.width >> level, 1); }
    int height(int level) const { return std::max(of_.height >> level, 1); }

    light pixel(int level, int x, int y) const {
        const int first = of_.first[static_cast<std::size_t>(level)];
        const std::uint32_t word =
            of_.texels[first + y * l3d_detail::texture_view::pitch(width(level)) + x];
        const auto square = [](double root) { return root * root; };
        return {square((word >> 21) / 2047.0), square((word >> 10 & 2047) / 2047.0),
                square((word & 1023) / 1023.0)};
    }

    /// The two pixels around a place along one axis, and the share of the second.
    struct neighbours {
        int first, second;
        double share;

        neighbours(double place, int size, l3d_texture_wrap wrap) {
            const double at = held(place, wrap) * size - 0.5;
            const int below = static_cast<int>(std::floor(at));
            share = at - below;
            const bool repeats = wrap == l3d_texture_wrap::repeat;
            first = below >= 0 ? below : repeats ? size - 1 : 0;
            second = below + 1 < size ? below + 1 : repeats ? 0 : size - 1;
        }
    };

    light bilinear(int level, double u, double v) const {
        const neighbours x(u, width(level), of_.wrap_u), y(v, height(level), of_.wrap_v);
        const auto row = [&](int of) {
            return mix(pixel(level, x.first, of), pixel(level, x.second, of), x.share);
        };
        return mix(row(y.first), row(y.second), y.share);
    }

    /// From the pictures whose pixels are 2^n and 2^(n + 1) wide.
    light trilinear(double width, double u, double v) const {
        int level = 0;
        while (width >= 2 && level + 1 < of_.levels) {
            width /= 2;
            ++level;
        }
        if (!(width > 1) || level + 1 == of_.levels)
            return bilinear(level, u, v);
        return mix(bilinear(level, u, v), bilinear(level + 1, u, v), width - 1);
    }

    light anisotropic(const l3d_texture_place& at, double ru, double rv, double du,
                      double dv) const {
        const double uu = ru * ru + du * du, uv = ru * rv + du * dv, vv = rv * rv + dv * dv;
        const double square = (uu + vv) / 2 + std::hypot((uu - vv) / 2, uv);
        const double longer = std::sqrt(square);
        const double shorter = longer > 0 ? std::abs(ru * dv - rv * du) / longer : 0.0;
        const double wanted = std::ceil(longer / std::max(shorter, 1.0) - 1.0 / 16);
        const int count =
            static_cast<int>(std::clamp(wanted, 1.0, double{l3d_texture::most_samples}));
        if (count == 1)
            return trilinear(longer, at.u, at.v);
        const double along_u = uu > vv ? square - vv : uv, along_v = uu > vv ? uv : square - uu;
        const double scale = longer / std::hypot(along_u, along_v) / count;
        light sum{};
        for (int i = 0; i < count; ++i) {
            const double from_middle = i - 0.5 * (count - 1);
            const light one = trilinear(std::max(shorter, longer / count),
                                        at.u + from_middle * along_u * scale / of_.width,
                                        at.v + from_middle * along_v * scale / of_.height);
            for (std::size_t c = 0; c < sum.size(); ++c)
                sum[c] += one[c] / count;
        }
        return sum;
    }

    l3d_detail::texture_view of_;
};

#endif
