// SPDX-License-Identifier: MIT
// l3d_two_layer_depths: in each pixel the two nearest sheets of surfaces, and how close they are.
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

/// A patch that stands in the picture, and those of its model that it touches.
///
/// Lives: borrows the list.
struct l3d_sheet_patch {
    std::uint32_t instance = 0, patch = 0;
    std::span<const std::uint32_t> touching; ///< patches that share a corner; in order

    bool is(const l3d_sheet_patch& other) const {
        return instance == other.instance && patch == other.patch;
    }

    /// Whether the two are neighbours, or one patch.
    bool meets(const l3d_sheet_patch& other) const;
};

/// Draws the polygons of all parts once more, one by one, for what the picture does not keep.
///
/// A polygon covers the pixels that the picture's own rule gives it, so a sheet that is not folded
/// is met once in each pixel. Along the rims of patches, slits and rims may overlap by less than
/// the bound. There, those of one patch and of its neighbours are one sheet, if their slopes are
/// alike.
/// Cost:    36 bytes and some 20 ns a pixel and sheet.
class l3d_two_layer_depths {
public:
    /// Nothing is anywhere. In a parallel projection, depths are linear in the distance, and change
    /// by depth_by_pixel where that changes by a pixel's width; in perspective it is 0.
    /// Units: focal in pixels.
    void begin(l3d_size size, double focal, double depth_by_pixel = 0);

    void add(const l3d_surface_part& part, const l3d_sheet_patch& of);

    /// 1 / w of the nearest sheet, 0 where none is. Units: as l3d_micro_vertex.
    float inv_w(int x, int y) const { return at(x, y).front.inv_w; }

    /// If places in the picture, and distances along normals, are off by `bound` on each sheet, the
    /// nearest sheet need not be the right one where this is at most `bound`. Units: pixels.
    float gap(int x, int y) const { return at(x, y).gap; }

private:
    /// Where in its part a polygon lies; what slits are closed by, are triangles.
    static constexpr std::uint32_t inner = 0, rim = 1, slit = 2, kinds = 3;

    /// A sheet at a pixel's centre.
    struct fragment {
        float inv_w = 0, along_x = 0, along_y = 0; ///< and its change to the next pixels
        std::uint32_t owner = 0; ///< kinds times its index in patches_, and its kind
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
