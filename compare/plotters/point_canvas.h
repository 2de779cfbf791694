// SPDX-License-Identifier: MIT
// l3d_point_canvas: a picture with depth, into which surface points are put one by one.
#ifndef L3D_COMPARE_PLOTTERS_POINT_CANVAS_H
#define L3D_COMPARE_PLOTTERS_POINT_CANVAS_H

#include "raster/depth_buffer.h"
#include "raster/surface_rasterizer.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstddef>
#include <cstdint>

/// A canvas for methods that make pixels instead of polygons. It knows no vertices and no polygons,
/// so `gouraud` and `flat` look like `lambert`.
///
/// Lives: borrows picture and depth from begin on.
class l3d_point_canvas {
public:
    /// Starts to draw on top of the picture.
    /// Expects: target and depth of one size; not mode `error`, since points have no bound.
    void begin(l3d_pixels target, l3d_depth_buffer& depth, const l3d_shading& shading) {
        target_ = target;
        depth_ = &depth;
        shading_ = shading;
        color_ = l3d_material().color;
        counts_ = {};
    }

    /// Sets the material colour of the next points; at first white.
    void set_color(std::uint32_t color) { color_ = color; }

    l3d_size size() const { return target_.size(); }

    /// Whether a point at `inv_w` would be seen in the pixel. It counts the point as tested.
    /// Expects: (x, y) in the picture.
    bool is_nearest(int x, int y, float inv_w) {
        ++counts_.samples;
        return inv_w > depth_->row(y)[static_cast<std::size_t>(x)];
    }

    /// Sets the pixel to a surface point. Units: inv_w and normal as in l3d_micro_vertex.
    /// Expects: is_nearest(x, y, inv_w).
    void put(int x, int y, float inv_w, const std::array<float, 3>& normal);

    /// The counts since begin.
    const l3d_surface_counts& counts() const { return counts_; }

private:
    std::uint32_t word_of(const float (&normal)[4]) const;

    l3d_pixels target_;
    l3d_depth_buffer* depth_ = nullptr;
    l3d_shading shading_;
    std::uint32_t color_ = 0;
    l3d_surface_counts counts_;
};

#endif
