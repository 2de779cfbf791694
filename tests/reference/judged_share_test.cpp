// SPDX-License-Identifier: MIT
// What share of a picture is judged: a judge that looks away finds no fault.
#include "reference/measure.h"
#include "reference/views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace reference {
namespace {

std::vector<float> depth_of(const exact_image& image) {
    std::vector<float> result;
    for (int y = 0; y < image.size().height; ++y)
        for (int x = 0; x < image.size().width; ++x)
            result.push_back(static_cast<float>(image.at(x, y).w));
    return result;
}

/// Pixels that are covered, and so are their eight neighbours: more cannot be judged.
std::int64_t surrounded(const exact_image& image) {
    std::int64_t count = 0;
    for (int y = 1; y + 1 < image.size().height; ++y)
        for (int x = 1; x + 1 < image.size().width; ++x) {
            bool all = true;
            for (int k = 0; k < 9; ++k)
                all = all && image.covered(x - 1 + k % 3, y - 1 + k / 3);
            count += all;
        }
    return count;
}

/// A floor, 4 units wide and `depth` long, that is seen from the height 1.
patch floor_of(double depth) {
    patch result;
    for (std::size_t k = 0; k < 16; ++k) {
        const std::size_t row = k / 4;
        result.points[k] = {-2 + 4.0 / 3 * static_cast<double>(k % 4), 0,
                            -depth / 3 * static_cast<double>(row)};
    }
    return result;
}

/// The plane is seen more and more edge on, by an eye that leans over. A neighbour across the slant
/// is up to sqrt(2) pixels off if the plane is not followed to it. None of that is a jump.
TEST(judged_share, of_a_slanted_plane_is_all_that_has_neighbours) {
    const camera view{{0, 1, 3}, {0, 0.6, 0}, {1, 1, 0}, 50, 0.1};
    constexpr picture_size size{160, 120};
    for (const double depth : {1.0, 10.0, 100.0, 1000.0}) {
        const std::vector<patch> patches{floor_of(depth)};
        const exact_image exact(patches, view, size);
        const exact_region region(patches, view, size);
        const auto product = depth_of(exact);
        const measurement found = measure(product, exact, region);
        ASSERT_GT(found.covered_exact, 1000);
        EXPECT_EQ(found.depth_compared, surrounded(exact)) << depth;
        EXPECT_EQ(map_errors(product, exact, region, 1).compared, found.depth_compared);
        const auto grey = exact.lambert(project_light);
        EXPECT_EQ(measure_lambert(grey, product, exact, project_light).compared,
                  found.depth_compared);
    }
}

struct known_share {
    const char* view;
    double least;
};

/// 2.7 % of `full` and 3.2 % of `top` lie at outlines, jumps, sharp bends or the picture's border.
/// If distances are compared as if neighbours faced the eye, 29 % and 35 % are left out.
TEST(judged_share, of_the_teapot_is_all_but_its_outlines) {
    const std::vector<patch> teapot = load_bpt_plain("data/teapot.bpt");
    constexpr picture_size size{1024, 768};
    for (const known_share& known : {known_share{"full", 0.97}, known_share{"top", 0.96}}) {
        const camera& eye = project_view(known.view).eye;
        const exact_image exact(teapot, eye, size);
        const exact_region region(teapot, eye, size);
        const auto product = depth_of(exact);
        const measurement found = measure(product, exact, region);
        const shade_difference shade =
            measure_lambert(exact.lambert(project_light), product, exact, project_light);
        const auto inside = static_cast<double>(surrounded(exact));
        const double of_inside = static_cast<double>(found.depth_compared) / inside;
        std::printf("%-5s %ld pixels covered, %.2f %% judged, of those with neighbours %.2f %%\n",
                    known.view, static_cast<long>(found.covered_exact), 100 * found.depth_share(),
                    100 * of_inside);
        EXPECT_GT(found.depth_share(), known.least) << known.view;
        EXPECT_GT(of_inside, 0.98) << known.view;
        EXPECT_EQ(shade.share(), found.depth_share());
        EXPECT_EQ(map_errors(product, exact, region, 1).depth_share(), found.depth_share());
    }
}

} // namespace
} // namespace reference
