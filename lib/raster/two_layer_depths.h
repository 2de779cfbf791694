// SPDX-License-Identifier: MIT
// l3d_two_layer_depths: finds the two nearest sheets of surfaces in each pixel, and their gap.
#ifndef L3D_RASTER_TWO_LAYER_DEPTHS_H
#define L3D_RASTER_TWO_LAYER_DEPTHS_H

#include "raster/shapes/scan_polygon_p.h"
#include "raster/surface_part.h"
#include "tool_2d/pixels.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

/// The patch to which a part's polygons belong, and the patches of the same model that this patch
/// touches.
///
/// Lives: borrows the list `touching`.
struct l3d_sheet_patch {
    std::uint32_t instance = 0, patch = 0;
    /// Indices of the patches that share a corner with this patch, in rising order.
    std::span<const std::uint32_t> touching;

    bool is(const l3d_sheet_patch& other) const {
        return instance == other.instance && patch == other.patch;
    }

    /// Whether this patch and the other one are neighbours, or are the same patch.
    bool meets(const l3d_sheet_patch& other) const;
};

/// Draws the polygons of all parts once more, one by one, to find the two nearest sheets of surface
/// in each pixel.
///
/// A polygon covers pixels by the picture's own rule, so a sheet that is not folded is met once in
/// each pixel. At the borders of patches, slits and rims may overlap by less than the bound of
/// places. At these borders, the polygons of a patch and of its neighbours count as one sheet if
/// their slopes are alike.
/// Cost:    36 bytes for each pixel, and some 20 ns for each pixel and sheet.
class l3d_two_layer_depths {
public:
    /// Starts an empty picture. In a parallel projection, depths are linear in the distance. Depths
    /// change by depth_by_pixel if the distance changes by a pixel's width; in perspective,
    /// depth_by_pixel is 0.
    /// Units: focal in pixels.
    void begin(l3d_size size, double focal, double depth_by_pixel = 0);

    void add(const l3d_surface_part& part, const l3d_sheet_patch& of);

    /// 1 / w of the nearest sheet, and 0 where there is no sheet. Units: as l3d_micro_vertex.
    float inv_w(int x, int y) const { return at(x, y).front.inv_w; }

    /// The least error of surfaces, in the picture or along their normals, with which another sheet
    /// could be the nearest sheet at this pixel.
    /// Units: pixels; infinite if there is only one sheet.
    float gap(int x, int y) const { return at(x, y).gap; }

private:
    /// The kinds of polygons, by their place in a part. `inner` are quads inside of a grid. `rim`
    /// are quads at a grid's rim, and triangles of a part without a grid. `slit` are triangles that
    /// close slits.
    static constexpr std::uint32_t inner = 0, rim = 1, slit = 2, kinds = 3;

    /// A sheet of surface at the centre of a pixel.
    struct fragment {
        /// The sheet's inv_w in this pixel, and its change to the next pixel to the right and
        /// below.
        float inv_w = 0, along_x = 0, along_y = 0;
        /// The polygon's patch and kind, as one number: `kinds` times the patch's index in
        /// patches_, plus the kind.
        std::uint32_t owner = 0;
    };
    struct pixel {
        fragment front, second;
        float gap = std::numeric_limits<float>::infinity();
    };
    const pixel& at(int x, int y) const { return pixels_[place(x, y)]; }
    std::size_t place(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
               static_cast<std::size_t>(x);
    }
    void add_quad(const l3d_micro_vertex& a, const l3d_micro_vertex& b, const l3d_micro_vertex& c,
                  const l3d_micro_vertex& d, std::uint32_t owner);
    void add_triangle(const l3d_micro_vertex& a, const l3d_micro_vertex& b,
                      const l3d_micro_vertex& c, std::uint32_t owner);
    void put(pixel& into, const fragment& f, int x, int y) const;
    bool overlap(const fragment& a, const fragment& b) const;
    float gap_between(const fragment& front, const fragment& other, int x, int y) const;

    l3d_size size_;
    double focal_ = 1, depth_by_pixel_ = 0;
    std::vector<pixel> pixels_;
    std::vector<l3d_sheet_patch> patches_;
    l3d_detail::scan_polygon scan_;
};

#endif
