// SPDX-License-Identifier: MIT
// l3d_pipeline_2d: keeps the screen and the rasterizer, and handles new sizes and the end.
#include "pipeline/pipeline_2d.h"

#include <utility>

l3d_pipeline_2d::l3d_pipeline_2d(l3d_canvas canvas)
    : screen_(std::move(canvas.screen)), font_(std::move(canvas.font)),
      imp_(canvas.rasterizers->create_2d(screen_->pixels())), rasterizer_(*imp_) {}

void l3d_pipeline_2d::key_event(int key) {
    done |= key == 'q' || key == l3d_key_escape;
}

void l3d_pipeline_2d::resize_event(l3d_size) {
    imp_->set_target(screen_->pixels());
    rasterizer_.clear_buffer();
}

void l3d_pipeline_2d::draw_event() {
    draw(rasterizer_);
    rasterizer_.finish();
}
