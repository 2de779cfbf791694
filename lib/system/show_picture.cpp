// SPDX-License-Identifier: MIT
// l3d_show_picture: a program of one pipeline that draws one image.
#include "system/show_picture.h"

#include "raster/images/placed_image.h"
#include "system/program.h"

#include <algorithm>
#include <array>

namespace {

class picture_pipeline final : public l3d_pipeline_2d {
public:
    picture_pipeline(l3d_canvas canvas, const l3d_pixels& picture)
        : l3d_pipeline_2d(std::move(canvas)), picture_(picture) {}

    bool is_at_rest() const override { return true; }
    bool needs_redraw() const override { return false; }

private:
    void draw(l3d_rasterizer_2d& rasterizer) override {
        const double width = picture_.width, height = picture_.height;
        const double scale = std::min(size().width / width, size().height / height);
        rasterizer.clear_buffer();
        rasterizer.draw_image(
            {.pixels = picture_,
             .place = l3d_placement_2d::image_in_box(
                 picture_.size(), (size().width - scale * width) / 2,
                 (size().height - scale * height) / 2, scale * width, scale * height)});
    }

    const l3d_pixels picture_;
};

} // namespace

int l3d_show_picture(const l3d_pixels& picture, const std::string& name) {
    l3d_program program(name, "Shows a picture.", picture.size());
    program.options().prefer_backend("auto");
    const std::array arguments{name.c_str()};
    return program.show<picture_pipeline>(static_cast<int>(arguments.size()), arguments.data(),
                                          picture);
}
