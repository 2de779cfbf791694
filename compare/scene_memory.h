// SPDX-License-Identifier: MIT
// l3d_scene_memory: tells whether a scene is still the one that kept data was made of.
#ifndef L3D_COMPARE_SCENE_MEMORY_H
#define L3D_COMPARE_SCENE_MEMORY_H

#include "scene/patch_scene.h"

#include <algorithm>
#include <vector>

/// Remembers the models of a scene, with their placements and materials. So a method knows whether
/// data that it made of the scene are still right.
///
/// Lives: shares the models, so no other model can come to the address of one that is remembered.
class l3d_scene_memory {
public:
    bool holds(const l3d_patch_scene& scene) const {
        const auto instances = scene.instances();
        return is_set_ &&
               std::equal(instances.begin(), instances.end(), instances_.begin(), instances_.end(),
                          [](const l3d_patch_instance& is, const l3d_patch_instance& was) {
                              return is.model().identity() == was.model().identity() &&
                                     is.model().paint_identity() == was.model().paint_identity() &&
                                     is.material() == was.material() &&
                                     is.placement() == was.placement();
                          });
    }

    void remember(const l3d_patch_scene& scene) {
        instances_.assign(scene.instances().begin(), scene.instances().end());
        is_set_ = true;
    }

private:
    bool is_set_ = false;
    std::vector<l3d_patch_instance> instances_;
};

#endif
