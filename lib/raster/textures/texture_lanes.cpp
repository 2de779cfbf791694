// SPDX-License-Identifier: MIT
// texture_lanes: applies the filters of l3d_texture to a vector of places.
#include "raster/textures/texture_lanes_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/textures/texture_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "geom/material.h"
#include "raster/color/linear_light_p.h"
#include "raster/parallel/lane_integers-inl.h"
#include "raster/parallel/lane_pairs-inl.h"
#include "raster/parallel/simd_dispatch_p.h"

#include <algorithm>
#include <array>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// The limit of a footprint's width, in pixels of the texture. It is larger than the width of any
/// picture, and its square is still a float.
constexpr float widest = 0x1p60F;

/// Wraps places along one axis, so that they lie between the picture's borders, which are at 0 and
/// 1.
HWY_INLINE float_vec held(float_vec place, l3d_texture_wrap wrap) {
    const float_vec one = set(1.0F);
    switch (wrap) {
    case l3d_texture_wrap::repeat:
        return hn::Sub(place, hn::Floor(place));
    case l3d_texture_wrap::mirror: {
        const float_vec turned =
            hn::Sub(place, hn::Mul(set(2.0F), hn::Floor(hn::Mul(set(0.5F), place))));
        return hn::Sub(one, hn::Abs(hn::Sub(one, turned)));
    }
    default:
        return hn::Min(hn::Max(place, hn::Zero(floats())), one);
    }
}

/// The two pixels beside a place along one axis, in each lane: the index of the first pixel, and
/// the share of the second pixel in the colour. Both pixels may lie in the border of one pixel
/// around the mip level.
struct neighbours {
    int_vec first;
    float_vec share;

    HWY_INLINE neighbours(float_vec place, int_vec size, l3d_texture_wrap wrap) {
        const float_vec at =
            hn::Sub(hn::Mul(held(place, wrap), hn::ConvertTo(floats(), size)), set(0.5F));
        const float_vec below = hn::Floor(at);
        share = hn::Sub(at, below);
        first = hn::ConvertTo(ints(), below);
    }
};

HWY_INLINE const std::int32_t* words_of(const texture_view& texture) {
    return reinterpret_cast<const std::int32_t*>(texture.texels);
}

/// Sums of light, in units that differ from channel to channel.
struct light_sums {
    float_vec of[3];

    HWY_INLINE light_sums() {
        for (float_vec& channel : of)
            channel = hn::Zero(floats());
    }

    HWY_INLINE void add(int_vec words, float_vec weight) {
        static_assert(texture_view::bits == std::array{11, 11, 10});
        const hn::RebindToUnsigned<ints> bits;
        const int_vec roots[3] = {hn::BitCast(ints(), hn::ShiftRight<21>(hn::BitCast(bits, words))),
                                  hn::And(hn::ShiftRight<10>(words), set(0x7ff)),
                                  hn::And(words, set(0x3ff))};
        for (std::size_t c = 0; c < 3; ++c) {
            const float_vec root = hn::ConvertTo(floats(), roots[c]);
            of[c] = hn::Add(of[c], hn::Mul(hn::Mul(root, root), weight));
        }
    }

    /// The sum of a channel's light; 1 is the light of white.
    HWY_INLINE float_vec light(std::size_t channel) const {
        const auto most = static_cast<float>((1 << texture_view::bits[channel]) - 1);
        return hn::Mul(of[channel], set(1 / (most * most)));
    }
};

/// The width, height and first pixel of a mip level in each lane.
struct lane_levels {
    int_vec width, height, first;

    /// In all lanes, the mip level of the whole picture.
    HWY_INLINE explicit lane_levels(const texture_view& texture)
        : width(set(texture.width)), height(set(texture.height)), first(set(texture.first[0])) {}

    HWY_INLINE lane_levels(const texture_view& texture, int_vec level) {
        width = hn::Max(hn::Shr(set(texture.width), level), set(1));
        height = hn::Max(hn::Shr(set(texture.height), level), set(1));
        first = hn::GatherIndex(ints(), texture.first.data(), level);
    }

    HWY_INLINE int_vec pitch() const { return hn::Add(width, set(texture_view::pitch(0))); }
};

