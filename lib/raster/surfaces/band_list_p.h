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

/// An item: some blocks of a part's grid, or some of its triangles, which are tested for being
/// hidden, and filled, together.
struct band_item {
    const l3d_surface_part* part = nullptr;
    l3d_pixel_box box{}; ///< the pixels of the window that the item may cover
    float nearest = 0;   ///< upper bound of inv_w in the item's pixels
    float order = 0;     ///< the key of sorting: items with larger numbers are drawn first
    grid_cells cells{};
    /// The range of the part's triangles that belong to the item.
    std::uint32_t triangle_begin = 0, triangle_end = 0;
    /// The index at which the item's pixel rows begin, in the list of all items' pixel rows.
    std::uint32_t rows_at = 0;
    /// The index at which the grey levels of its part's vertices begin, in the list of all grey
    /// levels.
    std::uint32_t levels_at = 0;
};

/// The items of a frame, sorted front to back, and the bands that they touch.
///
/// Items are sorted by their nearest vertices, rounded to one part in 2^8, then by their places in
/// the list of parts. If pixels show what is at their centres, a part's triangles take their grid's
/// place in this order. The reason is that these frames may leave out triangles that contain no
/// centre, so a place of the triangles' own would depend on which triangles are left out. So the
/// order depends neither on the bands nor on the number of workers.
/// Lives: borrows the parts. Keeps its memory from frame to frame.
class band_list {
public:
    /// The number of triangles in an item: as many as are set up together in lanes.
    static constexpr std::uint32_t triangles_in_item = l3d_micro_triangles::lanes;

    /// The settings of a frame: the drawn part of the picture, and the rule by which polygons touch
    /// pixels.
    struct frame {
        l3d_pixel_box window;
        int rows = 1; ///< number of rows in a band, at least 1
        /// Whether polygons touch a pixel if they reach its square. If false, they must contain its
        /// centre.
        bool squares = false;

        l3d_pixel_box pixels(const l3d_subpixel_box& box) const {
            return (squares ? squares_in(box) : pixels_in(box)).intersected(window);
        }
    };

    /// Makes the lists of a frame's bands. If `vertex_light` is not null, it makes the vertices'
    /// grey levels, too, for lanes that need them.
    void make(std::span<const l3d_surface_part* const> parts, const frame& of,
              const l3d_shading* vertex_light, l3d_workers& workers);

    /// The items that touch a band. Bands are counted from the window's top.
    std::span<const std::uint32_t> items(int band) const {
        const auto at = static_cast<std::size_t>(band);
        return {in_bands_.data() + band_begins_[at], band_begins_[at + 1] - band_begins_[at]};
    }

    const band_item& item(std::uint32_t index) const { return items_[index]; }

    /// The pixel rows of each row of quads in an item.
    const band_rows* rows(const band_item& item) const { return rows_.data() + item.rows_at; }

    /// The grid of an item. It has grey levels if make() got a `vertex_light`.
    fill_grid grid(const band_item& item, const fill_words& words) const {
        return {item.part->grid, levels_.data() + item.levels_at,
                words.of_material(item.part->material), item.part->names_quads};
    }

    /// The number of quads and triangles of all parts.
    std::int64_t polygons() const { return polygons_; }

private:
    struct place {
        /// Indices at which a part's items, pixel rows and grey levels begin in the lists.
        std::uint32_t items, rows, levels;
    };

    void lay_out(std::span<const l3d_surface_part* const> parts, bool with_levels);
    void list_part(const l3d_surface_part& part, place at, const frame& of,
                   const l3d_shading* vertex_light);
    void sort();
    void share_out(const frame& of);

    std::vector<place> places_;
    height_order by_height_; ///< the order of the parts from top to bottom
    std::vector<band_item> items_;
    std::vector<band_rows> rows_;
    std::vector<float> levels_; ///< grey levels of each part, laid out as its grid's arrays
    std::int64_t polygons_ = 0;

    struct sort_key {
        std::uint32_t distance, item;
    };
    std::vector<sort_key> order_, other_order_;
    std::vector<std::uint32_t> band_begins_, in_bands_;
};

} // namespace l3d_detail

#endif
