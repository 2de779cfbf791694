// SPDX-License-Identifier: MIT
// Frames that draw only what changed: the same bits as frames drawn whole, and no more work.
#include "effort.h"
#include "hard_edged.h"
#include "still_studio.h"

#include "raster/surfaces/surface_rasterizer_scalar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace still_tests;

/// The slow twin fills the surfaces.
class scalar_factory final : public l3d_rasterizer_factory {
    std::unique_ptr<l3d_rasterizer_2d_imp> do_create_2d(l3d_pixels target) const override {
        return l3d_rasterizer_factory_sw().create_2d(target);
    }
    std::unique_ptr<l3d_surface_rasterizer> do_create_surface(l3d_workers&) const override {
        return std::make_unique<l3d_surface_rasterizer_scalar>();
    }
};

struct tally {
    int frames = 0, parts = 0, still = 0;
};

/// Frames in which instances are placed again, each beside the same frame drawn whole.
template <class Factory>
tally compare(std::uint64_t seed, int frames, int threads, bool antialias = false) {
    studio s(seed);
    s.settings.threads = threads;
    s.settings.antialias = antialias;
    constexpr std::array backgrounds{l3d_background(), l3d_background::gradient(),
                                     l3d_background::none()};
    s.settings.background = backgrounds[seed % backgrounds.size()];
    tester program(s.scene, s.camera, s.settings, std::make_shared<Factory>());
    tally result;
    program.draw_event();
    for (int frame = 0; frame < frames; ++frame) {
        s.move(program);
        program.draw_event();
        const std::int64_t kept = program.report().pixels_kept;
        ++result.frames;
        result.parts += kept > 0 && kept < odd.width * odd.height;
        result.still += kept == odd.width * odd.height;
        tester fresh(program.scene(), s.camera, s.settings, std::make_shared<Factory>());
        fresh.draw_event();
        EXPECT_EQ(fresh.report().pixels_kept, 0);
        const auto a = program.words(), b = fresh.words();
        int off = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            off += a[i] != b[i];
        EXPECT_EQ(off, 0) << "seed " << seed << ", frame " << frame;
        // A whole frame also dices what is hidden, unless it was found to be, and what is just
        // beside the window.
        EXPECT_GE(program.report().dice.bound_px, fresh.report().dice.bound_px)
            << "seed " << seed << ", frame " << frame;
    }
    return result;
}

TEST(still_picture, is_the_same_bits_as_drawn_whole) {
    for (const auto& [threads, antialias] :
         {std::pair(1, false), std::pair(2, false), std::pair(2, true)}) {
        tally all;
        // Edges cost more in these small pictures than all else.
        const std::uint64_t seeds = (antialias ? 15 : 50) * (thorough ? 4 : 1);
        for (std::uint64_t seed = 0; seed < seeds; ++seed) {
            const tally t = compare<l3d_rasterizer_factory_sw>(seed, 8, threads, antialias);
            all.frames += t.frames;
            all.parts += t.parts;
            all.still += t.still;
        }
        std::printf("%d frames: %d drew a part, %d nothing\n", all.frames, all.parts, all.still);
        EXPECT_GT(all.parts, all.frames / 2);
    }
}

/// Each model lives nowhere but in the scene, and the next one may come to the same memory.
TEST(still_picture, of_models_that_come_and_go_is_that_of_a_new_program) {
    random_numbers random(707);
    l3d_camera camera;
    camera.eye = {0.3, 0.2, 7};
    tester program(wild_model(random, 2), camera, {});
    for (int frame = 0; frame < 6; ++frame) {
        program.draw_event();
        tester fresh(program.scene(), camera, {});
        fresh.draw_event();
        EXPECT_EQ(program.words(), fresh.words()) << "frame " << frame;
        if (frame < 3) {
            program.scene().place(0, wild_model(random, 2), l3d_identity<double>());
        } else {
            program.scene().clear();
            program.scene().add(wild_model(random, 2));
        }
    }
}

