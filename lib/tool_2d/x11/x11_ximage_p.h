// SPDX-License-Identifier: MIT
// What both kinds of x11_image need: Xlib's description of pixels, and its sizes.
#ifndef L3D_TOOL_2D_X11_X11_XIMAGE_P_H
#define L3D_TOOL_2D_X11_X11_XIMAGE_P_H

#include "tool_2d/pixels.h"
#include "tool_2d/screen_info.h"

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>

#include <X11/Xutil.h>

namespace l3d_detail {

/// Frees Xlib's part of an image; pixels and segment are ours.
struct ximage_freer {
    void operator()(XImage* image) const {
        image->data = nullptr;
        image->obdata = nullptr;
        XDestroyImage(image);
    }
};
using unique_ximage = std::unique_ptr<XImage, ximage_freer>;

/// An image of the display's own pixels that has none yet.
///
/// Shape:   rows as short as the server allows, which Xlib sends uncopied.
/// Errors:  std::bad_alloc.
inline unique_ximage make_ximage(Display* display, Visual* visual, const l3d_pixel_layout& layout,
                                 l3d_size size) {
    unique_ximage image(XCreateImage(display, visual, static_cast<unsigned>(layout.depth), ZPixmap,
                                     0, nullptr, static_cast<unsigned>(size.width),
                                     static_cast<unsigned>(size.height), layout.scanline_pad, 0));
    if (!image)
        throw std::bad_alloc();
    assert(image->bits_per_pixel == layout.bits_per_pixel);
    return image;
}

inline std::size_t ximage_row_size(const XImage& image) {
    return static_cast<std::size_t>(image.bytes_per_line);
}

inline std::size_t ximage_size(const XImage& image) {
    return ximage_row_size(image) * static_cast<std::size_t>(image.height);
}

} // namespace l3d_detail

#endif
