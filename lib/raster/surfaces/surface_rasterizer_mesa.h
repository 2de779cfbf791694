// SPDX-License-Identifier: MIT
// l3d_surface_rasterizer_mesa: the surface rasterizer through GL.
#ifndef L3D_RASTER_SURFACES_SURFACE_RASTERIZER_MESA_H
#define L3D_RASTER_SURFACES_SURFACE_RASTERIZER_MESA_H

#include "raster/mesa_target_p.h"
#include "raster/surfaces/surface_rasterizer_scalar.h"

#include <array>
#include <memory>
#include <vector>

/// Draws surfaces through GL, as a second opinion on every picture. Coverage, interpolation, depth
/// test and shading language are GL's.
///
/// A convex quad is drawn as two triangles. The quad's outline is exact. If it is no parallelogram,
/// depth and shade inside differ a little from the plane that the CPU lays through it.
///
/// Positions are exact within 8192 pixels of the middle of the picture. Polygons that reach further
/// are clipped at this distance, with rounding. The CPU draws pictures larger than GL's largest,
/// and pictures with several lights or highlights.
/// Units:   as l3d_surface_rasterizer_scalar, and inv_w from 2^-94 to 2^32.
/// Cost:    drawing gathers polygons. If pixels are counted, every batch is drawn twice: once for
///          its samples alone, and once for its pixels.
class l3d_surface_rasterizer_mesa final : public l3d_surface_rasterizer {
public:
    /// Errors:  l3d_error(no_backend) if this GL does not compile the shaders.
    explicit l3d_surface_rasterizer_mesa(std::unique_ptr<l3d_detail::mesa_context> context);

private:
    std::string do_describe() const override { return by_cpu_ ? "" : gl_target_.describe(); }
    void do_begin(l3d_pixels target, l3d_depth_buffer* depth, const l3d_shading& shading,
                  bool untouched) override;
    void do_draw(std::span<const l3d_surface_part* const> parts) override;
    void do_finish() override;
    const l3d_surface_counts& do_counts() const override;

    struct vertex {
        float position[3]; ///< the vertex's x and y in pixels, and its inv_w
        float normal[3];   ///< the normal; in mode `error`, the colour's red, green and blue
        std::array<std::uint8_t, 4> material; ///< red, green and blue of the material
    };

    void add_part(const l3d_surface_part& part);
    void set_material(std::uint32_t material);
    void add_quad(std::array<l3d_micro_vertex, 4> corners, bool shows_both, bool parallel);
    void add(std::span<const l3d_micro_vertex> convex);
    void flush();
    std::int64_t draw();

    l3d_detail::mesa_target gl_target_;
    l3d_pixels target_;
    /// Depths for counting covered pixels, if the caller gave no buffer.
    l3d_depth_buffer own_depth_;
    l3d_depth_buffer* depth_ = nullptr;
    l3d_shading shading_;
    l3d_surface_counts counts_;
    std::uint32_t error_color_ = 0x00ffffff;
    /// The material's colour for vertices that are added next.
    std::array<std::uint8_t, 4> color_{};
    std::vector<vertex> batch_;
    l3d_size held_size_;
    bool fits_ = false; ///< whether GL can hold the picture
    /// Whether the CPU draws this frame, as the picture does not fit or the frame is lit.
    bool by_cpu_ = false;
    bool cleared_ = false; ///< whether GL's picture was cleared for this frame
    unsigned query_ = 0;
    l3d_surface_rasterizer_scalar cpu_;
};

#endif
