// SPDX-License-Identifier: MIT
// Placed models: their boxes, their normals, and nets in lanes.
#include "scene/patch_scene.h"
#include "teapot_studio.h"
#include "scene/placed_net.h"
#include "raster/parallel/simd_target.h"
#include "base/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

namespace {

using dice_tests::teapot_model;

using vector = l3d_patch_scene::vector;

/// Affine, of any orientation, slanted, and turned inside out half of the time.
l3d_matrix<double> random_placement(std::mt19937_64& random, double far) {
    std::uniform_real_distribution<double> entry(-1.5, 1.5), place(-far, far);
    l3d_matrix<double> m = l3d_identity<double>();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            m(row, column) = entry(random);
        m(row, 3) = place(random);
    }
    return m;
}

vector point_of(const l3d_matrix<double>& m, const vector& p) {
    const auto h = m * l3d_vector<double, 4>(p[0], p[1], p[2], 1.0);
    return {h[0], h[1], h[2]};
}

TEST(patch_scene, of_a_model_is_the_model_where_it_is) {
    const l3d_patch_model model = teapot_model();
    const l3d_patch_scene scene = model;
    ASSERT_EQ(scene.instances().size(), 1u);
    EXPECT_EQ(scene.instances()[0].model().identity(), model.identity());
    EXPECT_EQ(scene.instances()[0].placement(), l3d_identity<double>());
    EXPECT_FALSE(scene.instances()[0].turns_normals());
    EXPECT_EQ(scene.patch_count(), 28);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(scene.least()[i], model.least()[i], 1e-14);
        EXPECT_NEAR(scene.most()[i], model.most()[i], 1e-14);
    }
}

TEST(patch_scene, boxes_hold_what_is_placed_and_no_more) {
    std::mt19937_64 random(8231);
    const l3d_patch_model model = teapot_model();
    l3d_patch_scene scene;
    for (int i = 0; i < 50; ++i)
        scene.add(model, random_placement(random, 30));
    EXPECT_EQ(scene.patch_count(), 50 * 28);
    vector least{1e30, 1e30, 1e30}, most{-1e30, -1e30, -1e30};
    for (const l3d_patch_instance& instance : scene.instances()) {
        double sum = 0;
        for (int corner = 0; corner < 8; ++corner) {
            vector p;
            for (int i = 0; i < 3; ++i)
                p[i] = (corner >> i & 1) != 0 ? model.most()[i] : model.least()[i];
            p = point_of(instance.placement(), p);
            for (int i = 0; i < 3; ++i) {
                least[i] = std::min(least[i], p[i]);
                most[i] = std::max(most[i], p[i]);
            }
            sum = std::max(sum, std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]));
        }
        EXPECT_GE(scene.reach(), sum);
    }
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(scene.least()[i], least[i], 1e-12);
        EXPECT_NEAR(scene.most()[i], most[i], 1e-12);
    }
}

TEST(patch_scene, keeps_models_that_the_program_forgets) {
    l3d_patch_scene scene(teapot_model());
    l3d_patch_model model = teapot_model();
    scene.add(model, l3d_translation<double>(3, 0, 0));
    model = l3d_patch_model();
    scene.place(0, teapot_model(), l3d_translation<double>(1, 0, 0));
    for (int i = 0; i < 9; ++i) // so that instances move to other memory
        scene.add(scene.instances()[0].model(), l3d_translation<double>(0, i, 0));
    EXPECT_EQ(scene.patch_count(), 11 * 28);
    for (const l3d_patch_instance& instance : scene.instances()) {
        ASSERT_EQ(instance.model().patches().size(), 28u);
        EXPECT_EQ(instance.model().patches()[7].points, teapot_model().patches()[7].points);
    }
}

TEST(patch_scene, shares_models_instead_of_copying_them) {
    const l3d_patch_model model = teapot_model();
    l3d_patch_model moved_from = model;
    const l3d_patch_model moved_to = std::move(moved_from);
    EXPECT_EQ(moved_to.identity(), model.identity());
    EXPECT_EQ(moved_from.identity(), model.identity()); // NOLINT: a move is a copy
    EXPECT_NE(teapot_model().identity(), model.identity());
    EXPECT_TRUE(l3d_patch_model().patches().empty());
}

