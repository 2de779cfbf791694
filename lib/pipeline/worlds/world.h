// SPDX-License-Identifier: MIT
// l3d_world: objects and the camera that looks at them.
#ifndef L3D_PIPELINE_WORLDS_WORLD_H
#define L3D_PIPELINE_WORLDS_WORLD_H

#include "base/public.h"
#include "pipeline/worlds/facet_list.h"

#include <cstddef>
#include <memory>
#include <vector>

/// A left-handed world. A program populates it in the constructor of a subclass.
class L3D_PUBLIC l3d_world {
public:
    /// An empty world, whose camera makes pictures of this size.
    explicit l3d_world(l3d_size size) : camera(size) {}
    l3d_world(const l3d_world&) = delete;
    l3d_world& operator=(const l3d_world&) = delete;
    virtual ~l3d_world() = default;

    /// Where the world is seen from.
    l3d_camera_left_handed<l3d_real> camera;
    /// All that is in the world.
    std::vector<std::unique_ptr<l3d_object>> objects;
    /// In which order polygons are drawn.
    l3d_draw_order order = l3d_draw_order::far_first;
    /// Only the camera moves.
    bool frozen = false;

    /// Lets time pass for every object, then for the camera. Units: seconds.
    void update_all(double seconds);

    /// Draws all that the camera sees. Returns the number of polygons drawn.
    std::size_t draw_all(l3d_rasterizer_2d& rasterizer, l3d_size size);

private:
    l3d_facet_list facets_;
};

#endif
