// SPDX-License-Identifier: MIT
// l3d_polygon_model: faces as triangles, normals, the centroid; and tessellated patches.
#include "pipeline/polygons/polygon_model.h"

#include "geom/files/model_file.h"
#include "geom/polygon_shapes.h"
#include "geom/teapot.h"
#include "base/error.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace {

using vector = l3d_polygon_model::vector;

/// One face in a slanted plane through (3, -2, 5), from places in that plane.
l3d_polygon_mesh face_of(const std::vector<std::pair<double, double>>& places) {
    l3d_polygon_mesh mesh;
    std::vector<std::uint32_t> face;
    for (const auto& [u, v] : places) {
        face.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
        mesh.vertices.push_back({3 + u, -2 + 0.3 * u + v, 5 + 0.2 * u - 0.4 * v});
    }
    mesh.add_face(face);
    return mesh;
}

/// Twice the area of a triangle, positive if it faces as its face does.
double area2(const l3d_polygon_model& model, const l3d_model_triangle& t) {
    const auto& p = model.mesh().vertices;
    const vector a = p[t.corners[0]], b = p[t.corners[1]], c = p[t.corners[2]];
    return l3d_dot(l3d_cross(b - a, c - a), l3d_converted<double>(model.face_normals()[t.face]));
}

/// Triangles cover the face once: none is turned round, areas add up, each side once.
void expect_covered(const l3d_polygon_mesh& mesh) {
    const l3d_polygon_model model(mesh);
    const auto face = mesh.face(0);
    ASSERT_EQ(model.triangles().size(), face.size() - 2);
    vector whole{0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < face.size(); ++i)
        whole += l3d_cross(mesh.vertices[face[i]] - mesh.vertices[face[0]],
                           mesh.vertices[face[(i + 1) % face.size()]] - mesh.vertices[face[0]]);
    double sum = 0;
    std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
    for (const l3d_model_triangle& t : model.triangles()) {
        EXPECT_GE(area2(model, t), -1e-9);
        sum += area2(model, t);
        for (std::size_t k = 0; k < 3; ++k)
            if (t.sides >> k & 1) {
                EXPECT_TRUE(sides.insert({t.corners[k], t.corners[(k + 1) % 3]}).second);
            }
    }
    EXPECT_NEAR(sum, l3d_length(whole), 1e-6);
    EXPECT_EQ(sides.size(), face.size());
    for (std::size_t i = 0; i < face.size(); ++i)
        EXPECT_TRUE(sides.contains({face[i], face[(i + 1) % face.size()]}));
}

TEST(polygon_model, faces_of_any_form_become_triangles) {
    expect_covered(face_of({{0, 0}, {4, 1}, {5, 4}, {1, 3}}));                 // convex
    expect_covered(face_of({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}));         // a notch
    expect_covered(face_of({{0, 4}, {2, 1}, {4, 4}, {4, 0}, {0, 0}}));         // turned round
    expect_covered(face_of({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 2}, {0, 2}})); // on one line
    std::vector<std::pair<double, double>> star;
    for (int i = 0; i < 22; ++i) {
        const double r = i % 2 ? 1.1 : 5, a = 6.283185307179586 * i / 22;
        star.emplace_back(r * std::cos(a), r * std::sin(a));
    }
    expect_covered(face_of(star));
}

/// A pentagram goes round twice without ever turning right: a fan would do as well as anything, but
/// no corner may be lost.
TEST(polygon_model, a_face_that_crosses_itself_still_becomes_triangles) {
    std::vector<std::pair<double, double>> places;
    for (int i = 0; i < 5; ++i)
        places.emplace_back(std::cos(2.5132741228718345 * i), std::sin(2.5132741228718345 * i));
    EXPECT_EQ(l3d_polygon_model(face_of(places)).triangles().size(), 3u);
}

