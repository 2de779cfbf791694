// SPDX-License-Identifier: MIT
// pixel_writer: against bytes written by hand, against its slow twin, and what the dither promises.
#include "tool_2d/pixel_writer_p.h"

#include "shown_pixel.h"
#include "tool_2d/image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace {

using l3d_detail::pixel_writer;
using bytes = std::vector<std::uint8_t>;

constexpr std::uint8_t untouched = 0xA5;

/// Converts three words into a row with room for one byte more, which must stay as it is.
bytes converted(l3d_pixel_layout layout, std::endian order) {
    layout.byte_order = order;
    const l3d_screen_info info(layout);
    const std::vector<std::uint32_t> words{0x00FF80, 0x123456, 0xFEDCBA};
    bytes row(words.size() * static_cast<std::size_t>(info.bytes_per_pixel()) + 1, untouched);
    pixel_writer(info).write_row(words, 5, 3, row.data());
    EXPECT_EQ(row.back(), untouched) << "wrote behind the row";
    row.pop_back();
    return row;
}

TEST(pixel_writer, bits_8) {
    const l3d_pixel_layout layout{8, 8, 0xE0, 0x1C, 0x03, std::endian::little, 32};
    // Row 5 of the square begins 51, 19, 59. At 19, half a gap above level 0 goes up to 1.
    // (0, 255, 128) -> 0, 7, 1; (18, 52, 86) -> 1, 2, 1; (254, 220, 186) -> 7, 6, 2.
    const bytes expected{0x1D, 0x29, 0xFA};
    EXPECT_EQ(converted(layout, std::endian::little), expected);
    EXPECT_EQ(converted(layout, std::endian::big), expected);
}

