// SPDX-License-Identifier: MIT
// l3d_pipeline_afd: runs the stages of a frame.
#include "pipeline/afd/pipeline_afd_p.h"

#include "pipeline/surface_method.h"
#include "raster/pixel_bits.h"
#include "raster/parallel/workers.h"
#include "scene/camera_shading.h"
#include "scene/drawn_pixels.h"
#include "dice/certificate/frame_doubts.h"
#include "dice/edges/edge_polyline.h"
#include "dice/frame_dicer.h"
#include "scene/image_transform.h"
#include "scene/culling/scene_culling.h"
#include "pipeline/stopwatch_p.h"
#include "pipeline/wire_lines_p.h"
#include "raster/parallel/simd_target.h"
#include "base/error.h"
#include "tool_2d/pixel_boxes.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace {

/// The factor by which frames with the map of errors ask for more exact normals of curved models.
/// It makes these models two levels finer. The map tells folds only as exactly as normals are
/// known, and otherwise doubts whole tiles. One level finer suffices for spheres and tori, two for
/// a hull with cusps (docs/NUMERICS.md, section 25).
constexpr double finer_for_map = 8;

/// The share of the tolerance that errors of curved models may take if the scene has trims. It is
/// larger than l3d_curved_share, since trims are drawn as polygons: four times the share halves
/// their corners. Dicing gets the rest (docs/NUMERICS.md, section 27). Frames with the map of
/// errors keep l3d_curved_share, or the map would tell little near the borders of trims.
constexpr double trimmed_share = 0.25;

using l3d_detail::stopwatch;

/// The most shade levels of 0 to 255 by which a shade changes if its unit normal is off by 1
/// (NUMERICS, section 1).
constexpr double lambert_levels = 229.5;

void check_method(const l3d_method_factory& method, const l3d_patch_scene& scene) {
    if (scene.has_trims() && !method.is_default())
        throw l3d_error(l3d_exit::failure,
                        "trimmed surfaces: " + method.name() + " draws whole ones alone");
}

/// Creates the rasterizer of lines and text for a screen, after it has checked that the settings
/// can be drawn.
std::unique_ptr<l3d_rasterizer_2d_imp> create_2d(const l3d_rasterizer_factory& rasterizers,
                                                 l3d_screen& screen, const l3d_camera& camera,
                                                 const l3d_afd_settings& settings,
                                                 const l3d_patch_scene& scene) {
    check_method(settings.method, scene);
    const std::string why = l3d_afd_complaint(camera, screen.pixels().size(), settings);
    if (!why.empty())
        throw l3d_error(l3d_exit::failure, why);
    return rasterizers.create_2d(screen.pixels());
}

} // namespace

l3d_pipeline_afd::l3d_pipeline_afd(l3d_canvas canvas, l3d_patch_scene scene,
                                   const l3d_camera& camera, const l3d_afd_settings& settings)
    : screen_(std::move(canvas.screen)), font_(std::move(canvas.font)),
      rasterizers_(std::move(canvas.rasterizers)),
      imp_(create_2d(*rasterizers_, *screen_, camera, settings, scene)), rasterizer_(*imp_),
      scene_(std::move(scene)), camera_(camera), settings_(settings),
      stages_(std::make_unique<stages>(settings_, *rasterizers_)) {
    report_.frame = -1;
    report_.method = settings.method.name();
    report_.real = l3d_real_name();
    report_.threads = stages_->workers.count();
}

l3d_pipeline_afd::~l3d_pipeline_afd() = default;

std::string l3d_pipeline_afd::take_remark() {
    return stages_->workers.take_shortage();
}

void l3d_pipeline_afd::interrupt_when(std::function<bool()> wanted) {
    stages_->workers.interrupt_when(std::move(wanted));
}

void l3d_pipeline_afd::take_method(const l3d_method_factory& method) {
    check_method(method, scene_);
    stages_->method = method.create(*rasterizers_, stages_->workers);
    settings_.method = method;
    report_.method = method.name();
    if (!method.draws_parallel())
        camera_.projection = l3d_projection::perspective;
    report_.outline_pixels = l3d_surface_counts::none_counted;
    touch();
    redraw();
}

const l3d_pixel_bits* l3d_pipeline_afd::outlines() const {
    return report_.outline_pixels == l3d_surface_counts::none_counted ? nullptr
                                                                      : stages_->method->outlines();
}

