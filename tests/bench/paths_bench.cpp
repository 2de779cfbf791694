// SPDX-License-Identifier: MIT
// Smooth paths beside cairo's image surface and AGG, 1024 x 768, one thread.
//
// Every library builds its path and fills it in each turn, with a nonzero rule and one opaque
// colour. Curves are within 1/1024 pixel in all three: cairo's tolerance and AGG's scales are set
// so. A row shows the median processor time of a turn and how many times as long the others take.
// `off` is the mean difference of their levels from ours, in pixels that any of them lit.
#include "bench/paths_peers.h"
#include "raster/paths/gradient.h"
#include "raster/paths/path.h"

#include <agg2/agg_conv_curve.h>
#include <agg2/agg_conv_dash.h>
#include <agg2/agg_conv_stroke.h>
#include <agg2/agg_ellipse.h>
#include <agg2/agg_path_storage.h>
#include <cairo/cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using namespace path_bench;
using outlines = std::vector<std::vector<l3d_point_2d>>;

/// Many polygons, each one path or all of them together. Cairo and AGG have pixel 0 from 0 to 1.
void polygons_row(const std::string& name, const outlines& all, bool one_path) {
    const auto ours = [&](peers& p) {
        p.path.clear();
        for (const auto& o : all) {
            p.path.add_polygon(o);
            if (!one_path) {
                p.draw.draw_path(p.path, {.color = color});
                p.path.clear();
            }
        }
        if (one_path)
            p.draw.draw_path(p.path, {.color = color});
    };
    const auto cairo = [&](peers& p) {
        for (const auto& o : all) {
            for (const l3d_point_2d& c : o)
                cairo_line_to(p.cairo, c.x + 0.5, c.y + 0.5);
            cairo_close_path(p.cairo);
            if (one_path)
                cairo_new_sub_path(p.cairo);
            else
                cairo_fill(p.cairo);
        }
        if (one_path)
            cairo_fill(p.cairo);
    };
    const auto agg = [&](peers& p) {
        p.agg_path.remove_all();
        for (const auto& o : all) {
            p.agg_path.move_to(o[0].x + 0.5, o[0].y + 0.5);
            for (std::size_t i = 1; i < o.size(); ++i)
                p.agg_path.line_to(o[i].x + 0.5, o[i].y + 0.5);
            p.agg_path.close_polygon();
            if (!one_path) {
                p.agg_fill(p.agg_path);
                p.agg_path.remove_all();
            }
        }
        if (one_path)
            p.agg_fill(p.agg_path);
    };
    row(name, ours, cairo, agg);
}