/// What a scene says of a placement; it is as it was after that.
std::string refusal_of(const l3d_matrix<double>& placement) {
    l3d_patch_scene scene(teapot_model());
    scene.forget_changes();
    std::string said;
    try {
        scene.add(teapot_model(), placement);
    } catch (const l3d_error& error) {
        said = error.what();
    }
    try {
        scene.place(0, placement);
        EXPECT_EQ(said, "");
    } catch (const l3d_error& error) {
        EXPECT_EQ(error.what(), said);
        EXPECT_EQ(scene.instances().size(), 1u);
        EXPECT_EQ(scene.instances()[0].placement(), l3d_identity<double>());
        EXPECT_FALSE(scene.is_changed());
    }
    return said;
}

TEST(patch_scene, refuses_placements_that_cannot_be_drawn) {
    const l3d_matrix<double> turn = l3d_rotation<double>({0.3, 1.0, -0.2}, 40);
    l3d_matrix<double> nan = turn, projective = turn, none, thin = l3d_identity<double>();
    nan(1, 2) = std::nan("");
    projective(3, 0) = 1e-3;
    none = l3d_identity<double>();
    for (int i = 0; i < 3; ++i)
        none(i, i) = 0;
    l3d_matrix<double> flat = thin;
    flat(2, 2) = 0;
    thin(2, 2) = 1e-9;
    const std::string flattens =
        "placement: it flattens the model, since the matrix cannot be inverted";
    EXPECT_EQ(refusal_of(nan), "placement: a number is not finite");
    EXPECT_EQ(refusal_of(projective), "placement: the last row is not 0,0,0,1");
    EXPECT_EQ(refusal_of(none), flattens);
    EXPECT_EQ(refusal_of(flat), flattens);
    EXPECT_EQ(refusal_of(turn * flat * turn), flattens);
    EXPECT_EQ(refusal_of(l3d_translation<double>(0, 1e12, 0)),
              "placement: it takes the model beyond 1e12");
    EXPECT_EQ(refusal_of(thin), "");
    EXPECT_EQ(refusal_of(turn * thin * turn), "");
}

TEST(patch_scene, counts_terms_that_cancel) {
    const l3d_patch_model model = teapot_model();
    const l3d_patch_scene alone = model;
    l3d_patch_scene far;
    far.add(model, l3d_translation<double>(3e9, 0.5, -2.0));
    EXPECT_GT(alone.reach(), 5);
    EXPECT_LT(alone.reach(), 12);
    EXPECT_GT(far.reach(), 3e9);
}

TEST(patch_scene, that_is_cleared_is_as_new) {
    const l3d_patch_model model = teapot_model();
    l3d_patch_scene scene;
    scene.add(model, l3d_translation<double>(300, 5, 7));
    scene.clear();
    EXPECT_EQ(scene.patch_count(), 0);
    EXPECT_EQ(scene.boxes().count(), 0u);
    EXPECT_EQ(scene.reach(), 0);
    scene.add(model);
    EXPECT_LT(scene.most()[0], 10);
    EXPECT_GT(scene.least()[0], -10);
}

TEST(patch_instance, knows_which_placements_leave_normals_alone) {
    const l3d_patch_model model = teapot_model();
    const auto turns = [&](const l3d_matrix<double>& placement) {
        return l3d_patch_instance(model, placement).turns_normals();
    };
    l3d_matrix<double> half = l3d_translation<double>(1, 2, 3), mirrored = half, flat = half;
    for (int i = 0; i < 3; ++i)
        half(i, i) = 0.5;
    mirrored(0, 0) = -1;
    flat(1, 1) = 0.25;
    EXPECT_FALSE(turns(l3d_translation<double>(-7, 1e9, 0.1)));
    EXPECT_FALSE(turns(half));
    EXPECT_TRUE(turns(mirrored));
    EXPECT_TRUE(turns(flat));
    EXPECT_TRUE(turns(l3d_rotation<double>({0.3, 1.0, -0.2}, 0.6)));
}

