// SPDX-License-Identifier: MIT
// l3d_method_mesa: gives GL meshes, matrices and shaders.
#include "compare/method_mesa.h"

#include "scene/placed_net.h"
#include "pipeline/stopwatch_p.h"
#include "compare/method_patches.h"
#include "raster/mesa_target_p.h"
#include "base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace l3d_detail;

// Depth is near / w. So all bits of reciprocal depth are good, nearer is more, and everything in
// front of the near plane is clipped. 1.2e-38 is a little more than the smallest float with all its
// bits. With it, the cosine of a zero normal is 0.
const mesa_target::program_text smooth_surfaces{.vertex = R"(#version 120
        attribute vec3 position;
        attribute vec3 normal;
        uniform mat4 to_clip;
        uniform mat3 to_world;
        varying vec3 direction;
        void main() {
            gl_Position = to_clip * vec4(position, 1.0);
            direction = to_world * normal;
        })",
                                                .fragment = R"(#version 120
        uniform int shade;
        uniform vec3 light;
        uniform vec3 ray;
        uniform vec3 ray_right;
        uniform vec3 ray_down;
        varying vec3 direction;
        void main() {
            vec3 unit = direction / sqrt(max(dot(direction, direction), 1.2e-38));
            vec3 to_here = ray + gl_FragCoord.x * ray_right + gl_FragCoord.y * ray_down;
            unit = dot(unit, to_here) > 0.0 ? -unit : unit;
            vec3 shaded = vec3(0.1 + 0.9 * clamp(dot(light, unit), 0.0, 1.0));
            if (shade == 3)
                shaded = 0.5 * (unit + 1.0);
            gl_FragColor = vec4(floor(255.0 * clamp(shaded, 0.0, 1.0) + 0.5) / 255.0, 0.0);
        })",
                                                .attributes = {"position", "normal"}};
static_assert(static_cast<int>(l3d_shade::normals) == 3);

struct vertex {
    float position[3], normal[3];
};

/// The number of quads along a patch is rounded up to a multiple of `coarseness`. The most are 2^17
/// triangles for a patch.
constexpr int coarseness = 4, most_quads = 256;

/// The number of steps along a net with which two triangles a cell keep the tolerance everywhere.
int steps_of(const l3d_image_patch& net, const l3d_dice_view& view) {
    const l3d_image_box seen = l3d_image_box_of(net.points).intersected(view.margin());
    if (seen.empty())
        return 1;
    const l3d_second_bounds b =
        l3d_second_bounds_of(net, seen, l3d_depth_range_of(net.points).least);
    const double n = std::ceil(std::sqrt(b.triangle_error(1, 1) / view.tolerance));
    return n < most_quads ? std::max(1, static_cast<int>(n)) : most_quads;
}

/// Draws triangles that GL holds.
class method_mesa final : public l3d_surface_method {
public:
    explicit method_mesa(std::unique_ptr<mesa_context> context);

private:
    /// A model's triangles.
    struct mesh {
        l3d_patch_model model;
        bool is_used = true;                ///< in this frame
        unsigned vertices = 0, indices = 0; ///< buffers
        int count = 0;                      ///< number of indices
        int n = 0;
    };

    void do_draw(const l3d_method_frame& frame, l3d_stage_times& times) override;
    std::string do_renderer() const override { return target_.describe(); }
    const l3d_dice_counts& do_counts() const override { return counts_; }
    const l3d_surface_counts& do_surface_counts() const override { return surface_counts_; }

    const mesh& mesh_of(const l3d_patch_model& model, int n);
    void drop_unused();
    void build(mesh& made, const l3d_patch_model& model, int n);
    void set_shading(const l3d_shading& shading);
    void set_placement(const l3d_method_frame& frame, const l3d_patch_instance& instance);
    void read_back(const l3d_method_frame& frame);

    mesa_target target_;
    l3d_size held_size_;
    std::vector<mesh> meshes_;
    l3d_depth_buffer own_depth_; ///< used if only the covered pixels are counted
    l3d_dice_counts counts_;
    l3d_surface_counts surface_counts_;
};

