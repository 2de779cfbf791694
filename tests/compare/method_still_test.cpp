// SPDX-License-Identifier: MIT
// Every method draws each picture as a new program would.
#include "pipeline/still_studio.h"

#include "compare/method_choice.h"
#include "tool_2d/error.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <optional>
#include <string>

namespace {

using namespace still_tests;

/// Each model lives nowhere but in the scene, and the next one may come to the same memory.
TEST(method_still_picture, of_models_that_come_and_go_is_that_of_a_new_program) {
    for (const char* method : {"afd", "tessellation:8", "voxels:32", "mesa"}) {
        random_numbers random(707);
        l3d_camera camera;
        camera.eye = {0.3, 0.2, 7};
        l3d_afd_settings settings;
        std::string why;
        settings.method = l3d_method_choice::from_name(method, why).value().factory();
        std::optional<tester> program;
        try {
            program.emplace(wild_model(random, 2), camera, settings);
        } catch (const l3d_error& error) {
            std::printf("%s left out: %s\n", method, error.what());
            continue;
        }
        for (int frame = 0; frame < 6; ++frame) {
            program->draw_event();
            tester fresh(program->scene(), camera, settings);
            fresh.draw_event();
            EXPECT_EQ(program->words(), fresh.words()) << method << ", frame " << frame;
            if (frame < 3) {
                program->scene().place(0, wild_model(random, 2), l3d_identity<double>());
            } else {
                program->scene().clear();
                program->scene().add(wild_model(random, 2));
            }
        }
    }
}

} // namespace
