// SPDX-License-Identifier: MIT
// Rows of pixel words become rows of the display's own pixels.
#ifndef L3D_TOOL_2D_ROW_CONVERTER_P_H
#define L3D_TOOL_2D_ROW_CONVERTER_P_H

#include "tool_2d/screen_info.h"

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// Writes one row of words as native pixels.
/// Expects: room for words.size() * info.bytes_per_pixel() bytes.
using row_converter = void (*)(const l3d_screen_info& info, std::span<const std::uint32_t> words,
                               std::uint8_t* bytes);

/// The converter for any pixel of Bytes bytes, lowest byte first if Order is little.
template <int Bytes, std::endian Order>
void convert_row(const l3d_screen_info& info, std::span<const std::uint32_t> words,
                 std::uint8_t* bytes) {
    for (const auto word : words) {
        const auto pixel = info.to_display(word);
        for (int i = 0; i < Bytes; ++i) {
            const int place = Order == std::endian::little ? i : Bytes - 1 - i;
            bytes[place] = static_cast<std::uint8_t>(pixel >> (8 * i));
        }
        bytes += Bytes;
    }
}

template <std::endian Order> row_converter choose_row_converter(int bytes_per_pixel) {
    switch (bytes_per_pixel) {
    case 1:
        return convert_row<1, Order>;
    case 2:
        return convert_row<2, Order>;
    case 3:
        return convert_row<3, Order>;
    default:
        return convert_row<4, Order>;
    }
}

/// The converter for a display, to be chosen once per picture, not per row.
/// Expects: 8, 16, 24 or 32 bits per pixel.
inline row_converter choose_row_converter(const l3d_screen_info& info) {
    assert(info.bytes_per_pixel() >= 1 && info.bytes_per_pixel() <= 4);
    return info.layout().byte_order == std::endian::little
               ? choose_row_converter<std::endian::little>(info.bytes_per_pixel())
               : choose_row_converter<std::endian::big>(info.bytes_per_pixel());
}

} // namespace l3d_detail

#endif