TEST(pixel_writer, bits_16) {
    const l3d_pixel_layout layout{16, 16, 0xF800, 0x07E0, 0x001F, std::endian::little, 32};
    // (0, 63, 15), (2, 13, 11), (30, 54, 22).
    EXPECT_EQ(converted(layout, std::endian::little), (bytes{0xEF, 0x07, 0xAB, 0x11, 0xD6, 0xF6}));
    EXPECT_EQ(converted(layout, std::endian::big), (bytes{0x07, 0xEF, 0x11, 0xAB, 0xF6, 0xD6}));
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

TEST(pixel_writer, a_palette) {
    // 2x3x2 colours: levels 0, 255; 0, 128, 255; 0, 255.
    const l3d_palette palette{2, 3, 2, {50, 51, 52, 53, 54, 55, 60, 61, 62, 63, 64, 65}};
    const l3d_pixel_layout layout{8, 8, 0, 0, 0, std::endian::little, 32};
    const l3d_screen_info info(layout, palette);
    // Row 1 of the square begins 48, 16, 56, 24, 50: halves go up at the second and the fourth.
    const std::vector<std::uint32_t> words{0x00FF00, 0x800080, 0x7F007F, 0xFF80FF, 0x004000};
    bytes row(words.size());
    pixel_writer(info).write_row(words, 9, 5, row.data());
    EXPECT_EQ(row, (bytes{54, 61, 50, 63, 50}));
}

/// Any layout that a display might have: masks in any order and place, or a palette.
struct random_layouts {
    explicit random_layouts(unsigned seed) : random(seed) {}

    int below(int end) { return static_cast<int>(random() % static_cast<unsigned>(end)); }

    l3d_screen_info masks() {
        const int bits = 8 * (1 + below(4));
        const bool whole_bytes = bits >= 24 && below(2) == 0;
        std::array<int, 3> widths{8, 8, 8};
        for (int left = bits - 3; auto& width : widths) {
            if (!whole_bytes)
                width = 1 + below(std::min(left + 1, 12));
            left -= width - 1;
        }
        return with_masks(bits, widths);
    }

    l3d_screen_info palette() {
        l3d_pixel_layout layout{8, 8 * (1 + below(2)), 0, 0, 0, order(), 32};
        l3d_palette palette;
        palette.red = 2 + below(layout.bits_per_pixel == 8 ? 5 : 15);
        palette.green = palette.blue = 1;
        if (below(3) > 0) {
            palette.green = 2 + below(5);
            palette.blue = 2 + below(7);
        } else if (below(3) == 0) {
            palette.red = 256;
        }
        const int count = palette.red * palette.green * palette.blue;
        palette.pixels.resize(static_cast<std::size_t>(count));
        const auto mask = (1U << layout.bits_per_pixel) - 1;
        std::ranges::generate(palette.pixels, [&] { return random() & mask; });
        return l3d_screen_info(layout, palette);
    }

    std::mt19937 random;

private:
    std::endian order() { return below(2) == 0 ? std::endian::little : std::endian::big; }

    l3d_screen_info with_masks(int bits, const std::array<int, 3>& widths) {
        std::array<std::size_t, 3> places{0, 1, 2};
        std::ranges::shuffle(places, random);
        std::array<std::uint32_t, 3> masks{};
        const int used = std::accumulate(widths.begin(), widths.end(), 0);
        int shift = bits > used ? below(bits - used + 1) : 0;
        for (const auto place : places) {
            masks[place] = ((1U << widths[place]) - 1) << shift;
            shift += widths[place];
        }
        const int depth = bits == 32 && below(2) == 0 ? 32 : std::min(shift, 31);
        return l3d_screen_info({depth, bits, masks[0], masks[1], masks[2], order(), 32});
    }
};

/// The bytes of a native picture, one by one.
bytes expected_bytes(const l3d_screen_info& info, const l3d_pixels& picture, l3d_size native,
                     int scale, std::ptrdiff_t bytes_per_line) {
    bytes expected(static_cast<std::size_t>(bytes_per_line * native.height), untouched);
    const std::ptrdiff_t size = info.bytes_per_pixel();
    for (int y = 0; y < native.height; ++y) {
        for (int x = 0; x < native.width; ++x) {
            const auto word = picture.row(y / scale)[static_cast<std::size_t>(x / scale)];
            const auto pixel = shown_pixel(info, word, x / scale, y / scale);
            for (std::ptrdiff_t i = 0; i < size; ++i) {
                const auto place =
                    info.layout().byte_order == std::endian::little ? i : size - 1 - i;
                expected[static_cast<std::size_t>(y * bytes_per_line + x * size + place)] =
                    static_cast<std::uint8_t>(pixel >> (8 * i));
            }
        }
    }
    return expected;
}

TEST(pixel_writer, is_its_slow_twin) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    random_layouts layouts(seed);
    for (int i = 0; i < 3000; ++i) {
        const auto info = i % 3 == 0 ? layouts.palette() : layouts.masks();
        const int scale = 1 + layouts.below(3) * layouts.below(3);
        const l3d_size native{1 + layouts.below(41), 1 + layouts.below(23)};
        const l3d_size size{(native.width + scale - 1) / scale,
                            (native.height + scale - 1) / scale};
        l3d_image picture(size, size.width + layouts.below(3));
        for (int y = 0; y < size.height; ++y)
            std::ranges::generate(picture.pixels().row(y),
                                  [&] { return layouts.random() & 0xFFFFFF; });
        const std::ptrdiff_t bytes_per_line =
            native.width * info.bytes_per_pixel() + layouts.below(9);
        bytes written(static_cast<std::size_t>(bytes_per_line * native.height), untouched);
        pixel_writer(info, scale)
            .write(picture.pixels(), l3d_whole(picture.pixels().size()), native, written.data(),
                   bytes_per_line);
        ASSERT_EQ(written, expected_bytes(info, picture.pixels(), native, scale, bytes_per_line))
            << info.describe() << ", " << native.width << "x" << native.height << " at scale "
            << scale << ", layout " << i;
    }
}

/// Rows one by one, as when only some are sent, are those of the whole picture.
TEST(pixel_writer, rows_do_not_depend_on_others) {
    const l3d_palette palette{6, 1, 1, {9, 8, 7, 6, 5, 4}};
    const l3d_screen_info info(l3d_pixel_layout{8, 8, 0, 0, 0, std::endian::little, 32}, palette);
    constexpr l3d_size size{13, 11};
    l3d_image picture(size, 17);
    for (int y = 0; y < size.height; ++y)
        std::ranges::fill(picture.pixels().row(y), 0x476B93U + static_cast<std::uint32_t>(y));
    const pixel_writer writer(info, 3);
    bytes whole(38UL * 32), row(38);
    writer.write(picture.pixels(), l3d_whole(size), {38, 32}, whole.data(), 38);
    auto there = whole.end();
    for (int y = 31; y >= 0; --y) {
        there -= 38;
        writer.write_row(picture.pixels().row(y / 3), y / 3, 38, row.data());
        EXPECT_TRUE(std::equal(row.begin(), row.end(), there)) << y;
    }
}

