// SPDX-License-Identifier: MIT
// l3d_screen_memory: the screen without a display, with pixels of its own or around given ones.
#ifndef L3D_TOOL_2D_SCREEN_MEMORY_H
#define L3D_TOOL_2D_SCREEN_MEMORY_H

#include "base/public.h"
#include "tool_2d/image.h"
#include "tool_2d/screen.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace l3d_detail {
class pixel_writer;
}

/// Memory that somebody else owns, with pixels of any layout, such as an XImage of 16 bits.
///
/// Shape:   height rows, each `pitch` bytes after the one above it.
/// Lives:   borrows the bytes.
struct L3D_PUBLIC l3d_packed_pixels {
    std::uint8_t* bytes = nullptr; ///< the first byte of the top row
    l3d_size size{};               ///< width and height, in pixels
    std::ptrdiff_t pitch = 0;      ///< bytes from one row to the next
    l3d_pixel_layout layout{}; ///< 8, 16, 24 or 32 bits for each pixel, and the masks of colours
};

/// A screen that only has pixels in memory. It has no events, and wait returns at once.
///
/// Shape:   its own rows are longer than the picture, so that nobody relies on stride == width.
class L3D_PUBLIC l3d_screen_memory final : public l3d_screen {
public:
    /// A screen of this size. Expects: width and height at least 1.
    /// Errors:  std::bad_alloc.
    explicit l3d_screen_memory(l3d_size size);

    /// A screen around given words, which hold the picture once it is drawn.
    /// Expects: width and height at least 1, stride >= width; the words outlive the screen.
    explicit l3d_screen_memory(const l3d_pixels& words);

    /// A screen around packed pixels, which hold the picture once it is shown. Colours that the
    /// layout lacks are mixed from neighbouring colours by an ordered dither.
    /// Expects: width and height at least 1; rows that do not overlap; a layout of masks; bytes
    ///          that outlive the screen.
    /// Errors:  std::bad_alloc.
    explicit l3d_screen_memory(const l3d_packed_pixels& packed);
    ~l3d_screen_memory() override;

private:
    l3d_pixels do_pixels() override { return words_; }
    const l3d_screen_info& do_info() const override { return info_; }
    void do_show(const l3d_pixel_box& part) override;
    std::string do_describe() const override;
    bool do_next_event(l3d_event&) override { return false; }
    void do_wait(std::chrono::nanoseconds, int) override {}

    l3d_image image_;  ///< the screen's own words; empty if the caller gave words
    l3d_pixels words_; ///< the words of image_, or those that the caller gave
    l3d_packed_pixels packed_{};
    l3d_screen_info info_;
    std::unique_ptr<l3d_detail::pixel_writer> writer_; ///< writes packed pixels; null without them
};

/// Makes screens without a display. Such screens can be made everywhere.
class L3D_PUBLIC l3d_screen_factory_memory final : public l3d_screen_factory {
private:
    /// Tells that the screens serve, but are not seen. Errors: none.
    l3d_service do_service() const override { return {.is_seen = false}; }

    /// Makes a screen. Errors: null, with the size in the reason, if there is not enough memory for
    /// the screen.
    std::unique_ptr<l3d_screen> do_create(const l3d_screen_request& request,
                                          l3d_service& refusal) const override;
};

#endif
