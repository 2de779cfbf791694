// SPDX-License-Identifier: MIT
// drawdot: a dot that moves and leaves a trail; the smallest program.
#include <l3d/pipeline_2d.h>
#include <l3d/program.h>

#include <algorithm>
#include <vector>

namespace {

// Step 2 of 5: the application is a pipeline.
class drawdot_pipeline final : public l3d_pipeline_2d {
public:
    using l3d_pipeline_2d::l3d_pipeline_2d;

    void key_event(int key) override {
        l3d_pipeline_2d::key_event(key);
        if ((key >= 'h' && key <= 'l' && key != 'i') || key == 'p' || key == ' ')
            turn((key == 'l') - (key == 'h'), (key == 'j') - (key == 'k'));
    }

    void resize_event(l3d_size size) override {
        l3d_pipeline_2d::resize_event(size);
        turn(right_, down_); // what is outside now starts again from the border
    }

    void update_event(double seconds) override {
        const double step = 60 * seconds; // one pixel per frame, unless --fps says otherwise
        x_ = std::clamp(x_ + right_ * step, 0.0, size().width - 1.0);
        y_ = std::clamp(y_ + down_ * step, 0.0, size().height - 1.0);
        l3d_line_2d& line = trail_.back();
        moved_ |= line.x1 != static_cast<int>(x_) || line.y1 != static_cast<int>(y_);
        line = {line.x0, line.y0, static_cast<int>(x_), static_cast<int>(y_)};
    }

    bool needs_redraw() const override { return moved_; }
    bool is_at_rest() const override { return right_ == 0 && down_ == 0; }

private:
    void draw(l3d_rasterizer_2d& rasterizer) override {
        rasterizer.draw_lines(trail_, l3d_screen_info::ext_to_native(0, 255, 128));
        moved_ = false;
    }

    void turn(int right, int down) {
        right_ = right;
        down_ = down;
        trail_.push_back({trail_.back().x1, trail_.back().y1, trail_.back().x1, trail_.back().y1});
    }

    double x_ = 0, y_ = 0;
    int right_ = 1, down_ = 0;
    std::vector<l3d_line_2d> trail_{{}}; // one line from turn to turn; the last one grows
    bool moved_ = false;
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program(
        "drawdot",
        l3d_caption{.what = "A dot leaves a trail.",
                    .keys = {{"h, j, k, l", "left, down, up, right"}, {"p, space", "rest"}},
                    .help = "?"},
        {640, 400});
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        drawdot_pipeline pipeline(program.create_canvas());
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
