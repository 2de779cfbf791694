// SPDX-License-Identifier: MIT
// Patches diced in lanes, against exact evaluation and the slow twin.
#include "certificate.h"
#include "nasty.h"
#include "dice/lanes/lane_dicer.h"
#include "dice/normal_columns.h"
#include "scene/culling/visibility.h"
#include "raster/parallel/simd_target.h"
#include "scene.h"

#include "reference/random_patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>

namespace dice_tests {
namespace {

template <class T> class lane_dicer : public ::testing::Test {};

TYPED_TEST_SUITE(lane_dicer, product_types, type_names);

struct named_kind {
    reference::patch_kind kind;
    const char* name;
};
constexpr named_kind kinds[] = {{reference::patch_kind::moderate, "moderate"},
                                {reference::patch_kind::thin, "thin"},
                                {reference::patch_kind::folded, "folded"},
                                {reference::patch_kind::coincident, "coincident"},
                                {reference::patch_kind::stiff, "stiff"}};

scene random_scene(std::uint64_t seed, reference::patch_kind kind, int patches) {
    return {random_patches(seed, kind, patches, oblique, {odd.width, odd.height}), oblique, odd};
}

l3d_image_transform transform_of(const scene& s) {
    l3d_patch_scene world;
    world.add(s.model);
    return {s.camera, s.size, world};
}

/// Dices those patches of a scene that are ordinary.
template <class T> class ordinary_patches {
public:
    /// Calls sink(i, net, piece) for each of them.
    template <class Sink> void dice(const scene& s, double tolerance, Sink sink) {
        const l3d_image_transform to_image = transform_of(s);
        const l3d_dice_view view = to_image.view(tolerance);
        for (std::size_t i = 0; i < s.patches.size(); ++i) {
            const l3d_image_patch net = l3d_placed_net(to_image.matrix(), s.model.patches()[i]);
            if (l3d_left_out(net, view, counts))
                continue;
            edges_.build(net, view);
            piece_.clear();
            piece_.keep_parameters = true;
            ++offered;
            if (dicer_.dice(net, s.model.normals(i), view, edges_.outer(), piece_, counts))
                sink(i, net, piece_);
            else
                EXPECT_EQ(piece_.u.size() + piece_.part.triangles.count, 0u);
        }
    }

    l3d_dice_counts counts;
    std::int64_t offered = 0;

private:
    l3d_lane_dicer<T> dicer_;
    l3d_edge_polylines edges_;
    l3d_diced_piece piece_;
};

TYPED_TEST(lane_dicer, holds_its_bound) {
    const std::uint64_t scenes = thorough ? 40 : 5;
    constexpr int patches = 20;
    for (const named_kind& of : kinds) {
        std::int64_t offered = 0, taken = 0, samples = 0;
        double worst = 0;
        for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
            const double tolerance = random_numbers(seed).of_any_size(0.03, 2);
            SCOPED_TRACE(testing::Message()
                         << of.name << " seed " << seed << " tolerance " << tolerance);
            const scene s = random_scene(seed, of.kind, patches);
            certificate result(s.eye, s.size);
            result.measure_every(thorough ? 5 : 50);
            ordinary_patches<TypeParam> all;
            all.dice(s, tolerance,
                     [&](std::size_t i, const l3d_image_patch&, const l3d_diced_piece& piece) {
                         result.next(s.patches[i]);
                         result.draw({&piece, 1}, all.counts.bound_px);
                     });
            EXPECT_EQ(result.violations, 0)
                << "worst at u " << result.worst_u << " v " << result.worst_v << ", in a "
                << (result.worst_is_grid ? "grid" : "triangle") << ": measured "
                << result.worst_measured << " px, bound " << result.worst_bound << " px";
            EXPECT_LE(all.counts.bound_px, tolerance);
            offered += all.offered;
            taken += all.counts.pieces;
            samples += result.samples;
            worst = std::max(worst, result.worst_ratio);
        }
        std::printf("%-6s %-10s %ld of %ld patches in lanes, %ld samples: worst measured / bound "
                    "%.3f\n",
                    name_of<TypeParam>(), of.name, static_cast<long>(taken),
                    static_cast<long>(offered), static_cast<long>(samples), worst);
        // Of the others, most are cut.
        if (of.kind == reference::patch_kind::moderate) {
            EXPECT_GT(taken, offered * 9 / 10);
        }
        EXPECT_GT(taken, offered / 4);
    }
}

/// Where the vertex of a grid's row and column is to be; its strips are given by where they start.
/// It is at f - m f'' along u and then along v, m that of l3d_balance, or 0 at the strips' ends.
class balanced_places {
public:
    explicit balanced_places(const l3d_diced_piece& piece)
        : u_(moved(piece.part.block_columns)), v_(moved(piece.part.block_rows)) {}

