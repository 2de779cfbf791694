// SPDX-License-Identifier: MIT
// pixel_writer: converts rows of pixels, with one loop for each kind of pixel.
#include "tool_2d/pixel_writer_p.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace l3d_detail {
namespace {

constexpr int dither_side = 8;
constexpr int dither_pixels = dither_side * dither_side;

/// A row of the thresholds t[x % 8] of ordered dithering. A pixel whose level has the fraction n /
/// 64 shows the next level if n + t >= 64.
///
/// Over a square of 8 x 8 pixels, t takes each of 0..63 once, so exactly n of the pixels show the
/// next level. The bits of x and y are interleaved, last bits first, so that any n of these pixels
/// are spread evenly.
/// Source:  Bayer: An optimum method for two-level rendition of continuous-tone pictures (1973).
std::array<std::uint32_t, dither_side> thresholds_of_row(int y) {
    std::array<std::uint32_t, dither_side> thresholds{};
    for (std::uint32_t x = 0; x < dither_side; ++x) {
        const auto low = static_cast<std::uint32_t>(y), high = x ^ low;
        std::uint32_t rank = 0;
        for (int bit = 0; bit < 3; ++bit)
            rank = rank << 2 | (high >> bit & 1) << 1 | (low >> bit & 1);
        thresholds[x] = dither_pixels - 1 - rank;
    }
    return thresholds;
}

/// Stores a pixel, with the lowest byte first if Order is little.
template <std::endian Order, int Bytes> void store(std::uint32_t pixel, std::uint8_t* bytes) {
    if constexpr (Bytes == 4) {
        // Stores whole words, as compilers turn these into vectors.
        if (Order != std::endian::native)
            pixel = pixel >> 24 | (pixel >> 8 & 0xFF00) | (pixel << 8 & 0xFF0000) | pixel << 24;
        std::memcpy(bytes, &pixel, Bytes);
    } else {
        for (int i = 0; i < Bytes; ++i) {
            const int place = Order == std::endian::little ? i : Bytes - 1 - i;
            bytes[place] = static_cast<std::uint8_t>(pixel >> (8 * i));
        }
    }
}

/// Enlarges a row of pixels in place: each pixel is repeated `scale` times. The function goes from
/// right to left, so that no pixel is overwritten before it is read.
template <int Bytes>
void replicate(std::uint8_t* bytes, std::ptrdiff_t width, std::ptrdiff_t scale) {
    for (std::ptrdiff_t from = (width - 1) / scale; from >= 0; --from) {
        std::array<std::uint8_t, Bytes> pixel;
        std::memcpy(pixel.data(), bytes + from * Bytes, Bytes);
        const auto end = std::min(width, (from + 1) * scale);
        for (auto x = from * scale; x < end; ++x)
            std::memcpy(bytes + x * Bytes, pixel.data(), Bytes);
    }
}

auto choose_replicate(int bytes_per_pixel) {
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

/// Pixels with any masks, by the tables of l3d_screen_info.
struct pixel_writer::by_tables {
    const l3d_screen_info& info;

    by_tables(const pixel_writer& writer, int) : info(writer.info_) {}
    std::uint32_t operator()(std::uint32_t word, std::size_t) const { return info.by_masks(word); }
};

/// Pixels with masks of eight bits each. Their order may differ from ours, or there is alpha.
struct pixel_writer::by_shifts {
    int red, green, blue;
    std::uint32_t opaque_bits;

    by_shifts(const pixel_writer& writer, int)
        : red(writer.info_.red().shift), green(writer.info_.green().shift),
          blue(writer.info_.blue().shift), opaque_bits(writer.info_.opaque_bits()) {}
    std::uint32_t operator()(std::uint32_t word, std::size_t) const {
        return (word >> 16 & 255) << red | (word >> 8 & 255) << green | (word & 255) << blue |
               opaque_bits;
    }
};

/// Dithered pixels with masks of at most eight bits, some of which have fewer.
struct pixel_writer::by_few_bits {
    const pixel_writer& writer;
    int red, green, blue;
    std::uint32_t opaque_bits;
    std::array<std::uint32_t, dither_side> thresholds;

    by_few_bits(const pixel_writer& from, int y)
        : writer(from), red(from.info_.red().shift), green(from.info_.green().shift),
          blue(from.info_.blue().shift), opaque_bits(from.info_.opaque_bits()),
          thresholds(thresholds_of_row(y)) {}
    std::uint32_t operator()(std::uint32_t word, std::size_t x) const {
        const auto threshold = thresholds[x % dither_side];
        return (writer.red_[word >> 16 & 255] + threshold) / dither_pixels << red |
               (writer.green_[word >> 8 & 255] + threshold) / dither_pixels << green |
               (writer.blue_[word & 255] + threshold) / dither_pixels << blue | opaque_bits;
    }
};

/// Dithered pixels that index a cube of colours.
struct pixel_writer::by_cube {
    const pixel_writer& writer;
    const std::uint32_t* pixels;
    std::uint32_t greens, blues;
    std::array<std::uint32_t, dither_side> thresholds;

    by_cube(const pixel_writer& from, int y)
        : writer(from), pixels(from.info_.palette().pixels.data()),
          greens(static_cast<std::uint32_t>(from.info_.palette().green)),
          blues(static_cast<std::uint32_t>(from.info_.palette().blue)),
          thresholds(thresholds_of_row(y)) {}
    std::uint32_t operator()(std::uint32_t word, std::size_t x) const {
        const auto threshold = thresholds[x % dither_side];
        const auto red = (writer.red_[word >> 16 & 255] + threshold) / dither_pixels;
        const auto green = (writer.green_[word >> 8 & 255] + threshold) / dither_pixels;
        const auto blue = (writer.blue_[word & 255] + threshold) / dither_pixels;
        return pixels[(red * greens + green) * blues + blue];
    }
};

/// Dithered pixels that index a ramp of greys.
struct pixel_writer::by_ramp {
    const pixel_writer& writer;
    const std::uint32_t* pixels;
    std::array<std::uint32_t, dither_side> thresholds;

    by_ramp(const pixel_writer& from, int y)
        : writer(from), pixels(from.info_.palette().pixels.data()),
          thresholds(thresholds_of_row(y)) {}
    std::uint32_t operator()(std::uint32_t word, std::size_t x) const {
        const auto level =
            writer.red_[l3d_screen_info::gray_of(word)] + thresholds[x % dither_side];
        return pixels[level / dither_pixels];
    }
};

pixel_writer::pixel_writer(const l3d_screen_info& info, int scale)
    : info_(info), scale_(scale), write_row_(choose_kind()),
      replicate_(choose_replicate(info.bytes_per_pixel())) {
    assert(info.bytes_per_pixel() >= 1 && info.bytes_per_pixel() <= 4);
    assert(scale >= 1);
    if (info.has_palette()) {
        red_ = dither_table_of(info.palette().red);
        green_ = dither_table_of(info.palette().green);
        blue_ = dither_table_of(info.palette().blue);
    } else if (has_few_bits()) {
        red_ = dither_table_of(1 << info.red().width);
        green_ = dither_table_of(1 << info.green().width);
        blue_ = dither_table_of(1 << info.blue().width);
    }
}

/// The levels of each value for dithering, in 64ths. The share of level i + 1 is (value - level i)
/// / gap, rounded to the nearest 64th.
pixel_writer::dither_table pixel_writer::dither_table_of(int levels) {
    dither_table table{};
    for (int value = 0, level = 0; value < 255 && levels > 1; ++value) {
        if (value == l3d_palette::value_of(level + 1, levels))
            ++level;
        const int below = l3d_palette::value_of(level, levels);
        const int gap = l3d_palette::value_of(level + 1, levels) - below;
        const int share = (2 * dither_pixels * (value - below) + gap) / (2 * gap);
        table[static_cast<std::size_t>(value)] =
            static_cast<std::uint16_t>(dither_pixels * level + share);
    }
    table[255] = static_cast<std::uint16_t>(dither_pixels * (levels - 1));
    return table;
}

/// Whether some masks have fewer than eight bits, and none has more. Displays with masks both below
/// and above eight bits are too rare for tables of their own.
bool pixel_writer::has_few_bits() const {
    const auto [least, most] =
        std::minmax({info_.red().width, info_.green().width, info_.blue().width});
    return least < 8 && most <= 8;
}

pixel_writer::row_function pixel_writer::choose_kind() const {
    if (info_.native_is_word())
        return &pixel_writer::copy_words;
    if (info_.has_palette())
        return info_.palette().is_ramp() ? choose_order<by_ramp>() : choose_order<by_cube>();
    const bool bytes =
        info_.red().width == 8 && info_.green().width == 8 && info_.blue().width == 8;
    if (bytes)
        return choose_order<by_shifts>();
    return has_few_bits() ? choose_order<by_few_bits>() : choose_order<by_tables>();
}

template <class Kind> pixel_writer::row_function pixel_writer::choose_order() const {
    return info_.layout().byte_order == std::endian::little
               ? choose_size<Kind, std::endian::little>()
               : choose_size<Kind, std::endian::big>();
}

template <class Kind, std::endian Order>
pixel_writer::row_function pixel_writer::choose_size() const {
    switch (info_.bytes_per_pixel()) {
    case 1:
        return &pixel_writer::write_pixels<Kind, Order, 1>;
    case 2:
        return &pixel_writer::write_pixels<Kind, Order, 2>;
    case 3:
        return &pixel_writer::write_pixels<Kind, Order, 3>;
    default:
        return &pixel_writer::write_pixels<Kind, Order, 4>;
    }
}

template <class Kind, std::endian Order, int Bytes>
void pixel_writer::write_pixels(std::span<const std::uint32_t> words, int y,
                                std::uint8_t* bytes) const {
    const Kind pixel_of(*this, y);
    for (std::size_t x = 0; x < words.size(); ++x)
        store<Order, Bytes>(pixel_of(words[x], x), bytes + x * Bytes);
}

/// Writes a row of words that are native pixels already, by copying them.
void pixel_writer::copy_words(std::span<const std::uint32_t> words, int,
                              std::uint8_t* bytes) const {
    std::memcpy(bytes, words.data(), words.size_bytes());
}

void pixel_writer::write_row(std::span<const std::uint32_t> words, int y, int native_width,
                             std::uint8_t* bytes) const {
    assert(words.size() == static_cast<std::size_t>((native_width + scale_ - 1) / scale_));
    (this->*write_row_)(words, y, bytes);
    if (scale_ > 1)
        replicate_(bytes, native_width, scale_);
}

l3d_pixel_box pixel_writer::writable_part(const l3d_pixel_box& part, l3d_size size) {
    l3d_pixel_box wider = part;
    wider.left = part.left / dither_side * dither_side;
    wider.right = std::min(size.width, (part.right + dither_side - 1) / dither_side * dither_side);
    return wider;
}

void pixel_writer::write(const l3d_pixels& picture, const l3d_pixel_box& part, l3d_size native,
                         std::uint8_t* bytes, std::ptrdiff_t bytes_per_line) const {
    assert(writable_part(part, picture.size()) == part);
    const l3d_pixel_box box = native_part(part, native);
    const int width = box.right - box.left;
    const auto row_bytes =
        static_cast<std::size_t>(width) * static_cast<std::size_t>(info_.bytes_per_pixel());
    bytes += box.top * bytes_per_line + std::ptrdiff_t{box.left} * info_.bytes_per_pixel();
    for (int y = box.top; y < box.bottom; ++y) {
        if (y % scale_ == 0)
            write_row(l3d_row(picture, y / scale_, part), y / scale_, width, bytes);
        else
            std::memcpy(bytes, bytes - bytes_per_line, row_bytes);
        bytes += bytes_per_line;
    }
}

} // namespace l3d_detail
