// SPDX-License-Identifier: MIT
// l3d_pipeline_world: rows "Free-fly keys" and "Status overlay" of the book's table.
#include "pipeline/worlds/pipeline_world.h"

#include "raster/rasterizer_factory.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

/// A world with nothing but a few triangles before the camera.
struct flown {
    explicit flown(l3d_size size) : world(size), pipeline(l3d_memory_canvas(size), world) {
        world.camera.place = l3d_point<l3d_real>::of(0, 0, -50);
        l3d_polygon_mesh mesh;
        for (std::uint32_t i = 0; i < 3; ++i) {
            const double x = 3.0 * i;
            mesh.vertices.insert(mesh.vertices.end(), {{x, 1, 0}, {x + 2, 1, 0}, {x, -2, 0}});
            mesh.add_face({{3 * i, 3 * i + 1, 3 * i + 2}});
        }
        world.add(std::make_unique<l3d_object>(mesh));
    }

    void press(const char* keys) {
        for (; *keys; ++keys)
            pipeline.key_event(*keys);
    }
    void fly(double seconds) {
        for (int i = 0; i < seconds * l3d_book_rate; ++i)
            pipeline.update_event(1 / l3d_book_rate);
    }
    /// Lit pixels in some rows.
    int lit(int from_row, int rows) {
        int count = 0;
        for (int y = from_row; y < from_row + rows; ++y)
            for (const std::uint32_t word : pipeline.screen().pixels().row(y))
                count += word != 0;
        return count;
    }
    double forward(int axis) const { return l3d_to_double(world.camera.forward()[axis]); }
    double right(int axis) const { return l3d_to_double(world.camera.right()[axis]); }
    double place(int axis) const { return l3d_to_double(world.camera.place[axis]); }

    l3d_world world;
    l3d_pipeline_world pipeline;
};

TEST(book_pipeline_world, thrust_cycles) {
    flown f({64, 40});
    std::vector<double> thrusts{f.world.camera.thrust.up / l3d_book_rate};
    for (int i = 0; i < 6; ++i) {
        f.press(i % 2 ? "v" : "V");
        EXPECT_EQ(f.world.camera.thrust.up, f.world.camera.thrust.right);
        EXPECT_EQ(f.world.camera.thrust.up, f.world.camera.thrust.forward);
        thrusts.push_back(f.world.camera.thrust.up / l3d_book_rate);
    }
    const double wanted[] = {0.2, 1.2, 2.2, 0.2, 1.2, 2.2, 0.2};
    for (std::size_t i = 0; i < 7; ++i)
        EXPECT_NEAR(thrusts[i], wanted[i], 1e-12);
}

/// Where each key leads in two seconds, seen from a camera that looks along z with y up.
TEST(book_pipeline_world, keys_turn) {
    const auto after = [](const char* keys, auto look) {
        flown f({64, 40});
        f.press(keys);
        f.fly(2);
        return look(f);
    };
    const auto forward_x = [](const flown& f) { return f.forward(0); };
    const auto forward_y = [](const flown& f) { return f.forward(1); };
    const auto right_y = [](const flown& f) { return f.right(1); };
    EXPECT_LT(after("j", forward_x), -0.1); // left
    EXPECT_GT(after("l", forward_x), 0.1);
    EXPECT_LT(after("I", forward_y), -0.1); // the nose goes down
    EXPECT_GT(after("K", forward_y), 0.1);
    EXPECT_GT(after("J", right_y), 0.1); // the right wing goes up
    EXPECT_LT(after("L", right_y), -0.1);
    EXPECT_NEAR(after("jl", forward_x), 0, 1e-6);
}

TEST(book_pipeline_world, keys_thrust) {
    const auto after = [](const char* keys, int axis) {
        flown f({64, 40});
        const double before = f.place(axis);
        f.press(keys);
        f.fly(4);
        return f.place(axis) - before;
    };
    EXPECT_NEAR(after("i", 2), 3.8, 0.01);
    EXPECT_NEAR(after("k", 2), -3.8, 0.01);
    EXPECT_NEAR(after("s", 0), -3.8, 0.01);
    EXPECT_NEAR(after("f", 0), 3.8, 0.01);
    EXPECT_NEAR(after("e", 1), 3.8, 0.01);
    EXPECT_NEAR(after("d", 1), -3.8, 0.01);
    EXPECT_NEAR(after("vi", 2), 6 * 3.8, 0.05);
}

TEST(book_pipeline_world, keys_change_the_field_of_view) {
    flown f({64, 40});
    const double fovx = f.world.camera.fovx, fovy = f.world.camera.fovy;
    f.press("XXy");
    EXPECT_NEAR(f.world.camera.fovx, fovx + 0.2, 1e-12);
    EXPECT_NEAR(f.world.camera.fovy, fovy - 0.1, 1e-12);
    f.press("xxY");
    EXPECT_NEAR(f.world.camera.fovx, fovx, 1e-12);
    EXPECT_NEAR(f.world.camera.fovy, fovy, 1e-12);
    f.press("xxxxxxxxxx");
    EXPECT_GT(f.world.camera.fovx, 0);
    // The picture changes with it; the book's keys change numbers that nobody reads.
    f.pipeline.draw_event();
    const int wide = f.lit(0, 40);
    f.press("XXXXXXXXXX");
    f.pipeline.draw_event();
    EXPECT_GT(f.lit(0, 40), 2 * wide);
}

TEST(book_pipeline_world, keys_stop_and_quit) {
    flown f({64, 40});
    f.press("0");
    EXPECT_TRUE(f.world.frozen);
    f.press("1");
    EXPECT_FALSE(f.world.frozen);
    EXPECT_FALSE(f.pipeline.done);
    f.press("q");
    EXPECT_TRUE(f.pipeline.done);
    EXPECT_EQ(f.forward(2), 1); // q is not j, as it may be in the book
}

TEST(book_pipeline_world, status_overlay) {
    flown f({160, 120});
    f.pipeline.draw_event();
    EXPECT_EQ(f.lit(0, 25), 0);
    const int triangles = f.lit(25, 95);
    EXPECT_GT(triangles, 10);
    f.press("n");
    f.pipeline.draw_event();
    EXPECT_GT(f.lit(0, 9), 5);
    EXPECT_GT(f.lit(16, 9), 20);
    EXPECT_EQ(f.lit(25, 95), triangles);
    // "3 polys drawn" and "0 polys drawn" differ.
    const int three = f.lit(16, 9);
    f.world.camera.place = l3d_point<l3d_real>::of(0, 0, 50);
    f.pipeline.draw_event();
    EXPECT_NE(f.lit(16, 9), three);
    f.press("N");
    f.pipeline.draw_event();
    EXPECT_EQ(f.lit(0, 120), 0);
}

TEST(book_pipeline_world, resize_keeps_squares) {
    flown f({160, 120});
    f.pipeline.resize_event({240, 120});
    EXPECT_NEAR(f.world.camera.fovx * 240, f.world.camera.fovy * 120, 1e-9);
}

} // namespace
