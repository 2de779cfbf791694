// SPDX-License-Identifier: MIT
// inspection_shader: exact properties of a patch at each pixel, as colours.
#ifndef L3D_RASTER_SHADERS_INSPECTION_SHADER_P_H
#define L3D_RASTER_SHADERS_INSPECTION_SHADER_P_H

#include "geom/patch_jet.h"
#include "raster/inspected_patches.h"
#include "raster/surface_rasterizer.h"

#include <algorithm>
#include <array>
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

/// Finds the parameters of the point of a patch that the eye sees at a place of the picture, by
/// Newton's method from a guess. Gives the guess itself if that leads nowhere. Units: pixels.
patch_parameters seen_parameters(const l3d_inspected_patches& frame,
                                 const l3d_bezier_patch<double, 3>& net, double x, double y,
                                 double u, double v);

/// The common part of shaders that look at exact patches. Only the pixel's place and a guess of its
/// parameters come from the vertices.
class patch_shader {
public:
    /// The parameters u and v.
    static constexpr std::size_t components = 2;

    /// Chooses the patch of the next polygons.
    void use_material(std::uint32_t index) {
        index_ = index;
        net_ = &patches_.nets[index];
    }

    void begin_polygon(std::span<const l3d_micro_vertex> corners) {
        for (std::size_t i = 0; i < components; ++i) {
            least_[i] = most_[i] = corners[0].normal[i];
            for (const l3d_micro_vertex& vertex : corners) {
                least_[i] = std::min(least_[i], vertex.normal[i]);
                most_[i] = std::max(most_[i], vertex.normal[i]);
            }
        }
    }
    void corner(const l3d_micro_vertex& vertex, float* out) const {
        std::copy_n(vertex.normal, components, out);
    }

    /// The pixels since the last call for which no exact place was found.
    std::int64_t take_unsolved() { return std::exchange(unsolved_, 0); }

protected:
    /// Lives: borrows the shading and its patches.
    explicit patch_shader(const l3d_shading& shading)
        : shading_(shading), patches_(*shading.inspected) {}

    /// Parameters from a plane through a polygon's corners are only a guess, above all in slivers.
    patch_parameters solved(const float* guess, double x, double y) const;

    const l3d_shading& shading_;
    const l3d_inspected_patches& patches_;
    const l3d_bezier_patch<double, 3>* net_ = nullptr;
    std::uint32_t index_ = 0;
    std::int64_t unsolved_ = 0;

private:
    std::array<float, components> least_{}, most_{}; ///< bounds of the polygon's corners
};

/// Shows a number, or stripes, of the exact patch in each pixel.
class inspection_shader : public patch_shader {
public:
    explicit inspection_shader(const l3d_shading& shading) : patch_shader(shading) {}

    /// Units: pixels from the picture's top left corner.
    std::uint32_t word_at(const float* guess, double x, double y);

    /// The word of a part of a pixel around a place: stripes are means over whole pixels already,
    /// so all parts of a patch in one pixel should show the same. Beside outlines the eye misses
    /// the patch at the pixel's middle.
    std::uint32_t word_around(const float* guess, double x, double y);

private:
    struct sight;
    std::uint32_t word_of(patch_parameters place, double x, double y);
    std::optional<sight> look_at(patch_parameters at, double x, double y) const;
    std::uint32_t stripe(const sight& of) const;
};

} // namespace l3d_detail

#endif
