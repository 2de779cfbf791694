// SPDX-License-Identifier: MIT
// pixel_writer: one loop per kind of pixel.
#include "tool_2d/pixel_writer_p.h"

#include <bit>
#include <cassert>
#include <cstring>

namespace l3d_detail {
namespace {

/// Any pixel of Bytes bytes, lowest byte first if Order is little.
template <int Bytes, std::endian Order>
void write_pixels(const l3d_screen_info& info, std::span<const std::uint32_t> words, int,
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

/// Turns a row of pixels into one of squares, in place: from right to left, so that no pixel is
/// overwritten before it was read.
template <int Bytes> void replicate(std::uint8_t* bytes, int width, int scale) {
    for (int x = width - 1; x >= 0; --x)
        std::memmove(bytes + x * Bytes, bytes + x / scale * Bytes, Bytes);
}

template <std::endian Order> auto row_writer(int bytes_per_pixel) {
    switch (bytes_per_pixel) {
    case 1:
        return write_pixels<1, Order>;
    case 2:
        return write_pixels<2, Order>;
    case 3:
        return write_pixels<3, Order>;
    default:
        return write_pixels<4, Order>;
    }
}

auto replicator(int bytes_per_pixel) {
    switch (bytes_per_pixel) {
    case 1:
        return replicate<1>;
    case 2:
        return replicate<2>;
    case 3:
        return replicate<3>;
    default:
        return replicate<4>;
    }
}

} // namespace

pixel_writer::pixel_writer(const l3d_screen_info& info, int scale)
    : info_(info), scale_(scale),
      write_row_(info.layout().byte_order == std::endian::little
                     ? row_writer<std::endian::little>(info.bytes_per_pixel())
                     : row_writer<std::endian::big>(info.bytes_per_pixel())),
      replicate_(replicator(info.bytes_per_pixel())) {
    assert(info.bytes_per_pixel() >= 1 && info.bytes_per_pixel() <= 4);
    assert(scale >= 1);
}

void pixel_writer::write_row(std::span<const std::uint32_t> words, int y, int native_width,
                             std::uint8_t* bytes) const {
    assert(words.size() == static_cast<std::size_t>((native_width + scale_ - 1) / scale_));
    write_row_(info_, words, y, bytes);
    if (scale_ > 1)
        replicate_(bytes, native_width, scale_);
}

void pixel_writer::write(const l3d_pixels& picture, l3d_size native, std::uint8_t* bytes,
                         std::ptrdiff_t bytes_per_line) const {
    for (int y = 0; y < native.height; ++y) {
        if (y % scale_ == 0)
            write_row(picture.row(y / scale_), y / scale_, native.width, bytes);
        else
            std::memcpy(bytes, bytes - bytes_per_line,
                        static_cast<std::size_t>(native.width * info_.bytes_per_pixel()));
        bytes += bytes_per_line;
    }
}

} // namespace l3d_detail
