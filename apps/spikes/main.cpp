// SPDX-License-Identifier: MIT
// spikes: polygons in space that share vertices, flying past the viewer.
#include "pipeline/world.h"
#include "spike.h"
#include "system/program.h"

namespace {

// Step 2 of 5: the application is a pipeline.
class spikes_pipeline final : public l3d_pipeline_2d {
public:
    spikes_pipeline(l3d_canvas canvas, std::uint64_t seed)
        : l3d_pipeline_2d(std::move(canvas)), random_(seed), world_(size()) {
        world_.camera.place = l3d_point<l3d_real>::of(0, 0, 0);
        world_.camera.near_z = 1;
        world_.camera.far_z = 2000;
        for (int i = 0; i < 150; ++i)
            world_.objects.push_back(std::make_unique<spike>(spike_kind{}, random_));
    }

    void update_event(double seconds) override { world_.update_all(seconds); }

    void resize_event(l3d_size size) override {
        l3d_pipeline_2d::resize_event(size);
        world_.camera.fovy = world_.camera.fovx * size.width / size.height;
    }

private:
    void draw(l3d_rasterizer_2d& rasterizer) override {
        rasterizer.clear_buffer();
        world_.draw_all(rasterizer, size());
    }

    l3d_random random_;
    l3d_world world_;
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program("spikes", "Spikes fly past. Keys: F11, q.", {320, 200});
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        spikes_pipeline pipeline(program.create_canvas(), program.seed());
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
