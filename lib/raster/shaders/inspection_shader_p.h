// SPDX-License-Identifier: MIT
// inspection_shader: shows exact properties of a patch at each pixel as colours.
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

/// The parameters of a patch at a pixel, and whether the parameters were found exactly.
struct patch_parameters {
    double u = 0, v = 0;
    bool is_solved = false;
};

/// Finds the parameters of the patch's point that is seen at a place of the picture, by Newton's
/// method from a guess. Returns the guess itself if the method fails.
/// Units: pixels.
patch_parameters seen_parameters(const l3d_inspected_patches& frame,
                                 const l3d_bezier_patch<double, 3>& net, double x, double y,
                                 double u, double v);

/// The common part of shaders that evaluate exact patches. From the vertices, these shaders take
/// only a guess of a pixel's parameters.
class patch_shader {
public:
    /// The numbers that are interpolated: the parameters u and v.
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

    /// The number of pixels, since the last call, for which no exact place was found.
    std::int64_t take_unsolved() { return std::exchange(unsolved_, 0); }

protected:
    /// Lives: borrows the shading and its patches.
    explicit patch_shader(const l3d_shading& shading)
        : shading_(shading), patches_(*shading.inspected) {}

    /// The patch's exact parameters that are seen at a place of the picture. The guess comes from a
    /// plane through a polygon's corners, and may be poor, above all in slivers.
    patch_parameters solved(const float* guess, double x, double y) const;

    const l3d_shading& shading_;
    const l3d_inspected_patches& patches_;
    const l3d_bezier_patch<double, 3>* net_ = nullptr;
    std::uint32_t index_ = 0;
    std::int64_t unsolved_ = 0;

private:
    /// The least and the largest parameters at the polygon's corners.
    std::array<float, components> least_{}, most_{};
};

/// Shows a quantity of the exact patch as a colour in each pixel, or as stripes.
class inspection_shader : public patch_shader {
public:
    explicit inspection_shader(const l3d_shading& shading) : patch_shader(shading) {}

    /// The pixel word of a place, from a guess of the patch's parameters. Units: pixels from the
    /// picture's top left corner.
    std::uint32_t word_at(const float* guess, double x, double y);

    /// The pixel word for a part of a pixel around a place. Stripes are means over whole pixels
    /// already. So the word is that of the pixel's middle, the same for all parts of a patch in the
    /// pixel. At outlines, the ray through the pixel's middle may miss the patch; then the word of
    /// the place itself is taken.
    std::uint32_t word_around(const float* guess, double x, double y);

private:
    struct sight;
    std::uint32_t word_of(patch_parameters place, double x, double y);
    std::optional<sight> look_at(patch_parameters at, double x, double y) const;
    std::uint32_t stripe(const sight& of) const;
};

} // namespace l3d_detail

#endif
