// SPDX-License-Identifier: MIT
// x11_enlarger: has the server enlarge small pictures.
#ifndef L3D_TOOL_2D_X11_X11_ENLARGER_P_H
#define L3D_TOOL_2D_X11_X11_ENLARGER_P_H

#include "tool_2d/x11/x11_window_p.h"

#include <array>
#include <functional>
#include <vector>

namespace l3d_detail {

/// Enlarges parts of a picture in the server. This class uses only core requests, since untrusted
/// clients may use no others.
///
/// The columns of a small picture are moved apart. Copies of all columns then fill the gaps. Each
/// copy is shifted by twice as much as the copy before. Rows are enlarged in the same way.
/// Lives:   the window outlives the enlarger.
/// Cost:    memory in the server for almost two large pictures. A part of w x h cells takes w + h
///          requests of 28 bytes beside its pixels.
class x11_enlarger {
public:
    /// The largest side of the square that shows a cell. Each such side is a power of two.
    static constexpr int largest_factor = 4;

    /// Some requests that go together, small enough for every connection's buffer.
    using step = std::function<void()>;

    /// Makes the pixmaps in the server. `native` is the size of the large picture.
    x11_enlarger(const x11_window& window, l3d_size native);
    x11_enlarger(const x11_enlarger&) = delete;
    x11_enlarger& operator=(const x11_enlarger&) = delete;
    ~x11_enlarger();

    /// The pixmap that small pictures are put into.
    Pixmap small() const { return small_; }

    /// Adds the steps that enlarge these cells of small() by `factor`.
    /// Lives:   the steps borrow this.
    void add_steps(const l3d_pixel_box& cells, int factor, std::vector<step>& steps) const;

    /// Copies a box of the large picture to the window.
    /// Expects: the steps from add_steps() for the cells in this box have run.
    void show(const l3d_pixel_box& box) const;

private:
    /// The number of doublings that make the largest factor.
    static constexpr std::size_t doublings = 2;

    GC make_copier() const;
    GC make_filler(const std::vector<XRectangle>& gaps) const;
    void copy_columns(const l3d_pixel_box& cells, int factor) const;
    void copy_rows(const l3d_pixel_box& cells, int factor) const;

    const x11_window& window_;
    Pixmap small_, wide_, large_; ///< the cells; the cells with enlarged columns; the large picture
    GC copier_;
    std::array<GC, doublings> column_fillers_{}, row_fillers_{};
};

} // namespace l3d_detail

#endif
