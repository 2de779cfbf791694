// SPDX-License-Identifier: MIT
// Vertex lists, coordinates, polygons over them, and their clipping: the book's rows 23 to 30.
#include "geom/polygon_2d.h"

#include "geom/random.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace {

using indices = std::vector<std::uint32_t>;

template <class T> l3d_position<T> position(double x, double y) {
    return {l3d_from_double<T>(x), l3d_from_double<T>(y)};
}

template <class T> l3d_vertex_list<T> list_of(std::initializer_list<std::array<double, 2>> places) {
    std::vector<l3d_coordinate<T>> vertices;
    for (const auto& place : places)
        vertices.emplace_back(l3d_point<T>::of(place[0], place[1], 0));
    return l3d_vertex_list<T>(vertices);
}

indices kept(const l3d_polygon_2d& polygon) {
    return {polygon.clip_ivertices().begin(), polygon.clip_ivertices().end()};
}

template <class T> class polygon_2d : public testing::Test {};
using numbers_tested = testing::Types<float, double, l3d_fixed<std::int64_t, 32>>;
TYPED_TEST_SUITE(polygon_2d, numbers_tested);

/// A place in more digits than any of the number types has.
struct place {
    long double x, y;
};
using places = std::vector<place>;

long double side(const place& p, const place& a, const place& b) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

bool holds(const places& polygon, const place& p) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
        if (side(p, polygon[i], polygon[(i + 1) % polygon.size()]) < 0)
            return false;
    return true;
}

long double area(const places& polygon) {
    long double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        twice += side(polygon[i], polygon[0], polygon[(i + 1) % polygon.size()]);
    return std::abs(twice) / 2;
}

/// The corners of either polygon that are in the other one, and where edges cross; then in order
/// around their middle. It shares nothing with the library's way.
places slow_intersection(const places& p, const places& q) {
    places found;
    std::ranges::copy_if(p, std::back_inserter(found), [&](auto& v) { return holds(q, v); });
    std::ranges::copy_if(q, std::back_inserter(found), [&](auto& v) { return holds(p, v); });
    for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t j = 0; j < q.size(); ++j) {
            const place &a = p[i], &b = p[(i + 1) % p.size()];
            const place &c = q[j], &d = q[(j + 1) % q.size()];
            const long double sa = side(a, c, d), sb = side(b, c, d);
            if (sa * sb < 0 && side(c, a, b) * side(d, a, b) < 0)
                found.push_back(
                    {a.x + (b.x - a.x) * sa / (sa - sb), a.y + (b.y - a.y) * sa / (sa - sb)});
        }
    place middle{};
    for (const place& v : found)
        middle = {middle.x + v.x / static_cast<long double>(found.size()),
                  middle.y + v.y / static_cast<long double>(found.size())};
    std::ranges::sort(found, {},
                      [&](const place& v) { return std::atan2(v.y - middle.y, v.x - middle.x); });
    return found;
}

/// A convex polygon: corners in clockwise order on an ellipse.
template <class T>
std::vector<l3d_position<T>> random_polygon(l3d_random& random, int corners, double size) {
    const double x = size * (random.fraction() - 0.3), y = size * (random.fraction() - 0.4);
    const double width = size * (0.1 + random.fraction()),
                 height = size * (0.1 + random.fraction());
    std::vector<double> angles;
    for (int i = 0; i < corners; ++i)
        angles.push_back(2 * std::numbers::pi * random.fraction());
    std::ranges::sort(angles);
    std::vector<l3d_position<T>> polygon;
    for (const double angle : angles)
        polygon.push_back(position<T>(x + width * std::cos(angle), y + height * std::sin(angle)));
    return polygon;
}

template <class T> places as_places(std::span<const l3d_position<T>> polygon) {
    places result;
    for (const auto& p : polygon)
        result.push_back({l3d_to_double(p[0]), l3d_to_double(p[1])});
    return result;
}

