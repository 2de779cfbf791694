// SPDX-License-Identifier: MIT
// The views and the random surfaces; tilings, which must cover the window, test the exact picture.
#include "reference/random_patches.h"
#include "reference/views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

namespace reference {
namespace {

constexpr camera oblique{{2.5, 3.1, 6.3}, {0.4, 0.2, -0.3}, {0.1, 1, 0.05}, 41, 0.2};
constexpr picture_size small{157, 118};

struct coverage {
    std::int64_t pixels = 0;
    int columns = 0, rows = 0; ///< of the smallest box around them
    double nearest = 1e30;
};

coverage coverage_of(const exact_image& image) {
    coverage result;
    int x0 = image.size().width, x1 = -1, y0 = image.size().height, y1 = -1;
    for (int y = 0; y < image.size().height; ++y)
        for (int x = 0; x < image.size().width; ++x)
            if (image.covered(x, y)) {
                ++result.pixels;
                x0 = std::min(x0, x);
                x1 = std::max(x1, x);
                y0 = std::min(y0, y);
                y1 = std::max(y1, y);
                result.nearest = std::min(result.nearest, image.at(x, y).w);
            }
    result.columns = std::max(0, x1 - x0 + 1);
    result.rows = std::max(0, y1 - y0 + 1);
    return result;
}

coverage teapot_seen(std::string_view name, picture_size size) {
    const auto teapot = load_bpt_plain("data/teapot.bpt");
    return coverage_of(exact_image(teapot, project_view(name).eye, size));
}

TEST(views, reader_takes_the_numbers_and_names_a_bad_file) {
    const auto teapot = load_bpt_plain("data/teapot.bpt");
    ASSERT_EQ(teapot.size(), 28u);
    EXPECT_EQ(teapot[0].points[5].x, 1.3375);
    EXPECT_EQ(teapot[0].points[5].y, 2.38125);
    EXPECT_EQ(teapot[0].points[5].z, 0.749);
    try {
        load_bpt_plain("data/no_such.bpt");
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("data/no_such.bpt"), std::string::npos);
    }
    EXPECT_THROW(project_view("nowhere"), std::out_of_range);
}

TEST(views, show_what_their_names_say) {
    constexpr picture_size quarter{256, 192};
    const double all = 256 * 192;
    const auto share = [&](std::string_view name) {
        return static_cast<double>(teapot_seen(name, quarter).pixels) / all;
    };
    EXPECT_NEAR(share("full"), 221300.0 / (1024 * 768), 0.002); // the same camera at full size
    EXPECT_GT(share("closeup"), 0.5);
    EXPECT_GT(share("top"), 0.4);
    EXPECT_GT(share("inside"), 0.95);
    EXPECT_GT(share("grazing"), 0.2);
    EXPECT_NEAR(teapot_seen("tiny", {1024, 768}).columns, 30, 3);
    const coverage cut = teapot_seen("near_cut", quarter);
    EXPECT_LT(static_cast<double>(cut.pixels) / all, share("full") - 0.03);
    EXPECT_GT(static_cast<double>(cut.pixels) / all, 0.1);
    EXPECT_GE(cut.nearest, 7.9);
    EXPECT_LT(cut.nearest, 7.95);
}

constexpr patch_kind all_kinds[] = {patch_kind::moderate, patch_kind::thin, patch_kind::folded,
                                    patch_kind::coincident, patch_kind::stiff};

TEST(random_patches, lie_before_the_camera_and_repeat) {
    const camera_frame frame(oblique, small);
    for (const auto kind : all_kinds) {
        const auto patches = random_patches(77, kind, 60, oblique, small);
        const auto again = random_patches(77, kind, 60, oblique, small);
        const auto other = random_patches(78, kind, 60, oblique, small);
        EXPECT_NE(patches[0].points[3].x, other[0].points[3].x);
        for (std::size_t n = 0; n < patches.size(); ++n)
            for (std::size_t k = 0; k < 16; ++k) {
                const vec3& p = patches[n].points[k];
                EXPECT_EQ(p.x, again[n].points[k].x);
                EXPECT_GE(static_cast<double>(frame.project({p.x, p.y, p.z}).w), 2 * oblique.near);
            }
    }
}

/// Distance of the control points from the line through the two that are farthest apart, in the
/// picture, as a part of the length; least of the patches.
double smallest_width_to_length(patch_kind kind) {
    const camera_frame frame(oblique, small);
    double result = 1;
    for (const patch& surface : random_patches(5, kind, 100, oblique, small)) {
        std::vector<std::complex<double>> p;
        for (const vec3& point : surface.points) {
            const homogeneous_point h = frame.project({point.x, point.y, point.z});
            p.emplace_back(static_cast<double>(h.x / h.w), static_cast<double>(h.y / h.w));
        }
        std::complex<double> from, way;
        for (const auto& a : p)
            for (const auto& b : p)
                if (std::abs(b - a) > std::abs(way)) {
                    from = a;
                    way = b - a;
                }
        double width = 0;
        for (const auto& a : p)
            width = std::max(width, std::abs(((a - from) / way).imag()));
        result = std::min(result, width);
    }
    return result;
}

double picture_length(const patch& surface, const camera_frame& frame, std::size_t a,
                      std::size_t b) {
    const vec3 &p = surface.points[a], &q = surface.points[b];
    const homogeneous_point from = frame.project({p.x, p.y, p.z});
    const homogeneous_point to = frame.project({q.x, q.y, q.z});
    return static_cast<double>(
        std::hypot(from.x / from.w - to.x / to.w, from.y / from.w - to.y / to.w));
}

/// The largest ratio over the patches, of two distances between control points in the picture.
double largest_ratio(patch_kind kind, std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    const camera_frame frame(oblique, small);
    double result = 0;
    for (const patch& surface : random_patches(5, kind, 100, oblique, small))
        result = std::max(result, picture_length(surface, frame, a, b) /
                                      (picture_length(surface, frame, c, d) + 1e-30));
    return result;
}

TEST(random_patches, kinds_are_what_they_are_called) {
    EXPECT_LT(largest_ratio(patch_kind::moderate, 0, 15, 3, 12), 100);
    EXPECT_LT(smallest_width_to_length(patch_kind::moderate), 0.5);
    EXPECT_GT(smallest_width_to_length(patch_kind::moderate), 0.01);
    EXPECT_LT(smallest_width_to_length(patch_kind::thin), 1e-5);
    EXPECT_GT(largest_ratio(patch_kind::stiff, 2, 3, 0, 1), 1e4);
    int with_equal_points = 0;
    for (const patch& surface : random_patches(5, patch_kind::coincident, 50, oblique, small)) {
        std::set<std::tuple<double, double, double>> points;
        for (const vec3& p : surface.points)
            points.insert({p.x, p.y, p.z});
        with_equal_points += points.size() < 16;
    }
    EXPECT_GE(with_equal_points, 45); // two points out of sixteen may be the same one
    const exact_image folds(random_patches(5, patch_kind::folded, 1, oblique, small), oblique,
                            small);
    int most = 0;
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x)
            most = std::max(most, folds.layers(x, y));
    EXPECT_GE(most, 3);
}

