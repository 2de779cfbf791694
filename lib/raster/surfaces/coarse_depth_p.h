// SPDX-License-Identifier: MIT
// coarse_depth: bounds of a picture's depths, tile by tile.
#ifndef L3D_RASTER_SURFACES_COARSE_DEPTH_P_H
#define L3D_RASTER_SURFACES_COARSE_DEPTH_P_H

#include "raster/surfaces/fill_kernel_p.h"
#include "raster/surfaces/pixel_box_p.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace l3d_detail {

/// The size of the tiles into which a picture is divided. A tile is as wide as a cache line of
/// depths, and about as large as a micro-quad at a tolerance of 1/4 pixel.
struct depth_tile {
    static constexpr std::int32_t width = 16, height = 8;
};

/// For each tile of a picture, a bound of its depths, and whether anything was drawn into it.
/// Shape: rows of `columns` numbers, and rows of `words` with a bit for each tile.
struct tile_table {
    std::size_t columns = 0, words = 0;
    std::vector<float> farthest; ///< for each tile, a lower bound of inv_w in its pixels
    /// For each tile, whether anything was drawn into it; if not, its depths are undefined.
    std::vector<std::uint64_t> drawn;
    /// For each tile, whether anything was drawn into it since `farthest` was found.
    std::vector<std::uint64_t> newer;
};

/// Keeps a bound of the depths in each tile of a picture. The bounds tell which shapes are hidden,
/// and which tiles have undefined depths. A tile's depths are set to 0 only when something is drawn
/// into it, as drawing needs these depths in the nearest cache anyway.
///
/// Depths only become nearer in a frame, so the farthest depth that was found for a tile stays a
/// bound.
/// Expects: boxes are not empty, and inside the window, and inside the band if there is one. Bands
///          consist of whole rows of tiles. Threads may change different bands at the same time.
class coarse_depth {
public:
    void resize(l3d_size size);

    /// Writes the background of a picture of this height into those tiles of the band into which
    /// something was drawn.
    void clear_words(const fill_band& band, const l3d_background& background,
                     std::int32_t height) const;

    /// Marks all tiles in rows [top, bottom) as not drawn into, whatever the depths in these rows
    /// are.
    void forget(std::int32_t top, std::int32_t bottom);

    /// Prepares a box for drawing: sets the depths to 0 in those of its tiles into which nothing
    /// was drawn yet.
    void open(const l3d_pixel_box& box, const fill_band& band);

    /// Prepares all depths of a band for reading: sets the depths of tiles into which nothing was
    /// drawn to 0.
    void open_others(const fill_band& band);

    /// Whether known depths hide every shape in the box that is no nearer than `nearest`, a 1 / w.
    /// Where the bounds of tiles do not decide, the depths in the tiles are read.
    /// Cost:    for a tile whose depths are read, one to eight cache lines.
    bool hidden(const l3d_pixel_box& box, float nearest, const fill_band& band);

    /// Whether the bounds of tiles alone prove that every shape in the box is hidden that is no
    /// nearer than `nearest`, a 1 / w. No depth is read.
    bool hidden(const l3d_pixel_box& box, float nearest) const;

    /// Finds the farthest depth of each tile of the band into which something was drawn.
    void refresh(const fill_band& band);

    /// Whether something may have been drawn into the pixel's tile. If not, the pixel's depth is
    /// undefined.
    bool drawn_at(std::int32_t x, std::int32_t y) const {
        const auto column = static_cast<std::size_t>(x / depth_tile::width);
        const auto row = static_cast<std::size_t>(y / depth_tile::height);
        return (table_.drawn[row * table_.words + column / 64] >> (column % 64) & 1) != 0;
    }

    /// A box of rows [top, bottom), with the columns of tiles into which something may have been
    /// drawn.
    l3d_pixel_box drawn_in(std::int32_t top, std::int32_t bottom) const;

    /// Calls visit(box) for runs of tiles of the band into which something may have been drawn.
    template <class Visit> void visit_drawn(const fill_band& band, const Visit& visit) const {
        constexpr std::int32_t width = depth_tile::width, height = depth_tile::height;
        for (std::int32_t y = band.top; y < band.bottom; y += height)
            for (std::int32_t x = 0, end = 0; x < band.width; x = end) {
                const bool drawn = drawn_at(x, y);
                for (end = x + width; end < band.width && drawn_at(end, y) == drawn;)
                    end += width;
                if (drawn)
                    visit({x, y, std::min(end, band.width), std::min(y + height, band.bottom)});
            }
    }

    /// The number of pixels in the band whose depth is not 0.
    std::int64_t covered(const fill_band& band) const;

private:
    tile_table table_;
};

} // namespace l3d_detail

#endif
