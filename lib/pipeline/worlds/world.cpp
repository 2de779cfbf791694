// SPDX-License-Identifier: MIT
// l3d_world: what happens to all its objects.
#include "pipeline/worlds/world.h"

void l3d_world::update_all(double seconds) {
    if (!frozen)
        for (const auto& object : objects)
            object->update(seconds);
    camera.update(seconds);
}

std::size_t l3d_world::draw_all(l3d_rasterizer_2d& rasterizer, l3d_size size) {
    facets_.begin(camera, size);
    for (const auto& object : objects)
        facets_.add(*object);
    facets_.draw(rasterizer, order);
    return facets_.polygons();
}
