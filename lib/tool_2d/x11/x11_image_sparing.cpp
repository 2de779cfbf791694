// SPDX-License-Identifier: MIT
// An x11_image that sends changed pixels by XPutImage: text first, and the rest in coarse cells if
// it is much.
#include "tool_2d/x11/x11_image_p.h"

#include "tool_2d/pixel_writer_p.h"
#include "tool_2d/x11_window/x11_echo_p.h"
#include "tool_2d/x11/x11_enlarger_p.h"
#include "tool_2d/x11/x11_tiles_p.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

namespace l3d_detail {
namespace {

using std::chrono::steady_clock;
using namespace std::chrono_literals;

// The bytes that a line of 1 MB a second carries in 80 ms, at twelve pictures a second. Larger
// pictures are sent in coarse cells first, and their fine pixels follow in pieces of this size. So
// a key waits for one piece at most.
constexpr std::int64_t bytes_at_once = 80'000;
// The divisor of bytes_at_once for text. Text with no more bytes goes with a picture; more text
// goes by itself. Each picture also takes at least that many bytes of pixels that have come to
// rest.
constexpr std::int64_t small_part = 4;
// The time without a picture after which things have come to rest. At 15 pictures a second, three
// are missing by then.
constexpr auto until_rest = 250ms;

int cells(int length, int factor) {
    return (length + factor - 1) / factor;
}

/// The box of cells that show the pixels of a box.
l3d_pixel_box cells_of(const l3d_pixel_box& box, int factor) {
    return {box.left / factor, box.top / factor, cells(box.right, factor),
            cells(box.bottom, factor)};
}

/// The parts of a box outside a hole, as boxes that do not overlap.
/// Expects: the hole is empty, or lies in the box.
std::vector<l3d_pixel_box> beside(const l3d_pixel_box& box, const l3d_pixel_box& hole) {
    if (hole.empty())
        return {box};
    std::vector<l3d_pixel_box> sides{{box.left, box.top, box.right, hole.top},
                                     {box.left, hole.bottom, box.right, box.bottom},
                                     {box.left, hole.top, hole.left, hole.bottom},
                                     {hole.right, hole.top, box.right, hole.bottom}};
    std::erase_if(sides, [](const l3d_pixel_box& side) { return side.empty(); });
    return sides;
}

/// The mean colour of a box of words.
std::uint32_t mean_word(const l3d_pixels& picture, const l3d_pixel_box& box) {
    std::uint32_t red = 0, green = 0, blue = 0;
    for (int y = box.top; y < box.bottom; ++y) {
        for (const std::uint32_t word : l3d_row(picture, y, box)) {
            red += word >> 16 & 255;
            green += word >> 8 & 255;
            blue += word & 255;
        }
    }
    const auto count = static_cast<std::uint32_t>(box.area());
    const auto mean = [count](std::uint32_t sum) { return (sum + count / 2) / count; };
    return mean(red) << 16 | mean(green) << 8 | mean(blue);
}

/// Sends a picture in steps that never block, so that a slow or stopped server does not stop the
/// program. Steps that could not go are kept, and look_after goes on with them.
class x11_image_sparing final : public x11_image {
public:
    x11_image_sparing(const x11_window& window, l3d_size size)
        : window_(window), writer_(window.info(), window.scale()),
          cell_writer_(window.info()), native_{size.width * window.scale(),
                                               size.height * window.scale()},
          ximage_(ximage_of(native_)), bytes_(ximage_size(*ximage_)),
          row_(ximage_row_size(*ximage_)), letters_(native_), changed_(native_), coarse_(native_),
          echo_(window) {
        ximage_->data = reinterpret_cast<char*>(bytes_.data());
    }

private:
    bool do_is_free() const override { return do_is_idle(); }
    bool do_is_idle() const override { return !do_is_sending() && !echo_.is_awaited(); }
    bool do_is_sending() const override { return next_step_ < steps_.size(); }

    void do_put(const l3d_pixels& picture, const l3d_pixel_box& part,
                time_point deadline) override {
        const l3d_pixel_box written = pixel_writer::writable_part(part, picture.size());
        update(picture, written);
        if (std::exchange(is_forgotten_, false)) {
            add_changed(writer_.native_part(written, native_));
            coarse_.take();
        }
        last_put_ = steady_clock::now();
        const std::int64_t small = pixels_at_once() / small_part;
        const std::int64_t text = add_text();
        if (text <= small)
            add_motion(picture, small - text);
        add_question();
        send(deadline);
    }

