// SPDX-License-Identifier: MIT
// x11_image by XPutImage.
#include "tool_2d/x11_image_p.h"

#include "tool_2d/pixel_writer_p.h"
#include "tool_2d/x11_echo_p.h"
#include "tool_2d/x11_ximage_p.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <utility>
#include <vector>

namespace l3d_detail {
namespace {

// Rows that are compared, and sent, together: an overlay line of text is about as high.
constexpr int band_height = 16;

/// Pictures go in pieces that never block, so that a server that is slow, or stopped, does not
/// take the program with it. What could not be sent is kept, and goes on in look_after.
class x11_image_put final : public x11_image {
public:
    x11_image_put(const x11_window& window, l3d_size size)
        : window_(window), writer_(window.info(), window.scale()),
          ximage_(make_ximage(window.display(), window.visual(), window.info().layout(),
                              {size.width * window.scale(), size.height * window.scale()})),
          bytes_(ximage_size(*ximage_)),
          stale_(static_cast<std::size_t>((ximage_->height + band_height - 1) / band_height)),
          echo_(window), is_local_(window.connection().is_local()) {
        if (!is_local_)
            row_.resize(ximage_row_size(*ximage_));
    }

private:
    bool do_is_free() const override { return do_is_idle(); }
    bool do_is_idle() const override { return !is_sending() && !echo_.is_awaited(); }
    bool do_is_sending() const override { return is_sending_; }

    void do_put(const l3d_pixels& picture, time_point deadline) override {
        assert(ximage_->width == picture.width * writer_.scale() &&
               ximage_->height == picture.height * writer_.scale());
        const bool is_copied = !is_local_ || !writer_.is_identity();
        assert(is_copied || picture.stride * 4 == ximage_->bytes_per_line);
        if (!is_local_)
            update(picture);
        else if (is_copied)
            writer_.write(picture, {ximage_->width, ximage_->height}, bytes_.data(),
                          ximage_->bytes_per_line);
        if (is_local_)
            stale_.assign(stale_.size(), true);
        ximage_->data = is_copied ? reinterpret_cast<char*>(bytes_.data())
                                  : reinterpret_cast<char*>(picture.words);
        next_row_ = 0;
        is_sending_ = std::ranges::find(stale_, true) != stale_.end();
        send(deadline);
        if (!is_copied)
            keep_rest();
    }

    /// Writes those rows that differ from what was sent before, and notes their bands.
    void update(const l3d_pixels& picture) {
        stale_.assign(stale_.size(), std::exchange(is_forgotten_, false));
        auto* kept = bytes_.data();
        for (int y = 0; y < ximage_->height; ++y) {
            const int word_row = y / writer_.scale();
            writer_.write_row(picture.row(word_row), word_row, ximage_->width, row_.data());
            if (std::memcmp(kept, row_.data(), row_.size()) != 0) {
                std::ranges::copy(row_, kept);
                stale_[static_cast<std::size_t>(y / band_height)] = true;
            }
            kept += row_.size();
        }
    }

    bool is_stale(int row) const { return stale_[static_cast<std::size_t>(row / band_height)]; }

    /// The end of the stale rows from next_row_ on, as many as go at once.
    int end_of_piece() const {
        const auto most = std::max(
            1, static_cast<int>(window_.connection().writable_size() / ximage_row_size(*ximage_)));
        const int end = std::min(ximage_->height, next_row_ + most);
        int row = next_row_ + 1;
        while (row < end && is_stale(row))
            ++row;
        return row;
    }

    /// Each piece, and the question at the end, goes when there is room for it. Even a small
    /// request would block right after a large one.
    void send(time_point deadline) {
        while (is_sending()) {
            while (next_row_ < ximage_->height && !is_stale(next_row_))
                ++next_row_;
            if (!window_.connection().wait_writable(deadline))
                return;
            if (next_row_ < ximage_->height)
                send_piece();
            else
                ask();
        }
    }

    void send_piece() {
        const int end = end_of_piece();
        XPutImage(window_.display(), window_.id(), window_.graphics(), ximage_.get(), 0, next_row_,
                  0, next_row_, static_cast<unsigned>(ximage_->width),
                  static_cast<unsigned>(end - next_row_));
        next_row_ = end;
    }

    void ask() {
        echo_.ask();
        is_sending_ = false;
    }

    /// What is not sent yet becomes ours.
    void keep_rest() {
        if (!is_sending())
            return;
        const auto sent = static_cast<std::size_t>(next_row_) * ximage_row_size(*ximage_);
        std::memcpy(bytes_.data() + sent, ximage_->data + sent, bytes_.size() - sent);
        ximage_->data = reinterpret_cast<char*>(bytes_.data());
    }

    void do_look_after() override { send({}); }

    void do_forget_shown() override { is_forgotten_ = true; }
    bool do_take(const XEvent& event) override { return echo_.take(event); }

    std::string do_describe() const override {
        return writer_.is_identity() ? "unconverted" : "converted";
    }

    const x11_window& window_;
    pixel_writer writer_;
    unique_ximage ximage_;
    std::vector<std::uint8_t> bytes_; ///< what is to be sent; over a network also what was
    std::vector<std::uint8_t> row_;   ///< what may become part of it
    std::vector<bool> stale_;         ///< bands that differ from what the window shows
    int next_row_ = 0;                ///< above it all is sent
    bool is_sending_ = false;         ///< pieces, or the question at the end
    x11_echo echo_;
    bool is_local_;
    bool is_forgotten_ = true; ///< nothing is known of what the window shows
};

} // namespace

std::unique_ptr<x11_image> make_x11_image_put(const x11_window& window, l3d_size size) {
    return std::make_unique<x11_image_put>(window, size);
}

} // namespace l3d_detail
