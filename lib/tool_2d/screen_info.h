// SPDX-License-Identifier: MIT
// l3d_screen_info: the format of a display's native pixels, and the conversion of colours to them.
#ifndef L3D_TOOL_2D_SCREEN_INFO_H
#define L3D_TOOL_2D_SCREEN_INFO_H

#include "base/color.h"
#include "base/public.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// The way in which a display finds a pixel's colour: in a map of colours or grays, by masks, or by
/// masks and a map for each channel. Static maps cannot be changed.
enum class L3D_PUBLIC l3d_color_class {
    static_gray,  ///< grays in a map that cannot be changed
    gray_scale,   ///< grays in a map that can be changed
    static_color, ///< colours in a map that cannot be changed
    pseudo_color, ///< colours in a map that can be changed
    true_color,   ///< masks: the usual display of today
    direct_color, ///< masks, and a map for each channel
};

/// The name of a class as X spells it, "TrueColor".
L3D_PUBLIC const char* l3d_name_of(l3d_color_class color_class);

/// The description that a display gives of its pixels. The defaults are those of l3d_pixels itself.
///
/// Expects: each mask is one run of ones, at most 16 wide, and no two overlap. All masks are 0 if a
///          pixel is only the number of a cell in a map of colours.
struct L3D_PUBLIC l3d_pixel_layout {
    int depth = 24;                               ///< bits of a pixel that mean something
    int bits_per_pixel = 32;                      ///< bits that a pixel takes in memory
    std::uint32_t red_mask = 0xFF0000;            ///< the bits of red in a pixel
    std::uint32_t green_mask = 0x00FF00;          ///< the bits of green in a pixel
    std::uint32_t blue_mask = 0x0000FF;           ///< the bits of blue in a pixel
    std::endian byte_order = std::endian::native; ///< order of a stored pixel's bytes
    int scanline_pad = 32; ///< every row starts at a multiple of this number of bits
    l3d_color_class color_class = l3d_color_class::true_color; ///< how colours are found

    /// Describes the layout in one phrase: class, depth, bits per pixel, byte order, masks.
    std::string describe() const;

    friend bool operator==(const l3d_pixel_layout&, const l3d_pixel_layout&) = default;
};

/// The bits in which a native pixel holds one channel: red, green or blue.
struct L3D_PUBLIC l3d_channel {
    int shift = 0; ///< the number of bits below the channel's
    int width = 0; ///< the number of the channel's bits; 0 if pixels have no channels
};

/// The native pixels that show our colours on a display with few: a cube of colours, or a ramp of
/// grays.
///
/// Shape:   pixels[(r * green + g) * blue + b] shows level r of `red` levels, g of `green`, b of
///          `blue`; on a ramp, `red` counts the grays, and the others are 1.
/// Expects: 2 to 256 levels in each channel, or only in `red` on a ramp.
struct L3D_PUBLIC l3d_palette {
    int red = 0;                       ///< levels of red, or of gray on a ramp
    int green = 0;                     ///< levels of green; 1 on a ramp
    int blue = 0;                      ///< levels of blue; 1 on a ramp
    std::vector<std::uint32_t> pixels; ///< the native pixels; empty if masks are used instead
    /// The largest difference, in any channel and in 255ths, between the colour that a pixel shows
    /// and the value of the pixel's level. The difference is not 0 if the display's map had no room
    /// for exact colours.
    int deviation = 0;

    /// Whether the palette has grays only.
    bool is_ramp() const { return green == 1; }

    /// The channel value, 0..255, of one of a palette's levels: level * 255 / (levels - 1), to
    /// nearest.
    /// Expects: levels >= 2.
    static int value_of(int level, int levels) {
        return (2 * 255 * level + levels - 1) / (2 * (levels - 1));
    }
};

/// The format of one display's native pixels. A value: copy it freely.
///
/// Cost:    three tables of 256 words. Converting a pixel takes three loads, or four with a
///          palette.
/// Source:  the scaling of few bits is that of Lin, Linux 3D Graphics Programming, chapter 2.
class L3D_PUBLIC l3d_screen_info final {
public:
    /// Makes the tables for this layout or palette.
    /// Expects: masks or a palette; with both, pixels are those of the palette.
    explicit l3d_screen_info(const l3d_pixel_layout& layout = {}, l3d_palette palette = {});

