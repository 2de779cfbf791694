// SPDX-License-Identifier: MIT
// marked_pixels: the pixels of a band that are sampled, in tiles.
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

/// A marked pixel: one that is sampled for anti-aliasing.
struct marked_pixel {
    std::int32_t x, y;
    std::uint32_t last; ///< the fragment that was added last
    bool is_closed;     ///< whether something was drawn in the pixel and in all pixels around it
    /// The farthest depth that can be seen. It is the farthest depth drawn in the pixel and around
    /// it, or that of polygons that cover all samples.
    float farthest;
    float least;           ///< the least inv_w of the polygons that were added
    std::uint64_t covered; ///< the samples that these polygons cover
};

/// The marked pixels of a band.
///
/// Shape: rows of tiles of 8 x 8 pixels. A tile has a bit for each pixel: bit 8 row + column.
///        Pixels are listed tile by tile, and in each tile in the order of bits.
/// Lives: one for each worker, kept for its memory.
class marked_pixels {
public:
    static constexpr std::int32_t side = 8;
    struct tile {
        std::uint64_t bits = 0;
        std::uint64_t open = 0;  ///< the marked pixels that still take fragments
        std::uint32_t first = 0; ///< the index of its first marked pixel
    };

    /// Starts a band, or so many rows of its tiles that at least `most` pixels are marked.
    /// Expects: the band begins at a tile.
    void begin(const l3d_pixel_bits& marks, const drawn_depth& depth, const l3d_pixel_box& band,
               std::size_t most);

    /// Empties the closed pixels that the added polygons do not cover wholly. It opens them for all
    /// polygons, also those behind what was drawn there. All other pixels take no more fragments.
    /// Returns whether any pixel is open.
    bool reopen();

    /// Calls visit(tile, left, top, bits of its open pixels in the box) for each tile that has such
    /// pixels. It ends when visit returns true, and returns whether that happened.
    /// Expects: the box lies in the band, and is not empty.
    template <class Visit> bool visit(const l3d_pixel_box& box, const Visit& visit) const {
        constexpr std::uint64_t all = ~std::uint64_t{0}, a_row = (1u << side) - 1,
                                a_column = 0x0101010101010101;
        const auto first = static_cast<std::uint32_t>(box.left),
                   end = static_cast<std::uint32_t>(box.right);
        const std::uint32_t last_column = (end - 1) / side,
                            last_row = static_cast<std::uint32_t>(box.bottom - 1) / side;
        for (auto y = static_cast<std::uint32_t>(box.top) / side; y <= last_row; ++y) {
            const auto top = static_cast<std::int32_t>(y * side);
            const std::uint64_t rows = all << side * std::max(box.top - top, 0) &
                                       all >> side * std::max(top + side - box.bottom, 0);
            const tile* row = &at(0, static_cast<std::int32_t>(y));
            for (std::uint32_t x = first / side; x <= last_column; ++x) {
                std::uint64_t bits = row[x].open & rows;
                if (bits == 0)
                    continue;
                const auto left = static_cast<std::int32_t>(x * side);
                bits &= (a_row << std::max(box.left - left, 0) &
                         a_row >> std::max(left + side - box.right, 0)) *
                        a_column;
                if (bits != 0 && visit(row[x], left, top, bits))
                    return true;
            }
        }
        return false;
    }

    /// Whether a box has an open pixel. Expects: as visit.
    bool reached(const l3d_pixel_box& box) const {
        return visit(box,
                     [](const tile&, std::int32_t, std::int32_t, std::uint64_t) { return true; });
    }

    /// The tile with this column and row of tiles, counted from the picture's first.
    const tile& at(std::int32_t x, std::int32_t y) const {
        return tiles_[static_cast<std::size_t>(y - first_row_) * columns_ +
                      static_cast<std::size_t>(x)];
    }

    /// The box of the pixels that still take fragments.
    const l3d_pixel_box& band() const { return band_; }
    std::vector<marked_pixel>& pixels() { return pixels_; }
    const std::vector<marked_pixel>& pixels() const { return pixels_; }

private:
    void gather_bits(const l3d_pixel_bits& marks, std::int32_t top);
    void list(tile& of, std::int32_t left, std::int32_t top, const drawn_depth& depth);

    l3d_pixel_box band_;
    std::size_t columns_ = 0; ///< the number of tiles in a row
    std::int32_t first_row_ = 0;
    std::vector<tile> tiles_;
    std::vector<marked_pixel> pixels_;
};

} // namespace l3d_detail

#endif
