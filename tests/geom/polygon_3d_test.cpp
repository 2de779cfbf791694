// SPDX-License-Identifier: MIT
// l3d_polygon_3d: normals, facing, and cuts by planes: rows of the book's table on polygons.
#include "geom/polygon_3d.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using fixed_32 = l3d_fixed<std::int64_t, 32>;
using indices = std::vector<std::uint32_t>;

template <class T> using points = std::vector<l3d_point<T>>;

template <class T> class book_polygon_3d : public testing::Test {};
using number_types = testing::Types<float, double, fixed_32>;
TYPED_TEST_SUITE(book_polygon_3d, number_types);

/// The pyramid of fltsim, all faces outward.
template <class T> points<T> pyramid() {
    return {l3d_point<T>::of(0, 0, 0), l3d_point<T>::of(10, 0, 0), l3d_point<T>::of(0, 10, 0),
            l3d_point<T>::of(0, 0, 10)};
}
const indices pyramid_faces[] = {{0, 1, 3}, {2, 3, 1}, {0, 2, 1}, {3, 2, 0}};

TYPED_TEST(book_polygon_3d, normals) {
    using T = TypeParam;
    const auto vertices = pyramid<T>();
    const auto middle = l3d_point<T>::of(2, 2, 2);
    for (const indices& face : pyramid_faces) {
        const l3d_polygon_3d<T> polygon{vertices, face};
        const auto plane = polygon.plane();
        ASSERT_TRUE(plane.has_value());
        EXPECT_NEAR(l3d_to_double(l3d_length(plane->normal)), 1, 1e-6);
        EXPECT_LT(l3d_to_double(plane->side_of_point(middle)), -1);
        EXPECT_GT(l3d_to_double(l3d_dot(plane->normal, polygon.centre() - middle)), 0);
    }
    const l3d_polygon_3d<T> slope{vertices, pyramid_faces[1]};
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(l3d_to_double(slope.centre()[i]), 10 / 3., 1e-5);
        EXPECT_NEAR(l3d_to_double(slope.plane()->normal[i]), std::sqrt(1 / 3.), 1e-6);
    }
    EXPECT_NEAR(slope.area(), 50 * std::sqrt(3.), 1e-4);
}

TYPED_TEST(book_polygon_3d, degenerate_polygons) {
    using T = TypeParam;
    const points<T> line{l3d_point<T>::of(1, 2, 3), l3d_point<T>::of(2, 4, 5),
                         l3d_point<T>::of(5, 10, 11), l3d_point<T>::of(5, 11, 11)};
    const indices collinear{0, 1, 2}, again{1, 1, 1}, late{0, 1, 2, 3};
    EXPECT_FALSE((l3d_polygon_3d<T>{line, collinear}.plane().has_value()));
    EXPECT_FALSE((l3d_polygon_3d<T>{line, again}.plane().has_value()));
    EXPECT_FALSE((l3d_polygon_3d<T>{line, collinear}.faces(l3d_point<T>::of(9, 9, -9))));
    // The first three corners are on a line, the next are not.
    EXPECT_TRUE((l3d_polygon_3d<T>{line, late}.plane().has_value()));
}

/// Seen from the front, a left-handed triangle is clockwise on the screen, whose y is down: its
/// area by the shoelace rule is positive there.
TYPED_TEST(book_polygon_3d, facing_test) {
    using T = TypeParam;
    std::mt19937 random(17);
    const auto uniform = [&random] { return static_cast<double>(random()) / 0x1p31 - 1; };
    const indices corners{0, 1, 2};
    const auto origin = l3d_point<T>::of(0, 0, 0);
    int seen = 0;
    for (int i = 0; i < 10000; ++i) {
        points<T> p;
        double x[3], y[3];
        for (int k = 0; k < 3; ++k) {
            p.push_back(l3d_point<T>::of(9 * uniform(), 9 * uniform(), 10 + 8 * uniform()));
            x[k] = l3d_to_double(p.back()[0]) / l3d_to_double(p.back()[2]);
            y[k] = -l3d_to_double(p.back()[1]) / l3d_to_double(p.back()[2]);
        }
        const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
        if (std::abs(area) < 1e-5)
            continue; // edge-on as far as float can tell
        ++seen;
        ASSERT_EQ((l3d_polygon_3d<T>{p, corners}.faces(origin)), area > 0) << "case " << i;
    }
    EXPECT_GT(seen, 9900);
}

