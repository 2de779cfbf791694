// SPDX-License-Identifier: MIT
// texture_lanes: the filters of l3d_texture, for a vector of places.
#include "raster/textures/texture_lanes_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/textures/texture_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "geom/material.h"
#include "raster/color/linear_light_p.h"
#include "raster/parallel/simd_dispatch_p.h"

#include <algorithm>
#include <limits>

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
HWY_INLINE int_vec set_int(int number) {
    return hn::Set(integers, number);
}

/// The largest width of a footprint: beyond any picture's, and its square is a number.
constexpr float widest = 0x1p60F;

/// Places along one axis, from 0 to 1 at the picture's borders.
HWY_INLINE float_vec held(float_vec place, l3d_texture_wrap wrap) {
    const float_vec one = set(1);
    switch (wrap) {
    case l3d_texture_wrap::repeat:
        return hn::Sub(place, hn::Floor(place));
    case l3d_texture_wrap::mirror: {
        const float_vec turned =
            hn::Sub(place, hn::Mul(set(2), hn::Floor(hn::Mul(set(0.5F), place))));
        return hn::Sub(one, hn::Abs(hn::Sub(one, turned)));
    }
    default:
        return hn::Min(hn::Max(place, hn::Zero(floats)), one);
    }
}

/// The two pixels around places along one axis, and the share of the second.
struct neighbours {
    int_vec first, second;
    float_vec share;

    HWY_INLINE neighbours(float_vec place, int_vec size, l3d_texture_wrap wrap) {
        const float_vec at =
            hn::Sub(hn::Mul(held(place, wrap), hn::ConvertTo(floats, size)), set(0.5F));
        const float_vec below = hn::Floor(at);
        share = hn::Sub(at, below);
        const int_vec zero = hn::Zero(integers), last = hn::Sub(size, set_int(1));
        const bool repeats = wrap == l3d_texture_wrap::repeat;
        first = hn::ConvertTo(integers, below);
        second = hn::Add(first, set_int(1));
        first = hn::IfThenElse(hn::Lt(first, zero), repeats ? last : zero, first);
        second = hn::IfThenElse(hn::Gt(second, last), repeats ? zero : last, second);
    }
};

/// Sums of light. 65535 is that of a level of 255.
struct light_sums {
    float_vec of[3];

    HWY_INLINE light_sums() {
        for (float_vec& channel : of)
            channel = hn::Zero(floats);
    }

    /// Adds pixels by their places among all of the texture.
    HWY_INLINE void add(const texture_view& texture, int_vec place, float_vec weight) {
        const auto* const words = reinterpret_cast<const std::int32_t*>(texture.pixels);
        const int_vec at = hn::Add(place, place), lower = set_int(0xffff);
        const int_vec red_green = hn::GatherIndex(integers, words, at);
        const int_vec blue = hn::GatherIndex(integers, words + 1, at);
        const int_vec channels[3] = {hn::And(red_green, lower),
                                     hn::And(hn::ShiftRight<16>(red_green), lower),
                                     hn::And(blue, lower)};
        for (std::size_t c = 0; c < 3; ++c)
            of[c] = hn::Add(of[c], hn::Mul(hn::ConvertTo(floats, channels[c]), weight));
    }
};

/// Widths, heights and first pixels of levels.
struct lane_levels {
    int_vec width, height, first;

    HWY_INLINE lane_levels(const texture_view& texture, int_vec level) {
        width = hn::Max(hn::Shr(set_int(texture.width), level), set_int(1));
        height = hn::Max(hn::Shr(set_int(texture.height), level), set_int(1));
        first = hn::GatherIndex(integers, texture.first.data(), level);
    }
};

HWY_INLINE void add_bilinear(const texture_view& texture, int_vec level, float_vec u, float_vec v,
                             float_vec weight, light_sums& to) {
    const lane_levels of(texture, level);
    const neighbours across(u, of.width, texture.wrap_u), down(v, of.height, texture.wrap_v);
    const int_vec upper = hn::Add(of.first, hn::Mul(down.first, of.width));
    const int_vec lower = hn::Add(of.first, hn::Mul(down.second, of.width));
    const float_vec below = hn::Mul(weight, down.share), above = hn::Sub(weight, below);
    const float_vec upper_right = hn::Mul(above, across.share);
    const float_vec lower_right = hn::Mul(below, across.share);
    to.add(texture, hn::Add(upper, across.first), hn::Sub(above, upper_right));
    to.add(texture, hn::Add(upper, across.second), upper_right);
    to.add(texture, hn::Add(lower, across.first), hn::Sub(below, lower_right));
    to.add(texture, hn::Add(lower, across.second), lower_right);
}

