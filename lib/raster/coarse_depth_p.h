// SPDX-License-Identifier: MIT
// coarse_depth: the farthest depth of every tile of the picture, to leave out what is behind it.
#ifndef L3D_RASTER_COARSE_DEPTH_P_H
#define L3D_RASTER_COARSE_DEPTH_P_H

#include "raster/fill_kernel_p.h"
#include "raster/pixel_box_p.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace l3d_detail {

/// Lower bounds of inv_w, tile by tile.
///
/// Depth only ever comes nearer in a frame, so what was found for a tile stays a bound; it is found
/// anew when that could change an answer and the tile was drawn to in the meantime.
/// Expects: boxes inside the window; threads that change different rows of tiles do not meet.
/// Cost:    a tile is found in some tens of cycles, from 8 cache lines.
class coarse_depth {
public:
    /// A cache line of depths wide; about as large as a micro-quad at a tolerance of 1/4 pixel.
    static constexpr std::int32_t tile_width = 16, tile_height = 8;

    void resize(l3d_size size);

    /// Nothing is in rows [top, bottom). Expects: whole rows of tiles, but for the last.
    void clear(std::int32_t top, std::int32_t bottom);

    /// Something may have been drawn in the box.
    void touch(const pixel_box& box);

    /// Whether nothing in the box that is no nearer than `nearest` would be seen.
    /// Expects: the box inside the band.
    bool hidden(const pixel_box& box, float nearest, const fill_band& band);

    /// The same from what is known already.
    bool hidden(const pixel_box& box, float nearest) const;

    /// Finds all tiles of the band that were drawn to. Expects: the band is whole rows of tiles.
    void refresh(const fill_band& band);

    /// Pixels of the band in which something is. Expects: as refresh.
    std::int64_t covered(const fill_band& band) const;

private:
    struct tile {
        float farthest;
        bool touched; ///< since the frame began
        bool stale;   ///< touched since it was found
    };

    tile& at(std::int32_t column, std::int32_t row) {
        return tiles_[static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column)];
    }
    const tile& at(std::int32_t column, std::int32_t row) const {
        return tiles_[static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column)];
    }
    void find(tile& t, std::int32_t column, std::int32_t row, const fill_band& band);

    std::size_t columns_ = 0;
    std::vector<tile> tiles_;
};

} // namespace l3d_detail

#endif
