// SPDX-License-Identifier: MIT
// xform: piles up lines, and triangles that are thrown about the window and clipped by it.
#include "pile_pipeline.h"
#include <l3d/polygon_2d_flatshaded.h>
#include <l3d/program.h>

namespace {

// Step 2 of 5: the application is a pipeline.
class xform_pipeline final : public pile_pipeline {
public:
    using pile_pipeline::pile_pipeline;

private:
    /// Draws a triangle anywhere in or near the window, and a line from the window's corner. Half
    /// of the range of the triangle's place is outside, so that there is something to clip.
    void draw_one(l3d_rasterizer_2d& rasterizer, l3d_random& random, std::uint32_t color) override {
        const auto [width, height] = size();
        const int right = random.between(-width, width * 7 / 8);
        const int down = random.between(-height * 5 / 6, height * 5 / 6);
        const int x = random.between(0, width * 5 / 6);
        const int y = random.between(0, height * 4 / 5);
        draw_moved(rasterizer, right, down, color);
        rasterizer.draw_line(0, 0, x, y, color);
    }

    void draw_at(l3d_rasterizer_2d& rasterizer, int x, int y, std::uint32_t color) override {
        constexpr int middle_x = 157, middle_y = 123; // the mean of the triangle's corners
        draw_moved(rasterizer, x - middle_x, y - middle_y, color);
    }

    void draw_moved(l3d_rasterizer_2d& rasterizer, int right, int down, std::uint32_t color) {
        vertices_.clear_varying();
        for (auto& vertex : vertices_.fixed()) {
            vertex.reset();
            vertex.transform(l3d_translation<l3d_real>(right, down, 0), 1);
        }
        const auto [width, height] = size();
        const auto window = l3d_window_corners(position(0, 0), position(width, height));
        triangle_.init_clip_ivertices();
        triangle_.final_color = color;
        if (triangle_.clip_to_polygon_2d(vertices_, window))
            triangle_.draw(vertices_, rasterizer);
    }

    static l3d_position<l3d_real> position(double x, double y) {
        return {l3d_from_double<l3d_real>(x), l3d_from_double<l3d_real>(y)};
    }
    static l3d_coordinate<l3d_real> vertex(double x, double y) {
        return l3d_coordinate<l3d_real>(l3d_point<l3d_real>::of(x, y, 0));
    }

    l3d_vertex_list<l3d_real> vertices_{{vertex(100, 100), vertex(300, 150), vertex(70, 120)}};
    l3d_polygon_2d_flatshaded triangle_{{0, 1, 2}, 0};
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program("xform",
                        l3d_caption{.what = "Triangles that the window clips, and lines, pile up.",
                                    .teaches = "A polygon is cut at one side of the window after "
                                               "the other, before it is drawn.",
                                    .keys = l3d_lesson_keys("more of them, there")},
                        {640, 480});
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        xform_pipeline pipeline(program.create_canvas(), program.seed());
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