TEST(polygon_model, normals_point_outwards_and_the_centroid_may_be_the_origin) {
    l3d_polygon_mesh sphere = l3d_sphere_mesh(24, 12, 2);
    for (vector& v : sphere.vertices)
        v += vector{10.0, -20.0, 30.0};
    const l3d_polygon_model model(sphere);
    const vector centre{10.0, -20.0, 30.0};
    for (std::size_t i = 0; i < sphere.vertices.size(); ++i)
        EXPECT_GT(l3d_dot(l3d_normalized(sphere.vertices[i] - centre),
                          l3d_converted<double>(model.vertex_normals()[i])),
                  0.98);
    EXPECT_NEAR(model.radius(), 2, 1e-9);
    EXPECT_NEAR(l3d_length(model.centre() - centre), 0, 1e-9);
    const l3d_polygon_model moved(sphere, true);
    EXPECT_NEAR(l3d_length(moved.centre()), 0, 1e-9);
    const std::size_t blocks = (model.triangles().size() + 31) / 32;
    EXPECT_EQ(model.facing_blocks().size(), blocks);
    EXPECT_EQ(model.bytes(), 28 * sphere.faces() + 48 + 32 * sphere.faces() + 64 * blocks +
                                 12 * sphere.vertices.size());
}

TEST(polygon_model, of_a_file_is_that_of_its_polygons_and_patches) {
    const std::string path = testing::TempDir() + "polygon_model_test";
    const auto refusal_of = [&](std::string_view text) -> std::string {
        std::ofstream(path) << text;
        try {
            l3d_polygon_model::load(path);
        } catch (const l3d_error& error) {
            EXPECT_EQ(error.code(), l3d_exit::bad_input);
            return error.what();
        }
        return "";
    };
    std::ofstream(path) << l3d_teapot_bpt();
    EXPECT_EQ(l3d_polygon_model::load(path).mesh(),
              l3d_tessellated(l3d_patch_model::teapot().with_parts({}), l3d_usual_facets).mesh);
    const l3d_polygon_mesh sphere = l3d_sphere_mesh(9, 5, 2);
    std::ofstream(path) << l3d_write_off(sphere);
    EXPECT_EQ(l3d_polygon_model::load(path).mesh().vertices, sphere.vertices);
    EXPECT_EQ(refusal_of("OFF\n0 0 0\n"), path + ": no polygons and no patches");
    EXPECT_EQ(refusal_of("OFF\n1 0 0\n0 0\n").find(path + ':'), 0u);
    std::filesystem::remove(path);
    EXPECT_THROW(l3d_polygon_model::load(path), l3d_error);
}

/// Concave faces, hidden parts and colours, too.
TEST(polygon_model, is_cut_by_a_plane) {
    l3d_polygon_mesh mesh = face_of({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}});
    const std::uint32_t more = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {{2, 0, 0}, {4, 0, 0}, {4, 1, 0}});
    mesh.add_face(std::array<std::uint32_t, 3>{more, more + 1, more + 2});
    mesh.parts = {{"sheet", 0}, {"chip", 1}};
    mesh.face_colors = {0x00ff0000, 0x0000ff00};
    const l3d_polygon_model whole(mesh);
    const auto plane =
        l3d_plane<double>::through(l3d_point<double>(vector{5, 0, 0}), vector{-1.0, 0.0, 0.0});
    const auto area_of = [](const l3d_polygon_model& model) {
        double area = 0;
        for (const l3d_model_triangle& t : model.triangles())
            area += area2(model, t) / 2;
        return area;
    };
    const l3d_polygon_model kept = whole.cut(plane), rest = whole.cut(plane.flipped());
    EXPECT_NEAR(area_of(kept) + area_of(rest), area_of(whole), 1e-12);
    EXPECT_GT(area_of(rest), 0.1);
    for (const l3d_model_triangle& t : kept.triangles())
        for (const std::uint32_t corner : t.corners)
            EXPECT_LE(kept.mesh().vertices[corner][0], 5 + 1e-12);
    EXPECT_EQ(kept.centre(), whole.centre());
    ASSERT_TRUE(kept.parts().find("chip"));
    const auto last = kept.triangles().back().face;
    EXPECT_EQ(kept.parts().name_of(last), "chip");
    EXPECT_EQ(kept.materials()[kept.material_of(last)].color, 0x0000ff00U);
    const std::size_t sheet = *whole.parts().find("sheet");
    EXPECT_EQ(whole.without(std::span(&sheet, 1)).cut(plane).triangles().size(), 1u);
    EXPECT_TRUE(whole.only(std::span(&sheet, 1)).cut(plane).triangles().size() > 1);
    EXPECT_TRUE(whole.cut({plane.normal, -100}).triangles().empty());
}

