// SPDX-License-Identifier: MIT
// Triangles of a frame, against the plainest way to place each by itself.
#include "pipeline/polygons/polygon_frame.h"

#include "dice/snap.h"
#include "geom/polygon_shapes.h"
#include "raster/parallel/simd_target.h"
#include "reference/random_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace {

using reference::random_numbers;

constexpr l3d_size size{157, 118};

/// Triangles between random vertices within `reach`, and `small` ones beside them.
l3d_polygon_mesh random_mesh(random_numbers& random, std::size_t vertices, std::size_t faces,
                             double reach, double small) {
    l3d_polygon_mesh mesh;
    for (std::size_t i = 0; i < vertices; ++i)
        mesh.vertices.push_back({random.between(-reach, reach), random.between(-reach, reach),
                                 random.between(-reach, reach)});
    for (std::size_t i = 0; i < faces; ++i) {
        // Half of them are smaller than a few pixels: their corners are near the first one.
        const auto first = static_cast<std::uint32_t>(random.between(0, double(vertices)));
        std::array<std::uint32_t, 3> face{first % std::uint32_t(vertices)};
        for (std::size_t k = 1; k < face.size(); ++k) {
            if (i % 2 == 0) {
                face[k] = static_cast<std::uint32_t>((face[0] + 1 + k * (1 + i % (vertices / 3))) %
                                                     vertices);
                continue;
            }
            face[k] = static_cast<std::uint32_t>(mesh.vertices.size());
            const auto beside = [&] { return random.between(-small, small); };
            const l3d_polygon_mesh::vector by{beside(), beside(), beside()};
            mesh.vertices.push_back(mesh.vertices[face[0]] + by);
        }
        mesh.add_face(face);
    }
    return mesh;
}

struct plain_triangle {
    std::array<l3d_micro_vertex, 3> v;
    bool operator==(const plain_triangle& other) const {
        for (std::size_t k = 0; k < v.size(); ++k) {
            const l3d_micro_vertex &a = v[k], &b = other.v[k];
            if (a.x != b.x || a.y != b.y || a.inv_w != b.inv_w ||
                !std::equal(a.normal, a.normal + 3, b.normal))
                return false;
        }
        return true;
    }
};

/// One model seen in one way, triangle by triangle.
class plain_frame {
public:
    plain_frame(const l3d_polygon_model& model, const l3d_polygon_view& view,
                const l3d_polygon_frame::way& how)
        : model_(model), view_(view), how_(how) {
        for (std::size_t t = 0; t < model.triangles().size(); ++t)
            add(t);
    }

