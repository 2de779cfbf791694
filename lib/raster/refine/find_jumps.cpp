// SPDX-License-Identifier: MIT
// find_jumps: a channel's levels as bytes, 64 pixels to a word of bits.
#include "raster/refine/find_jumps_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/refine/find_jumps.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::int32_t side = pixel_bits::word_pixels;
constexpr hn::CappedTag<std::uint32_t, 16> words;
constexpr hn::Rebind<std::uint8_t, decltype(words)> few_levels;
constexpr hn::CappedTag<std::uint8_t, side> levels;

/// A channel of 64 pixels of a row, of one before them and of two behind. Beyond its ends, the row
/// goes on with its first and last pixel.
struct level_row {
    static constexpr std::int32_t before = 16, size = before + side + 16;
    alignas(64) std::uint8_t at[size];

    HWY_INLINE void load(const l3d_pixels& picture, std::int32_t x, std::int32_t y, int shift) {
        const std::uint32_t* const row = picture.row(std::clamp(y, 0, picture.height - 1)).data();
        if (HWY_LIKELY(x > 0 && x + side + 2 <= picture.width)) {
            const auto lanes = static_cast<std::int32_t>(hn::Lanes(words));
            for (std::int32_t i = 0; i < side; i += lanes)
                hn::StoreU(hn::TruncateTo(few_levels,
                                          hn::ShiftRightSame(hn::LoadU(words, row + x + i), shift)),
                           few_levels, at + before + i);
            for (const std::int32_t i : {-1, side, side + 1})
                at[before + i] = static_cast<std::uint8_t>(row[x + i] >> shift);
        } else {
            for (std::int32_t i = -1; i < side + 2; ++i)
                at[before + i] = static_cast<std::uint8_t>(
                    row[std::clamp(x + i, 0, picture.width - 1)] >> shift);
        }
    }
    const std::uint8_t* from(std::int32_t i) const { return at + before + i; }
};

/// A bit for each of 64 places at which there is a jump from b to c.
template <jump_rule Rule>
HWY_INLINE std::uint64_t jumps_at(const std::uint8_t* a, const std::uint8_t* b,
                                  const std::uint8_t* c, const std::uint8_t* e) {
    const auto rest = [](auto rise, auto before, auto after) HWY_ATTR {
        const auto steady =
            Rule == jump_rule::smooth ? hn::Max(before, after) : hn::Min(before, after);
        return hn::SaturatedSub(hn::SaturatedSub(rise, steady), steady);
    };
    const auto lanes = hn::Lanes(levels);
    std::uint8_t bytes[16] = {};
    std::uint64_t result = 0;
    for (std::size_t i = 0; i < side; i += lanes) {
        const auto la = hn::LoadU(levels, a + i), lb = hn::LoadU(levels, b + i);
        const auto lc = hn::LoadU(levels, c + i), le = hn::LoadU(levels, e + i);
        const auto up =
            rest(hn::SaturatedSub(lc, lb), hn::SaturatedSub(lb, la), hn::SaturatedSub(le, lc));
        const auto down =
            rest(hn::SaturatedSub(lb, lc), hn::SaturatedSub(la, lb), hn::SaturatedSub(lc, le));
        const auto over = hn::SaturatedSub(hn::Max(up, down), hn::Set(levels, jump_levels));
        hn::StoreMaskBits(levels, hn::Ne(over, hn::Zero(levels)), bytes);
        std::uint64_t bits = 0;
        std::memcpy(&bits, bytes, sizeof bits);
        result |= bits << i;
    }
    return result;
}

template <jump_rule Rule>
HWY_INLINE void find_by(const l3d_pixels& picture, bool grey, const l3d_pixel_box& where,
                        level_jumps& jumps) {
    const std::int32_t last = (where.right + side - 1) / side;
    for (int shift = 0; shift < (grey ? 8 : 24); shift += 8)
        for (std::int32_t w = where.left / side; w < last; ++w) {
            // Beyond its right end, the picture goes on with its last column, jumps and all.
            const std::uint64_t inside = pixel_bits::within(w, 0, picture.width);
            level_row rows[4]; // y - 1 to y + 2, that of row y in place y % 4
            const auto row = [&](std::int32_t y) -> level_row& { return rows[(y + 4) % 4]; };
            for (std::int32_t y = where.top - 1; y < where.top + 2; ++y)
                row(y).load(picture, w * side, y, shift);
            for (std::int32_t y = where.top; y < where.bottom; ++y) {
                row(y + 2).load(picture, w * side, y + 2, shift);
                const level_row& here = row(y);
                jumps.right.row(y)[w] |=
                    jumps_at<Rule>(here.from(-1), here.from(0), here.from(1), here.from(2));
                jumps.down.row(y)[w] |=
                    inside & jumps_at<Rule>(row(y - 1).from(0), here.from(0), row(y + 1).from(0),
                                            row(y + 2).from(0));
            }
        }
}

void find_jumps(const l3d_pixels& picture, bool grey, jump_rule rule, const l3d_pixel_box& where,
                level_jumps& jumps) {
    if (rule == jump_rule::smooth)
        find_by<jump_rule::smooth>(picture, grey, where, jumps);
    else
        find_by<jump_rule::any>(picture, grey, where, jumps);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(find_jumps);

void find_jumps(const l3d_pixels& picture, bool grey, jump_rule rule, const l3d_pixel_box& where,
                level_jumps& jumps) {
    if (!where.empty())
        L3D_SIMD_CALL(find_jumps)(picture, grey, rule, where, jumps);
}

} // namespace l3d_detail
#endif