/// Two teapots, one of which may be moved, and a few pixels between them.
struct pair_of_teapots {
    pair_of_teapots() {
        camera.eye = {0.3, 1.2, 12};
        camera.target = {0, 1, 0};
        scene.add(teapot, l3d_translation<double>(-2.6, 0, 0));
        scene.add(teapot, right(0));
    }

    static l3d_matrix<double> small() {
        l3d_matrix<double> m = l3d_identity<double>();
        for (int i = 0; i < 3; ++i)
            m(i, i) = 0.3;
        return m;
    }

    static l3d_matrix<double> right(int step) {
        return l3d_translation<double>(2.4 + 0.05 * step, 0.1, 0) * small();
    }

    l3d_patch_model teapot = teapot_model();
    l3d_patch_scene scene;
    l3d_camera camera;
    l3d_afd_settings settings = hard_edged();
};

std::vector<std::uint32_t> drawn_whole(tester& program, l3d_size size = odd) {
    tester fresh(program.scene(), program.camera(), program.settings(),
                 std::make_shared<l3d_rasterizer_factory_sw>(), size);
    fresh.text_at = program.text_at;
    fresh.draw_event();
    return fresh.words();
}

void expect_kept(const tester& program, const l3d_frame_report& first) {
    const l3d_frame_report report = program.report();
    EXPECT_TRUE(program.changed().empty());
    EXPECT_EQ(report.surface.quads, 0);
    EXPECT_EQ(report.surface.samples, 0);
    EXPECT_EQ(report.surface.written, 0);
    EXPECT_EQ(report.dice.drawn, 0);
    EXPECT_EQ(report.dice.samples, 0);
    EXPECT_EQ(report.dice.unchanged, first.patches);
    EXPECT_EQ(report.dice.bound_px, first.dice.bound_px);
    EXPECT_EQ(report.pixels_kept, odd.width * odd.height);
    EXPECT_EQ(report.hash, first.hash);
}

TEST(still_picture, costs_no_drawing) {
    const pair_of_teapots s;
    tester program(s.scene, s.camera, s.settings);
    program.draw_event();
    EXPECT_EQ(program.changed(), l3d_whole(odd));
    const l3d_frame_report first = program.report();
    EXPECT_GT(first.surface.written, 1000);
    for (int frame = 0; frame < 100; ++frame) {
        if (frame % 2 == 0)
            program.redraw();
        if (frame % 3 == 0) // where it is already
            program.scene().place(1, pair_of_teapots::right(0));
        EXPECT_EQ(program.needs_redraw(), frame % 2 == 0);
        program.draw_event();
        expect_kept(program, first);
    }
    EXPECT_NE(program.report().json().find(R"("left_out":["unchanged"])"), std::string::npos);
    EXPECT_NE(program.report().explanation().find("56 of 56 patches (unchanged)"),
              std::string::npos);
}

TEST(still_picture, is_drawn_where_something_moved) {
    const pair_of_teapots s;
    tester program(s.scene, s.camera, s.settings);
    program.draw_event();
    const l3d_frame_report first = program.report();
    for (int step = 1; step < 12; ++step) {
        program.scene().place(1, pair_of_teapots::right(step));
        EXPECT_TRUE(program.needs_redraw());
        program.draw_event();
        EXPECT_FALSE(program.needs_redraw());
        const l3d_frame_report report = program.report();
        EXPECT_LT(program.changed().area(), odd.width * odd.height / 10);
        EXPECT_EQ(report.pixels_kept + program.changed().area(), odd.width * odd.height);
        EXPECT_EQ(report.dice.unchanged, 28);
        EXPECT_LT(report.surface.quads, first.surface.quads / 2);
        EXPECT_EQ(program.words(), drawn_whole(program)) << step;
    }
}