using edge = std::array<std::tuple<double, double, double>, 4>;

edge edge_of(const patch& surface, std::size_t first, std::size_t step) {
    edge result;
    for (std::size_t i = 0; i < 4; ++i) {
        const vec3& p = surface.points[first + i * step];
        result[i] = {p.x, p.y, p.z};
    }
    edge backward(result);
    std::reverse(backward.begin(), backward.end());
    return std::min(result, backward);
}

TEST(random_tiling, inner_edges_are_shared_bit_for_bit_by_two_patches) {
    constexpr int k = 5;
    std::map<edge, int> uses;
    for (const patch& tile : random_tiling(31, k, 1.5, 0.4, oblique, small))
        for (const auto& [first, step] :
             {std::pair<std::size_t, std::size_t>{0, 1}, {12, 1}, {0, 4}, {3, 4}})
            ++uses[edge_of(tile, first, step)];
    const auto used = [&](int times) {
        return std::count_if(uses.begin(), uses.end(),
                             [&](const auto& use) { return use.second == times; });
    };
    EXPECT_EQ(used(1), 4 * k);
    EXPECT_EQ(used(2), 2 * k * (k - 1));
}

/// The tiling is a disc whose boundary runs once round the window: every pixel centre is covered,
/// and has an odd number of surface points, for each fold adds two.
TEST(random_tiling, covers_every_pixel_an_odd_number_of_times) {
    std::int64_t several = 0;
    for (std::uint64_t seed = 601; seed < 613; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const int k = 1 + static_cast<int>(seed % 4) * 2;
        const double fold = static_cast<double>(seed % 3) * 1.9 + 0.2;
        const auto tiling =
            random_tiling(seed, k, fold, 0.1 * static_cast<double>(seed % 5), oblique, small);
        const exact_image image(tiling, oblique, small);
        for (int y = 0; y < small.height; ++y)
            for (int x = 0; x < small.width; ++x) {
                ASSERT_EQ(image.layers(x, y) % 2, 1) << x << ' ' << y;
                several += image.layers(x, y) > 1;
            }
    }
    EXPECT_GT(several, 20000);
}

} // namespace
} // namespace reference
