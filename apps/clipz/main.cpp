// SPDX-License-Identifier: MIT
// clipz: large spikes that are cut where they come too near; and what is wrong without sorting.
#include "../spikes/spike.h"
#include <l3d/pipeline_world.h>
#include <l3d/program.h>

#include <utility>
#include <vector>

namespace {

class clipz_world final : public l3d_world {
public:
    clipz_world(l3d_size size, std::uint64_t seed) : l3d_world(size), random_(seed) {
        order = l3d_draw_order::as_added;
        camera.near_z = 10;
        const spike_kind kind{.length = 50,
                              .width = 50,
                              .spread = 300,
                              .nearest_start = 200,
                              .farthest_start = 200,
                              .slowest = 10,
                              .fastest = 49};
        for (int i = 0; i < 50; ++i)
            objects.push_back(std::make_unique<spike>(kind, random_));
    }

private:
    l3d_random random_;
};

// Step 2 of 5: the pipeline of worlds, with one key more.
class clipz_pipeline final : public l3d_pipeline_world {
public:
    clipz_pipeline(l3d_canvas canvas, l3d_world& world)
        : l3d_pipeline_world(std::move(canvas), world), world_(world) {}

    void key_event(int key) override {
        l3d_pipeline_world::key_event(key);
        if (key == 'o')
            world_.order = world_.order == l3d_draw_order::as_added ? l3d_draw_order::far_first
                                                                    : l3d_draw_order::as_added;
    }

private:
    l3d_world& world_;
};

} // namespace

int main(int argc, char** argv) {
    std::vector<l3d_caption_row> keys = l3d_world_keys();
    keys.push_back({"o", "draw far spikes first, or as they come"});
    l3d_program program("clipz",
                        l3d_caption{.what = "Spikes cut by a near plane. Stop them with 0, and fly "
                                            "into one.",
                                    .keys = std::move(keys)},
                        {960, 600});
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        auto canvas = program.create_canvas();
        clipz_world world(canvas.screen->pixels().size(), program.seed());
        clipz_pipeline pipeline(std::move(canvas), world);
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