/// Small ones in opposite corners move, what is between them stays.
TEST(still_picture, is_not_drawn_between_things_that_moved) {
    pair_of_teapots s;
    const auto corner = [](double side, int step) {
        return l3d_translation<double>(4.6 * side, 1 + 3.1 * side + 0.02 * step, 0.0) *
               pair_of_teapots::small();
    };
    s.scene.add(s.teapot, corner(-1, 0));
    s.scene.add(s.teapot, corner(1, 0));
    tester program(s.scene, s.camera, s.settings);
    program.draw_event();
    for (int step = 1; step < 12; ++step) {
        program.scene().place(2, corner(-1, step));
        program.scene().place(3, corner(1, -step));
        program.draw_event();
        const l3d_frame_report report = program.report();
        EXPECT_GT(program.changed().area(), odd.width * odd.height / 2);
        EXPECT_GT(report.pixels_kept, odd.width * odd.height * 9 / 10);
        EXPECT_GE(report.dice.unchanged, 56); // some of a small one lie beside any centre
        EXPECT_LE(report.dice.unchanged + report.dice.drawn, report.patches);
        EXPECT_EQ(program.words(), drawn_whole(program)) << step;
    }
}

TEST(still_picture, is_drawn_whole_if_all_is_kept_or_depth_is_asked_for) {
    for (const bool depth : {false, true}) {
        pair_of_teapots s;
        s.settings.depth = depth;
        if (!depth)
            s.settings.keep = l3d_kept_work::all();
        tester program(s.scene, s.camera, s.settings);
        for (int step = 0; step < 4; ++step) {
            program.scene().place(1, pair_of_teapots::right(step / 2));
            program.draw_event();
            const bool still = depth && step % 2 == 1;
            EXPECT_EQ(program.report().pixels_kept, still ? odd.width * odd.height : 0) << step;
        }
    }
}

TEST(still_picture, is_drawn_beneath_what_comes_and_goes_on_top) {
    const pair_of_teapots s;
    tester program(s.scene, s.camera, s.settings);
    random_numbers random(5);
    for (int frame = 0; frame < 60; ++frame) {
        program.text_at = random() % 3 == 0 ? 1 + static_cast<int>(random() % 90) : 0;
        program.redraw();
        if (random() % 3 == 0)
            program.scene().place(1, pair_of_teapots::right(frame));
        if (random() % 7 == 0)
            program.settings().net = !program.settings().net;
        if (random() % 7 == 0)
            program.settings().wireframe = !program.settings().wireframe;
        program.draw_event();
        ASSERT_EQ(program.words(), drawn_whole(program)) << frame;
    }
}

TEST(still_picture, is_drawn_whole_where_others_wrote_or_its_size_changed) {
    const pair_of_teapots s;
    tester program(s.scene, s.camera, s.settings);
    program.draw_event();
    program.pixels().row(7)[11] = 0x00abcdef;
    program.draw_event();
    EXPECT_EQ(program.report().pixels_kept, 0);
    EXPECT_EQ(program.words(), drawn_whole(program));
    for (const l3d_size size : {l3d_size{130, 200}, odd}) {
        program.resize(size);
        EXPECT_TRUE(program.needs_redraw());
        program.draw_event();
        EXPECT_EQ(program.changed(), l3d_whole(size));
        EXPECT_EQ(program.words(), drawn_whole(program, size));
    }
}

TEST(still_picture, follows_camera_settings_and_what_comes_and_goes) {
    pair_of_teapots s;
    tester program(s.scene, s.camera, s.settings);
    const auto differs = [&](const char* what) {
        program.draw_event();
        EXPECT_EQ(program.report().pixels_kept, 0) << what;
        EXPECT_EQ(program.words(), drawn_whole(program)) << what;
    };
    differs("first");
    program.camera().orbit(0.6, 0);
    differs("camera");
    program.settings().shade = l3d_shade::flat;
    differs("shade");
    program.settings().light = {1, 0.2, 0.3};
    differs("light");
    program.settings().tolerance = 1;
    differs("tolerance");
    program.scene().add(s.teapot, l3d_translation<double>(0, 2, 0));
    differs("a model more");
    program.scene().clear();
    differs("none");
}

TEST(still_picture, is_the_same_bits_by_the_slow_twin) {
    for (std::uint64_t seed = 0; seed < (thorough ? 60 : 15); ++seed)
        compare<scalar_factory>(seed, 6, 1);
}

} // namespace
