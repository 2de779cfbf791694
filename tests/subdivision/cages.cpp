// SPDX-License-Identifier: MIT
// Cages for tests: exact shapes, and a head.
#include "subdivision/cages.h"

#include "tool_2d/text_file.h"

#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <stdexcept>

namespace subdivision_tests {

namespace {

using indices = std::initializer_list<std::uint32_t>;

void add(l3d_model_file& model, indices face) {
    model.mesh.add_face({face.begin(), face.size()});
}

/// A place on a circle around the y axis.
l3d_polygon_mesh::vector around(int step, int steps, double radius, double y) {
    const double angle = 2 * std::numbers::pi * step / steps;
    return {radius * std::cos(angle), y, -radius * std::sin(angle)};
}

l3d_model_file tetrahedron() {
    l3d_model_file model;
    model.mesh.vertices = {
        {1.0, 1.0, 1.0}, {-1.0, -1.0, 1.0}, {-1.0, 1.0, -1.0}, {1.0, -1.0, -1.0}};
    for (const indices& face : {indices{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})
        add(model, face);
    return model;
}

l3d_model_file prism(std::uint32_t corners) {
    l3d_model_file model;
    std::vector<std::uint32_t> top, bottom;
    for (std::uint32_t i = 0; i < corners; ++i) {
        model.mesh.vertices.push_back(
            around(static_cast<int>(i), static_cast<int>(corners), 1, -0.7));
        model.mesh.vertices.push_back(
            around(static_cast<int>(i), static_cast<int>(corners), 1, 0.7));
        top.push_back(2 * i + 1);
        bottom.insert(bottom.begin(), 2 * i);
    }
    model.mesh.add_face(top);
    model.mesh.add_face(bottom);
    for (std::uint32_t i = 0; i < corners; ++i) {
        const std::uint32_t next = (i + 1) % corners;
        add(model, {2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
    }
    return model;
}

l3d_model_file creased_cube() {
    l3d_model_file model = cube();
    model.tags.creases = {{4, 5, 10.0F}, {5, 6, 10.0F}, {6, 7, 10.0F}, {7, 4, 10.0F}, {0, 1, 2.5F}};
    model.tags.corners = {{2, 3.2F}, {5, 10.0F}};
    return model;
}

l3d_model_file open_box(bool keeps_corners) {
    l3d_model_file model = cube();
    model.mesh.face_ends.pop_back(); // the last face
    model.mesh.corners.resize(model.mesh.face_ends.back());
    model.tags.keeps_corners = keeps_corners;
    return model;
}

} // namespace

l3d_model_file cube() {
    l3d_model_file model;
    for (const double z : {-1.0, 1.0})
        for (const std::array<double, 2>& p :
             {std::array{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
            model.mesh.vertices.push_back({p[0], p[1], z});
    for (const indices& face : {indices{3, 2, 1, 0},
                                {4, 5, 6, 7},
                                {0, 1, 5, 4},
                                {1, 2, 6, 5},
                                {2, 3, 7, 6},
                                {3, 0, 4, 7}})
        add(model, face);
    return model;
}

l3d_model_file wheels(int spokes) {
    l3d_model_file model;
    model.mesh.vertices = {{0.0, 1.0, 0.0}, {0.0, -1.0, 0.0}};
    for (int i = 0; i < 2 * spokes; ++i)
        model.mesh.vertices.push_back(around(i, 2 * spokes, 1, i % 2 == 0 ? 0.25 : 0.2));
    const auto rim = static_cast<std::uint32_t>(2 * spokes);
    for (std::uint32_t i = 0; i < rim; i += 2) {
        const std::uint32_t a = 2 + i, b = 3 + i, c = 2 + (i + 2) % rim;
        add(model, {0, a, b, c});
        add(model, {1, c, b, a});
    }
    return model;
}

l3d_model_file torus_of_quads() {
    constexpr std::uint32_t around_axis = 12, around_ring = 8;
    l3d_model_file model;
    for (std::uint32_t i = 0; i < around_axis; ++i)
        for (std::uint32_t k = 0; k < around_ring; ++k) {
            const double angle = 2 * std::numbers::pi * k / around_ring;
            model.mesh.vertices.push_back(around(static_cast<int>(i), around_axis,
                                                 1 + 0.4 * std::cos(angle), 0.4 * std::sin(angle)));
        }
    for (std::uint32_t i = 0; i < around_axis; ++i)
        for (std::uint32_t k = 0; k < around_ring; ++k) {
            const std::uint32_t next = (i + 1) % around_axis * around_ring, here = i * around_ring;
            const std::uint32_t up = (k + 1) % around_ring;
            add(model, {here + k, next + k, next + up, here + up});
        }
    return model;
}

l3d_model_file head() {
    std::string why;
    auto model = l3d_read_model(l3d_read_text_file("data/head.obj"), "head.obj", why);
    if (!model)
        throw std::runtime_error(why);
    return *std::move(model);
}

std::vector<named_cage> all_cages() {
    std::vector<named_cage> result{{"cube", cube()},
                                   {"creased cube", creased_cube()},
                                   {"tetrahedron", tetrahedron()},
                                   {"prism of 5", prism(5)},
                                   {"torus", torus_of_quads()},
                                   {"box with corners", open_box(true), false},
                                   {"smooth box", open_box(false), false},
                                   {"head", head(), false}};
    for (const int spokes : {3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
        result.push_back({"wheels of " + std::to_string(spokes), wheels(spokes)});
    return result;
}

} // namespace subdivision_tests
