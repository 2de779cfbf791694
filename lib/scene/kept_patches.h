// SPDX-License-Identifier: MIT
// l3d_kept_patches: which rules of leaving patches out are switched off.
#ifndef L3D_SCENE_KEPT_PATCHES_H
#define L3D_SCENE_KEPT_PATCHES_H

#include "base/public.h"

/// Patches, and parts of them, that are drawn although a rule could leave them out. It serves those
/// who measure or judge a rule.
struct L3D_PUBLIC l3d_kept_patches {
    /// Those outside the picture.
    bool outside = false;
    /// Those that cover no pixel's centre.
    bool centreless = false;
    /// Those behind what is drawn.
    bool hidden = false;
    /// Those that show only their back.
    bool backs = false;
    /// Those that could be drawn as a point each, without dicing.
    bool dicing = false;

    /// All of them, as if there were no rule.
    static constexpr l3d_kept_patches all() { return {true, true, true, true, true}; }

    friend bool operator==(const l3d_kept_patches&, const l3d_kept_patches&) = default;
};

#endif
