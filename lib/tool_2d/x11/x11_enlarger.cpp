// SPDX-License-Identifier: MIT
// x11_enlarger: enlarges pictures by copies within the server.
#include "tool_2d/x11/x11_enlarger_p.h"

#include <algorithm>

namespace l3d_detail {
namespace {

// The copies in one step. Each takes 28 bytes, so all take 7168, less than the 8192 that every
// connection takes at once.
constexpr int copies_at_once = 256;

int rounded_up(int length, int unit) {
    return (length + unit - 1) / unit * unit;
}

unsigned length(int from, int to) {
    return static_cast<unsigned>(to - from);
}

/// The second strip of `strip` rows or columns, and every second strip after it.
std::vector<XRectangle> gaps(int strip, int length, int breadth, bool are_columns) {
    std::vector<XRectangle> list;
    for (int at = strip; at < length; at += 2 * strip) {
        const auto place = static_cast<short>(at);
        const auto thin = static_cast<unsigned short>(strip);
        const auto wide = static_cast<unsigned short>(breadth);
        list.push_back(are_columns ? XRectangle{place, 0, thin, wide}
                                   : XRectangle{0, place, wide, thin});
    }
    return list;
}

} // namespace

x11_enlarger::x11_enlarger(const x11_window& window, l3d_size native) : window_(window) {
    const int width = rounded_up(native.width, largest_factor);
    const int height = rounded_up(native.height, largest_factor);
    // There are most cells at the smallest factor, two.
    const auto pixmap = [&](int columns, int rows) {
        return XCreatePixmap(window.display(), window.id(), static_cast<unsigned>(columns),
                             static_cast<unsigned>(rows),
                             static_cast<unsigned>(window.info().layout().depth));
    };
    small_ = pixmap(width / 2, height / 2);
    wide_ = pixmap(width, height / 2);
    large_ = pixmap(width, height);
    copier_ = make_copier();
    for (std::size_t i = 0; i < doublings; ++i) {
        column_fillers_[i] = make_filler(gaps(1 << i, width, height, true));
        row_fillers_[i] = make_filler(gaps(1 << i, height, width, false));
    }
}

x11_enlarger::~x11_enlarger() {
    const bool is_lost = window_.connection().lost();
    const auto free = [&](GC graphics) {
        if (is_lost)
            XFree(graphics); // frees only Xlib's record of it, as there is no server to tell
        else
            XFreeGC(window_.display(), graphics);
    };
    free(copier_);
    std::ranges::for_each(column_fillers_, free);
    std::ranges::for_each(row_fillers_, free);
    if (!is_lost)
        for (const Pixmap pixmap : {small_, wide_, large_})
            XFreePixmap(window_.display(), pixmap);
}

/// A context for copies. Copies here never lack a part of their source, so the server need not
/// report missing parts after each copy.
GC x11_enlarger::make_copier() const {
    XGCValues values{};
    values.graphics_exposures = False;
    return XCreateGC(window_.display(), large_, GCGraphicsExposures, &values);
}

/// A context for copies into some gaps only.
GC x11_enlarger::make_filler(const std::vector<XRectangle>& gaps) const {
    GC graphics = make_copier();
    auto list = gaps;
    XSetClipRectangles(window_.display(), graphics, 0, 0, list.data(),
                       static_cast<int>(list.size()), YXSorted);
    return graphics;
}

void x11_enlarger::copy_columns(const l3d_pixel_box& cells, int factor) const {
    for (int x = cells.left; x < cells.right; ++x)
        XCopyArea(window_.display(), small_, wide_, copier_, x, cells.top, 1,
                  length(cells.top, cells.bottom), factor * x, cells.top);
}

/// Copies rows of the widened picture to every `factor`-th row of the large picture.
/// Shape:   `cells` has columns of the large picture, but rows of the small one.
void x11_enlarger::copy_rows(const l3d_pixel_box& cells, int factor) const {
    for (int y = cells.top; y < cells.bottom; ++y)
        XCopyArea(window_.display(), wide_, large_, copier_, cells.left, y,
                  length(cells.left, cells.right), 1, cells.left, factor * y);
}

void x11_enlarger::add_steps(const l3d_pixel_box& cells, int factor,
                             std::vector<step>& steps) const {
    for (int x = cells.left; x < cells.right; x += copies_at_once) {
        const int end = std::min(cells.right, x + copies_at_once);
        steps.emplace_back([=, this] { copy_columns({x, cells.top, end, cells.bottom}, factor); });
    }
    const l3d_pixel_box wide{factor * cells.left, cells.top, factor * cells.right, cells.bottom};
    for (int y = wide.top; y < wide.bottom; y += copies_at_once) {
        const int end = std::min(wide.bottom, y + copies_at_once);
        steps.emplace_back([=, this] {
            if (y == wide.top)
                for (int shift = 1, i = 0; shift < factor; shift *= 2, ++i)
                    XCopyArea(window_.display(), wide_, wide_,
                              column_fillers_[static_cast<std::size_t>(i)], wide.left, wide.top,
                              length(wide.left, wide.right), length(wide.top, wide.bottom),
                              wide.left + shift, wide.top);
            copy_rows({wide.left, y, wide.right, end}, factor);
        });
    }
    const l3d_pixel_box large{wide.left, factor * wide.top, wide.right, factor * wide.bottom};
    steps.emplace_back([=, this] {
        for (int shift = 1, i = 0; shift < factor; shift *= 2, ++i)
            XCopyArea(window_.display(), large_, large_, row_fillers_[static_cast<std::size_t>(i)],
                      large.left, large.top, length(large.left, large.right),
                      length(large.top, large.bottom), large.left, large.top + shift);
    });
}

void x11_enlarger::show(const l3d_pixel_box& box) const {
    XCopyArea(window_.display(), large_, window_.id(), copier_, box.left, box.top,
              length(box.left, box.right), length(box.top, box.bottom), box.left, box.top);
}

} // namespace l3d_detail
