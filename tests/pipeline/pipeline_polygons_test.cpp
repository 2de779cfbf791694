// SPDX-License-Identifier: MIT
// Whole frames of polygons: zsort against zbuffer against Mesa, in every style and projection.
#include "hard_edged.h"
#include "pipeline/polygons/pipeline_zbuffer.h"
#include "pipeline/zsort/pipeline_zsort.h"

#include "base/error.h"
#include "geom/files/model_file.h"
#include "geom/polygon_shapes.h"
#include "raster/rasterizer_factory.h"
#include "tool_2d/screen_memory.h"
#include "pipeline/polygons/polygon_wires.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr l3d_size window{331, 247};
using picture = std::vector<std::uint32_t>;

const l3d_rasterizer_factory_sw sw;

l3d_canvas canvas() {
    return l3d_memory_canvas(window);
}

/// A factory that tells whether it is still there.
class mortal_factory final : public l3d_rasterizer_factory {
public:
    explicit mortal_factory(bool& is_there) : is_there_(is_there) { is_there_ = true; }
    ~mortal_factory() override { is_there_ = false; }
    mortal_factory(const mortal_factory&) = delete;
    mortal_factory& operator=(const mortal_factory&) = delete;

private:
    std::unique_ptr<l3d_rasterizer_2d_imp> do_create_2d(l3d_pixels target) const override {
        return sw.create_2d(target);
    }
    std::unique_ptr<l3d_surface_rasterizer> do_create_surface(l3d_workers& workers) const override {
        EXPECT_TRUE(is_there_);
        return sw.create_surface(workers);
    }

    bool& is_there_;
};

l3d_camera camera(double x = 1.3, double y = -5.1, double z = 3.2) {
    l3d_camera result;
    result.eye = {x, y, z};
    result.target = {0.1, 0.05, -0.1};
    result.up = {0, 0, 1};
    return result;
}

picture drawn(l3d_pipeline_polygons& pipeline) {
    pipeline.draw_event();
    picture result;
    const l3d_pixels pixels = pipeline.screen().pixels();
    for (int y = 0; y < pixels.height; ++y)
        result.insert(result.end(), pixels.row(y).begin(), pixels.row(y).end());
    return result;
}

picture by_zsort(const l3d_polygon_model& model, const l3d_camera& from,
                 const l3d_polygon_settings& settings, l3d_polygon_report* report = nullptr) {
    l3d_pipeline_zsort pipeline(canvas(), model, from, settings);
    picture result = drawn(pipeline);
    if (report)
        *report = pipeline.report();
    return result;
}

picture by_zbuffer(const l3d_polygon_model& model, const l3d_camera& from,
                   const l3d_polygon_settings& settings) {
    l3d_pipeline_zbuffer pipeline(canvas(), model, from, settings, sw);
    return drawn(pipeline);
}

long differing(const picture& a, const picture& b, int levels) {
    long count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        count += std::abs(static_cast<int>(a[i] & 255) - static_cast<int>(b[i] & 255)) > levels;
    return count;
}

long lit(const picture& p) {
    return std::ranges::count_if(p, [](std::uint32_t word) { return word != 0; });
}

/// Two tori, one through the other.
l3d_polygon_mesh linked_tori() {
    l3d_polygon_mesh mesh = l3d_torus_mesh(31, 14, 1.5, 0.6);
    const l3d_polygon_mesh other = l3d_torus_mesh(27, 12, 1.2, 0.5);
    const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const auto& v : other.vertices)
        mesh.vertices.push_back({v[0] + 0.7, v[2] - 0.2, -v[1] + 0.1});
    for (std::size_t f = 0; f < other.faces(); ++f) {
        const auto face = other.face(f);
        mesh.add_face({{face[0] + offset, face[1] + offset, face[2] + offset}});
    }
    return mesh;
}

