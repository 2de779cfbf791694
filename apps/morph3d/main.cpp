// SPDX-License-Identifier: MIT
// morph3d: turns a ball into a cube, a star and a palm tree, which share one list of vertices.
#include "lit_faces.h"

#include <l3d/pipeline_world.h>
#include <l3d/polygon_shapes.h>
#include <l3d/program.h>
#include <l3d/pipeline.h>
#include <l3d/polygon_2d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace {

using vector = l3d_polygon_mesh::vector;

/// Maps a place on a unit sphere about the z axis to a place on the form.
struct form {
    vector (*place)(const vector&);
    std::uint32_t low, high; ///< colours of the trunk, and of all above it
};

/// The cosine of four times the angle about the axis; 1 on the axis.
double cosine_of_four(const vector& v) {
    const double square = v[0] * v[0] + v[1] * v[1];
    if (square == 0)
        return 1;
    const double cosine_of_two = (v[0] * v[0] - v[1] * v[1]) / square;
    return 2 * cosine_of_two * cosine_of_two - 1;
}

constexpr double trunk_end = 0.1; // on the sphere's axis, from -1 to 1

vector ball(const vector& v) {
    return v * 10.0;
}

/// A cube. The rows of the sphere's upper quarter make the top, those of the half in the middle the
/// sides. So edges lie on rows and columns.
vector cube(const vector& v) {
    constexpr double half = 7;
    const double row = std::acos(std::clamp(v[2], -1.0, 1.0)) / std::numbers::pi;
    const double reach = half * std::min({4 * row, 4 * (1 - row), 1.0});
    const double across = std::max({std::abs(v[0]), std::abs(v[1]), 1e-9});
    return {v[0] / across * reach, v[1] / across * reach,
            half * std::clamp(2 - 4 * row, -1.0, 1.0)};
}

vector star(const vector& v) {
    return v * (8 + 5 * cosine_of_four(v) * (1 - v[2] * v[2]));
}

/// A palm: a trunk, and four leaves that hang down. Rows run along the leaves' lower sides, and
/// back on the upper ones.
vector palm(const vector& v) {
    const double across = std::sqrt(v[0] * v[0] + v[1] * v[1]);
    const auto at = [&](double radius, double height) {
        const double scale = across == 0 ? 0 : radius / across;
        return vector(v[0] * scale, v[1] * scale, height);
    };
    constexpr double trunk = 1.0, top = 8;
    if (v[2] <= trunk_end)
        return at(v[2] < -0.99 ? 0 : trunk, -12 + (v[2] + 1) / (trunk_end + 1) * (top + 11));
    const double way = (v[2] - trunk_end) / (1 - trunk_end);
    const double leaf = 0.5 + 0.5 * cosine_of_four(v), reach = 2 + 10 * leaf * leaf;
    const bool is_below = way < 0.5;
    const double radius = is_below ? trunk + (reach - trunk) * 2 * way : reach * 2 * (1 - way);
    const double thickness = (1 - radius / reach) * (is_below ? -0.7 : 1);
    return at(radius, top + thickness - 0.06 * radius * radius);
}

constexpr std::array<form, 4> forms{{{ball, 0xe0952f, 0xe0952f},
                                     {cube, 0x4f7fc8, 0x4f7fc8},
                                     {star, 0xc8557b, 0xc8557b},
                                     {palm, 0x9a6a3a, 0x4fa84f}}};

/// A form that turns while it changes from form to form, each time within a second.
class morphing final : public l3d_object {
public:
    /// `is_painted` tells that the colours of its faces already contain the light.
    explicit morphing(bool is_painted)
        : is_painted_(is_painted), first_(l3d_sphere_mesh(48, 32)), now_(first_) {
        begin();
    }

private:
    static constexpr int rest = 30, way = 60; ///< steps of a rest, and of a change of form

    using list = l3d_vertex_list<double>;

    list vertices_of(const form& to) const {
        std::vector<l3d_coordinate<double>> places;
        for (const vector& v : first_.vertices) {
            const vector place = to.place(v);
            places.emplace_back(l3d_point<double>::of(place[0], place[1], place[2]));
        }
        return list(places);
    }

    const form& last() const { return forms[which_]; }
    const form& next() const { return forms[(which_ + 1) % forms.size()]; }

    void begin() {
        morph_.start(vertices_of(last()), vertices_of(next()), way);
        step_ = -rest;
        show();
    }

    void do_update(double seconds) override {
        degrees_ += 30 * seconds;
        for (int due = ticker_.due(seconds); due > 0; --due) {
            if (step_ >= 0)
                morph_.step();
            if (++step_ == way) {
                which_ = (which_ + 1) % forms.size();
                begin();
            }
        }
        show();
    }

    /// Shows the present form. The sphere's axis is the world's y axis.
    void show() {
        const l3d_matrix<double> turned =
            l3d_rotation_y<double>(degrees_) * l3d_rotation_x<double>(-90);
        for (std::size_t i = 0; i < now_.vertices.size(); ++i)
            now_.vertices[i] = morph_.list()[i].original.from_origin;
        now_.face_colors.clear();
        const double done = std::max(step_, 0) / static_cast<double>(way);
        for (std::size_t face = 0; face < now_.faces(); ++face) {
            const bool is_low = first_.vertices[now_.face(face)[0]][2] < trunk_end;
            const std::uint32_t from = is_low ? last().low : last().high;
            const std::uint32_t to = is_low ? next().low : next().high;
            const double light = is_painted_ ? light_on(now_, face, turned) : 1;
            now_.face_colors.push_back(mixed(0, mixed(from, to, done), light));
        }
        set_mesh(now_);
        set_transform(0, l3d_rotation_x<l3d_real>(-90));
        set_transform(1, l3d_rotation_y<l3d_real>(degrees_));
    }

    bool is_painted_;
    const l3d_polygon_mesh first_; ///< the unit sphere that all forms are made of
    l3d_polygon_mesh now_;
    l3d_vertex_interpolator<double> morph_;
    l3d_ticker ticker_;
    std::size_t which_ = 0; ///< the form from which the present change began
    int step_ = 0;          ///< step of the change; below 0 at rest
    double degrees_ = 0;
};

// Step 2 of 5: the world that l3d_pipeline_world shows.
class morph3d_world final : public l3d_world {
public:
    morph3d_world(l3d_size size, bool is_painted) : l3d_world(size) {
        order = l3d_draw_order::far_first;
        camera.place = l3d_point<l3d_real>::of(0, 0, -20);
        add(std::make_unique<morphing>(is_painted));
    }
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program(
        "morph3d",
        l3d_caption{.what = "A ball becomes a cube, a star and a palm tree.",
                    .teaches = "Forms with the same number of vertices pass into each other: each "
                               "vertex goes its way in equal steps.",
                    .keys = l3d_world_keys()},
        {960, 720});
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        l3d_pipeline_world pipeline(program.create_canvas(), [&](l3d_size size) {
            return std::make_unique<morph3d_world>(size, program.is_classic());
        });
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
