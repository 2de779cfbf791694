// SPDX-License-Identifier: MIT
// The map of errors of lit, fogged and transparent pictures against exact ones: no pixel is farther
// off.
#include "hard_edged.h"
#include "../dice/scene.h"
#include "../scene/bodies.h"
#include "words_of.h"

#include "dice/certificate/frame_doubts.h"
#include "pipeline/pipeline_afd.h"
#include "raster/depth_buffer.h"
#include "raster/rasterizer_factory.h"
#include "reference/box_image.h"
#include "reference/random_numbers.h"
#include "scene/image_transform.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using dice_tests::scene;

/// A channel's place in a pixel word.
constexpr int red = 16, blue = 0;

double part_of(std::uint32_t color, int shift) {
    return (color >> shift & 255) / 255.0;
}

/// One channel of a frame's light.
reference::lamp_light lamps_of(const l3d_lighting& lighting, const l3d_material& material,
                               int shift) {
    const auto channel = static_cast<std::size_t>((16 - shift) / 8);
    reference::lamp_light result{
        .color = part_of(material.color, shift),
        .highlight = part_of(material.highlight, shift),
        .sharpness = material.sharpness,
        .ambient = double{lighting.ambient[channel]},
        .lamps = {{reference::project_light, double{lighting.color[channel]}}}};
    for (std::size_t i = 0; i < lighting.count; ++i) {
        const l3d_far_light& light = lighting.lights[i];
        result.lamps.push_back(
            {{double{light.direction[0]}, double{light.direction[1]}, double{light.direction[2]}},
             double{light.color[channel]}});
    }
    return result;
}

/// What pixels are off, and what is promised of them, away from edges and beside them.
struct found {
    std::vector<double> bounds, errors, of_edges;
    int exceptions = 0;

    void add(const std::vector<std::uint32_t>& words, const l3d_error_map& map, int shift,
             const reference::box_image& exact) {
        for (std::size_t i = 0; i < words.size(); ++i) {
            const reference::box_pixel& p = exact.pixels()[i];
            const double level = words[i] >> shift & 255, error = std::abs(level - p.level);
            const double bound = double{map.levels()[i]};
            if (!(error <= bound + p.unsure) && ++exceptions <= 3)
                std::printf("  pixel %zu: drawn %.0f, exact %.3f +- %.3f, bound %.3f\n", i, level,
                            p.level, p.unsure, bound);
            if (p.covered == 1 && !p.edge) {
                bounds.push_back(bound);
                errors.push_back(error);
            } else if (p.covered > 0) {
                of_edges.push_back(bound);
            }
        }
    }
    static double at(std::vector<double> of, double part) {
        std::ranges::sort(of);
        return of.empty() ? 0 : of[static_cast<std::size_t>(part * double(of.size() - 1))];
    }
    void print(const std::string& name) const {
        std::printf("%-26s %6zu pixels inside: bound %5.2f, 99 %% %6.2f; off %5.2f, 99 %% %6.2f, "
                    "most %6.2f; %5zu at edges: bound %6.2f; %d exceptions\n",
                    name.c_str(), bounds.size(), at(bounds, 0.5), at(bounds, 0.99), at(errors, 0.5),
                    at(errors, 0.99), at(errors, 1), of_edges.size(), at(of_edges, 0.5),
                    exceptions);
    }
};

struct drawn {
    std::vector<std::uint32_t> words;
    l3d_error_map map;
    l3d_frame_report report;
};

drawn draw(const scene& s, const l3d_material& material, const l3d_afd_settings& settings,
           double opacity = 1) {
    l3d_patch_scene world;
    world.add(s.model, s.placement);
    world.paint(0, material);
    world.set_opacity(0, opacity);
    l3d_afd_settings with_map = settings;
    with_map.error_map = true;
    with_map.light = {reference::project_light.x, reference::project_light.y,
                      reference::project_light.z};
    l3d_pipeline_afd pipeline(l3d_memory_canvas(s.size), world, s.camera, with_map);
    pipeline.draw_event();
    return {words_of(pipeline.screen().pixels()), *pipeline.error_map(), pipeline.report()};
}

struct named_scene {
    std::string name;
    scene of;
};

