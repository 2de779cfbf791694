// SPDX-License-Identifier: MIT
// l3d_program: runs a program's steps, from its options to its way out.
#include "system/program.h"

#include "system/load_window_p.h"
#include "raster/rasterizer_factory.h"
#include "raster/placement_2d.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <string>
#include <utility>

l3d_program::l3d_program(std::string name, const std::string& purpose, l3d_size default_size)
    : options_(std::move(name), purpose, default_size) {}

l3d_program::l3d_program(std::string name, const l3d_caption& caption, l3d_size default_size)
    : options_(std::move(name), caption.text(), default_size), caption_(caption) {
    if (!caption_.teaches.empty())
        options_.add("--classic", is_classic_,
                     "pictures as in the book: hard edges, letters of dots, a black ground");
}

int l3d_program::run(int argc, const char* const* argv, const std::function<l3d_exit()>& steps) {
    options_.watch_loads(
        [window = std::make_shared<l3d_detail::load_window>(factories_, options_)](
            const std::string& file, double share) { return window->goes_on(file, share); });
    try {
        if (!options_.parse(argc, argv) || !goes_on_() || !factories_.choose(options_))
            return static_cast<int>(l3d_exit::success);
        return l3d_report(options_.command(), steps());
    } catch (const std::exception& error) {
        return l3d_report(options_.command(), error);
    }
}

std::unique_ptr<l3d_dispatcher> l3d_program::create_dispatcher() const {
    const l3d_frame_settings settings = options_.frame_settings();
    auto dispatcher = factories_.create_dispatcher(settings);
    // Pictures that are counted or written are the same in windows and in files, so they have no
    // caption.
    if (settings.frames == 0 && settings.output.empty())
        dispatcher->set_caption(caption_);
    return dispatcher;
}

l3d_canvas l3d_program::create_canvas(const std::string& shows) const {
    l3d_screen_request request = options_.screen_request();
    if (!shows.empty() && shows != request.title && options_.common().title.empty())
        request.title = shows + " - " + request.title;
    l3d_canvas canvas{
        factories_.create_screen(request), factories_.chosen().rasterizer_factory, {}, is_classic_};
    // The canvas decides on smooth edges for the library's own rasterizers alone. Those of GL, or
    // of a program's own factory, keep their edges.
    const bool is_ours = dynamic_cast<const l3d_rasterizer_factory_sw*>(canvas.rasterizers.get());
    if (!caption_.teaches.empty() && !is_classic_ && is_ours)
        canvas.rasterizers = std::make_shared<l3d_rasterizer_factory_sw>(l3d_edges::smooth);
    // Pictures that are counted, or made without a window, use the built-in font, so that they are
    // the same on every machine.
    std::string why;
    if (canvas.screen->is_window() && options_.frame_settings().frames == 0)
        canvas.font = l3d_font::of_system(why);
    if (!why.empty())
        std::cerr << options_.command() << ": " << why << '\n';
    return canvas;
}

void l3d_program::check_transparency(bool in_window) const {
    const auto refuse = [](const std::string& why) {
        throw l3d_error(l3d_exit::usage, "--background: none " + why);
    };
    if (in_window)
        refuse("is for files, and a window was asked for; --backend memory --output FILE.png "
               "writes one");
    if (draws_by_gl())
        refuse("is not drawn by --backend mesa; --backend memory draws it");
}

bool l3d_program::draws_by_gl() const {
    return dynamic_cast<const l3d_rasterizer_factory_mesa*>(
        factories_.chosen().rasterizer_factory.get());
}

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