const l3d_error_map* l3d_pipeline_afd::error_map() const {
    return stages_->doubts ? &stages_->doubts->map() : nullptr;
}

std::vector<float> l3d_pipeline_afd::distances() const {
    std::vector<float> result;
    for (int y = 0; y < depth_.size().height; ++y)
        for (const float there : depth_.row(y))
            result.push_back(there > 0 ? stages_->drawn.shading.distance(there)
                                       : std::numeric_limits<float>::infinity());
    return result;
}

void l3d_pipeline_afd::resize_event(l3d_size) {
    imp_->set_target(screen_->pixels());
    touch();
    redraw();
}

void l3d_pipeline_afd::draw_event() {
    const stopwatch whole;
    l3d_stage_times times;
    const std::string why =
        l3d_detail::numbers_complaint(camera_, screen_->pixels().size(), settings_);
    if (!why.empty())
        throw l3d_error(l3d_exit::failure, why);
    is_drawing_ = true;
    const basis now = begin_frame();
    const l3d_pixel_boxes parts = parts_to_draw(now);
    changed_ = parts.around();
    if (changed_.empty())
        keep_picture();
    else if (settings_.drawing)
        draw_drawing(now.shading);
    else if (settings_.wireframe)
        draw_wireframe(now.shading);
    else
        fill_surfaces(now, parts, times);
    // If the budget of a part did not suffice, the whole frame is drawn. The part may have had a
    // larger share of the budget than in a whole frame, and the rest a smaller one.
    if (report_.pixels_kept > 0 && report_.dice.unfinished > 0 && !changed_.empty()) {
        changed_ = l3d_whole(stages_->view.size);
        fill_surfaces(now, l3d_pixel_boxes(changed_), times);
    }

    if (!changed_.empty())
        find_doubts(!now.shading.is_lit(scene_.materials()) && !now.shading.fog.is_on(), times);

    const stopwatch overlaying;
    if (stale_ || !changed_.empty())
        draw_on_top(now.shading);
    times.overlay = overlaying.milliseconds();
    stages_->drawn = now;
    scene_.forget_changes();
    is_drawing_ = is_foreign_ = false;

    times.total = whole.milliseconds() - times.outlines - times.error_map;
    report_.time_ms = times;
    ++report_.frame;
    report_.simd = l3d_simd_target();
    report_.size = stages_->view.size;
    report_.tolerance_px = settings_.tolerance;
    report_.near_z = camera_.is_parallel()
                         ? camera_.near_z
                         : (report_.dice.near_z > 0 ? report_.dice.near_z : stages_->view.near) /
                               stages_->view.depth_scale;
    report_.patches = scene_.patch_count();
    stale_ = false;
}

void l3d_pipeline_afd::frame_event(const l3d_frame_times& times) {
    report_.time_ms.show = 1000 * times.show;
    report_.time_ms.write = 1000 * times.write;
}