TEST(pipeline_polygons, keep_a_model_that_the_program_forgets) {
    l3d_polygon_settings settings = hard_edged_polygons();
    const l3d_polygon_model model(linked_tori());
    l3d_pipeline_zsort zsort(canvas(), l3d_polygon_model(linked_tori()), camera(), settings);
    l3d_pipeline_zbuffer zbuffer(canvas(), l3d_polygon_model(linked_tori()), camera(), settings,
                                 sw);
    EXPECT_EQ(drawn(zsort), by_zsort(model, camera(), settings));
    EXPECT_EQ(drawn(zbuffer), by_zbuffer(model, camera(), settings));
}

/// A tube of 24 sides as .obj text: what stands before its faces, and whether its corners have the
/// normals of the faces, those of the round tube, or none.
l3d_polygon_model tube(const std::string& before, char normals) {
    std::string text;
    constexpr int sides = 24;
    const auto vector = [&text](const char* word, double steps, double z) {
        const double angle = 2 * std::numbers::pi * steps / sides;
        text += word + std::to_string(std::cos(angle)) + ' ' + std::to_string(std::sin(angle)) +
                ' ' + std::to_string(z) + '\n';
    };
    for (int i = 0; i < sides; ++i) {
        vector("v ", i, -1);
        vector("v ", i, 1);
        vector("vn ", i, 0);       // of the round tube, 2 i + 1
        vector("vn ", i + 0.5, 0); // of a side, 2 i + 2
    }
    text += before;
    for (int i = 0; i < sides; ++i) {
        const int next = (i + 1) % sides;
        text += 'f';
        for (const auto& [vertex, at] : {std::pair(2 * i + 1, i), std::pair(2 * next + 1, next),
                                         std::pair(2 * next + 2, next), std::pair(2 * i + 2, i)})
            text += ' ' + std::to_string(vertex) +
                    (normals == 'r'   ? "//" + std::to_string(2 * at + 1)
                     : normals == 'f' ? "//" + std::to_string(2 * i + 2)
                                      : "");
        text += '\n';
    }
    std::string why;
    const auto file = l3d_read_model(text, "tube", why);
    EXPECT_TRUE(file) << why;
    return l3d_polygon_model(file->mesh);
}

TEST(pipeline_polygons, show_normals_of_corners_and_smoothing_groups) {
    l3d_polygon_settings smooth, flat;
    smooth.shade = l3d_shade::lambert;
    flat.shade = l3d_shade::flat;
    for (const bool sorts : {false, true}) {
        const auto shown = [&](const l3d_polygon_model& model, const l3d_polygon_settings& how) {
            return sorts ? by_zsort(model, camera(), how) : by_zbuffer(model, camera(), how);
        };
        const picture faceted = shown(tube("", '-'), flat), round = shown(tube("", '-'), smooth);
        ASSERT_GT(differing(faceted, round, 4), 1000);
        for (const auto& model : {tube("", 'f'), tube("s off\n", '-'), tube("s 1\n", 'f')}) {
            EXPECT_EQ(differing(shown(model, smooth), faceted, 1), 0) << sorts;
            EXPECT_EQ(differing(shown(model, flat), faceted, 1), 0) << sorts;
        }
        for (const auto& model : {tube("", 'r'), tube("s 1\n", '-'), tube("s off\n", 'r')}) {
            EXPECT_LT(differing(shown(model, smooth), round, 1), 20) << sorts;
            EXPECT_EQ(differing(shown(model, flat), faceted, 1), 0) << sorts;
        }
    }
}

TEST(pipeline_polygons, are_steered_without_a_subclass) {
    l3d_polygon_settings settings = hard_edged_polygons();
    const l3d_polygon_model model(linked_tori());
    l3d_pipeline_zsort pipeline(canvas(), model, camera(), settings);
    drawn(pipeline);
    EXPECT_FALSE(pipeline.needs_redraw());
    settings.style = pipeline.settings().style = l3d_polygon_style::wireframe;
    pipeline.camera() = camera(2, -4, 1);
    pipeline.redraw();
    EXPECT_TRUE(pipeline.needs_redraw());
    EXPECT_EQ(drawn(pipeline), by_zsort(model, camera(2, -4, 1), settings));
}

