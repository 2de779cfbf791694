// SPDX-License-Identifier: MIT
// l3d_rasterizer_factory_mesa: the rasterizers through Mesa's software GL.
#ifndef L3D_RASTER_RASTERIZER_FACTORY_MESA_H
#define L3D_RASTER_RASTERIZER_FACTORY_MESA_H

#include "base/public.h"
#include "raster/rasterizer_factory.h"

#include <string>
#include <utility>

/// Gives every rasterizer a GL context of its own; serves every screen, as GL's picture is copied
/// to the screen's pixels. A rasterizer belongs to the thread that made it.
class L3D_PUBLIC l3d_rasterizer_factory_mesa final : public l3d_rasterizer_factory {
public:
    /// Takes the GL of this library: auto, egl or osmesa; empty: what the environment variable
    /// L3D_MESA says. `auto` tries EGL first.
    explicit l3d_rasterizer_factory_mesa(std::string library = {}) : library_(std::move(library)) {}

private:
    /// Errors:  l3d_error(no_backend) with the reasons, if there is no software GL.
    std::string do_describe() const override;

    /// Errors:  l3d_error(no_backend) with the reasons, if there is no software GL.
    std::unique_ptr<l3d_rasterizer_2d_imp> do_create_2d(l3d_pixels target) const override;

    /// Errors:  l3d_error(no_backend) with the reasons, if there is no software GL.
    std::unique_ptr<l3d_surface_rasterizer> do_create_surface(l3d_workers& workers) const override;

    std::string library_;
};

#endif
