// SPDX-License-Identifier: MIT
// band_fragments: which polygons reach the marked pixels of a band.
#ifndef L3D_RASTER_REFINE_BAND_FRAGMENTS_P_H
#define L3D_RASTER_REFINE_BAND_FRAGMENTS_P_H

#include "raster/refine/pixel_bits_p.h"
#include "raster/surface_part.h"
#include "raster/refine/drawn_depth_p.h"
#include "raster/surfaces/band_list_p.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// A convex polygon that reaches a marked pixel. A triangle's last corner is there twice.
struct fragment_polygon {
    std::int32_t x[4], y[4]; ///< units: 1/256 pixel
    float inv_w[4];
    float light[3][4]; ///< the corners' three numbers of l3d_micro_vertex::normal
    std::int32_t corners;
    /// Of its material, or in mode `error` the part's own; of what is lit or inspected, the
    /// material's place.
    std::uint32_t color;
    float farthest, nearest; ///< of the corners' inv_w
    bool counts_once; ///< of those with the same corners, one is seen: not a triangle of a slit

    std::int64_t area2() const; ///< twice its area, positive if its corners turn to the right
    l3d_micro_vertex corner(std::size_t i) const {
        return {x[i], y[i], inv_w[i], {light[0][i], light[1][i], light[2][i]}};
    }
};

/// The marked pixels of a band, row by row, and pairs of these with the polygons that reach their
/// squares.
///
/// Lives: of one worker, kept for its memory.
class band_fragments {
public:
    /// Starts rows [top, bottom) of a picture. Expects: bits outlive the band.
    void begin(const pixel_bits& bits, const drawn_depth& depth, std::int32_t width,
               std::int32_t top, std::int32_t bottom);

    /// The colours of the frame's materials, if it has any and they are levels'; whether shaders
    /// want to know the place of the material itself.
    /// Lives: until the next call.
    void use_colors(std::span<const std::uint32_t> colors, bool by_material) {
        colors_ = colors;
        by_material_ = by_material;
    }

    /// Adds those of an item's quads and triangles that reach a marked pixel and are no farther
    /// than all that was drawn there and around. Folded quads come in pieces; `levels`: those of
    /// mode l3d_shade::levels.
    void add(const band_list& list, const band_item& item, bool levels);

    /// Sorts the pairs by pixel; those of one pixel stay in their order.
    void sort();

    struct pixel {
        std::int32_t x, y;
    };
    std::span<const pixel> pixels() const { return pixels_; }

    /// Whether something was drawn in pixel i and in all around it. Then what is left empty by the
    /// polygons is no background: they are not all here.
    bool closed(std::size_t i) const { return farthest_[i] > 0; }

    /// A pixel and a polygon that may reach into it, by their indices.
    struct pair {
        std::uint32_t pixel, polygon;
    };

    /// All pairs, pixel by pixel; those of one pixel in the order of the polygons. Those of pixel i
    /// go from begin_of(i) to begin_of(i + 1).
    /// Expects: sort came before.
    std::span<const pair> pairs() const { return sorted_; }
    std::size_t begin_of(std::size_t i) const { return begins_[i]; }
    std::span<const fragment_polygon> polygons() const { return polygons_; }

private:
    void add_row(const l3d_surface_part& part, const grid_cells& cells, int row, bool levels);
    void add_triangles(const l3d_surface_part& part, std::size_t first, std::size_t last);
    void add_quad(const l3d_surface_part& part, std::size_t p00, const l3d_pixel_box& box,
                  bool levels);
    void add_convex(std::span<const l3d_micro_vertex> corners, std::uint32_t color,
                    const l3d_pixel_box& box, bool counts_once);
    bool add_pairs(std::span<const l3d_micro_vertex> corners, l3d_pixel_box box, float nearest);
    std::uint32_t color_of(const l3d_surface_part& part, std::uint32_t material) const {
        return by_material_ ? material : colors_.empty() ? part.error_color : colors_[material];
    }
    l3d_pixel_box reached(std::span<const l3d_micro_vertex> corners) const;
    std::uint32_t first_in(std::int32_t word, std::int32_t y) const;
    bool has_column(std::int32_t left, std::int32_t right) const;

    std::span<const std::uint32_t> colors_;
    bool by_material_ = false;
    const pixel_bits* bits_ = nullptr;
    l3d_pixel_box band_;
    l3d_pixel_box marked_; ///< holds all marked pixels that the item reaches
    std::vector<pixel> pixels_;
    std::vector<float> farthest_;        ///< what was drawn in each of these and around it
    std::vector<std::uint64_t> columns_; ///< marked in any row that some quads may reach
    std::vector<std::uint32_t> before_;  ///< marked pixels before each word of bits of the band
    std::vector<fragment_polygon> polygons_;
    std::vector<pair> pairs_, sorted_;
    std::vector<std::uint32_t> begins_;
};

} // namespace l3d_detail

#endif
