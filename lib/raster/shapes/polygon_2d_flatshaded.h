// SPDX-License-Identifier: MIT
// l3d_polygon_2d_flatshaded: a polygon of one colour.
#ifndef L3D_RASTER_SHAPES_POLYGON_2D_FLATSHADED_H
#define L3D_RASTER_SHAPES_POLYGON_2D_FLATSHADED_H

#include "base/color.h"
#include "base/public.h"
#include "geom/polygon_2d.h"
#include "raster/rasterizer_2d.h"

#include <cstdint>
#include <utility>
#include <vector>

/// A convex polygon of one colour, drawn by l3d_rasterizer_2d.
///
/// Lives:   a value; copies are deep, and of the same type.
class L3D_PUBLIC l3d_polygon_2d_flatshaded : public l3d_polygon_2d {
public:
    /// Makes a polygon of one colour, a pixel word. Its corners are indices in the list of vertices
    /// that draw() gets.
    l3d_polygon_2d_flatshaded(std::vector<std::uint32_t> ivertices, l3d_color color)
        : l3d_polygon_2d(std::move(ivertices)), final_color(color) {}

    /// Fills the part of the polygon that clipping has left.
    template <class Vertex>
    void draw(const l3d_two_part_list<Vertex>& vertices, l3d_rasterizer_2d& rasterizer) {
        corners_.clear();
        for (const std::uint32_t i : clip_ivertices()) {
            const auto place = l3d_in_picture(vertices[i]);
            corners_.push_back({l3d_to_double(place[0]), l3d_to_double(place[1])});
        }
        rasterizer.draw_polygon_flatshaded(corners_, final_color);
    }

    l3d_color final_color; ///< the polygon's colour, a pixel word

private:
    /// Memory for draw(), kept between calls so that no frame allocates.
    std::vector<l3d_point_2d> corners_;
};

#endif