    /// Adds the pixels that changed, and at least `least_rest` of the pixels that have come to
    /// rest, if there are so many.
    void add_motion(const l3d_pixels& picture, std::int64_t least_rest) {
        const int factor = factor_for(changed_.pixels());
        const std::int64_t room = pixels_at_once() - changed_.pixels() / (factor * factor);
        auto boxes = changed_.take();
        if (factor == 1)
            add_fine(boxes);
        else
            add_coarse(picture, factor, boxes);
        for (const l3d_pixel_box& box : boxes)
            coarse_.remove(box);
        if (const std::int64_t most = std::max(room, least_rest); most > 0)
            add_fine(coarse_.take(most));
        if (factor > 1)
            for (const l3d_pixel_box& box : boxes)
                coarse_.add(box);
    }

    void do_set_text(const std::vector<l3d_pixel_box>& boxes) override {
        std::vector<l3d_pixel_box> text;
        for (const l3d_pixel_box& box : boxes)
            text.push_back(box.scaled(writer_.scale()).intersected(l3d_whole(native_)));
        if (text == text_)
            return;
        text_ = std::move(text);
        // The window may still show cells at places where text appears on an unchanged picture.
        for (const l3d_pixel_box& box : text_)
            for (x11_tiles* tiles : {&changed_, &coarse_}) {
                for (const l3d_pixel_box& part : tiles->inside(box))
                    letters_.add(part);
                tiles->remove(box);
            }
    }

    /// Notes changed pixels. Pixels within text and pixels beside text are sent in different ways.
    void add_changed(const l3d_pixel_box& box) {
        for (const l3d_pixel_box& text : text_)
            if (const l3d_pixel_box letters = box.intersected(text); !letters.empty())
                letters_.add(letters);
        for (const l3d_pixel_box& rest : beside_text(box))
            changed_.add(rest);
    }

    /// The parts of a box outside of all text, as boxes that do not overlap.
    std::vector<l3d_pixel_box> beside_text(const l3d_pixel_box& box) const {
        std::vector<l3d_pixel_box> rests{box};
        for (const l3d_pixel_box& text : text_) {
            std::vector<l3d_pixel_box> next;
            for (const l3d_pixel_box& rest : rests) {
                const auto sides = beside(rest, rest.intersected(text));
                next.insert(next.end(), sides.begin(), sides.end());
            }
            rests = std::move(next);
        }
        return rests;
    }

    /// Adds text tile by tile, as much as can be sent at once. Returns the number of pixels that
    /// are sent.
    std::int64_t add_text() {
        std::int64_t pixels = 0;
        while (!letters_.empty() && pixels < pixels_at_once())
            for (const l3d_pixel_box& box : letters_.take(1))
                pixels += add_text(box);
        return pixels;
    }

    /// Adds a tile of text. Most of the tile has the panel's ground colour, with which the server
    /// fills the tile. The box around all other pixels is sent, so these pixels never blink.
    /// Returns the number of pixels that are sent.
    std::int64_t add_text(const l3d_pixel_box& box) {
        const auto* const ground = place_of(box.left, box.top);
        l3d_pixel_box letters;
        for (int y = box.top; y < box.bottom; ++y)
            for (int x = box.left; x < box.right; ++x)
                if (std::memcmp(place_of(x, y), ground, bytes_of(1)) != 0)
                    letters = letters.united({x, y, x + 1, y + 1});
        std::vector<XRectangle> filled;
        for (const l3d_pixel_box& side : beside(box, letters))
            filled.push_back({static_cast<short>(side.left), static_cast<short>(side.top),
                              static_cast<unsigned short>(side.right - side.left),
                              static_cast<unsigned short>(side.bottom - side.top)});
        const unsigned long word = XGetPixel(ximage_.get(), box.left, box.top);
        if (!filled.empty())
            steps_.emplace_back([this, word, filled]() mutable {
                XSetForeground(window_.display(), window_.graphics(), word);
                XFillRectangles(window_.display(), window_.id(), window_.graphics(), filled.data(),
                                static_cast<int>(filled.size()));
            });
        if (!letters.empty())
            add_pieces(letters, *ximage_, window_.id());
        return letters.area();
    }

