// SPDX-License-Identifier: MIT
// Whole frames: the same bits however they are made, like the slow twins', and nothing allocated.
#include "effort.h"
#include "hard_edged.h"
#include "pipeline/pipeline_afd.h"

#include "allocations.h"
#include "geom/matrix.h"
#include "geom/polygon_shapes.h"
#include "geom/teapot.h"
#include "scene/camera_shading.h"
#include "raster/rasterizer_factory.h"
#include "raster/parallel/simd_target.h"
#include "raster/surfaces/surface_rasterizer_scalar.h"
#include "reference/views.h"
#include "words_of.h"
#include "dice/scene.h"
#include "base/error.h"
#include "tool_2d/screen_memory.h"
#include "pipeline/surface_method.h"
#include "pipeline/worlds/pipeline_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace dice_tests {
namespace {

constexpr l3d_size picture_size{640, 481};

/// A pipeline that tests may steer, into memory.
class tester final : public l3d_pipeline_afd {
public:
    tester(const dice_tests::scene& s, const l3d_afd_settings& settings)
        : tester(s.model, s.camera, s.size, settings) {}

    tester(l3d_patch_scene what, const l3d_camera& camera, l3d_size size,
           const l3d_afd_settings& settings)
        : l3d_pipeline_afd(l3d_memory_canvas(size), std::move(what), camera, settings) {}

    bool has_text = false;

    std::vector<std::uint32_t> draw() {
        draw_event();
        return words();
    }

    /// Draws the same picture again, whole: the far plane is elsewhere, behind all that there is.
    void draw_again() {
        camera().far_z = std::nextafter(camera().far_z, 0.0);
        draw_event();
    }

    std::vector<std::uint32_t> words() { return words_of(screen().pixels()); }

private:
    void draw_overlay() override {
        if (has_text)
            rasterizer().draw_line(3, 3, 600, 400, 0x00123456);
    }
};

l3d_afd_settings settings_of(double tolerance, int threads) {
    l3d_afd_settings result = hard_edged();
    result.tolerance = tolerance;
    result.threads = threads;
    return result;
}

/// Many teapots around the target, some half behind others and some outside: several batches.
struct crowd {
    static constexpr int count = 600;

    crowd() : teapot(dice_tests::teapot(reference::project_view("full"), picture_size)) {
        std::mt19937_64 random(90125);
        std::uniform_real_distribution<double> unit(-1, 1);
        for (int i = 0; i < count; ++i) {
            l3d_matrix<double> placement = l3d_translation<double>(
                22 * unit(random) + 0.3, 12 * unit(random), 22 * unit(random) - 5);
            for (int row = 0; row < 3; ++row)
                for (int column = 0; column < 3; ++column)
                    placement(row, column) += 0.4 * unit(random);
            world.add(teapot.model, placement);
        }
        camera = teapot.camera;
        camera.eye = {13.1, 15.3, 47.9};
        camera.far_z = 1e4;
    }
    crowd(const crowd&) = delete;
    crowd& operator=(const crowd&) = delete;

