// SPDX-License-Identifier: MIT
// Patches that culling leaves out are not visible; those that it hands out come nearest first.
#include "scene/camera.h"
#include "teapot_studio.h"
#include "scene/culling/scene_culling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using dice_tests::teapot_model;

using vector = l3d_patch_scene::vector;

constexpr l3d_size odd{317, 241};

l3d_camera oblique() {
    l3d_camera camera = dice_tests::oblique_camera();
    camera.near_z = 0.2;
    camera.far_z = 300;
    return camera;
}

l3d_dice_view view_of(const l3d_camera& camera, l3d_size size) {
    l3d_dice_view view;
    view.size = size;
    view.near = camera.near_z;
    view.far = camera.far_z;
    return view;
}

/// Patches of all sizes, some flat as a line.
l3d_patch_model random_model(std::mt19937_64& random, int patches) {
    std::uniform_real_distribution<double> unit(-1, 1), power(-9, 2);
    std::vector<l3d_patch_model::patch> result(static_cast<std::size_t>(patches));
    for (auto& patch : result) {
        const double size = std::exp2(power(random));
        const vector centre(3 * unit(random), 3 * unit(random), 3 * unit(random));
        const vector shape(unit(random), unit(random) * 0.1, unit(random));
        for (auto& p : patch.points)
            p = centre +
                vector(shape[0] * unit(random), shape[1] * unit(random), shape[2] * unit(random)) *
                    size;
    }
    return l3d_patch_model(std::move(result));
}

/// Instances around the eye on all sides, near and far, of many sizes, slanted and mirrored.
l3d_patch_scene random_scene(std::mt19937_64& random, const l3d_patch_model& model, int count) {
    std::uniform_real_distribution<double> unit(-1, 1), power(-1, 10), size(-6, 1);
    l3d_patch_scene scene;
    for (int i = 0; i < count; ++i) {
        l3d_matrix<double> m = l3d_identity<double>();
        const double scale = std::exp2(size(random)), distance = std::exp2(power(random));
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                m(row, column) = scale * unit(random);
            m(row, 3) = oblique().eye[row] + distance * unit(random);
        }
        scene.add(model, m);
    }
    return scene;
}

constexpr auto never = [](const l3d_subpixel_box&, float) { return false; };

std::int64_t left_out(const l3d_dice_counts& counts) {
    return counts.offscreen + counts.behind + counts.beyond + counts.subpixel + counts.hidden;
}

using name = std::pair<std::uint32_t, std::uint32_t>;

/// Exact surface points (x / w, y / w, w) of a patch of an instance.
std::vector<vector> samples_of(const l3d_patch_instance& instance, std::size_t patch,
                               const l3d_matrix<double>& to_image) {
    constexpr int n = 12;
    std::vector<vector> result;
    for (int r = 0; r <= n; ++r)
        for (int c = 0; c <= n; ++c) {
            const vector p = instance.model().patches()[patch].evaluate(c / 12.0, r / 12.0);
            const auto h =
                to_image * (instance.placement() * l3d_vector<double, 4>(p[0], p[1], p[2], 1.0));
            result.push_back({h[0] / h[3], h[1] / h[3], h[3]});
        }
    return result;
}

/// Whether the points prove that something is in the picture: one of them is (the picture's
/// outermost half pixels have no centre), and neither rows nor columns of pixel centres are missed
/// by all.
bool surely_seen(const std::vector<vector>& points, const l3d_dice_view& view) {
    const double right = view.size.width / 2.0 - 0.5, bottom = view.size.height / 2.0 - 0.5;
    bool inside = false, in_front = true;
    double low[2]{1e30, 1e30}, high[2]{-1e30, -1e30};
    for (const vector& p : points) {
        const bool between = p[2] > view.near && p[2] < view.far;
        in_front = in_front && p[2] > view.near;
        inside = inside || (between && std::abs(p[0]) < right && std::abs(p[1]) < bottom);
        for (int i = 0; i < 2; ++i) {
            low[i] = std::min(low[i], p[i]);
            high[i] = std::max(high[i], p[i]);
        }
    }
    // Sizes are odd: pixel centres lie at whole numbers from the picture's centre.
    const bool catches =
        std::floor(high[0]) >= std::ceil(low[0]) && std::floor(high[1]) >= std::ceil(low[1]);
    return inside && (catches || !in_front);
}