    const std::uint8_t* place_of(int x, int y) const {
        return bytes_.data() + static_cast<std::size_t>(y) * ximage_row_size(*ximage_) +
               bytes_of(x);
    }

    unique_ximage ximage_of(l3d_size size) const {
        return make_ximage(window_.display(), window_.visual(), window_.info().layout(), size);
    }

    std::size_t bytes_of(int pixels) const {
        return static_cast<std::size_t>(pixels) *
               static_cast<std::size_t>(window_.info().bytes_per_pixel());
    }

    std::int64_t pixels_at_once() const { return bytes_at_once / window_.info().bytes_per_pixel(); }

    /// The width and height of cells, in pixels, with which `pixels` can be sent at once.
    int factor_for(std::int64_t pixels) const {
        int factor = 1;
        while (factor < x11_enlarger::largest_factor &&
               pixels / (factor * factor) > pixels_at_once())
            factor *= 2;
        return factor;
    }

    /// Writes the native pixels of a part into bytes_, and notes which of them have changed.
    void update(const l3d_pixels& picture, const l3d_pixel_box& part) {
        const l3d_pixel_box box = writer_.native_part(part, native_);
        for (int y = box.top; y < box.bottom; ++y) {
            const int word_row = y / writer_.scale();
            writer_.write_row(l3d_row(picture, word_row, part), word_row, box.right - box.left,
                              row_.data());
            auto* const kept = bytes_.data() +
                               static_cast<std::size_t>(y) * ximage_row_size(*ximage_) +
                               bytes_of(box.left);
            if (std::memcmp(kept, row_.data(), bytes_of(box.right - box.left)) != 0)
                update_row(box.left, box.right, y, kept);
        }
    }

    /// Compares a row tile by tile, as changes may lie at both of its ends.
    void update_row(int left, int right, int y, std::uint8_t* kept) {
        const std::size_t pixel = bytes_of(1);
        const auto* found = row_.data();
        for (int end = left; left < right; left = end) {
            end = std::min(right, (left / x11_tiles::width + 1) * x11_tiles::width);
            const std::size_t size = bytes_of(end - left);
            std::size_t first = 0, last = size;
            while (first < size && kept[first] == found[first])
                ++first;
            while (last > first && kept[last - 1] == found[last - 1])
                --last;
            if (first < last)
                add_changed({left + static_cast<int>(first / pixel), y,
                             left + static_cast<int>((last + pixel - 1) / pixel), y + 1});
            std::copy_n(found, size, kept);
            kept += size;
            found += size;
        }
    }

    /// Adds the pixels of boxes at full resolution.
    void add_fine(const std::vector<l3d_pixel_box>& boxes) {
        for (const l3d_pixel_box& box : boxes)
            add_pieces(box, *ximage_, window_.id());
    }

    /// Adds cells, which the server enlarges. The boxes grow to hold whole cells, except over text.
    void add_coarse(const l3d_pixels& picture, int factor, std::vector<l3d_pixel_box>& boxes) {
        if (!enlarger_)
            prepare_cells();
        l3d_pixel_box all;
        std::vector<l3d_pixel_box> shown;
        for (const l3d_pixel_box& box : boxes) {
            const l3d_pixel_box part = cells_of(box, factor);
            write_cells(picture, part, factor);
            add_pieces(part, *cell_ximage_, enlarger_->small());
            all = all.united(part);
            const l3d_pixel_box grown = part.scaled(factor).intersected(l3d_whole(native_));
            const auto rests = beside_text(grown);
            shown.insert(shown.end(), rests.begin(), rests.end());
        }
        enlarger_->add_steps(all, factor, steps_);
        for (const l3d_pixel_box& box : shown)
            steps_.emplace_back([this, box] { enlarger_->show(box); });
        boxes = std::move(shown);
    }

    void prepare_cells() {
        constexpr int least_factor = 2;
        cell_ximage_ =
            ximage_of({cells(native_.width, least_factor), cells(native_.height, least_factor)});
        cell_bytes_.resize(ximage_size(*cell_ximage_));
        cell_ximage_->data = reinterpret_cast<char*>(cell_bytes_.data());
        enlarger_ = std::make_unique<x11_enlarger>(window_, native_);
    }

