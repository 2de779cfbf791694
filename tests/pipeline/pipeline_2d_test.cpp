// SPDX-License-Identifier: MIT
// The services that programs get from their base class.
#include "pipeline/pipeline_2d.h"
#include "raster/rasterizer_factory.h"
#include "sizable_screen.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace {

using pipeline_tests::sizable_screen;

constexpr std::uint32_t red = 0xFF0000;

/// Adds a point with each draw_event, further right each time.
class points final : public l3d_pipeline_2d {
public:
    using l3d_pipeline_2d::l3d_pipeline_2d;

private:
    void draw(l3d_rasterizer_2d& rasterizer) override { rasterizer.draw_point(x_++, 5, red); }

    int x_ = 3;
};

class pipeline_2d : public testing::Test {
protected:
    l3d_pixels pixels() { return screen.pixels(); }

    std::unique_ptr<sizable_screen> owned = std::make_unique<sizable_screen>(l3d_size{37, 23});
    sizable_screen& screen = *owned;
    points pipeline{{std::move(owned), std::make_shared<l3d_rasterizer_factory_sw>()}};
};

} // namespace

TEST_F(pipeline_2d, draws_on_top_of_the_last_picture) {
    pipeline.draw_event();
    pipeline.draw_event();
    EXPECT_EQ(pixels().row(5)[3], red);
    EXPECT_EQ(pixels().row(5)[4], red);
    EXPECT_EQ(pixels().row(5)[5], 0u);
}

TEST_F(pipeline_2d, row_7_the_last_pixel_of_a_new_size_can_be_drawn) {
    pipeline.draw_event();
    screen.resize({53, 31});
    std::ranges::fill(pixels().row(5), 0xABCDEFu); // nobody promises what is in new pixels
    pipeline.resize_event({53, 31});
    EXPECT_EQ(pipeline.size(), (l3d_size{53, 31}));
    for (int x = 4; x < 53; ++x)
        pipeline.draw_event();
    EXPECT_EQ(pixels().row(5)[52], red);
    EXPECT_EQ(pixels().row(5)[3], 0u) << "a new size begins with an empty picture";
}

TEST_F(pipeline_2d, ends_by_q_and_escape_only) {
    for (int key = 0; key < 0x120; ++key) {
        pipeline.done = false;
        pipeline.key_event(key);
        EXPECT_EQ(pipeline.done, key == 'q' || key == l3d_key_escape) << key;
    }
}
