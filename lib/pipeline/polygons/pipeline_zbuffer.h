// SPDX-License-Identifier: MIT
// l3d_pipeline_zbuffer: polygons through a depth buffer.
#ifndef L3D_PIPELINE_POLYGONS_PIPELINE_ZBUFFER_H
#define L3D_PIPELINE_POLYGONS_PIPELINE_ZBUFFER_H

#include "base/public.h"
#include "pipeline/polygons/pipeline_polygons.h"
#include "raster/depth_buffer.h"
#include "raster/rasterizer_factory.h"
#include "raster/surface_rasterizer.h"

#include <memory>
#include <vector>

struct l3d_painter_triangle;

/// Draws polygons in any order; a depth buffer tells which polygon is nearest in each pixel. The
/// surface rasterizer is the library's own or Mesa's OpenGL.
class L3D_PUBLIC l3d_pipeline_zbuffer : public l3d_pipeline_polygons {
public:
    /// A pipeline that draws this model on this canvas, by the canvas's own rasterizers.
    /// Errors:  as l3d_rasterizer_factory::create_surface.
    l3d_pipeline_zbuffer(l3d_canvas canvas, l3d_polygon_model model, const l3d_camera& camera,
                         const l3d_polygon_settings& settings);

    /// A pipeline that fills surfaces with the rasterizers of `surfaces`, which may be of another
    /// kind than the canvas's. `method` is the pipeline's name in reports.
    /// Errors:  as l3d_rasterizer_factory::create_surface.
    l3d_pipeline_zbuffer(l3d_canvas canvas, l3d_polygon_model model, const l3d_camera& camera,
                         const l3d_polygon_settings& settings,
                         const l3d_rasterizer_factory& surfaces, const char* method = "zbuffer");
    ~l3d_pipeline_zbuffer() override;

private:
    l3d_pipeline_zbuffer(const std::shared_ptr<const l3d_rasterizer_factory>& surfaces,
                         l3d_canvas&& canvas, l3d_polygon_model&& model, const l3d_camera& camera,
                         const l3d_polygon_settings& settings);

    void draw_solid(const scene& what, l3d_polygon_report& report) override;
    void draw_hidden_lines(const scene& what, l3d_polygon_report& report) override;
    const char* name() const override { return method_; }

    void fill(const scene& what, l3d_depth_buffer* depth, l3d_polygon_report& report);

    l3d_surface_rasterizer& rasterizer_for(const l3d_shading& shading);

    const char* method_;
    std::unique_ptr<l3d_surface_rasterizer> rasterizer_;
    std::unique_ptr<l3d_surface_rasterizer> with_fog_; ///< draws fog, if `rasterizer_` cannot
    l3d_depth_buffer depth_;
    std::vector<l3d_painter_triangle> triangles_; ///< triangles with their sides, for hidden lines
};

#endif
