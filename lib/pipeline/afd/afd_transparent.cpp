// SPDX-License-Identifier: MIT
// l3d_pipeline_afd: mixes pictures with and without the transparent instances.
#include "pipeline/afd/pipeline_afd_p.h"

#include "pipeline/stopwatch_p.h"
#include "scene/drawn_pixels.h"
#include "scene/lit_shade_bound.h"
#include "tool_2d/pixel_boxes.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace {

using l3d_detail::stopwatch;

/// A box of the picture, and a bit for each transparent instance that may be seen in this box.
struct cell {
    l3d_pixel_box box;
    unsigned instances = 0;
};

/// Divides the given boxes into disjoint cells. Bit i of a cell is set if box i holds the cell.
std::vector<cell> cells_of(const std::vector<l3d_pixel_box>& boxes) {
    std::vector<std::int32_t> columns, rows;
    for (const l3d_pixel_box& box : boxes) {
        if (box.empty())
            continue;
        columns.insert(columns.end(), {box.left, box.right});
        rows.insert(rows.end(), {box.top, box.bottom});
    }
    std::ranges::sort(columns);
    std::ranges::sort(rows);
    std::vector<cell> result;
    for (std::size_t r = 0; r + 1 < rows.size(); ++r) {
        const std::size_t first = result.size();
        for (std::size_t c = 0; c + 1 < columns.size(); ++c) {
            const l3d_pixel_box here{columns[c], rows[r], columns[c + 1], rows[r + 1]};
            unsigned instances = 0;
            for (std::size_t i = 0; i < boxes.size(); ++i)
                if (!here.intersected(boxes[i]).empty())
                    instances |= 1U << i;
            if (here.empty() || instances == 0)
                continue;
            const bool goes_on = result.size() > first && result.back().instances == instances &&
                                 result.back().box.right == here.left;
            if (goes_on)
                result.back().box.right = here.right;
            else
                result.push_back({here, instances});
        }
    }
    return result;
}

} // namespace

/// Draws transparent instances, as the mean of several pictures, weighted by their probabilities.
/// In each of these pictures, a transparent instance is either opaque or absent. An instance's
/// opacity is the probability that the instance is there. So nothing needs to be sorted, and
/// surfaces may pass through each other.
void l3d_pipeline_afd::draw_transparent(const basis& now, l3d_stage_times& times) {
    std::vector<std::size_t> opaque, transparent;
    const auto instances = scene_.instances();
    for (std::size_t i = 0; i < instances.size(); ++i)
        if (instances[i].opacity() == 1)
            opaque.push_back(i);
        else if (instances[i].opacity() > 0)
            transparent.push_back(i);
    const l3d_pixel_box whole = l3d_whole(now.target.size());
    draw_surfaces(now, {scene_.only(opaque), now.target, whole}, times);

    std::vector<l3d_pixel_box> boxes;
    const bool by_parts = stages_->method->draws_parts();
    for (const std::size_t i : transparent) {
        l3d_box_lanes box;
        box.add(instances[i].box());
        l3d_pixel_boxes reached;
        l3d_drawn_pixels(box, stages_->transform.matrix(), stages_->view, reached);
        boxes.push_back(by_parts ? reached.around().grown(now.shading.reach()).intersected(whole)
                                 : whole);
    }
    if (stages_->mixed.pixels().size() != now.target.size())
        stages_->mixed = l3d_image(now.target.size(), l3d_padded_stride(now.target.width));
    const l3d_pixels mixed = stages_->mixed.pixels();
    for (const cell& c : cells_of(boxes)) {
        stages_->mix.begin(c.box);
        for (unsigned seen = 0; seen <= c.instances; ++seen) {
            if ((seen & ~c.instances) != 0)
                continue;
            double weight = 1;
            std::vector<std::size_t> with = opaque;
            for (std::size_t i = 0; i < transparent.size(); ++i) {
                const double opacity = instances[transparent[i]].opacity();
                if (seen >> i & 1)
                    with.push_back(transparent[i]);
                if (c.instances >> i & 1)
                    weight *= seen >> i & 1 ? opacity : 1 - opacity;
            }
            std::ranges::sort(with);
            if (seen != 0)
                draw_surfaces(now, {scene_.only(with), mixed, c.box}, times);
            const stopwatch mixing;
            stages_->mix.add(seen == 0 ? now.target : mixed, static_cast<float>(weight),
                             stages_->workers);
            times.raster += mixing.milliseconds();
        }
        const stopwatch writing;
        stages_->mix.write(now.target, stages_->workers);
        times.raster += writing.milliseconds();
    }

    // The depth is that of the nearest surface, as if all surfaces were opaque.
    if (wants_depth())
        draw_surfaces(now, {what_is_there(), mixed, whole, true}, times);
}

/// The scene without the instances of opacity 0, which are not seen.
l3d_patch_scene l3d_pipeline_afd::what_is_there() const {
    std::vector<std::size_t> there;
    for (std::size_t i = 0; i < scene_.instances().size(); ++i)
        if (scene_.instances()[i].opacity() > 0)
            there.push_back(i);
    return scene_.only(there);
}

/// Bounds the error of a picture that is the mean light of several pictures, in shade levels of 0
/// to 255. `of_each` is the bound of each of these pictures' errors. The result is 4/3 of `of_each`
/// (NUMERICS, section 22), and one rounding more.
double l3d_pipeline_afd::shade_bound_of_mix(double of_each) {
    constexpr double most_steep = 4.0 / 3, rounding = 0.51;
    return most_steep * of_each + rounding;
}

/// Bound of the error that fog adds, in shade levels of 0 to 255. A drawn surface is nowhere
/// farther from the exact surface than the bound of depth, in pixels at the surface's distance. The
/// amount of fog is rounded to whole 255ths. Its products with the two colours that are mixed are
/// rounded to whole levels.
double l3d_pipeline_afd::shade_bound_of_fog() const {
    const l3d_fog& fog = settings_.fog;
    if (!fog.is_on())
        return 0;
    constexpr double white = 255, rounding = 0.5 + 0.5 + 0.5 + 0.01;
    const l3d_size size = stages_->view.size;
    const double far = double{fog.to}, off = report_.dice.depth_bound_px;
    const double most_off = camera_.is_parallel() ? off / camera_.scale_at_target(size)
                                                  : off * far / camera_.focal_length(size);
    return white * most_off / (far - double{fog.from}) + rounding;
}

/// Bound of the error of shades under lights. A pixel's shade belongs to an exact point that is off
/// by at most the bound of places. So the direction of the eye's ray may be off by an angle, which
/// is largest in the picture's middle. In a parallel projection this angle is 0, since all rays
/// have one direction.
double l3d_pipeline_afd::shade_bound_of_lights(const l3d_shading& shading) const {
    const l3d_size size = stages_->view.size;
    return l3d_lit_shade_bound(
        shading, scene_.materials(), size,
        {.normal = report_.dice.normal_off + report_.surface.normal_error,
         .way = camera_.is_parallel() ? 0 : report_.dice.bound_px / camera_.focal_length(size)});
}
