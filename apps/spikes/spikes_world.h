// SPDX-License-Identifier: MIT
// spikes_world: polygons in space that share vertices, flying past the viewer.
#ifndef L3D_APPS_SPIKES_SPIKES_WORLD_H
#define L3D_APPS_SPIKES_SPIKES_WORLD_H

#include <l3d/world.h>
#include "spike.h"

/// A world of a hundred and fifty spikes of one kind, and a viewer at the origin.
class spikes_world final : public l3d_world {
public:
    spikes_world(l3d_size size, std::uint64_t seed, const spike_kind& kind)
        : l3d_world(size), random_(seed) {
        order = l3d_draw_order::far_first;
        camera.place = l3d_point<l3d_real>::of(0, 0, 0);
        camera.near_z = 1;
        camera.far_z = 2000;
        for (int i = 0; i < 150; ++i)
            add(std::make_unique<spike>(kind, random_));
    }

private:
    l3d_random random_;
};

#endif
