// SPDX-License-Identifier: MIT
// An x11_image that sends pictures by XPutImage.
#include "tool_2d/x11/x11_image_p.h"

#include "tool_2d/pixel_writer_p.h"
#include "tool_2d/x11_window/x11_echo_p.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <vector>

namespace l3d_detail {
namespace {

/// Sends pictures in pieces that never block, so that a slow or stopped server does not stop the
/// program. Pieces that could not be sent are kept, and look_after goes on with them.
class x11_image_put final : public x11_image {
public:
    x11_image_put(const x11_window& window, l3d_size size)
        : window_(window), writer_(window.info(), window.scale()),
          ximage_(make_ximage(window.display(), window.visual(), window.info().layout(),
                              {size.width * window.scale(), size.height * window.scale()})),
          bytes_(ximage_size(*ximage_)), echo_(window) {}

private:
    bool do_is_free() const override { return do_is_idle(); }
    bool do_is_idle() const override { return !is_sending() && !echo_.is_awaited(); }
    bool do_is_sending() const override { return is_sending_; }

    void do_put(const l3d_pixels& picture, const l3d_pixel_box& part,
                time_point deadline) override {
        assert(ximage_->width == picture.width * writer_.scale() &&
               ximage_->height == picture.height * writer_.scale());
        const bool is_copied =
            !writer_.is_identity() || picture.stride * 4 != ximage_->bytes_per_line;
        const l3d_pixel_box written = pixel_writer::writable_part(part, picture.size());
        const l3d_size native{ximage_->width, ximage_->height};
        box_ = writer_.native_part(written, native);
        if (is_copied)
            writer_.write(picture, written, native, bytes_.data(), ximage_->bytes_per_line);
        ximage_->data = is_copied ? reinterpret_cast<char*>(bytes_.data())
                                  : reinterpret_cast<char*>(picture.words);
        next_row_ = box_.top;
        is_sending_ = true;
        send(deadline);
        if (!is_copied)
            keep_rest();
    }

    /// The end of the rows, from next_row_ on, that go in one piece.
    int end_of_piece() const {
        const auto row = static_cast<std::size_t>(box_.right - box_.left) *
                         static_cast<std::size_t>(window_.info().bytes_per_pixel());
        const auto most = static_cast<int>(window_.connection().writable_size() / row);
        return std::min(box_.bottom, next_row_ + std::max(1, most));
    }

    /// Sends each piece once there is room for it. At the end, it asks for the event that tells
    /// when all is done. Even a small request would block right after a large one.
    void send(time_point deadline) {
        while (is_sending()) {
            if (!window_.connection().wait_writable(deadline))
                return;
            if (next_row_ < box_.bottom)
                send_piece();
            else
                ask();
        }
    }

    void send_piece() {
        const int end = end_of_piece();
        XPutImage(window_.display(), window_.id(), window_.graphics(), ximage_.get(), box_.left,
                  next_row_, box_.left, next_row_, static_cast<unsigned>(box_.right - box_.left),
                  static_cast<unsigned>(end - next_row_));
        next_row_ = end;
    }

    void ask() {
        echo_.ask();
        is_sending_ = false;
    }

    /// Copies the pixels that are not sent yet.
    void keep_rest() {
        if (!is_sending())
            return;
        const auto sent = static_cast<std::size_t>(next_row_) * ximage_row_size(*ximage_);
        const auto end = static_cast<std::size_t>(box_.bottom) * ximage_row_size(*ximage_);
        std::memcpy(bytes_.data() + sent, ximage_->data + sent, end - sent);
        ximage_->data = reinterpret_cast<char*>(bytes_.data());
    }

    void do_look_after() override { send({}); }

    bool do_take(const XEvent& event) override { return echo_.take(event); }

    std::string do_describe() const override {
        return writer_.is_identity() ? "unconverted" : "converted";
    }

    const x11_window& window_;
    pixel_writer writer_;
    unique_ximage ximage_;
    std::vector<std::uint8_t> bytes_; ///< bytes to send, unless the words themselves are sent
    l3d_pixel_box box_;               ///< the part that is sent, in native pixels
    int next_row_ = 0;                ///< the rows above this one are sent
    bool is_sending_ = false; ///< whether pieces, or the question at the end, are still to be sent
    x11_echo echo_;
};

} // namespace

std::unique_ptr<x11_image> make_x11_image_put(const x11_window& window, l3d_size size) {
    return std::make_unique<x11_image_put>(window, size);
}

} // namespace l3d_detail