    l3d_image_point operator()(const l3d_image_patch& net, const l3d_diced_piece& piece, int row,
                               int column) const {
        const auto r = static_cast<std::size_t>(row), c = static_cast<std::size_t>(column);
        l3d_image_curve along_v;
        for (int i = 0; i < 4; ++i)
            along_v.points[static_cast<std::size_t>(i)] =
                moved_by(net.row(i), u_[c]).evaluate(piece.u[c]);
        return moved_by(along_v, v_[r]).evaluate(piece.v[r]);
    }

private:
    static std::vector<double> moved(const l3d_block_starts& starts) {
        std::vector<double> result;
        for (int s = 0; s < starts.blocks; ++s) {
            const auto strip = static_cast<std::size_t>(s);
            const int n = starts.first[strip + 1] - starts.first[strip];
            for (int i = 0; i < n; ++i)
                result.push_back(i == 0 || starts.blocks == 1 ? 0 : l3d_balance / (16.0 * n * n));
        }
        result.push_back(0);
        return result;
    }

    /// f'' is 6 times the second differences of the control points, and linear.
    static l3d_image_curve moved_by(const l3d_image_curve& f, double m) {
        l3d_image_curve result = f;
        for (std::size_t i = 0; i < 4; ++i) {
            const double last = static_cast<double>(i) / 3;
            for (std::size_t k = 0; k < 2; ++k)
                result.points[i] -= (f.points[k] - f.points[k + 1] * 2.0 + f.points[k + 2]) *
                                    (6 * m * (k == 0 ? 1 - last : last));
        }
        return result;
    }

