// SPDX-License-Identifier: MIT
// band_list: the items to draw in each band of a picture, front to back.
#ifndef L3D_RASTER_SURFACES_BAND_LIST_P_H
#define L3D_RASTER_SURFACES_BAND_LIST_P_H

#include "raster/surfaces/band_cells_p.h"
#include "raster/surfaces/fill_kernel_p.h"
#include "raster/parallel/height_order_p.h"
#include "raster/surfaces/pixel_box_p.h"
#include "raster/surface_part.h"
#include "raster/parallel/workers.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Some blocks of a part's grid, or some of its triangles. They are tested for being hidden, and
/// filled, as a whole.
struct band_item {
    const l3d_surface_part* part = nullptr;
    l3d_pixel_box box{}; ///< the pixels it may cover, of those in the window
    float nearest = 0;   ///< no pixel of it has a larger inv_w
    grid_cells cells{};
    std::uint32_t triangle_begin = 0, triangle_end = 0; ///< range of the part's triangles
    std::uint32_t rows_at = 0;   ///< beginning of its cells' rows in the list
    std::uint32_t levels_at = 0; ///< beginning of its vertices' grey levels in the list
};

/// Items, sorted front to back, and the bands that they touch.
///
/// The order is by the nearest vertex, to a part in 2^8, then by the place in the list of parts.
/// It does not depend on the bands nor on the number of workers.
/// Lives: borrows the parts. Keeps its memory from frame to frame.
class band_list {
public:
    /// Triangles in an item: as many as are set up side by side in lanes.
    static constexpr std::uint32_t triangles_in_item = l3d_micro_triangles::lanes;

    /// The drawn part of the picture, and the rule for the pixels of a polygon.
    struct frame {
        l3d_pixel_box window;
        int rows = 1;         ///< rows of a band; >= 1
        bool squares = false; ///< pixels whose squares it reaches, not only those of its centres

        l3d_pixel_box pixels(const l3d_subpixel_box& box) const {
            return (squares ? squares_in(box) : pixels_in(box)).intersected(window);
        }
    };

    /// Makes the lists of a frame's bands, and the vertices' grey levels if the shading is for
    /// lanes that want them, else null.
    void make(std::span<const l3d_surface_part* const> parts, const frame& of,
              const l3d_shading* vertex_light, l3d_workers& workers);

    /// The items of a band; bands count from the window's top.
    std::span<const std::uint32_t> items(int band) const {
        const auto at = static_cast<std::size_t>(band);
        return {in_bands_.data() + band_begins_[at], band_begins_[at + 1] - band_begins_[at]};
    }

    const band_item& item(std::uint32_t index) const { return items_[index]; }

    /// The pixel rows of each of an item's rows of quads.
    const band_rows* rows(const band_item& item) const { return rows_.data() + item.rows_at; }

    /// An item's grid. Its levels are there if `make` was given a light.
    fill_grid grid(const band_item& item, const fill_words& words) const {
        return {item.part->grid, levels_.data() + item.levels_at,
                words.of_material(item.part->material), item.part->names_quads};
    }

    /// Quads and triangles of all parts.
    std::int64_t polygons() const { return polygons_; }

private:
    struct place {
        std::uint32_t items, rows, levels; ///< beginnings of a part's items, rows and levels
    };

    void lay_out(std::span<const l3d_surface_part* const> parts, bool with_levels);
    void list_part(const l3d_surface_part& part, place at, const frame& of,
                   const l3d_shading* vertex_light);
    void sort();
    void share_out(const frame& of);

    std::vector<place> places_;
    height_order by_height_; ///< the parts
    std::vector<band_item> items_;
    std::vector<band_rows> rows_;
    std::vector<float> levels_; ///< each part's like its grid's arrays
    std::int64_t polygons_ = 0;

    struct sort_key {
        std::uint32_t distance, item;
    };
    std::vector<sort_key> order_, other_order_;
    std::vector<std::uint32_t> band_begins_, in_bands_;
};

} // namespace l3d_detail

#endif
