// SPDX-License-Identifier: MIT
// l3d_pipeline_world: moves the camera by keys, and writes the status lines.
#include "pipeline/worlds/pipeline_world.h"

#include "raster/text/font.h"

#include <algorithm>
#include <string>

namespace {

/// The step by which the key v changes the thrust. After the largest thrust, the least thrust
/// follows: 0.2, 1.2, 2.2, 0.2 in units per update of the book.
constexpr double thrust_step = 1 * l3d_book_rate;
constexpr double largest_thrust = 3 * l3d_book_rate;

constexpr double fov_step = 0.1;
constexpr double least_fov = 0.05; // 169 degrees

/// The frame rate is the mean over this number of frames.
constexpr int frames_of_mean = 64;

l3d_draw_order after(l3d_draw_order order) {
    switch (order) {
    case l3d_draw_order::by_depth:
        return l3d_draw_order::far_first;
    case l3d_draw_order::far_first:
        return l3d_draw_order::as_added;
    default:
        return l3d_draw_order::by_depth;
    }
}

constexpr std::uint32_t text_color = 0x00ffffff;
constexpr int second_line = 16;   // in pixels from the top, as in the book
constexpr int least_height = 300; // rows of a picture for each pixel of a letter's dots

} // namespace

std::vector<l3d_caption_row> l3d_world_keys() {
    return {{"drag, wheel", "look around, fly"},
            {"space", "stop the world, let it go on"},
            {"r", "start again"},
            {"i, k", "fly forward and back"},
            {"s, f", "fly left and right"},
            {"e, d", "fly up and down"},
            {"j, l", "turn left and right"},
            {"I, K", "pitch"},
            {"J, L", "roll"},
            {"v", "more or less thrust"},
            {"X, x", "width of the view"},
            {"Y, y", "height of the view"},
            {"0, 1", "stop and start the world"},
            {"o", "by depth, far first, as added"},
            {"n", "status"}};
}

l3d_pipeline_world::l3d_pipeline_world(l3d_canvas canvas, l3d_world& world)
    : l3d_pipeline_world(canvas.rasterizers, std::move(canvas), &world, {}) {}

l3d_pipeline_world::l3d_pipeline_world(l3d_canvas canvas, maker make)
    : l3d_pipeline_world(canvas.rasterizers, std::move(canvas), nullptr, std::move(make)) {
    make_world();
}

l3d_pipeline_world::l3d_pipeline_world(std::shared_ptr<const l3d_rasterizer_factory> rasterizers,
                                       l3d_canvas&& canvas, l3d_world* world, maker make)
    : l3d_lesson(std::move(canvas)), make_(std::move(make)), world_(world),
      rasterizers_(std::move(rasterizers)), seen_size_(size()) {}

void l3d_pipeline_world::restart() {
    if (make_)
        make_world();
}

void l3d_pipeline_world::make_world() {
    own_ = make_(size());
    world_ = own_.get();
    if (is_classic())
        return;
    if (world_->order == l3d_draw_order::far_first)
        world_->order = l3d_draw_order::by_depth;
    world_->surfaces.shade = l3d_shade::flat;
    world_->surfaces.lighting.ambient = {0.35F, 0.35F, 0.35F}; // colours show in the shade, too
    world_->surfaces.light = {-0.48, 0.6, -0.64}; // from above, from the left and from the viewer
    world_->surfaces.background = ground();
    world_->surfaces.antialias = true;
}

void l3d_pipeline_world::key_event(int key) {
    if (key == ' ')
        world_->frozen = !world_->frozen;
    else if (!turn_key(key) && !thrust_key(key) && !look_key(key))
        l3d_lesson::key_event(key);
}

void l3d_pipeline_world::drag(int, int, int right, int down) {
    world_->camera.drag(right, down, size());
}

void l3d_pipeline_world::roll(int notches) {
    world_->camera.push({.forward = double(notches)});
}

