// SPDX-License-Identifier: MIT
// pixel_writer: pixel words become rows of the display's own pixels.
#ifndef L3D_TOOL_2D_PIXEL_WRITER_P_H
#define L3D_TOOL_2D_PIXEL_WRITER_P_H

#include "tool_2d/pixels.h"
#include "tool_2d/screen_info.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// Writes pictures as native pixels. How is chosen once per display, not per row or pixel.
///
/// Each word is shown as a square of scale x scale native pixels. The native picture may end
/// within a square: ceil(native / scale) words make it.
///
/// Lives:   borrows the info.
class pixel_writer {
public:
    /// Expects: 8, 16, 24 or 32 bits per pixel; scale >= 1.
    explicit pixel_writer(const l3d_screen_info& info, int scale = 1);

    /// Whether words in memory are native pixels as they stand, so that nothing need be written.
    bool is_identity() const { return scale_ == 1 && info_.native_is_word(); }

    int scale() const { return scale_; }

    /// Writes one native row of those that show row y of a picture; they are all alike.
    /// Shape:   native_width pixels; words.size() is native_width / scale, rounded up.
    void write_row(std::span<const std::uint32_t> words, int y, int native_width,
                   std::uint8_t* bytes) const;

    /// Writes all native rows of a picture.
    /// Shape:   native.height rows, each bytes_per_line after the one above it.
    void write(const l3d_pixels& picture, l3d_size native, std::uint8_t* bytes,
               std::ptrdiff_t bytes_per_line) const;

private:
    using row_function = void (*)(const l3d_screen_info&, std::span<const std::uint32_t>, int y,
                                  std::uint8_t*);
    using replicate_function = void (*)(std::uint8_t* bytes, int width, int scale);

    const l3d_screen_info& info_;
    int scale_;
    row_function write_row_;
    replicate_function replicate_;
};

} // namespace l3d_detail

#endif
