// SPDX-License-Identifier: MIT
// palette_shape: distances, and the search for the largest palette.
#include "tool_2d/x11/x11_palette_p.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace l3d_detail {
namespace {

using channels = std::array<int, 3>;

channels channels_of(std::uint32_t word) {
    return {static_cast<int>(word >> 16 & 255), static_cast<int>(word >> 8 & 255),
            static_cast<int>(word & 255)};
}

// What a map that nobody can change may hold; 8x8x4 is what eight bits make as masks do it.
constexpr std::array<palette_shape, 8> cubes{
    {{16, 16, 16}, {8, 8, 8}, {8, 8, 4}, {6, 6, 6}, {5, 5, 5}, {4, 4, 4}, {3, 3, 3}, {2, 2, 2}}};
constexpr std::array<palette_shape, 8> ramps{{{256, 1, 1},
                                              {128, 1, 1},
                                              {64, 1, 1},
                                              {32, 1, 1},
                                              {16, 1, 1},
                                              {8, 1, 1},
                                              {4, 1, 1},
                                              {2, 1, 1}}};

std::optional<l3d_palette> palette_of_shape(const palette_shape& shape,
                                            std::span<const std::uint32_t> cells) {
    std::vector<std::uint32_t> pixels;
    int deviation = 0;
    for (int place = 0; place < shape.size(); ++place) {
        const auto color = shape.color(place);
        const auto nearest = std::ranges::min_element(
            cells, {}, [&](std::uint32_t cell) { return shape.distance(cell, color); });
        if (nearest == cells.end() || !shape.is_near(*nearest, color))
            return std::nullopt;
        pixels.push_back(static_cast<std::uint32_t>(nearest - cells.begin()));
        deviation = std::max(deviation, channel_difference(*nearest, color));
    }
    return shape.palette(std::move(pixels), deviation);
}

} // namespace

std::uint32_t palette_shape::color(int place) const {
    const auto value = [](int level, int levels) { return l3d_palette::value_of(level, levels); };
    if (is_ramp())
        return static_cast<std::uint32_t>(value(place, red)) * 0x010101;
    return l3d_screen_info::ext_to_native(value(place / (green * blue), red),
                                          value(place / blue % green, green),
                                          value(place % blue, blue));
}

int palette_shape::distance(std::uint32_t one, std::uint32_t other) const {
    const auto a = channels_of(one), b = channels_of(other);
    // A step is 255 / (levels - 1). On a ramp red speaks for all channels.
    const channels steps{red - 1, green - 1, blue - 1};
    int worst = 0;
    for (std::size_t i = 0; i < steps.size(); ++i)
        worst = std::max(worst, 2 * std::abs(a[i] - b[i]) * steps[i]);
    return worst;
}

int channel_difference(std::uint32_t one, std::uint32_t other) {
    const auto a = channels_of(one), b = channels_of(other);
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

std::optional<l3d_palette> palette_of_cells(std::span<const std::uint32_t> cells, bool ramp) {
    for (const auto& shape : ramp ? ramps : cubes) {
        if (static_cast<std::size_t>(shape.size()) > cells.size())
            continue;
        if (auto palette = palette_of_shape(shape, cells))
            return palette;
    }
    return std::nullopt;
}

l3d_palette palette_of_masks(const l3d_screen_info& info) {
    const palette_shape shape{1 << info.red().width, 1 << info.green().width,
                              1 << info.blue().width};
    std::vector<std::uint32_t> pixels;
    for (int place = 0; place < shape.size(); ++place) {
        const auto level = [&](int distance, int levels, l3d_channel channel) {
            return static_cast<std::uint32_t>(place / distance % levels) << channel.shift;
        };
        pixels.push_back(level(shape.green * shape.blue, shape.red, info.red()) |
                         level(shape.blue, shape.green, info.green()) |
                         level(1, shape.blue, info.blue()));
    }
    return shape.palette(std::move(pixels), 0);
}

} // namespace l3d_detail
