// SPDX-License-Identifier: MIT
// l3d_screen_info: finds shifts, widths and tables from masks and palettes.
#include "tool_2d/screen_info.h"

#include <cassert>
#include <locale>
#include <sstream>
#include <utility>

namespace {

using table = std::array<std::uint32_t, 256>;

l3d_channel channel_of(std::uint32_t mask) {
    if (mask == 0)
        return {};
    const l3d_channel channel{std::countr_zero(mask), std::popcount(mask)};
    assert(channel.width <= 16 && mask >> channel.shift == (1U << channel.width) - 1);
    return channel;
}

std::uint32_t opaque_bits_of(const l3d_pixel_layout& layout) {
    return layout.depth == 32 ? ~(layout.red_mask | layout.green_mask | layout.blue_mask) : 0;
}

table bits_of(l3d_channel channel) {
    assert(channel.width >= 1);
    const std::uint32_t largest = (1U << channel.width) - 1;
    const std::uint32_t rounding = channel.width > 8 ? 255 / 2 : 0;
    table bits{};
    for (std::uint32_t value = 0; value < bits.size(); ++value)
        bits[value] = (value * largest + rounding) / 255 << channel.shift;
    return bits;
}

/// For each channel value, the place of its nearest level among the palette's pixels: the level
/// times the distance between neighbouring levels of the channel.
table places_of(int levels, int distance) {
    table places{};
    for (int value = 0, level = 0; value < 256; ++value) {
        while (level + 1 < levels && 2 * value > l3d_palette::value_of(level, levels) +
                                                     l3d_palette::value_of(level + 1, levels))
            ++level;
        places[static_cast<std::size_t>(value)] = static_cast<std::uint32_t>(level * distance);
    }
    return places;
}

} // namespace

const char* l3d_name_of(l3d_color_class color_class) {
    constexpr std::array names{"StaticGray",  "GrayScale", "StaticColor",
                               "PseudoColor", "TrueColor", "DirectColor"};
    return names.at(static_cast<std::size_t>(color_class));
}

std::string l3d_pixel_layout::describe() const {
    std::ostringstream text;
    text.imbue(std::locale::classic()); // the host's locale would group digits
    text << l3d_name_of(color_class) << ", depth " << depth << ", " << bits_per_pixel
         << " bits per pixel, " << (byte_order == std::endian::little ? "low" : "high")
         << " byte first";
    if ((red_mask | green_mask | blue_mask) != 0)
        text << ", masks " << std::hex << red_mask << "/" << green_mask << "/" << blue_mask;
    return text.str();
}

l3d_screen_info::l3d_screen_info(const l3d_pixel_layout& layout, l3d_palette palette)
    : layout_(layout), palette_(std::move(palette)), red_(channel_of(layout.red_mask)),
      green_(channel_of(layout.green_mask)), blue_(channel_of(layout.blue_mask)),
      opaque_bits_(opaque_bits_of(layout)) {
    if (has_palette()) {
        assert(palette_.pixels.size() ==
               static_cast<std::size_t>(palette_.red * palette_.green * palette_.blue));
        red_parts_ = places_of(palette_.red, palette_.green * palette_.blue);
        green_parts_ = places_of(palette_.green, palette_.blue);
        blue_parts_ = places_of(palette_.blue, 1);
    } else {
        red_parts_ = bits_of(red_);
        green_parts_ = bits_of(green_);
        blue_parts_ = bits_of(blue_);
    }
}

bool l3d_screen_info::native_is_word() const {
    auto layout = layout_;
    layout.color_class = l3d_color_class::true_color;
    return !has_palette() && layout == l3d_pixel_layout{};
}

std::string l3d_screen_info::describe() const {
    std::ostringstream text;
    text.imbue(std::locale::classic()); // the host's locale would group digits
    text << layout_.describe();
    if (!has_palette())
        return text.str();
    text << ", " << palette_.red;
    if (!palette_.is_ramp())
        text << "x" << palette_.green << "x" << palette_.blue;
    text << (palette_.is_ramp() ? " grays" : " colours");
    if (palette_.deviation != 0)
        text << ", exact within " << palette_.deviation << "/255";
    return text.str();
}
