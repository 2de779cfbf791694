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

/// l3d_product_of_colors of a colour and greys. A number n < 2^16 - 1 divided by 255 is (n + 1 + n
/// / 256) / 256, both rounded down.
template <class D> HWY_INLINE hn::Vec<D> colored(D d, std::uint32_t color, hn::Vec<D> level) {
    const auto product = [&](std::uint32_t channel) HWY_ATTR {
        const auto n = hn::Add(hn::Mul(hn::Set(d, channel & 255), level), hn::Set(d, 127u));
        return hn::ShiftRight<8>(hn::Add(hn::Add(n, hn::Set(d, 1u)), hn::ShiftRight<8>(n)));
    };
    return hn::Or(hn::ShiftLeft<16>(product(color >> 16)),
                  hn::Or(hn::ShiftLeft<8>(product(color >> 8)), product(color)));
}

/// Operation by operation what lambert_shader does, so that each pixel gets the same bits. That
/// turns a cosine round where this does a product, which only changes the sign of either.
template <class D> class normal_light {
public:
    using vec = hn::Vec<D>;

    HWY_INLINE explicit normal_light(const std::array<float, 3>& light) {
        for (std::size_t i = 0; i < light.size(); ++i)
            light_[i] = hn::Set(D(), light[i]);
    }

    /// A normal's square, and its product with the light, turned to the eye.
    struct squares {
        vec square, product;
    };
    HWY_INLINE squares squares_of(vec x, vec y, vec z, hn::Mask<D> away) const {
        const vec square = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
        const vec product =
            hn::Add(hn::Add(hn::Mul(light_[0], x), hn::Mul(light_[1], y)), hn::Mul(light_[2], z));
        return {square, hn::IfThenElse(away, hn::Neg(product), product)};
    }

    HWY_INLINE static vec intensity(const squares& of) {
        const D d;
        const vec least = hn::Set(d, FLT_MIN);
        const vec safe = hn::IfThenElse(hn::Gt(of.square, least), of.square, least);
        const vec cosine = hn::Div(of.product, hn::Sqrt(safe));
        const vec zero = hn::Zero(d), one = hn::Set(d, 1.0f);
        const vec lit = hn::IfThenElse(hn::Gt(cosine, zero), cosine, zero);
        return hn::Add(hn::Set(d, 0.1f),
                       hn::Mul(hn::Set(d, 0.9f), hn::IfThenElse(hn::Lt(lit, one), lit, one)));
    }
    HWY_INLINE vec intensity(vec x, vec y, vec z, hn::Mask<D> away) const {
        return intensity(squares_of(x, y, z, away));
    }

private:
    vec light_[3];
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