/// The exponent of a width is the number of the larger picture, and its mantissa the share of the
/// smaller one.
HWY_INLINE void add_trilinear(const texture_view& texture, float_vec width, float_vec u,
                              float_vec v, float_vec weight, light_sums& to) {
    const float_vec held_width = hn::Min(hn::Max(width, set(1)), set(widest));
    const int_vec bits = hn::BitCast(integers, held_width), one = hn::BitCast(integers, set(1));
    const int_vec number = hn::ShiftRight<23>(hn::Sub(bits, one));
    const int_vec mantissa = hn::Or(hn::And(bits, set_int(0x7fffff)), one);
    const int_vec last = set_int(texture.levels - 1);
    const float_vec smaller = hn::IfThenElseZero(hn::RebindMask(floats, hn::Lt(number, last)),
                                                 hn::Sub(hn::BitCast(floats, mantissa), set(1)));
    const float_vec of_smaller = hn::Mul(weight, smaller);
    add_bilinear(texture, hn::Min(number, last), u, v, hn::Sub(weight, of_smaller), to);
    if (!hn::AllFalse(floats, hn::Gt(of_smaller, hn::Zero(floats))))
        add_bilinear(texture, hn::Min(hn::Add(number, set_int(1)), last), u, v, of_smaller, to);
}

HWY_INLINE void add_nearest(const texture_view& texture, float_vec u, float_vec v, light_sums& to) {
    const auto pixel = [](float_vec place, int size) HWY_ATTR {
        const float_vec at = hn::Mul(place, set(static_cast<float>(size)));
        return hn::Min(hn::ConvertTo(integers, at), set_int(size - 1));
    };
    const int_vec x = pixel(held(u, texture.wrap_u), texture.width);
    const int_vec y = pixel(held(v, texture.wrap_v), texture.height);
    to.add(texture, hn::Add(hn::Mul(y, set_int(texture.width)), x), set(1));
}

/// The ways to the next pixels, in pixels of the texture.
struct footprint {
    float_vec right_u, right_v, down_u, down_v;

    HWY_INLINE footprint(const texture_view& texture, const painted_pixels& pixels, std::size_t i) {
        const float_vec width = set(static_cast<float>(texture.width));
        const float_vec height = set(static_cast<float>(texture.height));
        right_u = hn::Mul(hn::Load(floats, &pixels.u_right[i]), width);
        right_v = hn::Mul(hn::Load(floats, &pixels.v_right[i]), height);
        down_u = hn::Mul(hn::Load(floats, &pixels.u_down[i]), width);
        down_v = hn::Mul(hn::Load(floats, &pixels.v_down[i]), height);
    }

    static HWY_INLINE float_vec square(float_vec x, float_vec y) {
        return hn::Add(hn::Mul(x, x), hn::Mul(y, y));
    }

    HWY_INLINE float_vec longer_way() const {
        return hn::Sqrt(hn::Max(square(right_u, right_v), square(down_u, down_v)));
    }
};

