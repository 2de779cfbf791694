// SPDX-License-Identifier: MIT
// The error bound that every frame carries, against the exact surface.
#include "certificate.h"
#include "scene.h"

#include "reference/random_patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

namespace pipeline_tests {
namespace {

template <class T> class bound_of : public ::testing::Test {};

struct type_names {
    template <class T> static std::string GetName(int) { return name_of<T>(); }
};
TYPED_TEST_SUITE(bound_of, number_types, type_names);

/// Dices and measures, every n-th thing; what must hold in every frame.
template <class T>
certificate measured(const scene& s, double tolerance, std::size_t every, const char* what);

template <class T>
void measure(const scene& s, double tolerance, certificate& result, l3d_dice_counts& counts) {
    l3d_patch_dicer<T> dicer;
    dice(dicer, s, tolerance, result, [&](std::size_t i) { result.next(s.patches[i]); });
    counts = dicer.counts();
    EXPECT_EQ(result.violations, 0)
        << "worst at u " << result.worst_u << " v " << result.worst_v << ", in a "
        << (result.worst_is_grid ? "grid" : "triangle") << ": measured " << result.worst_measured
        << " px, bound " << result.worst_bound << " px, of " << result.samples << " samples";
    EXPECT_LE(result.largest, counts.bound_px);
    EXPECT_LE(result.largest_promise, counts.bound_px);
}

TYPED_TEST(bound_of, the_teapot_holds_in_every_view_size_and_tolerance) {
    for (const reference::view& view : reference::project_views())
        for (const l3d_size size : {l3d_size{320, 240}, {1024, 768}, {1920, 1080}})
            for (const double tolerance : {1.0, 0.5, 0.25, 0.1, 0.05}) {
                if (sanitized && (size.width > 320 || tolerance < 0.25))
                    continue;
                SCOPED_TRACE(testing::Message() << view.name << " " << size.width << "x"
                                                << size.height << " tolerance " << tolerance);
                const scene s = teapot(view, size);
                certificate result(s.eye, size);
                result.measure_every(size.width > 320 ? 7 : 1);
                l3d_dice_counts counts;
                measure<TypeParam>(s, tolerance, result, counts);
                EXPECT_LE(counts.bound_px, tolerance);
                EXPECT_GT(result.samples, 100);
                std::printf("%-6s %-8.*s %4dx%-4d tolerance %.2f: bound %.4f, measured max %.4f "
                            "mean %.4f px, %ld samples\n",
                            name_of<TypeParam>(), static_cast<int>(view.name.size()),
                            view.name.data(), size.width, size.height, tolerance, counts.bound_px,
                            result.largest, result.mean(), static_cast<long>(result.samples));
            }
}

} // namespace
} // namespace pipeline_tests
