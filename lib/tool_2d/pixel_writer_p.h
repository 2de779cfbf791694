// SPDX-License-Identifier: MIT
// pixel_writer: turns pixel words into rows of the display's own pixels.
#ifndef L3D_TOOL_2D_PIXEL_WRITER_P_H
#define L3D_TOOL_2D_PIXEL_WRITER_P_H

#include "tool_2d/pixels.h"
#include "tool_2d/screen_info.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// Converts pictures to native pixels. The kind of pixel is chosen once per display, not per row or
/// pixel.
///
/// Each word is shown as a square of scale x scale native pixels. The native picture may end within
/// a square, so a side has ceil(native / scale) words.
///
/// With a palette, and with masks of fewer than eight bits, colours between two levels are mixed
/// from both by an ordered dither. The pattern stays where it is while the picture moves:
/// - a channel shows one of the two levels around its value, so it is off by less than a step;
/// - a value that is a level is shown as that level in every pixel;
/// - over 8 x 8 words of one colour, whole blocks of the picture or not, the mean of the shown
///   channel is off by at most 1/128 of the gap between its two levels;
/// - where all channels have the same number of levels, greys are mixed from greys.
/// The palette's deviation adds to all of these errors. On a ramp, the bounds hold for the grey
/// that l3d_screen_info::gray_of gives.
///
/// Lives:   borrows the info.
class pixel_writer {
public:
    /// Chooses how words become pixels of this display.
    /// Expects: 8, 16, 24 or 32 bits per pixel; scale >= 1.
    explicit pixel_writer(const l3d_screen_info& info, int scale = 1);

    /// Whether words in memory already are native pixels, so that nothing need be written.
    bool is_identity() const { return scale_ == 1 && info_.native_is_word(); }

    int scale() const { return scale_; }

    /// Writes one native row that shows row y of a picture. All `scale` native rows of y are equal.
    /// The row may begin at the left end of a part that writable_part has widened.
    /// Shape:   native_width pixels; words.size() is native_width / scale, rounded up.
    void write_row(std::span<const std::uint32_t> words, int y, int native_width,
                   std::uint8_t* bytes) const;

    /// Widens a part, within the picture, to whole columns of the dither's 8 x 8 squares, for
    /// write().
    static l3d_pixel_box writable_part(const l3d_pixel_box& part, l3d_size size);

    /// The box of native pixels that shows a part of the picture.
    l3d_pixel_box native_part(const l3d_pixel_box& part, l3d_size native) const {
        return part.scaled(scale_).intersected(l3d_whole(native));
    }

    /// Writes the native rows of a part of a picture to their place in the whole picture's rows.
    /// Shape:   `bytes` has native.height rows, each bytes_per_line after the one above it.
    /// Expects: a part that writable_part has widened.
    void write(const l3d_pixels& picture, const l3d_pixel_box& part, l3d_size native,
               std::uint8_t* bytes, std::ptrdiff_t bytes_per_line) const;

private:
    /// Maps a channel value to 64 i + n. On a dithered square of 8 x 8, n pixels show level i + 1,
    /// the others level i.
    using dither_table = std::array<std::uint16_t, 256>;

    // Each kind of pixel is made for one row, and converts that row's words.
    struct by_tables;
    struct by_shifts;
    struct by_few_bits;
    struct by_cube;
    struct by_ramp;

    using row_function = void (pixel_writer::*)(std::span<const std::uint32_t>, int y,
                                                std::uint8_t*) const;
    using replicate_function = void (*)(std::uint8_t* bytes, std::ptrdiff_t width,
                                        std::ptrdiff_t scale);

    static dither_table dither_table_of(int levels);
    bool has_few_bits() const;
    row_function choose_kind() const;
    template <class Kind> row_function choose_order() const;
    template <class Kind, std::endian Order> row_function choose_size() const;
    template <class Kind, std::endian Order, int Bytes>
    void write_pixels(std::span<const std::uint32_t> words, int y, std::uint8_t* bytes) const;
    void copy_words(std::span<const std::uint32_t> words, int y, std::uint8_t* bytes) const;

    const l3d_screen_info& info_;
    int scale_;
    row_function write_row_;
    replicate_function replicate_;
    dither_table red_{}, green_{}, blue_{}; ///< for a palette, or masks of at most eight bits
};

} // namespace l3d_detail

#endif