TEST(scene_culling, leaves_out_nothing_that_is_seen) {
    const l3d_camera camera = oblique();
    const l3d_dice_view view = view_of(camera, odd);
    const l3d_matrix<double> to_image = camera.image_matrix(odd);
    l3d_scene_culling culling;
    std::int64_t seen = 0;
    l3d_dice_counts sum;
    for (const unsigned seed : {71u, 72u, 73u, 74u}) {
        std::mt19937_64 random(seed);
        const l3d_patch_model model = random_model(random, 37);
        const l3d_patch_scene scene = random_scene(random, model, 300);
        culling.begin(scene, to_image, view);
        std::set<name> handed_out;
        while (!culling.is_done())
            for (const l3d_placed_patch& p : culling.next(never))
                EXPECT_TRUE(handed_out.insert({p.instance, p.patch}).second);
        const l3d_dice_counts& counts = culling.counts();
        EXPECT_EQ(left_out(counts) + static_cast<std::int64_t>(handed_out.size()),
                  scene.patch_count());
        EXPECT_EQ(counts.hidden, 0);
        for (std::uint32_t i = 0; i < scene.instances().size(); ++i)
            for (std::uint32_t k = 0; k < 37; ++k)
                if (!handed_out.contains({i, k})) {
                    EXPECT_FALSE(surely_seen(samples_of(scene.instances()[i], k, to_image), view))
                        << "seed " << seed << " instance " << i << " patch " << k;
                } else {
                    ++seen;
                }
        sum.offscreen += counts.offscreen;
        sum.behind += counts.behind;
        sum.beyond += counts.beyond;
        sum.subpixel += counts.subpixel;
    }
    EXPECT_GT(seen, 1000);
    for (const std::int64_t count : {sum.offscreen, sum.behind, sum.beyond, sum.subpixel})
        EXPECT_GT(count, 100);
}

/// Against the control net of each patch: boxes are seldom much worse.
TEST(scene_culling, leaves_out_most_of_what_control_nets_would) {
    const l3d_camera camera = oblique();
    const l3d_dice_view view = view_of(camera, odd);
    const l3d_matrix<double> to_image = camera.image_matrix(odd);
    std::mt19937_64 random(9021);
    const l3d_patch_model model = teapot_model();
    const l3d_patch_scene scene = random_scene(random, model, 2000);
    l3d_scene_culling culling;
    culling.begin(scene, to_image, view);
    std::int64_t handed_out = 0, in_vain = 0;
    while (!culling.is_done())
        for (const l3d_placed_patch& p : culling.next(never)) {
            std::vector<l3d_image_point> net;
            for (const auto& point : model.patches()[p.patch].points) {
                const auto h =
                    culling.matrix(p) * l3d_vector<double, 4>(point[0], point[1], point[2], 1.0);
                net.push_back({h[0], h[1], h[3]});
            }
            ++handed_out;
            in_vain += l3d_outside(net, view.margin(), view.near, view.far);
        }
    std::printf("of %lld patches handed out, %lld have a control net outside; %lld left out\n",
                static_cast<long long>(handed_out), static_cast<long long>(in_vain),
                static_cast<long long>(left_out(culling.counts())));
    EXPECT_GT(handed_out, 2000);
    EXPECT_LT(in_vain, left_out(culling.counts()) / 100);
}

TEST(scene_culling, keeps_all_if_told_so) {
    const l3d_camera camera = oblique();
    l3d_dice_view view = view_of(camera, odd);
    view.keep = l3d_culling_switches::all();
    std::mt19937_64 random(31);
    const l3d_patch_model model = random_model(random, 5);
    const l3d_patch_scene scene = random_scene(random, model, 300);
    l3d_scene_culling culling;
    culling.begin(scene, camera.image_matrix(odd), view);
    std::size_t count = 0;
    while (!culling.is_done())
        count += culling.next([](const l3d_subpixel_box&, float) { return true; }).size();
    EXPECT_EQ(count, 1500u);
}

TEST(scene_culling, hands_out_the_nearest_first_in_growing_batches) {
    const l3d_camera camera = oblique();
    const l3d_dice_view view = view_of(camera, odd);
    const l3d_patch_model model = teapot_model();
    l3d_patch_scene scene;
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < 400; ++i)
        scene.add(model, l3d_translation<double>(7 * unit(random), 5 * unit(random),
                                                 -30 + 30 * unit(random)));
    l3d_scene_culling culling;
    culling.begin(scene, camera.image_matrix(odd), view);
    // The most that a teapot reaches along the view axis.
    const float deep = 8;
    float farthest = 0;
    std::vector<std::size_t> sizes;
    while (!culling.is_done()) {
        const auto batch = culling.next(never);
        sizes.push_back(batch.size());
        for (std::size_t i = 0; i < batch.size(); ++i) {
            EXPECT_TRUE(i == 0 || batch[i - 1].nearest_w <= batch[i].nearest_w);
            EXPECT_GT(batch[i].nearest_w + deep, farthest);
        }
        farthest = std::max(farthest, batch.back().nearest_w);
    }
    ASSERT_GE(sizes.size(), 4u);
    EXPECT_EQ(sizes[0], 64u);
    EXPECT_EQ(sizes[1], 128u);
    EXPECT_EQ(sizes[2], 256u);
    EXPECT_TRUE(culling.next(never).empty());
}