method_mesa::method_mesa(std::unique_ptr<mesa_context> context)
    : target_(std::move(context), smooth_surfaces, true) {}

void method_mesa::build(mesh& made, const l3d_patch_model& model, int n) {
    const mesa_gl& gl = target_.gl();
    if (made.vertices == 0) {
        gl.GenBuffers(1, &made.vertices);
        gl.GenBuffers(1, &made.indices);
    }
    std::vector<vertex> vertices;
    std::vector<std::uint32_t> indices;
    for (std::size_t i = 0; i < model.patches().size(); ++i) {
        const auto first = static_cast<std::uint32_t>(vertices.size());
        for (int row = 0; row <= n; ++row)
            for (int column = 0; column <= n; ++column) {
                const double u = static_cast<double>(column) / n, v = static_cast<double>(row) / n;
                const auto p = model.patches()[i].evaluate(u, v);
                const auto normal = model.normals(i).evaluate(u, v);
                vertex& added = vertices.emplace_back();
                for (int k = 0; k < 3; ++k) {
                    added.position[k] = static_cast<float>(p[k]);
                    added.normal[k] = static_cast<float>(normal[k]);
                }
            }
        const auto width = static_cast<std::uint32_t>(n) + 1;
        for (std::uint32_t row = 0; row + 1 < width; ++row)
            for (std::uint32_t column = 0; column + 1 < width; ++column) {
                const std::uint32_t a = first + row * width + column, b = a + 1, c = a + width;
                indices.insert(indices.end(), {a, b, c + 1, a, c + 1, c});
            }
    }
    gl.BindBuffer(GL_ARRAY_BUFFER, made.vertices);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(vertex)),
                  vertices.data(), GL_STATIC_DRAW);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, made.indices);
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                  static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data(),
                  GL_STATIC_DRAW);
    made.model = model;
    made.count = static_cast<int>(indices.size());
    made.n = n;
    counts_.samples += static_cast<std::int64_t>(vertices.size());
}

const method_mesa::mesh& method_mesa::mesh_of(const l3d_patch_model& model, int n) {
    auto found = std::ranges::find_if(
        meshes_, [&](const mesh& each) { return each.model.identity() == model.identity(); });
    if (found == meshes_.end())
        found = meshes_.insert(meshes_.end(), mesh{});
    found->is_used = true;
    // A mesh that is up to twice too fine is not made again.
    if (found->n < n || found->n > 2 * n)
        build(*found, model, (n + coarseness - 1) / coarseness * coarseness);
    return *found;
}

/// Forgets the models that have left the scene, and their buffers.
void method_mesa::drop_unused() {
    std::erase_if(meshes_, [this](const mesh& each) {
        if (each.is_used)
            return false;
        target_.gl().DeleteBuffers(1, &each.vertices);
        target_.gl().DeleteBuffers(1, &each.indices);
        return true;
    });
}

void method_mesa::set_shading(const l3d_shading& shading) {
    const mesa_gl& gl = target_.gl();
    gl.Uniform1i(target_.uniform("shade"), static_cast<int>(shading.mode));
    for (const auto& [name, value] :
         {std::pair{"light", &shading.light}, std::pair{"ray", &shading.ray},
          std::pair{"ray_right", &shading.ray_right}, std::pair{"ray_down", &shading.ray_down}})
        gl.Uniform3f(target_.uniform(name), (*value)[0], (*value)[1], (*value)[2]);
}

