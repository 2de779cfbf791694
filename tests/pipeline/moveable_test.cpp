// SPDX-License-Identifier: MIT
// l3d_moveable and the left-handed camera: the rows of the book's table on flying and looking.
#include "pipeline/worlds/camera_left_handed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace {

using fixed_32 = l3d_fixed<std::int64_t, 32>;

template <class T> double number(const l3d_vector<T, 3>& v, int axis) {
    return l3d_to_double(v[axis]);
}

template <class T> class book_moveable : public testing::Test {};
using number_types = testing::Types<float, double, fixed_32>;
TYPED_TEST_SUITE(book_moveable, number_types);

template <class T> void expect_orthonormal(const l3d_moveable<T>& body, double tolerance) {
    const l3d_vector<T, 3> axes[3] = {body.right(), body.up(), body.forward()};
    for (int i = 0; i < 3; ++i) {
        const auto a = l3d_converted<double, T, 3>(axes[i]);
        const auto b = l3d_converted<double, T, 3>(axes[(i + 1) % 3]);
        const auto c = l3d_converted<double, T, 3>(axes[(i + 2) % 3]);
        ASSERT_NEAR(l3d_length(a), 1, tolerance);
        ASSERT_NEAR(l3d_dot(a, b), 0, tolerance);
        ASSERT_NEAR(l3d_length(l3d_cross(a, b) - c), 0, 4 * tolerance);
    }
}

TYPED_TEST(book_moveable, movable_frame) {
    l3d_moveable<TypeParam> body;
    std::mt19937 random(3);
    for (int i = 0; i < 1000000; ++i) {
        const double degrees = static_cast<double>(random()) / 0x1p32 * 38 - 19;
        switch (random() % 3) {
        case 0:
            body.turn_about_right(degrees);
            break;
        case 1:
            body.turn_about_up(degrees);
            break;
        default:
            body.turn_about_forward(degrees);
        }
        if (i % 1000 == 999)
            expect_orthonormal(body, 1e-6);
    }
}

/// One turn about one axis leaves the axis alone, and turns the other two the right way round.
TYPED_TEST(book_moveable, turns_about_its_own_axes) {
    using moveable = l3d_moveable<TypeParam>;
    const auto expect = [](const auto& v, double x, double y, double z) {
        EXPECT_NEAR(number(v, 0), x, 1e-6);
        EXPECT_NEAR(number(v, 1), y, 1e-6);
        EXPECT_NEAR(number(v, 2), z, 1e-6);
    };
    moveable yaw, pitch, roll;
    yaw.turn_about_up(90); // z towards x
    expect(yaw.forward(), 1, 0, 0);
    expect(yaw.right(), 0, 0, -1);
    expect(yaw.up(), 0, 1, 0);
    pitch.turn_about_right(90); // y towards z
    expect(pitch.up(), 0, 0, 1);
    expect(pitch.forward(), 0, -1, 0);
    expect(pitch.right(), 1, 0, 0);
    roll.turn_about_forward(90); // x towards y
    expect(roll.right(), 0, 1, 0);
    expect(roll.up(), -1, 0, 0);
    expect(roll.forward(), 0, 0, 1);
    // Not the world's axes: after a yaw, a pitch is about another.
    yaw.turn_about_right(90);
    expect(yaw.forward(), 0, -1, 0);
    expect(yaw.up(), 1, 0, 0);
}

TYPED_TEST(book_moveable, view_transform) {
    using T = TypeParam;
    l3d_moveable<T> body;
    EXPECT_EQ(l3d_transformed(body.viewing_transform(), l3d_point<T>::of(50, 5, 60)),
              l3d_point<T>::of(0, 0, 10));
    body.place = l3d_point<T>::of(-31, 12.5, 44);
    body.turn_about_up(33);
    body.turn_about_right(-71);
    body.turn_about_forward(140);
    const auto product = body.viewing_transform() * body.inverse_viewing_transform();
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            EXPECT_NEAR(l3d_to_double(product(i, j)), i == j, 1e-5);
    // Row "Coordinate change": world to camera and back.
    const auto p = l3d_point<T>::of(7, -19, 3);
    const auto back = l3d_transformed(body.inverse_viewing_transform(),
                                      l3d_transformed(body.viewing_transform(), p));
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(l3d_to_double(back[i] - p[i]), 0, 1e-5);
}