TEST(patch_instance, normals_are_those_of_the_placed_surface) {
    std::mt19937_64 random(77012);
    const l3d_patch_model model = teapot_model();
    const auto& patch = model.patches()[11];
    const vector du = patch.derivative_u(0.3, 0.6), dv = patch.derivative_v(0.3, 0.6);
    for (const double size : {1.0, 1e-9, 1e11})
        for (int i = 0; i < 100; ++i) {
            l3d_matrix<double> placement = random_placement(random, 30);
            for (int row = 0; row < 3; ++row)
                for (int column = 0; column < 3; ++column)
                    placement(row, column) *= size;
            const auto turned = [](const l3d_matrix<double>& m, const vector& v) {
                const auto h = m * l3d_vector<double, 4>(v[0], v[1], v[2], 0.0);
                return vector(h[0], h[1], h[2]);
            };
            const vector exact =
                l3d_normalized(l3d_cross(turned(placement, du), turned(placement, dv)));
            const l3d_patch_instance instance(model, placement);
            const vector ours = l3d_normalized(turned(instance.normal_matrix(), l3d_cross(du, dv)));
            EXPECT_NEAR(l3d_length(exact - ours), 0, 1e-10) << size;
        }
}

TEST(placed_net, has_the_bits_of_products_one_by_one_with_every_instruction_set) {
    std::mt19937_64 random(4410);
    std::uniform_real_distribution<double> coordinate(-1e3, 1e3);
    for (const std::string& target : l3d_simd_targets()) {
        ASSERT_TRUE(l3d_set_simd_target(target));
        for (int i = 0; i < 200; ++i) {
            l3d_bezier_patch<double, 3> patch;
            for (auto& p : patch.points)
                p = {coordinate(random), coordinate(random), coordinate(random)};
            l3d_matrix<double> m = random_placement(random, 1e4);
            for (int column = 0; column < 4; ++column)
                m(3, column) = coordinate(random);
            const l3d_image_patch net = l3d_placed_net(m, patch);
            for (std::size_t k = 0; k < 16; ++k) {
                const auto& p = patch.points[k];
                const auto h = m * l3d_vector<double, 4>(p[0], p[1], p[2], 1.0);
                ASSERT_EQ(net.points[k][0], h[0]) << target;
                ASSERT_EQ(net.points[k][1], h[1]) << target;
                ASSERT_EQ(net.points[k][2], h[3]) << target;
            }
        }
    }
    l3d_set_simd_target({});
}

TEST(placed_normals, have_the_bits_of_products_one_by_one_with_every_instruction_set) {
    std::mt19937_64 random(4411);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    for (const std::string& target : l3d_simd_targets()) {
        ASSERT_TRUE(l3d_set_simd_target(target));
        for (int i = 0; i < 200; ++i) {
            l3d_normal_polynomial normals;
            for (auto& v : normals.points)
                v = {coordinate(random), coordinate(random), coordinate(random)};
            const l3d_normal_net net(normals);
            const l3d_matrix<double> m = random_placement(random, 1);
            std::array<vector, 36> turned;
            double most = 0;
            for (std::size_t k = 0; k < turned.size(); ++k)
                for (int row = 0; row < 3; ++row) {
                    const auto& n = net.polynomial().points[k];
                    turned[k][row] = m(row, 0) * n[0] + m(row, 1) * n[1] + m(row, 2) * n[2];
                    most = std::max(most, std::abs(turned[k][row]));
                }
            const l3d_normal_net result = l3d_placed_normals(m, net);
            for (std::size_t k = 0; k < turned.size(); ++k)
                for (int row = 0; row < 3; ++row) {
                    const double expected = turned[k][row] * (1 / most);
                    ASSERT_EQ(result.polynomial().points[k][row], expected) << target;
                    ASSERT_EQ(result.in_floats()[row][k / 6][k % 6], static_cast<float>(expected))
                        << target;
                }
        }
    }
    l3d_set_simd_target({});
}

TEST(patch_scene, refuses_an_instance_that_is_not_there) {
    l3d_patch_scene scene(l3d_patch_model::teapot());
    EXPECT_THROW(scene.place(1, l3d_identity<double>()), std::out_of_range);
    EXPECT_THROW(scene.paint(1, l3d_material{}), std::out_of_range);
    EXPECT_THROW(scene.lay(1, {}), std::out_of_range);
    EXPECT_THROW(scene.set_opacity(1, 0.5), std::out_of_range);
    EXPECT_THROW(scene.lay(0, {.texture = nullptr, .pieces = {{}, {}}}), l3d_error);
    EXPECT_EQ(scene.transparent_count(), 0);
}

} // namespace
