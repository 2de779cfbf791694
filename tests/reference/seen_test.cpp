// SPDX-License-Identifier: MIT
// The verdict of the judge of grey levels on pictures whose faults are known.
#include "reference/seen.h"
#include "reference/measure.h"
#include "reference/region.h"
#include "reference/views.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace reference {
namespace {

constexpr picture_size size{240, 180};
constexpr seen_bounds bounds{0.25, 0.25};

/// The exact picture of the teapot, to be spoilt.
class seen : public testing::Test {
protected:
    seen() {
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                distances.push_back(static_cast<float>(exact.at(x, y).w));
    }

    seen_picture judged() const {
        return judge_seen(greys, distances, exact, second, bounds, project_light);
    }

    static std::size_t place(int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
               static_cast<std::size_t>(x);
    }

    const std::vector<patch> teapot = load_bpt_plain("data/teapot.bpt");
    const camera& eye = project_view("full").eye;
    const exact_image exact{teapot, eye, size};
    const second_judge second{teapot, eye, size};
    std::vector<unsigned char> greys = exact.lambert(project_light);
    std::vector<float> distances;
};

/// In the middle of the body, on its bright side.
constexpr int inside_x = 112, inside_y = 110;

TEST_F(seen, finds_no_fault_with_the_exact_picture) {
    const seen_picture found = judged();
    EXPECT_EQ(found.largest, 0);
    EXPECT_EQ(found.rms, 0);
    EXPECT_TRUE(found.far.empty());
    EXPECT_TRUE(found.sparks.empty());
    EXPECT_EQ(found.drawn_sparks, found.exact_sparks);
    EXPECT_EQ(found.holes, 0);
    EXPECT_EQ(found.histogram[0], found.shown);
    EXPECT_EQ(found.judged + found.outline_pixels(), found.shown);
    // Half of a pixel's width along outlines: 0.25 px to both sides.
    EXPECT_GT(found.judged_share(), 0.96);
    EXPECT_LT(found.judged_share(), 0.99);
    EXPECT_LT(found.judged_depth_px, 1e-4);
}

TEST_F(seen, tells_a_spark_and_a_dull_pixel_from_what_is_near_enough) {
    auto& spoilt = greys[place(inside_x, inside_y)];
    spoilt = static_cast<unsigned char>(spoilt - far_levels);
    EXPECT_TRUE(judged().far.empty());
    --spoilt;
    seen_picture found = judged();
    ASSERT_EQ(found.far.size(), 1u);
    EXPECT_EQ(found.far[0].x, inside_x);
    EXPECT_EQ(found.far[0].y, inside_y);
    EXPECT_EQ(found.far[0].exact - found.far[0].drawn, far_levels + 1);
    EXPECT_EQ(found.judged_largest, far_levels + 1);
    // Beside it, levels differ by less than 10.
    const int wanted = found.far[0].exact;
    spoilt = static_cast<unsigned char>(wanted - spark_levels + 10);
    EXPECT_TRUE(judged().sparks.empty());
    spoilt = static_cast<unsigned char>(wanted - spark_levels - 10);
    found = judged();
    EXPECT_EQ(found.far_anywhere, 1);
    EXPECT_EQ(found.sparks.size(), 1u);
    EXPECT_EQ(std::accumulate(found.histogram.begin() + 1, found.histogram.end(), std::int64_t{0}),
              1);
}

TEST_F(seen, counts_a_hole_inside_a_sheet) {
    greys[place(inside_x, inside_y)] = 0;
    distances[place(inside_x, inside_y)] = std::numeric_limits<float>::infinity();
    const seen_picture found = judged();
    EXPECT_EQ(found.holes, 1);
    EXPECT_EQ(found.far.size(), 1u);
}

TEST_F(seen, forgives_what_an_outlines_bound_reaches_and_no_more) {
    // Pixels left of the body's outline, drawn although nothing is there.
    int near = 0, beyond = 0;
    const exact_region region(teapot, eye, size);
    for (int y = 60; y < 140; ++y) {
        int x = 0;
        while (!exact.covered(x, y))
            ++x;
        const double off = region.distance_to_exact_surface(x - 0.5, y + 0.5);
        greys[place(x - 1, y)] = 200;
        distances[place(x - 1, y)] = 8;
        near += off < bounds.place;
        beyond += off > 1.03 * bounds.place + 1e-3;
    }
    ASSERT_GT(near, 10);
    ASSERT_GT(beyond, 10);
    const seen_picture found = judged();
    EXPECT_GE(found.far_outlines, near);
    EXPECT_GE(found.far.size(), static_cast<std::size_t>(beyond));
    EXPECT_LE(found.far.size(), static_cast<std::size_t>(80 - near));
}

/// The first judge's outlines are all that there are, hidden ones and seams among them; what the
/// second one sees of borders and jumps has to be one.
TEST_F(seen, outlines_of_the_second_judge_are_those_of_the_first) {
    const exact_region region(teapot, eye, size);
    int outlines = 0;
    for (int y = 0; y < size.height; y += 2)
        for (int x = 0; x < size.width; x += 3) {
            const outline_kind kind = second.outline_within(x + 0.5, y + 0.5, 1);
            if (kind != outline_kind::border && kind != outline_kind::jump)
                continue;
            ++outlines;
            EXPECT_LE(region.distance_to_outline(x + 0.5, y + 0.5), 1) << x << ' ' << y;
        }
    EXPECT_GT(outlines, 100);
}

} // namespace
} // namespace reference