HWY_INLINE void add_bilinear(const texture_view& texture, const lane_levels& of, float_vec u,
                             float_vec v, float_vec weight, light_sums& to) {
    const neighbours across(u, of.width, texture.wrap_u), down(v, of.height, texture.wrap_v);
    const int_vec pitch = of.pitch();
    const int_vec place = hn::Add(of.first, hn::Add(hn::Mul(down.first, pitch), across.first));
    const lane_pairs upper(ints(), words_of(texture), place);
    const lane_pairs lower(ints(), words_of(texture), hn::Add(place, pitch));
    const float_vec below = hn::Mul(weight, down.share), above = hn::Sub(weight, below);
    const float_vec upper_right = hn::Mul(above, across.share);
    const float_vec lower_right = hn::Mul(below, across.share);
    to.add(upper.first, hn::Sub(above, upper_right));
    to.add(upper.second, upper_right);
    to.add(lower.first, hn::Sub(below, lower_right));
    to.add(lower.second, lower_right);
}

/// Two neighbouring mip levels for the footprint of a pixel in each lane. The pixels of the larger
/// mip level are not wider than the footprint. The other mip level is the next smaller copy.
class level_pair {
public:
    /// Chooses both mip levels by the footprint's width. The exponent of this float is the number
    /// of the larger mip level, and the mantissa tells the share of the smaller mip level.
    HWY_INLINE level_pair(const texture_view& texture, float_vec width) : texture_(texture) {
        const float_vec held_width = hn::Min(hn::Max(width, set(1.0F)), set(widest));
        const int_vec bits = hn::BitCast(ints(), held_width), one = hn::BitCast(ints(), set(1.0F));
        const int_vec number = hn::ShiftRight<23>(hn::Sub(bits, one));
        const int_vec mantissa = hn::Or(hn::And(bits, set(0x7fffff)), one);
        const int_vec last = set(texture.levels - 1);
        larger_ = lane_levels(texture, hn::Min(number, last));
        smaller_ = lane_levels(texture, hn::Min(hn::Add(number, set(1)), last));
        share_ = hn::IfThenElseZero(hn::RebindMask(floats(), hn::Lt(number, last)),
                                    hn::Sub(hn::BitCast(floats(), mantissa), set(1.0F)));
        is_mixed_ = !hn::AllFalse(floats(), hn::Gt(share_, hn::Zero(floats())));
    }

    HWY_INLINE void add(float_vec u, float_vec v, float_vec weight, light_sums& to) const {
        const float_vec of_smaller = hn::Mul(weight, share_);
        add_bilinear(texture_, larger_, u, v, hn::Sub(weight, of_smaller), to);
        if (is_mixed_)
            add_bilinear(texture_, smaller_, u, v, of_smaller, to);
    }

private:
    const texture_view& texture_;
    lane_levels larger_{texture_}, smaller_{texture_};
    float_vec share_;
    bool is_mixed_;
};

HWY_INLINE void add_nearest(const texture_view& texture, float_vec u, float_vec v, light_sums& to) {
    const auto pixel = [](float_vec place, int size) HWY_ATTR {
        const float_vec at = hn::Mul(place, set(static_cast<float>(size)));
        return hn::Min(hn::ConvertTo(ints(), at), set(size - 1));
    };
    const int_vec x = pixel(held(u, texture.wrap_u), texture.width);
    const int_vec y = pixel(held(v, texture.wrap_v), texture.height);
    const int_vec row = hn::Mul(y, set(texture_view::pitch(texture.width)));
    const int_vec place = hn::Add(set(texture.first[0]), hn::Add(row, x));
    to.add(hn::GatherIndex(ints(), words_of(texture), place), set(1.0F));
}

/// The part of the texture that a pixel covers: the steps in the texture to the places of the next
/// pixels on the right and below. Units: pixels of the texture.
struct footprint {
    float_vec right_u, right_v, down_u, down_v;

    HWY_INLINE footprint(const texture_view& texture, const painted_pixels& pixels, std::size_t i) {
        const float_vec width = set(static_cast<float>(texture.width));
        const float_vec height = set(static_cast<float>(texture.height));
        right_u = hn::Mul(hn::LoadU(floats(), &pixels.u_right[i]), width);
        right_v = hn::Mul(hn::LoadU(floats(), &pixels.v_right[i]), height);
        down_u = hn::Mul(hn::LoadU(floats(), &pixels.u_down[i]), width);
        down_v = hn::Mul(hn::LoadU(floats(), &pixels.v_down[i]), height);
    }

    static HWY_INLINE float_vec square(float_vec x, float_vec y) {
        return hn::Add(hn::Mul(x, x), hn::Mul(y, y));
    }

