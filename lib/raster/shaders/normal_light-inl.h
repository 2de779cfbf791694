// SPDX-License-Identifier: MIT
// normal_light: lambert_shader's greys of many normals.
#if defined(L3D_RASTER_SHADERS_NORMAL_LIGHT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_SHADERS_NORMAL_LIGHT_INL_H
#undef L3D_RASTER_SHADERS_NORMAL_LIGHT_INL_H
#else
#define L3D_RASTER_SHADERS_NORMAL_LIGHT_INL_H
#endif

#include <array>
#include <cfloat>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// round(255 intensity).
template <class D>
HWY_INLINE hn::Vec<hn::RebindToUnsigned<D>> level_of_intensity(D d, hn::Vec<D> intensity) {
    const auto level = hn::Add(hn::Mul(hn::Set(d, 255.0f), intensity), hn::Set(d, 0.5f));
    return hn::BitCast(hn::RebindToUnsigned<D>(), hn::ConvertTo(hn::RebindToSigned<D>(), level));
}

/// Operation by operation what lambert_shader does, so that each pixel gets the same bits.
template <class D> class normal_light {
public:
    using vec = hn::Vec<D>;

    HWY_INLINE explicit normal_light(const std::array<float, 3>& light) {
        for (std::size_t i = 0; i < light.size(); ++i)
            light_[i] = hn::Set(D(), light[i]);
    }

    HWY_INLINE vec intensity(vec x, vec y, vec z, hn::Mask<D> away) const {
        const D d;
        const vec square = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
        const vec least = hn::Set(d, FLT_MIN);
        const vec safe = hn::IfThenElse(hn::Gt(square, least), square, least);
        const vec product =
            hn::Add(hn::Add(hn::Mul(light_[0], x), hn::Mul(light_[1], y)), hn::Mul(light_[2], z));
        const vec cosine = hn::Div(product, hn::Sqrt(safe));
        const vec zero = hn::Zero(d), one = hn::Set(d, 1.0f);
        const vec turned = hn::IfThenElse(away, hn::Neg(cosine), cosine);
        const vec lit = hn::IfThenElse(hn::Gt(turned, zero), turned, zero);
        return hn::Add(hn::Set(d, 0.1f),
                       hn::Mul(hn::Set(d, 0.9f), hn::IfThenElse(hn::Lt(lit, one), lit, one)));
    }

    HWY_INLINE hn::Vec<hn::RebindToUnsigned<D>> level(vec x, vec y, vec z, hn::Mask<D> away) const {
        return level_of_intensity(D(), intensity(x, y, z, away));
    }

private:
    vec light_[3];
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
