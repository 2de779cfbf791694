// SPDX-License-Identifier: MIT
// l3d_drawn_pixels: nothing is drawn beside what it names.
#include "still_studio.h"

#include "scene/drawn_pixels.h"
#include "scene/image_transform.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace {

using namespace still_tests;

/// Alone in a picture and of colours that are not the background's, a model shows where it is.
TEST(drawn_pixels, are_all_that_is_drawn) {
    random_numbers random(20261121);
    int tested = 0;
    double kept = 0;
    for (int i = 0; i < 600; ++i) {
        studio s(random());
        const l3d_patch_model& model = s.any_model();
        l3d_patch_scene alone;
        alone.add(model, s.any_place());
        s.settings.shade = l3d_shade::lambert;
        tester program(alone, s.camera, s.settings);
        program.draw_event();

        const l3d_image_transform to_image(s.camera, odd, alone);
        l3d_pixel_boxes boxes; // of one model there is one
        l3d_drawn_pixels(alone.boxes(), to_image.matrix(), to_image.view(s.settings.tolerance),
                         boxes);
        const l3d_pixel_box box = boxes.around();
        int outside = 0, inside = 0;
        for (int y = 0; y < odd.height; ++y)
            for (int x = 0; x < odd.width; ++x) {
                const bool in = x >= box.left && x < box.right && y >= box.top && y < box.bottom;
                (in ? inside : outside) +=
                    program.screen().pixels().row(y)[static_cast<std::size_t>(x)] != 0;
            }
        ASSERT_EQ(outside, 0) << i;
        if (inside > 0) {
            ++tested;
            kept += inside / static_cast<double>(box.area());
        }
    }
    std::printf("%d models, each covers %.2f of its box on average\n", tested, kept / tested);
    EXPECT_GT(tested, 200);
    EXPECT_GT(kept / tested, 0.05) << "boxes are too large";
}

} // namespace