std::vector<named_scene> four_models(l3d_size small) {
    reference::random_numbers random(21);
    std::vector<named_scene> result;
    for (const char* const view : {"full", "closeup", "top"})
        result.push_back({std::string("teapot, ") + view,
                          dice_tests::teapot(reference::project_view(view), small)});
    result.push_back({"dome", scene(reference::load_bpt_plain("tests/data/dome.bpt"),
                                    {{0.1, 0.2, 13.94}, {0, 0, 0}, {0.1, 1, 0}, 38, 0.1}, small)});
    result.push_back({"bumps", scene(reference::load_bpt_plain("tests/data/bump3.bpt"),
                                     {{1, 2, 4}, {0, 0, 0}, {0, 1, 0}, 38, 0.1}, small)});
    result.push_back(
        {"body", scene(dice_tests::random_body(random, dice_tests::body_kind::toroidal),
                       {{2.1, 3.2, 4.3}, {0, 0, 0}, {0.1, 1, 0.2}, 38, 0.1}, small)});
    return result;
}

l3d_material shining(int sharpness) {
    return {.color = 0x803020, .highlight = 0xffffff, .sharpness = sharpness};
}

l3d_lighting two_lights() {
    l3d_lighting lighting;
    lighting.color = {0.8F, 0.9F, 0.6F};
    lighting.add({-1, 0.3, 0.6}, {0.3F, 0.1F, 0.9F});
    return lighting;
}

/// What all pictures of some scenes have, in some channels, with and without smooth edges.
found beside_exact(const std::vector<named_scene>& scenes, int sharpness,
                   const std::vector<int>& shifts) {
    const l3d_lighting lighting = two_lights();
    const l3d_material material = shining(sharpness);
    found all;
    for (const named_scene& each : scenes) {
        found of_scene;
        for (const int shift : shifts) {
            const reference::box_image exact(each.of.patches, each.of.eye, each.of.picture(),
                                             reference::project_light,
                                             {.lamps = lamps_of(lighting, material, shift)});
            for (const bool antialias : {false, true}) {
                l3d_afd_settings settings = hard_edged();
                settings.lighting = lighting;
                settings.antialias = antialias;
                const drawn picture = draw(each.of, material, settings);
                for (found* const to : {&all, &of_scene})
                    to->add(picture.words, picture.map, shift, exact);
            }
        }
        of_scene.print(each.name + ", k = " + std::to_string(sharpness));
    }
    EXPECT_EQ(all.exceptions, 0) << sharpness;
    // A bound that says nothing is true, too.
    EXPECT_LT(found::at(all.bounds, 0.5), 3) << sharpness;
    EXPECT_LT(found::at(all.bounds, 0.99), 15) << sharpness;
    return all;
}

TEST(lit_doubts, hold_for_highlights_of_two_lights_on_four_models) {
    const std::vector<named_scene> scenes = four_models({36, 27});
    beside_exact({scenes[0], scenes[3]}, 5, {blue});
    beside_exact({scenes[1], scenes[5]}, 50, {red});
    beside_exact({scenes[1], scenes[4]}, 500, {red});
}

/// Five minutes.
TEST(lit_doubts, DISABLED_hold_for_more_pixels_of_highlights) {
    for (const int sharpness : {5, 50, 500})
        beside_exact(four_models({56, 42}), sharpness, {red, blue})
            .print("all, k = " + std::to_string(sharpness));
}

/// A black and a white picture show both bounds of the light itself. They are closer to it than
/// what pixels are off.
TEST(lit_doubts, enclose_the_exact_light_from_both_sides) {
    const scene s = dice_tests::teapot(reference::project_view("closeup"), {32, 24});
    l3d_patch_scene world;
    world.add(s.model, s.placement);
    const l3d_image_transform transform(s.camera, s.size, world);
    const auto count = static_cast<std::size_t>(s.size.width * s.size.height);
    l3d_workers workers(1);
    const l3d_vector<double, 3> light{reference::project_light.x, reference::project_light.y,
                                      reference::project_light.z};
    for (const int sharpness : {5, 50, 500}) {
        if (!thorough && sharpness != 50)
            continue;
        const l3d_material material{
            .color = 0x404040, .highlight = 0xffffff, .sharpness = sharpness};
        world.paint(0, material);
        const auto map_of = [&](std::uint32_t color) {
            std::vector<std::uint32_t> words(count, color);
            l3d_frame_doubts doubts;
            doubts.find({.scene = world,
                         .to_image = transform.matrix(),
                         .view = transform.view(0.25),
                         .light = light,
                         .bound_px = 0.25,
                         .depth_bound_px = 0.25,
                         .has_levels = false,
                         .drawn = {words.data(), s.size.width, s.size.height, s.size.width}},
                        workers);
            return doubts.map();
        };
        const l3d_error_map most = map_of(0), least = map_of(0xffffff);
        const reference::box_image exact(s.patches, s.eye, s.picture(), reference::project_light,
                                         {.wanted = 0.05, .lamps = lamps_of({}, material, red)});
        int exceptions = 0;
        double apart = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const reference::box_pixel& p = exact.pixels()[i];
            const double high = double{most.levels()[i]}, low = 255 - double{least.levels()[i]};
            exceptions += p.level - p.unsure > high || p.level + p.unsure < low;
            apart += (high - low) / static_cast<double>(count);
        }
        std::printf("k = %d: bounds are %.2f levels apart in the mean; %d exceptions\n", sharpness,
                    apart, exceptions);
        EXPECT_EQ(exceptions, 0) << sharpness;
        EXPECT_LT(apart, 6) << sharpness;
    }
}

