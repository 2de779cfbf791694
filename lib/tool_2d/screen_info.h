// SPDX-License-Identifier: MIT
// l3d_screen_info: how a display's native pixels look, and how colours become them.
#ifndef L3D_TOOL_2D_SCREEN_INFO_H
#define L3D_TOOL_2D_SCREEN_INFO_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

/// What a display says about its pixels. The defaults are those of l3d_pixels itself.
///
/// Expects: each mask one run of ones, at most 16 wide, none overlapping another.
struct l3d_pixel_layout {
    int depth = 24;          ///< bits that mean something
    int bits_per_pixel = 32; ///< bits that are stored
    std::uint32_t red_mask = 0xFF0000;
    std::uint32_t green_mask = 0x00FF00;
    std::uint32_t blue_mask = 0x0000FF;
    std::endian byte_order = std::endian::native;
    int scanline_pad = 32; ///< every row starts at a multiple of so many bits
    friend bool operator==(const l3d_pixel_layout&, const l3d_pixel_layout&) = default;
};

/// Where one channel sits in a native pixel.
struct l3d_channel {
    int shift = 0; ///< zero bits below it
    int width = 0; ///< bits
};

/// How the native pixels of one display look. A value: copy it freely.
///
/// Cost:    three tables of 256 words, so that converting a pixel is three loads.
/// Source:  the scaling of few bits is that of Lin, Linux 3D Graphics Programming, chapter 2.
class l3d_screen_info final {
public:
    explicit l3d_screen_info(const l3d_pixel_layout& layout = {});

    const l3d_pixel_layout& layout() const { return layout_; }
    int bytes_per_pixel() const { return layout_.bits_per_pixel / 8; }
    l3d_channel red() const { return red_; }
    l3d_channel green() const { return green_; }
    l3d_channel blue() const { return blue_; }

    /// The bits set in every native pixel: on a 32-bit deep display those that no colour uses,
    /// since a compositor takes them for opacity; otherwise 0.
    std::uint32_t opaque_bits() const { return opaque_bits_; }

    /// Whether a pixel word, stored by this machine, is already the native pixel.
    bool native_is_word() const { return layout_ == l3d_pixel_layout{}; }

    /// The word that goes into l3d_pixels, 0x00RRGGBB.
    /// Units:   channels 0..255; others are clamped.
    static std::uint32_t ext_to_native(int red, int green, int blue) {
        return channel_byte(red) << 16 | channel_byte(green) << 8 | channel_byte(blue);
    }

    /// The display's own pixel value for such a word.
    ///
    /// A channel value v becomes v * max / 255, where max is the display's largest: rounded down
    /// below 8 bits, as the book does, so that each level stands for an equal share of the 256;
    /// the same number at 8 bits; rounded to nearest above, so that 0 and 255 stay the ends.
    std::uint32_t to_display(std::uint32_t word) const {
        return red_pixels_[word >> 16 & 255] | green_pixels_[word >> 8 & 255] |
               blue_pixels_[word & 255] | opaque_bits_;
    }

private:
    using table = std::array<std::uint32_t, 256>;

    static std::uint32_t channel_byte(int value) {
        return static_cast<std::uint32_t>(std::clamp(value, 0, 255));
    }
    static table channel_pixels(l3d_channel channel);

    l3d_pixel_layout layout_;
    l3d_channel red_, green_, blue_;
    std::uint32_t opaque_bits_;
    table red_pixels_, green_pixels_, blue_pixels_;
};

#endif