    std::vector<double> u_, v_;
};

TYPED_TEST(lane_dicer, places_vertices_where_exact_evaluation_does) {
    double worst = 0;
    for (const named_kind& of : kinds)
        for (std::uint64_t seed = 1; seed <= (thorough ? 12 : 2); ++seed) {
            const scene s = random_scene(seed, of.kind, 20);
            const l3d_dice_view view = transform_of(s).view(0.25);
            ordinary_patches<TypeParam> all;
            all.dice(s, 0.25,
                     [&](std::size_t i, const l3d_image_patch& net, const l3d_diced_piece& piece) {
                         const l3d_micro_grid& grid = piece.part.grid;
                         const balanced_places place(piece);
                         for (int r = 0; r < grid.rows; ++r)
                             for (int c = 0; c < grid.columns; ++c) {
                                 const l3d_image_point h = place(net, piece, r, c);
                                 const l3d_micro_vertex v = grid.vertex(r, c);
                                 const double x = h[0] / h[2] * l3d_subpixel_one + view.centre_x();
                                 const double y = h[1] / h[2] * l3d_subpixel_one + view.centre_y();
                                 // Half a sub-pixel of snapping, and what the numbers add.
                                 ASSERT_NEAR(v.x, x, 1)
                                     << of.name << " seed " << seed << " patch " << i;
                                 ASSERT_NEAR(v.y, y, 1)
                                     << of.name << " seed " << seed << " patch " << i;
                                 ASSERT_NEAR(static_cast<double>(v.inv_w) * h[2] / view.depth_scale,
                                             1, 2e-5)
                                     << of.name << " seed " << seed << " patch " << i;
                                 worst = std::max({worst, std::abs(v.x - x), std::abs(v.y - y)});
                             }
                     });
        }
    std::printf("%-6s worst distance %.4f sub-pixels\n", name_of<TypeParam>(), worst);
}

TYPED_TEST(lane_dicer, holds_depths_of_scenes_of_any_size) {
    for (const double size : {1e-28, 1e-22, 1e9})
        for (const double tolerance : {0.02, 0.5}) { // with registers of 64 and of 32 bits
            const auto sized = [size](reference::vec3 p) {
                return reference::vec3{p.x * size, p.y * size, p.z * size};
            };
            reference::camera eye = oblique;
            eye.eye = sized(eye.eye);
            eye.target = sized(eye.target);
            eye.near *= size;
            auto patches = random_scene(1, reference::patch_kind::moderate, 20).patches;
            for (reference::patch& patch : patches)
                for (reference::vec3& p : patch.points)
                    p = sized(p);
            const scene s(patches, eye, odd);
            const l3d_dice_view view = transform_of(s).view(tolerance);
            std::int64_t vertices = 0;
            ordinary_patches<TypeParam> all;
            all.dice(s, tolerance,
                     [&](std::size_t i, const l3d_image_patch& net, const l3d_diced_piece& piece) {
                         const l3d_micro_grid& grid = piece.part.grid;
                         const balanced_places place(piece);
                         for (int r = 0; r < grid.rows; ++r)
                             for (int c = 0; c < grid.columns; ++c, ++vertices)
                                 ASSERT_NEAR(static_cast<double>(grid.vertex(r, c).inv_w) *
                                                 place(net, piece, r, c)[2] / view.depth_scale,
                                             1, 2e-5)
                                     << size << " patch " << i;
                     });
            EXPECT_GT(vertices, 1000) << size;
        }
}

TYPED_TEST(lane_dicer, has_unit_normals_of_the_slow_twin_or_none) {
    double worst = 0;
    std::int64_t compared = 0, missing = 0;
    for (const named_kind& of : kinds)
        for (std::uint64_t seed = 1; seed <= (thorough ? 12 : 2); ++seed) {
            const scene s = random_scene(seed, of.kind, 20);
            ordinary_patches<TypeParam> all;
            all.dice(
                s, 0.25, [&](std::size_t i, const l3d_image_patch&, const l3d_diced_piece& piece) {
                    const l3d_micro_grid& grid = piece.part.grid;
                    for (int r = 0; r < grid.rows; ++r)
                        for (int c = 0; c < grid.columns; ++c) {
                            const auto exact =
                                s.model.normals(i).evaluate(piece.u[static_cast<std::size_t>(c)],
                                                            piece.v[static_cast<std::size_t>(r)]);
                            const std::array<float, 3> unit = l3d_unit_normal(exact);
                            const l3d_micro_vertex v = grid.vertex(r, c);
                            double error = 0, length = 0;
                            for (std::size_t k = 0; k < 3; ++k) {
                                error = std::max(error,
                                                 std::abs(double{v.normal[k]} - double{unit[k]}));
                                length += double{v.normal[k]} * double{v.normal[k]};
                            }
                            ASSERT_TRUE(length == 0 || std::abs(length - 1) < 1e-6) << length;
                            missing += length == 0;
                            // Where it nearly vanishes, in folds and cusps, its direction is what
                            // rounding leaves of it.
                            if (l3d_dot(exact, exact) < 0.01 * 0.01)
                                continue;
                            ++compared;
                            ASSERT_LT(error, 5e-4) << of.name << " seed " << seed << " patch " << i;
                            worst = std::max(worst, error * std::sqrt(l3d_dot(exact, exact)));
                        }
                });
        }
    std::printf("%-6s %ld normals (%ld missing), worst error times length %.2g\n",
                name_of<TypeParam>(), static_cast<long>(compared), static_cast<long>(missing),
                worst);
    EXPECT_LT(worst, 1e-6);
    EXPECT_GT(compared, missing);
}

TYPED_TEST(lane_dicer, takes_all_of_the_teapot_that_is_in_front) {
    for (const char* name : {"full", "top"}) {
        const scene s = teapot(reference::project_view(name), {1024, 768});
        ordinary_patches<TypeParam> all;
        all.dice(s, 0.5, [](std::size_t, const l3d_image_patch&, const l3d_diced_piece&) {});
        EXPECT_EQ(all.counts.pieces, all.offered) << name;
        EXPECT_LE(all.counts.bound_px, 0.5) << name;
        EXPECT_GT(all.counts.samples, 5000) << name;
    }
}

TYPED_TEST(lane_dicer, keeps_the_memory_of_a_frame_like_the_last_one) {
    const scene s = teapot(reference::project_view("full"), {1024, 768});
    ordinary_patches<TypeParam> all;
    const auto memory_of = [](const l3d_diced_piece& piece) {
        const l3d_micro_grid& grid = piece.part.grid;
        return std::array<const void*, 7>{grid.x.data(),
                                          grid.inv_w.data(),
                                          piece.u.data(),
                                          piece.v.data(),
                                          grid.normal[0].data(),
                                          grid.y.data(),
                                          piece.part.triangles.blocks.data()};
    };
    std::array<const void*, 7> first{};
    all.dice(s, 0.1, [&](std::size_t, const l3d_image_patch&, const l3d_diced_piece& piece) {
        first = memory_of(piece);
    });
    all.dice(s, 0.1, [&](std::size_t, const l3d_image_patch&, const l3d_diced_piece& piece) {
        EXPECT_EQ(memory_of(piece), first);
    });
}

/// FNV-1a over everything that is drawn.
class fingerprint {
public:
    void add(const l3d_diced_piece& piece) {
        const l3d_micro_grid& grid = piece.part.grid;
        for (int r = 0; r < grid.rows; ++r)
            for (int c = 0; c < grid.columns; ++c)
                add(grid.vertex(r, c));
        for (std::size_t i = 0; i < piece.part.triangles.count; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                add(piece.part.triangles.vertex(i, k));
    }
    void add(double number) { mix(std::bit_cast<std::uint64_t>(number)); }
    std::uint64_t value = 0xcbf29ce484222325u;

private:
    void add(const l3d_micro_vertex& v) {
        mix(static_cast<std::uint32_t>(v.x));
        mix(static_cast<std::uint32_t>(v.y));
        mix(std::bit_cast<std::uint32_t>(v.inv_w));
        for (const float component : v.normal)
            mix(std::bit_cast<std::uint32_t>(component));
    }
    void mix(std::uint64_t bits) { value = (value ^ bits) * 0x100000001b3u; }
};

TYPED_TEST(lane_dicer, draws_the_same_bits_with_every_instruction_set) {
    const auto drawn = [] {
        fingerprint all;
        for (const named_kind& of : kinds)
            for (std::uint64_t seed = 1; seed <= 3; ++seed)
                for (const double tolerance : {0.01, 0.3}) {
                    ordinary_patches<TypeParam> some;
                    some.dice(
                        random_scene(seed, of.kind, 20), tolerance,
                        [&](std::size_t, const l3d_image_patch&, const l3d_diced_piece& piece) {
                            all.add(piece);
                            all.add(piece.bound);
                        });
                }
        return all.value;
    };
    const std::uint64_t best = drawn();
    for (const std::string& target : l3d_simd_targets()) {
        ASSERT_TRUE(l3d_set_simd_target(target));
        EXPECT_EQ(drawn(), best) << target;
    }
    l3d_set_simd_target("");
}

} // namespace
} // namespace dice_tests
