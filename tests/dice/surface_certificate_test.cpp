// SPDX-License-Identifier: MIT
// The bounds of depth and shade that every frame carries, against the exact surface.
#include "surface_certificate.h"

#include "scene/bodies.h"
#include "nasty.h"
#include "reference/random_patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <vector>

namespace dice_tests {
namespace {

/// Rounding to a whole level, and the arithmetic of floats, are parts of the bound that are not
/// measured here.
constexpr double rounding = 0.5;

/// The common part of scenes of one kind: a summary of their ratios.
template <class T> class surface_scenes {
public:
    explicit surface_scenes(std::string what) : what_(std::move(what)) {}

    ~surface_scenes() {
        std::printf("%-10s %-12s %ld scenes, %ld samples (%ld levels, %ld quads unshaded, %ld "
                    "polygons of two sides), %ld and %ld violations; measured / bound: depth "
                    "median %.3f, largest %.3f (%ld bounds), shade %.3f, %.3f (%ld)\n",
                    name_of<T>(), what_.c_str(), scenes_, samples_, levels_, unshaded_, mixed_,
                    depth_.violations, shade_.violations, depth_.median(), depth_.largest(),
                    static_cast<long>(depth_.all.size()), shade_.median(), shade_.largest(),
                    static_cast<long>(shade_.all.size()));
    }

    l3d_dice_counts check(const scene& s, double tolerance, std::size_t every = 1) {
        surface_certificate measured(s);
        measured.measure_every(every);
        const l3d_dice_counts counts =
            dicer_.dice(s, tolerance, [&](std::size_t i, diced pieces, double) {
                measured.next(i);
                measured.draw(pieces);
            });
        ++scenes_;
        samples_ += static_cast<long>(measured.samples);
        levels_ += static_cast<long>(measured.levels);
        unshaded_ += static_cast<long>(measured.unshaded);
        mixed_ += static_cast<long>(measured.mixed);
        depth_.judge("depth", measured.depth, counts.depth_bound_px);
        shade_.judge("shade", measured.shade, counts.shade_bound - rounding);
        return counts;
    }

private:
    struct ratios {
        std::vector<double> all;
        long violations = 0;

        void judge(const char* what, const surface_certificate::worst& of, double bound) {
            if (of.measured == 0)
                return;
            const bool kept = of.measured <= bound;
            violations += !kept;
            if (violations < 4) {
                EXPECT_TRUE(kept) << what << " of patch " << of.patch << " at " << of.u << ", "
                                  << of.v << (of.in_slit ? " in a slit" : "") << ": measured "
                                  << of.measured << ", bound " << bound;
            }
            if (std::isfinite(bound))
                all.push_back(of.measured / bound);
        }
        double median() {
            if (all.empty())
                return 0;
            const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
            std::nth_element(all.begin(), middle, all.end());
            return *middle;
        }
        double largest() const {
            return all.empty() ? 0 : *std::max_element(all.begin(), all.end());
        }
    };

    std::string what_;
    scene_dicer<T> dicer_;
    ratios depth_, shade_;
    long scenes_ = 0, samples_ = 0, levels_ = 0, unshaded_ = 0, mixed_ = 0;
};

template <class T> class surface_bound_of : public ::testing::Test {};

TYPED_TEST_SUITE(surface_bound_of, number_types, type_names);

TYPED_TEST(surface_bound_of, the_teapot_holds_in_every_view) {
    surface_scenes<TypeParam> all("teapot");
    for (const reference::view& view : reference::project_views())
        for (const l3d_size size : {l3d_size{320, 240}, {1024, 768}})
            for (const double tolerance : {1.0, 0.25, 0.05}) {
                if ((sanitized || size.width > 320) && tolerance < 0.25)
                    continue;
                SCOPED_TRACE(testing::Message() << view.name << " " << size.width << "x"
                                                << size.height << " tolerance " << tolerance);
                scene s = teapot(view, size);
                for (const double levels : {2.0, 1.0}) {
                    s.shade_tolerance = levels;
                    all.check(s, tolerance, size.width > 320 ? 41 : 13);
                }
            }
}

/// The teapot's bottom and knob have blocks without normals, whose corners are measured after they
/// were snapped: by a third of that, they may exceed the tolerance.
TYPED_TEST(surface_bound_of, depth_is_kept_down_to_a_hundredth) {
    constexpr double without_normals = 0.001;
    for (const char* name : {"full", "closeup", "top"})
        for (const double tolerance : {0.5, 0.25, 0.1, 0.05, 0.03, 0.02, 0.01}) {
            if (sanitized && tolerance < 0.05)
                continue;
            SCOPED_TRACE(testing::Message() << name << " tolerance " << tolerance);
            const scene s = teapot(reference::project_view(name), {1024, 768});
            const l3d_dice_counts counts =
                scene_dicer<TypeParam>().dice(s, tolerance, [](std::size_t, diced, double) {});
            EXPECT_LE(counts.depth_bound_px, tolerance + without_normals);
        }
}

/// Small pictures of crumpled patches, two of whose corners have no normal: their few quads are far
/// off a plane. What is not kept is told.
TYPED_TEST(surface_bound_of, depth_is_kept_or_reported_where_normals_vanish) {
    constexpr double tolerance = 0.25, snapped = 0.001;
    random_numbers random(11);
    int over = 0;
    constexpr int patches = 60;
    for (int n = 0; n < patches; ++n) {
        reference::patch p;
        for (std::size_t k = 0; k < p.points.size(); ++k)
            p.points[k] = {static_cast<double>(k % 4) + random.between(-0.5, 0.5),
                           static_cast<double>(k / 4) + random.between(-0.5, 0.5),
                           random.between(-1.5, 1.5)};
        p.points[1] = p.points[0];
        p.points[14] = p.points[11] = p.points[15];
        const scene s({p},
                      {.eye = {random.between(-20, 20), random.between(-20, 20), 20},
                       .target = {1.5, 1.5, 0},
                       .fov_degrees = 42},
                      {160, 120});
        const l3d_dice_counts counts =
            scene_dicer<TypeParam>().dice(s, tolerance, [](std::size_t, diced, double) {});
        const bool is_over = !(counts.depth_bound_px <= tolerance + snapped);
        over += is_over;
        EXPECT_GE(counts.coarse, is_over ? 1 : 0) << n << ": " << counts.depth_bound_px;
    }
    std::printf("%d of %d patches over the tolerance\n", over, patches);
}

TYPED_TEST(surface_bound_of, models_of_data_hold) {
    for (const char* const name : {"dome", "bump3", "far11", "spike20"}) {
        const std::string path = std::string("tests/data/") + name + ".bpt";
        if (!std::filesystem::exists(path))
            continue;
        surface_scenes<TypeParam> all(name);
        for (const double tolerance : {1.0, 0.25, 0.05}) {
            SCOPED_TRACE(testing::Message() << name << " tolerance " << tolerance);
            scene s{reference::load_bpt_plain(path), oblique, {640, 480}};
            s.shade_tolerance = 2;
            all.check(s, tolerance, 3);
        }
    }
}

/// Each patch by itself, so that each bound is its own.
template <class T>
void check_each(surface_scenes<T>& all, std::uint64_t seed,
                const std::vector<reference::patch>& patches) {
    random_numbers random(seed);
    const double tolerance = random.of_any_size(0.03, 2);
    const double levels = random.of_any_size(1, 8);
    SCOPED_TRACE(testing::Message() << "seed " << seed << " tolerance " << tolerance);
    for (const reference::patch& p : patches) {
        scene s{{p}, oblique, odd};
        s.shade_tolerance = levels;
        all.check(s, tolerance, 7);
    }
}

template <class T> void check_random_patches(std::uint64_t first, std::uint64_t end, int count) {
    for (const auto& [kind, name] : reference::patch_kinds) {
        surface_scenes<T> all(name);
        for (std::uint64_t seed = first; seed < end; ++seed)
            check_each(all, seed,
                       random_patches(seed, kind, count, oblique, {odd.width, odd.height}));
    }
}

TYPED_TEST(surface_bound_of, random_patches_of_every_kind_hold) {
    check_random_patches<TypeParam>(1, 3, thorough ? 10 : 5);
    // Beside a piece that is cut, an edge's step reaches beyond the row's end.
    check_random_patches<TypeParam>(1565, 1566, 1);
}

/// 10^5 patches.
TYPED_TEST(surface_bound_of, DISABLED_a_hundred_thousand_random_patches_hold) {
    check_random_patches<TypeParam>(1000, 2000, 20);
}

TYPED_TEST(surface_bound_of, patches_around_the_eye_and_far_from_the_window_hold) {
    for (const auto& [kind, name] : nasty_kinds) {
        surface_scenes<TypeParam> all(name);
        for (std::uint64_t seed = 1; seed <= 2; ++seed)
            check_each(all, seed, nasty_patches(seed, kind, 5, oblique, {odd.width, odd.height}));
    }
}

TYPED_TEST(surface_bound_of, random_bodies_hold) {
    surface_scenes<TypeParam> all("bodies");
    random_numbers random(7);
    for (const body_kind kind :
         {body_kind::bent, body_kind::flattened, body_kind::toroidal, body_kind::starfish})
        for (int i = 0; i < (thorough ? 3 : 1); ++i) {
            const double tolerance = random.of_any_size(0.05, 2);
            SCOPED_TRACE(testing::Message() << "body " << i << " tolerance " << tolerance);
            l3d_matrix<double> placement = l3d_identity<double>();
            if (i > 0)
                for (int row = 0; row < 3; ++row)
                    for (int column = 0; column < 3; ++column)
                        placement(row, column) += random.between(-0.2, 0.2);
            scene s{random_body(random, kind), placement, oblique, {400, 300}};
            s.shade_tolerance = random.of_any_size(1, 4);
            all.check(s, tolerance, 5);
        }
}

} // namespace
} // namespace dice_tests
