// SPDX-License-Identifier: MIT
// material_words: colours each pixel by two products of 16-bit lanes.
#include "raster/shaders/material_words_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/shaders/material_words.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<std::uint32_t, 16> words;
using word_vec = hn::Vec<decltype(words)>;

HWY_INLINE void color_pixel(std::uint32_t& word, const std::uint32_t* colors) {
    word = color_of_level(colors[word >> 8], word & 0xff);
}

#if HWY_TARGET != HWY_SCALAR // the scalar target has no halves of words
constexpr hn::Repartition<std::uint16_t, decltype(words)> halves;
using half_vec = hn::Vec<decltype(halves)>;

/// The products of levels and colours over 255, rounded, in the upper bytes of 16-bit halves of
/// words. With x the product plus 128, the quotient is (x + floor(x / 256)) / 256, and all numbers
/// fit 16 bits.
HWY_INLINE half_vec products(half_vec levels, half_vec colors) {
    const half_vec x = hn::Add(hn::Mul(levels, colors), hn::Set(halves, 128));
    return hn::Add(x, hn::ShiftRight<8>(x));
}

/// The colours of a vector of words, cut apart: red and blue in one vector, and green in another.
struct color_halves {
    half_vec red_blue, green;

    HWY_INLINE explicit color_halves(word_vec colors)
        : red_blue(hn::And(hn::BitCast(halves, colors), hn::Set(halves, 0xff))),
          green(hn::ShiftRight<8>(hn::BitCast(halves, colors))) {}

    HWY_INLINE word_vec of(word_vec coded) const {
        const word_vec level = hn::And(coded, hn::Set(words, 0xffu));
        const half_vec both = hn::BitCast(halves, hn::Or(level, hn::ShiftLeft<16>(level)));
        return hn::Or(hn::BitCast(words, hn::ShiftRight<8>(products(both, red_blue))),
                      hn::And(hn::BitCast(words, products(hn::BitCast(halves, level), green)),
                              hn::Set(words, 0xff00u)));
    }
};

/// Colours vectors of words. Most vectors are full, and have the material of the vector before.
class word_colorer {
public:
    HWY_INLINE explicit word_colorer(const std::uint32_t* colors)
        : colors_(colors), material_(hn::Zero(words)), color_(hn::Set(words, colors[0])) {}

    HWY_INLINE void color(std::uint32_t* at, const float* depths) {
        const hn::RebindToFloat<decltype(words)> numbers;
        const auto filled = hn::Gt(hn::LoadU(numbers, depths), hn::Zero(numbers));
        if (HWY_LIKELY(hn::AllTrue(numbers, filled))) {
            const word_vec coded = hn::LoadU(words, at);
            hn::StoreU(colored(coded), words, at);
        } else if (!hn::AllFalse(numbers, filled)) {
            const auto mask = hn::RebindMask(words, filled);
            const word_vec there = hn::LoadU(words, at);
            const word_vec coded = hn::IfThenElseZero(mask, there);
            hn::StoreU(hn::IfThenElse(mask, by_each(coded), there), words, at);
        }
    }

private:
    HWY_INLINE word_vec colored(word_vec coded) {
        const word_vec material = hn::ShiftRight<8>(coded);
        if (HWY_LIKELY(hn::AllTrue(words, hn::Eq(material, material_))))
            return color_.of(coded);
        const std::uint32_t first = hn::GetLane(material);
        material_ = hn::Set(words, first);
        color_ = color_halves(hn::Set(words, colors_[first]));
        return hn::AllTrue(words, hn::Eq(material, material_)) ? color_.of(coded) : by_each(coded);
    }

    HWY_INLINE word_vec by_each(word_vec coded) const {
        const hn::RebindToSigned<decltype(words)> places;
        return color_halves(
                   hn::GatherIndex(words, colors_, hn::BitCast(places, hn::ShiftRight<8>(coded))))
            .of(coded);
    }

    const std::uint32_t* colors_;
    word_vec material_; ///< the material in the words of the last vector
    color_halves color_;
};
#endif

void color_words(const material_pixels& pixels, const std::uint32_t* colors) {
#if HWY_TARGET != HWY_SCALAR
    word_colorer colorer(colors);
#endif
    const auto width = static_cast<std::size_t>(pixels.width);
    for (std::int32_t row = 0; row < pixels.height; ++row) {
        std::uint32_t* const at = pixels.words + row * pixels.word_pitch;
        const float* const depths = pixels.depths + row * pixels.depth_pitch;
        std::size_t i = 0;
#if HWY_TARGET != HWY_SCALAR
        for (; i + hn::Lanes(words) <= width; i += hn::Lanes(words))
            colorer.color(at + i, depths + i);
#endif
        for (; i < width; ++i)
            if (depths[i] > 0)
                color_pixel(at[i], colors);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(color_words);

void material_words::color(const material_pixels& pixels) const {
    L3D_SIMD_CALL(color_words)(pixels, colors_.data());
}

void material_words::color_slowly(const material_pixels& pixels) const {
    for (std::int32_t row = 0; row < pixels.height; ++row)
        for (std::int32_t column = 0; column < pixels.width; ++column) {
            std::uint32_t& word = pixels.words[row * pixels.word_pitch + column];
            if (pixels.depths[row * pixels.depth_pitch + column] > 0)
                word = color_of_level(colors_[word >> 8], word & 0xff);
        }
}

} // namespace l3d_detail
#endif
