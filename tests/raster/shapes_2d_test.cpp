// SPDX-License-Identifier: MIT
// Polygons that share an edge, outlines, shaded polygons and smooth lines against their slow twins.
#include "raster/canvas_2d.h"
#include "raster/parallel/simd_target.h"
#include "raster/slow_2d.h"

#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace {

constexpr unsigned seed = 20010713;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

double uniform(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// All vector instructions in turn; the best again at the end.
class each_simd_target {
public:
    ~each_simd_target() { l3d_set_simd_target(""); }
    void next() { l3d_set_simd_target(names_[turn_++ % names_.size()]); }

private:
    std::vector<std::string> names_ = l3d_simd_targets();
    std::size_t turn_ = 0;
};

/// Positions that matter: inside, across the border, 10^6 pixels away; often on samples' rows or
/// columns, or in the same place.
l3d_point_2d corner(std::mt19937& random, double reach) {
    l3d_point_2d p{uniform(random, -reach, reach) + 17, uniform(random, -reach, reach) + 11};
    if (random() % 4 == 0)
        p.x = std::round(p.x);
    if (random() % 4 == 0)
        p.y = std::round(p.y);
    if (random() % 8 == 0)
        p.x = std::round(uniform(random, -3, 40));
    if (random() % 8 == 0)
        p.y = std::round(uniform(random, -3, 30));
    return p;
}

/// Two triangles on either side of a line: no gap, no double hit, and each as by the rule.
void test_pairs(int pairs, unsigned first_seed) {
    constexpr int width = 37, height = 23;
    constexpr std::array<double, 6> reaches{8, 40, 600, 33000, 1e6, 1e9};
    std::mt19937 random(first_seed);
    each_simd_target targets;
    canvas one(width, height), other(width, height);
    std::size_t lit = 0, shared = 0;
    for (int n = 0; n < pairs; ++n) {
        if (n % 64 == 0)
            targets.next();
        const double reach = reaches[random() % reaches.size()];
        const l3d_point_2d a = corner(random, reach), b = corner(random, reach);
        std::array<l3d_point_2d, 3> left{a, b, corner(random, reach)};
        std::array<l3d_point_2d, 3> right{b, a, corner(random, reach)};
        const slow_2d::outline l = slow_2d::rounded(left), r = slow_2d::rounded(right);
        // the same turn: they lie on different sides of the edge
        const bool apart = (slow_2d::doubled_area(l[0], l[1], l[2]) > 0) ==
                           (slow_2d::doubled_area(r[0], r[1], r[2]) > 0);
        one.draw.clear_buffer();
        other.draw.clear_buffer();
        one.draw.draw_polygon_flatshaded(left, canvas::color);
        other.draw.draw_polygon_flatshaded(right, canvas::color);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const bool in_left = one.at(x, y) != 0, in_right = other.at(x, y) != 0;
                ASSERT_TRUE(in_left == (slow_2d::winding(l, x, y) != 0) &&
                            in_right == (slow_2d::winding(r, x, y) != 0) &&
                            !(apart && in_left && in_right))
                    << "seed " << first_seed << ", pair " << n << ", pixel " << x << " " << y;
                lit += in_left + in_right;
                shared += apart && in_left && x + 1 < width && other.at(x + 1, y) != 0;
            }
    }
    EXPECT_TRUE(one.guards_intact() && other.guards_intact());
    EXPECT_GT(lit, static_cast<std::size_t>(pairs) * 20);
    EXPECT_GT(shared, static_cast<std::size_t>(pairs) / 10);
}

TEST(SharedEdges, HaveNoGapAndNoDoubleHit) {
    test_pairs(20000, seed);
}

/// Takes a minute: make stress.
TEST(SharedEdges, DISABLED_AMillionPairs) {
    test_pairs(1000000, seed + 1);
}

/// A fan around a point covers every pixel once, whatever is outside of the picture.
TEST(SharedEdges, FansCoverEverythingOnce) {
    constexpr int width = 31, height = 27;
    std::mt19937 random(seed + 2);
    each_simd_target targets;
    for (int n = 0; n < 2000; ++n) {
        targets.next();
        const l3d_point_2d middle = corner(random, 20);
        const double radius = n % 2 ? 200 : 1e6;
        const int count = 5 + static_cast<int>(random() % 9);
        std::vector<l3d_point_2d> rim;
        for (int i = 0; i < count; ++i) {
            const double angle = (i + uniform(random, 0, 0.9)) * 6.283185307179586 / count;
            rim.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        }
        std::vector<int> hits(std::size_t{width} * height);
        for (std::size_t i = 0; i < rim.size(); ++i) {
            canvas c(width, height);
            const std::array<l3d_point_2d, 3> t{middle, rim[i], rim[(i + 1) % rim.size()]};
            c.draw.draw_polygon_flatshaded(t, canvas::color);
            for (std::size_t k = 0; k < hits.size(); ++k)
                hits[k] += c.at(static_cast<int>(k) % width, static_cast<int>(k) / width) != 0;
        }
        ASSERT_EQ(std::ranges::count(hits, 1), width * height)
            << "seed " << seed + 2 << ", fan " << n;
    }
}

