// SPDX-License-Identifier: MIT
// fill_words: makes the words that lanes write into pixels.
#if defined(L3D_RASTER_SURFACES_FILL_WORDS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_SURFACES_FILL_WORDS_INL_H
#undef L3D_RASTER_SURFACES_FILL_WORDS_INL_H
#else
#define L3D_RASTER_SURFACES_FILL_WORDS_INL_H
#endif

#include "raster/surfaces/fill_table-inl.h"
#include "raster/shaders/normal_code_p.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// Shuffles that make a pixel word from the lowest byte of each sum. A grey repeats the byte in the
/// word's three lower bytes. A level takes the byte once, as the word's other bytes belong to the
/// material.
alignas(16) constexpr std::uint8_t bytes_of_greys[16] = {0, 0, 0, 0x80, 4,  4,  4,  0x80,
                                                         8, 8, 8, 0x80, 12, 12, 12, 0x80};
alignas(16) constexpr std::uint8_t bytes_of_levels[16] = {
    0, 0x80, 0x80, 0x80, 4, 0x80, 0x80, 0x80, 8, 0x80, 0x80, 0x80, 12, 0x80, 0x80, 0x80};

/// Makes words from a polygon's levels or normals.
template <class D> struct word_maker {
    using tag = hn::RebindToUnsigned<D>;
    using word_vec = hn::Vec<tag>;

    HWY_INLINE word_maker(const fill_table& table, std::size_t i)
#if HWY_TARGET == HWY_SCALAR // the scalar target has no bytes to shuffle
        : unit_(hn::Set(tag(), table.words.unit())), material_(hn::Set(tag(), table.material[i])){}
#else
        : bytes_(hn::LoadDup128(hn::Repartition<std::uint8_t, D>(),
                                table.words.has_materials ? bytes_of_levels : bytes_of_greys)),
          material_(hn::Set(tag(), table.material[i])),
          darkest_(hn::Or(material_, hn::Set(tag(), ambient * table.words.unit()))) {
    }
#endif

          /// Words of levels, which are rounded to the nearest. Expects: levels in [0, 255].
          HWY_INLINE word_vec of_levels(hn::Vec<D> level) const {
        return hn::Or(spread(hn::Add(level, hn::Set(D(), whole_numbers))), material_);
    }

    /// Packs words: the normal's z in the upper half, the material in the lower half. Expects: z
    /// times normal_code::scale.
    HWY_INLINE word_vec of_normal_z(hn::Vec<D> z) const {
        return hn::Or(hn::ShiftLeft<16>(rounded(z)), material_);
    }

    /// Packs words: the normal's x in the lower half, its y in the upper half. Expects: x and y
    /// times normal_code::scale.
    static HWY_INLINE word_vec of_normal_xy(hn::Vec<D> x, hn::Vec<D> y) {
        return hn::Or(hn::And(rounded(x), hn::Set(tag(), 0xffffu)), hn::ShiftLeft<16>(rounded(y)));
    }

    /// Words of the levels 26 + floor(max(0, lit)), at most 255. Expects: lit < 256.
    HWY_INLINE word_vec of_cosines(hn::Vec<D> lit) const {
        const D d;
        const auto sum =
            hn::Max(hn::Add(lit, hn::Set(d, whole_numbers - 0.5f)), hn::Set(d, whole_numbers));
#if HWY_TARGET == HWY_SCALAR
        const auto level = hn::And(hn::BitCast(tag(), sum), hn::Set(tag(), 0xffu));
        const auto grey = hn::Min(hn::Add(level, hn::Set(tag(), ambient)), hn::Set(tag(), 255u));
        return hn::Or(hn::Mul(grey, unit_), material_);
#else
        // A material's bytes are added to 0, and its level is held at 255.
        const hn::Repartition<std::uint8_t, D> bytes;
        return hn::BitCast(
            tag(), hn::SaturatedAdd(hn::BitCast(bytes, spread(sum)), hn::BitCast(bytes, darkest_)));
#endif
    }

private:
    static constexpr std::uint32_t ambient = 26;

    /// A number for rounding: if it is added to a smaller number, the last bits of the sum are the
    /// nearest integer.
    static constexpr float whole_numbers = 8388608.0f; // 2^23

    /// Words whose lower halves are the integers nearest to the given numbers.
    static HWY_INLINE word_vec rounded(hn::Vec<D> number) {
        return hn::BitCast(tag(), hn::Add(number, hn::Set(D(), normal_code::whole_numbers)));
    }

    /// Words that repeat the lowest byte of each sum in the bytes of a grey, or have it in the byte
    /// of a level.
    HWY_INLINE word_vec spread(hn::Vec<D> sum) const {
#if HWY_TARGET == HWY_SCALAR
        return hn::Mul(hn::And(hn::BitCast(tag(), sum), hn::Set(tag(), 0xffu)), unit_);
#else
        const hn::Repartition<std::uint8_t, D> bytes;
        return hn::BitCast(tag(), hn::TableLookupBytesOr0(hn::BitCast(bytes, sum), bytes_));
#endif
    }

#if HWY_TARGET == HWY_SCALAR
    word_vec unit_, material_;
#else
    hn::Vec<hn::Repartition<std::uint8_t, D>> bytes_;
    /// Words of the polygon's material: with level 0, and with the level of ambient light.
    word_vec material_, darkest_;
#endif
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
