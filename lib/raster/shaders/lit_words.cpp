// SPDX-License-Identifier: MIT
// lit_words: does the work of lit_shader in lanes, a material at a time.
#include "raster/shaders/lit_words_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/shaders/lit_words.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"

#include <cfloat>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using floats = hn::CappedTag<float, 16>;
using words = hn::RebindToUnsigned<floats>;
using float_vec = hn::Vec<floats>;
using word_vec = hn::Vec<words>;
using float_mask = hn::Mask<floats>;

HWY_INLINE float_vec set(float value) {
    return hn::Set(floats(), value);
}

/// A vector in space for each pixel, one pixel in each lane.
struct lane_vector {
    float_vec x, y, z;

    HWY_INLINE lane_vector scaled(float_vec by) const {
        return {hn::Mul(x, by), hn::Mul(y, by), hn::Mul(z, by)};
    }
};

HWY_INLINE float_vec dot_of(const lane_vector& a, const lane_vector& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

HWY_INLINE float_vec length_of(const lane_vector& v) {
    return hn::Sqrt(hn::Max(dot_of(v, v), set(FLT_MIN)));
}

HWY_INLINE lane_vector broadcast(const std::array<float, 3>& v) {
    return {set(v[0]), set(v[1]), set(v[2])};
}

HWY_INLINE float_vec whole_power(float_vec base, int exponent) {
    float_vec result = set(1);
    for (;; base = hn::Mul(base, base)) {
        if (exponent & 1)
            result = hn::Mul(result, base);
        exponent >>= 1;
        if (exponent == 0)
            return result;
    }
}

/// Amounts of light in three channels, or one amount for all three.
template <std::size_t Channels> struct light_amounts {
    float_vec of[Channels];

    HWY_INLINE explicit light_amounts(const l3d_light_color& color) {
        for (std::size_t i = 0; i < Channels; ++i)
            of[i] = set(color[i]);
    }
    HWY_INLINE void add(float_vec amount, const l3d_light_color& color) {
        for (std::size_t i = 0; i < Channels; ++i)
            of[i] = hn::Add(of[i], hn::Mul(amount, set(color[i])));
    }
    HWY_INLINE float_vec operator[](std::size_t i) const { return of[Channels == 1 ? 0 : i]; }
};

/// The light of a vector of pixels. Shape: one channel if all lights are white or grey.
template <std::size_t Channels> class lane_light {
public:
    /// Takes the normals `raw` of pixels, and `own`: the part of the ray from the eye that differs
    /// from pixel to pixel, as lit_shader::own_way.
    HWY_INLINE lane_light(const l3d_shading& shading, const lane_vector& raw,
                          const lane_vector& own, float_vec depth)
        : shading_(shading), look_(look_of(shading, own)), distance_(length_of(look_)) {
        if (shading.lighting.point_count > 0)
            place_ = place_of(own, depth);
        float_vec inverse = hn::Div(set(1), length_of(raw));
        if (lit_shader::turns_normals(shading)) {
            const auto away = hn::Gt(dot_of(raw, look_), hn::Zero(floats()));
            inverse = hn::IfThenElse(away, hn::Neg(inverse), inverse);
        }
        normal_ = raw.scaled(inverse);
        against_ = dot_of(look_, normal_);
    }

    HWY_INLINE word_vec word(const lit_material& material, const word_vec* colors) const {
        const l3d_lighting& lighting = shading_.lighting;
        light_amounts<Channels> scattered(lighting.ambient), mirrored({0, 0, 0});
        const bool shines = material.shines();
        const auto add_far = [&](const std::array<float, 3>& direction,
                                 const l3d_light_color& color) HWY_ATTR {
            return add({broadcast(direction), set(1), color}, material, shines, scattered,
                       mirrored);
        };
        bool peaks = add_far(shading_.light, lighting.color);
        for (std::size_t i = 0; i < lighting.count; ++i)
            peaks |= add_far(lighting.lights[i].direction, lighting.lights[i].color);
        for (std::size_t i = 0; i < lighting.point_count; ++i)
            peaks |= add(light_at(lighting.points[i]), material, shines, scattered, mirrored);
        word_vec result = hn::Zero(words());
        for (std::size_t i = 0; i < 3; ++i) {
            const float_vec color = colors ? channel(*colors, i) : set(material.color[i]);
            float_vec level = hn::Mul(color, scattered[i]);
            if (peaks)
                level = hn::Add(level, hn::Mul(set(material.highlight[i]), mirrored[i]));
            result = hn::Or(hn::ShiftLeft<8>(result), whole(level));
        }
        return result;
    }

private:
    /// A light as it is seen from the pixels' places: its direction and its brightness.
    struct seen_light {
        lane_vector direction;
        float_vec strength;
        const l3d_light_color& color;
    };

    static HWY_INLINE lane_vector look_of(const l3d_shading& shading, const lane_vector& own) {
        return lit_shader::is_parallel(shading) ? broadcast(shading.look) : own;
    }

    /// The places that pixels show, relative to the eye.
    HWY_INLINE lane_vector place_of(const lane_vector& own, float_vec depth) const {
        const floats d;
        HWY_ALIGN float of[hn::MaxLanes(floats())];
        hn::Store(depth, d, of);
        for (float& each : of)
            each = shading_.distance(each) / shading_.look_depth;
        const float_vec along = hn::Load(d, of);
        if (!lit_shader::is_parallel(shading_))
            return own.scaled(along);
        const lane_vector ahead = look_.scaled(along);
        return {hn::Add(own.x, ahead.x), hn::Add(own.y, ahead.y), hn::Add(own.z, ahead.z)};
    }

    HWY_INLINE seen_light light_at(const l3d_point_light& light) const {
        const auto from_eye = [&](int i) HWY_ATTR {
            const double eye = shading_.eye[static_cast<std::size_t>(i)];
            return set(static_cast<float>(light.position[i] - eye));
        };
        const lane_vector way{hn::Sub(from_eye(0), place_.x), hn::Sub(from_eye(1), place_.y),
                              hn::Sub(from_eye(2), place_.z)};
        const float_vec square = hn::Max(dot_of(way, way), set(FLT_MIN));
        float_vec strength = set(1);
        if (light.reach > 0)
            strength = hn::Min(hn::Div(set(light.reach * light.reach), square),
                               set(l3d_point_light::brightest));
        return {way.scaled(hn::Div(set(1), hn::Sqrt(square))), strength, light.color};
    }

    /// Adds the scattered and the mirrored light. Returns whether any highlight was added.
    HWY_INLINE bool add(const seen_light& light, const lit_material& material, bool shines,
                        light_amounts<Channels>& scattered,
                        light_amounts<Channels>& mirrored) const {
        const floats d;
        const float_vec zero = hn::Zero(d);
        const lane_vector& to_light = light.direction;
        const float_vec cosine = dot_of(to_light, normal_);
        const float_mask is_lit = hn::Gt(cosine, zero);
        if (hn::AllFalse(d, is_lit))
            return false;
        scattered.add(
            hn::Mul(hn::Mul(set(0.9F), hn::IfThenElseZero(is_lit, cosine)), light.strength),
            light.color);
        if (!shines)
            return false;
        const float_vec product = hn::Sub(hn::Mul(distance_, cosine), against_);
        const float_vec beside = hn::Sub(distance_, dot_of(to_light, look_));
        const float_vec square =
            hn::Max(hn::Mul(hn::Add(distance_, distance_), beside), set(FLT_MIN));
        const float_mask is_seen =
            hn::And(hn::And(is_lit, hn::Gt(product, zero)),
                    hn::Gt(hn::Mul(product, product), hn::Mul(set(material.least_square), square)));
        if (hn::AllFalse(d, is_seen))
            return false;
        const float_vec facing = hn::Min(hn::Div(product, hn::Sqrt(square)), set(1));
        const float_vec peak =
            whole_power(hn::IfThenElse(is_seen, facing, set(1)), material.sharpness);
        mirrored.add(hn::Mul(hn::IfThenElseZero(is_seen, peak), light.strength), light.color);
        return true;
    }

    static HWY_INLINE float_vec channel(word_vec colors, std::size_t i) {
        const word_vec level = hn::ShiftRightSame(colors, static_cast<int>(16 - 8 * i));
        const hn::RebindToSigned<floats> d;
        return hn::ConvertTo(floats(), hn::BitCast(d, hn::And(level, hn::Set(words(), 0xffu))));
    }

    static HWY_INLINE word_vec whole(float_vec level) {
        const float_vec held = hn::Min(hn::Max(level, hn::Zero(floats())), set(255));
        const hn::RebindToSigned<floats> d;
        return hn::BitCast(words(), hn::ConvertTo(d, hn::Add(held, set(0.5F))));
    }

    const l3d_shading& shading_;
    lane_vector look_, normal_;
    /// The places that pixels show, relative to the eye; set if there are point lights.
    lane_vector place_;
    float_vec distance_, against_;
};

/// The signed 16-bit numbers in the upper halves of words, as floats.
HWY_INLINE float_vec upper(word_vec word) {
    const hn::RebindToSigned<floats> whole;
    return hn::ConvertTo(floats(), hn::ShiftRight<16>(hn::BitCast(whole, word)));
}

/// Pixels of a row side by side, whose normals are to be lit.
struct pixel_row {
    std::uint32_t* words;
    const float* depths;
    const std::uint32_t* normals;
    /// The pixels' colours; null if materials tell the colours (lit_pixels::colors).
    const std::uint32_t* colors;
    /// The shading's `look`, or `aside` with parallel rays, in column 0 of the row.
    lane_vector own;
    lane_vector own_right; ///< the change of `own` from a column to the next
};

/// The pixel words of a vector of lit pixels. They are found for one material at a time. Most
/// vectors have only one material.
template <std::size_t Channels>
HWY_INLINE word_vec by_materials(const lane_light<Channels>& light, const lit_material* materials,
                                 const word_vec* colors, word_vec there, float_mask filled) {
    const words dw;
    const word_vec material = hn::And(there, hn::Set(dw, 0xffffu));
    const std::uint32_t first = hn::GetLane(material);
    const auto others = hn::Ne(material, hn::Set(dw, first));
    if (HWY_LIKELY(hn::AllFalse(dw, others) && hn::AllTrue(floats(), filled)))
        return light.word(materials[first], colors);
    HWY_ALIGN std::uint32_t each[hn::MaxLanes(words())];
    hn::Store(material, dw, each);
    word_vec result = there;
    for (auto left = hn::RebindMask(dw, filled); !hn::AllFalse(dw, left);) {
        const std::uint32_t next = each[hn::FindKnownFirstTrue(dw, left)];
        const auto same = hn::And(left, hn::Eq(material, hn::Set(dw, next)));
        result = hn::IfThenElse(same, light.word(materials[next], colors), result);
        left = hn::AndNot(same, left);
    }
    return result;
}

template <std::size_t Channels>
HWY_INLINE void color_vector(const l3d_shading& shading, const lit_material* materials,
                             const pixel_row& row, std::size_t i, float_vec x) {
    const floats d;
    const words dw;
    const float_vec depth = hn::LoadU(d, row.depths + i);
    const float_mask filled = hn::Gt(depth, hn::Zero(d));
    if (hn::AllFalse(d, filled))
        return;
    const word_vec there = hn::LoadU(dw, row.words + i), xy = hn::LoadU(dw, row.normals + i);
    const lane_vector raw{upper(hn::ShiftLeft<16>(xy)), upper(xy), upper(there)};
    const lane_vector along = row.own_right.scaled(x);
    const lane_light<Channels> light(
        shading, raw,
        {hn::Add(row.own.x, along.x), hn::Add(row.own.y, along.y), hn::Add(row.own.z, along.z)},
        depth);
    const word_vec colors = row.colors ? hn::LoadU(dw, row.colors + i) : hn::Zero(dw);
    hn::StoreU(by_materials(light, materials, row.colors ? &colors : nullptr, there, filled), dw,
               row.words + i);
}

/// Colours the last pixels of a row, which do not fill a whole vector.
template <std::size_t Channels>
HWY_NOINLINE void color_last(const l3d_shading& shading, const lit_material* materials,
                             const pixel_row& row, std::size_t from, std::size_t end, float_vec x) {
    constexpr std::size_t lanes = hn::MaxLanes(floats());
    HWY_ALIGN std::uint32_t of_words[lanes] = {}, normals[lanes] = {}, colors[lanes] = {};
    HWY_ALIGN float depths[lanes] = {};
    std::copy(row.words + from, row.words + end, of_words);
    std::copy(row.normals + from, row.normals + end, normals);
    std::copy(row.depths + from, row.depths + end, depths);
    if (row.colors)
        std::copy(row.colors + from, row.colors + end, colors);
    color_vector<Channels>(
        shading, materials,
        {of_words, depths, normals, row.colors ? colors : nullptr, row.own, row.own_right}, 0, x);
    std::copy_n(of_words, end - from, row.words + from);
}

template <std::size_t Channels>
HWY_INLINE void light_by(const l3d_shading& shading, const lit_material* materials,
                         const lit_pixels& pixels) {
    const floats d;
    const auto width = static_cast<std::size_t>(pixels.width);
    const bool parallel = lit_shader::is_parallel(shading);
    const lane_vector own = broadcast(parallel ? shading.aside : shading.look),
                      own_right = broadcast(parallel ? shading.aside_right : shading.look_right),
                      down = broadcast(parallel ? shading.aside_down : shading.look_down);
    const float_vec first = hn::Add(hn::Iota(d, 0), set(static_cast<float>(pixels.left) + 0.5F));
    for (std::int32_t row = 0; row < pixels.height; ++row) {
        const lane_vector along = down.scaled(set(static_cast<float>(pixels.top + row) + 0.5F));
        const pixel_row of{
            pixels.words + row * pixels.word_pitch,
            pixels.depths + row * pixels.depth_pitch,
            pixels.normals + row * pixels.depth_pitch,
            pixels.colors,
            {hn::Add(own.x, along.x), hn::Add(own.y, along.y), hn::Add(own.z, along.z)},
            own_right};
        std::size_t i = 0;
        const auto x = [&] HWY_ATTR { return hn::Add(first, set(static_cast<float>(i))); };
        for (; i + hn::Lanes(d) <= width; i += hn::Lanes(d))
            color_vector<Channels>(shading, materials, of, i, x());
        if (i < width)
            color_last<Channels>(shading, materials, of, i, width, x());
    }
}

bool is_grey(const l3d_light_color& color) {
    return color[0] == color[1] && color[1] == color[2];
}

void light_pixels(const l3d_shading& shading, const lit_material* materials,
                  const lit_pixels& pixels) {
    const l3d_lighting& lighting = shading.lighting;
    bool grey = is_grey(lighting.ambient) && is_grey(lighting.color);
    for (std::size_t i = 0; i < lighting.count; ++i)
        grey = grey && is_grey(lighting.lights[i].color);
    for (std::size_t i = 0; i < lighting.point_count; ++i)
        grey = grey && is_grey(lighting.points[i].color);
    if (grey)
        light_by<1>(shading, materials, pixels);
    else
        light_by<3>(shading, materials, pixels);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(light_pixels);

void lit_words::color(const lit_pixels& pixels) const {
    L3D_SIMD_CALL(light_pixels)(*shading_, materials_.data(), pixels);
}

void lit_words::color_slowly(const lit_pixels& pixels) const {
    lit_shader shader(*shading_, frame_materials_);
    for (std::int32_t row = 0; row < pixels.height; ++row)
        for (std::int32_t column = 0; column < pixels.width; ++column) {
            const std::ptrdiff_t at = row * pixels.depth_pitch + column;
            std::uint32_t& word = pixels.words[row * pixels.word_pitch + column];
            if (!(pixels.depths[at] > 0))
                continue;
            shader.use_material(word & 0xffff);
            const vector3 normal = normal_code{pixels.normals[at], word}.scaled();
            const vector3 own =
                lit_shader::own_way(*shading_, static_cast<float>(pixels.left + column) + 0.5F,
                                    static_cast<float>(pixels.top + row) + 0.5F);
            const std::array<float, lit_shader::components> numbers{
                normal[0], normal[1], normal[2], own[0], own[1], own[2], pixels.depths[at]};
            word = shader.word(numbers.data());
        }
}

} // namespace l3d_detail
#endif