bool l3d_pipeline_world::turn_key(int key) {
    switch (key) {
    case 'j':
        world_->camera.twist({.up = -1});
        return true;
    case 'l':
        world_->camera.twist({.up = 1});
        return true;
    case 'I':
        world_->camera.twist({.right = 1});
        return true;
    case 'K':
        world_->camera.twist({.right = -1});
        return true;
    case 'J':
        world_->camera.twist({.forward = 1});
        return true;
    case 'L':
        world_->camera.twist({.forward = -1});
        return true;
    default:
        return false;
    }
}

bool l3d_pipeline_world::thrust_key(int key) {
    auto& thrust = world_->camera.thrust;
    switch (key) {
    case 'i':
        world_->camera.push({.forward = 1});
        return true;
    case 'k':
        world_->camera.push({.forward = -1});
        return true;
    case 's':
        world_->camera.push({.right = -1});
        return true;
    case 'f':
        world_->camera.push({.right = 1});
        return true;
    case 'e':
        world_->camera.push({.up = 1});
        return true;
    case 'd':
        world_->camera.push({.up = -1});
        return true;
    case 'v':
    case 'V':
        for (double* t : {&thrust.right, &thrust.up, &thrust.forward}) {
            *t += thrust_step;
            if (*t > largest_thrust)
                *t -= largest_thrust;
        }
        return true;
    default:
        return false;
    }
}

bool l3d_pipeline_world::look_key(int key) {
    const auto change = [](double& fov, double by) { fov = std::max(fov + by, least_fov); };
    switch (key) {
    case 'X':
        change(world_->camera.fovx, fov_step);
        return true;
    case 'x':
        change(world_->camera.fovx, -fov_step);
        return true;
    case 'Y':
        change(world_->camera.fovy, fov_step);
        return true;
    case 'y':
        change(world_->camera.fovy, -fov_step);
        return true;
    case 'n':
    case 'N':
        status_shown_ = !status_shown_;
        return true;
    case 'o':
        world_->order = after(world_->order);
        return true;
    case '0':
    case '1':
        world_->frozen = key == '0';
        return true;
    default:
        return false;
    }
}

void l3d_pipeline_world::resize_event(l3d_size size) {
    l3d_lesson::resize_event(size);
    world_->camera.change_size(seen_size_, size);
    seen_size_ = size;
}

void l3d_pipeline_world::advance(double seconds) {
    world_->update_all(seconds);
    seconds_ += seconds;
    if (++frames_ == frames_of_mean) {
        frame_rate_ = frames_ / std::max(seconds_, 1e-9);
        frames_ = 0;
        seconds_ = 0;
    }
}

void l3d_pipeline_world::draw_lesson(l3d_rasterizer_2d& rasterizer) {
    l3d_world_target target{rasterizer, screen().pixels()};
    if (world_->order == l3d_draw_order::by_depth) {
        if (!surfaces_) {
            workers_ = std::make_unique<l3d_workers>(world_->surfaces.threads);
            surfaces_ = rasterizers_->create_surface(*workers_);
        }
        target.surfaces = surfaces_.get();
        target.workers = workers_.get();
    } else {
        set_ground(world_->surfaces.background);
        clear(rasterizer);
    }
    drawn_ = world_->draw_all(target);
    draw_overlay(rasterizer);
    if (status_shown_ && (is_classic() || !make_))
        draw_status(rasterizer);
}

std::vector<std::string> l3d_pipeline_world::status() const {
    const auto whole = static_cast<long>(frame_rate_ + 0.5);
    return {"FPS " + std::to_string(whole), std::to_string(drawn_) + " polys drawn"};
}

void l3d_pipeline_world::draw_status(l3d_rasterizer_2d& rasterizer) {
    const int scale = std::max(1, size().height / least_height);
    int y = 0;
    for (const std::string& line : status()) {
        l3d_draw_text(rasterizer, 0, y, line, text_color, scale);
        y += scale * second_line;
    }
}

std::string l3d_pipeline_world::message() const {
    std::string lines;
    const auto add = [&](const std::string& line) { lines += (lines.empty() ? "" : "\n") + line; };
    if (status_shown_ && make_ && !is_classic())
        for (const std::string& line : status())
            add(line);
    if (world_->frozen)
        add("the world is stopped; space lets it go on");
    if (drawn_ == 0 && make_)
        add("nothing is seen from here; r starts again");
    return lines;
}