/// A circle becomes an ellipse under the linear map from the picture's pixels to the texture's. Its
/// axes are the map's singular values, and the longer one is an eigenvector of the map times its
/// transpose.
HWY_INLINE void add_anisotropic(const texture_view& texture, const footprint& of, float_vec u,
                                float_vec v, light_sums& to) {
    const float_vec zero = hn::Zero(floats), one = set(1), half = set(0.5F);
    const float_vec uu = footprint::square(of.right_u, of.down_u);
    const float_vec vv = footprint::square(of.right_v, of.down_v);
    const float_vec uv = hn::Add(hn::Mul(of.right_u, of.right_v), hn::Mul(of.down_u, of.down_v));
    const float_vec area =
        hn::Abs(hn::Sub(hn::Mul(of.right_u, of.down_v), hn::Mul(of.right_v, of.down_u)));
    const float_vec mean = hn::Mul(half, hn::Add(uu, vv));
    const float_vec apart = hn::Mul(half, hn::Sub(uu, vv));
    const float_vec square =
        hn::Min(hn::Add(mean, hn::Sqrt(footprint::square(apart, uv))), set(widest));
    const float_vec longer = hn::Sqrt(square);
    const auto has_axis = hn::Gt(longer, zero);
    const float_vec shorter = hn::IfThenElseZero(has_axis, hn::Div(area, longer));
    constexpr float round = 1e-3F; // a footprint that is round but for rounding has no longer axis
    constexpr auto most = static_cast<float>(l3d_texture::most_samples);
    const float_vec wanted = hn::Ceil(hn::Sub(hn::Div(longer, hn::Max(shorter, one)), set(round)));
    const float_vec count = hn::Min(hn::Max(wanted, one), set(most));
    const auto is_flat = hn::Gt(uu, vv);
    const float_vec along_u = hn::IfThenElse(is_flat, hn::Sub(square, vv), uv);
    const float_vec along_v = hn::IfThenElse(is_flat, uv, hn::Sub(square, uu));
    const float_vec length = hn::Sqrt(footprint::square(along_u, along_v));
    const float_vec scale = hn::IfThenElseZero(
        hn::Gt(length, zero), hn::Div(longer, hn::Mul(hn::Max(length, set(1e-30F)), count)));
    const float_vec step_u =
        hn::Div(hn::Mul(along_u, scale), set(static_cast<float>(texture.width)));
    const float_vec step_v =
        hn::Div(hn::Mul(along_v, scale), set(static_cast<float>(texture.height)));
    // One sample is as wide as the footprint is long, and no narrower ones than it is wide.
    const float_vec width =
        hn::IfThenElse(hn::Eq(count, one), longer, hn::Max(shorter, hn::Div(longer, count)));
    const float_vec weight = hn::Div(one, count);
    const float most_of_all = hn::GetLane(hn::MaxOfLanes(floats, count));
    for (float i = 0; i < most_of_all; ++i) {
        const float_vec from_middle = hn::Sub(set(i), hn::Mul(half, hn::Sub(count, one)));
        add_trilinear(texture, width, hn::Add(u, hn::Mul(from_middle, step_u)),
                      hn::Add(v, hn::Mul(from_middle, step_v)),
                      hn::IfThenElseZero(hn::Lt(set(i), count), weight), to);
    }
}

template <class Add> HWY_INLINE void light_pixels(painted_pixels& pixels, const Add& add) {
    constexpr float white = 65535;
    for (std::size_t i = 0; i < pixels.count; i += hn::Lanes(floats)) {
        light_sums sums;
        add(i, hn::Load(floats, &pixels.u[i]), hn::Load(floats, &pixels.v[i]), sums);
        for (std::size_t c = 0; c < 3; ++c) {
            float* const light = &pixels.light[c][i];
            hn::Store(hn::Mul(hn::Load(floats, light), hn::Mul(sums.of[c], set(1 / white))), floats,
                      light);
        }
    }
}

void light_by_texture(const texture_view& texture, l3d_texture_filter filter,
                      painted_pixels& pixels) {
    switch (filter) {
    case l3d_texture_filter::nearest:
        return light_pixels(pixels, [&](std::size_t, float_vec u, float_vec v, light_sums& to)
                                        HWY_ATTR { add_nearest(texture, u, v, to); });
    case l3d_texture_filter::bilinear:
        return light_pixels(pixels,
                            [&](std::size_t, float_vec u, float_vec v, light_sums& to) HWY_ATTR {
                                add_bilinear(texture, hn::Zero(integers), u, v, set(1), to);
                            });
    case l3d_texture_filter::trilinear:
        return light_pixels(pixels, [&](std::size_t i, float_vec u, float_vec v,
                                        light_sums& to) HWY_ATTR {
            add_trilinear(texture, footprint(texture, pixels, i).longer_way(), u, v, set(1), to);
        });
    case l3d_texture_filter::anisotropic:
        return light_pixels(pixels,
                            [&](std::size_t i, float_vec u, float_vec v, light_sums& to) HWY_ATTR {
                                add_anisotropic(texture, footprint(texture, pixels, i), u, v, to);
                            });
    }
}