TEST(pipeline_polygons, zsort_and_zbuffer_show_the_same) {
    const l3d_polygon_model model(linked_tori());
    for (const bool cull : {true, false})
        for (const auto projection : {l3d_projection::perspective, l3d_projection::parallel})
            for (const auto shade :
                 {l3d_shade::flat, l3d_shade::gouraud, l3d_shade::lambert, l3d_shade::normals}) {
                l3d_polygon_settings settings = hard_edged_polygons();
                settings.shade = shade;
                l3d_camera from = camera();
                from.projection = projection;
                settings.cull = cull;
                settings.rotation = {17, -23, 40};
                l3d_polygon_report report;
                const picture a = by_zsort(model, from, settings, &report);
                const picture b = by_zbuffer(model, from, settings);
                // By lanes, lambert's grey may be a level off.
                EXPECT_EQ(differing(a, b, shade == l3d_shade::lambert), 0)
                    << "cull " << cull << " shade " << static_cast<int>(shade);
                EXPECT_GT(lit(a), 10000);
                EXPECT_GT(report.order.cuts, 10);
            }
}

/// Edges are where bodies go through each other, too. Without the second step of zsort, some
/// thousand pixels would be stairs.
TEST(pipeline_polygons, zsort_and_zbuffer_smooth_the_same_edges) {
    const l3d_polygon_model model(linked_tori());
    for (const bool cull : {true, false})
        for (const auto projection : {l3d_projection::perspective, l3d_projection::parallel})
            for (const auto shade :
                 {l3d_shade::flat, l3d_shade::gouraud, l3d_shade::lambert, l3d_shade::normals}) {
                l3d_polygon_settings settings = hard_edged_polygons();
                settings.shade = shade;
                l3d_camera from = camera();
                from.projection = projection;
                settings.cull = cull;
                settings.rotation = {17, -23, 40};
                settings.background = l3d_background::gradient();
                const picture stairs = by_zsort(model, from, settings);
                settings.antialias = true;
                l3d_polygon_report report;
                const picture a = by_zsort(model, from, settings, &report);
                const picture b = by_zbuffer(model, from, settings);
                // A level by which lambert is off may decide whether two pixels jump.
                EXPECT_EQ(differing(a, b, shade == l3d_shade::lambert ? 2 : 0), 0)
                    << "cull " << cull << " shade " << static_cast<int>(shade);
                EXPECT_GT(differing(a, stairs, 1), 1000);
                EXPECT_GT(report.surface.refined, 1000);
            }
}

/// Inside a torus, with faces behind the eye, near it, and far outside of the window.
TEST(pipeline_polygons, clipped_at_the_near_plane_both_show_the_same) {
    const l3d_polygon_model model(l3d_torus_mesh(40, 20, 2, 0.8));
    l3d_camera inside = camera(2.1, 0.1, 0.3);
    inside.target = {1.7, 1.4, -0.2};
    inside.near_z = 0.05;
    l3d_polygon_settings settings = hard_edged_polygons();
    settings.cull = false;
    const picture a = by_zsort(model, inside, settings);
    EXPECT_EQ(differing(a, by_zbuffer(model, inside, settings), 0), 0);
    EXPECT_EQ(lit(a), window.width * window.height); // no hole in the wall around the eye
}

TEST(pipeline_polygons, mesa_agrees) {
    const l3d_polygon_model model(linked_tori());
    l3d_polygon_settings settings = hard_edged_polygons();
    const l3d_rasterizer_factory_mesa gl;
    l3d_pipeline_zbuffer pipeline(canvas(), model, camera(), settings, gl, "mesa");
    const picture a = by_zsort(model, camera(), settings), b = drawn(pipeline);
    EXPECT_LE(differing(a, b, 1) * 1000, lit(a)); // it rounds where depths nearly tie
}

