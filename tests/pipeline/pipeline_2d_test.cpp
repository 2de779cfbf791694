// SPDX-License-Identifier: MIT
// The services that programs get from their base class.
#include "pipeline/pipeline_2d.h"
#include "raster/rasterizer_factory_sw.h"
#include "tool_2d/image.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace {

constexpr std::uint32_t red = 0xFF0000;

/// A memory screen that can be resized; nobody promises what is in the new pixels.
class test_screen final : public l3d_screen {
public:
    void resize(l3d_size size) {
        image_ = l3d_image(size, size.width + 3);
        std::ranges::fill(image_.pixels().row(5), 0xABCDEFu);
    }

private:
    l3d_pixels do_pixels() override { return image_.pixels(); }
    const l3d_screen_info& do_info() const override { return info_; }
    void do_show(const l3d_pixel_box&) override {}
    std::string do_describe() const override { return "test"; }
    bool do_next_event(l3d_event&) override { return false; }
    void do_wait(std::chrono::nanoseconds, int) override {}

    l3d_image image_{{37, 23}, 41};
    l3d_screen_info info_;
};

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

    std::unique_ptr<test_screen> owned = std::make_unique<test_screen>();
    test_screen& screen = *owned;
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
