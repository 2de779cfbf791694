// SPDX-License-Identifier: MIT
// Draws a jet of polygons that flies through a cloud of cells.
#include "report_alternatives.h"
#include "report_rows.h"
#include "report_table.h"

#include "compare/cells/cloud.h"
#include "processor_time.h"
#include "raster/parallel/workers.h"
#include "raster/surface_part.h"
#include "scene/camera_shading.h"
#include <l3d/image.h>
#include <l3d/rasterizer_factory.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

using vector = l3d_camera::vector;
using triangle = std::array<vector, 3>;

void add_quad(std::vector<triangle>& to, const vector& a, const vector& b, const vector& c,
              const vector& d) {
    to.push_back({a, b, c});
    to.push_back({a, c, d});
}

/// Adds both sides of a thin plate: a wing, or a fin.
void add_plate(std::vector<triangle>& to, const vector& a, const vector& b, const vector& c,
               const vector& d) {
    add_quad(to, a, b, c, d);
    add_quad(to, d, c, b, a);
}

/// A jet: a body of revolution along x, two wings, a tail.
std::vector<triangle> jet() {
    constexpr int around = 14;
    constexpr std::array<std::array<double, 2>, 7> sections{
        {{1.05, 0}, {0.85, 0.06}, {0.55, 0.11}, {0.1, 0.13}, {-0.5, 0.12}, {-0.8, 0.1}, {-0.8, 0}}};
    std::vector<triangle> result;
    const auto at = [&](std::size_t section, int i) {
        const double a = 2 * std::numbers::pi * i / around;
        const auto [x, r] = sections[section];
        return vector(x, r * std::cos(a), r * std::sin(a));
    };
    for (std::size_t s = 0; s + 1 < sections.size(); ++s)
        for (int i = 0; i < around; ++i)
            add_quad(result, at(s, i), at(s, i + 1), at(s + 1, i + 1), at(s + 1, i));
    for (const double side : {-1.0, 1.0}) {
        add_plate(result, {0.35, 0.0, 0.1 * side}, {-0.35, 0.0, 0.1 * side},
                  {-0.5, 0.03, 0.8 * side}, {-0.3, 0.03, 0.8 * side});
        add_plate(result, {-0.55, 0.02, 0.08 * side}, {-0.8, 0.02, 0.08 * side},
                  {-0.92, 0.04, 0.36 * side}, {-0.8, 0.04, 0.36 * side});
    }
    add_plate(result, {-0.5, 0.1, 0.0}, {-0.8, 0.1, 0.0}, {-0.95, 0.42, 0.0}, {-0.82, 0.42, 0.0});
    return result;
}

/// The natural logarithm of the factor by which a cube of the largest density weakens light.
constexpr double thickness = 22;

/// The smoke in a cell. It is densest round the jet's tail, and has lumps and holes.
l3d_cloud::matter smoke_at(const l3d_cloud::place& cell, int side) {
    const double x = 2 * cell[0] / side - 1, y = 2 * cell[1] / side - 1, z = 2 * cell[2] / side - 1;
    const double lumps = 0.5 + 0.25 * std::sin(7 * x + 3 * std::sin(4 * z + 1)) +
                         0.25 * std::sin(6 * z - 5 * y + 2 * std::sin(5 * x));
    const double within = 1 - (2.2 * (x + 0.3) * (x + 0.3) + 3.2 * y * y + 1.6 * z * z);
    const double dense = std::clamp(within, 0.0, 1.0) * std::clamp(2 * lumps - 0.4, 0.0, 1.0);
    return {static_cast<float>(dense * thickness / side), static_cast<float>(0.62 + 0.3 * y)};
}

/// Projects places into a camera's picture, as the inverse of the camera's rays.
class eye {
public:
    eye(const l3d_camera& camera, const l3d_shading& view)
        : from_(camera.eye), corner_(vector_of(view.ray)), right_(vector_of(view.ray_right)),
          down_(vector_of(view.ray_down)) {
        const vector ahead = camera.target - camera.eye;
        axis_ = ahead / l3d_length(ahead);
    }

    l3d_micro_vertex vertex(const vector& at, const vector& normal) const {
        const vector there = at - from_;
        const double w = l3d_dot(there, axis_);
        const vector in_plane = there * (l3d_dot(corner_, axis_) / w) - corner_;
        const auto place = [&](const vector& along) {
            return static_cast<std::int32_t>(
                std::lround(l3d_subpixel_one * l3d_dot(in_plane, along) / l3d_dot(along, along)));
        };
        return {place(right_),
                place(down_),
                static_cast<float>(1 / w),
                {static_cast<float>(normal[0]), static_cast<float>(normal[1]),
                 static_cast<float>(normal[2])}};
    }

private:
    static vector vector_of(const std::array<float, 3>& v) {
        return vector(double(v[0]), double(v[1]), double(v[2]));
    }

    vector from_, corner_, right_, down_, axis_{0.0, 0.0, -1.0};
};

l3d_surface_part part_of(const std::vector<triangle>& triangles, const eye& seen_by) {
    l3d_surface_part part;
    for (const triangle& t : triangles) {
        const vector across = l3d_cross<double>(vector(t[1] - t[0]), vector(t[2] - t[0]));
        const double size = l3d_length(across);
        if (!(size > 0))
            continue; // triangles at the body's tips are lines
        const vector normal = across / size;
        part.triangles.add(seen_by.vertex(t[0], normal), seen_by.vertex(t[1], normal),
                           seen_by.vertex(t[2], normal));
    }
    return part;
}

} // namespace

void write_smoke(const std::string& folder, bool quick) {
    const l3d_size size = quick ? l3d_size{160, 120} : l3d_size{640, 480};
    const int side = quick ? 32 : 128;
    const l3d_camera camera{{1.5, 0.9, 2.4}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 38, 0.1, 100};
    const l3d_shading view = l3d_camera_shading(camera, size, l3d_shade::lambert, l3d_usual_light);
    const l3d_cloud cloud(side, [side](const l3d_cloud::place& at) { return smoke_at(at, side); });
    const std::vector<triangle> triangles = jet();

    l3d_image image(size);
    const l3d_pixels picture = image.pixels();
    l3d_depth_buffer depth;
    depth.resize(size);
    l3d_workers one(1);
    const auto surface = l3d_rasterizer_factory_sw().create_surface(one);
    const double start = processor_seconds();
    const l3d_surface_part part = part_of(triangles, eye(camera, view));
    const l3d_surface_part* const parts[] = {&part};
    surface->begin(picture, &depth, view);
    surface->draw(parts);
    surface->finish();
    const double drawn = processor_seconds();
    const std::int64_t met = l3d_lay_over(picture, depth, camera, cloud, {{-1.0, -1.0, -1.0}, 2});
    const double done = processor_seconds();
    l3d_write_image(folder + "/smoke.png", picture);
    const double pixels = double(size.width) * size.height;
    write_text(folder + "/smoke.csv",
               "polygons,cells_a_side,cells_a_pixel,polygons_ms,cloud_ms,ns_a_cell\n" +
                   table_row(triangles.size(), side, static_cast<double>(met) / pixels,
                             1e3 * (drawn - start), 1e3 * (done - drawn),
                             1e9 * (done - drawn) / static_cast<double>(met)));
}
