// SPDX-License-Identifier: MIT
// rotspikes: spikes that tumble about all three axes while they fly past the viewer.
#include "../spikes/spikes_pipeline.h"
#include <l3d/program.h>

// Step 2 of 5: the application is a pipeline, that of spikes; these tumble.
int main(int argc, char** argv) {
    l3d_program program("rotspikes", l3d_caption{"Spikes tumble and fly past the viewer."},
                        {960, 600});
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        spikes_pipeline pipeline(program.create_canvas(), program.seed(),
                                 spike_kind{.fastest_turn = 8});
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