/// Any part of a picture, written in any order, is the same where it was written.
TEST(pixel_writer, parts_are_those_of_the_whole) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    random_layouts layouts(seed);
    for (int i = 0; i < 1000; ++i) {
        const auto info = i % 3 == 0 ? layouts.palette() : layouts.masks();
        const int scale = 1 + layouts.below(3);
        const l3d_size size{1 + layouts.below(41), 1 + layouts.below(23)};
        const l3d_size native{size.width * scale, size.height * scale};
        l3d_image picture(size, size.width + layouts.below(3));
        for (int y = 0; y < size.height; ++y)
            std::ranges::generate(picture.pixels().row(y),
                                  [&] { return layouts.random() & 0xFFFFFF; });
        const int left = layouts.below(size.width), top = layouts.below(size.height);
        const l3d_pixel_box part =
            pixel_writer::writable_part({left, top, left + 1 + layouts.below(size.width - left),
                                         top + 1 + layouts.below(size.height - top)},
                                        size);
        const std::ptrdiff_t line = native.width * info.bytes_per_pixel() + layouts.below(9);
        bytes written(static_cast<std::size_t>(line * native.height), untouched);
        pixel_writer(info, scale).write(picture.pixels(), part, native, written.data(), line);
        auto expected = expected_bytes(info, picture.pixels(), native, scale, line);
        for (int y = 0; y < native.height; ++y)
            for (int at = 0; at < line; ++at) {
                const int x = at / info.bytes_per_pixel() / scale;
                if (x < part.left || x >= part.right || y / scale < part.top ||
                    y / scale >= part.bottom)
                    expected[static_cast<std::size_t>(y * line + at)] = untouched;
            }
        ASSERT_EQ(written, expected) << info.describe() << " at scale " << scale << ", " << i;
    }
}

TEST(pixel_writer, is_identity_only_for_words_shown_one_to_one) {
    const l3d_screen_info words,
        palette({8, 8, 0, 0, 0, std::endian::little, 32}, {2, 1, 1, {0, 1}});
    EXPECT_TRUE(pixel_writer(words).is_identity());
    EXPECT_FALSE(pixel_writer(words, 2).is_identity());
    EXPECT_FALSE(pixel_writer(palette).is_identity());
    l3d_pixel_layout direct;
    direct.color_class = l3d_color_class::direct_color;
    EXPECT_TRUE(pixel_writer(l3d_screen_info(direct)).is_identity());
}

// ---- the dither's promises ---------------------------------------------------------------------

/// Shows one word on 8 x 8 pixels at some place, as the levels that are seen.
class block {
public:
    /// A palette whose pixels tell their levels.
    block(int red, int green, int blue)
        : red_(red), green_(green), blue_(blue), info_(layout(), numbered()) {}

    /// Masks, from the highest bit on and without gaps: pixels tell their levels, too.
    explicit block(const l3d_pixel_layout& masks) : red_(0), green_(0), blue_(0), info_(masks) {
        red_ = 1 << info_.red().width;
        green_ = 1 << info_.green().width;
        blue_ = 1 << info_.blue().width;
    }

    /// Channels of the 64 pixels, 0..255; those of a ramp are all alike.
    std::array<std::array<int, 3>, 64> show(std::uint32_t word, int first_y) const {
        std::array<std::array<int, 3>, 64> seen{};
        std::array<std::uint16_t, 8> row{};
        const std::array<std::uint32_t, 8> words{word, word, word, word, word, word, word, word};
        for (int y = 0; y < 8; ++y) {
            writer_.write_row(words, first_y + y, 8, reinterpret_cast<std::uint8_t*>(row.data()));
            for (std::size_t x = 0; x < 8; ++x)
                seen[static_cast<std::size_t>(8 * y) + x] = channels(row[x]);
        }
        return seen;
    }

    std::array<int, 3> channels(int place) const {
        const auto value = [](int level, int levels) {
            return static_cast<int>(std::floor(level * 255.0 / (levels - 1) + 0.5));
        };
        if (green_ == 1) {
            const int gray = value(place, red_);
            return {gray, gray, gray};
        }
        return {value(place / (green_ * blue_), red_), value(place / blue_ % green_, green_),
                value(place % blue_, blue_)};
    }