template <class T>
void expect_intersection(const std::vector<l3d_position<T>>& corners,
                         const std::vector<l3d_position<T>>& window, double tolerance) {
    std::vector<l3d_coordinate<T>> vertices;
    indices all;
    for (const auto& corner : corners) {
        all.push_back(static_cast<std::uint32_t>(vertices.size()));
        vertices.emplace_back(l3d_point<T>(corner[0], corner[1], l3d_from_double<T>(0)));
    }
    l3d_vertex_list<T> list(vertices);
    l3d_polygon_2d polygon(all);
    const bool visible = polygon.clip_to_polygon_2d(list, window);
    std::vector<l3d_position<T>> clipped;
    for (const std::uint32_t i : polygon.clip_ivertices())
        clipped.push_back(l3d_in_picture(list[i]));
    ASSERT_EQ(visible, !clipped.empty());
    const places wanted = slow_intersection(as_places<T>(corners), as_places<T>(window));
    const auto found = as_places(std::span<const l3d_position<T>>(clipped));
    const auto wanted_area = wanted.size() < 3 ? 0 : area(wanted);
    ASSERT_NEAR(static_cast<double>(found.empty() ? 0 : area(found)),
                static_cast<double>(wanted_area), tolerance);
}

/// A vertex with a value of its own, as gouraud shading or textures have it.
template <class T> struct bright_vertex : l3d_coordinate<T> {
    bright_vertex(double x, double y, double light)
        : l3d_coordinate<T>(l3d_point<T>::of(x, y, 0)), brightness(light) {}
    bright_vertex(const l3d_coordinate<T>& base, double light)
        : l3d_coordinate<T>(base), brightness(light) {}
    double brightness;
};

template <class T>
bright_vertex<T> l3d_cut_vertex(const bright_vertex<T>& from, const bright_vertex<T>& to,
                                const l3d_crossing_2d<T>& crossing) {
    return {l3d_cut_vertex<T>(static_cast<const l3d_coordinate<T>&>(from), to, crossing),
            from.brightness + (to.brightness - from.brightness) * crossing.t};
}

} // namespace

TYPED_TEST(polygon_2d, row_23_is_the_intersection) {
    l3d_random random(23);
    // Some 40 roundings of coordinates below 1000, each moving an edge no longer than 1000.
    const double unit =
        l3d_real_traits<TypeParam>::unit_roundoff * 1000 + l3d_real_traits<TypeParam>::half_ulp;
    for (int i = 0; i < 10000; ++i) {
        const auto polygon = random_polygon<TypeParam>(random, random.between(3, 12), 400);
        const auto window = random_polygon<TypeParam>(random, random.between(3, 8), 300);
        ASSERT_NO_FATAL_FAILURE(expect_intersection<TypeParam>(polygon, window, 40e3 * unit))
            << "case " << i;
    }
}

TYPED_TEST(polygon_2d, row_23_no_corner_is_outside_an_upright_window) {
    l3d_random random(24);
    const auto window =
        l3d_window_corners(position<TypeParam>(3.3, 5.7), position<TypeParam>(319.1, 199.9));
    for (int i = 0; i < 10000; ++i) {
        l3d_vertex_list<TypeParam> list = list_of<TypeParam>({});
        indices all;
        for (const auto& p : random_polygon<TypeParam>(random, random.between(3, 9), 700))
            all.push_back(list.add_varying(
                l3d_coordinate<TypeParam>({p[0], p[1], l3d_from_double<TypeParam>(0)})));
        l3d_polygon_2d polygon(all);
        polygon.clip_to_polygon_2d(list, window);
        for (const std::uint32_t index : polygon.clip_ivertices()) {
            const auto p = l3d_in_picture(list[index]);
            ASSERT_TRUE(p[0] >= window[0][0] && p[0] <= window[2][0]) << "case " << i;
            ASSERT_TRUE(p[1] >= window[0][1] && p[1] <= window[2][1]) << "case " << i;
        }
    }
}

TYPED_TEST(polygon_2d, row_23_keeps_the_order_and_the_indices_of_what_is_inside) {
    auto list = list_of<TypeParam>({{20, 30}, {50, 25}, {130, 60}, {40, 90}});
    const auto window =
        l3d_window_corners(position<TypeParam>(10, 10), position<TypeParam>(100, 100));
    l3d_polygon_2d polygon({0, 1, 2, 3});
    EXPECT_TRUE(polygon.clip_to_polygon_2d(list, window));
    EXPECT_EQ(kept(polygon), (indices{0, 1, 4, 5, 3}));
    EXPECT_EQ(l3d_in_picture(list[4])[0], l3d_from_double<TypeParam>(100));
    EXPECT_EQ(l3d_in_picture(list[5])[0], l3d_from_double<TypeParam>(100));
    EXPECT_NEAR(l3d_to_double(l3d_in_picture(list[4])[1]), 25 + 35 * 50 / 80.0, 1e-5);
    EXPECT_NEAR(l3d_to_double(l3d_in_picture(list[5])[1]), 60 + 30 * 30 / 90.0, 1e-5);
    polygon.init_clip_ivertices();
    EXPECT_EQ(kept(polygon), (indices{0, 1, 2, 3}));
}

