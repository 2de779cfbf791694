// SPDX-License-Identifier: MIT
// l3d_pipeline_afd: draws contours, creases and borders, the hidden ones dashed.
#include "pipeline/afd/pipeline_afd_p.h"

#include "pipeline/wire_p.h"
#include "scene/line_drawing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

/// Hidden lines are drawn with dashes and gaps of these lengths. Units: pixels.
constexpr double dash = 5, gap = 4;

std::int32_t in_subpixels(double pixels) {
    return static_cast<std::int32_t>(std::lround(pixels * l3d_subpixel_one));
}

/// Cuts the curves of a line drawing into straight wires, and hidden curves into dashes.
class wires_of_lines {
public:
    explicit wires_of_lines(const l3d_shading& shading) : shading_(shading) {}

    void add(const l3d_drawn_line& line) {
        double along = 0;
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
            const l3d_drawn_place &a = line.points[i], &b = line.points[i + 1];
            const double length = std::hypot(b.x - a.x, b.y - a.y);
            if (line.is_seen)
                add(a, b);
            else
                add_dashes(a, b, along, length);
            along += length;
        }
    }
    const std::vector<l3d_detail::wire>& all() const { return wires_; }

private:
    void add_dashes(const l3d_drawn_place& a, const l3d_drawn_place& b, double along,
                    double length) {
        for (double from = 0; from < length;) {
            const double in_period = std::fmod(along + from, dash + gap);
            const bool is_dash = in_period < dash;
            const double to =
                std::min(length, from + std::max((is_dash ? dash : dash + gap) - in_period, 1e-6));
            if (is_dash)
                add(between(a, b, from / length), between(a, b, to / length));
            from = to;
        }
    }

    static l3d_drawn_place between(const l3d_drawn_place& a, const l3d_drawn_place& b, double t) {
        return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.depth + (b.depth - a.depth) * t};
    }

    float depth_of(double distance) const {
        const double step = shading_.depth_step;
        return static_cast<float>(step == 0 ? 1 / distance : shading_.depth_base + step * distance);
    }

    void add(const l3d_drawn_place& a, const l3d_drawn_place& b) {
        wires_.push_back({in_subpixels(a.x), in_subpixels(a.y), in_subpixels(b.x),
                          in_subpixels(b.y), depth_of(a.depth), depth_of(b.depth)});
    }

    const l3d_shading& shading_;
    std::vector<l3d_detail::wire> wires_;
};

} // namespace

/// Draws contours, creases and borders in place of surfaces. Such lines have no depth, so the depth
/// buffer is cleared, as for a wireframe.
void l3d_pipeline_afd::draw_drawing(const l3d_shading& shading) {
    untouched_ = false;
    if (wants_depth()) {
        depth_.resize(stages_->view.size);
        depth_.clear();
    }
    const double tolerance = std::clamp(settings_.tolerance, l3d_line_settings::least_tolerance,
                                        l3d_line_settings::most_tolerance);
    const l3d_line_drawing drawn =
        l3d_draw_lines(scene_, camera_, stages_->view.size, {.tolerance = tolerance});
    // Lines wider than a pixel become one path, which covers joints once.
    constexpr double width = 1.25;
    l3d_detail::wire_picture picture(rasterizer_, screen_->pixels(), shading, settings_.antialias,
                                     width * std::max(1.0, screen_->text_scale()));
    wires_of_lines wires(shading);
    for (const l3d_drawn_line& line : drawn.lines)
        wires.add(line);
    picture.draw(wires.all());
    picture.finish();
    report_.dice = {};
    report_.dice.drawn = drawn.lines.empty() ? 0 : scene_.patch_count();
    report_.dice.bound_px = drawn.bound;
    report_.curved_px = 0;
    report_.renderer = {};
    report_.surface = {};
    report_.outline_pixels = l3d_surface_counts::none_counted;
    report_.pixels_kept = 0;
}
