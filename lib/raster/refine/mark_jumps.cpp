// SPDX-License-Identifier: MIT
// mark_jumps: differences of bytes, 64 pixels to a word of bits.
#include "raster/refine/mark_jumps_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/refine/mark_jumps.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using words = hn::CappedTag<std::uint32_t, 16>;
constexpr std::size_t lanes = hn::MaxLanes(words());

/// Words of a row or column, one after the other.
struct four_words {
    const std::uint32_t *a, *b, *c, *d;
};

#if HWY_TARGET == HWY_SCALAR
HWY_INLINE bool jumps(int a, int b, int c, int d) {
    const int rise = c - b, before = rise < 0 ? a - b : b - a, after = rise < 0 ? c - d : d - c;
    return std::abs(rise) - 2 * std::max(std::min(before, after), 0) > jump_levels;
}

HWY_INLINE std::uint64_t jump_bits(const four_words& w, std::size_t i) {
    for (int shift = 0; shift < 24; shift += 8) {
        const auto byte = [&](const std::uint32_t* of) {
            return static_cast<int>(of[i] >> shift & 255);
        };
        if (jumps(byte(w.a), byte(w.b), byte(w.c), byte(w.d)))
            return 1;
    }
    return 0;
}
#else
/// A bit for each lane in which a byte jumps from b to c.
HWY_INLINE std::uint64_t jump_bits(const four_words& w, std::size_t i) {
    const words d;
    const hn::Repartition<std::uint8_t, words> db;
    const auto load = [&](const std::uint32_t* of)
                          HWY_ATTR { return hn::BitCast(db, hn::LoadU(d, of + i)); };
    const auto a = load(w.a), b = load(w.b), c = load(w.c), e = load(w.d);
    const auto rest = [](auto rise, auto before, auto after) HWY_ATTR {
        const auto steady = hn::Min(before, after);
        return hn::SaturatedSub(rise, hn::SaturatedAdd(steady, steady));
    };
    const auto up = rest(hn::SaturatedSub(c, b), hn::SaturatedSub(b, a), hn::SaturatedSub(e, c));
    const auto down = rest(hn::SaturatedSub(b, c), hn::SaturatedSub(a, b), hn::SaturatedSub(c, e));
    const auto over = hn::SaturatedSub(hn::Or(up, down), hn::Set(db, jump_levels));
    std::uint8_t mask[8] = {};
    hn::StoreMaskBits(d, hn::Ne(hn::BitCast(d, over), hn::Zero(d)), mask);
    std::uint32_t bits = 0;
    std::memcpy(&bits, mask, sizeof bits);
    return bits;
}
#endif

/// A bit for each of 64 places at which there is a jump from b to c. Expects: 64 words may be read
/// of each.
HWY_INLINE std::uint64_t jumps_at(const four_words& w) {
    std::uint64_t result = 0;
    for (std::size_t i = 0; i < pixel_bits::word_pixels; i += lanes)
        result |= jump_bits(w, i) << i;
    return result;
}

/// 64 words of a row from column x on, one before them and two behind. Beyond its ends, the row
/// goes on with its first and last word.
class row_part {
public:
    HWY_INLINE const std::uint32_t* of(const std::uint32_t* row, std::int32_t x,
                                       std::int32_t width) {
        if (HWY_LIKELY(x > 0 && x + pixel_bits::word_pixels + 2 <= width))
            return row + x;
        for (std::int32_t i = 0; i < size; ++i)
            copy_[i] = row[std::clamp(x - 1 + i, 0, width - 1)];
        return copy_ + 1;
    }

private:
    static constexpr std::int32_t size = pixel_bits::word_pixels + 3;
    std::uint32_t copy_[size];
};

/// The jumps between rows y and y + 1, and between the columns of row y, of the 64 columns from x
/// on. A jump to the right of the last of these counts, too.
class jump_rows {
public:
    HWY_INLINE jump_rows(const l3d_pixels& picture, std::int32_t x) : picture_(picture), x_(x) {}

    HWY_INLINE std::uint64_t down(std::int32_t y) {
        const auto part = [&](std::size_t i) HWY_ATTR {
            const std::int32_t row = y - 1 + static_cast<std::int32_t>(i);
            return parts_[i].of(picture_.row(std::clamp(row, 0, picture_.height - 1)).data(), x_,
                                picture_.width);
        };
        return jumps_at({part(0), part(1), part(2), part(3)});
    }
    HWY_INLINE std::uint64_t right(std::int32_t y) {
        const std::uint32_t* const w = parts_[0].of(picture_.row(y).data(), x_, picture_.width);
        return jumps_at({w - 1, w, w + 1, w + 2});
    }

private:
    const l3d_pixels& picture_;
    std::int32_t x_;
    row_part parts_[4];
};

void mark_jumps(const l3d_pixels& picture, const l3d_pixel_box& where, pixel_bits& bits) {
    constexpr std::int32_t side = pixel_bits::word_pixels;
    const std::int32_t last = (where.right + side - 1) / side;
    for (std::int32_t w = where.left / side; w < last; ++w) {
        const std::uint64_t inside = pixel_bits::within(w, 0, picture.width);
        jump_rows rows(picture, w * side);
        std::uint64_t from_above = where.top > 0 ? rows.down(where.top - 1) & inside : 0;
        for (std::int32_t y = where.top; y < where.bottom; ++y) {
            const std::uint64_t right = rows.right(y), down = rows.down(y) & inside;
            bits.row(y)[w] |= right | right << 1 | down | from_above;
            if (w + 1 < static_cast<std::int32_t>(bits.row_words()))
                bits.row(y)[w + 1] |= right >> (side - 1);
            from_above = down;
        }
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(mark_jumps);

void mark_jumps(const l3d_pixels& picture, const l3d_pixel_box& where, pixel_bits& bits) {
    if (!where.empty())
        L3D_SIMD_CALL(mark_jumps)(picture, where, bits);
}

} // namespace l3d_detail
#endif