    std::vector<plain_triangle> whole;
    l3d_polygon_counts counts; ///< of those that are not clipped
    std::int64_t others = 0;

private:
    void add(std::size_t t) {
        const l3d_model_triangle& triangle = model_.triangles()[t];
        const bool from_behind =
            !(view_.faces_eye(l3d_converted<double>(model_.face_normals()[triangle.face]),
                              model_.mesh().vertices[triangle.corners[0]]) > 0);
        if (from_behind && how_.cull) {
            ++counts.back;
            return;
        }
        plain_triangle made;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto v = vertex(t, k, from_behind);
            if (!v) {
                ++others;
                return;
            }
            made.v[k] = *v;
        }
        const auto [left, right] = std::minmax({made.v[0].x, made.v[1].x, made.v[2].x});
        const auto [top, bottom] = std::minmax({made.v[0].y, made.v[1].y, made.v[2].y});
        const double at = how_.antialias ? 0 : 0.5; // of the place in a pixel that counts
        const auto first = [&](int of) {
            return how_.antialias ? std::floor(of / 256.0) : std::ceil(of / 256.0 - at);
        };
        const auto end = [&](int of) {
            return how_.antialias ? std::floor(of / 256.0) + 1 : std::ceil(of / 256.0 - at);
        };
        if (end(right) <= 0 || end(bottom) <= 0 || first(left) >= size.width ||
            first(top) >= size.height) {
            ++counts.offscreen;
        } else if (first(left) >= end(right) || first(top) >= end(bottom)) {
            ++counts.subpixel;
        } else {
            ++counts.drawn;
            whole.push_back(made);
        }
    }

    std::optional<l3d_micro_vertex> vertex(std::size_t t, std::size_t k, bool from_behind) const {
        const l3d_model_triangle& triangle = model_.triangles()[t];
        const auto& at = model_.mesh().vertices[triangle.corners[k]];
        const l3d_matrix<double>& m = view_.matrix();
        const auto row = [&](int i) {
            return m(i, 3) + m(i, 0) * at[0] + m(i, 1) * at[1] + m(i, 2) * at[2];
        };
        const double w = row(3), reach = l3d_guard_band * w;
        const bool parallel = view_.is_parallel();
        if (!(w > (parallel ? 0.5 : view_.camera().near_z)) ||
            !(w < (parallel ? 2.0 : view_.camera().far_z)) || std::abs(row(0)) > reach ||
            std::abs(row(1)) > reach)
            return std::nullopt;
        const l3d_snapped snapped = l3d_snap(row(0), row(1), w);
        l3d_micro_vertex v{snapped.x + size.width * 128, snapped.y + size.height * 128,
                           snapped.inv_w};
        if (parallel) {
            const auto centre = model_.centre();
            const double middle =
                m(2, 3) + m(2, 0) * centre[0] + m(2, 1) * centre[1] + m(2, 2) * centre[2];
            const double step = -0.5 / (model_.radius() * (1 + 1e-9));
            v.inv_w = static_cast<float>(1.5 - step * middle + step * row(2));
        }
        const auto& n =
            how_.smooth ? model_.corner_normal(t, k) : model_.face_normals()[triangle.face];
        for (int i = 0; i < 3; ++i) {
            const l3d_matrix<double>& p = view_.placement();
            v.normal[i] = static_cast<float>(p(i, 0) * n[0] + p(i, 1) * n[1] + p(i, 2) * n[2]);
            if (from_behind)
                v.normal[i] = -v.normal[i];
        }
        return v;
    }

    const l3d_polygon_model& model_;
    const l3d_polygon_view& view_;
    l3d_polygon_frame::way how_;
};

std::vector<plain_triangle> triangles_of(const l3d_polygon_frame& frame) {
    std::vector<plain_triangle> all;
    for (const l3d_surface_part* part : frame.parts())
        for (std::size_t i = 0; i < part->triangles.count; ++i)
            all.push_back({{part->triangles.vertex(i, 0), part->triangles.vertex(i, 1),
                            part->triangles.vertex(i, 2)}});
    return all;
}

/// The same by the list that painters get.
std::vector<plain_triangle> listed_of(const l3d_polygon_frame& frame, l3d_workers& workers) {
    std::vector<l3d_painter_triangle> list;
    frame.list(list, workers);
    std::vector<plain_triangle> all;
    all.reserve(list.size());
    for (const l3d_painter_triangle& triangle : list)
        all.push_back({triangle.v});
    return all;
}

/// Whether all of `some` are among `all`, in this order.
bool in_order(const std::vector<plain_triangle>& some, const std::vector<plain_triangle>& all) {
    std::size_t found = 0;
    for (const plain_triangle& each : all)
        found += found < some.size() && each == some[found];
    return found == some.size();
}

l3d_camera camera(random_numbers& random) {
    l3d_camera result;
    result.eye = {random.between(-1, 1), random.between(-6, -4), random.between(-1, 1)};
    result.target = {0.05, 0.02, -0.1};
    result.up = {0, 0, 1};
    return result;
}

/// A frame against the plain one, by every set of instructions.
void check_frame(const l3d_polygon_model& model, const l3d_polygon_view& view,
                 const l3d_polygon_frame::way& how, const plain_frame& expected,
                 l3d_workers& workers) {
    for (const std::string& target : l3d_simd_targets()) {
        ASSERT_TRUE(l3d_set_simd_target(target));
        l3d_polygon_frame frame;
        frame.make(model, view, how, workers);
        const auto found = triangles_of(frame);
        EXPECT_TRUE(in_order(expected.whole, found)) << target;
        EXPECT_EQ(listed_of(frame, workers), found) << target;
        l3d_polygon_frame of_list;
        of_list.make(model, view, {how.cull, how.smooth, how.antialias, how.antialias}, workers);
        EXPECT_EQ(of_list.parts().empty(), !how.antialias);
        EXPECT_EQ(listed_of(of_list, workers), found) << target;
        const l3d_polygon_counts& counts = frame.counts();
        EXPECT_EQ(counts.back, expected.counts.back);
        EXPECT_EQ(counts.subpixel, expected.counts.subpixel);
        EXPECT_EQ(counts.drawn + counts.offscreen,
                  expected.counts.drawn + expected.counts.offscreen + expected.others);
        if (expected.others == 0) {
            EXPECT_EQ(found.size(), expected.whole.size()) << target;
        }
    }
    l3d_set_simd_target("");
}