/// A closed body shows the same with and without the faces that are seen from behind, so they are
/// left out unasked. No side of it may be missing or turned round, and no plane may cut it open.
TEST(pipeline_polygons, closed_bodies_are_shown_without_their_backs) {
    const l3d_polygon_mesh torus = l3d_torus_mesh(24, 16, 1.7, 0.7);
    for (const auto projection : {l3d_projection::perspective, l3d_projection::parallel}) {
        l3d_polygon_settings settings = hard_edged_polygons();
        l3d_camera from = camera();
        from.projection = projection;
        settings.rotation = {-31, 12, 5};
        l3d_polygon_report report, open_report;
        const picture closed = by_zsort(l3d_polygon_model(torus), from, settings, &report);
        EXPECT_GT(report.polygons.back, 200);
        EXPECT_EQ(report.polygons.drawn + report.polygons.back + report.polygons.subpixel +
                      report.polygons.offscreen,
                  768);
        settings.cull = true;
        EXPECT_EQ(closed, by_zsort(l3d_polygon_model(torus), from, settings));
        settings.cull = false;

        l3d_polygon_mesh with_dot = torus; // a triangle far below a pixel opens the model
        const auto first = static_cast<std::uint32_t>(with_dot.vertices.size());
        for (const double x : {0.0, 1e-9, 2e-9})
            with_dot.vertices.push_back({1.7 + x, x * x * 1e9, 0.0});
        with_dot.corners.insert(with_dot.corners.end(), {first, first + 1, first + 2});
        with_dot.face_ends.push_back(static_cast<std::uint32_t>(with_dot.corners.size()));
        const picture all = by_zsort(l3d_polygon_model(with_dot), from, settings, &open_report);
        EXPECT_EQ(open_report.polygons.back, 0);
        // On an outline, where a face from behind and one from in front share an edge, depths tie.
        EXPECT_LE(differing(closed, all, 0), 20);
    }
}

std::int64_t backs_left_out(const l3d_polygon_mesh& mesh, const l3d_camera& from,
                            const l3d_polygon_settings& settings = hard_edged_polygons()) {
    l3d_pipeline_zbuffer pipeline(canvas(), l3d_polygon_model(mesh), from, settings, sw);
    pipeline.draw_event();
    return pipeline.report().polygons.back;
}

/// The corners of each face run the other way.
l3d_polygon_mesh turned_inside_out(l3d_polygon_mesh mesh) {
    for (std::size_t begin = 0; const std::uint32_t end : mesh.face_ends) {
        std::reverse(mesh.corners.begin() + static_cast<std::ptrdiff_t>(begin),
                     mesh.corners.begin() + static_cast<std::ptrdiff_t>(end));
        begin = end;
    }
    return mesh;
}

TEST(pipeline_polygons, backs_that_may_be_seen_are_drawn) {
    const l3d_polygon_mesh sphere = l3d_sphere_mesh(24, 12);
    EXPECT_GT(backs_left_out(sphere, camera()), 0);
    EXPECT_EQ(backs_left_out(turned_inside_out(sphere), camera()), 0);

    l3d_polygon_mesh apart = sphere; // each face has vertices of its own, as in many files
    apart.vertices.clear();
    for (std::uint32_t& corner : apart.corners) {
        apart.vertices.push_back(sphere.vertices[corner]);
        corner = static_cast<std::uint32_t>(apart.vertices.size() - 1);
    }
    EXPECT_EQ(backs_left_out(apart, camera()), backs_left_out(sphere, camera()));

    l3d_polygon_mesh one_face_turned = sphere;
    std::swap(one_face_turned.corners[0], one_face_turned.corners[1]);
    EXPECT_EQ(backs_left_out(one_face_turned, camera()), 0);

    l3d_polygon_mesh two = sphere; // the second one is inside out, and as large
    const l3d_polygon_mesh other = turned_inside_out(sphere);
    const auto count = static_cast<std::uint32_t>(sphere.vertices.size());
    for (const auto& place : other.vertices)
        two.vertices.push_back(place * 0.5 + l3d_polygon_model::vector(3.0, 0.0, 0.0));
    for (const std::uint32_t corner : other.corners)
        two.corners.push_back(corner + count);
    for (const std::uint32_t end : other.face_ends)
        two.face_ends.push_back(end + static_cast<std::uint32_t>(sphere.corners.size()));
    EXPECT_EQ(backs_left_out(two, camera()), 0);

    l3d_camera within = camera(0.1, 0.2, 0.3);
    EXPECT_EQ(backs_left_out(sphere, within), 0);
    within = camera(0, -3, 0);
    within.near_z = 2.5; // it cuts the sphere open
    EXPECT_EQ(backs_left_out(sphere, within), 0);
    within.projection = l3d_projection::parallel; // without a near plane
    EXPECT_GT(backs_left_out(sphere, within), 0);
}

