// SPDX-License-Identifier: MIT
// spikes_pipeline: polygons in space that share vertices, flying past the viewer.
#ifndef L3D_APPS_SPIKES_SPIKES_PIPELINE_H
#define L3D_APPS_SPIKES_SPIKES_PIPELINE_H

#include <l3d/pipeline_2d.h>
#include <l3d/world.h>
#include "spike.h"

/// A hundred and fifty spikes of a kind, and a viewer who stands still.
class spikes_pipeline final : public l3d_pipeline_2d {
public:
    spikes_pipeline(l3d_canvas canvas, std::uint64_t seed, const spike_kind& kind)
        : l3d_pipeline_2d(std::move(canvas)), random_(seed), world_(size()) {
        world_.camera.place = l3d_point<l3d_real>::of(0, 0, 0);
        world_.camera.near_z = 1;
        world_.camera.far_z = 2000;
        for (int i = 0; i < 150; ++i)
            world_.add(std::make_unique<spike>(kind, random_));
    }

    void update_event(double seconds) override { world_.update_all(seconds); }

    void resize_event(l3d_size size) override {
        l3d_pipeline_2d::resize_event(size);
        world_.camera.fovy = world_.camera.fovx * size.width / size.height;
    }

private:
    void draw(l3d_rasterizer_2d& rasterizer) override {
        rasterizer.clear_buffer();
        world_.draw_all({rasterizer, screen().pixels()});
    }

    l3d_random random_;
    l3d_world world_;
};

#endif