    scene teapot;
    l3d_patch_scene world;
    l3d_camera camera;
};

TEST(pipeline_afd, refuses_settings_before_it_uses_them) {
    const scene s = dice_tests::teapot(reference::project_view("full"), picture_size);
    const auto expect_refused = [&](int threads, const std::string& why) {
        try {
            tester refused(s, settings_of(0.25, threads));
            ADD_FAILURE() << threads << " threads";
        } catch (const l3d_error& error) {
            EXPECT_TRUE(std::string(error.what()).starts_with(why)) << error.what();
        }
    };
    expect_refused(0, "threads: 0 is not positive");
    expect_refused(-1, "threads: -1 is not positive");
    expect_refused(100'000, "threads: 100000 is more than 1024; ");
}

TEST(pipeline_afd, refuses_numbers_that_were_changed_and_draws_on) {
    const scene s = dice_tests::teapot(reference::project_view("full"), picture_size);
    tester program(s, settings_of(0.25, 1));
    const std::vector<std::uint32_t> first = program.draw();
    const l3d_camera camera = program.camera();
    const l3d_afd_settings settings = program.settings();
    const auto expect_refused = [&](const std::string& why) {
        try {
            program.draw_event();
            ADD_FAILURE() << why;
        } catch (const l3d_error& error) {
            EXPECT_TRUE(std::string(error.what()).starts_with(why)) << error.what();
        }
        EXPECT_EQ(program.words(), first);
        program.camera() = camera;
        program.settings() = settings;
    };
    program.camera().fov = 200;
    expect_refused("camera: fov");
    program.camera().eye = program.camera().target;
    expect_refused("camera: target");
    program.settings().light = {0.0, 0.0, 0.0};
    expect_refused("light: no direction");
    program.settings().tolerance = -1;
    expect_refused("tolerance: -1");
    program.settings().shade = l3d_shade::own;
    expect_refused("own: ");
    program.draw_again();
    EXPECT_EQ(program.words(), first);
}

TEST(pipeline_afd, draws_the_same_bits_with_any_number_of_threads) {
    for (const reference::view& view : reference::project_views()) {
        const scene s = teapot(view, picture_size);
        const auto alone = tester(s, settings_of(0.25, 1)).draw();
        for (const int threads : {2, 3, 8}) {
            tester shared(s, settings_of(0.25, threads));
            for (int frame = 0; frame < 3; ++frame) {
                shared.draw_again();
                EXPECT_TRUE(shared.words() == alone) << view.name << ", " << threads << " threads";
            }
        }
    }
}

TEST(pipeline_afd, draws_the_same_bits_with_any_vector_instructions) {
    EXPECT_GE(l3d_simd_targets().size(), 1u);
    for (const reference::view& view : reference::project_views())
        for (const double tolerance : {1.0, 0.1}) {
            const scene s = teapot(view, picture_size);
            const auto best = tester(s, settings_of(tolerance, 1)).draw();
            for (const std::string& target : l3d_simd_targets()) {
                ASSERT_TRUE(l3d_set_simd_target(target));
                EXPECT_TRUE(tester(s, settings_of(tolerance, 1)).draw() == best)
                    << view.name << ", " << target;
            }
            l3d_set_simd_target("");
        }
}

TEST(pipeline_afd, draws_the_same_bits_with_vector_instructions_and_threads_in_every_mode) {
    const crowd many;
    const scene one = teapot(reference::project_view("closeup"), picture_size);
    for (const l3d_shade shade :
         {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat, l3d_shade::normals}) {
        const auto draw = [&](bool crowded, int threads) {
            l3d_afd_settings settings = settings_of(0.5, threads);
            settings.shade = shade;
            tester program = crowded ? tester(many.world, many.camera, picture_size, settings)
                                     : tester(one, settings);
            auto words = program.draw();
            EXPECT_TRUE(!crowded || program.report().dice.hidden > 0);
            return words;
        };
        const auto best_one = draw(false, 1), best_many = draw(true, 1);
        for (const std::string& target : l3d_simd_targets()) {
            ASSERT_TRUE(l3d_set_simd_target(target));
            EXPECT_TRUE(draw(false, 2) == best_one) << static_cast<int>(shade) << ", " << target;
            EXPECT_TRUE(draw(true, 2) == best_many) << static_cast<int>(shade) << ", " << target;
        }
        l3d_set_simd_target("");
    }
}

TEST(pipeline_afd, reports_the_vector_instructions_in_use) {
    const scene s = teapot(reference::project_view("full"), {61, 47});
    for (const std::string& target : l3d_simd_targets()) {
        ASSERT_TRUE(l3d_set_simd_target(target));
        tester program(s, settings_of(0.5, 1));
        program.draw_event();
        const std::string json = program.report().json();
        EXPECT_NE(json.find(R"("simd":")" + target + '"'), std::string::npos) << json;
    }
    l3d_set_simd_target("");
}

TEST(pipeline_afd, keeps_an_empty_depth_of_a_wireframe) {
    l3d_afd_settings settings = settings_of(0.5, 1);
    settings.depth = settings.wireframe = true;
    const scene s = teapot(reference::project_view("full"), picture_size);
    tester program(s, settings);
    program.draw_event();
    EXPECT_EQ(program.depth().size(), picture_size);
    program.settings().wireframe = false;
    program.draw_event();
    EXPECT_GT(l3d_covered(program.depth()), 1000);
    program.settings().wireframe = true;
    program.draw_event();
    EXPECT_EQ(l3d_covered(program.depth()), 0);
}

/// A method of a program's own: fills the part with one colour, and has no bound.
class one_color_method final : public l3d_surface_method {
public:
    static constexpr std::uint32_t color = 0x00123456;

private:
    void do_draw(const l3d_method_frame& frame, l3d_stage_times&) override {
        for (int y = frame.part.top; y < frame.part.bottom; ++y)
            for (std::uint32_t& word : frame.target.row(y))
                word = color;
        surface_.covered =
            frame.counts_pixels ? frame.part.area() : l3d_surface_counts::none_counted;
        counts_.bound_px = std::numeric_limits<double>::infinity();
    }
    const l3d_dice_counts& do_counts() const override { return counts_; }
    const l3d_surface_counts& do_surface_counts() const override { return surface_; }

    l3d_dice_counts counts_;
    l3d_surface_counts surface_;
};

TEST(pipeline_afd, draws_with_the_method_of_its_settings) {
    l3d_afd_settings settings = settings_of(0.5, 3);
    int workers_of_method = 0;
    settings.method =
        l3d_method_factory("one color", [&](const l3d_rasterizer_factory&, l3d_workers& workers) {
            workers_of_method = workers.count();
            return std::make_unique<one_color_method>();
        });
    settings.count_pixels = true;
    const scene s = teapot(reference::project_view("full"), picture_size);
    tester program(s, settings);
    const std::vector<std::uint32_t> words = program.draw();
    EXPECT_EQ(words, std::vector(words.size(), one_color_method::color));
    EXPECT_EQ(workers_of_method, 3);
    EXPECT_EQ(program.report().method, "one color");
    EXPECT_EQ(program.report().surface.covered, l3d_whole(picture_size).area());
    EXPECT_TRUE(std::isinf(program.report().dice.bound_px));
    settings.shade = l3d_shade::error;
    EXPECT_EQ(l3d_afd_complaint(s.camera, picture_size, settings),
              "shade: error shows a bound of the error, and one color has none");
}

TEST(pipeline_afd, takes_another_method_between_frames) {
    const scene s = teapot(reference::project_view("full"), picture_size);
    tester program(s, settings_of(0.5, 2));
    const std::vector<std::uint32_t> first = program.draw();
    const l3d_method_factory usual = program.settings().method;
    program.take_method(l3d_method_factory(
        "one color", [](const auto&, auto&) { return std::make_unique<one_color_method>(); }));
    EXPECT_EQ(program.draw(), std::vector(first.size(), one_color_method::color));
    EXPECT_EQ(program.report().method, "one color");
    const l3d_method_factory refuses("none",
                                     [](const auto&, auto&) -> std::unique_ptr<l3d_surface_method> {
                                         throw l3d_error(l3d_exit::no_backend, "not here");
                                     });
    EXPECT_THROW(program.take_method(refuses), l3d_error);
    EXPECT_EQ(program.settings().method.name(), "one color") << "what was refused changes nothing";
    EXPECT_EQ(program.draw(), std::vector(first.size(), one_color_method::color));
    program.take_method(usual);
    EXPECT_EQ(program.draw(), first);
}

/// Frames follow each other as in a program: the eye goes round, things come and go.
void change(tester& program, int frame) {
    program.camera().orbit(frame % 5 == 4 ? 86 : 6, frame % 7 == 6 ? 17 : 0);
    program.has_text = frame % 6 == 2;
    l3d_afd_settings& settings = program.settings();
    settings.wireframe = frame % 11 == 5;
    settings.net = frame % 13 == 7;
    settings.depth = frame % 4 >= 2;
    constexpr l3d_shade shades[] = {l3d_shade::lambert, l3d_shade::lambert, l3d_shade::flat,
                                    l3d_shade::gouraud, l3d_shade::normals};
    settings.shade = shades[frame / 3 % 5];
}

/// The distances that were asked for.
std::vector<float> depths(const tester& program, const l3d_afd_settings& settings) {
    return settings.depth ? l3d_distances(program.depth()) : std::vector<float>();
}

TEST(pipeline_afd, clears_what_the_frame_before_left) {
    const scene s = teapot(reference::project_view("full"), picture_size);
    tester program(s, settings_of(0.5, 2));
    for (int frame = 0; frame < 70; ++frame) {
        change(program, frame);
        tester fresh(s, program.settings());
        fresh.camera() = program.camera();
        fresh.has_text = program.has_text;
        ASSERT_TRUE(program.draw() == fresh.draw()) << "frame " << frame;
        ASSERT_TRUE(depths(program, program.settings()) == depths(fresh, program.settings()))
            << "frame " << frame;
    }
}

TEST(pipeline_afd, clears_what_the_frame_before_left_of_a_crowd) {
    const crowd many;
    tester program(many.world, many.camera, picture_size, settings_of(0.5, 2));
    for (int frame = 0; frame < (thorough ? 30 : 8); ++frame) {
        change(program, frame);
        tester fresh(many.world, program.camera(), picture_size, program.settings());
        fresh.has_text = program.has_text;
        ASSERT_TRUE(program.draw() == fresh.draw()) << "frame " << frame;
        ASSERT_TRUE(depths(program, program.settings()) == depths(fresh, program.settings()))
            << "frame " << frame;
    }
}

/// Every piece by the general dicer, every pixel by the scalar rasterizer.
TEST(pipeline_afd, draws_what_the_slow_twins_draw) {
    for (const reference::view& view : reference::project_views()) {
        const scene s = teapot(view, picture_size);
        const auto fast = tester(s, settings_of(0.25, 1)).draw();

        std::vector<std::uint32_t> slow(fast.size());
        l3d_depth_buffer depth;
        depth.resize(s.size);
        const auto& light = reference::project_light;
        l3d_surface_rasterizer_scalar rasterizer;
        rasterizer.begin(
            {slow.data(), s.size.width, s.size.height, s.size.width}, &depth,
            l3d_camera_shading(s.camera, s.size, l3d_shade::lambert, {light.x, light.y, light.z}));
        scene_dicer<dice_tests::slow<l3d_real>>().dice(
            s, 0.25, [&](std::size_t, diced pieces, double) {
                std::vector<const l3d_surface_part*> parts;
                for (const l3d_diced_piece& piece : pieces)
                    parts.push_back(&piece.part);
                rasterizer.draw(parts);
            });
        rasterizer.finish();

        // Steps differ where floats bound what doubles bound; both are within the tolerance.
        std::size_t outline = 0, covered = 0, far_off = 0;
        for (std::size_t i = 0; i < fast.size(); ++i) {
            outline += (fast[i] == 0) != (slow[i] == 0);
            if (fast[i] == 0 || slow[i] == 0)
                continue;
            ++covered;
            far_off +=
                std::abs(static_cast<int>(fast[i] & 255) - static_cast<int>(slow[i] & 255)) > 3;
        }
        std::printf("%.*s: of %zu pixels %zu are covered in one only, %zu differ by more than 3\n",
                    static_cast<int>(view.name.size()), view.name.data(), covered, outline,
                    far_off);
        EXPECT_LE(outline, 20 + covered / 2000) << view.name;
        // The slow one interpolates normals, the fast one levels, which may be two levels off.
        EXPECT_LE(far_off, 30 + covered / 80) << view.name;
    }
}

template <class T> class steady_dicer : public ::testing::Test {};
TYPED_TEST_SUITE(steady_dicer, number_types, type_names);

TYPED_TEST(steady_dicer, allocates_nothing_for_a_frame_like_the_last_one) {
    for (const char* name : {"full", "closeup", "near_cut", "inside"}) {
        scene_dicer<TypeParam> dicer;
        const auto forget = [](std::size_t, diced, double) {};
        const scene s = teapot(reference::project_view(name), picture_size);
        dicer.dice(s, 0.1, forget);
        const long before = allocations;
        dicer.dice(s, 0.1, forget);
        EXPECT_EQ(allocations - before, 0) << name;
    }
}

TEST(pipeline_afd, allocates_nothing_for_a_frame_like_the_last_one) {
    for (const reference::view& view : reference::project_views())
        for (const int threads : {1, 2}) {
            const scene s = teapot(view, picture_size);
            tester program(s, settings_of(0.25, threads));
            for (int frame = 0; frame < 3; ++frame)
                program.draw_again();
            const long before = allocations;
            program.draw_again();
            EXPECT_EQ(allocations - before, 0) << view.name << ", " << threads << " threads";
        }
}

TEST(pipeline_afd, allocates_nothing_for_a_crowd_like_the_last_one) {
    const crowd many;
    for (const int threads : {1, 2}) {
        tester program(many.world, many.camera, picture_size, settings_of(0.25, threads));
        for (int frame = 0; frame < 2; ++frame)
            program.draw_again();
        for (int frame = 0; frame < 5; ++frame) {
            const long before = allocations;
            program.draw_again();
            EXPECT_EQ(allocations - before, 0) << threads << " threads";
        }
        // The first three batches take 64 + 128 + 256 patches.
        EXPECT_GT(program.report().dice.drawn + program.report().dice.hidden, 1000);
    }
}

TEST(pipeline_afd, allocates_nothing_on_its_second_turn_round_the_model) {
    constexpr int stops = 24;
    for (const int threads : {1, 2})
        for (const char* name : {"full", "near_cut"}) {
            const scene s = teapot(reference::project_view(name), picture_size);
            tester program(s, settings_of(0.25, threads));
            const l3d_camera start = program.camera();
            long before = 0;
            for (int turn = 0; turn < 2; ++turn) {
                before = allocations;
                for (int stop = 0; stop < stops; ++stop) {
                    program.camera() = start; // or rounding makes the turns differ
                    program.camera().orbit(stop * 360.0 / stops, 0);
                    program.draw_event();
                }
            }
            EXPECT_EQ(allocations - before, 0) << name << ", " << threads << " threads";
        }
}

/// Boxes that a matrix has scaled keep their shape while they turn.
TEST(world_depth, allocates_nothing_for_objects_that_have_turned_before) {
    l3d_world world(picture_size);
    world.camera.place = l3d_point<l3d_real>::of(0, 0, -20);
    for (int i = 0; i < 20; ++i) {
        l3d_object& box = world.add(std::make_unique<l3d_object>(l3d_box_mesh()));
        box.set_transform(0, l3d_scaling<l3d_real>(1, 2, 3));
        box.set_transform(2, l3d_translation<l3d_real>(i - 10, 0, 0));
    }
    l3d_pipeline_world pipeline(l3d_memory_canvas(picture_size), world);
    long before = 0;
    for (int turn = 0; turn < 2; ++turn) {
        before = allocations;
        for (int degrees = 0; degrees < 360; degrees += 15) {
            for (const auto& box : world.objects())
                box->set_transform(1, l3d_rotation_y<l3d_real>(degrees));
            pipeline.draw_event();
        }
    }
    EXPECT_EQ(allocations - before, 0);
}

} // namespace
} // namespace dice_tests
