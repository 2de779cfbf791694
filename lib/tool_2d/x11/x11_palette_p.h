// SPDX-License-Identifier: MIT
// palette_shape: the colours of a palette, and the cells of a map that come near them.
#ifndef L3D_TOOL_2D_X11_X11_PALETTE_P_H
#define L3D_TOOL_2D_X11_X11_PALETTE_P_H

#include "tool_2d/screen_info.h"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace l3d_detail {

/// The levels of a cube, or of a ramp: then green and blue are 1.
struct palette_shape {
    int red = 0;
    int green = 0;
    int blue = 0;

    static palette_shape cube(int levels) { return {levels, levels, levels}; }
    static palette_shape ramp(int levels) { return {levels, 1, 1}; }

    bool is_ramp() const { return green == 1; }
    int size() const { return red * green * blue; }

    /// The colour of a place in the palette, as a pixel word.
    std::uint32_t color(int place) const;

    /// Distance of two colours in their worst channel, in 510ths of a step of that channel.
    int distance(std::uint32_t one, std::uint32_t other) const;

    /// Whether no channel is off by more than half a step, so that a dither still mixes colours of
    /// both sides.
    bool is_near(std::uint32_t one, std::uint32_t other) const {
        return distance(one, other) <= 255;
    }

    /// Expects: pixels of shape size().
    l3d_palette palette(std::vector<std::uint32_t> pixels, int deviation) const {
        return {red, green, blue, std::move(pixels), deviation};
    }
};

/// The largest difference of two words in a channel, 0..255.
int channel_difference(std::uint32_t one, std::uint32_t other);

/// The largest palette that an unchangeable map allows; each place has the nearest cell.
/// Errors: nothing, if the map lacks cells near black and white, or, but for a ramp, near the six
///         other corners of the cube.
std::optional<l3d_palette> palette_of_cells(std::span<const std::uint32_t> cells, bool ramp);

/// The palette whose pixels masks make: its dither hides how few bits they have.
l3d_palette palette_of_masks(const l3d_screen_info& info);

} // namespace l3d_detail

#endif
