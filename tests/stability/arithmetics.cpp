// SPDX-License-Identifier: MIT
// Frames in every number type.
#include "hard_edged.h"
#include "arithmetics.h"

#include "scene/camera_shading.h"
#include "dice/frame_dicer.h"
#include "scene/image_transform.h"
#include "scene/levels/level_choice.h"
#include "pipeline/pipeline_afd.h"
#include "scene/culling/scene_culling.h"
#include "processor_time.h"
#include "raster/rasterizer_factory.h"
#include "raster/surfaces/surface_rasterizer_sw.h"
#include "tool_2d/screen_memory.h"

#include <limits>
#include <type_traits>
#include <utility>

namespace stability {
namespace {

using fixed = l3d_fixed<std::int64_t, 32>;

const l3d_vector<double, 3> light{0.4, 0.8, 0.45};

l3d_afd_settings settings_of(double tolerance) {
    l3d_afd_settings settings = hard_edged();
    settings.tolerance = tolerance;
    settings.light = light;
    settings.depth = true;
    return settings;
}

template <class T> class dicing final : public arithmetic {
public:
    dicing(const char* name, l3d_dice_way way) : name_(name), dicer_(workers_, way, true) {}

    const char* name() const override { return name_; }

    l3d_dice_counts dice(const library_case& c, const piece_sink& sink) override {
        begin(c);
        const auto nothing_is_hidden = [](const l3d_subpixel_box&, float) { return false; };
        for (auto batch = culling_.next(nothing_is_hidden); !batch.empty();
             batch = culling_.next(nothing_is_hidden)) {
            dicer_.dice(scene_, culling_, batch);
            hand_out(batch, sink);
        }
        return counts();
    }

    frame draw(const library_case& c, const piece_sink& sink) override {
        frame result;
        result.words.resize(static_cast<std::size_t>(c.size.width) *
                            static_cast<std::size_t>(c.size.height));
        const l3d_pixels target{result.words.data(), c.size.width, c.size.height, c.size.width};
        double seconds = -processor_seconds();
        begin(c);
        depth_.resize(c.size);
        rasterizer_.begin(target, &depth_, rest_of_shading_);
        const auto hidden = [this](const l3d_subpixel_box& box, float inv_w) {
            return rasterizer_.hidden(box, inv_w);
        };
        for (auto batch = culling_.next(hidden); !batch.empty(); batch = culling_.next(hidden)) {
            rasterizer_.draw(dicer_.dice(scene_, culling_, batch));
            seconds += processor_seconds();
            hand_out(batch, sink);
            seconds -= processor_seconds();
        }
        rasterizer_.finish();
        seconds += processor_seconds();
        result.milliseconds = 1000 * seconds;
        result.counts = counts();
        result.near = result.counts.near_z / depth_scale_;
        result.distances = l3d_distances(depth_);
        return result;
    }

private:
    void begin(const library_case& c) {
        scene_.clear();
        scene_.add(c.model);
        const l3d_image_transform to_image(c.camera, c.size, scene_);
        l3d_dice_view view = to_image.view(c.dice_tolerance);
        l3d_shading shading = l3d_camera_shading(c.camera, c.size, l3d_shade::lambert, light);
        to_image.set_depths(shading);
        rest_of_shading_ = l3d_lit_while_diced(view, shading, true);
        depth_scale_ = view.depth_scale;
        culling_.begin(scene_, to_image.matrix(), view);
        dicer_.begin(view);
    }

    void hand_out(std::span<const l3d_placed_patch> batch, const piece_sink& sink) const {
        for (std::size_t i = 0; i < batch.size(); ++i)
            sink(batch[i].patch, dicer_.pieces(i), dicer_.counts().bound_px);
    }

    l3d_dice_counts counts() const {
        l3d_dice_counts result = dicer_.counts();
        result.add(culling_.counts());
        return result;
    }

    const char* name_;
    l3d_workers workers_{1};
    l3d_patch_scene scene_;
    l3d_scene_culling culling_;
    l3d_frame_dicer<T> dicer_;
    double depth_scale_ = 1;
    l3d_shading rest_of_shading_; ///< that is left to the rasterizer
    l3d_depth_buffer depth_;
    l3d_surface_rasterizer_sw rasterizer_{workers_};
};

} // namespace

std::optional<library_case> library_case::of(const test_case& c, std::string& why) {
    const auto vector_of = [](const reference::vec3& v) {
        return l3d_camera::vector{v.x, v.y, v.z};
    };
    library_case result;
    result.camera = {vector_of(c.eye.eye),
                     vector_of(c.eye.target),
                     vector_of(c.eye.up),
                     c.eye.fov_degrees,
                     c.eye.near,
                     c.far,
                     c.eye.parallel ? l3d_projection::parallel : l3d_projection::perspective};
    result.size = {c.size.width, c.size.height};
    result.tolerance = result.dice_tolerance = c.tolerance;
    why = l3d_afd_complaint(result.camera, result.size, settings_of(result.tolerance));
    if (!why.empty())
        return std::nullopt;
    std::vector<l3d_patch_model::patch> patches(c.patches.size());
    for (std::size_t i = 0; i < patches.size(); ++i)
        for (std::size_t k = 0; k < 16; ++k)
            patches[i].points[k] = vector_of(c.patches[i].points[k]);
    auto model = c.curved.empty() ? l3d_patch_model::checked(std::move(patches), c.name, why)
                                  : l3d_patch_model::from_patches(c.curved, c.name, why);
    if (!model)
        return std::nullopt;
    result.model = *std::move(model);
    if (result.model.is_curved()) {
        l3d_patch_scene scene(result.model);
        result.curved_px = scene
                               .choose_levels({.camera = result.camera,
                                               .size = result.size,
                                               .places_px = l3d_curved_share * c.tolerance,
                                               .normals = std::numeric_limits<double>::infinity()})
                               .places_px;
        result.model = scene.instances()[0].model();
        result.dice_tolerance = (1 - l3d_curved_share) * c.tolerance;
    }
    return result;
}

std::vector<std::unique_ptr<arithmetic>> all_arithmetics() {
    std::vector<std::unique_ptr<arithmetic>> result;
    result.push_back(std::make_unique<dicing<float>>("float", l3d_dice_way::lanes));
    result.push_back(std::make_unique<dicing<double>>("double", l3d_dice_way::lanes));
    result.push_back(std::make_unique<dicing<fixed>>("block 32", l3d_dice_way::lanes));
    result.push_back(std::make_unique<dicing<fixed>>("32.32", l3d_dice_way::general));
    return result;
}

frame draw_by_pipeline(const library_case& c) {
    l3d_pipeline_afd pipeline(l3d_memory_canvas(c.size), c.model, c.camera,
                              settings_of(c.tolerance));
    pipeline.draw_event();
    frame result;
    result.counts = pipeline.report().dice;
    result.near = pipeline.report().near_z;
    for (int y = 0; y < c.size.height; ++y) {
        const auto row = pipeline.screen().pixels().row(y);
        result.words.insert(result.words.end(), row.begin(), row.end());
    }
    result.distances = pipeline.distances();
    return result;
}

const char* pipeline_arithmetic() {
    return std::is_same_v<l3d_real, float>    ? "float"
           : std::is_same_v<l3d_real, double> ? "double"
                                              : "block 32";
}

} // namespace stability
