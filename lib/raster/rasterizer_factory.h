// SPDX-License-Identifier: MIT
// l3d_rasterizer_factory: makes the rasterizers of one kind.
#ifndef L3D_RASTER_RASTERIZER_FACTORY_H
#define L3D_RASTER_RASTERIZER_FACTORY_H

#include "base/public.h"
#include "raster/rasterizer_2d.h"
#include "raster/surface_rasterizer.h"
#include "raster/parallel/workers.h"

#include <memory>
#include <string>

/// Makes what draws points, lines and polygons, and what fills surfaces, both of one kind.
class L3D_PUBLIC l3d_rasterizer_factory {
public:
    l3d_rasterizer_factory() = default;
    l3d_rasterizer_factory(const l3d_rasterizer_factory&) = delete;
    l3d_rasterizer_factory& operator=(const l3d_rasterizer_factory&) = delete;
    virtual ~l3d_rasterizer_factory() = default;

    /// One line for --verbose on what draws; empty if that is the processors.
    /// Errors:  as create_2d.
    std::string describe() const { return do_describe(); }

    /// Makes what draws into these pixels; never null.
    /// Errors:  l3d_error(no_backend); a kind whose screen factory can serve throws none.
    std::unique_ptr<l3d_rasterizer_2d_imp> create_2d(l3d_pixels target) const {
        return do_create_2d(target);
    }

    /// Makes what fills surfaces; never null.
    /// Errors:  as create_2d.
    /// Lives:   borrows the workers.
    std::unique_ptr<l3d_surface_rasterizer> create_surface(l3d_workers& workers) const {
        return do_create_surface(workers);
    }

private:
    virtual std::string do_describe() const { return {}; }
    virtual std::unique_ptr<l3d_rasterizer_2d_imp> do_create_2d(l3d_pixels target) const = 0;
    virtual std::unique_ptr<l3d_surface_rasterizer>
    do_create_surface(l3d_workers& workers) const = 0;
};

#endif
