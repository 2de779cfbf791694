// SPDX-License-Identifier: MIT
// l3d_surface_rasterizer_scalar: draws the whole picture as one band.
#include "raster/surfaces/surface_rasterizer_scalar.h"

#include "raster/shaders/face_painter_p.h"
#include "raster/shaders/fog_words_p.h"

#include <algorithm>
#include <cassert>

using namespace l3d_detail;

void l3d_surface_rasterizer_scalar::do_begin(l3d_pixels target, l3d_depth_buffer* depth,
                                             const l3d_shading& shading, bool) {
    assert(!depth || target.size() == depth->size());
    if (!depth) {
        depth = &own_depth_;
        depth->resize(target.size());
    }
    depth->clear();
    shading.background.fill(target);
    shading_ = shading;
    drawn_ = target;
    materials_.begin(shading.is_lit(materials()) ? std::span<const l3d_material>() : materials());
    part_ = {};
    depth_ = depth;
    counts_ = {};
    filler_.begin({target.words, target.stride, depth->data(), depth->pitch(), target.width, 0,
                   target.height},
                  shading_, materials(), fill_words{materials_.wanted()});
}

void l3d_surface_rasterizer_scalar::do_begin_part(l3d_pixels target, l3d_depth_buffer* depth,
                                                  const l3d_shading& shading,
                                                  const l3d_pixel_box& part) {
    assert(!part.empty() && part.intersected(l3d_whole(target.size())) == part);
    if (own_picture_.pixels().size() != target.size())
        own_picture_ = l3d_image(target.size());
    do_begin(own_picture_.pixels(), depth, shading, false);
    part_ = part;
    part_target_ = target;
}

void l3d_surface_rasterizer_scalar::do_draw(std::span<const l3d_surface_part* const> parts) {
    for (const l3d_surface_part* part : parts) {
        filler_.fill(*part, all_cells(part->grid));
        filler_.fill(*part, 0, part->triangles.count);
        counts_.quads += polygons(*part);
    }
}

void l3d_surface_rasterizer_scalar::do_finish() {
    const material_pixels pixels{drawn_.words,    drawn_.stride, depth_->data(),
                                 depth_->pitch(), drawn_.width,  drawn_.height};
    if (materials_.wanted() && shading_.paints) {
        face_painter painter(*shading_.paints, materials());
        paint_words(pixels, 0, 0, painter);
    } else if (materials_.wanted()) {
        materials_.color_slowly(pixels);
    }
    if (shading_.fog.is_on())
        put_fog(shading_, pixels, 0, drawn_.height);
    for (int row = part_.top; row < part_.bottom; ++row)
        std::copy_n(own_picture_.pixels().row(row).data() + part_.left, part_.right - part_.left,
                    part_target_.row(row).data() + part_.left);
    counts_.samples = filler_.counts().samples;
    counts_.written = filler_.counts().written;
    counts_.level_error = double{filler_.counts().level_error};
    counts_.normal_error = double{filler_.counts().normal_error};
    counts_.unproven_levels = filler_.counts().unproven_levels;
    counts_.unsolved = filler_.counts().unsolved;
    counts_.covered = counts_pixels() ? l3d_covered(*depth_) : l3d_surface_counts::none_counted;
}
