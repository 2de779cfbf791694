// SPDX-License-Identifier: MIT
// Means over pixels against brute force, and against means of fewer samples.
#include "effort.h"
#include "reference/box_image.h"
#include "reference/second_judge.h"
#include "reference/views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <utility>
#include <vector>

namespace reference {
namespace {

/// 64 x 64 lines of sight of the second judge, at the middles of their cells.
struct supersampled {
    double level = 0;
    double unsure = 0; ///< levels: half of what light changes about each sample
};
supersampled look_often(const second_judge& judge, const camera_frame& frame, int x, int y) {
    constexpr int side = 64;
    std::vector<double> light;
    const double length =
        std::sqrt(project_light.x * project_light.x + project_light.y * project_light.y +
                  project_light.z * project_light.z);
    for (int k = 0; k < side * side; ++k) {
        const int column = k % side, row = k / side;
        const double px = x + (column + 0.5) / side, py = y + (row + 0.5) / side;
        const second_sample seen = judge.look(px, py);
        light.push_back(0);
        if (!seen.covered())
            continue;
        const vec3 place = frame.unproject(px, py, seen.w);
        const vec3& n = seen.normal;
        const double away = n.x * (place.x - static_cast<double>(frame.eye[0])) +
                            n.y * (place.y - static_cast<double>(frame.eye[1])) +
                            n.z * (place.z - static_cast<double>(frame.eye[2]));
        const double cosine =
            (n.x * project_light.x + n.y * project_light.y + n.z * project_light.z) / length;
        light.back() =
            light_of_level(255 * (0.1 + 0.9 * std::max(0.0, away > 0 ? -cosine : cosine)));
    }
    double sum = 0, change = 0;
    for (int k = 0; k < side * side; ++k) {
        const auto at = [&](int i, int j) {
            const int place = std::clamp(j, 0, side - 1) * side + std::clamp(i, 0, side - 1);
            return light[static_cast<std::size_t>(place)];
        };
        const int i = k % side, j = k / side;
        const auto [low, high] =
            std::minmax({at(i, j), at(i - 1, j), at(i + 1, j), at(i, j - 1), at(i, j + 1)});
        sum += at(i, j);
        change += (high - low) / 2;
    }
    constexpr double cells = side * side;
    const double level = level_of_light(sum / cells);
    return {level, std::max(level_of_light((sum + change) / cells) - level,
                            level - level_of_light(std::max(sum - change, 0.0) / cells))};
}

TEST(box_image, of_the_teapot_is_what_many_samples_say) {
    const std::vector<patch> teapot = load_bpt_plain("data/teapot.bpt");
    const camera& eye = project_view("full").eye;
    constexpr picture_size size{160, 120};
    const box_image image(teapot, eye, size, project_light);
    const second_judge judge(teapot, eye, size);
    const camera_frame frame(eye, size);
    int edges = 0, compared = 0;
    double squares = 0, largest = 0, unsure = 0, most_unsure = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const box_pixel& found = image.at(x, y);
            most_unsure = std::max(most_unsure, found.unsure);
            if (!found.edge || edges++ % 50 != 0)
                continue;
            const supersampled known = look_often(judge, frame, x, y);
            const double off = std::abs(found.level - known.level);
            EXPECT_LE(off, found.unsure + known.unsure) << x << ", " << y;
            ++compared;
            squares += off * off;
            largest = std::max(largest, off);
            unsure += found.unsure;
        }
    const double rms = std::sqrt(squares / compared);
    std::printf("%d of %d edge pixels: from 64 x 64 samples rms %.3f levels, largest %.3f; sure to "
                "%.3f in the mean, %.3f at worst\n",
                compared, edges, rms, largest, unsure / compared, most_unsure);
    EXPECT_GT(compared, 40);
    EXPECT_LT(rms, 0.1); // 64 x 64 samples are off by that much
    EXPECT_LE(most_unsure, image.settings().wanted);
}

/// What is sure to be so with few samples is so with many.
TEST(box_image, of_few_samples_and_of_many_agree) {
    const std::vector<patch> teapot = load_bpt_plain("data/teapot.bpt");
    constexpr picture_size size{64, 48};
    for (const char* name : {"inside", "full"}) {
        if (!thorough && name == std::string_view("full"))
            continue;
        const camera& eye = project_view(name).eye;
        const box_image many(teapot, eye, size, project_light);
        const box_image few(teapot, eye, size, project_light,
                            {.cells = 2, .edge_cells = 4, .most_lines = 5});
        double unsure = 0, largest = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const box_pixel &p = few.at(x, y), &q = many.at(x, y);
                EXPECT_LE(std::abs(p.level - q.level), p.unsure + q.unsure)
                    << name << ": " << x << ", " << y;
                unsure = std::max(unsure, p.unsure);
                largest = std::max(largest, std::abs(p.level - q.level));
            }
        std::printf("%-8s 4 x 4 samples are off by up to %.3f levels, sure to %.3f\n", name,
                    largest, unsure);
        EXPECT_GT(largest, 0.05);
    }
}

} // namespace
} // namespace reference
