// SPDX-License-Identifier: MIT
// Far points cost near ones nothing: each patch has the rounding errors of its own points.
#include "picture.h"
#include "scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace {

using namespace dice_tests;

constexpr l3d_size size{320, 240};
constexpr double tolerance = 0.25;

/// A flat square of `width` around a place, across the x axis.
reference::patch square(double x, double width) {
    reference::patch result;
    for (std::size_t i = 0; i < 16; ++i)
        result.points[i] = {x, (static_cast<double>(i % 4) / 3 - 0.5) * width,
                            (static_cast<double>(i / 4) / 3 - 0.5) * width};
    return result;
}

/// The teapot seen along the x axis, from before the origin: what has a large x is behind it, what
/// has a small one behind the eye.
scene teapot_and(std::vector<reference::patch> more) {
    std::vector<reference::patch> patches = reference::load_bpt_plain("data/teapot.bpt");
    patches.insert(patches.end(), more.begin(), more.end());
    reference::camera eye;
    eye.eye = {-7, 3, 2};
    eye.target = {0, 1, 0};
    eye.up = {0, 1, 0};
    eye.fov_degrees = 45;
    eye.near = 0.1;
    return {patches, eye, size};
}

/// The dicer's result for the patches of the teapot: all vertices, and the pieces' bounds.
struct diced_teapot {
    std::vector<std::vector<std::int32_t>> x, y;
    double bound = 0;
    l3d_dice_counts counts;
};

template <class T> diced_teapot dice_teapot(const scene& s) {
    diced_teapot result;
    result.x.resize(28);
    result.y.resize(28);
    result.counts = scene_dicer<T>().dice(s, tolerance, [&](std::size_t i, diced pieces, double) {
        if (i >= result.x.size())
            return;
        for (const l3d_diced_piece& piece : pieces) {
            const auto& grid = piece.part.grid;
            for (int row = 0; row < grid.rows; ++row)
                for (int column = 0; column < grid.columns; ++column) {
                    const std::size_t at = grid.index(row, column);
                    result.x[i].push_back(grid.x[at]);
                    result.y[i].push_back(grid.y[at]);
                }
            result.bound = std::max(result.bound, piece.bound);
        }
    });
    return result;
}

template <class T> class far_point : public testing::Test {};
TYPED_TEST_SUITE(far_point, number_types);

TYPED_TEST(far_point, leaves_the_others_their_bounds) {
    const diced_teapot alone = dice_teapot<TypeParam>(teapot_and({}));
    ASSERT_LE(alone.bound, tolerance);
    for (const double x : {-1e11, -1e12, 1e11, 1e12}) {
        SCOPED_TRACE(testing::Message() << "a square at x = " << x);
        const diced_teapot beside = dice_teapot<TypeParam>(teapot_and({square(x, 3)}));
        EXPECT_EQ(beside.x, alone.x);
        EXPECT_EQ(beside.y, alone.y);
        EXPECT_NEAR(beside.bound, alone.bound, 1e-9);
        EXPECT_EQ(beside.counts.samples, alone.counts.samples);
        EXPECT_NEAR(beside.counts.bound_px, alone.counts.bound_px, 1e-9);
    }
}

/// A patch that is near and far has the errors of its far points; the others have not.
TYPED_TEST(far_point, of_a_patch_is_its_own_trouble) {
    const diced_teapot alone = dice_teapot<TypeParam>(teapot_and({}));
    reference::patch wide = square(-1e11, 3);
    for (std::size_t i = 0; i < 4; ++i)
        wide.points[i] = {-3, 0, -static_cast<double>(i)};
    const diced_teapot beside = dice_teapot<TypeParam>(teapot_and({wide}));
    EXPECT_EQ(beside.x, alone.x);
    EXPECT_EQ(beside.y, alone.y);
    EXPECT_NEAR(beside.bound, alone.bound, 1e-9);
}

/// The left half is ordinary, the right one reaches far beyond the window: their errors differ by
/// ten orders of magnitude, and still both draw the same edge.
TYPED_TEST(far_point, opens_no_slit_to_a_neighbour) {
    reference::camera eye;
    eye.eye = {0, 0, 10};
    eye.target = {0, 0, 0};
    eye.up = {0, 1, 0};
    eye.fov_degrees = 30;
    for (const double near : {0.1, 8.0})
        for (const double far : {1e2, 1e9, 1e11, 1e12}) {
            SCOPED_TRACE(testing::Message() << "far " << far << ", near " << near);
            eye.near = near;
            reference::patch left, right;
            for (std::size_t i = 0; i < 16; ++i) {
                const std::size_t column = i % 4;
                const double y = static_cast<double>(i / 4) * 20 - 30,
                             z = static_cast<double>(i * 7 % 5) * 0.8;
                left.points[i] = {static_cast<double>(column) * 5 - 15, y, z};
                right.points[i] = {column == 3 ? far : static_cast<double>(column) * 5, y, z};
            }
            for (std::size_t i = 0; i < 16; i += 4)
                right.points[i] = left.points[i + 3];
            const scene s({left, right}, eye, size);
            picture drawn(size);
            const l3d_dice_counts counts = dice<TypeParam>(s, tolerance, drawn);
            EXPECT_EQ(drawn.uncovered(), 0);
            EXPECT_EQ(counts.drawn, 2);
        }
}

} // namespace
