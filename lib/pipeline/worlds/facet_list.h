// SPDX-License-Identifier: MIT
// l3d_facet_list: a frame's polygons, from objects in a world to pixels, farthest first.
#ifndef L3D_PIPELINE_WORLDS_FACET_LIST_H
#define L3D_PIPELINE_WORLDS_FACET_LIST_H

#include "base/public.h"
#include "geom/radix_sort.h"
#include "raster/rasterizer_2d.h"
#include "pipeline/worlds/camera_left_handed.h"
#include "pipeline/worlds/object.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// The order in which polygons are drawn.
enum class L3D_PUBLIC l3d_draw_order {
    as_added,  ///< later ones cover earlier ones
    far_first, ///< the painter's: by the mean distance of the corners, equal ones as added
    by_depth,  ///< each pixel shows the polygon that is nearest there
};

/// Transforms, clips and projects polygons, and holds the result for one frame.
///
/// Each vertex of an object is transformed once, however many polygons share it. Polygons are cut
/// at near_z, and far outside the picture; what is wholly beyond far_z is left out. New vertices
/// follow the object's own in one list.
/// Cost:    time linear in vertices and polygons, sorting included; memory for the most polygons of
///          any frame so far, and no limit to their number but 2^32.
/// Source:  the order of steps is that of l3d_world::draw_all in the book.
class L3D_PUBLIC l3d_facet_list {
public:
    /// The numbers that pictures are computed in.
    using real = l3d_real;

    /// Forgets the last frame. Expects: 0 < near_z <= far_z, fovx and fovy > 0.
    void begin(const l3d_camera_left_handed<real>& camera, l3d_size size);

    /// Adds the polygons of an object that may be seen. Returns the number of vertices transformed.
    std::size_t add(const l3d_object& object);

    /// Polygons added and neither behind the eye nor outside the picture.
    std::size_t polygons() const { return polygons_.size(); }

    /// Draws the polygons added since begin(), each in its own colour; `by_depth` is far_first.
    void draw(l3d_rasterizer_2d& rasterizer, l3d_draw_order order);

    /// The corners of a polygon, in the order of addition. Units: pixels.
    std::span<const l3d_point_2d> corners(std::size_t which) const;

private:
    struct polygon {
        std::size_t first_corner, corners;
        std::uint32_t color;
        real depth;
    };

    bool clip(std::span<const std::uint32_t> face);
    bool clip_sideways(int axis, real scale);
    void project(std::uint32_t color);

    l3d_camera_left_handed<real> camera_{l3d_size{1, 1}};
    l3d_size size_{1, 1};
    l3d_matrix<real> viewing_ = l3d_identity<real>();
    std::vector<l3d_point<real>> points_; ///< points of one object, in the camera's coordinates
    std::vector<std::uint32_t> clipped_, before_; ///< corners of one polygon
    std::vector<l3d_point_2d> corners_;           ///< corners of all polygons
    std::vector<polygon> polygons_;
    std::vector<l3d_sort_item> order_, sorting_;
};

#endif