TYPED_TEST(polygon_2d, row_24_corner_cases) {
    const auto window =
        l3d_window_corners(position<TypeParam>(10, 20), position<TypeParam>(110, 80));
    const auto clipped = [&](std::initializer_list<std::array<double, 2>> corners) {
        auto list = list_of<TypeParam>(corners);
        indices all;
        for (std::uint32_t i = 0; i < corners.size(); ++i)
            all.push_back(i);
        l3d_polygon_2d polygon(all);
        const bool visible = polygon.clip_to_polygon_2d(list, window);
        EXPECT_EQ(visible, !polygon.clip_ivertices().empty());
        std::vector<l3d_position<TypeParam>> result;
        for (const std::uint32_t i : polygon.clip_ivertices())
            result.push_back(l3d_in_picture(list[i]));
        return result;
    };
    // The window inside the polygon: its four corners, clockwise.
    auto covered = clipped({{-500, -300}, {700, -250}, {50, 900}});
    ASSERT_EQ(covered.size(), 4u);
    std::rotate(covered.begin(), std::ranges::find(covered, window[0]), covered.end());
    EXPECT_TRUE(std::ranges::equal(covered, window));
    // All inside, two corners on an edge: as it was.
    EXPECT_EQ(clipped({{10, 30}, {60, 50}, {10, 70}}).size(), 3u);
    // All outside, on one side or around a corner.
    EXPECT_TRUE(clipped({{-5, 30}, {5, 40}, {-3, 60}}).empty());
    EXPECT_TRUE(clipped({{-20, 30}, {30, -20}, {-20, -20}}).empty());
    // Outside, but for a corner or an edge that touches.
    EXPECT_TRUE(clipped({{10, 50}, {-5, 60}, {-3, 40}}).empty());
    EXPECT_TRUE(clipped({{10, 30}, {10, 70}, {-3, 40}}).empty());
    // No corner inside, but a piece.
    EXPECT_EQ(clipped({{0, 10}, {40, 10}, {0, 50}}).size(), 3u);
    // Without area: nothing to see, but nothing to fear.
    EXPECT_LE(clipped({{30, 30}, {60, 60}, {45, 45}}).size(), 3u);
}

TYPED_TEST(polygon_2d, row_24_what_is_not_finite_does_no_harm) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double inf = std::numeric_limits<double>::infinity();
    const auto window = l3d_window_corners(position<TypeParam>(1, 2), position<TypeParam>(9, 8));
    for (const double odd : {nan, inf, -inf, 1e30, -1e30}) {
        auto list = list_of<TypeParam>({{3, 3}, {odd, 4}, {5, odd}});
        l3d_polygon_2d polygon({0, 1, 2});
        polygon.clip_to_polygon_2d(list, window);
        for (const std::uint32_t i : polygon.clip_ivertices())
            ASSERT_LT(i, list.size());
    }
}

TYPED_TEST(polygon_2d, row_25_the_varying_part_comes_and_goes) {
    auto list = list_of<TypeParam>({{20, 30}, {50, 25}, {130, 60}, {40, 90}});
    const auto window =
        l3d_window_corners(position<TypeParam>(30, 10), position<TypeParam>(100, 100));
    l3d_polygon_2d polygon({0, 1, 2, 3});
    for (int frame = 0; frame < 1000; ++frame) {
        list.clear_varying();
        polygon.init_clip_ivertices();
        EXPECT_TRUE(polygon.clip_to_polygon_2d(list, window));
        ASSERT_EQ(list.varying_size(), 4u);
    }
    EXPECT_EQ(list.fixed_size(), 4u);
    EXPECT_EQ(list[2].original, l3d_point<TypeParam>::of(130, 60, 0));
    EXPECT_EQ(list.size(), 8u);
}

TYPED_TEST(polygon_2d, row_25_a_wrong_index_is_noticed) {
#ifdef NDEBUG
    GTEST_SKIP() << "assertions are off";
#else
    auto list = list_of<TypeParam>({{20, 30}});
    EXPECT_DEATH(static_cast<void>(list[1]), "index");
#endif
}

