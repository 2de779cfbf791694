// SPDX-License-Identifier: MIT
// pixel_writer: every pixel size in both byte orders, against bytes written by hand.
#include "tool_2d/pixel_writer_p.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

using bytes = std::vector<std::uint8_t>;

constexpr std::uint8_t untouched = 0xA5;

/// Converts three words into a row with room for one byte more, which must stay as it is.
bytes converted(l3d_pixel_layout layout, std::endian order) {
    layout.byte_order = order;
    const l3d_screen_info info(layout);
    const std::vector<std::uint32_t> words{0x00FF80, 0x123456, 0xFEDCBA};
    bytes row(words.size() * static_cast<std::size_t>(info.bytes_per_pixel()) + 1, untouched);
    l3d_detail::pixel_writer(info).write_row(words, 5, 3, row.data());
    EXPECT_EQ(row.back(), untouched) << "wrote behind the row";
    row.pop_back();
    return row;
}

TEST(pixel_writer, bits_8) {
    const l3d_pixel_layout layout{8, 8, 0xE0, 0x1C, 0x03, std::endian::little, 32};
    // (0, 255, 128) -> 0, 7, 1; (18, 52, 86) -> 0, 1, 1; (254, 220, 186) -> 6, 6, 2.
    const bytes expected{0x1D, 0x05, 0xDA};
    EXPECT_EQ(converted(layout, std::endian::little), expected);
    EXPECT_EQ(converted(layout, std::endian::big), expected);
}

TEST(pixel_writer, bits_16) {
    const l3d_pixel_layout layout{16, 16, 0xF800, 0x07E0, 0x001F, std::endian::little, 32};
    // (0, 63, 15), (2, 12, 10), (30, 54, 22).
    EXPECT_EQ(converted(layout, std::endian::little), (bytes{0xEF, 0x07, 0x8A, 0x11, 0xD6, 0xF6}));
    EXPECT_EQ(converted(layout, std::endian::big), (bytes{0x07, 0xEF, 0x11, 0x8A, 0xF6, 0xD6}));
}

TEST(pixel_writer, bits_24_packed) {
    const l3d_pixel_layout layout{24, 24, 0xFF0000, 0x00FF00, 0x0000FF, std::endian::little, 32};
    EXPECT_EQ(converted(layout, std::endian::little),
              (bytes{0x80, 0xFF, 0x00, 0x56, 0x34, 0x12, 0xBA, 0xDC, 0xFE}));
    EXPECT_EQ(converted(layout, std::endian::big),
              (bytes{0x00, 0xFF, 0x80, 0x12, 0x34, 0x56, 0xFE, 0xDC, 0xBA}));
}

TEST(pixel_writer, bits_32) {
    const l3d_pixel_layout layout;
    EXPECT_EQ(converted(layout, std::endian::little),
              (bytes{0x80, 0xFF, 0x00, 0, 0x56, 0x34, 0x12, 0, 0xBA, 0xDC, 0xFE, 0}));
    EXPECT_EQ(converted(layout, std::endian::big),
              (bytes{0, 0x00, 0xFF, 0x80, 0, 0x12, 0x34, 0x56, 0, 0xFE, 0xDC, 0xBA}));
}

TEST(pixel_writer, alpha_is_opaque) {
    const l3d_pixel_layout layout{32, 32, 0x0000FF, 0x00FF00, 0xFF0000, std::endian::little, 32};
    EXPECT_EQ(converted(layout, std::endian::little),
              (bytes{0x00, 0xFF, 0x80, 255, 0x12, 0x34, 0x56, 255, 0xFE, 0xDC, 0xBA, 255}));
}

} // namespace