/// Whatever way the corners of faces run, and whatever side a file's normals are on.
TEST(pipeline_polygons, the_side_that_is_seen_is_lit) {
    const l3d_polygon_mesh sheet =
        l3d_grid_mesh(4, [](double x, double y) { return 0.3 * x * x - 0.2 * x * y * y; });
    l3d_polygon_settings settings = hard_edged_polygons();
    settings.shade = l3d_shade::lambert;
    settings.light = {0.3, -0.4, 1};
    const auto seen = [&](l3d_polygon_mesh mesh, double normal) {
        if (normal != 0)
            mesh.vertex_normals.assign(mesh.vertices.size(), {0.1 * normal, 0.0, normal});
        return by_zbuffer(l3d_polygon_model(mesh), camera(), settings);
    };
    for (const double normal : {0.0, 1.0}) {
        const picture lit_sheet = seen(sheet, normal);
        EXPECT_GT(lit(lit_sheet), 5000);
        for (const std::uint32_t word : lit_sheet)
            EXPECT_TRUE(word == 0 || (word & 255) > 120) << (word & 255);
        EXPECT_EQ(differing(lit_sheet, seen(turned_inside_out(sheet), normal), 1), 0) << normal;
        EXPECT_EQ(differing(lit_sheet, seen(sheet, -normal), 1), 0) << normal;
        EXPECT_EQ(differing(lit_sheet, seen(turned_inside_out(sheet), -normal), 1), 0) << normal;
    }
}

void expect_hidden_lines_among_all(bool smooth) {
    const l3d_polygon_model model(l3d_torus_mesh(12, 8, 1.7, 0.7));
    l3d_polygon_settings settings = hard_edged_polygons();
    settings.antialias = smooth;
    settings.style = l3d_polygon_style::wireframe;
    settings.cull = false;
    const picture wires = by_zsort(model, camera(), settings);
    settings.style = l3d_polygon_style::hidden_lines;
    settings.cull = true;
    const picture sorted = by_zsort(model, camera(), settings);
    const picture tested = by_zbuffer(model, camera(), settings);
    EXPECT_LT(lit(sorted) * 10, lit(wires) * 8);
    EXPECT_GT(lit(sorted) * 10, lit(wires) * 3);
    long beside_wires = 0;
    for (std::size_t i = 0; i < wires.size(); ++i)
        beside_wires += std::max(sorted[i] & 255, tested[i] & 255) > (wires[i] & 255);
    EXPECT_EQ(beside_wires, 0); // the same pixels, fewer of them
    // Near an outline a line may end a pixel earlier in one of the two.
    EXPECT_LE(differing(sorted, tested, 0) * 12, lit(sorted));
    const auto grey = [](std::uint32_t word) { return word != 0 && (word & 255) != 255; };
    EXPECT_EQ(std::ranges::any_of(sorted, grey), smooth);
    EXPECT_EQ(std::ranges::any_of(tested, grey), smooth);
}

TEST(pipeline_polygons, hidden_lines_are_some_of_all_lines) {
    expect_hidden_lines_among_all(false);
}

TEST(pipeline_polygons, smooth_hidden_lines_are_some_of_all_lines) {
    expect_hidden_lines_among_all(true);
}

