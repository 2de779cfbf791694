// SPDX-License-Identifier: MIT
// l3d_kept_patches: which rules of leaving patches out are switched off.
#ifndef L3D_SCENE_KEPT_PATCHES_H
#define L3D_SCENE_KEPT_PATCHES_H

#include "base/public.h"

/// Which patches, and parts of them, are done although they need not be. Only who measures or
/// judges a rule has a use for that.
struct L3D_PUBLIC l3d_kept_patches {
    bool outside = false;    ///< such that nothing of them lies in the picture
    bool centreless = false; ///< such that cover no pixel's centre
    bool hidden = false;     ///< such that lie behind what is drawn
    bool backs = false;      ///< whose back alone is turned to the eye
    bool dicing = false;     ///< of what a point may stand for

    /// All of them, as if no rule could leave any out.
    static constexpr l3d_kept_patches all() { return {true, true, true, true, true}; }

    friend bool operator==(const l3d_kept_patches&, const l3d_kept_patches&) = default;
};

#endif
