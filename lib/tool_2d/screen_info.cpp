// SPDX-License-Identifier: MIT
// l3d_screen_info: shifts, widths and tables from the masks.
#include "tool_2d/screen_info.h"

#include <cassert>

namespace {

l3d_channel channel_of(std::uint32_t mask) {
    const l3d_channel channel{std::countr_zero(mask), std::popcount(mask)};
    assert(channel.width >= 1 && channel.width <= 16);
    assert(mask >> channel.shift == (1U << channel.width) - 1);
    return channel;
}

std::uint32_t opaque_bits_of(const l3d_pixel_layout& layout) {
    return layout.depth == 32 ? ~(layout.red_mask | layout.green_mask | layout.blue_mask) : 0;
}

} // namespace

l3d_screen_info::l3d_screen_info(const l3d_pixel_layout& layout)
    : layout_(layout), red_(channel_of(layout.red_mask)), green_(channel_of(layout.green_mask)),
      blue_(channel_of(layout.blue_mask)), opaque_bits_(opaque_bits_of(layout)),
      red_pixels_(channel_pixels(red_)), green_pixels_(channel_pixels(green_)),
      blue_pixels_(channel_pixels(blue_)) {}

l3d_screen_info::table l3d_screen_info::channel_pixels(l3d_channel channel) {
    const std::uint32_t largest = (1U << channel.width) - 1;
    const std::uint32_t rounding = channel.width > 8 ? 255 / 2 : 0;
    table pixels{};
    for (std::uint32_t value = 0; value < pixels.size(); ++value) {
        pixels[value] = (value * largest + rounding) / 255 << channel.shift;
    }
    return pixels;
}