TEST(pipeline_polygons, a_side_of_two_faces_is_one_wire) {
    const l3d_polygon_model model(l3d_torus_mesh(12, 8, 1.7, 0.7));
    const l3d_polygon_view view(camera(), window, l3d_identity<double>());
    std::size_t sides = 0;
    for (const l3d_model_triangle& triangle : model.triangles())
        sides += static_cast<std::size_t>(std::popcount(triangle.sides));
    l3d_polygon_wires wires;
    EXPECT_EQ(wires.make(model, view, false).size() * 2, sides);
    using ends = std::array<std::int32_t, 4>;
    std::set<ends> different;
    const auto seen = wires.make(model, view, true);
    for (const l3d_detail::wire& w : seen)
        different.insert(std::min(ends{w.x0, w.y0, w.x1, w.y1}, ends{w.x1, w.y1, w.x0, w.y0}));
    EXPECT_EQ(different.size(), seen.size());
    EXPECT_GT(seen.size(), sides / 5);
    EXPECT_LT(seen.size(), sides / 2);
}

/// Lines that reach behind the eye end at the near plane, and nothing wraps round.
TEST(pipeline_polygons, wires_are_clipped) {
    const l3d_polygon_model model(l3d_torus_mesh(40, 20, 2, 0.8));
    l3d_camera inside = camera(2.1, 0.1, 0.3);
    inside.target = {1.7, 1.4, -0.2};
    const l3d_polygon_view view(inside, window, l3d_identity<double>());
    l3d_polygon_wires wires;
    const auto lines = wires.make(model, view, false);
    EXPECT_GT(lines.size(), 500u);
    EXPECT_LT(lines.size(), 2400u); // 1600 triangles of three sides, each of two
    for (const l3d_detail::wire& of : lines) {
        const l3d_line_2d line = of.sharp();
        for (const int number : {line.x0, line.y0, line.x1, line.y1})
            EXPECT_LE(std::abs(number), 16384 + 331);
    }
    // A face that is wholly in front is where the matrix puts it.
    const auto& v = model.mesh().vertices;
    std::size_t exact = 0;
    for (const l3d_model_triangle& t : model.triangles())
        for (std::size_t k = 0; k < 3; ++k) {
            const auto place = [&](std::uint32_t i) {
                return view.matrix() * l3d_vector<double, 4>(v[i][0], v[i][1], v[i][2], 1.0);
            };
            const auto a = place(t.corners[k]), b = place(t.corners[(k + 1) % 3]);
            if (a[3] > 0.2 && b[3] > 0.2) {
                const auto beside = [](int pixel, double offset, int side) {
                    return std::abs(pixel + 0.5 - offset - side / 2.0) <= 0.5 + 1.0 / 256;
                };
                const auto leads = [&](const l3d_line_2d& l, const auto& from, const auto& to) {
                    return beside(l.x0, from[0] / from[3], 331) &&
                           beside(l.y0, from[1] / from[3], 247) &&
                           beside(l.x1, to[0] / to[3], 331) && beside(l.y1, to[1] / to[3], 247);
                };
                const bool found = std::ranges::any_of(lines, [&](const l3d_detail::wire& of) {
                    return leads(of.sharp(), a, b) || leads(of.sharp(), b, a);
                });
                exact += found;
                EXPECT_TRUE(found);
            }
        }
    EXPECT_GT(exact, 500u);
}

TEST(pipeline_polygons, euler_angles_turn_about_the_centre) {
    const l3d_vector<double, 3> centre{3.0, -2.0, 7.0};
    const auto turn = l3d_euler_rotation({90, 0, 90}, centre);
    const auto kept = turn * l3d_vector<double, 4>(3.0, -2.0, 7.0, 1.0);
    EXPECT_EQ(kept, (l3d_vector<double, 4>(3.0, -2.0, 7.0, 1.0)));
    // First about x: y becomes z. Then about z: z stays.
    const auto y = turn * l3d_vector<double, 4>(3.0, -1.0, 7.0, 1.0);
    EXPECT_EQ(y, (l3d_vector<double, 4>(3.0, -2.0, 8.0, 1.0)));
    // x is left by the first, and becomes y by the second.
    const auto x = turn * l3d_vector<double, 4>(4.0, -2.0, 7.0, 1.0);
    EXPECT_EQ(x, (l3d_vector<double, 4>(3.0, -1.0, 7.0, 1.0)));
}