TYPED_TEST(polygon_2d, row_26_another_list_changes_all_polygons) {
    auto now = list_of<TypeParam>({{20, 30}, {50, 25}, {40, 60}});
    auto next = list_of<TypeParam>({{21, 33}, {54, 22}, {44, 69}});
    const l3d_polygon_2d one({0, 1, 2});
    const l3d_polygon_2d other({2, 1, 0});
    auto* list = &now;
    EXPECT_EQ(l3d_in_picture((*list)[one.clip_ivertices()[1]]), position<TypeParam>(50, 25));
    list = &next;
    EXPECT_EQ(l3d_in_picture((*list)[one.clip_ivertices()[1]]), position<TypeParam>(54, 22));
    EXPECT_EQ(l3d_in_picture((*list)[other.clip_ivertices()[0]]), position<TypeParam>(44, 69));
}

TYPED_TEST(polygon_2d, row_27_a_stage_is_done_once) {
    l3d_coordinate<TypeParam> vertex(l3d_point<TypeParam>::of(7, -3, 2));
    const auto shift = l3d_translation<TypeParam>(10, 20, 30);
    vertex.transform(shift, 1);
    vertex.transform(shift, 1);
    EXPECT_EQ(vertex.transformed, l3d_point<TypeParam>::of(17, 17, 32));
    vertex.transform(shift, 2);
    EXPECT_EQ(vertex.transformed, l3d_point<TypeParam>::of(27, 37, 62));
    EXPECT_EQ(vertex.original, l3d_point<TypeParam>::of(7, -3, 2));
    vertex.reset();
    EXPECT_EQ(vertex.transformed, vertex.original);
    vertex.transform(shift, 1);
    EXPECT_EQ(vertex.transformed, l3d_point<TypeParam>::of(17, 17, 32));
}

TYPED_TEST(polygon_2d, row_28_a_copy_is_deep) {
    auto list = list_of<TypeParam>({{20, 30}, {50, 25}, {130, 60}, {40, 90}});
    const auto window =
        l3d_window_corners(position<TypeParam>(10, 10), position<TypeParam>(100, 100));
    const l3d_polygon_2d original({0, 1, 2, 3});
    l3d_polygon_2d copy = original;
    copy.clip_to_polygon_2d(list, window);
    EXPECT_EQ(copy.clip_ivertices().size(), 5u);
    EXPECT_EQ(kept(original), (indices{0, 1, 2, 3}));
    auto other = list;
    other[0].original = l3d_point<TypeParam>::of(1, 2, 3);
    EXPECT_EQ(list[0].original, l3d_point<TypeParam>::of(20, 30, 0));
}

TYPED_TEST(polygon_2d, row_29_a_list_of_richer_vertices_keeps_what_they_add) {
    l3d_two_part_list<bright_vertex<TypeParam>> list(
        {{20, 30, 0.25}, {50, 20, 0.5}, {150, 60, 1.5}});
    const auto window =
        l3d_window_corners(position<TypeParam>(10, 10), position<TypeParam>(100, 100));
    l3d_polygon_2d polygon({0, 1, 2});
    const auto copy = list;
    EXPECT_EQ(copy[2].brightness, 1.5);
    EXPECT_TRUE(polygon.clip_to_polygon_2d(list, window));
    EXPECT_EQ(kept(polygon), (indices{3, 0, 1, 4}));
    EXPECT_NEAR(list[4].brightness, 1.0, 1e-6); // half way from the second to the third
    EXPECT_NEAR(list[3].brightness, 1.5 - 1.25 * 50 / 130, 1e-6);
}

TYPED_TEST(polygon_2d, row_30_all_vertices_arrive_together) {
    const auto from = list_of<TypeParam>({{-100, 100}, {200, 100}, {950.7, 200}, {940, 200.3}});
    const auto to = list_of<TypeParam>({{100, 150}, {100.1, 100}, {250, 200.9}, {100, 200}});
    for (const int steps : {1, 2, 3, 7, 50}) {
        l3d_vertex_interpolator<TypeParam> morph;
        morph.start(from, to, steps);
        EXPECT_EQ(morph.list()[2].transformed, from[2].original);
        for (int step = 1; step <= steps; ++step) {
            ASSERT_EQ(morph.step(), step < steps);
            const double x = l3d_to_double(morph.list()[2].transformed[0]);
            EXPECT_NEAR(x, 950.7 + (250 - 950.7) * step / steps, 1e-4);
        }
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_EQ(morph.list()[i].original, to[i].original);
    }
}
