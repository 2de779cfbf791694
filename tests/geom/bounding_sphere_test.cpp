// SPDX-License-Identifier: MIT
// Bounding spheres: they hold what they are of, wherever that is placed, and touch in time.
#include "geom/bounding_sphere.h"

#include "geom/polygon_shapes.h"
#include "geom/random.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

using vector = l3d_bounding_sphere::vector;

std::vector<vector> cloud(l3d_random& random) {
    std::vector<vector> places;
    const auto number = [&] { return random.between(-1000, 1000) / 100.0; };
    for (int i = random.between(1, 40); i > 0; --i)
        places.push_back({number(), number() * 3, number() + 50});
    return places;
}

TEST(bounding_sphere, holds_every_vertex_and_reaches_one) {
    l3d_random random(1);
    for (int round = 0; round < 200; ++round) {
        const std::vector<vector> places = cloud(random);
        const auto ball = l3d_bounding_sphere::of(places);
        double farthest = 0;
        for (const vector& place : places)
            farthest = std::max(farthest, l3d_length(place - ball.centre));
        EXPECT_EQ(farthest, ball.radius);
    }
}

TEST(bounding_sphere, of_a_sphere_is_that_sphere) {
    const auto ball = l3d_bounding_sphere::of(l3d_sphere_mesh(16, 8, 3).vertices);
    EXPECT_NEAR(ball.radius, 3, 1e-12);
    EXPECT_NEAR(l3d_length(ball.centre), 0, 1e-12);
}

TEST(bounding_sphere, of_nothing_touches_nothing) {
    const auto none = l3d_bounding_sphere::of({});
    EXPECT_EQ(none.radius, 0);
    EXPECT_FALSE(none.touches(none));
}

TEST(bounding_sphere, holds_what_was_placed) {
    l3d_random random(2);
    for (int round = 0; round < 200; ++round) {
        const std::vector<vector> places = cloud(random);
        const auto some = [&](int most) { return static_cast<double>(random.between(1, most)); };
        const l3d_matrix<double> placement = l3d_translation<double>(some(50), -some(50), some(9)) *
                                             l3d_rotation_x<double>(some(360)) *
                                             l3d_rotation_z<double>(some(360)) *
                                             l3d_scaling<double>(some(5), some(5), some(5));
        const auto ball = l3d_bounding_sphere::of(places).placed(placement);
        double farthest = 0;
        for (const vector& place : places) {
            const auto moved = placement * l3d_vector<double, 4>(place, 1.0);
            farthest =
                std::max(farthest, l3d_length(vector(moved[0], moved[1], moved[2]) - ball.centre));
        }
        EXPECT_LE(farthest, ball.radius * (1 + 1e-12));
    }
}

TEST(bounding_sphere, keeps_its_radius_where_nothing_is_scaled) {
    const l3d_bounding_sphere ball{{1, 2, 3}, 4};
    const auto moved = ball.placed(l3d_translation<double>(5, 6, 7) * l3d_rotation_y<double>(33));
    EXPECT_NEAR(moved.radius, 4, 1e-12);
    EXPECT_NEAR(moved.centre[1], 8, 1e-12);
}

TEST(bounding_sphere, touches_where_the_distance_is_less_than_both_radii) {
    const l3d_bounding_sphere one{{0, 0, 0}, 3};
    for (const int axis : {0, 1, 2}) {
        l3d_bounding_sphere other{{0, 0, 0}, 1.5};
        other.centre[axis] = 4.5;
        EXPECT_FALSE(one.touches(other)) << "as the book has it, balls that kiss do not touch";
        other.centre[axis] = -4.499;
        EXPECT_TRUE(one.touches(other));
        EXPECT_TRUE(other.touches(one));
        other.centre[axis] = 4.501;
        EXPECT_FALSE(other.touches(one));
    }
}

} // namespace
