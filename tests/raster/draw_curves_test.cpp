// SPDX-License-Identifier: MIT
// draw_curves: runs of pixels against the curve itself, evaluated exactly.
#include "raster/canvas_2d.h"
#include "raster/paths/curve_pixels_p.h"
#include "raster/paths/path.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace {

double uniform(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

using wide_curve = l3d_bezier_curve<long double, 3>;

struct wide_point {
    long double x, y;
};

/// Any curve: of any size, with cusps, loops, nearly straight, rational or not.
l3d_curve_2d random_curve(std::mt19937& random, double most) {
    const double size = std::pow(10, uniform(random, -3, most));
    l3d_curve_2d curve;
    const int manner = static_cast<int>(random() % 5);
    const double x = uniform(random, -size, size), y = uniform(random, -size, size);
    for (int i = 0; i < 4; ++i) {
        double px = uniform(random, -size, size), py = uniform(random, -size, size);
        if (manner == 1) { // nearly straight
            px = x * i + uniform(random, -1, 1);
            py = y * i + uniform(random, -1, 1);
        } else if (manner == 2 && i > 1) { // a cusp or a loop: the legs cross
            px = i == 2 ? -x : x;
            py = i == 2 ? y : -y;
        } else if (manner == 3) { // where samples and their borders are
            px = std::round(px * 2) / 2;
            py = std::round(py * 2) / 2;
        }
        const double w = manner == 4 ? std::exp(uniform(random, -3, 3)) : 1;
        curve.points[static_cast<std::size_t>(i)] = {px * w, py * w, w};
    }
    return curve;
}

class judge {
public:
    explicit judge(const l3d_curve_2d& curve) {
        wide_curve wide;
        for (std::size_t i = 0; i < 4; ++i)
            wide.points[i] = {curve.points[i][0], curve.points[i][1], curve.points[i][2]};
        // As many points as pixels' eighths, by the control polygon's speed.
        const int count = 16 + static_cast<int>(8 * l3d_detail::pixel_steps(curve));
        for (int i = 0; i <= count; ++i) {
            const auto p = wide.evaluate(static_cast<long double>(i) / count);
            points_.push_back({p[0] / p[2], p[1] / p[2]});
        }
    }

    const std::vector<wide_point>& points() const { return points_; }

private:
    std::vector<wide_point> points_;
};

struct pixel {
    std::int64_t x, y;
};

void test_curves(int count, unsigned seed, double most) {
    std::mt19937 random(seed);
    const l3d_detail::seen_box everything{-1e9, -1e9, 1e9, 1e9};
    long double farthest = 0;
    for (int n = 0; n < count; ++n) {
        const l3d_curve_2d curve = random_curve(random, most);
        std::vector<pixel> run;
        const auto light = [&](std::int64_t x, std::int64_t y) { run.push_back({x, y}); };
        {
            l3d_detail::thin_run<decltype(light)> thin(light);
            l3d_detail::walk_curve(curve, everything, thin);
        }
        ASSERT_FALSE(run.empty());
        for (std::size_t i = 1; i < run.size(); ++i) {
            const auto dx = std::abs(run[i].x - run[i - 1].x);
            const auto dy = std::abs(run[i].y - run[i - 1].y);
            ASSERT_TRUE(std::max(dx, dy) == 1) << "seed " << seed << ", curve " << n;
        }
        // Along both in order: a pixel is near a point that is not before the last one's, and each
        // point is near the pixel reached.
        const judge exact(curve);
        const auto& p = exact.points();
        const auto off = [&](const pixel& at, const wide_point& q) {
            return std::max(std::abs(at.x - q.x), std::abs(at.y - q.y));
        };
        std::size_t at = 0;
        for (const wide_point& q : p) {
            while (off(run[at], q) > 2 + 0x1p-20L && at + 1 < run.size())
                ++at;
            ASSERT_LE(off(run[at], q), 2 + 0x1p-20L) << "seed " << seed << ", curve " << n;
        }
        std::size_t near = 0;
        for (const pixel& lit : run) {
            // points lie an eighth of a pixel apart: the nearest one is that much off at most
            while (off(lit, p[near]) > 0.5L + 0.125L && near + 1 < p.size())
                ++near;
            ASSERT_LE(off(lit, p[near]), 0.5L + 0.125L) << "seed " << seed << ", curve " << n;
            farthest = std::max(farthest, off(lit, p[near]));
        }
    }
    EXPECT_GT(farthest, 0.5L);
}

TEST(draw_curves, light_the_pixels_nearest_to_the_curve_and_miss_none) {
    test_curves(1500, 1, 1.5);
    test_curves(60, 1, 2.5);
}

/// Takes minutes: make stress.
TEST(draw_curves, DISABLED_light_the_pixels_nearest_to_a_million_curves_and_miss_none) {
    test_curves(1000000, 2, 1.5);
    test_curves(300, 3, 5);
}

/// Each point that the walk goes through, against the same parameter evaluated in long double.
TEST(draw_curves, walk_along_the_curve_within_a_millionth_of_a_pixel) {
    std::mt19937 random(4);
    long double worst = 0;
    for (int n = 0; n < 3000; ++n) {
        const l3d_curve_2d curve = random_curve(random, 2);
        if (l3d_detail::pixel_steps(curve) > 512)
            continue;
        wide_curve wide;
        for (std::size_t i = 0; i < 4; ++i)
            wide.points[i] = {curve.points[i][0], curve.points[i][1], curve.points[i][2]};
        l3d_detail::adaptive_walk walk(curve);
        l3d_point_2d last = walk.at();
        while (!walk.done()) {
            walk.step();
            const l3d_point_2d at = walk.at();
            ASSERT_LE(std::max(std::abs(at.x - last.x), std::abs(at.y - last.y)), 1 + 0x1p-20);
            last = at;
            const auto p = wide.evaluate(static_cast<long double>(walk.parameter()));
            worst = std::max({worst, std::abs(p[0] / p[2] - at.x), std::abs(p[1] / p[2] - at.y)});
        }
    }
    EXPECT_LT(worst, 0x1p-20L);
    EXPECT_GT(worst, 0x1p-60L);
}

TEST(draw_curves, draw_the_same_pixels_however_much_is_outside) {
    std::mt19937 random(5);
    for (int n = 0; n < 300; ++n) {
        canvas whole(140, 110), part(40, 30);
        l3d_path path;
        const auto place = [&] {
            return l3d_point_2d{std::round(uniform(random, -200, 600)) / 4,
                                std::round(uniform(random, -200, 500)) / 4};
        };
        path.move_to(place());
        for (int i = 0; i < 3; ++i) {
            path.cubic_to(place(), place(), place());
            path.line_to(place());
            path.rational_to({place(), place(), place()}, {2, 0.5, 3});
        }
        path.close();
        whole.draw.draw_curves(path, canvas::color);
        part.draw.draw_curves(path, canvas::color);
        for (int y = 0; y < 30; ++y)
            for (int x = 0; x < 40; ++x)
                ASSERT_EQ(part.at(x, y), whole.at(x, y)) << n << ": " << x << ' ' << y;
        ASSERT_TRUE(part.guards_intact() && whole.guards_intact());
    }
}

} // namespace