void expect_outlines(const std::vector<std::vector<l3d_point_2d>>& outlines, l3d_winding inside,
                     canvas& c, int width, int height, const std::string& name) {
    std::vector<l3d_outline_2d> views(outlines.begin(), outlines.end());
    c.draw.clear_buffer();
    c.draw.draw_outlines(views, inside, canvas::color);
    std::vector<slow_2d::outline> exact;
    for (const auto& o : outlines)
        exact.push_back(slow_2d::rounded(o));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            int turns = 0;
            for (const slow_2d::outline& o : exact)
                turns += slow_2d::winding(o, x, y);
            const bool expected = inside == l3d_winding::nonzero ? turns != 0 : turns % 2 != 0;
            ASSERT_EQ(c.at(x, y) != 0, expected) << name << ", pixel " << x << " " << y;
        }
}

TEST(Outlines, AreExactHoweverTheyCross) {
    constexpr int width = 41, height = 33;
    std::mt19937 random(seed + 3);
    each_simd_target targets;
    canvas c(width, height);
    for (int n = 0; n < 4000; ++n) {
        targets.next();
        const double reach = std::array<double, 4>{15, 40, 3000, 1e6}[random() % 4];
        std::vector<std::vector<l3d_point_2d>> outlines(random() % 4);
        for (auto& o : outlines) {
            o.resize(random() % 12);
            for (l3d_point_2d& p : o)
                p = corner(random, reach);
        }
        const auto inside = random() % 2 ? l3d_winding::nonzero : l3d_winding::even_odd;
        expect_outlines(outlines, inside, c, width, height,
                        "seed " + std::to_string(seed + 3) + ", outlines " + std::to_string(n));
        if (HasFatalFailure())
            return;
    }
    EXPECT_TRUE(c.guards_intact());
}

TEST(Outlines, WithoutNumbersDrawNothingAndFarOnesStayInside) {
    canvas c(19, 13);
    const std::vector<l3d_point_2d> good{{2, 2}, {15, 3}, {8, 11}}, bad{{1, 1}, {nan, 9}, {3, 9}};
    const std::array<l3d_outline_2d, 2> both{good, bad};
    c.draw.draw_outlines(both, l3d_winding::nonzero, canvas::color);
    c.draw.draw_outlines({}, l3d_winding::nonzero, canvas::color);
    c.draw.draw_polygon_complex({}, l3d_winding::even_odd, canvas::color);
    EXPECT_TRUE(c.lit().empty());
    const std::vector<l3d_point_2d> all{
        {-infinity, -infinity}, {infinity, -infinity}, {infinity, infinity}, {-infinity, infinity}};
    c.draw.draw_polygon_complex(all, l3d_winding::even_odd, canvas::color);
    EXPECT_EQ(c.lit().size(), 19u * 13u);
    EXPECT_TRUE(c.guards_intact());
}

constexpr std::array<int, 3> shifts{0, 8, 16};

int channel(std::uint32_t word, int shift) {
    return static_cast<int>(word >> shift & 255);
}

/// Pixels as of the flat triangle, colours within 1/2 + 2^-12 of the exact ones.
TEST(Gouraud, IsWithinTheBoundOfTheExactColor) {
    constexpr int width = 37, height = 23;
    constexpr std::array<double, 6> reaches{8, 40, 600, 33000, 1e6, 1e9};
    std::mt19937 random(seed + 4);
    each_simd_target targets;
    canvas flat(width, height), shaded(width, height);
    long double worst = 0;
    for (int n = 0; n < 12000; ++n) {
        targets.next();
        const double reach = reaches[random() % reaches.size()];
        std::array<l3d_point_2d, 3> corners;
        std::array<l3d_colored_point_2d, 3> colored;
        std::vector<std::uint32_t> colors;
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i] = corner(random, reach);
            colors.push_back(random() % 3 ? static_cast<std::uint32_t>(random()) : 0x00ff00ff);
            colored[i] = {corners[i].x, corners[i].y, colors[i]};
        }
        flat.draw.clear_buffer();
        flat.draw.draw_polygon_flatshaded(corners, canvas::color);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                shaded.at(x, y) = 0xff000000; // no colour of a shaded polygon
        shaded.draw.draw_polygon_gouraudshaded(colored);
        const slow_2d::outline v = slow_2d::rounded(corners);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const std::uint32_t word = shaded.at(x, y);
                ASSERT_EQ(flat.at(x, y) != 0, word != 0xff000000)
                    << "seed " << seed + 4 << ", triangle " << n << ", pixel " << x << " " << y;
                if (word == 0xff000000)
                    continue;
                ASSERT_EQ(word >> 24, 0u);
                for (const int shift : shifts)
                    worst =
                        std::max(worst, std::abs(slow_2d::channel(v, colors, shift, x, y) -
                                                 static_cast<long double>(channel(word, shift))));
            }
    }
    EXPECT_LE(worst, 0.5L + 0x1p-12L) << "seed " << seed + 4;
    EXPECT_GT(worst, 0.49L);
    EXPECT_TRUE(shaded.guards_intact());
}