    /// Writes cells. The colour of each cell is the mean of the words that the cell shows.
    void write_cells(const l3d_pixels& picture, const l3d_pixel_box& part, int factor) {
        std::vector<std::uint32_t> words(static_cast<std::size_t>(part.right - part.left));
        const auto box_of = [&](int x, int y) {
            const l3d_pixel_box box{x * factor, y * factor,
                                    std::min((x + 1) * factor, native_.width),
                                    std::min((y + 1) * factor, native_.height)};
            return cells_of(box, writer_.scale());
        };
        for (int y = part.top; y < part.bottom; ++y) {
            for (int x = part.left; x < part.right; ++x)
                words[static_cast<std::size_t>(x - part.left)] = mean_word(picture, box_of(x, y));
            cell_writer_.write_row(
                words, y, part.right - part.left,
                cell_bytes_.data() + static_cast<std::size_t>(y) * ximage_row_size(*cell_ximage_) +
                    bytes_of(part.left));
        }
    }

    /// Adds a box in pieces, each of as many rows as the connection takes at once.
    void add_pieces(const l3d_pixel_box& box, XImage& from, Drawable to) {
        const auto most = window_.connection().writable_size() / bytes_of(box.right - box.left);
        const int rows = std::max(1, static_cast<int>(most));
        for (int top = box.top; top < box.bottom; top += rows) {
            const l3d_pixel_box piece{box.left, top, box.right, std::min(box.bottom, top + rows)};
            steps_.emplace_back([this, piece, &from, to] {
                XPutImage(window_.display(), to, window_.graphics(), &from, piece.left, piece.top,
                          piece.left, piece.top, static_cast<unsigned>(piece.right - piece.left),
                          static_cast<unsigned>(piece.bottom - piece.top));
            });
        }
    }

    /// If there are steps, ends them by a question, whose answer tells that all steps are done.
    void add_question() {
        if (!steps_.empty())
            steps_.emplace_back([this] { echo_.ask(); });
    }

    /// Sends each step once there is room for it. Even a small request would block right after a
    /// large one.
    void send(time_point deadline) {
        while (do_is_sending() && window_.connection().wait_writable(deadline))
            steps_[next_step_++]();
        if (!do_is_sending()) {
            steps_.clear();
            next_step_ = 0;
        }
    }

    void do_look_after() override {
        send({});
        if (!do_is_idle() || steady_clock::now() < do_next_look())
            return;
        if (add_text() == 0) {
            // Changed pixels still wait if the last picture's text went by itself.
            for (const l3d_pixel_box& box : changed_.take())
                coarse_.add(box);
            add_fine(coarse_.take(pixels_at_once()));
        }
        add_question();
        send({});
    }

    time_point do_next_look() const override {
        if (!letters_.empty())
            return last_put_;
        return coarse_.empty() && changed_.empty() ? time_point::max() : last_put_ + until_rest;
    }

    void do_forget_shown() override { is_forgotten_ = true; }
    bool do_take(const XEvent& event) override { return echo_.take(event); }

    std::string do_describe() const override {
        return std::string(writer_.is_identity() ? "unconverted" : "converted") +
               ", changed tiles, coarse while they move";
    }

    const x11_window& window_;
    pixel_writer writer_, cell_writer_;
    l3d_size native_;
    unique_ximage ximage_, cell_ximage_;
    std::vector<std::uint8_t> bytes_; ///< the window's contents after all is sent
    std::vector<std::uint8_t> row_;   ///< a row that may become part of `bytes_`
    std::vector<std::uint8_t> cell_bytes_;
    std::vector<l3d_pixel_box> text_; ///< boxes of text, in the window's own pixels
    x11_tiles letters_;               ///< where the window shows other text than the latest picture
    x11_tiles changed_; ///< where the window shows neither pixels nor cells of the latest picture
    x11_tiles coarse_;  ///< where the window shows cells
    std::unique_ptr<x11_enlarger> enlarger_;
    std::vector<x11_enlarger::step> steps_;
    std::size_t next_step_ = 0;
    time_point last_put_{};
    x11_echo echo_;
    bool is_forgotten_ = true; ///< the window's contents are unknown
};

} // namespace

std::unique_ptr<x11_image> make_x11_image_sparing(const x11_window& window, l3d_size size) {
    return std::make_unique<x11_image_sparing>(window, size);
}

} // namespace l3d_detail