/// Half turns that do not commute: each order leads elsewhere, and each turn is about an axis of
/// the world.
TEST(pipeline_polygons, euler_angles_turn_in_the_order_that_is_asked_for) {
    const l3d_vector<double, 3> centre{1.0, 1.0, 1.0}, degrees{90.0, 180.0, 90.0};
    const auto quarter = [&](std::array<double, 3> p, std::size_t about) {
        std::array<double, 3> q = p;
        q[(about + 1) % 3] = -p[(about + 2) % 3];
        q[(about + 2) % 3] = p[(about + 1) % 3];
        return q;
    };
    for (const auto& [order, axes] :
         {std::pair(l3d_rotation_order::xyz, std::array<std::size_t, 3>{0, 1, 2}),
          std::pair(l3d_rotation_order::xzy, std::array<std::size_t, 3>{0, 2, 1}),
          std::pair(l3d_rotation_order::yxz, std::array<std::size_t, 3>{1, 0, 2}),
          std::pair(l3d_rotation_order::yzx, std::array<std::size_t, 3>{1, 2, 0}),
          std::pair(l3d_rotation_order::zxy, std::array<std::size_t, 3>{2, 0, 1}),
          std::pair(l3d_rotation_order::zyx, std::array<std::size_t, 3>{2, 1, 0})}) {
        std::array<double, 3> p{3, 5, 11};
        for (const std::size_t axis : axes)
            for (int turn = 0; turn < degrees[static_cast<int>(axis)] / 90; ++turn)
                p = quarter(p, axis);
        const auto moved =
            l3d_euler_rotation(degrees, centre, order) * l3d_vector<double, 4>(4.0, 6.0, 12.0, 1.0);
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(moved[k], p[static_cast<std::size_t>(k)] + 1, 1e-12)
                << axes[0] << axes[1] << axes[2];
    }
}

TEST(pipeline_polygons, threads_do_not_change_the_picture) {
    const l3d_polygon_model model(l3d_torus_mesh(90, 60, 1.7, 0.7));
    l3d_polygon_settings settings = hard_edged_polygons();
    settings.shade = l3d_shade::lambert;
    const picture one = by_zbuffer(model, camera(), settings);
    const picture one_sorted = by_zsort(model, camera(), settings);
    settings.threads = 3;
    EXPECT_EQ(by_zbuffer(model, camera(), settings), one);
    EXPECT_EQ(by_zsort(model, camera(), settings), one_sorted);
}

TEST(pipeline_zbuffer, uses_a_factory_that_nobody_else_owns_while_it_is_there) {
    bool is_there = false;
    l3d_canvas one = canvas();
    one.rasterizers = std::make_shared<mortal_factory>(is_there);
    l3d_pipeline_zbuffer pipeline(std::move(one), l3d_polygon_model(l3d_torus_mesh(9, 6, 1.7, 0.7)),
                                  camera(), {});
    EXPECT_EQ(drawn(pipeline).size(), static_cast<std::size_t>(window.width * window.height));
}

TEST(pipeline_polygons, refuses_a_camera_and_a_shade_that_it_cannot_draw) {
    l3d_pipeline_zbuffer program(canvas(), l3d_polygon_model(l3d_box_mesh(1, 1, 1)), camera(), {});
    program.camera().fov = 200;
    EXPECT_THROW(program.draw_event(), l3d_error);
    program.camera() = camera();
    program.settings().shade = l3d_shade::zebra;
    EXPECT_THROW(program.draw_event(), l3d_error);
    program.settings().shade = l3d_shade::lambert;
    EXPECT_NO_THROW(program.draw_event());
}

} // namespace