void encode_light(const level_tables& tables, painted_pixels& pixels) {
    const float_vec zero = hn::Zero(floats), one = set(1);
    constexpr auto last_guess = static_cast<float>(level_tables::guesses - 1);
    for (std::size_t i = 0; i < pixels.count; i += hn::Lanes(floats)) {
        int_vec word = hn::Zero(integers);
        for (const auto& channel : pixels.light) {
            const float_vec light = hn::Min(hn::Max(hn::Load(floats, &channel[i]), zero), one);
            int_vec level =
                hn::GatherIndex(integers, tables.first.data(),
                                hn::ConvertTo(integers, hn::Mul(light, set(last_guess))));
            // A guess errs by less than two levels.
            for (int step = 0; step < 2; ++step) {
                const float_vec next = hn::GatherIndex(floats, tables.begins.data() + 1, level);
                level =
                    hn::Sub(level, hn::VecFromMask(integers,
                                                   hn::RebindMask(integers, hn::Ge(light, next))));
            }
            word = hn::Or(hn::ShiftLeft<8>(word), level);
        }
        hn::Store(word, integers, reinterpret_cast<std::int32_t*>(&pixels.words[i]));
    }
}

/// The product of a level and a channel over 255, rounded: with x the product plus 128, it is
/// (x + floor(x / 256)) / 256.
HWY_INLINE int_vec product_over_255(int_vec a, int_vec b) {
    const int_vec x = hn::Add(hn::Mul(a, b), set_int(128));
    return hn::ShiftRight<8>(hn::Add(x, hn::ShiftRight<8>(x)));
}

void color_levels(std::uint32_t* words, const float* depths, const std::uint32_t* colors,
                  std::size_t count) {
    const int_vec byte = set_int(0xff);
    std::size_t i = 0;
    for (; i + hn::Lanes(floats) <= count; i += hn::Lanes(floats)) {
        auto* const at = reinterpret_cast<std::int32_t*>(words + i);
        const int_vec word = hn::LoadU(integers, at), level = hn::And(word, byte);
        const int_vec color =
            hn::LoadU(integers, reinterpret_cast<const std::int32_t*>(colors + i));
        const int_vec red = product_over_255(hn::And(hn::ShiftRight<16>(color), byte), level);
        const int_vec green = product_over_255(hn::And(hn::ShiftRight<8>(color), byte), level);
        const int_vec blue = product_over_255(hn::And(color, byte), level);
        const int_vec shown = hn::Or(hn::ShiftLeft<16>(red), hn::Or(hn::ShiftLeft<8>(green), blue));
        const auto filled = hn::Gt(hn::LoadU(floats, depths + i), hn::Zero(floats));
        hn::StoreU(hn::IfThenElse(hn::RebindMask(integers, filled), shown, word), integers, at);
    }
    for (; i < count; ++i)
        if (depths[i] > 0)
            words[i] = l3d_product_of_colors(colors[i], (words[i] & 0xff) * 0x010101);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(light_by_texture);
L3D_SIMD_TABLE(encode_light);
L3D_SIMD_TABLE(color_levels);

level_tables::level_tables() {
    const linear_light& tables = linear_light_tables();
    for (std::size_t i = 0; i < guesses; ++i)
        first[i] = tables.first_guess(i);
    std::ranges::copy(tables.begins(), begins.begin());
    begins.back() = std::numeric_limits<float>::infinity();
}

void light_by_texture(const texture_view& texture, l3d_texture_filter filter,
                      painted_pixels& pixels) {
    L3D_SIMD_CALL(light_by_texture)(texture, filter, pixels);
}

void encode_light(painted_pixels& pixels) {
    static const level_tables tables;
    L3D_SIMD_CALL(encode_light)(tables, pixels);
}

void color_levels(std::uint32_t* words, const float* depths, const std::uint32_t* colors,
                  std::size_t count) {
    L3D_SIMD_CALL(color_levels)(words, depths, colors, count);
}

} // namespace l3d_detail
#endif