TEST(lit_doubts, hold_for_fog) {
    const scene s = dice_tests::teapot(reference::project_view("full"), {32, 24});
    const double eye = std::hypot(s.eye.eye.x - s.eye.target.x, s.eye.eye.y - s.eye.target.y,
                                  s.eye.eye.z - s.eye.target.z);
    l3d_afd_settings settings = hard_edged();
    settings.fog = {.from = static_cast<float>(eye - 1.5),
                    .to = static_cast<float>(eye + 2),
                    .color = 0x90c0ff};
    for (const l3d_material& material : {l3d_material(), shining(20)}) {
        reference::lamp_light light = lamps_of({}, material, red);
        light.fog_near = double{settings.fog.from};
        light.fog_far = double{settings.fog.to};
        light.fog_level = 0x90;
        const reference::box_image exact(s.patches, s.eye, s.picture(), reference::project_light,
                                         {.lamps = light});
        found all;
        for (const bool antialias : {false, true}) {
            settings.antialias = antialias;
            const drawn picture = draw(s, material, settings);
            all.add(picture.words, picture.map, red, exact);
            EXPECT_LT(picture.report.color_bound, 100);
        }
        all.print("fog, teapot");
        EXPECT_EQ(all.exceptions, 0);
        EXPECT_LT(found::at(all.bounds, 0.5), 3);
    }
}

/// Two instances through each other, each there with a probability.
TEST(lit_doubts, hold_for_transparent_instances) {
    constexpr l3d_size size{40, 30};
    constexpr double first = 0.4, second = 0.7;
    reference::random_numbers random(21);
    const reference::camera eye{{2.1, 3.2, 4.3}, {0, 0, 0}, {0.1, 1, 0.2}, 38, 0.1};
    const auto body = [&](dice_tests::body_kind kind) {
        return dice_tests::random_body(random, kind);
    };
    const auto one = body(dice_tests::body_kind::toroidal);
    const auto other = body(dice_tests::body_kind::flattened);
    auto both = one;
    both.insert(both.end(), other.begin(), other.end());
    const scene of_one(one, eye, size), of_other(other, eye, size), of_both(both, eye, size);
    const auto exact_of = [&](const scene& s) {
        return reference::box_image(s.patches, s.eye, s.picture(), reference::project_light);
    };
    const auto only_one = exact_of(of_one), only_other = exact_of(of_other),
               of_all = exact_of(of_both);

    l3d_patch_scene world;
    world.add(of_one.model, of_one.placement);
    world.add(of_other.model, of_other.placement);
    world.set_opacity(0, first);
    world.set_opacity(1, second);
    l3d_afd_settings settings = hard_edged();
    settings.error_map = true;
    settings.light = {reference::project_light.x, reference::project_light.y,
                      reference::project_light.z};
    for (const bool antialias : {false, true}) {
        settings.antialias = antialias;
        l3d_pipeline_afd pipeline(l3d_memory_canvas(size), world, of_both.camera, settings);
        pipeline.draw_event();
        const auto words = words_of(pipeline.screen().pixels());
        int exceptions = 0;
        std::vector<double> bounds;
        for (std::size_t i = 0; i < words.size(); ++i) {
            double low = 0, high = 0;
            const auto add = [&](const reference::box_image& exact, double weight) {
                const reference::box_pixel& p = exact.pixels()[i];
                low += weight * reference::light_of_level(std::max(0.0, p.level - p.unsure));
                high += weight * reference::light_of_level(std::min(255.0, p.level + p.unsure));
            };
            add(only_one, first * (1 - second));
            add(only_other, (1 - first) * second);
            add(of_all, first * second);
            const double level = words[i] & 255;
            const double bound = double{pipeline.error_map()->levels()[i]};
            exceptions += level - reference::level_of_light(high) > bound ||
                          reference::level_of_light(low) - level > bound;
            if (of_all.pixels()[i].covered > 0)
                bounds.push_back(bound);
        }
        std::printf("transparent: bound %.2f, 90 %% %.2f; %d exceptions\n", found::at(bounds, 0.5),
                    found::at(bounds, 0.9), exceptions);
        EXPECT_EQ(exceptions, 0);
        EXPECT_LT(found::at(bounds, 0.5), 6);
    }
}

} // namespace
