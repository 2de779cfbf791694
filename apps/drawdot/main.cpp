// SPDX-License-Identifier: MIT
// drawdot: moves a dot that leaves a trail. It is the smallest program.
#include <l3d/lesson.h>
#include <l3d/program.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace {

// Step 2 of 5: the application is a pipeline.
class drawdot_pipeline final : public l3d_lesson {
public:
    explicit drawdot_pipeline(l3d_canvas canvas) : l3d_lesson(std::move(canvas)) { restart(); }

    void key_event(int key) override {
        if ((key >= 'h' && key <= 'l' && key != 'i') || key == 'p' || key == ' ')
            turn((key == 'l') - (key == 'h'), (key == 'j') - (key == 'k'));
        else
            l3d_lesson::key_event(key);
    }

    void resize_event(l3d_size size) override {
        l3d_lesson::resize_event(size);
        turn(right_, down_); // dots that are outside now begin again at the border
    }

    bool needs_redraw() const override { return moved_; }
    bool is_at_rest() const override { return right_ == 0 && down_ == 0; }

private:
    void restart() override {
        x_ = is_classic() ? 0 : size().width / 2;
        y_ = is_classic() ? 0 : size().height / 2;
        right_ = 1;
        down_ = 0;
        start_line();
        trail_.erase(trail_.begin(), trail_.end() - 1);
    }

    void advance(double seconds) override {
        const double step = 60 * seconds; // one pixel per frame at 60 frames a second
        x_ = std::clamp(x_ + right_ * step, 0.0, size().width - 1.0);
        y_ = std::clamp(y_ + down_ * step, 0.0, size().height - 1.0);
        l3d_line_2d& line = trail_.back();
        moved_ |= line.x1 != static_cast<int>(x_) || line.y1 != static_cast<int>(y_);
        line = {line.x0, line.y0, static_cast<int>(x_), static_cast<int>(y_)};
    }

    /// Puts the dot where the pointer is. From there it goes on.
    void drag(int x, int y, int, int) override {
        x_ = x;
        y_ = y;
        start_line();
    }

    void draw_lesson(l3d_rasterizer_2d& rasterizer) override {
        moved_ = false;
        if (!is_classic())
            clear(rasterizer); // else smooth edges would add up
        const std::uint32_t green = l3d_rgb(0, 255, 128);
        const double pen = std::floor(size().height / 128.0); // visible in large windows, too
        if (pen < 2)
            return rasterizer.draw_lines(trail_, green);
        for (const l3d_line_2d& line : trail_)
            draw_box(rasterizer, line, pen / 2, green);
        const l3d_line_2d& last = trail_.back();
        draw_box(rasterizer, {last.x1, last.y1, last.x1, last.y1}, 1.5 * pen, 0xffffff);
    }

    /// Draws all pixels within a distance of an upright or horizontal line.
    static void draw_box(l3d_rasterizer_2d& rasterizer, const l3d_line_2d& line, double reach,
                         std::uint32_t color) {
        const auto [left, right] = std::minmax(line.x0, line.x1);
        const auto [top, bottom] = std::minmax(line.y0, line.y1);
        const double l = left + 0.5 - reach, r = right + 0.5 + reach;
        const double t = top + 0.5 - reach, b = bottom + 0.5 + reach;
        const l3d_point_2d corners[] = {{l, t}, {r, t}, {r, b}, {l, b}};
        rasterizer.draw_polygon_flatshaded(corners, color);
    }

    void turn(int right, int down) {
        right_ = right;
        down_ = down;
        start_line();
    }

    void start_line() {
        const int x = static_cast<int>(x_), y = static_cast<int>(y_);
        trail_.push_back({x, y, x, y});
        moved_ = true;
    }

    double x_ = 0, y_ = 0;
    int right_ = 1, down_ = 0;
    std::vector<l3d_line_2d> trail_; // one line from turn to turn; the last one grows
    bool moved_ = true;
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program(
        "drawdot",
        l3d_caption{.what = "A dot leaves a trail. Draw with the mouse, or steer by h, j, k, l.",
                    .teaches = "The smallest program: five steps, and a pipeline that is told of "
                               "keys, of time, and when to draw.",
                    .keys = {{"drag", "draw"},
                             {"h, j, k, l", "left, down, up, right"},
                             {"p, space", "rest"},
                             {"r", "start again"}},
                    .help = "?"},
        {640, 400});
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        drawdot_pipeline pipeline(program.create_canvas());
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
