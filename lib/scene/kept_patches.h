// SPDX-License-Identifier: MIT
// l3d_kept_patches: which rules of leaving patches out are switched off.
#ifndef L3D_SCENE_KEPT_PATCHES_H
#define L3D_SCENE_KEPT_PATCHES_H

#include "base/public.h"

/// Patches, and parts of them, that are drawn although a rule could leave them out. It serves those
/// who measure or judge a rule.
struct L3D_PUBLIC l3d_kept_patches {
    bool outside = false;    ///< those outside the picture
    bool centreless = false; ///< those that cover no pixel's centre
    bool hidden = false;     ///< those behind what is drawn
    bool backs = false;      ///< those that show only their back
    bool dicing = false;     ///< those that could be drawn as a point each, without dicing

    /// All of them, as if there were no rule.
    static constexpr l3d_kept_patches all() { return {true, true, true, true, true}; }

    friend bool operator==(const l3d_kept_patches&, const l3d_kept_patches&) = default;
};

#endif
