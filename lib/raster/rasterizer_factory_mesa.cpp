// SPDX-License-Identifier: MIT
// l3d_rasterizer_factory_mesa: makes a context for each rasterizer.
#include "raster/rasterizer_factory.h"

#include "base/error.h"
#include "raster/shapes/rasterizer_2d_mesa.h"
#include "raster/surfaces/surface_rasterizer_mesa.h"

namespace {

std::unique_ptr<l3d_detail::mesa_context> open_context(const std::string& library) {
    std::string why;
    auto context = l3d_detail::mesa_context::open(library, why);
    if (!context)
        throw l3d_error(l3d_exit::no_backend, why);
    return context;
}

} // namespace

std::string l3d_rasterizer_factory_mesa::do_describe() const {
    return open_context(library_)->describe();
}

std::unique_ptr<l3d_rasterizer_2d_imp>
l3d_rasterizer_factory_mesa::do_create_2d(l3d_pixels target) const {
    return std::make_unique<l3d_rasterizer_2d_mesa_imp>(open_context(library_), target);
}

std::unique_ptr<l3d_surface_rasterizer>
l3d_rasterizer_factory_mesa::do_create_surface(l3d_workers&) const {
    return std::make_unique<l3d_surface_rasterizer_mesa>(open_context(library_));
}
