// SPDX-License-Identifier: MIT
// pixel_writer: pixel words become rows of the display's own pixels.
#ifndef L3D_TOOL_2D_PIXEL_WRITER_P_H
#define L3D_TOOL_2D_PIXEL_WRITER_P_H

#include "tool_2d/screen_info.h"

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// Writes pictures as native pixels. How is chosen once per display, not per row or pixel.
///
/// Lives:   borrows the info.
class pixel_writer {
public:
    /// Expects: 8, 16, 24 or 32 bits per pixel.
    explicit pixel_writer(const l3d_screen_info& info)
        : info_(info), write_row_(info.layout().byte_order == std::endian::little
                                      ? choose<std::endian::little>(info.bytes_per_pixel())
                                      : choose<std::endian::big>(info.bytes_per_pixel())) {
        assert(info.bytes_per_pixel() >= 1 && info.bytes_per_pixel() <= 4);
    }

    /// Whether words in memory are native pixels as they stand, so that nothing need be written.
    bool is_identity() const { return info_.native_is_word(); }

    /// Writes row y of a picture.
    /// Expects: room for words.size() * info.bytes_per_pixel() bytes.
    void write_row(std::span<const std::uint32_t> words, int y, std::uint8_t* bytes) const {
        write_row_(info_, words, y, bytes);
    }

private:
    using row_function = void (*)(const l3d_screen_info&, std::span<const std::uint32_t>, int y,
                                  std::uint8_t*);

    /// Any pixel of Bytes bytes, lowest byte first if Order is little.
    template <int Bytes, std::endian Order>
    static void write(const l3d_screen_info& info, std::span<const std::uint32_t> words, int,
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

    template <std::endian Order> static row_function choose(int bytes_per_pixel) {
        switch (bytes_per_pixel) {
        case 1:
            return write<1, Order>;
        case 2:
            return write<2, Order>;
        case 3:
            return write<3, Order>;
        default:
            return write<4, Order>;
        }
    }

    const l3d_screen_info& info_;
    row_function write_row_;
};

} // namespace l3d_detail

#endif