l3d_pipeline_afd::basis l3d_pipeline_afd::begin_frame() {
    const l3d_pixels target = screen_->pixels();
    const bool is_trimmed = scene_.has_trims();
    if (is_trimmed && !settings_.method.is_default()) // other methods draw no trims
        take_method({});
    const double share = is_trimmed && !settings_.error_map ? trimmed_share : l3d_curved_share;
    stages_->curved = scene_.choose_levels(
        {.camera = camera_,
         .size = target.size(),
         .places_px = settings_.tolerance * share,
         .normals = settings_.shade_tolerance * l3d_curved_share_of_shade /
                    (settings_.error_map ? finer_for_map : 1) / lambert_levels});
    const bool is_curved = scene_.is_curved();
    stages_->transform = l3d_image_transform(camera_, target.size(), scene_);
    double of_dicing = settings_.tolerance * (is_curved ? 1 - share : 1);
    if (is_trimmed) // errors may be less than their share by a factor of up to 4
        of_dicing = std::max(of_dicing, settings_.tolerance - stages_->curved.places_px);
    stages_->view = stages_->transform.view(of_dicing);
    stages_->view.shade_tolerance =
        settings_.shade_tolerance * (is_curved ? 1 - l3d_curved_share_of_shade : 1);
    if (settings_.lateral_only)
        stages_->view.focal = 0;
    stages_->view.keep = settings_.keep;
    if (settings_.antialias) // smooth edges show surfaces between pixel centres, too
        stages_->view.keep.centreless = stages_->view.keep.dicing = true;
    stages_->view.one_sided = settings_.one_sided;
    if (settings_.section)
        stages_->view.section = stages_->transform.section(*settings_.section);
    stages_->view.most_samples = settings_.most_samples;
    const l3d_frame_lights of_frame = lights();
    l3d_shading shading = l3d_camera_shading(camera_, target.size(), settings_.shade,
                                             of_frame.light, of_frame.lighting);
    stages_->transform.set_depths(shading);
    shading.keep_unit_normals = settings_.keep.unit_normals;
    shading.antialias = settings_.antialias;
    shading.background = settings_.background;
    if (!l3d_has_scale(settings_.shade)) // while there is fog, viewers may change to such a shade
        shading.fog = settings_.fog;
    if (l3d_is_inspection(settings_.shade))
        shading.inspection = inspection();
    if (settings_.shade == l3d_shade::own)
        shading.own = &settings_.own;
    return {.target = target,
            .to_image = stages_->transform.matrix(),
            .view = stages_->view,
            .shading = shading,
            .filter = settings_.texture_filter,
            .wireframe = settings_.wireframe,
            .drawing = settings_.drawing,
            .net = settings_.net,
            .edges = settings_.edges,
            .depth = wants_depth(),
            .outlines = settings_.outlines,
            .error_map = settings_.error_map};
}

/// The parts of the picture to draw; none if the picture is right as it is. If only instances were
/// moved, there are two reasons to draw the whole picture all the same. Things that were drawn on
/// top, at unknown places, may have to go. Or the parts have three quarters of the pixels, and so
/// cost nearly as much as all pixels (docs/SPEED.md).
l3d_pixel_boxes l3d_pipeline_afd::parts_to_draw(const basis& now) {
    const l3d_pixel_boxes whole(l3d_whole(now.target.size()));
    if (settings_.keep.drawing || is_foreign_ || scene_.is_rebuilt() || now != stages_->drawn)
        return whole;
    if (!stale_ && !scene_.is_changed())
        return {};
    const bool may_differ = settings_.shade == l3d_shade::own && stale_;
    if (!untouched_ || may_differ)
        return whole;
    if (!scene_.is_changed())
        return {};
    if (wants_depth() || scene_.transparent_count() > 0 || !stages_->method->draws_parts() ||
        report_.dice.unfinished > 0)
        return whole;
    return parts_that_moved(whole.area() / 4 * 3, now.shading.reach());
}

/// Boxes around the old and new places of moved instances, grown by `reach` pixels. The result is
/// the whole picture if the boxes have more than `most` pixels.
l3d_pixel_boxes l3d_pipeline_afd::parts_that_moved(std::int64_t most, int reach) {
    const l3d_matrix<double>& to_image = stages_->transform.matrix();
    l3d_pixel_boxes parts;
    l3d_drawn_pixels(scene_.moved_from(), to_image, stages_->view, parts, most);
    if (parts.area() <= most) {
        stages_->moved_to.clear();
        for (const std::size_t index : scene_.moved())
            stages_->moved_to.add(scene_.instances()[index].box());
        l3d_drawn_pixels(stages_->moved_to, to_image, stages_->view, parts, most);
    }
    const l3d_pixel_box whole = l3d_whole(stages_->view.size);
    if (parts.area() > most)
        return l3d_pixel_boxes(whole);
    if (reach == 0)
        return parts;
    l3d_pixel_boxes reached;
    for (const l3d_pixel_box& box : parts.boxes())
        reached.add(box.grown(reach).intersected(whole));
    return reached;
}

/// Keeps the last picture, and the picture's bounds in the report, since nothing needs to be drawn.
void l3d_pipeline_afd::keep_picture() {
    l3d_dice_counts counts;
    counts.unchanged = scene_.patch_count();
    counts.bound_px = report_.dice.bound_px;
    counts.depth_bound_px = report_.dice.depth_bound_px;
    counts.shade_bound = report_.dice.shade_bound;
    counts.unproven_quads = report_.dice.unproven_quads;
    counts.near_z = report_.dice.near_z;
    counts.coarse = report_.dice.coarse;
    counts.unfinished = report_.dice.unfinished;
    counts.coarsest = report_.dice.coarsest;
    report_.dice = counts;
    report_.surface = {};
    report_.pixels_kept = l3d_whole(stages_->view.size).area();
}