TEST(polygon_model, shows_hides_and_paints_named_parts) {
    const l3d_polygon_model all(l3d_tessellated(l3d_patch_model::teapot(), 4).mesh);
    ASSERT_EQ(all.parts().names().size(), 4u);
    const std::array<std::size_t, 2> chosen{*all.parts().find("lid"), *all.parts().find("spout")};
    const l3d_polygon_model painted =
        all.part_painted(*all.parts().find("lid"), {.color = 0xff0000});
    const l3d_polygon_model some = painted.only(chosen), others = painted.without(chosen);
    EXPECT_EQ(some.triangles().size() + others.triangles().size(), all.triangles().size());
    EXPECT_EQ(some.mesh(), all.mesh());
    std::size_t red = 0;
    for (const l3d_model_triangle& t : some.triangles()) {
        const std::string_view part = some.parts().name_of(t.face);
        EXPECT_TRUE(part == "lid" || part == "spout") << part;
        const l3d_material look = some.materials()[some.material_of(t.face)];
        EXPECT_EQ(look.color, part == "lid" ? 0xff0000u : 0xffffffu);
        red += part == "lid";
    }
    EXPECT_EQ(red, all.parts().size_of(chosen[0]));
    for (const l3d_model_triangle& t : others.triangles())
        EXPECT_TRUE(others.parts().name_of(t.face) == "body" ||
                    others.parts().name_of(t.face) == "handle");
}

TEST(polygon_model, with_creases_keeps_those_of_the_parts_that_are_shown) {
    l3d_polygon_mesh mesh = l3d_sphere_mesh(8, 3, 1);
    mesh.parts = {{"north", 0}, {"south", static_cast<std::uint32_t>(mesh.faces() / 2)}};
    const l3d_polygon_model all(mesh);
    ASSERT_TRUE(all.has_creases());
    const std::array<std::size_t, 1> south{1};
    const l3d_polygon_model half = all.only(south);
    std::size_t i = 0;
    for (std::size_t t = 0; t < all.triangles().size(); ++t) {
        if (all.parts().of(all.triangles()[t].face) != 1)
            continue;
        for (std::size_t corner = 0; corner < 3; ++corner)
            EXPECT_EQ(half.corner_normal(i, corner), all.corner_normal(t, corner));
        ++i;
    }
    EXPECT_EQ(i, half.triangles().size());
}

/// The mesh turns over between its first and its second triangle, and its normals turn with it. A
/// file whose normals all point inwards has them turned.
TEST(polygon_model, normals_at_a_fold_are_those_of_the_triangle_s_own_side) {
    l3d_polygon_mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 1}};
    mesh.vertex_normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, -1}, {0, 0, -1}};
    mesh.corners = {0, 1, 2, 2, 1, 3};
    mesh.face_ends = {3, 6};
    const l3d_polygon_model model(mesh);
    ASSERT_EQ(model.triangles().size(), 2u);
    EXPECT_TRUE(model.has_creases());
    for (std::size_t t = 0; t < 2; ++t)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_GT(l3d_dot(model.corner_normal(t, k), model.face_normals()[t]), 0)
                << t << ' ' << k;
    for (auto& normal : mesh.vertex_normals)
        normal = {0, 0, -1};
    mesh.corners.resize(3);
    mesh.face_ends.resize(1);
    const l3d_polygon_model inwards(mesh);
    EXPECT_FALSE(inwards.has_creases());
    EXPECT_EQ(inwards.corner_normal(0, 0)[2], 1);
}

/// Zero says that a normal is to be computed: by angles, as in a mesh that has none.
TEST(polygon_model, normals_that_are_zero_are_those_of_the_faces_around) {
    l3d_polygon_mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 1}, {1, 1, 1}};
    mesh.corners = {0, 1, 2, 3, 1, 4, 5, 2};
    mesh.face_ends = {4, 8};
    const l3d_polygon_model without(mesh);
    mesh.vertex_normals.assign(6, {0, 0, 0});
    const l3d_polygon_model zero(mesh);
    ASSERT_TRUE(zero.has_creases());
    for (std::size_t t = 0; t < zero.triangles().size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(zero.corner_normal(t, k), without.corner_normal(t, k));
    mesh.vertex_normals[1] = {0, 3e-200, 0};
    mesh.vertex_normals[2] = {0, 3e200, 0};
    const l3d_polygon_model some(mesh);
    for (std::size_t t = 0; t < some.triangles().size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = some.triangles()[t].corners[k];
            EXPECT_EQ(some.corner_normal(t, k), vertex == 1 || vertex == 2
                                                    ? l3d_polygon_model::direction(0, 1, 0)
                                                    : without.corner_normal(t, k));
        }
}

