// SPDX-License-Identifier: MIT
// l3d_pipeline_zsort: polygons painted from back to front.
#ifndef L3D_PIPELINE_ZSORT_PIPELINE_ZSORT_H
#define L3D_PIPELINE_ZSORT_PIPELINE_ZSORT_H

#include "base/public.h"
#include "pipeline/polygons/pipeline_polygons.h"

#include <cstdint>
#include <memory>

/// Draws polygons by the painter's algorithm: triangles are painted from back to front, without a
/// depth buffer. Triangles that have no right order are cut.
///
/// For anti-aliasing, a depth buffer is filled after painting, to find the pixels at edges. Fog and
/// point lights need its depths, too.
class L3D_PUBLIC l3d_pipeline_zsort : public l3d_pipeline_polygons {
public:
    /// A pipeline that draws this model on this canvas.
    /// Errors:  as l3d_rasterizer_factory::create_2d.
    l3d_pipeline_zsort(l3d_canvas canvas, l3d_polygon_model model, const l3d_camera& camera,
                       const l3d_polygon_settings& settings);
    ~l3d_pipeline_zsort() override;

private:
    void draw_solid(const scene& what, l3d_polygon_report& report) override;
    void draw_hidden_lines(const scene& what, l3d_polygon_report& report) override;
    const char* name() const override { return "zsort"; }
    bool draws_parts(const l3d_shading& shading) const override { return wants_depth(shading); }

    static bool wants_depth(const l3d_shading& shading) {
        return shading.antialias || shading.fog.is_on() || shading.lighting.point_count > 0;
    }
    std::int64_t look_at_depth(const scene& what);
    void make_order(const scene& what, bool with_sides, l3d_polygon_report& report);

    struct stages;
    std::unique_ptr<stages> stages_;
};

#endif
