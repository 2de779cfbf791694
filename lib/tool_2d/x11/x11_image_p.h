// SPDX-License-Identifier: MIT
// x11_image: carries a window's pictures to the server.
#ifndef L3D_TOOL_2D_X11_X11_IMAGE_P_H
#define L3D_TOOL_2D_X11_X11_IMAGE_P_H

#include "tool_2d/pixels.h"
#include "tool_2d/x11/x11_window_p.h"

#include <cassert>
#include <chrono>
#include <cstddef>
#include <memory>
#include <new>
#include <string>
#include <vector>

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

/// Makes an XImage in the display's pixel layout, without memory for its pixels.
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

/// The buffers in which the pictures of one window travel, for one size of the window.
class x11_image {
public:
    using time_point = std::chrono::steady_clock::time_point;

    x11_image() = default;
    x11_image(const x11_image&) = delete;
    x11_image& operator=(const x11_image&) = delete;
    virtual ~x11_image() = default;

    /// Whether a buffer is free for a picture. The server still reads the busy buffers. Pictures
    /// that it has not read must not pile up.
    bool is_free() const { return do_is_free(); }

    /// Sends a part of the picture, and asks for an event that tells when the server has it. Xlib
    /// may buffer the requests until events are next asked for. The words may change after the
    /// call.
    /// Expects: is_free(). The picture has the size that this image was made for. Outside of the
    ///          part, the picture is the same as in the last put. The part is not empty, and is the
    ///          whole picture the first time.
    /// Cost:    in proportion to the part. Waits for a slow connection until the deadline, and
    ///          copies the rest.
    void put(const l3d_pixels& picture, const l3d_pixel_box& part, time_point deadline) {
        do_put(picture, part, deadline);
    }

    /// Tells where text stands from the next picture on. An image for a slow line sends the text
    /// first, and exactly.
    /// Expects: boxes in pixel words, which do not overlap.
    void set_text(const std::vector<l3d_pixel_box>& boxes) { do_set_text(boxes); }

    /// Sends the rest that put could not send without blocking, makes coarse parts fine, and asks
    /// for overdue answers. Call it now and then before events are read.
    void look_after() { do_look_after(); }

    /// The time at which look_after has something to do even if the server sends nothing.
    /// Expects: is_idle().
    time_point next_look() const { return do_next_look(); }

    /// Whether part of a picture is still to be sent, as soon as the connection takes it.
    bool is_sending() const { return do_is_sending(); }

    /// Whether the server has answered all puts.
    bool is_idle() const { return do_is_idle(); }

    /// Notes that the window may have lost its picture: the next picture has to be whole.
    void forget_shown() { do_forget_shown(); }

    /// Takes the event if it is an answer to put; false if it is not.
    bool take(const XEvent& event) { return do_take(event); }

    /// Whether this way of sending has failed. Pictures that were put may not have been seen, so
    /// another x11_image has to replace this one.
    /// Errors:  true, with one line in `why`.
    bool has_failed(std::string& why) const { return do_has_failed(why); }

    /// Describes, in one phrase for l3d_screen::describe, how words are converted on their way.
    std::string describe() const { return do_describe(); }

private:
    virtual bool do_is_free() const = 0;
    virtual void do_put(const l3d_pixels& picture, const l3d_pixel_box& part,
                        time_point deadline) = 0;
    virtual void do_set_text(const std::vector<l3d_pixel_box>&) {}
    virtual void do_look_after() = 0;
    virtual time_point do_next_look() const { return time_point::max(); }
    virtual bool do_is_sending() const { return false; }
    virtual bool do_is_idle() const = 0;
    virtual void do_forget_shown() {}
    virtual bool do_take(const XEvent& event) = 0;
    virtual bool do_has_failed(std::string&) const { return false; }
    virtual std::string do_describe() const = 0;
};

/// Makes an image whose pictures travel over the connection, in the display's own pixels.
/// Shape:   `size` in pixel words; the window's own size is scale() times as large.
/// Errors:  std::bad_alloc.
/// Lives:   the window outlives the image.
std::unique_ptr<x11_image> make_x11_image_put(const x11_window& window, l3d_size size);

/// Makes an image for a slow line, which sends only pixels that differ from those sent before. If
/// many pixels differ, the image sends fewer and coarser cells, which the server enlarges. The fine
/// pixels follow once no picture has come for a while.
/// Errors:  as make_x11_image_put.
/// Lives:   the window outlives the image.
std::unique_ptr<x11_image> make_x11_image_sparing(const x11_window& window, l3d_size size);

/// Makes an image in memory that the server shares.
/// Errors:  null, with one line in `why`, if memory cannot be shared here; std::bad_alloc.
/// Cost:    as x11_shm_segment::make.
std::unique_ptr<x11_image> make_x11_image_shm(const x11_window& window, l3d_size size,
                                              std::string& why);

} // namespace l3d_detail

#endif
