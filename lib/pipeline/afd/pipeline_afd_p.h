// SPDX-License-Identifier: MIT
// l3d_pipeline_afd's own data, for the files that define it.
#ifndef L3D_PIPELINE_PIPELINE_AFD_P_H
#define L3D_PIPELINE_PIPELINE_AFD_P_H

#include "pipeline/pipeline_afd.h"

#include "dice/certificate/frame_doubts.h"
#include "dice/frame_dicer.h"
#include "pipeline/surface_method.h"
#include "raster/parallel/workers.h"
#include "raster/color/light_mix_p.h"
#include "raster/lines/depth_lines_p.h"
#include "scene/dice_view.h"
#include "scene/image_transform.h"
#include "scene/levels/level_choice.h"
#include "scene/culling/scene_culling.h"
#include "scene/space_curve.h"
#include "tool_2d/image.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace l3d_detail {

/// The part of l3d_afd_complaint that a frame cannot do without: a frame of other numbers would be
/// wrong, or never end.
std::string numbers_complaint(const l3d_camera& camera, l3d_size size,
                              const l3d_afd_settings& settings);

} // namespace l3d_detail

/// All values that a picture depends on, except the placements of the scene's models. If two frames
/// have the same basis, only the models that were moved need be drawn again.
struct l3d_pipeline_afd::basis {
    l3d_pixels target;
    l3d_matrix<double> to_image;
    l3d_dice_view view;
    l3d_shading shading;
    l3d_texture_filter filter{};
    bool wireframe = false, drawing = false, net = false, edges = false;
    bool depth = false, outlines = false, error_map = false;

    friend bool operator==(const basis&, const basis&) = default;
};

/// The task of one drawing: the scene, the picture, and the part of the picture to draw.
struct l3d_pipeline_afd::drawing {
    const l3d_patch_scene& scene;
    l3d_pixels target;
    l3d_pixel_box part;
    bool wants_depth = false;
};

/// The objects that make a frame in stages, from culling the scene to filling its surfaces.
struct l3d_pipeline_afd::stages {
    stages(const l3d_afd_settings& settings, const l3d_rasterizer_factory& rasterizers)
        : workers(settings.threads), method(settings.method.create(rasterizers, workers)),
          wire_dicer(workers) {}

    l3d_workers workers;
    std::unique_ptr<l3d_surface_method> method;
    basis drawn; ///< basis of the last picture that was drawn
    l3d_image_transform transform;
    l3d_dice_view view;
    l3d_curved_error curved;
    /// Boxes around the new places of moved instances; kept to reuse the memory.
    l3d_box_lanes moved_to;
    l3d_scene_culling wire_culling;
    l3d_frame_dicer<l3d_real> wire_dicer;
    l3d_detail::light_mix mix;     ///< mixes pictures with and without transparent instances
    l3d_image mixed;               ///< the next picture that `mix` adds to its mean
    l3d_detail::depth_lines lines; ///< kept to reuse the memory
    /// The edges of models as lines, by the models' identities.
    std::map<const void*, std::vector<l3d_space_curve>> edges;
    /// The map of errors of the last frame for which the settings asked for a map.
    std::unique_ptr<l3d_frame_doubts> doubts;
};

#endif