double uniform(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

void triangles_row(double side) {
    std::mt19937 random(1);
    outlines all(20);
    const double radius = side / std::numbers::sqrt3;
    for (auto& t : all) {
        const double x = uniform(random, radius, size.width - radius);
        const double y = uniform(random, radius, size.height - radius);
        const double angle = uniform(random, 0, 6.28);
        for (int k = 0; k < 3; ++k)
            t.push_back({x + radius * std::cos(angle + k * 2 * std::numbers::pi / 3),
                         y + radius * std::sin(angle + k * 2 * std::numbers::pi / 3)});
    }
    polygons_row("20 triangles of " + std::to_string(int(side)) + " px", all, false);
}

/// Wavy countries of 100 segments each, a few pixels long.
void map_row() {
    std::mt19937 random(2);
    outlines all(1000);
    for (auto& o : all) {
        const double x = uniform(random, 30, size.width - 30);
        const double y = uniform(random, 30, size.height - 30);
        for (int i = 0; i < 100; ++i) {
            const double angle = i * std::numbers::pi / 50, r = uniform(random, 14, 22);
            o.push_back({x + r * std::cos(angle), y + r * std::sin(angle)});
        }
    }
    polygons_row("a map of 10^5 segments", all, true);
}

void circles_row(double radius) {
    std::mt19937 random(3);
    std::vector<l3d_point_2d> centers(20);
    for (l3d_point_2d& c : centers)
        c = {uniform(random, radius, size.width - radius),
             uniform(random, radius, size.height - radius)};
    row(
        "20 circles of radius " + std::to_string(int(radius)),
        [&](peers& p) {
            for (const l3d_point_2d& c : centers) {
                p.path.clear();
                p.path.add_circle(c, radius);
                p.draw.draw_path(p.path, {.color = color});
            }
        },
        [&](peers& p) {
            for (const l3d_point_2d& c : centers) {
                cairo_arc(p.cairo, c.x + 0.5, c.y + 0.5, radius, 0, 2 * std::numbers::pi);
                cairo_fill(p.cairo);
            }
        },
        [&](peers& p) {
            for (const l3d_point_2d& c : centers) {
                agg::ellipse e(c.x + 0.5, c.y + 0.5, radius, radius);
                e.approximation_scale(agg_scale);
                p.agg_fill(e);
            }
        });
}

/// Curves under a round pen, whole or in dashes.
void curves_row(double width, bool dashed) {
    std::mt19937 random(4);
    std::vector<std::array<l3d_point_2d, 4>> curves(20);
    for (auto& c : curves)
        for (l3d_point_2d& p : c)
            p = {uniform(random, 20, size.width - 20), uniform(random, 20, size.height - 20)};
    l3d_stroke pen{.width = width, .cap = l3d_cap::round, .join = l3d_join::round};
    if (dashed)
        pen.dashes = {20, 2 * width};
    row(
        std::string(dashed ? "20 dashed curves, " : "20 curves, ") + std::to_string(int(width)) +
            " px wide",
        [&](peers& p) {
            for (const auto& c : curves) {
                p.path.clear();
                p.path.move_to(c[0]);
                p.path.cubic_to(c[1], c[2], c[3]);
                p.draw.draw_path(l3d_stroked(p.path, pen), {.color = color});
            }
        },
        [&](peers& p) {
            cairo_set_line_width(p.cairo, width);
            cairo_set_line_cap(p.cairo, CAIRO_LINE_CAP_ROUND);
            cairo_set_line_join(p.cairo, CAIRO_LINE_JOIN_ROUND);
            cairo_set_dash(p.cairo, pen.dashes.data(), int(pen.dashes.size()), 0);
            for (const auto& c : curves) {
                cairo_move_to(p.cairo, c[0].x + 0.5, c[0].y + 0.5);
                cairo_curve_to(p.cairo, c[1].x + 0.5, c[1].y + 0.5, c[2].x + 0.5, c[2].y + 0.5,
                               c[3].x + 0.5, c[3].y + 0.5);
                cairo_stroke(p.cairo);
            }
        },
        [&](peers& p) {
            for (const auto& c : curves) {
                p.agg_path.remove_all();
                p.agg_path.move_to(c[0].x + 0.5, c[0].y + 0.5);
                p.agg_path.curve4(c[1].x + 0.5, c[1].y + 0.5, c[2].x + 0.5, c[2].y + 0.5,
                                  c[3].x + 0.5, c[3].y + 0.5);
                agg::conv_curve<agg::path_storage> curve(p.agg_path);
                curve.approximation_scale(agg_scale);
                const auto fill = [&](auto& chords) {
                    agg::conv_stroke<std::remove_reference_t<decltype(chords)>> stroke(chords);
                    stroke.approximation_scale(agg_scale);
                    stroke.width(width);
                    stroke.line_cap(agg::round_cap);
                    stroke.line_join(agg::round_join);
                    p.agg_fill(stroke);
                };
                if (dashed) {
                    agg::conv_dash<decltype(curve)> dash(curve);
                    dash.add_dash(20, 2 * width);
                    fill(dash);
                } else {
                    fill(curve);
                }
            }
        });
}

/// A line through many values: ten waves, or a walk of random steps, which covers most places many
/// times.
void plot_row(bool is_walk) {
    constexpr int count = 10000;
    const l3d_stroke pen{.width = 3};
    std::mt19937 random(6);
    std::vector<l3d_point_2d> values;
    double y = size.height / 2.0;
    for (int i = 0; i < count; ++i) {
        if (is_walk)
            y += uniform(random, -3, 3);
        else
            y = size.height / 2.0 + 300 * std::sin(20 * std::numbers::pi * i / count);
        values.push_back({12 + 1000.0 * i / count, y});
    }
    row(
        is_walk ? "a random walk of 10^4 values" : "ten waves of 10^4 values",
        [&](peers& p) {
            p.path.clear();
            p.path.move_to(values[0]);
            for (const l3d_point_2d& v : values)
                p.path.line_to(v);
            p.draw.draw_path(l3d_stroked(p.path, pen), {.color = color});
        },
        [&](peers& p) {
            cairo_set_line_width(p.cairo, pen.width);
            cairo_set_miter_limit(p.cairo, pen.miter_limit);
            for (const l3d_point_2d& v : values)
                cairo_line_to(p.cairo, v.x + 0.5, v.y + 0.5);
            cairo_stroke(p.cairo);
        },
        [&](peers& p) {
            p.agg_path.remove_all();
            p.agg_path.move_to(values[0].x + 0.5, values[0].y + 0.5);
            for (const l3d_point_2d& v : values)
                p.agg_path.line_to(v.x + 0.5, v.y + 0.5);
            agg::conv_stroke<agg::path_storage> stroke(p.agg_path);
            stroke.width(pen.width);
            stroke.miter_limit(pen.miter_limit);
            p.agg_fill(stroke);
        });
}

/// Chords of a circle, one path: each leads from a place to that of twice its angle.
void string_art_row() {
    constexpr int count = 4000;
    const l3d_stroke pen{.width = 1};
    const auto place = [](int i) {
        const double angle = 2 * std::numbers::pi * i / count;
        return l3d_point_2d{size.width / 2.0 + 380 * std::cos(angle),
                            size.height / 2.0 + 380 * std::sin(angle)};
    };
    row(
        "string art of 4000 chords",
        [&](peers& p) {
            p.path.clear();
            for (int i = 0; i < count; ++i) {
                p.path.move_to(place(i));
                p.path.line_to(place(2 * i));
            }
            p.draw.draw_path(l3d_stroked(p.path, pen), {.color = color});
        },
        [&](peers& p) {
            cairo_set_line_width(p.cairo, pen.width);
            for (int i = 0; i < count; ++i) {
                cairo_move_to(p.cairo, place(i).x + 0.5, place(i).y + 0.5);
                cairo_line_to(p.cairo, place(2 * i).x + 0.5, place(2 * i).y + 0.5);
            }
            cairo_stroke(p.cairo);
        },
        [&](peers& p) {
            p.agg_path.remove_all();
            for (int i = 0; i < count; ++i) {
                p.agg_path.move_to(place(i).x + 0.5, place(i).y + 0.5);
                p.agg_path.line_to(place(2 * i).x + 0.5, place(2 * i).y + 0.5);
            }
            agg::conv_stroke<agg::path_storage> stroke(p.agg_path);
            stroke.width(pen.width);
            p.agg_fill(stroke);
        });
}

/// A mesh of across x across patches, its net shaken.
void mesh_row(int across) {
    std::mt19937 random(5);
    const auto side = 3 * std::size_t(across) + 1;
    std::vector<l3d_point_2d> net(side * side);
    for (std::size_t r = 0; r < side; ++r)
        for (std::size_t k = 0; k < side; ++k) {
            const double step = 700.0 / double(side - 1), wild = step / 4;
            net[r * side + k] = {150 + step * double(k) + uniform(random, -wild, wild),
                                 30 + step * double(r) + uniform(random, -wild, wild)};
        }
    std::vector<l3d_mesh_patch> patches;
    for (std::size_t r = 0; r + 1 < side; r += 3)
        for (std::size_t k = 0; k + 1 < side; k += 3) {
            l3d_mesh_patch patch;
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j < 4; ++j)
                    patch.points[i][j] = net[(r + i) * side + k + j];
            for (std::uint32_t& c : patch.colors)
                c = static_cast<std::uint32_t>(random()) & 0x00ffffff;
            patches.push_back(patch);
        }
    row(
        "a mesh of " + std::to_string(across * across) + " patches",
        [&](peers& p) { p.draw.draw_mesh(patches); },
        [&](peers& p) {
            cairo_pattern_t* mesh = cairo_pattern_create_mesh();
            for (const l3d_mesh_patch& patch : patches) {
                const auto& q = patch.points;
                // along v = 0, then to (1, 1) and around; cairo's corners in the same order
                constexpr std::array<std::array<std::size_t, 2>, 12> around{{{0, 0},
                                                                             {0, 1},
                                                                             {0, 2},
                                                                             {0, 3},
                                                                             {1, 3},
                                                                             {2, 3},
                                                                             {3, 3},
                                                                             {3, 2},
                                                                             {3, 1},
                                                                             {3, 0},
                                                                             {2, 0},
                                                                             {1, 0}}};
                const auto at = [&](std::size_t i) {
                    return l3d_point_2d{q[around[i % 12][0]][around[i % 12][1]].x + 0.5,
                                        q[around[i % 12][0]][around[i % 12][1]].y + 0.5};
                };
                cairo_mesh_pattern_begin_patch(mesh);
                cairo_mesh_pattern_move_to(mesh, at(0).x, at(0).y);
                for (std::size_t i = 1; i < 12; i += 3)
                    cairo_mesh_pattern_curve_to(mesh, at(i).x, at(i).y, at(i + 1).x, at(i + 1).y,
                                                at(i + 2).x, at(i + 2).y);
                constexpr std::array<std::array<unsigned, 3>, 4> inner{
                    {{0, 1, 1}, {1, 1, 2}, {2, 2, 2}, {3, 2, 1}}};
                for (const auto& [n, r, k] : inner)
                    cairo_mesh_pattern_set_control_point(mesh, n, q[r][k].x + 0.5, q[r][k].y + 0.5);
                constexpr std::array<unsigned, 4> corners{0, 1, 3, 2};
                for (unsigned n = 0; n < 4; ++n) {
                    const std::uint32_t c = patch.colors[corners[n]];
                    cairo_mesh_pattern_set_corner_color_rgb(mesh, n, (c >> 16 & 255) / 255.0,
                                                            (c >> 8 & 255) / 255.0,
                                                            (c & 255) / 255.0);
                }
                cairo_mesh_pattern_end_patch(mesh);
            }
            cairo_save(p.cairo);
            cairo_set_source(p.cairo, mesh);
            cairo_paint(p.cairo);
            cairo_restore(p.cairo);
            cairo_pattern_destroy(mesh);
        },
        nullptr);
}

} // namespace

int main() {
    for (const double side : {16, 64, 128, 512})
        triangles_row(side);
    for (const double radius : {8, 64, 256})
        circles_row(radius);
    map_row();
    for (const bool dashed : {false, true})
        for (const double width : {3, 12})
            curves_row(width, dashed);
    plot_row(false);
    plot_row(true);
    string_art_row();
    mesh_row(1);
    mesh_row(6);
}