TEST(polygon_model, faces_that_cross_themselves_are_two_triangles) {
    l3d_polygon_mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.corners = {0, 1, 2, 3};
    mesh.face_ends = {4};
    const l3d_polygon_model model(mesh);
    ASSERT_EQ(model.triangles().size(), 2u);
    double area = 0;
    for (const l3d_model_triangle& t : model.triangles()) {
        EXPECT_EQ(model.face_normals()[t.face], model.face_normals()[0]);
        area += area2(model, t) / 2;
    }
    EXPECT_NEAR(area, 0.5, 1e-12);
}

TEST(polygon_model, vertices_of_no_face_do_not_count) {
    l3d_polygon_mesh mesh = l3d_torus_mesh(12, 8);
    const l3d_polygon_model alone(mesh);
    mesh.vertices.push_back({1000, 0, 0});
    const l3d_polygon_model model(mesh);
    EXPECT_EQ(model.least(), alone.least());
    EXPECT_EQ(model.most(), alone.most());
    EXPECT_EQ(model.radius(), alone.radius());
}

TEST(polygon_model, tessellated_patches_share_their_boundaries) {
    std::string why;
    const auto teapot = l3d_patch_model::from_bpt(l3d_teapot_bpt(), "teapot.bpt", why);
    ASSERT_TRUE(teapot) << why;
    for (const int n : {1, 3, 8}) {
        const l3d_polygon_mesh mesh = l3d_tessellated(*teapot, n).mesh;
        EXPECT_TRUE(mesh.is_valid());
        // By place: at a crease two vertices share it, each with the normal of one side.
        using place = std::array<double, 3>;
        const auto place_of = [&](std::uint32_t i) {
            return place{mesh.vertices[i][0], mesh.vertices[i][1], mesh.vertices[i][2]};
        };
        std::map<std::pair<place, place>, int> uses;
        std::set<place> places;
        for (std::size_t f = 0; f < mesh.faces(); ++f) {
            const auto face = mesh.face(f);
            for (std::size_t i = 0; i < 3; ++i) {
                const place from = place_of(face[i]), to = place_of(face[(i + 1) % 3]);
                ++uses[std::minmax(from, to)];
                places.insert(from);
            }
        }
        EXPECT_GT(mesh.vertices.size(), places.size()) << "the rims are creases";
        EXPECT_LE(mesh.vertices.size(), places.size() + 32 * static_cast<std::size_t>(n))
            << "all else is smooth";
        // All but the rims of body, lid, spout and handle are between two faces.
        int alone = 0;
        for (const auto& [side, count] : uses)
            alone += count == 1;
        EXPECT_LE(alone, 32 * n) << n;
        EXPECT_GE(mesh.faces(), static_cast<std::size_t>(28 * (2 * n * n - n)));
    }
}

/// At the top of the knob the patches have a fold of 0.002, and normals that point down there: of
/// that size may be what is seen from its wrong side.
TEST(polygon_model, tessellated_patches_have_normals_of_their_own_side) {
    std::string why;
    const auto teapot = l3d_patch_model::from_bpt(l3d_teapot_bpt(), "teapot.bpt", why);
    ASSERT_TRUE(teapot) << why;
    const l3d_polygon_model model(l3d_tessellated(*teapot, 8).mesh);
    double wrong = 0;
    for (const l3d_model_triangle& triangle : model.triangles()) {
        const auto& [a, b, c] = triangle.corners;
        const auto& at = model.mesh().vertices;
        const auto area = l3d_length(l3d_cross(at[b] - at[a], at[c] - at[a])) / 2;
        for (const std::uint32_t corner : triangle.corners)
            if (!(l3d_dot(model.vertex_normals()[corner], model.face_normals()[triangle.face]) >
                  0.3f))
                wrong += area;
    }
    EXPECT_LT(wrong, 0.001);
}

} // namespace
