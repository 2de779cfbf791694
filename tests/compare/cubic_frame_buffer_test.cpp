// SPDX-License-Identifier: MIT
// The cubic frame buffer: rays against every filled cell, one by one.
#include "compare/cells/cubic_frame_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <utility>

namespace {

using place = l3d_cubic_frame_buffer::place;
using cell = std::array<int, 3>;

constexpr int resolution = 50; // no multiple of a brick
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Where the ray runs within a cell, [enters, leaves]; nothing if leaves < enters.
std::pair<double, double> stretch_in(const cell& c, const place& from, const place& along) {
    double enters = -infinity, leaves = infinity;
    for (std::size_t i = 0; i < 3; ++i) {
        const double a = (c[i] - from[i]) / along[i], b = (c[i] + 1 - from[i]) / along[i];
        enters = std::max(enters, std::min(a, b));
        leaves = std::min(leaves, std::max(a, b));
    }
    return {enters, leaves};
}

double middle_of(const cell& c, const place& from, const place& along) {
    double sum = 0, length = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        sum += (c[i] + 0.5 - from[i]) * along[i];
        length += along[i] * along[i];
    }
    return sum / length;
}

TEST(CubicFrameBuffer, RaysMeetTheFirstCell) {
    std::mt19937 random(7);
    const auto between = [&random](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 0x1p32;
    };
    l3d_cubic_frame_buffer buffer;
    buffer.reset(resolution);
    std::set<cell> filled;
    while (filled.size() < 900) {
        cell c;
        place middle;
        for (std::size_t i = 0; i < 3; ++i) {
            c[i] = static_cast<int>(between(0, resolution));
            middle[i] = c[i] + 0.5;
        }
        buffer.fill(middle, {1, 0, 0});
        filled.insert(c);
    }
    EXPECT_EQ(buffer.filled(), filled.size());
    int met = 0, missed = 0;
    for (int ray = 0; ray < 3000; ++ray) {
        place from, along;
        for (std::size_t i = 0; i < 3; ++i) {
            from[i] = between(-30, resolution + 30);
            along[i] = between(0, resolution) - from[i];
        }
        double nearest = infinity, t = infinity;
        bool grazes = false; // rounding decides
        for (const cell& c : filled) {
            const auto [enters, leaves] = stretch_in(c, from, along);
            const double at = middle_of(c, from, along);
            grazes = grazes || (std::abs(leaves - enters) < 1e-9 || std::abs(at) < 1e-9);
            if (enters < leaves && at >= 0 && enters < nearest) {
                nearest = enters;
                t = at;
            }
        }
        if (grazes)
            continue;
        const auto hit = buffer.first(from, along, 0);
        ASSERT_EQ(hit.has_value(), t < infinity) << ray;
        if (hit) {
            ASSERT_NEAR(hit->t, t, 1e-9) << ray;
        }
        (hit ? met : missed) += 1;
    }
    EXPECT_GT(met, 1000);
    EXPECT_GT(missed, 100);
}

TEST(CubicFrameBuffer, KeepsTheFirstNormalOfACell) {
    l3d_cubic_frame_buffer buffer;
    buffer.reset(9);
    buffer.fill({8.5, 8.5, 8.5}, {0, -1, 0});
    buffer.fill({8.1, 8.9, 8.2}, {1, 0, 0});
    buffer.fill({9.5, 0, 0}, {1, 0, 0}); // outside
    EXPECT_EQ(buffer.filled(), 1u);
    const auto hit = buffer.first({8.5, 8.5, 0}, {0, 0, 1}, 0);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->normal, (std::array<float, 3>{0, -1, 0}));
    EXPECT_FALSE(buffer.first({8.5, 8.5, 0}, {0, 0, 1}, 9));
}

} // namespace
