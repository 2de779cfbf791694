// SPDX-License-Identifier: MIT
// l3d_part_switch: named parts of a scene that come and go while it is looked at.
#ifndef L3D_PIPELINE_PART_SWITCH_H
#define L3D_PIPELINE_PART_SWITCH_H

#include "base/public.h"
#include "scene/patch_model.h"
#include "scene/patch_scene.h"

#include <cstddef>
#include <string>
#include <vector>

/// The named parts of all models of a scene, one of which is chosen, and each of which is shown or
/// hidden. Parts of one name are one, in whichever instance.
///
/// Only shown parts stand in the scene: a hidden part's patches are taken out of their instances.
/// An instance that a program gives another model has all of that model again.
/// Lives: borrows the scene.
class L3D_PUBLIC l3d_part_switch {
public:
    /// The scene may get its models later.
    explicit l3d_part_switch(l3d_patch_scene& scene) : scene_(scene) {}

    /// Chooses the next part, beginning with the first, and again after the last one. Returns: a
    /// line that names it.
    std::string choose_next();

    /// Hides the chosen part, or shows it again. Without one, the first is chosen. One part at
    /// least stays shown. Returns: a line that tells the part's new state.
    /// Cost: bounds of the patches that stay are computed again: some microseconds for each.
    std::string switch_chosen();

    /// The name of the chosen part; "" if none is.
    const std::string& chosen() const { return chosen_; }

    /// Shows all that this has hidden.
    void show_all();

private:
    /// An instance's own model, and the one in its place.
    struct taken {
        l3d_patch_model whole, shown;
    };

    void note_parts();
    bool is_hidden(const std::string& name) const;
    void place_shown();
    bool shows_nothing() const;

    l3d_patch_scene& scene_;
    std::vector<std::string> names_;  ///< names of all parts, in the order of the instances
    std::vector<std::string> hidden_; ///< some of them
    std::string chosen_;              ///< one of them; "" at first
    std::vector<taken> instances_;
};

#endif