/// A polygon of several triangles: the flat one's pixels, none left out or drawn in black.
TEST(Gouraud, PolygonsHaveThePixelsOfFlatOnes) {
    std::mt19937 random(seed + 5);
    for (int n = 0; n < 500; ++n) {
        canvas flat(41, 29), shaded(41, 29);
        const int count = 3 + static_cast<int>(random() % 7);
        std::vector<l3d_point_2d> corners;
        std::vector<l3d_colored_point_2d> colored;
        const double radius = uniform(random, 5, 200), x = uniform(random, 0, 40);
        for (int i = 0; i < count; ++i) {
            const double angle = i * 6.283185307179586 / count;
            corners.push_back({x + radius * std::cos(angle), 9 + radius * std::sin(angle)});
            colored.push_back({corners.back().x, corners.back().y, canvas::color});
        }
        flat.draw.draw_polygon_flatshaded(corners, canvas::color);
        shaded.draw.draw_polygon_gouraudshaded(colored);
        ASSERT_EQ(flat.lit(), shaded.lit()) << "seed " << seed + 5 << ", polygon " << n;
    }
}

TEST(Gouraud, WithoutNumbersOrCornersDrawsNothing) {
    canvas c(19, 13);
    const std::vector<l3d_colored_point_2d> bad{{1, 1, 255}, {nan, 9, 255}, {3, 9, 255}};
    c.draw.draw_polygon_gouraudshaded(bad);
    c.draw.draw_polygon_gouraudshaded(std::span(bad).first(1));
    c.draw.draw_polygon_gouraudshaded({});
    EXPECT_TRUE(c.lit().empty());
    EXPECT_TRUE(c.guards_intact());
}

/// White on black shows the coverage itself; it may err by rounding to 1/255 and no more.
TEST(SmoothLines, CoverWhatTheFormulaSays) {
    constexpr int width = 37, height = 23;
    constexpr std::array<double, 6> reaches{3, 15, 40, 600, 1e6, 1e9};
    std::mt19937 random(seed + 6);
    canvas c(width, height), back(width, height);
    long double worst = 0;
    std::size_t lit = 0;
    for (int n = 0; n < 30000; ++n) {
        const double reach = reaches[random() % reaches.size()];
        const l3d_point_2d a = corner(random, reach);
        const l3d_point_2d b = n % 50 ? corner(random, reach) : a;
        c.draw.clear_buffer();
        back.draw.clear_buffer();
        c.draw.draw_line_antialiased(a, b, 0x00ffffff);
        back.draw.draw_line_antialiased(b, a, 0x00ffffff);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const int value = channel(c.at(x, y), 0);
                ASSERT_EQ(c.at(x, y), back.at(x, y)) << "seed " << seed + 6 << ", line " << n;
                const long double exact = 255 * slow_2d::coverage(a, b, x, y);
                worst = std::max(worst, std::abs(exact - static_cast<long double>(value)));
                lit += value != 0;
            }
    }
    EXPECT_LE(worst, 0.5L + 1e-9L) << "seed " << seed + 6;
    EXPECT_GT(lit, 100000u);
    EXPECT_TRUE(c.guards_intact() && back.guards_intact());
}

TEST(SmoothLines, BlendToTheNearestAndKeepTheHighestByte) {
    canvas c(9, 7);
    c.at(3, 4) = 0xab204060;
    c.draw.draw_line_antialiased({3.25, 4}, {3.25, 4}, 0x00ff0080); // covers 3/4 of it
    EXPECT_EQ(c.at(3, 4), 0xabc71078u); // 191 of 255: 0x20 + 223 * 191 / 255 = 199.04
    c.draw.draw_line_antialiased({1, 2}, {6, 2}, 0x00123456); // on samples: as an ordinary line
    for (int x = 1; x <= 6; ++x)
        EXPECT_EQ(c.at(x, 2), 0x00123456u);
    EXPECT_EQ(c.at(0, 2), 0u);
    EXPECT_EQ(c.at(7, 2), 0u);
}

TEST(SmoothLines, WithoutNumbersDrawNothingAndFarOnesStayInside) {
    canvas c(19, 13);
    for (const double bad : {nan, -nan}) {
        c.draw.draw_line_antialiased({bad, 3}, {9, 3}, canvas::color);
        c.draw.draw_line_antialiased({2, 3}, {9, bad}, canvas::color);
    }
    EXPECT_TRUE(c.lit().empty());
    c.draw.draw_line_antialiased({-infinity, 5}, {infinity, 5}, canvas::color);
    EXPECT_EQ(c.lit().size(), 19u);
    for (const double far : {infinity, 1e300, 3e9, -1e17})
        c.draw.draw_line_antialiased({far, -far}, {4, far}, canvas::color);
    EXPECT_TRUE(c.guards_intact());
}

} // namespace
