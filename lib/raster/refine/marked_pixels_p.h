// SPDX-License-Identifier: MIT
// marked_pixels: lists the pixels of a band that are sampled, in tiles.
#ifndef L3D_RASTER_REFINE_MARKED_PIXELS_P_H
#define L3D_RASTER_REFINE_MARKED_PIXELS_P_H

#include "raster/refine/drawn_depth_p.h"
#include "raster/pixel_bits.h"
#include "tool_2d/pixels.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace l3d_detail {

/// A pixel that is sampled for anti-aliasing, and what is known about the polygons that were added
/// to the pixel.
struct marked_pixel {
    std::int32_t x, y;
    std::uint32_t last; ///< index of the fragment that was added to the pixel last
    bool is_closed;     ///< whether something was drawn in the pixel and in all pixels around it
    /// The farthest depth at which a surface can still be seen in the pixel. At first it is the
    /// farthest depth drawn in the pixel and around it. Polygons that cover all samples may bring
    /// this depth nearer.
    float farthest;
    float least;           ///< the least inv_w of the polygons that were added to the pixel
    std::uint64_t covered; ///< a bit for each sample: whether an added polygon covers it
};

/// The marked pixels of a band, sorted by tiles. So the marked pixels that a polygon may reach are
/// found quickly.
///
/// Shape: rows of tiles of 8 x 8 pixels. A tile has a bit for each pixel: bit 8 row + column.
///        Pixels are listed tile by tile, and in each tile in the order of bits.
/// Lives: make one object for each worker, and keep it from frame to frame, since it keeps its
///        memory.
class marked_pixels {
public:
    static constexpr std::int32_t side = 8;
    struct tile {
        std::uint64_t bits = 0;
        std::uint64_t open = 0;  ///< the mask of the marked pixels that still take fragments
        std::uint32_t first = 0; ///< the index of the tile's first marked pixel in pixels()
    };

    /// Starts a band. It takes rows of tiles from the band's top on, until the number of marked
    /// pixels reaches `most`.
    /// Expects: the band begins at a tile.
    void begin(const l3d_pixel_bits& marks, const drawn_depth& depth, const l3d_pixel_box& band,
               std::size_t most);

    /// Opens closed pixels again that the added polygons do not cover wholly, and removes their
    /// fragments. Opened pixels take all polygons, also those behind the surfaces drawn in the
    /// pixel. All other pixels take no more fragments. Returns whether any pixel is open.
    bool reopen();

    /// Walks the tiles that have open pixels in a box, one after the other.
    /// Expects: the box lies in the band, and is not empty.
    class open_tiles {
    public:
        open_tiles(const marked_pixels& of, const l3d_pixel_box& box)
            : box_(box), columns_(of.columns_), last_(column_of(box.right - 1)),
              next_(column_of(box.left)), top_(box.top & -side), row_(&of.at(0, top_ / side)),
              rows_(rows_inside()) {}

        /// Goes to the first tile, or to the next one. Returns whether there is one.
        bool next() {
            constexpr std::uint64_t a_row = (1u << side) - 1, a_column = 0x0101010101010101;
            for (;;) {
                if (next_ > last_) {
                    top_ += side;
                    if (top_ >= box_.bottom)
                        return false;
                    next_ = column_of(box_.left);
                    row_ += columns_;
                    rows_ = rows_inside();
                }
                bits_ = row_[next_++].open & rows_;
                if (bits_ == 0)
                    continue;
                bits_ &= (a_row << std::max(box_.left - left(), 0) &
                          a_row >> std::max(left() + side - box_.right, 0)) *
                         a_column;
                if (bits_ != 0)
                    return true;
            }
        }

        const tile& here() const { return row_[next_ - 1]; }
        std::int32_t left() const { return static_cast<std::int32_t>(next_ - 1) * side; }
        std::int32_t top() const { return top_; }
        /// The open pixels of the present tile that are in the box, as bits.
        std::uint64_t bits() const { return bits_; }

    private:
        static std::uint32_t column_of(std::int32_t x) {
            return static_cast<std::uint32_t>(x) / side;
        }
        std::uint64_t rows_inside() const {
            constexpr std::uint64_t all = ~std::uint64_t{0};
            return all << side * std::max(box_.top - top_, 0) &
                   all >> side * std::max(top_ + side - box_.bottom, 0);
        }

        l3d_pixel_box box_;
        std::size_t columns_; ///< the number of tiles in a row of the picture
        std::uint32_t last_, next_;
        std::int32_t top_;
        const tile* row_;
        std::uint64_t rows_; ///< the mask of the tile's pixels that are in the box's rows
        std::uint64_t bits_ = 0;
    };

    /// Whether a box has an open pixel. Expects: the box lies in the band, and is not empty.
    bool reached(const l3d_pixel_box& box) const { return open_tiles(*this, box).next(); }

    /// The tile with this column and row of tiles, counted from the picture's first.
    const tile& at(std::int32_t x, std::int32_t y) const {
        return tiles_[static_cast<std::size_t>(y - first_row_) * columns_ +
                      static_cast<std::size_t>(x)];
    }

    /// A box around the pixels that still take fragments: the rows that begin() took, or after
    /// reopen() a smaller box.
    const l3d_pixel_box& band() const { return band_; }
    std::vector<marked_pixel>& pixels() { return pixels_; }
    const std::vector<marked_pixel>& pixels() const { return pixels_; }

private:
    void gather_bits(const l3d_pixel_bits& marks, std::int32_t top);
    void list(tile& of, std::int32_t left, std::int32_t top, const drawn_depth& depth);

    l3d_pixel_box band_;
    std::size_t columns_ = 0; ///< the number of tiles in a row of the band
    std::int32_t first_row_ = 0;
    std::vector<tile> tiles_;
    std::vector<marked_pixel> pixels_;
};

} // namespace l3d_detail

#endif