/// Sets the matrix that takes a model to the viewport of mesa_target. z is 2 near - w, so that z /
/// w runs from 1 at the near plane to -1.
void method_mesa::set_placement(const l3d_method_frame& frame, const l3d_patch_instance& instance) {
    const mesa_gl& gl = target_.gl();
    const l3d_matrix<double> m = frame.to_image * instance.placement();
    const double off_x = frame.view.size.width / 2.0 - target_.middle_x();
    const double off_y = frame.view.size.height / 2.0 - target_.middle_y();
    std::array<float, 16> clip;
    std::array<float, 9> world;
    for (int c = 0; c < 4; ++c) {
        const double w = m(3, c);
        const std::array<double, 4> column{(m(0, c) + off_x * w) / mesa_target::reach,
                                           (m(1, c) + off_y * w) / mesa_target::reach,
                                           (c == 3 ? 2 * frame.view.near : 0) - w, w};
        for (std::size_t r = 0; r < 4; ++r)
            clip[4 * static_cast<std::size_t>(c) + r] = static_cast<float>(column[r]);
        for (int r = 0; c < 3 && r < 3; ++r)
            world[3 * static_cast<std::size_t>(c) + static_cast<std::size_t>(r)] =
                static_cast<float>(instance.normal_matrix()(r, c));
    }
    gl.UniformMatrix4fv(target_.uniform("to_clip"), 1, GL_FALSE, clip.data());
    gl.UniformMatrix3fv(target_.uniform("to_world"), 1, GL_FALSE, world.data());
}

void method_mesa::read_back(const l3d_method_frame& frame) {
    target_.download(frame.target, frame.shading.background);
    surface_counts_.covered = l3d_surface_counts::none_counted;
    if (!frame.wants_depth && !frame.counts_pixels)
        return;
    l3d_depth_buffer& depth = frame.wants_depth ? frame.depth : own_depth_;
    depth.resize(frame.view.size);
    target_.download(depth);
    const auto scale =
        static_cast<float>(mesa_target::depth_scale * frame.view.depth_scale / frame.view.near);
    for (int y = 0; y < frame.view.size.height; ++y)
        for (float& inv_w : depth.row(y))
            inv_w *= scale;
    surface_counts_.covered = covered_of(frame, depth);
}

void method_mesa::do_draw(const l3d_method_frame& frame, l3d_stage_times& times) {
    const stopwatch dicing;
    counts_ = {};
    surface_counts_ = {};
    counts_.bound_px = std::numeric_limits<double>::infinity();
    const mesa_gl& gl = target_.gl();
    if (held_size_ != frame.view.size) {
        held_size_ = frame.view.size;
        if (!target_.resize(held_size_))
            throw l3d_error(l3d_exit::no_backend, "--method: mesa cannot draw a picture of " +
                                                      std::to_string(held_size_.width) + 'x' +
                                                      std::to_string(held_size_.height) +
                                                      " pixels");
    }
    int n = 1;
    for (const l3d_patch_instance& instance : frame.scene.instances())
        for (const auto& patch : instance.model().patches()) {
            const l3d_image_patch net =
                l3d_placed_net(frame.to_image * instance.placement(), patch);
            n = std::max(n, l3d_needs_no_clipping(net, frame.view) ? steps_of(net, frame.view) : 1);
        }
    for (mesh& each : meshes_)
        each.is_used = false;
    for (const l3d_patch_instance& instance : frame.scene.instances())
        mesh_of(instance.model(), n);
    drop_unused();
    times.dice += dicing.milliseconds();

    const stopwatch drawing;
    gl.DepthFunc(GL_GREATER);
    target_.clear(frame.shading.background);
    set_shading(frame.shading);
    for (const l3d_patch_instance& instance : frame.scene.instances()) {
        const mesh& triangles = mesh_of(instance.model(), n);
        set_placement(frame, instance);
        gl.BindBuffer(GL_ARRAY_BUFFER, triangles.vertices);
        gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles.indices);
        const auto at = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
        gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(vertex),
                               at(offsetof(vertex, position)));
        gl.VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(vertex),
                               at(offsetof(vertex, normal)));
        gl.DrawElements(GL_TRIANGLES, triangles.count, GL_UNSIGNED_INT, at(0));
        surface_counts_.quads += triangles.count / 3;
        counts_.drawn += static_cast<std::int64_t>(instance.model().patches().size());
    }
    read_back(frame);
    times.raster += drawing.milliseconds();
}

} // namespace

std::unique_ptr<l3d_surface_method> l3d_create_method_mesa() {
    std::string why;
    auto context = mesa_context::open("", why);
    if (!context)
        throw l3d_error(l3d_exit::no_backend, "--method: mesa: " + why);
    return std::make_unique<method_mesa>(std::move(context));
}