    std::array<int, 3> levels() const {
        return {red_, green_ == 1 ? red_ : green_, blue_ == 1 ? red_ : blue_};
    }

private:
    static l3d_pixel_layout layout() {
        l3d_pixel_layout layout{12, 16, 0, 0, 0, std::endian::native, 32};
        layout.color_class = l3d_color_class::pseudo_color;
        return layout;
    }
    l3d_palette numbered() const {
        l3d_palette palette{red_, green_, blue_, {}};
        const int count = red_ * green_ * blue_;
        palette.pixels.resize(static_cast<std::size_t>(count));
        std::iota(palette.pixels.begin(), palette.pixels.end(), 0U);
        return palette;
    }

    int red_, green_, blue_;
    l3d_screen_info info_;
    pixel_writer writer_{info_};
};

/// The rule written above the class, for one word. Returns the worst mean, in gaps.
double check_promises(const block& shown, std::uint32_t word, int first_y, bool ramp) {
    const auto seen = shown.show(word, first_y);
    double worst = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const int value =
            static_cast<int>(ramp ? l3d_screen_info::gray_of(word) : word >> (16 - 8 * c) & 255);
        const int levels = shown.levels()[c];
        int low = 0, high = 255;
        for (int level = 0; level < levels; ++level) {
            const int at = (2 * 255 * level + levels - 1) / (2 * (levels - 1));
            low = at <= value ? at : low;
            high = at >= value ? std::min(high, at) : high;
        }
        double sum = 0;
        for (const auto& pixel : seen) {
            EXPECT_TRUE(pixel[c] == low || pixel[c] == high) << std::hex << word;
            sum += pixel[c];
        }
        if (high > low)
            worst = std::max(worst, std::abs(sum / 64 - value) / (high - low));
        else
            EXPECT_EQ(sum, 64 * value);
    }
    return worst;
}

TEST(dither, keeps_its_promises) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    for (const auto& [red, green, blue] :
         {std::array{6, 6, 6}, std::array{5, 5, 5}, std::array{4, 4, 4}, std::array{8, 8, 4},
          std::array{2, 2, 2}, std::array{16, 16, 16}, std::array{64, 1, 1}, std::array{256, 1, 1},
          std::array{16, 1, 1}}) {
        const block shown(red, green, blue);
        double worst = 0;
        // Every value of every channel, beside random ones.
        for (std::uint32_t i = 0; i < 20000; ++i) {
            std::uint32_t word = random() & 0xFFFFFF;
            if (i < 256)
                word = green == 1 ? i * 0x010101 : i << 16 | (i * 77 & 255) << 8 | (i * 151 & 255);
            worst =
                std::max(worst, check_promises(shown, word, static_cast<int>(i % 11), green == 1));
        }
        EXPECT_LE(worst, 1 / 128.0 + 1e-12) << red << "x" << green << "x" << blue;
    }
}

TEST(dither, keeps_its_promises_on_15_and_16_bits) {
    for (const auto& layout :
         {l3d_pixel_layout{15, 16, 0x7C00, 0x03E0, 0x001F, std::endian::native, 32},
          l3d_pixel_layout{16, 16, 0xF800, 0x07E0, 0x001F, std::endian::native, 32}}) {
        const block shown(layout);
        double worst = 0;
        for (std::uint32_t i = 0; i < 256; ++i)
            worst = std::max(worst, check_promises(shown, i << 16 | (i * 77 & 255) << 8 | (255 - i),
                                                   static_cast<int>(i % 11), false));
        EXPECT_LE(worst, 1 / 128.0 + 1e-12) << layout.describe();
    }
}

TEST(dither, mixes_greys_from_greys) {
    const block shown(6, 6, 6);
    for (std::uint32_t value = 0; value < 256; ++value) {
        for (const auto& pixel : shown.show(value * 0x010101, 3))
            EXPECT_TRUE(pixel[0] == pixel[1] && pixel[1] == pixel[2]) << value;
    }
}

/// Half of the pixels: no two neighbours alike, the finest pattern there is.
TEST(dither, spreads_evenly) {
    const block shown(2, 1, 1);
    const auto half = shown.show(0x808080, 0);
    for (std::size_t i = 0; i < 64; ++i)
        EXPECT_EQ(half[i][0] == 255, (i + i / 8) % 2 == 0) << i;
    // A quarter: one in each square of 2 x 2.
    const auto quarter = shown.show(0x404040, 0);
    for (std::size_t y = 0; y < 8; y += 2) {
        for (std::size_t x = 0; x < 8; x += 2) {
            const auto at = [&](std::size_t dx, std::size_t dy) {
                return quarter[8 * (y + dy) + x + dx][0];
            };
            EXPECT_EQ(at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1), 255);
        }
    }
}

} // namespace