void l3d_pipeline_afd::fill_surfaces(const basis& now, const l3d_pixel_boxes& parts,
                                     l3d_stage_times& times) {
    if (wants_depth())
        depth_.resize(stages_->view.size);
    report_.pixels_kept = l3d_whole(stages_->view.size).area() - parts.area();
    const l3d_dice_counts kept = report_.pixels_kept > 0 ? report_.dice : l3d_dice_counts();
    report_.dice = {};
    report_.surface = {};
    if (scene_.transparent_count() > 0)
        draw_transparent(now, times);
    else
        for (const l3d_pixel_box& part : parts.boxes())
            draw_surfaces(now, {scene_, now.target, part, wants_depth()}, times);
    const l3d_pixel_bits* const outlines =
        scene_.transparent_count() > 0 ? nullptr : stages_->method->outlines();
    report_.outline_pixels = outlines ? outlines->count() : l3d_surface_counts::none_counted;
    untouched_ = true;
    if (!stages_->method->certifies_depth() || stages_->view.focal == 0)
        report_.dice.depth_bound_px = std::numeric_limits<double>::infinity();
    report_.curved_px = stages_->curved.places_px;
    report_.dice.add_off(report_.curved_px);
    report_.dice.coarsest.bound_px += report_.curved_px;
    report_.dice.normal_off += stages_->curved.normals;
    if (stages_->method->certifies_shade(now.shading) && stages_->view.focal > 0 &&
        now.shading.lighting.point_count == 0 && !scene_.has_pictures()) {
        if (now.shading.is_lit(scene_.materials()))
            report_.dice.shade_bound = shade_bound_of_lights(now.shading);
        else
            report_.dice.shade_bound += lambert_levels * stages_->curved.normals;
        report_.dice.shade_bound += report_.surface.level_error;
        report_.dice.unproven_quads += report_.surface.unproven_levels;
        report_.dice.shade_bound += shade_bound_of_fog();
        if (scene_.transparent_count() > 0)
            report_.dice.shade_bound = shade_bound_of_mix(report_.dice.shade_bound);
    } else {
        report_.dice.shade_bound = settings_.shade == l3d_shade::own
                                       ? settings_.own.error + shade_bound_of_fog()
                                       : std::numeric_limits<double>::infinity();
    }
    // The sum may exceed the number of quads. A quad may be unproven for two reasons, and it counts
    // in each band that it reaches.
    report_.dice.unproven_quads = std::min(report_.dice.unproven_quads, report_.surface.quads);
    keep_bounds(kept);
    // Each part counts all patches of the scene. Patches that it does not touch count as unchanged,
    // and patches that reach into several parts count as drawn in each.
    const auto more = static_cast<std::int64_t>(parts.boxes().size()) - 1;
    report_.dice.unchanged =
        std::max(std::int64_t{0}, report_.dice.unchanged - more * scene_.patch_count());
}

/// Draws a scene into a part of a picture, and adds the work to the report.
void l3d_pipeline_afd::draw_surfaces(const basis& now, const drawing& of, l3d_stage_times& times) {
    const l3d_method_frame frame{.scene = of.scene,
                                 .materials = of.scene.materials(),
                                 .camera = camera_,
                                 .to_image = stages_->transform.matrix(),
                                 .view = stages_->view,
                                 .shading = now.shading,
                                 .target = of.target,
                                 .depth = depth_,
                                 .wants_depth = of.wants_depth,
                                 .untouched = untouched_ && of.target == now.target,
                                 .counts_pixels = settings_.count_pixels,
                                 .part = of.part,
                                 .outlines = settings_.outlines && !of.scene.has_trims() &&
                                             !settings_.section,
                                 .filter = settings_.texture_filter,
                                 .curved_px = stages_->curved.places_px};
    stages_->method->draw(frame, times);
    report_.renderer = stages_->method->renderer();
    report_.dice.add(stages_->method->counts());
    report_.surface.add(stages_->method->surface_counts());
}

