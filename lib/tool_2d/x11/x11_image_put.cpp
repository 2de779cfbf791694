// SPDX-License-Identifier: MIT
// x11_image by XPutImage.
#include "tool_2d/x11/x11_image_p.h"

#include "tool_2d/pixel_writer_p.h"
#include "tool_2d/x11/x11_echo_p.h"
#include "tool_2d/x11/x11_ximage_p.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace l3d_detail {
namespace {

// Rows that are compared, and sent, together: an overlay line of text is about as high.
constexpr int band_height = 16;

/// From the first to behind the last of a band's pixels that are to be sent.
struct columns {
    int left = 0, right = 0;

    bool empty() const { return left >= right; }
    void add(const columns& more) {
        left = empty() ? more.left : std::min(left, more.left);
        right = std::max(right, more.right);
    }
    bool operator==(const columns&) const = default;
};

/// The first and the last byte in which two equally long rows differ, if they do.
std::optional<std::pair<std::size_t, std::size_t>> difference(std::span<const std::uint8_t> one,
                                                              std::span<const std::uint8_t> other) {
    const auto first = std::ranges::mismatch(one, other).in1 - one.begin();
    if (static_cast<std::size_t>(first) == one.size())
        return {};
    std::size_t last = one.size() - 1;
    while (one[last] == other[last])
        --last;
    return std::pair(static_cast<std::size_t>(first), last);
}

/// Pictures go in pieces that never block, so that a server that is slow, or stopped, does not take
/// the program with it. Pieces that could not be sent are kept, and look_after goes on with them.
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

    void do_put(const l3d_pixels& picture, const l3d_pixel_box& part,
                time_point deadline) override {
        assert(ximage_->width == picture.width * writer_.scale() &&
               ximage_->height == picture.height * writer_.scale());
        const bool is_copied =
            !is_local_ || !writer_.is_identity() || picture.stride * 4 != ximage_->bytes_per_line;
        const l3d_pixel_box written = pixel_writer::writable_part(part, picture.size());
        const l3d_size native{ximage_->width, ximage_->height};
        box_ = writer_.native_part(written, native);
        if (!is_local_)
            update(picture, written);
        else if (is_copied)
            writer_.write(picture, written, native, bytes_.data(), ximage_->bytes_per_line);
        if (is_local_)
            stale_.assign(stale_.size(), {box_.left, box_.right});
        ximage_->data = is_copied ? reinterpret_cast<char*>(bytes_.data())
                                  : reinterpret_cast<char*>(picture.words);
        next_row_ = box_.top;
        is_sending_ = !std::ranges::all_of(stale_, &columns::empty);
        send(deadline);
        if (!is_copied)
            keep_rest();
    }

    /// Writes those rows of the part that differ from what was sent before, and notes where.
    void update(const l3d_pixels& picture, const l3d_pixel_box& part) {
        stale_.assign(stale_.size(), std::exchange(is_forgotten_, false)
                                         ? columns{box_.left, box_.right}
                                         : columns{});
        const std::size_t size = bytes_of(box_.right - box_.left);
        const std::size_t pixel = bytes_of(1);
        auto* kept = bytes_.data() + place_of_part(box_.top);
        for (int y = box_.top; y < box_.bottom; ++y) {
            const int word_row = y / writer_.scale();
            writer_.write_row(l3d_row(picture, word_row, part), word_row, box_.right - box_.left,
                              row_.data());
            if (const auto found = difference({kept, size}, {row_.data(), size})) {
                std::copy_n(row_.data(), size, kept);
                stale_[static_cast<std::size_t>(y / band_height)].add(
                    {box_.left + static_cast<int>(found->first / pixel),
                     box_.left + static_cast<int>(found->second / pixel) + 1});
            }
            kept += ximage_row_size(*ximage_);
        }
    }

    std::size_t bytes_of(int pixels) const {
        return static_cast<std::size_t>(pixels * ximage_->bits_per_pixel / 8);
    }
    std::size_t place_of_part(int row) const {
        return static_cast<std::size_t>(row) * ximage_row_size(*ximage_) + bytes_of(box_.left);
    }

    const columns& stale(int row) const {
        return stale_[static_cast<std::size_t>(row / band_height)];
    }

    /// The end of the rows from next_row_ on that are stale in the same columns, as many as go at
    /// once.
    int end_of_piece() const {
        const columns& wanted = stale(next_row_);
        const auto most =
            window_.connection().writable_size() / bytes_of(wanted.right - wanted.left);
        const int end = std::min(box_.bottom, next_row_ + std::max(1, static_cast<int>(most)));
        int row = next_row_ + 1;
        while (row < end && stale(row) == wanted)
            ++row;
        return row;
    }

    /// Each piece, and the question at the end, goes when there is room for it. Even a small
    /// request would block right after a large one.
    void send(time_point deadline) {
        while (is_sending()) {
            while (next_row_ < box_.bottom && stale(next_row_).empty())
                ++next_row_;
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
        const auto [left, right] = stale(next_row_);
        XPutImage(window_.display(), window_.id(), window_.graphics(), ximage_.get(), left,
                  next_row_, left, next_row_, static_cast<unsigned>(right - left),
                  static_cast<unsigned>(end - next_row_));
        next_row_ = end;
    }

    void ask() {
        echo_.ask();
        is_sending_ = false;
    }

    /// The pixels that are not sent yet become ours.
    void keep_rest() {
        if (!is_sending())
            return;
        const auto sent = static_cast<std::size_t>(next_row_) * ximage_row_size(*ximage_);
        const auto end = static_cast<std::size_t>(box_.bottom) * ximage_row_size(*ximage_);
        std::memcpy(bytes_.data() + sent, ximage_->data + sent, end - sent);
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
    std::vector<columns> stale_;      ///< where bands differ from what the window shows
    l3d_pixel_box box_;               ///< what is sent of the display's own pixels
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
