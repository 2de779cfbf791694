// SPDX-License-Identifier: MIT
// An x11_image in memory that the server shares.
#include "tool_2d/x11/x11_image_p.h"

#include "tool_2d/pixel_writer_p.h"
#include "tool_2d/x11_window/x11_echo_p.h"
#include "tool_2d/x11/x11_shm_segment_p.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <chrono>

namespace l3d_detail {
namespace {

using std::chrono::steady_clock;

// The server copies one buffer to the screen while the next one is written. More of them would only
// add to the delay.
constexpr std::size_t buffer_count = 2;
// X counts a window's pixels in 16 bits with a sign.
constexpr int longest_side = 32767;
// The longest usual time for a picture. A server that works needs milliseconds. After this time, it
// is asked whether its answer was lost.
constexpr std::chrono::seconds usual_patience{1};

/// A buffer in the segment. Either the program may touch it, or the server.
struct shared_buffer {
    std::size_t offset = 0;
    unsigned long put = 0; ///< number of the request that lent it to the server; 0 if it is ours
    steady_clock::time_point put_time{};
};

/// An image in memory that the server shares. Words are copied into it, since the program may draw
/// into them while the server reads.
class x11_image_shm final : public x11_image {
public:
    x11_image_shm(const x11_window& window, unique_ximage ximage,
                  std::unique_ptr<x11_shm_segment> segment)
        : window_(window), writer_(window.info(), window.scale()), segment_(std::move(segment)),
          ximage_(std::move(ximage)), echo_(window),
          completion_(XShmGetEventBase(window.display()) + ShmCompletion) {
        ximage_->obdata = reinterpret_cast<char*>(&segment_->info());
        for (std::size_t i = 0; i < buffer_count; ++i)
            buffers_[i].offset = i * ximage_size(*ximage_);
    }

private:
    bool do_is_free() const override {
        return std::ranges::count(buffers_, 0UL, &shared_buffer::put) > 0;
    }
    bool do_is_idle() const override {
        return std::ranges::count(buffers_, 0UL, &shared_buffer::put) == buffer_count;
    }

    /// Writes a part into a free buffer and has the server read that part only. Beside the part,
    /// the buffer may be out of date.
    void do_put(const l3d_pixels& picture, const l3d_pixel_box& part, time_point) override {
        const l3d_size native{ximage_->width, ximage_->height};
        auto& buffer = *std::ranges::find(buffers_, 0UL, &shared_buffer::put);
        auto* const bytes = segment_->bytes() + buffer.offset;
        writer_.write(picture, pixel_writer::writable_part(part, picture.size()), native, bytes,
                      ximage_->bytes_per_line);
        ximage_->data = reinterpret_cast<char*>(bytes);
        buffer.put = XNextRequest(window_.display());
        buffer.put_time = steady_clock::now();
        const l3d_pixel_box box = writer_.native_part(part, native);
        XShmPutImage(window_.display(), window_.id(), window_.graphics(), ximage_.get(), box.left,
                     box.top, box.left, box.top, static_cast<unsigned>(box.right - box.left),
                     static_cast<unsigned>(box.bottom - box.top), True);
    }

    bool do_take(const XEvent& event) override {
        if (event.type == completion_)
            return take_completion(reinterpret_cast<const XShmCompletionEvent&>(event));
        const auto asked = echo_.serial();
        if (!echo_.take(event))
            return false;
        lost_completion_ = std::ranges::any_of(
            buffers_, [&](const auto& buffer) { return buffer.put != 0 && buffer.put < asked; });
        return true;
    }

    /// Takes the server's answer. Returns false if the answer is about an earlier image, which this
    /// one has replaced.
    bool take_completion(const XShmCompletionEvent& event) {
        if (event.shmseg != segment_->info().shmseg)
            return false;
        const auto done = std::ranges::find(buffers_, event.offset, &shared_buffer::offset);
        if (done != buffers_.end())
            done->put = 0;
        return true;
    }

    void do_look_after() override {
        const auto late = steady_clock::now() - usual_patience;
        const bool is_late = std::ranges::any_of(buffers_, [&](const auto& buffer) {
            return buffer.put != 0 && buffer.put_time < late;
        });
        if (is_late && !echo_.is_awaited())
            echo_.ask();
    }

    bool do_has_failed(std::string& why) const override {
        const auto& connection = window_.connection();
        for (const auto& buffer : buffers_) {
            const int error = buffer.put == 0 ? 0 : connection.error_of(buffer.put);
            if (error != 0) {
                why = "the X server refused a picture: " + x11_error_text(connection, error);
                return true;
            }
        }
        if (lost_completion_)
            why = "the X server does not say when it has read a picture";
        return lost_completion_;
    }

    std::string do_describe() const override {
        return writer_.is_identity() ? "unconverted" : "converted";
    }

    const x11_window& window_;
    pixel_writer writer_;
    std::unique_ptr<x11_shm_segment> segment_;
    unique_ximage ximage_;
    x11_echo echo_;
    int completion_; ///< type of the event that gives a buffer back
    std::array<shared_buffer, buffer_count> buffers_;
    bool lost_completion_ = false;
};

} // namespace

std::unique_ptr<x11_image> make_x11_image_shm(const x11_window& window, l3d_size size,
                                              std::string& why) {
    const l3d_size native{size.width * window.scale(), size.height * window.scale()};
    if (std::max(native.width, native.height) > longest_side) {
        why = "no X window has a side of more than " + std::to_string(longest_side) + " pixels";
        return nullptr;
    }
    auto ximage = make_ximage(window.display(), window.visual(), window.info().layout(), native);
    const auto bytes = buffer_count * ximage_size(*ximage);
    // X has 32 bits for a picture's place in a segment.
    if (bytes > UINT32_MAX) {
        why = "the pictures are too large for a segment";
        return nullptr;
    }
    auto segment = x11_shm_segment::make(window.connection(), window.visual(),
                                         window.info().layout(), bytes, why);
    if (!segment)
        return nullptr;
    return std::make_unique<x11_image_shm>(window, std::move(ximage), std::move(segment));
}

} // namespace l3d_detail