TYPED_TEST(book_polygon_3d, near_clipping) {
    using T = TypeParam;
    const auto near = l3d_from_double<T>(5);
    points<T> p{l3d_point<T>::of(0, 0, 0), l3d_point<T>::of(10, 20, 20),
                l3d_point<T>::of(-3, 30, 21)};
    const indices face{0, 1, 2};
    indices kept{7, 7};
    ASSERT_TRUE(l3d_clip_near_z<T>(face, near, p, kept));
    ASSERT_EQ(p.size(), 5u);
    EXPECT_EQ(kept, (indices{3, 4, 1, 2})); // corner 0 is behind: the edges from 2 and to 1 are cut
    EXPECT_EQ(p[4], l3d_point<T>::of(2.5, 5, 5));
    EXPECT_EQ(p[3][2], near);
    EXPECT_NEAR(l3d_to_double(p[3][1]), 30 * 5 / 21., 1e-5);

    points<T> behind{l3d_point<T>::of(0, 1, 4), l3d_point<T>::of(2, 2, 5),
                     l3d_point<T>::of(3, 3, -9)};
    EXPECT_FALSE(l3d_clip_near_z<T>(face, near, behind, kept));
    EXPECT_TRUE(kept.empty());
    EXPECT_EQ(behind.size(), 3u);
    points<T> front{l3d_point<T>::of(0, 1, 5), l3d_point<T>::of(2, 2, 6),
                    l3d_point<T>::of(3, 3, 9)};
    const indices turned{2, 0, 1};
    EXPECT_TRUE(l3d_clip_near_z<T>(turned, near, front, kept));
    EXPECT_EQ(kept, turned); // unchanged, in the same order
    EXPECT_EQ(front.size(), 3u);
}

TYPED_TEST(book_polygon_3d, clip_to_any_plane) {
    using T = TypeParam;
    // A square about (4, 1, 7) whose diagonal is on the plane x = 4; the book's code drops it.
    points<T> square{l3d_point<T>::of(4, 3, 7), l3d_point<T>::of(6, 1, 7),
                     l3d_point<T>::of(4, -1, 7), l3d_point<T>::of(2, 1, 7)};
    const indices face{0, 1, 2, 3};
    const l3d_plane<T> plane =
        l3d_plane<T>::through(l3d_point<T>::of(4, 9, 9), l3d_point<T>::of(1, 0, 0).from_origin);
    indices kept;
    ASSERT_TRUE(l3d_clip_to_plane(face, plane, square, kept));
    EXPECT_EQ(kept, (indices{0, 1, 2}));
    ASSERT_TRUE(l3d_clip_to_plane(face, plane.flipped(), square, kept));
    EXPECT_EQ(kept, (indices{0, 2, 3}));
    EXPECT_EQ(square.size(), 4u);
    // All on it, or behind with an edge on it: nothing.
    const indices edge_on{0, 2, 0};
    EXPECT_FALSE(l3d_clip_to_plane(edge_on, plane, square, kept));
    const indices behind{0, 2, 3};
    EXPECT_FALSE(l3d_clip_to_plane(behind, plane, square, kept));
    EXPECT_TRUE(kept.empty());
    // One corner on it, one edge cut.
    points<T> triangle{l3d_point<T>::of(4, 5, 1), l3d_point<T>::of(2, 1, 1),
                       l3d_point<T>::of(8, 1, 4)};
    ASSERT_TRUE(l3d_clip_to_plane(indices{0, 1, 2}, plane, triangle, kept));
    ASSERT_EQ(kept, (indices{0, 3, 2}));
    EXPECT_NEAR(l3d_to_double(triangle[3][0]), 4, 1e-6);
    EXPECT_NEAR(l3d_to_double(triangle[3][1]), 1, 1e-6);
    EXPECT_NEAR(l3d_to_double(triangle[3][2]), 2, 1e-6);
}

