// SPDX-License-Identifier: MIT
// laid_pictures: the numbers by which a rasterizer finds pictures that lie on patches.
#ifndef L3D_PIPELINE_LAID_PICTURES_P_H
#define L3D_PIPELINE_LAID_PICTURES_P_H

#include "dice/frame_dicer.h"
#include "raster/textures/painted_part_p.h"
#include "scene/patch_scene.h"
#include "scene/culling/scene_culling.h"

#include <cstddef>
#include <span>
#include <utility>

namespace l3d_detail {

/// Collects the pictures that lie on a frame's patches, for the rasterizer to paint. Each quad
/// under a picture gets a name, a number that replaces the number of the quad's material. The
/// rasterizer finds the picture by this name.
class laid_pictures {
public:
    /// Starts a frame. Names begin at `materials`, the number of the scene's materials. Returns the
    /// paints for the frame's shading; null if no picture lies on the scene.
    const l3d_face_paints* begin(const l3d_patch_scene& scene, l3d_texture_filter filter,
                                 std::size_t materials) {
        parts_.clear();
        paints_ = {{}, &parts_, filter};
        next_ = materials;
        return scene.has_pictures() ? &paints_ : nullptr;
    }

    /// Names the polygons that dicing made of `batch`, the dicer's last batch, if pictures lie on
    /// the patches.
    /// Expects: begin returned paints.
    template <class T>
    void add(const l3d_patch_scene& scene, std::span<const l3d_placed_patch> batch,
             l3d_frame_dicer<T>& dicer) {
        for (std::size_t i = 0; i < batch.size(); ++i) {
            const auto [index, patch] = std::pair{batch[i].instance, batch[i].patch};
            const l3d_patch_instance& instance = scene.instances()[index];
            const l3d_laid_picture& picture = instance.picture();
            if (!picture.texture)
                continue;
            painted_part like;
            like.material = scene.material_of(index, patch);
            like.texture = picture.texture.get();
            like.map = map_of(instance.model(), picture, patch);
            dicer.name_polygons(i, like, next_, parts_);
        }
    }

private:
    /// The map from a patch's parameters to the picture on the patch's piece. The patch may be only
    /// a part of the piece.
    static picture_map map_of(const l3d_patch_model& model, const l3d_laid_picture& picture,
                              std::size_t patch) {
        const std::size_t piece = model.piece_of(patch);
        const picture_map of_piece = picture_map::between(
            picture.pieces.empty() ? l3d_laid_picture::whole : picture.pieces[piece]);
        const l3d_parameter_range range = model.range_in_piece(patch);
        return picture_map::between(
            {of_piece.at({range.u0, range.v0}), of_piece.at({range.u1, range.v0}),
             of_piece.at({range.u0, range.v1}), of_piece.at({range.u1, range.v1})});
    }

    painted_parts parts_;
    l3d_face_paints paints_;
    std::size_t next_ = 0; ///< the next name to give
};

} // namespace l3d_detail

#endif