    /// The display's own description.
    const l3d_pixel_layout& layout() const { return layout_; }
    /// The native pixels that show our colours, as numbers in the display's colour map. Empty if
    /// masks are used.
    const l3d_palette& palette() const { return palette_; }
    /// Whether pixels are numbers of a colour map, not colours themselves.
    bool has_palette() const { return !palette_.pixels.empty(); }
    /// Bytes that a pixel takes in memory.
    int bytes_per_pixel() const { return layout_.bits_per_pixel / 8; }
    /// The bits of red; none if pixels have no channels.
    l3d_channel red() const { return red_; }
    /// The bits of green; none if pixels have no channels.
    l3d_channel green() const { return green_; }
    /// The bits of blue; none if pixels have no channels.
    l3d_channel blue() const { return blue_; }

    /// The bits that are set in every native pixel. On a 32-bit deep display these are the bits
    /// that no colour uses, since a compositor takes them for opacity. On other displays, they are
    /// 0.
    std::uint32_t opaque_bits() const { return opaque_bits_; }

    /// Whether a pixel word, as this machine stores it, already is the native pixel.
    bool native_is_word() const;

    /// Describes the format in one phrase: the layout, and the palette if there is one.
    std::string describe() const;

    /// Darkens a word's colour: multiplies each channel by intensity / 255, and rounds to nearest.
    /// The colour becomes black at 0, and stays itself at 255.
    ///
    /// Expects: 0 <= intensity <= 255.
    /// Cost:    two products for three channels. The book's tables do the same; a load for each
    ///          channel is no faster, and cannot be done for many pixels at once.
    static std::uint32_t light_native(std::uint32_t word, std::uint32_t intensity) {
        // Two channels share a product: 255 * 255 + 128 + 254 is below 2^16. For v up to 255 * 255,
        // x = v + 128 gives v / 255 to nearest as (x + (x >> 8)) >> 8.
        const auto scaled = [intensity](std::uint32_t channels) {
            const std::uint32_t x = channels * intensity + 0x800080;
            return (x + (x >> 8 & 0xFF00FF)) >> 8 & 0xFF00FF;
        };
        return scaled(word & 0xFF00FF) | scaled(word >> 8 & 0xFF) << 8;
    }

    /// Blends a word's colour with white fog. The colour stays itself at 0, and becomes white at
    /// 255.
    /// Expects: 0 <= intensity <= 255.
    static std::uint32_t fog_native(std::uint32_t word, std::uint32_t intensity) {
        return 0xFFFFFF - light_native(0xFFFFFF - word, 255 - intensity);
    }

    /// The grey, 0..255, that is as bright as a word's colour. A grey gives its own value.
    /// Source:  the weights of ITU-R BT.601; the sum is rounded to nearest.
    static std::uint32_t gray_of(std::uint32_t word) {
        return ((word >> 16 & 255) * 299 + (word >> 8 & 255) * 587 + (word & 255) * 114 + 500) /
               1000;
    }

    /// The display's own pixel value for a word.
    ///
    /// With masks, a channel value v becomes v * max / 255, where max is the channel's largest
    /// value on the display. Below 8 bits the result is rounded down, as in the book, so that each
    /// level stands for an equal share of the 256 values. At 8 bits the value stays as it is. Above
    /// 8 bits the result is rounded to nearest, so that 0 and 255 stay the ends.
    ///
    /// With a cube, a channel value becomes the nearest level, or the lower of two equally near.
    /// The shown colour differs by at most half the gap between two levels, plus the palette's
    /// deviation. On a ramp, this holds for the grey that gray_of gives.
    std::uint32_t to_display(std::uint32_t word) const {
        if (!has_palette())
            return by_masks(word);
        return palette_.pixels[sum_of_tables(palette_.is_ramp() ? gray_of(word) << 16 : word)];
    }

    /// Converts as to_display does, without looking for a palette.
    /// Expects: no palette.
    std::uint32_t by_masks(std::uint32_t word) const { return sum_of_tables(word) | opaque_bits_; }

private:
    using table = std::array<std::uint32_t, 256>;

    std::uint32_t sum_of_tables(std::uint32_t word) const {
        return red_parts_[word >> 16 & 255] + green_parts_[word >> 8 & 255] +
               blue_parts_[word & 255];
    }

    l3d_pixel_layout layout_;
    l3d_palette palette_;
    l3d_channel red_, green_, blue_;
    std::uint32_t opaque_bits_;
    /// The amount that each channel value adds to the native pixel or, if there is a palette, to
    /// the index in the palette's pixels.
    table red_parts_, green_parts_, blue_parts_;
};

#endif
