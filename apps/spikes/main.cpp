// SPDX-License-Identifier: MIT
// spikes: polygons in space that share vertices, flying past the viewer.
#include "spikes_pipeline.h"
#include <l3d/program.h>

// Step 2 of 5: the application is a pipeline; rotspikes has the same.
int main(int argc, char** argv) {
    l3d_program program("spikes", l3d_caption{"Spikes fly past the viewer."}, {960, 600});
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        spikes_pipeline pipeline(program.create_canvas(), program.seed(), spike_kind{});
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
