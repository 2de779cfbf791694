// SPDX-License-Identifier: MIT
// x11_tiles: cuts boxes at tiles when they are added, and joins them again when they are taken.
#include "tool_2d/x11/x11_tiles_p.h"

#include <algorithm>
#include <utility>

namespace l3d_detail {

x11_tiles::x11_tiles(l3d_size size)
    : columns_((size.width + width - 1) / width), rows_((size.height + height - 1) / height),
      boxes_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

l3d_pixel_box& x11_tiles::tile(int column, int row) {
    return boxes_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
}

/// Calls visit(kept, place) for each tile that a box touches, and updates the number of pixels.
/// `kept` is the tile's box, to be changed, and `place` the whole tile.
template <class Visit> void x11_tiles::visit_tiles(const l3d_pixel_box& box, Visit visit) {
    if (box.empty())
        return;
    for (int row = box.top / height; row <= (box.bottom - 1) / height; ++row) {
        for (int column = box.left / width; column <= (box.right - 1) / width; ++column) {
            l3d_pixel_box& kept = tile(column, row);
            pixels_ -= kept.area();
            visit(kept, l3d_pixel_box{column * width, row * height, (column + 1) * width,
                                      (row + 1) * height});
            pixels_ += kept.area();
        }
    }
}

void x11_tiles::add(const l3d_pixel_box& box) {
    visit_tiles(box, [&box](l3d_pixel_box& kept, const l3d_pixel_box& place) {
        kept = kept.united(box.intersected(place));
    });
}

void x11_tiles::remove(const l3d_pixel_box& box) {
    visit_tiles(box, [&box](l3d_pixel_box& kept, const l3d_pixel_box&) {
        if (kept.intersected(box) == kept)
            kept = {};
    });
}

std::vector<l3d_pixel_box> x11_tiles::inside(const l3d_pixel_box& box) const {
    std::vector<l3d_pixel_box> found;
    for (const l3d_pixel_box& kept : boxes_)
        if (const l3d_pixel_box common = kept.intersected(box); !common.empty())
            found.push_back(common);
    return found;
}

/// Takes boxes of a row of tiles. Boxes of neighbouring tiles become one.
std::vector<l3d_pixel_box> x11_tiles::take_row(int row, std::int64_t most, std::int64_t& taken) {
    std::vector<l3d_pixel_box> found;
    bool goes_on = false;
    for (int column = 0; column < columns_ && (taken < most || taken == 0); ++column) {
        const l3d_pixel_box box = std::exchange(tile(column, row), {});
        if (!box.empty() && goes_on)
            found.back() = found.back().united(box);
        else if (!box.empty())
            found.push_back(box);
        goes_on = !box.empty();
        pixels_ -= box.area();
        taken += box.area();
    }
    return found;
}

std::vector<l3d_pixel_box> x11_tiles::take(std::int64_t most) {
    std::vector<l3d_pixel_box> found;
    std::int64_t taken = 0;
    for (int row = 0; row < rows_ && !empty() && (taken < most || taken == 0); ++row) {
        for (const l3d_pixel_box& box : take_row(row, most, taken)) {
            // A box that continues another one downwards, with the same columns, lengthens that.
            const auto above = std::ranges::find_if(found, [&](const l3d_pixel_box& other) {
                return other.bottom == box.top && other.left == box.left &&
                       other.right == box.right;
            });
            if (above == found.end())
                found.push_back(box);
            else
                above->bottom = box.bottom;
        }
    }
    return found;
}

} // namespace l3d_detail
