// SPDX-License-Identifier: MIT
// Bounds of bends and turns, against exact values at many points.
#include "exact_bends.h"
#include "scene.h"
#include "teapot_studio.h"

#include "reference/random_patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

namespace dice_tests {
namespace {

using patch = l3d_bezier_patch<double, 3>;

patch library_patch(const reference::patch& of) {
    patch result;
    for (std::size_t i = 0; i < 16; ++i)
        result.points[i] = {of.points[i].x, of.points[i].y, of.points[i].z};
    return result;
}

/// Compares bounds with exact values, and keeps how much larger they are.
class tightness {
public:
    void compare(const bend_numbers& bound, const bend_numbers& exact) {
        for (std::size_t n = 0; n < all_bends.size(); ++n) {
            const double b = bound.*all_bends[n].of, e = exact.*all_bends[n].of;
            violations += !(b >= e);
            infinite += std::isinf(b);
            // What is next to nothing, of a size of 1, is all slack.
            if (!std::isinf(b) && e > 1e-6)
                ratios_[n].push_back(b / e);
        }
    }
    void compare(const l3d_surface_bends& bounds, const exact_bends& exact) {
        for (std::size_t i = 0; i < exact.of_blocks.size(); ++i)
            compare(bends_of_block(bounds, i), exact.of_blocks[i]);
        compare(bends_of_whole(bounds), exact.of_whole);
    }
    double quantile(std::size_t n, double part) {
        auto& of = ratios_[n];
        if (of.empty())
            return 1;
        const auto at = static_cast<std::ptrdiff_t>(part * static_cast<double>(of.size() - 1));
        std::nth_element(of.begin(), of.begin() + at, of.end());
        return of[static_cast<std::size_t>(at)];
    }
    void print(const char* what) {
        std::printf("%s: %ld infinite; bound / exact, median, nine tenths, most:\n", what,
                    infinite);
        for (std::size_t n = 0; n < all_bends.size(); ++n)
            std::printf("  %-6s %8.3f %8.3f %10.3f of %zu\n", all_bends[n].name, quantile(n, 0.5),
                        quantile(n, 0.9), quantile(n, 1), ratios_[n].size());
    }

    long violations = 0, infinite = 0;

private:
    std::vector<double> ratios_[17];
};

TEST(surface_bends, of_the_teapot_hold_and_are_tight) {
    const l3d_patch_model model = teapot_model();
    tightness found;
    for (std::size_t p = 0; p < model.patches().size(); ++p)
        found.compare(model.bends(p),
                      exact_bends(model.patches()[p], model.normals(p), sanitized ? 5 : 17));
    found.print("teapot");
    EXPECT_EQ(found.violations, 0);
}

TEST(surface_bends, of_random_patches_of_every_kind_hold) {
    using reference::patch_kind;
    constexpr reference::camera view{{2.5, 3.1, 6.3}, {0.4, 0.2, -0.3}, {0.1, 1, 0.05}, 41, 0.2};
    for (const auto& [kind, name] : {std::pair{patch_kind::moderate, "moderate"},
                                     {patch_kind::thin, "thin"},
                                     {patch_kind::folded, "folded"},
                                     {patch_kind::coincident, "coincident"},
                                     {patch_kind::stiff, "stiff"}}) {
        tightness found;
        for (const reference::patch& p :
             reference::random_patches(7, kind, sanitized ? 5 : 100, view, {640, 480})) {
            const l3d_patch_model model({library_patch(p)});
            found.compare(model.bends(0), exact_bends(model.patches()[0], model.normals(0), 9));
        }
        found.print(name);
        EXPECT_EQ(found.violations, 0) << name;
    }
}

} // namespace
} // namespace dice_tests