/// Every way to make a frame of some models. Of those with a `reach` of 7, some triangles are
/// clipped.
void check_frames(double reach, double crease_angle) {
    l3d_workers workers(2);
    std::int64_t drawn = 0, subpixel = 0, offscreen = 0, others = 0;
    for (unsigned seed = 0; seed < 12; ++seed) {
        random_numbers random(seed + 1);
        // Chosen such that vectors end before, at and after the last vertex and triangle.
        const l3d_polygon_model model(random_mesh(random, 60 + seed, 300 + 41 * seed, reach, 0.05),
                                      false, crease_angle);
        if (crease_angle < 180) {
            ASSERT_TRUE(model.has_creases());
        }
        for (unsigned bits = 0; bits < 16; ++bits) {
            const l3d_polygon_frame::way how{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
            const auto projection =
                bits & 8 ? l3d_projection::parallel : l3d_projection::perspective;
            l3d_camera seen_by = camera(random);
            seen_by.projection = projection;
            const l3d_polygon_view view(seen_by, size,
                                        l3d_euler_rotation({17.0, 40.0 * seed, 5.0}, {0, 0, 0}));
            const plain_frame expected(model, view, how);
            SCOPED_TRACE(std::to_string(seed) + ", way " + std::to_string(bits));
            check_frame(model, view, how, expected, workers);
            drawn += expected.counts.drawn;
            subpixel += expected.counts.subpixel;
            offscreen += expected.counts.offscreen;
            others += expected.others;
        }
    }
    EXPECT_GT(drawn, 10000);
    EXPECT_GT(subpixel, 100);
    EXPECT_GT(offscreen, 1000);
    EXPECT_EQ(others > 0, reach > 6);
}

TEST(polygon_frame, places_triangles_like_the_plain_twin) {
    check_frames(2.5, 180);
}

/// Around a torus, neighbours face alike: most triangles are left out many at a time. Some eyes are
/// inside of it or beside a face.
TEST(polygon_frame, finds_the_sides_of_faces_that_face_alike_like_the_plain_twin) {
    l3d_workers workers(2);
    std::int64_t back = 0;
    for (unsigned seed = 0; seed < 8; ++seed) {
        random_numbers random(seed + 1);
        const l3d_polygon_model model(l3d_torus_mesh(30 + static_cast<int>(seed), 40));
        for (unsigned bits = 0; bits < 16; ++bits) {
            const l3d_polygon_frame::way how{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
            const auto projection =
                bits & 8 ? l3d_projection::parallel : l3d_projection::perspective;
            l3d_camera seen_by = camera(random);
            if (seed % 4 == 0)
                seen_by.eye = {random.between(-2.5, 2.5), random.between(-2.5, -0.1),
                               random.between(-0.5, 0.5)};
            seen_by.projection = projection;
            const l3d_polygon_view view(seen_by, size,
                                        l3d_euler_rotation({17.0, 40.0 * seed, 5.0}, {0, 0, 0}));
            const plain_frame expected(model, view, how);
            SCOPED_TRACE(std::to_string(seed) + ", way " + std::to_string(bits));
            check_frame(model, view, how, expected, workers);
            back += expected.counts.back;
        }
    }
    EXPECT_GT(back, 50000);
}

TEST(polygon_frame, places_corners_on_creases_like_the_plain_twin) {
    check_frames(2.5, 1);
}

TEST(polygon_frame, keeps_the_order_around_triangles_that_are_clipped) {
    check_frames(7, 180);
}

} // namespace
