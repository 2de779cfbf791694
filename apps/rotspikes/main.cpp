// SPDX-License-Identifier: MIT
// rotspikes: tumbles spikes about all three axes while they fly past the viewer.
#include "../spikes/spikes_world.h"
#include <l3d/pipeline_world.h>
#include <l3d/program.h>

// Step 2 of 5: the pipeline shows the world of spikes, which tumble here.
int main(int argc, char** argv) {
    l3d_program program("rotspikes",
                        l3d_caption{.what = "Spikes tumble and fly past the viewer.",
                                    .teaches = "One product of matrices turns a spike about three "
                                               "axes and puts it into its place.",
                                    .keys = l3d_world_keys()},
                        {960, 600});
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        l3d_pipeline_world pipeline(program.create_canvas(), [&](l3d_size size) {
            return std::make_unique<spikes_world>(size, program.seed(),
                                                  spike_kind{.fastest_turn = 8});
        });
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
