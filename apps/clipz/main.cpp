// SPDX-License-Identifier: MIT
// clipz: cuts large spikes where they come too near. It shows the faults of pictures without
// sorting.
#include "../spikes/spike.h"
#include <l3d/pipeline_world.h>
#include <l3d/program.h>

namespace {

// Step 2 of 5: the world that l3d_pipeline_world shows.
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
            add(std::make_unique<spike>(kind, random_));
    }

private:
    l3d_random random_;
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program(
        "clipz",
        l3d_caption{
            .what = "Spikes cut by a near plane. Stop them with 0, and fly "
                    "into one.",
            .teaches =
                "Behind the eye there is no projection: polygons are cut at a plane before it. "
                "Without any order, far ones cover near ones; the key o puts that right.",
            .keys = l3d_world_keys()},
        {960, 600});
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        l3d_pipeline_world pipeline(program.create_canvas(), [&](l3d_size size) {
            return std::make_unique<clipz_world>(size, program.seed());
        });
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
