// SPDX-License-Identifier: MIT
// write_error_picture: colours each pixel by its error, and adds a legend.
#include "error_picture.h"

#include "base/formatted_p.h"
#include "raster/shapes/rasterizer_2d_sw.h"
#include <l3d/font.h>
#include <l3d/image.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace {

constexpr std::uint32_t magenta = 0x00ff00ff, white = 0x00ffffff;

std::uint32_t color_of(double part) {
    const auto level = [](double value) {
        return static_cast<std::uint32_t>(255 * std::clamp(value, 0.0, 1.0));
    };
    return level(2 * part) << 16 | level(2 - 2 * part) << 8;
}

/// Draws a bar of all colours, with their meaning.
void draw_legend(const l3d_pixels& pixels, double largest) {
    constexpr int left = 10, top = 10, width = 200, height = 12;
    for (int y = top; y < std::min(top + height, pixels.height); ++y)
        for (int x = left; x < std::min(left + width, pixels.width); ++x)
            pixels.row(y)[static_cast<std::size_t>(x)] = color_of(double(x - left) / width);
    l3d_rasterizer_2d_sw_imp imp(pixels);
    l3d_rasterizer_2d rasterizer(imp);
    l3d_draw_text(rasterizer, left, top + height + 4,
                  l3d_detail::formatted("0 to %.3g px; magenta: a hole", largest), white);
    rasterizer.finish();
}

} // namespace

void write_error_picture(const std::string& file, const reference::error_map& errors, l3d_size size,
                         double largest) {
    l3d_image image(size);
    const l3d_pixels pixels = image.pixels();
    std::size_t k = 0;
    for (int y = 0; y < size.height; ++y)
        for (std::uint32_t& word : pixels.row(y)) {
            const float depth = errors.depth[k], outline = errors.outline[k];
            const auto error = static_cast<double>(std::isnan(depth) ? outline : depth);
            word = errors.holes[k] ? magenta : std::isnan(error) ? 0 : color_of(error / largest);
            ++k;
        }
    draw_legend(pixels, largest);
    l3d_write_image(file, pixels);
}
