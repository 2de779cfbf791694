// SPDX-License-Identifier: MIT
// l3d_culling_switches: rules of leaving patches out that are switched off.
#ifndef L3D_SCENE_CULLING_SWITCHES_H
#define L3D_SCENE_CULLING_SWITCHES_H

#include "base/public.h"

/// Patches, and parts of them, that are drawn although a rule could leave them out, to measure or
/// judge a rule.
struct L3D_PUBLIC l3d_culling_switches {
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
    static constexpr l3d_culling_switches all() { return {true, true, true, true, true}; }

    friend bool operator==(const l3d_culling_switches&, const l3d_culling_switches&) = default;
};

#endif
