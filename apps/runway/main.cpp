// SPDX-License-Identifier: MIT
// runway: moves three rows of dots at different speeds, which look like depth and are not.
#include "../dots/dot.h"

#include <l3d/lesson.h>
#include <l3d/pipeline.h>
#include <l3d/program.h>

namespace {

/// Dots at the same height, which seem to be at the same distance.
struct row {
    int y, spacing, updates_per_pixel;
};

/// Units: pixels of a picture of 320 x 200.
constexpr row rows[] = {{180, 20, 1}, {140, 10, 2}, {120, 7, 4}};

// Step 2 of 5: the application is a pipeline.
class runway_pipeline final : public l3d_lesson {
public:
    using l3d_lesson::l3d_lesson;

private:
    void advance(double seconds) override { updates_ += ticker_.due(seconds); }
    void restart() override { updates_ = 0; }

    /// Moves the rows so that the nearest one follows the pointer.
    void drag(int, int, int right, int) override {
        dragged_ -= right;
        updates_ += dragged_ / dot_side(size());
        dragged_ %= dot_side(size());
    }

    void draw_lesson(l3d_rasterizer_2d& rasterizer) override {
        const int side = dot_side(size()), width = size().width / side;
        const double drawn_side = is_classic() ? side : smooth_dot_side(size());
        clear(rasterizer);
        for (const row& r : rows)
            for (int x = 0; x + r.spacing <= width; x += r.spacing)
                draw_dot(rasterizer, side * moved(x, r, width), side * r.y, drawn_side, 0xffffff);
    }

    /// The column of a dot after the picture has moved to the left. A dot that leaves comes in
    /// again from the right.
    int moved(int x, const row& r, int width) const {
        const auto gone = static_cast<int>(updates_ / r.updates_per_pixel % width);
        return ((x - gone) % width + width) % width;
    }

    l3d_ticker ticker_;
    long updates_ = 0;
    int dragged_ = 0; ///< pixels dragged to the left that do not yet make a whole update
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program(
        "runway",
        l3d_caption{.what = "Dots in three rows of different speeds look like a plain.",
                    .teaches = "No third dimension is computed: that far things "
                               "seem slower is enough for the eye.",
                    .keys = l3d_lesson_keys("move the rows")},
        {960, 600});
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        runway_pipeline pipeline(program.create_canvas());
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