TYPED_TEST(book_moveable, axes_can_be_set) {
    using T = TypeParam;
    using point = l3d_point<T>;
    l3d_moveable<T> body;
    body.place = point::of(1, 2, 3);
    ASSERT_TRUE(body.look_at(point::of(1, 2, -50))); // back, upright
    EXPECT_NEAR(number(body.forward(), 2), -1, 1e-6);
    EXPECT_NEAR(number(body.up(), 1), 1, 1e-6);
    EXPECT_NEAR(number(body.right(), 0), -1, 1e-6);
    const auto up = point::of(0, 1, 0).from_origin, along = point::of(0, 3, 0).from_origin;
    const auto none = point::of(0, 0, 0).from_origin;
    EXPECT_FALSE(body.set_axes(along, up));
    EXPECT_FALSE(body.set_axes(none, up));
    EXPECT_FALSE(body.set_axes(up, none));
    EXPECT_FALSE(body.look_at(body.place));
    EXPECT_NEAR(number(body.forward(), 2), -1, 1e-6); // as it was
    std::mt19937 random(5);
    const auto any = [&] { return static_cast<double>(random()) / 0x1p31 - 1; };
    for (int i = 0; i < 1000; ++i) {
        const double scale = std::exp2(9 * any()); // of very short and very long directions
        const point target = point::of(1 + scale * any(), 2 + scale * any(), 3 + scale * any());
        if (!body.look_at(target, point::of(any(), any(), any()).from_origin))
            continue;
        expect_orthonormal(body, 1e-6);
        const auto seen = l3d_transformed(body.viewing_transform(), target);
        EXPECT_GT(l3d_to_double(seen[2]), 0);
        EXPECT_NEAR(l3d_to_double(seen[0]), 0, 1e-5 * scale + 1e-6);
        EXPECT_NEAR(l3d_to_double(seen[1]), 0, 1e-5 * scale + 1e-6);
    }
}

/// The book's transform: a body is moved and turned as everything else is by a matrix.
TYPED_TEST(book_moveable, is_transformed) {
    using T = TypeParam;
    l3d_moveable<T> body;
    body.place = l3d_point<T>::of(10, 0, 0);
    ASSERT_TRUE(body.transform(l3d_translation<T>(0, 0, 5) * l3d_rotation_y<T>(90)));
    EXPECT_NEAR(l3d_to_double(body.place[0]), 0, 1e-6);
    EXPECT_NEAR(l3d_to_double(body.place[2]), -5, 1e-6); // x turns towards -z
    EXPECT_NEAR(number(body.forward(), 0), 1, 1e-6);
    EXPECT_NEAR(number(body.right(), 2), -1, 1e-6);
    EXPECT_FALSE(body.transform(l3d_scaling<T>(0, 0, 0)));
    EXPECT_NEAR(l3d_to_double(body.place[2]), -5, 1e-6);
}

/// One push travels 0.2 * 0.95 / 0.05 = 3.8 units in the end, as in the book; one turn turns
/// 5 * 0.85 / 0.15 degrees, of which the book cut off the fractions.
TYPED_TEST(book_moveable, a_push_is_damped_and_ends) {
    using moveable = l3d_moveable<TypeParam>;
    moveable body;
    body.push({0, 0, 1});
    body.update(1 / l3d_book_rate);
    EXPECT_NEAR(l3d_to_double(body.place[2]), 50 + 0.19, 1e-5);
    body.update(1 / l3d_book_rate);
    EXPECT_NEAR(l3d_to_double(body.place[2]), 50 + 0.19 + 0.1805, 1e-5);
    body.push({-1, 1, 0});
    body.twist({0, 0, -1});
    for (int i = 0; i < 2000; ++i)
        body.update(1 / l3d_book_rate);
    EXPECT_EQ(body.velocity.forward, 0); // a dead zone, no creeping
    EXPECT_EQ(body.velocity.right, 0);
    EXPECT_EQ(body.spin.forward, 0);
    EXPECT_NEAR(l3d_to_double(body.place[2]), 53.8, 0.02);
    EXPECT_NEAR(std::atan2(number(body.right(), 1), number(body.right(), 0)) * 180 /
                    std::numbers::pi,
                -5 * 0.85 / 0.15, 0.01);
    const auto rest = body.place;
    body.update(3);
    EXPECT_EQ(body.place, rest);
}

TYPED_TEST(book_moveable, pushes_have_limits) {
    l3d_moveable<TypeParam> body;
    for (int i = 0; i < 1000; ++i) {
        body.push({1, 0, -1});
        body.twist({0, 1, 0});
    }
    EXPECT_NEAR(body.velocity.right, 90 * l3d_book_rate, 12.001);
    EXPECT_NEAR(body.velocity.forward, -90 * l3d_book_rate, 12.001);
    EXPECT_EQ(body.spin.up, 95 * l3d_book_rate);
    body.twist({0, -1, 0}); // the way back is open
    EXPECT_EQ(body.spin.up, 90 * l3d_book_rate);
}