/// Both halves of a random convex polygon have its area together, and their own sides.
TYPED_TEST(book_polygon_3d, halves_add_up) {
    using T = TypeParam;
    std::mt19937 random(23);
    const auto uniform = [&random] { return static_cast<double>(random()) / 0x1p31 - 1; };
    int cut = 0;
    for (int i = 0; i < 3000; ++i) {
        // Corners of an ellipse in a slanted plane.
        const int n = 3 + static_cast<int>(random() % 8);
        points<T> vertices;
        indices face;
        const double at[3] = {5 * uniform(), 5 * uniform(), 5 * uniform()};
        const l3d_vector<double, 3> u(1 + uniform(), uniform(), 2), v(uniform(), 2, -uniform());
        for (int k = 0; k < n; ++k) {
            const double angle = (k + 0.4 * uniform()) * 2 * std::numbers::pi / n;
            const auto p = u * (3 * std::cos(angle)) + v * (2 * std::sin(angle));
            vertices.push_back(l3d_point<T>::of(at[0] + p[0], at[1] + p[1], at[2] + p[2]));
            face.push_back(static_cast<std::uint32_t>(k));
        }
        const auto plane =
            l3d_plane<T>::through(l3d_point<T>::of(5 * uniform(), 5 * uniform(), 5 * uniform()),
                                  l3d_point<T>::of(uniform(), 1.5, uniform()).from_origin);
        const double whole = l3d_polygon_3d<T>{vertices, face}.area();
        double sum = 0;
        for (const auto& half : {plane, plane.flipped()}) {
            indices kept;
            if (!l3d_clip_to_plane(face, half, vertices, kept))
                continue;
            cut += kept != face;
            sum += l3d_polygon_3d<T>{vertices, kept}.area();
            for (const std::uint32_t corner : kept)
                ASSERT_GT(l3d_to_double(half.side_of_point(vertices[corner])),
                          -l3d_plane_thickness - 1e-5);
        }
        ASSERT_NEAR(sum, whole, 1e-4 * whole) << "case " << i;
    }
    EXPECT_GT(cut, 500);
}

/// Neighbours that share an edge get the same new vertex to the last bit, whichever way each of
/// them runs along it.
TYPED_TEST(book_polygon_3d, neighbours_cut_alike) {
    using T = TypeParam;
    std::mt19937 random(29);
    const auto uniform = [&random] { return static_cast<double>(random()) / 0x1p31 - 1; };
    for (int i = 0; i < 1000; ++i) {
        points<T> p;
        for (int k = 0; k < 4; ++k)
            p.push_back(l3d_point<T>::of(9 * uniform(), 9 * uniform(), 9 * uniform()));
        const auto near = l3d_from_double<T>(uniform());
        if ((p[0][2] > near) == (p[1][2] > near))
            continue;
        indices a, b;
        ASSERT_TRUE(l3d_clip_near_z<T>(indices{0, 1, 2}, near, p, a));
        const std::size_t middle = p.size();
        ASSERT_TRUE(l3d_clip_near_z<T>(indices{1, 0, 3}, near, p, b));
        int shared = 0;
        for (std::size_t m = 4; m < middle; ++m)
            for (std::size_t n = middle; n < p.size(); ++n)
                shared += p[m] == p[n];
        ASSERT_EQ(shared, 1) << "case " << i;
    }
}

} // namespace
