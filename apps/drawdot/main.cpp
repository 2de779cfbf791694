// SPDX-License-Identifier: MIT
// drawdot: a dot that moves and leaves a trail; the smallest program.
#include "pipeline/pipeline.h"
#include "raster/rasterizer_2d.h"
#include "system/dispatcher.h"
#include "system/factory_manager.h"
#include "system/options.h"

#include <algorithm>
#include <vector>

namespace {

// Step 2 of 5: the application is a pipeline.
class drawdot_pipeline final : public l3d_pipeline {
public:
    drawdot_pipeline(const l3d_factory_manager& factories, const l3d_screen_request& request)
        : screen_(factories.create_screen(request)),
          imp_(factories.create_rasterizer(screen_->pixels())), rasterizer_(*imp_) {}
    l3d_screen& screen() { return *screen_; }

    void key_event(int key) override {
        done |= key == 'q' || key == l3d_key_escape;
        if ((key >= 'h' && key <= 'l' && key != 'i') || key == 'p' || key == ' ')
            turn((key == 'l') - (key == 'h'), (key == 'j') - (key == 'k'));
    }

    void resize_event(l3d_size) override {
        imp_->set_target(screen_->pixels());
        turn(right_, down_); // what is outside now starts again from the border
    }

    void update_event(double seconds) override {
        const double step = 60 * seconds; // one pixel per frame, unless --fps says otherwise
        const l3d_size size = screen_->pixels().size();
        x_ = std::clamp(x_ + right_ * step, 0.0, size.width - 1.0);
        y_ = std::clamp(y_ + down_ * step, 0.0, size.height - 1.0);
        l3d_line_2d& line = trail_.back();
        moved_ |= line.x1 != static_cast<int>(x_) || line.y1 != static_cast<int>(y_);
        line = {line.x0, line.y0, static_cast<int>(x_), static_cast<int>(y_)};
    }

    bool needs_redraw() const override { return moved_; }
    void draw_event() override {
        rasterizer_.draw_lines(trail_, l3d_screen_info::ext_to_native(0, 255, 128));
        rasterizer_.finish();
        moved_ = false;
    }

private:
    void turn(int right, int down) {
        right_ = right;
        down_ = down;
        trail_.push_back({trail_.back().x1, trail_.back().y1, trail_.back().x1, trail_.back().y1});
    }

    std::unique_ptr<l3d_screen> screen_;
    std::unique_ptr<l3d_rasterizer_2d_imp> imp_;
    l3d_rasterizer_2d rasterizer_;
    double x_ = 0, y_ = 0;
    int right_ = 1, down_ = 0;
    std::vector<l3d_line_2d> trail_{{}}; // one line from turn to turn; the last one grows
    bool moved_ = false;
};

} // namespace

int main(int argc, char** argv) try {
    l3d_options options("drawdot", "A dot leaves a trail. Keys: h j k l, p, F11, q.", {320, 200});
    l3d_factory_manager factories; // step 1: choose factories
    if (!options.parse(argc, argv) || !factories.choose(options))
        return 0;
    const auto dispatcher = factories.create_dispatcher(options.frame_settings()); // step 3
    drawdot_pipeline pipeline(factories, options.screen_request());
    dispatcher->plug(pipeline, pipeline.screen());     // step 4
    return l3d_report("drawdot", dispatcher->start()); // step 5
} catch (const std::exception& error) {
    return l3d_report("drawdot", error);
}