TEST(scene_culling, hands_out_a_small_scene_at_once) {
    const l3d_camera camera = oblique();
    const l3d_patch_model model = teapot_model();
    l3d_patch_scene scene;
    for (int i = 0; i < 4; ++i)
        scene.add(model, l3d_translation<double>(0.3 * i, 0.2, -i));
    l3d_scene_culling culling;
    culling.begin(scene, camera.image_matrix(odd), view_of(camera, odd));
    const std::size_t all = culling.next(never).size();
    EXPECT_TRUE(culling.is_done());
    EXPECT_GT(all, 100u);
    EXPECT_EQ(static_cast<std::int64_t>(all) + left_out(culling.counts()), 4 * 28);
    culling.begin({}, camera.image_matrix(odd), view_of(camera, odd));
    EXPECT_TRUE(culling.is_done());
    EXPECT_TRUE(culling.next(never).empty());
}

/// A wall across a part of the picture: all that is behind it is hidden, nothing else.
struct wall {
    l3d_subpixel_box box;
    float inv_w;

    bool operator()(const l3d_subpixel_box& b, float nearest) const {
        return b.left >= box.left && b.top >= box.top && b.right <= box.right &&
               b.bottom <= box.bottom && nearest <= inv_w;
    }
};

TEST(scene_culling, asks_about_all_that_is_in_a_patch_and_of_the_picture) {
    const l3d_camera camera = oblique();
    l3d_dice_view view = view_of(camera, odd);
    const double scale = 0.125; // of w, as image transforms have it
    view.near *= scale;
    view.far *= scale;
    view.depth_scale = scale;
    l3d_matrix<double> to_image = camera.image_matrix(odd);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            to_image(row, column) *= scale;
    // From the picture's left side, where it ends, to the middle.
    const wall behind{{-2 * l3d_subpixel_one, -2 * l3d_subpixel_one, 160 * l3d_subpixel_one,
                       200 * l3d_subpixel_one},
                      1.0f / 9};
    l3d_scene_culling culling;
    std::int64_t hidden = 0;
    for (const unsigned seed : {11u, 12u, 13u}) {
        std::mt19937_64 random(seed);
        const l3d_patch_model model = random_model(random, 23);
        const l3d_patch_scene scene = random_scene(random, model, 1500);
        const auto all = [&](auto&& is_hidden) {
            std::set<name> result;
            culling.begin(scene, to_image, view);
            while (!culling.is_done())
                for (const l3d_placed_patch& p : culling.next(is_hidden))
                    result.insert({p.instance, p.patch});
            return result;
        };
        const std::set<name> open = all(never), rest = all(behind);
        EXPECT_EQ(left_out(culling.counts()) + static_cast<std::int64_t>(rest.size()),
                  scene.patch_count());
        hidden += culling.counts().hidden;
        std::size_t missed = 0;
        for (const name& n : open) {
            const auto points = samples_of(scene.instances()[n.first], n.second, to_image);
            double low[2]{1e30, 1e30}, high[2]{-1e30, -1e30}, least = 1e30;
            for (const vector& p : points) {
                least = std::min(least, p[2]);
                for (int i = 0; i < 2; ++i) {
                    low[i] = std::min(low[i], p[i]);
                    high[i] = std::max(high[i], p[i]);
                }
            }
            const double left = -odd.width / 2.0, top = -odd.height / 2.0;
            const bool is_behind = least / scale > 9 &&
                                   std::min(high[0] - left, odd.width + 0.0) < 160 &&
                                   std::min(high[1] - top, odd.height + 0.0) < 200;
            if (!rest.contains(n))
                EXPECT_TRUE(is_behind)
                    << "seed " << seed << " instance " << n.first << " patch " << n.second;
            else
                missed +=
                    is_behind && least / scale > 12 && high[0] - left < 140 && high[1] - top < 180;
        }
        // The first batch is not asked about.
        EXPECT_LT(missed, 64 + rest.size() / 10) << "seed " << seed;
    }
    EXPECT_GT(hidden, 500);
}

} // namespace
