// SPDX-License-Identifier: MIT
// leaving_out_cases: crowds of teapots, balls, a ring, walls and sheets.
#include "bench/leaving_out_cases.h"

#include "compare/method_choice.h"

#include "../scene/bodies.h"
#include "../dice/scene.h"
#include "geom/teapot.h"
#include "scene/culling/facing_cones.h"

#include <cmath>
#include <random>
#include <span>
#include <stdexcept>
#include <utility>

namespace {

using vector = l3d_camera::vector;
using report = l3d_frame_report;

const l3d_camera::frame& axes() {
    static const l3d_camera::frame result = leaving_out_cases::camera.axes();
    return result;
}

/// The world point that is seen `right` and `up` from the picture's middle, at a distance.
/// Units: pixels.
vector seen_at(double right, double up, double w) {
    const double unit = w / leaving_out_cases::camera.focal_length(leaving_out_cases::size);
    return leaving_out_cases::camera.eye + axes().forward * w + axes().right * (right * unit) +
           axes().up * (up * unit);
}

l3d_matrix<double> at(const vector& p) {
    return l3d_translation<double>(p[0], p[1], p[2]);
}

/// Numbers for one scene.
class dice {
public:
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    l3d_matrix<double> turn() {
        return l3d_rotation<double>({between(-1, 1), between(-1, 1), 1.0}, between(-172, 172));
    }
    /// Anywhere in the picture.
    vector place(double nearest, double farthest) {
        constexpr l3d_size size = leaving_out_cases::size;
        const double right = between(-0.48, 0.48) * size.width;
        const double up = between(-0.48, 0.48) * size.height;
        return seen_at(right, up, between(nearest, farthest));
    }

private:
    std::mt19937_64 random_{20061};
};

l3d_patch_scene crowd(const l3d_patch_model& model, int count, double nearest, double farthest) {
    dice random;
    l3d_patch_scene scene;
    for (int i = 0; i < count; ++i)
        scene.add(model, at(random.place(nearest, farthest)) * random.turn());
    return scene;
}

/// All around the eye: a twentieth of them is in the picture.
l3d_patch_scene around_the_eye(const l3d_patch_model& model, int count) {
    constexpr double nearest = 30, farthest = 200;
    dice random;
    l3d_patch_scene scene;
    while (scene.instances().size() < static_cast<std::size_t>(count)) {
        const vector p(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
        if (l3d_length(p) <= 1 && l3d_length(p) * farthest >= nearest)
            scene.add(model, at(leaving_out_cases::camera.eye + p * farthest) * random.turn());
    }
    return scene;
}

/// Bumpy patches side by side that all face the eye and cover centres of pixels. Units: pixels.
l3d_patch_model sheet(int columns, int rows, double side) {
    constexpr double distance = 20, bump = 0.02;
    std::vector<l3d_patch_model::patch> patches;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            l3d_patch_model::patch& p = patches.emplace_back();
            for (int r = 0; r < 4; ++r)
                for (int c = 0; c < 4; ++c) {
                    const bool inner = r % 3 != 0 && c % 3 != 0;
                    p.at(r, c) = seen_at((column + c / 3.0 - columns / 2.0) * side,
                                         (row + r / 3.0 - rows / 2.0) * side,
                                         distance - (inner ? bump * side / 8 : 0));
                }
        }
    return l3d_patch_model(std::move(patches));
}

l3d_patch_model model_of(std::vector<reference::patch> body) {
    return dice_tests::scene(std::move(body), {}, leaving_out_cases::size).model;
}

/// A rule, and what it says that it left out.
struct rule {
    const char* name;
    bool l3d_kept_work::*keep;
    const char* unit;
    std::int64_t (*left_out)(const report&);

