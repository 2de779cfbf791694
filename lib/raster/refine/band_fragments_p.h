// SPDX-License-Identifier: MIT
// band_fragments: gathers the parts of polygons that are seen in the marked pixels of a band.
#ifndef L3D_RASTER_REFINE_BAND_FRAGMENTS_P_H
#define L3D_RASTER_REFINE_BAND_FRAGMENTS_P_H

#include "raster/refine/drawn_depth_p.h"
#include "raster/refine/marked_pixels_p.h"
#include "raster/refine/pixel_samples_p.h"
#include "raster/surface_part.h"
#include "raster/surfaces/band_list_p.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Gathers the fragments of polygons that are seen in the marked pixels of a band. A fragment is
/// the part of a polygon in one pixel.
///
/// Lives: make one object for each worker, and keep it from frame to frame, since it keeps its
///        memory.
/// Cost:  memory for the marked pixels, for the fragments that are seen, and for as many more.
///        Hidden fragments are removed whenever their number has doubled.
class band_fragments {
public:
    /// Starts a band of a picture. It takes rows of tiles (marked_pixels) from the band's top on,
    /// until the number of marked pixels reaches `most`.
    /// Returns: the end of the rows taken.
    /// Expects: the band begins at a tile of marked_pixels.
    std::int32_t begin(const l3d_pixel_bits& marks, const drawn_depth& depth,
                       const l3d_pixel_box& band, std::size_t most);

    /// Sets the colours of the frame's materials. The list is empty unless the frame has materials
    /// and pixel words are levels. `by_material` tells whether shaders take a material's index
    /// instead of its colour.
    /// Lives: until the next call.
    void use_colors(std::span<const std::uint32_t> colors, bool by_material) {
        colors_ = colors;
        by_material_ = by_material;
    }

    /// Adds those quads and triangles of an item that reach a marked pixel and may be seen there. A
    /// polygon may be seen if it is no farther than everything drawn in the pixel and around it.
    /// Folded quads are added in pieces. `levels` tells whether the mode is l3d_shade::levels.
    void add(const band_list& list, const band_item& item, bool levels);

    /// Opens closed pixels again that have samples which no polygon covers, and removes the
    /// fragments of these pixels. Returns whether any pixel is open again. If so, the caller has to
    /// add all items once more; only the pixels opened again take fragments of these. Samples stay
    /// uncovered at slits, and farther surfaces may be seen there.
    bool reopen() { return pixels_.reopen(); }

    std::span<const marked_pixel> pixels() const { return pixels_.pixels(); }

    /// Whether something was drawn in pixel i and in all pixels around it. If so, samples without a
    /// polygon do not show the background: some polygons have not been added.
    bool closed(std::size_t i) const { return pixels()[i].is_closed; }

    /// Calls visit(i, fragments) for each pixel i, with those fragments of the pixel that are seen.
    template <class Visit> void visit_seen(const Visit& visit) const {
        seen_in_pixels seen;
        const auto all = std::span(fragments_).first(count_);
        for (std::size_t first = 0; first < pixels().size(); first += seen_in_pixels::most) {
            const std::size_t few = std::min(seen_in_pixels::most, pixels().size() - first);
            see_samples(polygons_, all, pixels().subspan(first, few), seen);
            for (std::size_t i = 0; i < few; ++i)
                visit(first + i,
                      std::span<const seen_fragment>(seen.fragments.begin() + seen.begins[i],
                                                     seen.fragments.begin() + seen.begins[i + 1]));
        }
    }
    const fragment_polygon& polygon(const seen_fragment& of) const { return polygons_[of.polygon]; }

    /// All polygons that were added.
    std::span<const fragment_polygon> polygons() const {
        return std::span(polygons_).first(polygon_count_);
    }

    /// The number of fragments for which there is memory.
    std::size_t kept_fragments() const { return fragments_.size(); }

private:
    void add_row(const l3d_surface_part& part, const grid_cells& cells, int row, bool levels);
    void add_triangles(const l3d_surface_part& part, std::size_t first, std::size_t last);
    void add_quad(const l3d_surface_part& part, std::size_t p00, const l3d_pixel_box& box,
                  bool levels);
    void add_triangle(const std::array<l3d_micro_vertex, 3>& corners, std::uint32_t color);
    void add_polygon(const quad_corners& corners, std::int32_t count, std::int64_t area2,
                     const l3d_pixel_box& box, std::uint32_t color);
    void leave_out_hidden();
    std::uint32_t color_of(const l3d_surface_part& part, std::uint32_t material) const {
        return by_material_ ? material : colors_.empty() ? part.error_color : colors_[material];
    }

    std::span<const std::uint32_t> colors_;
    bool by_material_ = false;
    l3d_pixel_box inside_; ///< the box of the present item, within the band
    marked_pixels pixels_;
    quad_boxes boxes_;
    std::vector<fragment_polygon> polygons_; ///< polygons that were added, and room for more
    std::size_t polygon_count_ = 0;          ///< number of polygons that were added
    std::vector<fragment> fragments_;        ///< fragments of all pixels, and room for more
    /// Memory for the fragments that are left when hidden ones are removed.
    std::vector<fragment> kept_;
    std::size_t count_ = 0;          ///< number of fragments in use
    std::size_t most_fragments_ = 0; ///< number of fragments at which hidden ones are removed
    /// For each polygon, its new index after hidden fragments are removed.
    std::vector<std::uint32_t> names_;
};

} // namespace l3d_detail

#endif
