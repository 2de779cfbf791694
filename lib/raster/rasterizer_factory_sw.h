// SPDX-License-Identifier: MIT
// l3d_rasterizer_factory_sw: the rasterizers on the CPU.
#ifndef L3D_RASTER_RASTERIZER_FACTORY_SW_H
#define L3D_RASTER_RASTERIZER_FACTORY_SW_H

#include "base/public.h"
#include "raster/rasterizer_factory.h"

/// The kind of edges of polygons of one colour, and of lines.
enum class L3D_PUBLIC l3d_edges {
    hard,  ///< at whole pixels, as l3d_rasterizer_2d says
    smooth ///< as paths and smooth lines do, whatever call draws them
};

/// Serves every screen, since all of them have their pixels in memory.
class L3D_PUBLIC l3d_rasterizer_factory_sw final : public l3d_rasterizer_factory {
public:
    /// Makes rasterizers with these edges in two dimensions.
    explicit l3d_rasterizer_factory_sw(l3d_edges edges = l3d_edges::hard) : edges_(edges) {}

private:
    /// Errors:  none.
    std::unique_ptr<l3d_rasterizer_2d_imp> do_create_2d(l3d_pixels target) const override;

    /// Errors:  none.
    std::unique_ptr<l3d_surface_rasterizer> do_create_surface(l3d_workers& workers) const override;

    l3d_edges edges_;
};

#endif
