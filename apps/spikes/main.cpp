// SPDX-License-Identifier: MIT
// spikes: flies polygons past the viewer, which share vertices.
#include "spikes_world.h"
#include <l3d/pipeline_world.h>
#include <l3d/program.h>

// Step 2 of 5: the pipeline shows a world, which rotspikes has, too.
int main(int argc, char** argv) {
    l3d_program program("spikes",
                        l3d_caption{.what = "Spikes fly past the viewer.",
                                    .teaches = "Faces of a spike share their vertices: each is "
                                               "moved and projected once.",
                                    .keys = l3d_world_keys()},
                        {960, 600});
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        l3d_pipeline_world pipeline(program.create_canvas(), [&](l3d_size size) {
            return std::make_unique<spikes_world>(size, program.seed(), spike_kind{});
        });
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
