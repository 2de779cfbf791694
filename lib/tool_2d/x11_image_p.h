// SPDX-License-Identifier: MIT
// x11_image: what a window's picture must do, wherever its pixels live.
#ifndef L3D_TOOL_2D_X11_IMAGE_P_H
#define L3D_TOOL_2D_X11_IMAGE_P_H

#include "tool_2d/pixels.h"
#include "tool_2d/x11_window_p.h"

#include <memory>
#include <string>

namespace l3d_detail {

/// The pixels of a window at one size, and the way they take to the server.
class x11_image {
public:
    x11_image() = default;
    x11_image(const x11_image&) = delete;
    x11_image& operator=(const x11_image&) = delete;
    virtual ~x11_image() = default;

    /// Lives:   as long as the image.
    l3d_pixels pixels() { return do_pixels(); }

    /// Sends the picture, and asks the server for an event once it has it. What Xlib still
    /// buffers goes out when events are next asked for.
    /// Expects: the last put is done. (What the server still reads may not be written, and what
    ///          it has not read yet must not pile up.)
    void put() { do_put(); }

    /// Whether this event is the server's answer to put.
    bool is_put_done(const XEvent& event) const { return do_is_put_done(event); }

    /// One phrase for describe(): how the pixels travel.
    std::string describe() const { return do_describe(); }

private:
    virtual l3d_pixels do_pixels() = 0;
    virtual void do_put() = 0;
    virtual bool do_is_put_done(const XEvent& event) const = 0;
    virtual std::string do_describe() const = 0;
};

/// Makes the image of a window at a size.
/// Errors:  std::bad_alloc.
/// Lives:   the window outlives the image.
using x11_image_maker = std::unique_ptr<x11_image> (*)(const x11_window& window, l3d_size size);

/// The picture travels over the connection, in the display's own pixels.
/// Errors:  std::bad_alloc.
std::unique_ptr<x11_image> make_x11_image_put(const x11_window& window, l3d_size size);

} // namespace l3d_detail

#endif
