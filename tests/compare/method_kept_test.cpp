// SPDX-License-Identifier: MIT
// Micropolygons that are kept: what later frames dice again, and whether quads keep their size.
#include "hard_edged.h"
#include "dice/scene.h"

#include "compare/method_kept.h"
#include "pipeline/surface_method.h"
#include "pipeline/pipeline_afd.h"
#include "reference/exact.h"
#include "reference/measure.h"
#include "reference/region.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace dice_tests {
namespace {

constexpr l3d_size size{160, 120};

/// A pipeline whose camera moves, and its method.
class studio : public l3d_pipeline_afd {
public:
    explicit studio(const dice_tests::scene& s, int quads_a_pixel = 2)
        : studio(s, quads_a_pixel, std::make_shared<const l3d_method_kept*>()) {}

    /// The vertices that the frame dices.
    std::int64_t diced_from(const l3d_camera& at) {
        camera() = at;
        draw_event();
        return report().dice.samples;
    }
    const l3d_method_kept& method() const { return **method_; }

private:
    studio(const dice_tests::scene& s, int quads_a_pixel,
           std::shared_ptr<const l3d_method_kept*> method)
        : l3d_pipeline_afd(l3d_memory_canvas(s.size), s.model, s.camera,
                           settings(quads_a_pixel, method)),
          method_(std::move(method)) {}

    static l3d_afd_settings settings(int quads_a_pixel,
                                     const std::shared_ptr<const l3d_method_kept*>& to) {
        l3d_afd_settings result = hard_edged();
        result.depth = true;
        result.method = {"kept", [=](const l3d_rasterizer_factory& rasterizers, l3d_workers& all) {
                             auto made =
                                 std::make_unique<l3d_method_kept>(quads_a_pixel, rasterizers, all);
                             *to = made.get();
                             return made;
                         }};
        return result;
    }

    std::shared_ptr<const l3d_method_kept*> method_;
};

l3d_camera nearer(const l3d_camera& camera, double by) {
    l3d_camera result = camera;
    result.eye = camera.target + (camera.eye - camera.target) / by;
    return result;
}

TEST(method_kept, dices_nothing_again_while_quads_fit) {
    const scene s = teapot(reference::project_view("full"), size);
    studio pictures(s);
    const std::int64_t all = pictures.diced_from(s.camera);
    EXPECT_GT(all, 10000);
    EXPECT_EQ(pictures.diced_from(nearer(s.camera, 1.0001)), 0);
    // A twentieth nearer: most quads are within the quarter by which they may grow.
    EXPECT_LT(pictures.diced_from(nearer(s.camera, 1.05)), all / 4);
    // A third nearer, most are beyond that.
    const std::int64_t again = pictures.diced_from(nearer(s.camera, 1.4));
    std::printf("%ld vertices, a third nearer %ld\n", static_cast<long>(all),
                static_cast<long>(again));
    EXPECT_GT(again, all);
}

TEST(method_kept, dices_again_what_has_shrunk_and_gives_its_memory_back) {
    const scene s = teapot(reference::project_view("full"), size);
    studio pictures(s);
    const std::int64_t all = pictures.diced_from(s.camera);
    const std::size_t large = pictures.method().bytes();
    EXPECT_LT(pictures.diced_from(nearer(s.camera, 0.5)), all / 20);
    EXPECT_GT(pictures.diced_from(nearer(s.camera, 0.15)), 0);
    EXPECT_LT(pictures.method().bytes(), large / 4);
    EXPECT_GT(pictures.method().bytes(), 0u);
}

/// After any way, the picture is as exact as that of a new program.
TEST(method_kept, is_as_exact_after_a_flight_as_at_its_start) {
    const scene s = teapot(reference::project_view("full"), size);
    studio pictures(s);
    for (const double by : {0.3, 0.5, 0.8, 1.3, 2.0, 1.4, 1.0})
        pictures.diced_from(nearer(s.camera, by));
    const reference::exact_image exact(s.patches, s.eye, s.picture());
    const reference::exact_region region(s.patches, s.eye, s.picture());
    const reference::error_map errors =
        reference::map_errors(l3d_distances(pictures.depth()), exact, region, 60);
    int wrong = 0; // seen through where pieces of different steps meet
    for (std::size_t i = 0; i < errors.depth.size(); ++i)
        wrong += errors.outline[i] > 0.05f || errors.depth[i] > 0.1f;
    EXPECT_LE(wrong, 5);
    EXPECT_EQ(std::count(errors.holes.begin(), errors.holes.end(), true), 0);
}

/// An instance that moves has other places in the world, and normals.
TEST(method_kept, draws_what_has_moved_as_a_new_program_does) {
    const scene s = teapot(reference::project_view("full"), size);
    studio pictures(s);
    pictures.diced_from(s.camera);
    l3d_matrix<double> aside = l3d_identity<double>();
    aside(0, 3) = 0.7;
    pictures.scene().clear();
    pictures.scene().add(s.model, aside);
    pictures.draw_event();
    studio fresh(s);
    fresh.scene().clear();
    fresh.scene().add(s.model, aside);
    fresh.draw_event();
    EXPECT_EQ(pictures.report().hash, fresh.report().hash);
}

} // namespace
} // namespace dice_tests
