// SPDX-License-Identifier: MIT
// normal_code: a normal in two words of a pixel.
#ifndef L3D_RASTER_SHADERS_NORMAL_CODE_P_H
#define L3D_RASTER_SHADERS_NORMAL_CODE_P_H

#include <array>
#include <bit>
#include <cstdint>

namespace l3d_detail {

/// A normal in two words, to be stored in place of a pixel's colour, with components rounded to
/// multiples of 1 / scale, 16 bits each.
///
/// Components are at most 1 for unit normals, and at most 1.75 on a plane through four corners, so
/// they fit into 16 bits. The error of a normal of length 1 is at most sqrt(3) / 2 / scale =
/// 2^-14.2.
struct normal_code {
    static constexpr float scale = 16383;

    /// A number for rounding, 3 * 2^22. If it is added to a number below 2^15 in size, the last 16
    /// bits of the sum are the last 16 bits of the nearest integer.
    static constexpr float whole_numbers = 12582912;

    std::uint32_t xy = 0; ///< the normal's x in the lower half, its y in the upper half
    /// The normal's z in the upper half; the lower half is free for other data.
    std::uint32_t z = 0;

    /// Encodes a normal. Expects: components below 2 in size.
    static normal_code of(const float* normal) {
        const auto rounded = [](float number) {
            return std::bit_cast<std::uint32_t>(number * scale + whole_numbers) & 0xffff;
        };
        return {rounded(normal[0]) | rounded(normal[1]) << 16, rounded(normal[2]) << 16};
    }

    /// The normal times `scale`; the lower half of `z` is ignored.
    std::array<float, 3> scaled() const {
        const auto upper = [](std::uint32_t word) {
            return static_cast<float>(static_cast<std::int32_t>(word) >> 16);
        };
        return {upper(xy << 16), upper(xy), upper(z)};
    }
};

} // namespace l3d_detail

#endif