/// A flight with everything at once: where it is after a second, of that many frames.
template <class T> l3d_moveable<T> flown(int frames) {
    l3d_moveable<T> body;
    body.push({0.5, -1, 3});
    body.twist({1, -2, 1});
    for (int i = 0; i < frames; ++i)
        body.update(1.0 / frames);
    return body;
}

TYPED_TEST(book_moveable, frame_rate_independence) {
    const auto reference = flown<TypeParam>(1000);
    const double way = l3d_to_double(l3d_length(reference.place - l3d_moveable<TypeParam>().place));
    ASSERT_GT(way, 5);
    for (const int frames : {30, 60, 144}) {
        const auto body = flown<TypeParam>(frames);
        EXPECT_LT(l3d_to_double(l3d_length(body.place - reference.place)), way / 100) << frames;
        EXPECT_LT(l3d_to_double(l3d_length(body.forward() - reference.forward())), 0.01) << frames;
    }
}

TYPED_TEST(book_moveable, field_of_view) {
    using T = TypeParam;
    EXPECT_NEAR(l3d_fov_term(100), 0.41955, 5e-6);
    EXPECT_NEAR(l3d_fov_term(60), 0.86603, 5e-6);
    EXPECT_NEAR(l3d_fov_degrees(l3d_fov_term(77)), 77, 1e-9);
    const l3d_size size{320, 240};
    l3d_camera_left_handed<T> camera(size);
    EXPECT_NEAR(camera.fovx, 0.41955, 5e-6);
    EXPECT_NEAR(camera.fovy, 0.55940, 5e-6);
    const double half = 50 * std::numbers::pi / 180;
    const auto edge = camera.project(l3d_point<T>::of(7 * std::tan(half), 0, 7), size);
    EXPECT_NEAR(edge.x, 320, 1e-4);
    EXPECT_NEAR(edge.y, 120, 1e-4);
    camera.change_size(size, {640, 240}); // twice as wide: squares stay squares
    EXPECT_NEAR(camera.fovx * 640, camera.fovy * 240, 1e-9);
}

TYPED_TEST(book_moveable, projection) {
    using T = TypeParam;
    const l3d_size size{640, 400};
    const l3d_camera_left_handed<T> camera(size);
    EXPECT_NEAR(camera.fovy, 0.67128, 5e-6);
    const auto centre = camera.project(l3d_point<T>::of(0, 0, 3), size);
    EXPECT_EQ(centre.x, 320);
    EXPECT_EQ(centre.y, 200);
    EXPECT_LT(camera.project(l3d_point<T>::of(0, 1, 3), size).y, 200);
    // The point (1, 1, 1) of fltsim, seen from (0, 0, -50).
    const auto tip = camera.project(l3d_point<T>::of(1, 1, 51), size);
    EXPECT_NEAR(tip.x, 325.265, 1e-3);
    EXPECT_NEAR(tip.y, 194.735, 1e-3);
}

/// Our camera's picture of the mirrored world is the book's picture, half a pixel further.
TYPED_TEST(book_moveable, left_handed_camera_in_our_world) {
    using T = TypeParam;
    const l3d_size size{400, 300};
    l3d_camera_left_handed<T> camera(size);
    camera.fovx = l3d_fov_term(63);
    camera.fovy = camera.fovx * size.width / size.height;
    std::mt19937 random(5);
    const auto uniform = [&random] { return static_cast<double>(random()) / 0x1p31 - 1; };
    for (int i = 0; i < 1000; ++i) {
        camera.place = l3d_point<T>::of(20 * uniform(), 20 * uniform(), 20 * uniform());
        camera.turn_about_up(180 * uniform());
        camera.turn_about_right(80 * uniform());
        camera.turn_about_forward(180 * uniform());
        const auto seen = l3d_point<T>::of(5 * uniform(), 4 * uniform(), 12 + 6 * uniform());
        const auto world = l3d_transformed(camera.inverse_viewing_transform(), seen);
        const auto pixel = camera.project(seen, size);
        const auto matrix = l3d_right_handed(camera).image_matrix(size);
        const auto image =
            matrix * l3d_vector<double, 4>(l3d_to_double(world[0]), l3d_to_double(world[1]),
                                           -l3d_to_double(world[2]), 1.0);
        EXPECT_NEAR(image[0] / image[3] + size.width / 2.0, pixel.x, 2e-3);
        EXPECT_NEAR(image[1] / image[3] + size.height / 2.0, pixel.y, 2e-3);
        EXPECT_NEAR(image[3], l3d_to_double(seen[2]), 1e-4);
    }
}

} // namespace
