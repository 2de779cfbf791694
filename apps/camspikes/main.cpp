// SPDX-License-Identifier: MIT
// camspikes: shows spikes to a camera that flies.
#include "../spikes/spike.h"
#include <l3d/pipeline_world.h>
#include <l3d/program.h>

namespace {

// Step 2 of 5: the world that l3d_pipeline_world shows.
class camspikes_world final : public l3d_world {
public:
    camspikes_world(l3d_size size, std::uint64_t seed) : l3d_world(size), random_(seed) {
        order = l3d_draw_order::far_first;
        camera.near_z = 0.01;
        const spike_kind kind{.spread = 300,
                              .nearest_start = 200,
                              .farthest_start = 200,
                              .slowest = 10,
                              .fastest = 49};
        for (int i = 0; i < 150; ++i)
            add(std::make_unique<spike>(kind, random_));
    }

private:
    l3d_random random_;
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program("camspikes",
                        l3d_caption{.what = "Spikes come at a camera that you can fly.",
                                    .teaches = "A camera is a place and three axes of its own. All "
                                               "points are told by them before they are projected.",
                                    .keys = l3d_world_keys()},
                        {960, 600});
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        l3d_pipeline_world pipeline(program.create_canvas(), [&](l3d_size size) {
            return std::make_unique<camspikes_world>(size, program.seed());
        });
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
