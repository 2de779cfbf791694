// SPDX-License-Identifier: MIT
// x11_tiles: the parts of a picture that are to be sent.
#ifndef L3D_TOOL_2D_X11_X11_TILES_P_H
#define L3D_TOOL_2D_X11_X11_TILES_P_H

#include "tool_2d/pixels.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace l3d_detail {

/// A set of pixels that are to be sent. The picture is divided into tiles, and each tile has one
/// box that holds the set's pixels in this tile. So the boxes are few, and hold few pixels outside
/// of the set.
/// Cost:    16 bytes a tile.
class x11_tiles {
public:
    /// Width and height of a tile, in pixels. A letter of an overlay is about half as wide and as
    /// high. A rectangle that is sent has 24 bytes beside its pixels, a hundredth of a tile's 2048.
    static constexpr int width = 32, height = 16;

    explicit x11_tiles(l3d_size size);

    bool empty() const { return pixels_ == 0; }

    /// The number of pixels in the boxes.
    std::int64_t pixels() const { return pixels_; }

    /// Adds all pixels of a box. Expects: the box lies in the picture.
    void add(const l3d_pixel_box& box);

    /// Removes the box of each tile whose box lies wholly in the given box.
    void remove(const l3d_pixel_box& box);

    /// The parts of the boxes that lie inside `box`; none overlap. Expects: `box` lies in the
    /// picture.
    std::vector<l3d_pixel_box> inside(const l3d_pixel_box& box) const;

    /// Takes boxes out of the set, from top to bottom: all boxes, or as many as have at least
    /// `most` pixels. At least one is taken unless the set is empty. No two boxes overlap.
    std::vector<l3d_pixel_box> take(std::int64_t most = std::numeric_limits<std::int64_t>::max());

private:
    template <class Visit> void visit_tiles(const l3d_pixel_box& box, Visit visit);
    l3d_pixel_box& tile(int column, int row);
    std::vector<l3d_pixel_box> take_row(int row, std::int64_t most, std::int64_t& taken);

    int columns_, rows_;
    /// The box of each tile; empty if no pixel of the tile is in the set.
    std::vector<l3d_pixel_box> boxes_;
    std::int64_t pixels_ = 0;
};

} // namespace l3d_detail

#endif