    leaving_out_case on(std::string scene, bool applies, l3d_patch_scene world,
                        double tolerance = 0.25) const {
        leaving_out_case result{name, std::move(scene), applies,         keep,
                                unit, left_out,         std::move(world)};
        result.settings.tolerance = tolerance;
        result.settings.shade = l3d_shade::gouraud;
        return result;
    }
};

constexpr rule outside{"outside", &l3d_kept_work::outside, "patches",
                       [](const report& r) { return r.dice.offscreen + r.dice.behind; }};
constexpr rule centreless{"centreless", &l3d_kept_work::centreless, "patches",
                          [](const report& r) { return r.dice.subpixel; }};
constexpr rule hidden{"hidden", &l3d_kept_work::hidden, "patches",
                      [](const report& r) { return r.dice.hidden; }};
constexpr rule backs{"backs", &l3d_kept_work::backs, "blocks", [](const report& r) {
                         return static_cast<std::int64_t>(l3d_facing_cones::blocks) *
                                    r.dice.backfacing +
                                r.dice.back_blocks;
                     }};
constexpr rule dicing{"dicing", &l3d_kept_work::dicing, "patches",
                      [](const report& r) { return r.dice.as_points; }};
constexpr rule normals{"unit normals", &l3d_kept_work::unit_normals, "polygons",
                       [](const report& r) { return r.surface.by_plane; }};
constexpr rule drawing{"drawing", &l3d_kept_work::drawing, "pixels",
                       [](const report& r) { return r.pixels_kept; }};

/// Polygons have normals in the pixel; diced surfaces have levels instead.
leaving_out_case tessellated(leaving_out_case result) {
    result.settings.method = l3d_method_choice{l3d_method::tessellation, 16}.factory();
    result.settings.shade = l3d_shade::lambert;
    return result;
}

leaving_out_case one_sided(leaving_out_case result) {
    result.settings.one_sided = true;
    return result;
}

leaving_out_case changing(frame_change change, leaving_out_case result) {
    result.change = change;
    return result;
}

} // namespace

leaving_out_cases::leaving_out_cases() {
    std::string why;
    auto teapot_model = l3d_patch_model::from_bpt(l3d_teapot_bpt(), "teapot", why);
    if (!teapot_model)
        throw std::runtime_error(why);
    const auto kept = [&](l3d_patch_model model) -> const l3d_patch_model& {
        return models_.emplace_back(std::move(model));
    };
    const l3d_patch_model& teapot = kept(*std::move(teapot_model));
    const l3d_patch_model& ball = kept(model_of(dice_tests::ball()));
    const l3d_patch_model& ring = kept(model_of(dice_tests::ring(2, 0.7)));
    const l3d_patch_model& small = kept(sheet(100, 100, 3));
    const l3d_patch_model& large = kept(sheet(6, 6, 70));
    const l3d_patch_model& wall = kept(sheet(1, 1, 1.2 * size.width));

    constexpr bool made_for = true, in_vain = false;
    const char *const patches_10000 = "10000 patches of 3 px", *const patches_36 = "36 of 70 px";

    cases_.push_back(
        outside.on("300 teapots around the eye", made_for, around_the_eye(teapot, 300)));
    cases_.push_back(outside.on(patches_10000, in_vain, small));

    cases_.push_back(
        centreless.on("1000 teapots of 3 to 5 px", made_for, crowd(teapot, 1000, 1000, 1500)));
    cases_.push_back(centreless.on(patches_10000, in_vain, small));

    l3d_patch_scene behind = crowd(teapot, 300, 60, 200);
    behind.add(wall);
    cases_.push_back(hidden.on("300 teapots behind a wall", made_for, std::move(behind)));
    cases_.push_back(hidden.on(patches_10000, in_vain, small));

    cases_.push_back(backs.on("a ball", made_for, crowd(ball, 1, 4.5, 4.5)));
    cases_.push_back(backs.on("200 balls of 17 to 23 px", made_for, crowd(ball, 200, 60, 80)));
    cases_.push_back(one_sided(backs.on("a ring, one-sided", made_for, ring)));
    cases_.push_back(
        one_sided(backs.on(std::string(patches_10000) + ", one-sided", in_vain, small)));
    cases_.push_back(one_sided(backs.on(std::string(patches_36) + ", one-sided", in_vain, large)));

    cases_.push_back(
        dicing.on("1000 teapots of 1 to 2 px", made_for, crowd(teapot, 1000, 2200, 4500), 0.5));
    cases_.push_back(
        dicing.on("200 teapots of 11 to 15 px", in_vain, crowd(teapot, 200, 300, 400), 0.25));
    cases_.push_back(dicing.on(patches_10000, in_vain, small, 0.5));

    cases_.push_back(
        tessellated(normals.on("the teapot in 16 x 16 quads a patch", made_for, teapot)));

    const l3d_patch_scene still = crowd(teapot, 300, 90, 140);
    cases_.push_back(
        changing(frame_change::none, drawing.on("300 teapots at rest", made_for, still)));
    cases_.push_back(changing(frame_change::one, drawing.on("one of 300 moves", made_for, still)));
    cases_.push_back(changing(frame_change::all, drawing.on("all of 300 move", in_vain, still)));
}
