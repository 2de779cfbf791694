// SPDX-License-Identifier: MIT
// l3d_rasterizer_factory_sw: what it makes, which users of the factory need not see.
#include "raster/rasterizer_factory.h"

#include "raster/shapes/rasterizer_2d_smooth_p.h"
#include "raster/surfaces/surface_rasterizer_sw.h"

std::unique_ptr<l3d_rasterizer_2d_imp>
l3d_rasterizer_factory_sw::do_create_2d(l3d_pixels target) const {
    if (edges_ == l3d_edges::smooth)
        return std::make_unique<l3d_detail::rasterizer_2d_smooth>(target);
    return std::make_unique<l3d_rasterizer_2d_sw_imp>(target);
}

std::unique_ptr<l3d_surface_rasterizer>
l3d_rasterizer_factory_sw::do_create_surface(l3d_workers& workers) const {
    return std::make_unique<l3d_surface_rasterizer_sw>(workers);
}
