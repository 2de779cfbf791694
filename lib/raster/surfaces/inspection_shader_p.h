// SPDX-License-Identifier: MIT
// inspection_shader: what a patch exactly is at a pixel, in colours.
#ifndef L3D_RASTER_SURFACES_INSPECTION_SHADER_P_H
#define L3D_RASTER_SURFACES_INSPECTION_SHADER_P_H

#include "geom/patch_jet.h"
#include "raster/inspected_patches.h"
#include "raster/surface_rasterizer.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace l3d_detail {

/// Parameters of a patch, and whether the patch is seen there.
struct patch_parameters {
    double u = 0, v = 0;
    bool is_solved = false;
};

/// Where the eye sees a patch at a place of the picture, by Newton's method from a guess; the
/// guess itself if that leads nowhere. Units: pixels.
patch_parameters seen_parameters(const l3d_inspected_patches& frame,
                                 const l3d_bezier_patch<double, 3>& net, double x, double y,
                                 double u, double v);

/// Shows a number, or stripes, of the exact patch in each pixel: only the pixel's place and a
/// guess of its parameters come from the vertices.
class inspection_shader {
public:
    /// The parameters u and v, and the place in the picture, in pixels.
    static constexpr std::size_t components = 4;

    /// Lives: borrows the shading and what it has of patches.
    explicit inspection_shader(const l3d_shading& shading)
        : shading_(shading), patches_(*shading.inspected) {}

    /// The patch that polygons are parts of from now on.
    void use_material(std::uint32_t index) { net_ = &patches_.nets[index]; }

    void begin_polygon(std::span<const l3d_micro_vertex>) {}
    void corner(const l3d_micro_vertex& vertex, float* out) const {
        out[0] = vertex.normal[0];
        out[1] = vertex.normal[1];
        out[2] = static_cast<float>(vertex.x) / l3d_subpixel_one;
        out[3] = static_cast<float>(vertex.y) / l3d_subpixel_one;
    }
    std::uint32_t word(const float* at);

    /// The pixels since the last call for which no exact place was found.
    std::int64_t take_unsolved() { return std::exchange(unsolved_, 0); }

private:
    struct sight;
    std::optional<sight> look_at(patch_parameters at, double x, double y) const;
    std::uint32_t stripe(const sight& of) const;

    const l3d_shading& shading_;
    const l3d_inspected_patches& patches_;
    const l3d_bezier_patch<double, 3>* net_ = nullptr;
    std::int64_t unsolved_ = 0;
};

} // namespace l3d_detail

#endif
