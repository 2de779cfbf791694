// SPDX-License-Identifier: MIT
// l3d_scene_memory: whether a scene is still the one that something was made of.
#ifndef L3D_COMPARE_SCENE_MEMORY_H
#define L3D_COMPARE_SCENE_MEMORY_H

#include "scene/patch_scene.h"

#include <algorithm>
#include <utility>
#include <vector>

/// The models of a scene and where they stood, for what is made once and kept.
///
/// Lives: shares the models, so no other model can come to the address of one that is remembered.
class l3d_scene_memory {
public:
    bool holds(const l3d_patch_scene& scene) const {
        const auto instances = scene.instances();
        return is_set_ &&
               std::equal(instances.begin(), instances.end(), instances_.begin(), instances_.end(),
                          [](const l3d_patch_instance& is, const auto& was) {
                              return is.model().identity() == was.first.identity() &&
                                     is.placement() == was.second;
                          });
    }

    void remember(const l3d_patch_scene& scene) {
        instances_.clear();
        for (const l3d_patch_instance& instance : scene.instances())
            instances_.emplace_back(instance.model(), instance.placement());
        is_set_ = true;
    }

private:
    bool is_set_ = false;
    std::vector<std::pair<l3d_patch_model, l3d_matrix<double>>> instances_;
};

#endif
