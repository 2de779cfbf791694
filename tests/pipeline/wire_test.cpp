// SPDX-License-Identifier: MIT
// Wires: a line that neighbours share is one line.
#include "hard_edged.h"
#include "pipeline/pipeline_afd.h"
#include "pipeline/wire_p.h"
#include "words_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace {

TEST(wire, is_new_once_whichever_way_it_runs) {
    l3d_detail::shared_wires shared;
    EXPECT_TRUE(shared.add({-5, 7, 300, -20}));
    EXPECT_FALSE(shared.add({-5, 7, 300, -20}));
    EXPECT_FALSE(shared.add({300, -20, -5, 7}));
    EXPECT_TRUE(shared.add({-20, 300, 7, -5})); // the same numbers in other places
    EXPECT_TRUE(shared.add({7, -5, 300, -20}));
    EXPECT_TRUE(shared.add({7, 7, 7, 7}));
    EXPECT_FALSE(shared.add({7, 7, 7, 7}));
}

/// A square that bends towards the eye, from x = `left` on.
l3d_patch_model::patch bent_square(double left, double bend) {
    l3d_patch_model::patch result;
    for (std::size_t i = 0; i < 16; ++i) {
        const std::size_t row = i / 4, column = i % 4;
        const bool inner = row % 3 != 0 && column % 3 != 0;
        result.points[i] = {left + double(column) / 3, double(row) / 3 - 0.53, inner ? bend : 0};
    }
    return result;
}

class tester final : public l3d_pipeline_afd {
public:
    using l3d_pipeline_afd::l3d_pipeline_afd;
    std::vector<std::uint32_t> draw() {
        draw_event();
        return words_of(screen().pixels());
    }
};

constexpr int width = 320, height = 240;

/// Nets seen from behind, where one-sided surfaces are not drawn, so that nothing but lines is.
l3d_afd_settings as_nets() {
    l3d_afd_settings settings = hard_edged();
    settings.one_sided = true;
    settings.net = true;
    return settings;
}

l3d_afd_settings as_steps() {
    l3d_afd_settings settings = hard_edged();
    settings.wireframe = true;
    return settings;
}

std::vector<std::uint32_t> lines_of(std::vector<l3d_patch_model::patch> patches,
                                    l3d_afd_settings settings) {
    l3d_camera camera;
    camera.eye = {0.13, 0.07, -3};
    settings.threads = 1;
    settings.antialias = true;
    return tester(l3d_memory_canvas({width, height}), l3d_patch_model(std::move(patches)), camera,
                  settings)
        .draw();
}

/// Where either neighbour alone shows the same line, both show it no brighter.
void expect_common_lines_once(const l3d_afd_settings& settings) {
    const auto left = bent_square(-1, 0.1), right = bent_square(0, -0.2);
    const auto of_left = lines_of({left}, settings), of_right = lines_of({right}, settings),
               of_both = lines_of({left, right}, settings), of_none = lines_of({}, settings);
    std::size_t common = 0;
    for (std::size_t i = 0; i < of_both.size(); ++i)
        if (of_left[i] == of_right[i] && of_left[i] != of_none[i]) {
            ++common;
            EXPECT_EQ(of_both[i], of_left[i]) << i % width << ' ' << i / width;
        }
    EXPECT_GT(common, 50u);
}

TEST(wire, of_two_nets_is_drawn_once) {
    expect_common_lines_once(as_nets());
}

TEST(wire, of_two_patches_is_drawn_once) {
    expect_common_lines_once(as_steps());
}

} // namespace
