// SPDX-License-Identifier: MIT
// l3d_surface_rasterizer_scalar: the surface rasterizer, one pixel after the other.
#ifndef L3D_RASTER_SURFACES_SURFACE_RASTERIZER_SCALAR_H
#define L3D_RASTER_SURFACES_SURFACE_RASTERIZER_SCALAR_H

#include "raster/surfaces/band_scalar_p.h"
#include "raster/surface_rasterizer.h"
#include "raster/shaders/material_words_p.h"
#include "tool_2d/image.h"

/// Fills surfaces without bands or SIMD lanes, as the slow twin of l3d_surface_rasterizer_sw. It
/// draws parts in their given order, each into the whole picture.
///
/// Units:   normals of 1e-18 to 1e18 in length; a zero normal gets the ambient grey, and the middle
///          grey in mode `normals`.
/// Cost:    allocates in begin, if the picture is larger than any before, and in begin_part, if its
///          size changes.
class l3d_surface_rasterizer_scalar final : public l3d_surface_rasterizer {
private:
    void do_begin(l3d_pixels target, l3d_depth_buffer* depth, const l3d_shading& shading,
                  bool untouched) override;
    bool do_takes_levels() const override { return true; }
    bool do_draws_parts() const override { return true; }
    bool do_inspects() const override { return true; }
    void do_begin_part(l3d_pixels target, l3d_depth_buffer* depth, const l3d_shading& shading,
                       const l3d_pixel_box& part) override;
    void do_draw(std::span<const l3d_surface_part* const> parts) override;
    void do_finish() override;
    const l3d_surface_counts& do_counts() const override { return counts_; }

    l3d_detail::band_scalar filler_;
    l3d_detail::material_words materials_;
    l3d_shading shading_;
    l3d_pixels drawn_; ///< the target, or own_picture_ if only a part is drawn
    l3d_depth_buffer own_depth_;
    l3d_image own_picture_; ///< the picture into which a frame of begin_part is drawn
    l3d_pixel_box part_; ///< the part of own_picture_ that is copied to part_target_; may be empty
    l3d_pixels part_target_;
    l3d_depth_buffer* depth_ = nullptr;
    l3d_surface_counts counts_;
};

#endif
