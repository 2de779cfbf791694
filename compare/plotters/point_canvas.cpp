// SPDX-License-Identifier: MIT
// l3d_point_canvas: shades a point.
#include "compare/plotters/point_canvas.h"

#include "raster/shaders/surface_shader_p.h"

#include <cassert>

void l3d_point_canvas::put(int x, int y, float inv_w, const std::array<float, 3>& normal) {
    constexpr std::int32_t half = l3d_subpixel_one / 2;
    const l3d_micro_vertex vertex{x * l3d_subpixel_one + half,
                                  y * l3d_subpixel_one + half,
                                  inv_w,
                                  {normal[0], normal[1], normal[2]}};
    float turned[4];
    l3d_detail::put_normal(vertex, shading_, turned);
    const auto column = static_cast<std::size_t>(x);
    depth_->row(y)[column] = inv_w;
    target_.row(y)[column] = word_of(turned);
    ++counts_.written;
}

std::uint32_t l3d_point_canvas::word_of(const float (&normal)[4]) const {
    assert(shading_.mode != l3d_shade::error);
    if (shading_.mode == l3d_shade::normals)
        return l3d_detail::normals_shader(shading_).word(normal);
    return l3d_product_of_colors(color_, l3d_detail::lambert_shader(shading_).word(normal));
}