    HWY_INLINE float_vec longer_way() const {
        return hn::Sqrt(hn::Max(square(right_u, right_v), square(down_u, down_v)));
    }
};

/// Adds several samples along the longer axis of a pixel's footprint.
///
/// The linear map from the picture's pixels to the texture's maps a circle to an ellipse. The
/// ellipse's half axes are as long as the map's singular values. The longer half axis is an
/// eigenvector of the map times its transpose.
HWY_INLINE void add_anisotropic(const texture_view& texture, const footprint& of, float_vec u,
                                float_vec v, light_sums& to) {
    const float_vec zero = hn::Zero(floats()), one = set(1.0F), half = set(0.5F);
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
    // A footprint that is hardly longer than a whole number of samples gets no further sample,
    // which would only blur.
    constexpr float round = 1.0F / 16;
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
    // A single sample is as wide as the footprint is long. If there are several, they are at least
    // as wide as the footprint.
    const float_vec width =
        hn::IfThenElse(hn::Eq(count, one), longer, hn::Max(shorter, hn::Div(longer, count)));
    const level_pair levels(texture, width);
    const float_vec weight = hn::Div(one, count);
    const float most_of_all = hn::GetLane(hn::MaxOfLanes(floats(), count));
    for (float i = 0; i < most_of_all; ++i) {
        const float_vec from_middle = hn::Sub(set(i), hn::Mul(half, hn::Sub(count, one)));
        levels.add(hn::Add(u, hn::Mul(from_middle, step_u)),
                   hn::Add(v, hn::Mul(from_middle, step_v)),
                   hn::IfThenElseZero(hn::Lt(set(i), count), weight), to);
    }
}

template <class Add>
HWY_INLINE void light_pixels(const pixel_range& range, painted_pixels& pixels, const Add& add) {
    for (std::size_t i = range.begin; i < range.end; i += hn::Lanes(floats())) {
        light_sums sums;
        add(i, hn::LoadU(floats(), &pixels.u[i]), hn::LoadU(floats(), &pixels.v[i]), sums);
        for (std::size_t c = 0; c < 3; ++c) {
            float* const light = &pixels.light[c][i];
            hn::StoreU(hn::Mul(hn::LoadU(floats(), light), sums.light(c)), floats(), light);
        }
    }
}

void light_by_texture(const texture_view& texture, l3d_texture_filter filter,
                      const pixel_range& range, painted_pixels& pixels) {
    switch (filter) {
    case l3d_texture_filter::nearest:
        return light_pixels(range, pixels,
                            [&](std::size_t, float_vec u, float_vec v, light_sums& to)
                                HWY_ATTR { add_nearest(texture, u, v, to); });
    case l3d_texture_filter::bilinear:
        return light_pixels(range, pixels,
                            [&](std::size_t, float_vec u, float_vec v, light_sums& to) HWY_ATTR {
                                add_bilinear(texture, lane_levels(texture), u, v, set(1.0F), to);
                            });
    case l3d_texture_filter::trilinear:
        return light_pixels(range, pixels,
                            [&](std::size_t i, float_vec u, float_vec v, light_sums& to) HWY_ATTR {
                                level_pair(texture, footprint(texture, pixels, i).longer_way())
                                    .add(u, v, set(1.0F), to);
                            });
    case l3d_texture_filter::anisotropic:
        return light_pixels(range, pixels,
                            [&](std::size_t i, float_vec u, float_vec v, light_sums& to) HWY_ATTR {
                                add_anisotropic(texture, footprint(texture, pixels, i), u, v, to);
                            });
    }
}

void encode_light(const level_steps& steps, const pixel_range& range, painted_pixels& pixels) {
    const float_vec least = set(level_steps::least), one = set(1.0F);
    const int_vec first = hn::BitCast(ints(), least);
    constexpr int lower = level_steps::lower_bits;
    for (std::size_t i = range.begin; i < range.end; i += hn::Lanes(floats())) {
        int_vec word = hn::Zero(ints());
        for (const auto& channel : pixels.light) {
            const float_vec light = hn::Min(hn::Max(hn::LoadU(floats(), &channel[i]), least), one);
            const int_vec bits = hn::BitCast(ints(), light);
            const int_vec step = hn::GatherIndex(ints(), steps.level.data(),
                                                 hn::ShiftRight<lower>(hn::Sub(bits, first)));
            const auto is_below =
                hn::Lt(hn::And(bits, set((1 << lower) - 1)), hn::ShiftRight<8>(step));
            const int_vec level =
                hn::Add(hn::And(step, set(255)), hn::IfThenZeroElse(is_below, set(1)));
            word = hn::Or(hn::ShiftLeft<8>(word), level);
        }
        hn::StoreU(word, ints(), reinterpret_cast<std::int32_t*>(&pixels.words[i]));
    }
}

