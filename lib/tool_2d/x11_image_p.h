// SPDX-License-Identifier: MIT
// x11_image: the way a window's pictures take to the server.
#ifndef L3D_TOOL_2D_X11_IMAGE_P_H
#define L3D_TOOL_2D_X11_IMAGE_P_H

#include "tool_2d/pixels.h"
#include "tool_2d/x11_window_p.h"

#include <memory>
#include <string>

namespace l3d_detail {

/// The buffers in which the pictures of one window travel, for one size of it.
class x11_image {
public:
    x11_image() = default;
    x11_image(const x11_image&) = delete;
    x11_image& operator=(const x11_image&) = delete;
    virtual ~x11_image() = default;

    /// Whether a buffer is free: what the server still reads may not be written, and what it has
    /// not read yet must not pile up.
    bool is_free() const { return do_is_free(); }

    /// Sends the picture, and asks the server for an event once it has it. What Xlib still
    /// buffers goes out when events are next asked for.
    /// Expects: is_free(); a picture of the size this was made for.
    void put(const l3d_pixels& picture) { do_put(picture); }

    /// Takes the event if it is an answer to put; false if it is not.
    bool take(const XEvent& event) { return do_take(event); }

    /// True, with one line in `why`, once this way has turned out not to work. Pictures that were
    /// put may not have been seen; another x11_image has to go on.
    bool has_failed(std::string& why) { return do_has_failed(why); }

    /// One phrase for describe(): how the pixels travel.
    std::string describe() const { return do_describe(); }

private:
    virtual bool do_is_free() const = 0;
    virtual void do_put(const l3d_pixels& picture) = 0;
    virtual bool do_take(const XEvent& event) = 0;
    virtual bool do_has_failed(std::string&) { return false; }
    virtual std::string do_describe() const = 0;
};

/// The picture travels over the connection, in the display's own pixels.
/// Shape:   `size` in pixel words; the window's own pixels are scale() times as many.
/// Errors:  std::bad_alloc.
/// Lives:   the window outlives the image.
std::unique_ptr<x11_image> make_x11_image_put(const x11_window& window, l3d_size size);

/// The picture is in memory that the server shares.
/// Errors:  null, with one line in `why`, if that cannot be done here; std::bad_alloc.
/// Cost:    two round trips: one for the errors, one to read back what the server sees.
std::unique_ptr<x11_image> make_x11_image_shm(const x11_window& window, l3d_size size,
                                              std::string& why);

} // namespace l3d_detail

#endif
