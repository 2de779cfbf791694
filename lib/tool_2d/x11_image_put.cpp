// SPDX-License-Identifier: MIT
// x11_image by XPutImage.
#include "tool_2d/x11_image_p.h"

#include "tool_2d/pixel_writer_p.h"

#include <cassert>
#include <new>
#include <vector>

#include <X11/Xutil.h>

namespace l3d_detail {
namespace {

/// Frees Xlib's part of an image; the pixels are ours.
struct ximage_freer {
    void operator()(XImage* image) const {
        image->data = nullptr;
        XDestroyImage(image);
    }
};
using unique_ximage = std::unique_ptr<XImage, ximage_freer>;

unique_ximage make_ximage(const x11_window& window, l3d_size size) {
    const auto& layout = window.info().layout();
    // Row length 0: Xlib takes the shortest that the server allows, which it sends uncopied.
    unique_ximage image(XCreateImage(window.display(), window.visual(),
                                     static_cast<unsigned>(layout.depth), ZPixmap, 0, nullptr,
                                     static_cast<unsigned>(size.width),
                                     static_cast<unsigned>(size.height), layout.scanline_pad, 0));
    if (!image)
        throw std::bad_alloc();
    assert(image->bits_per_pixel == layout.bits_per_pixel);
    return image;
}

/// Without conversion the words are the XImage's data; otherwise it has a buffer of its own.
class x11_image_put final : public x11_image {
public:
    x11_image_put(const x11_window& window, l3d_size size)
        : window_(window), ximage_(make_ximage(window, size)), writer_(window.info()) {
        if (!writer_.is_identity())
            bytes_.resize(static_cast<std::size_t>(ximage_->bytes_per_line) *
                          static_cast<std::size_t>(size.height));
    }

private:
    bool do_is_free() const override { return !under_way_; }

    void do_put(const l3d_pixels& picture) override {
        assert(picture.width == ximage_->width && picture.height == ximage_->height);
        if (writer_.is_identity())
            ximage_->data = reinterpret_cast<char*>(picture.words);
        else
            convert(picture);
        XPutImage(window_.display(), window_.id(), window_.graphics(), ximage_.get(), 0, 0, 0, 0,
                  static_cast<unsigned>(ximage_->width), static_cast<unsigned>(ximage_->height));
        ask_for_answer();
        under_way_ = true;
    }

    void convert(const l3d_pixels& picture) {
        ximage_->data = reinterpret_cast<char*>(bytes_.data());
        writer_.write(picture, picture.size(), bytes_.data(), ximage_->bytes_per_line);
    }

    /// Sends an event to ourselves. The server works in order, so it arrives after the picture;
    /// and unlike a request with a reply it makes nobody wait.
    void ask_for_answer() const {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = window_.id();
        event.xclient.message_type = window_.atoms().l3d_put_done;
        event.xclient.format = 32;
        XSendEvent(window_.display(), window_.id(), False, NoEventMask, &event);
    }

    bool do_take(const XEvent& event) override {
        if (event.type != ClientMessage ||
            event.xclient.message_type != window_.atoms().l3d_put_done)
            return false;
        under_way_ = false;
        return true;
    }

    std::string do_describe() const override {
        return writer_.is_identity() ? "over the wire, unconverted" : "over the wire, converted";
    }

    const x11_window& window_;
    unique_ximage ximage_;
    pixel_writer writer_;
    std::vector<std::uint8_t> bytes_;
    bool under_way_ = false;
};

} // namespace

std::unique_ptr<x11_image> make_x11_image_put(const x11_window& window, l3d_size size) {
    return std::make_unique<x11_image_put>(window, size);
}

} // namespace l3d_detail