void take_names(const std::uint32_t* words, const float* depths, std::size_t count,
                named_pixels& to) {
    const hn::RebindToUnsigned<ints> names;
    to.count = count;
    std::fill(to.names.begin() + static_cast<std::ptrdiff_t>(count), to.names.end(), no_name);
    std::size_t i = 0;
    for (; i + hn::Lanes(names) <= count; i += hn::Lanes(names)) {
        const auto filled = hn::Gt(hn::LoadU(floats(), depths + i), hn::Zero(floats()));
        hn::StoreU(hn::IfThenElse(hn::RebindMask(names, filled),
                                  hn::ShiftRight<8>(hn::LoadU(names, words + i)),
                                  hn::Set(names, no_name)),
                   names, &to.names[i]);
    }
    for (; i < count; ++i)
        to.names[i] = depths[i] > 0 ? words[i] >> 8 : no_name;
}

/// The product of a grey level and a colour's channel, divided by 255 and rounded. Let x be the
/// product plus 128; then the result is (x + floor(x / 256)) / 256.
HWY_INLINE int_vec product_over_255(int_vec a, int_vec b) {
    const int_vec x = hn::Add(hn::Mul(a, b), set(128));
    return hn::ShiftRight<8>(hn::Add(x, hn::ShiftRight<8>(x)));
}

void color_levels(std::uint32_t* words, const float* depths, const std::uint32_t* colors,
                  std::size_t count) {
    const int_vec byte = set(0xff);
    std::size_t i = 0;
    for (; i + hn::Lanes(floats()) <= count; i += hn::Lanes(floats())) {
        auto* const at = reinterpret_cast<std::int32_t*>(words + i);
        const int_vec word = hn::LoadU(ints(), at), level = hn::And(word, byte);
        const int_vec color = hn::LoadU(ints(), reinterpret_cast<const std::int32_t*>(colors + i));
        const int_vec red = product_over_255(hn::And(hn::ShiftRight<16>(color), byte), level);
        const int_vec green = product_over_255(hn::And(hn::ShiftRight<8>(color), byte), level);
        const int_vec blue = product_over_255(hn::And(color, byte), level);
        const int_vec shown = hn::Or(hn::ShiftLeft<16>(red), hn::Or(hn::ShiftLeft<8>(green), blue));
        const auto filled = hn::Gt(hn::LoadU(floats(), depths + i), hn::Zero(floats()));
        hn::StoreU(hn::IfThenElse(hn::RebindMask(ints(), filled), shown, word), ints(), at);
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
L3D_SIMD_TABLE(take_names);
L3D_SIMD_TABLE(color_levels);

level_steps::level_steps() {
    const linear_light& tables = linear_light_tables();
    constexpr std::uint32_t length = 1u << lower_bits;
    for (std::size_t i = 0; i < steps; ++i) {
        const std::uint32_t begin =
            std::bit_cast<std::uint32_t>(least) + static_cast<std::uint32_t>(i) * length;
        const std::uint32_t is = tables.level(std::bit_cast<float>(begin));
        std::uint32_t lower = length;
        if (is < 255)
            lower = std::min(std::bit_cast<std::uint32_t>(tables.begins()[is + 1]) - begin, length);
        level[i] = static_cast<std::int32_t>(lower << 8 | is);
    }
}

void light_by_texture(const texture_view& texture, l3d_texture_filter filter,
                      const pixel_range& range, painted_pixels& pixels) {
    L3D_SIMD_CALL(light_by_texture)(texture, filter, range, pixels);
}

void encode_light(const pixel_range& range, painted_pixels& pixels) {
    static const level_steps steps;
    L3D_SIMD_CALL(encode_light)(steps, range, pixels);
}

void take_names(const std::uint32_t* words, const float* depths, std::size_t count,
                named_pixels& to) {
    L3D_SIMD_CALL(take_names)(words, depths, count, to);
}

void color_levels(std::uint32_t* words, const float* depths, const std::uint32_t* colors,
                  std::size_t count) {
    L3D_SIMD_CALL(color_levels)(words, depths, colors, count);
}

} // namespace l3d_detail
#endif
