// SPDX-License-Identifier: MIT
// mesaflat: piles up triangles, drawn by software GL unless told otherwise.
#include "../xform/pile_pipeline.h"
#include <l3d/program.h>

#include <array>

namespace {

// Step 2 of 5: the application is a pipeline.
class mesaflat_pipeline final : public pile_pipeline {
public:
    using pile_pipeline::pile_pipeline;

private:
    void draw_one(l3d_rasterizer_2d& rasterizer, l3d_random& random, std::uint32_t color) override {
        const double x = random.between(0, size().width - 1);
        const double y = random.between(0, size().height - 1);
        draw_from(rasterizer, x, y, color);
    }

    void draw_at(l3d_rasterizer_2d& rasterizer, int x, int y, std::uint32_t color) override {
        draw_from(rasterizer, x - 57, y - 37, color); // (57, 37) is the mean of its corners
    }

    static void draw_from(l3d_rasterizer_2d& rasterizer, double x, double y, std::uint32_t color) {
        const std::array<l3d_point_2d, 3> corners{{{x, y}, {x + 100, y + 10}, {x + 70, y + 100}}};
        rasterizer.draw_polygon_flatshaded(corners, color);
    }
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program("mesaflat",
                        l3d_caption{.what = "Triangles, drawn by software GL, pile up.",
                                    .teaches = "The same five steps draw by another library: only "
                                               "the factories differ.",
                                    .keys = l3d_lesson_keys("more of them, there")},
                        {640, 480});
    program.options().prefer_backend("mesa");
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        mesaflat_pipeline pipeline(program.create_canvas(), program.seed());
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