/// Adds the bounds of the kept pixels to the report. Drawing the whole frame might have diced
/// further patches beside the parts, or patches that earlier batches do not hide. It is only known
/// that the steps of such patches would keep the tolerance.
void l3d_pipeline_afd::keep_bounds(const l3d_dice_counts& kept) {
    l3d_dice_counts& now = report_.dice;
    if (report_.pixels_kept > 0) {
        now.bound_px = std::max({now.bound_px, kept.bound_px, settings_.tolerance});
        now.depth_bound_px =
            std::max({now.depth_bound_px, kept.depth_bound_px, settings_.tolerance});
        now.shade_bound = std::max({now.shade_bound, kept.shade_bound, settings_.shade_tolerance});
        now.unproven_quads += kept.unproven_quads;
    }
    now.near_z = std::max(now.near_z, kept.near_z);
    now.coarse = std::max(now.coarse, kept.coarse);
    now.coarsest = std::max(now.coarsest, kept.coarsest);
}

/// Bounds the difference of the surfaces from the exact picture, for the map of errors, before
/// anything is drawn on top.
void l3d_pipeline_afd::find_doubts(bool has_levels, l3d_stage_times& times) {
    const stopwatch finding;
    constexpr double unknown = std::numeric_limits<double>::infinity();
    report_.coverage_bound = report_.color_bound = unknown;
    const l3d_frame_lights of_frame = lights();
    const bool has_exact = l3d_is_light(settings_.shade) && !settings_.wireframe &&
                           !settings_.drawing && !settings_.background.is_none() &&
                           of_frame.lighting.point_count == 0 && !scene_.has_pictures() &&
                           !settings_.section;
    if (!settings_.error_map || !has_exact) {
        stages_->doubts.reset();
        return;
    }
    if (!stages_->doubts)
        stages_->doubts = std::make_unique<l3d_frame_doubts>();
    l3d_frame_doubts& doubts = *stages_->doubts;
    doubts.find({.scene = scene_,
                 .to_image = stages_->transform.matrix(),
                 .view = stages_->view,
                 .light = of_frame.light,
                 .bound_px = report_.dice.bound_px,
                 .depth_bound_px = report_.dice.depth_bound_px,
                 .curved = stages_->curved,
                 .has_levels = has_levels,
                 .lighting = of_frame.lighting,
                 .fog = settings_.fog,
                 .nearer = stages_->transform.nearer(),
                 .drawn = screen_->pixels(),
                 .background = settings_.background},
                stages_->workers);
    report_.coverage_bound = doubts.coverage_bound();
    report_.color_bound = doubts.color_bound();
    times.error_map += finding.milliseconds();
}

void l3d_pipeline_afd::draw_on_top(const l3d_shading& shading) {
    paint_surfaces();
    if (!changed_.empty())
        draw_curves(shading);
    if (settings_.net && !changed_.empty())
        draw_nets();
    draw_overlay();
    draw_panels();
    rasterizer_.finish();
    if (!untouched_)
        changed_ = l3d_whole(stages_->view.size);
}

/// Draws the wireframe. Its lines hide nothing and have no depth, so a depth that is asked for is
/// cleared.
void l3d_pipeline_afd::draw_wireframe(const l3d_shading& shading) {
    const auto nothing_is_hidden = [](const l3d_subpixel_box&, float) { return false; };
    untouched_ = false;
    if (wants_depth()) {
        depth_.resize(stages_->view.size);
        depth_.clear();
    }
    const l3d_patch_scene there = what_is_there();
    stages_->wire_culling.begin(there, stages_->transform.matrix(), stages_->view);
    l3d_dice_view view = stages_->view;
    view.shading.antialias = settings_.antialias; // makes dicing note shared borders
    stages_->wire_dicer.begin(view);
    l3d_detail::wire_picture picture(rasterizer_, screen_->pixels(), shading, settings_.antialias,
                                     screen_->text_scale());
    l3d_detail::wire_lines lines(picture);
    for (auto batch = stages_->wire_culling.next(nothing_is_hidden); !batch.empty();
         batch = stages_->wire_culling.next(nothing_is_hidden))
        lines.draw(stages_->wire_dicer.dice(there, stages_->wire_culling, batch));
    picture.finish();
    report_.dice = stages_->wire_dicer.counts();
    report_.dice.add(stages_->wire_culling.counts());
    report_.curved_px = stages_->curved.places_px;
    report_.dice.add_off(report_.curved_px);
    report_.renderer = {};
    report_.surface = {};
    report_.outline_pixels = l3d_surface_counts::none_counted;
    report_.pixels_kept = 0;
}
