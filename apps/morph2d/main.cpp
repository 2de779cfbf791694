// SPDX-License-Identifier: MIT
// morph2d: takes a polygon through four forms, one of them far wider than the window.
#include <l3d/polygon_2d.h>
#include <l3d/pipeline.h>
#include <l3d/polygon_2d_flatshaded.h>
#include <l3d/lesson.h>
#include <l3d/program.h>
#include <l3d/transform.h>

#include <algorithm>
#include <array>
#include <utility>

namespace {

using vertex_list = l3d_vertex_list<l3d_real>;

vertex_list form(std::initializer_list<std::array<int, 2>> corners) {
    std::vector<l3d_coordinate<l3d_real>> vertices;
    for (const auto& corner : corners)
        vertices.emplace_back(l3d_point<l3d_real>::of(corner[0], corner[1], 0));
    return vertex_list(vertices);
}

// Step 2 of 5: the application is a pipeline.
class morph2d_pipeline final : public l3d_lesson {
public:
    explicit morph2d_pipeline(l3d_canvas canvas) : l3d_lesson(std::move(canvas)) { begin(); }

private:
    static constexpr int steps = 50; // from one form to the next

    void begin() {
        last_ = 0;
        right_ = down_ = 0;
        morph_.start(forms_[0], forms_[1], steps);
    }

    void restart() override { begin(); }

    void drag(int, int, int right, int down) override {
        right_ += right;
        down_ += down;
    }

    void advance(double seconds) override {
        for (int due = ticker_.due(seconds); due > 0; --due) {
            if (morph_.step())
                continue;
            last_ = (last_ + 1) % forms_.size();
            morph_.start(forms_[last_], forms_[(last_ + 1) % forms_.size()], steps);
        }
    }

    void draw_lesson(l3d_rasterizer_2d& rasterizer) override {
        clear(rasterizer);
        // The polygon is drawn whole: the rasterizer cuts it off at the window without moving an
        // edge.
        vertex_list& vertices = morph_.list();
        for (auto& vertex : vertices.fixed()) {
            vertex.reset();
            vertex.transform(scaling(), 1);
            vertex.transform(l3d_translation<l3d_real>(right_, down_, 0), 2);
        }
        polygon_.draw(vertices, rasterizer);
    }

    /// The matrix from a picture of 320 x 200, for which the forms are made, to this one.
    l3d_matrix<l3d_real> scaling() {
        const double scale = std::min(size().width / 320.0, size().height / 200.0);
        return l3d_scaling<l3d_real>(scale, scale, 1);
    }

    const std::array<vertex_list, 4> forms_{form({{100, 100}, {200, 150}, {150, 200}, {50, 120}}),
                                            form({{100, 100}, {200, 100}, {150, 200}, {140, 200}}),
                                            form({{-100, 100}, {200, 100}, {950, 200}, {940, 200}}),
                                            form({{100, 150}, {100, 100}, {250, 200}, {100, 200}})};
    std::size_t last_ = 0;     ///< the form from which the present change began
    int right_ = 0, down_ = 0; ///< how far the user has dragged it, in pixels
    l3d_vertex_interpolator<l3d_real> morph_;
    l3d_polygon_2d_flatshaded polygon_{{0, 1, 2, 3}, l3d_rgb(0, 128, 255)};
    l3d_ticker ticker_;
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program("morph2d",
                        l3d_caption{.what = "A polygon on its way through four forms.",
                                    .teaches = "Corners go in equal steps. The third form is three "
                                               "times as wide as the window, which cuts it off.",
                                    .keys = l3d_lesson_keys("move it")},
                        {960, 600});
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        morph2d_pipeline pipeline(program.create_canvas());
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
