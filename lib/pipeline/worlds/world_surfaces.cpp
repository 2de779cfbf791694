// SPDX-License-Identifier: MIT
// l3d_world_surfaces: places objects that may be seen, and fills them in one call.
#include "pipeline/worlds/world_surfaces.h"

#include "pipeline/polygons/paint_gatherer_p.h"
#include "pipeline/wire_p.h"
#include "raster/lines/hidden_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace {

using vector = l3d_vector<double, 3>;

/// The largest number of triangles of a small object. A larger object takes some tenths of a
/// millisecond or more, so all threads place it together.
constexpr std::size_t large = 4096;

l3d_matrix<double> in_double(const l3d_matrix<l3d_real>& m) {
    l3d_matrix<double> result;
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k)
            result(i, k) = l3d_to_double(m(i, k));
    return result;
}

/// Whether a placement keeps lengths and angles, up to 2^-16. A product of rotations in floats is
/// off by some 2^-23 for each factor. Errors below 2^-16 do not show in shades.
bool is_rigid(const l3d_matrix<double>& placement) {
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k <= i; ++k) {
            double product = 0;
            for (int row = 0; row < 3; ++row)
                product += placement(row, i) * placement(row, k);
            if (!(std::abs(product - (i == k)) < 0x1p-16))
                return false;
        }
    return true;
}

/// A model whose vertices and normals are transformed by the linear part of a matrix. If the matrix
/// mirrors, faces are reversed, so that the order of their corners still tells which side is
/// outside.
l3d_polygon_model reshaped(const l3d_polygon_model& model, const l3d_matrix<double>& shape) {
    l3d_polygon_mesh result = model.mesh();
    for (vector& v : result.vertices)
        v = l3d_transformed(shape, v);
    for (vector& normal : result.vertex_normals)
        normal = l3d_transformed_normal(shape, normal).value_or(vector(0.0));
    if (l3d_determinant(shape) < 0)
        for (std::size_t face = 0; face < result.faces(); ++face) {
            const auto begin =
                static_cast<std::ptrdiff_t>(face == 0 ? 0 : result.face_ends[face - 1]);
            const auto end = static_cast<std::ptrdiff_t>(result.face_ends[face]);
            std::reverse(result.corners.begin() + begin, result.corners.begin() + end);
            if (!result.picture_places.empty())
                std::reverse(result.picture_places.begin() + begin,
                             result.picture_places.begin() + end);
        }
    const auto textures = model.textures();
    return l3d_polygon_model(std::move(result)).textured({textures.begin(), textures.end()});
}

} // namespace

/// The input that all objects of a frame share.
struct l3d_world_surfaces::frame_input {
    l3d_camera camera; ///< the camera, in the right-handed world
    vector forward;    ///< direction of the camera's view
    l3d_size size;
    l3d_picture_fit fit;
    const l3d_polygon_settings& settings;
    l3d_shading shading;
    /// Normals of the four planes at the view's sides, pointing inwards.
    std::array<vector, 4> sides;

    /// Whether a ball in the right-handed world may be seen.
    bool may_show(const vector& centre, double radius) const {
        const vector from_eye = centre - camera.eye;
        const double depth = l3d_dot(from_eye, forward);
        return depth + radius >= camera.near_z && depth - radius <= camera.far_z &&
               std::ranges::all_of(
                   sides, [&](const vector& side) { return l3d_dot(side, from_eye) >= -radius; });
    }
};

std::size_t l3d_world_surfaces::draw(std::span<const std::unique_ptr<l3d_object>> objects,
                                     const l3d_world::camera_type& camera,
                                     const l3d_polygon_settings& settings,
                                     const l3d_world_target& target) {
    const l3d_size size = target.pixels.size();
    // The centres of pixels are at whole numbers in the book, and at halves here.
    const l3d_picture_fit fit{camera.fovx * size.width / (camera.fovy * size.height), 0.5};
    const l3d_camera ours = l3d_right_handed(camera);
    const l3d_camera::frame axes = ours.axes();
    // A pixel shows things up to half a pixel beyond its centre; one more is for rounding.
    const double right = (1 + 2.0 / size.width) / (2 * camera.fovx);
    const double up = (1 + 2.0 / size.height) / (2 * camera.fovy);
    frame_input in{ours,
                   axes.forward,
                   size,
                   fit,
                   settings,
                   {},
                   {l3d_normalized(axes.forward * right - axes.right),
                    l3d_normalized(axes.forward * right + axes.right),
                    l3d_normalized(axes.forward * up - axes.up),
                    l3d_normalized(axes.forward * up + axes.up)}};
    const auto mirrored = [](vector v) {
        v[2] = -v[2];
        return v;
    };
    l3d_lighting lighting = settings.lighting;
    for (std::size_t i = 0; i < lighting.count; ++i)
        lighting.lights[i].direction[2] = -lighting.lights[i].direction[2];
    for (std::size_t i = 0; i < lighting.point_count; ++i)
        lighting.points[i].position[2] = -lighting.points[i].position[2];
    const l3d_polygon_view view(ours, size, l3d_identity<double>(), fit);
    in.shading = view.shading(settings.shade, mirrored(settings.light), lighting);
    in.shading.background = settings.background;
    in.shading.fog = settings.fog;
    if (settings.style == l3d_polygon_style::solid)
        in.shading.antialias = settings.antialias && target.surfaces->antialiases();
    place_all(in, objects);
    if (settings.style == l3d_polygon_style::wireframe)
        return draw_wires(in, target);
    gather_materials(settings);
    if (settings.style == l3d_polygon_style::solid && l3d_is_light(in.shading.mode))
        in.shading.paints = gather_paints(settings);
    make_frames(in, *target.workers);
    return fill(in, target);
}

void l3d_world_surfaces::place_all(const frame_input& in,
                                   std::span<const std::unique_ptr<l3d_object>> objects) {
    // New objects come last. So an entry whose object is not the next one belongs to an object that
    // has gone. Its memory serves a new object.
    std::size_t kept = 0;
    for (auto& old : placed_)
        if (kept < objects.size() && old->object == objects[kept].get())
            std::swap(old, placed_[kept++]);
    while (placed_.size() < objects.size())
        placed_.push_back(std::make_unique<placed>());
    placed_.resize(objects.size());
    seen_.clear();
    for (std::size_t i = 0; i < objects.size(); ++i) {
        placed_[i]->object = objects[i].get();
        if (place(in, *objects[i], *placed_[i]))
            seen_.push_back(placed_[i].get());
    }
}

/// Prepares an object for the frame: its model, and the view of it. Returns whether any of the
/// object may be seen.
bool l3d_world_surfaces::place(const frame_input& in, const l3d_object& object, placed& to) const {
    const l3d_polygon_model& model = object.model();
    if (model.triangles().empty())
        return false;
    const l3d_matrix<double> placement = in_double(object.world_transform());
    l3d_matrix<double> mirror = l3d_identity<double>();
    mirror(2, 2) = -1;
    const bool is_new = !to.plain || &to.plain->mesh() != &model.mesh();
    if (is_new) {
        to.plain = model;
        to.shaped.reset();
    }
    l3d_matrix<double> rest = placement;
    if (is_rigid(placement))
        to.shaped.reset();
    else if (!to.shaped || !is_rigid(rest = placement * to.unshape)) {
        l3d_matrix<double> shape = placement;
        for (int i = 0; i < 3; ++i) {
            shape(i, 3) = 0;
            for (int k = 0; k < 3; ++k)
                rest(i, k) = i == k;
        }
        to.shaped = reshaped(model, shape);
        to.unshape = l3d_inverted(shape).value_or(l3d_identity<double>());
    }
    const l3d_matrix<double> ours = mirror * rest;
    const vector c = to.model().centre();
    const auto centre = ours * l3d_vector<double, 4>(c, 1.0);
    // The margin is far beyond the rounding of the centre and of the planes.
    const double radius = to.model().radius() * (1 + 1e-6) + 1e-9 * l3d_length(in.camera.eye);
    if (!in.may_show(vector(centre[0], centre[1], centre[2]), radius))
        return false;
    to.view.emplace(in.camera, in.size, ours, in.fit);
    return true;
}

/// Gathers the materials of all objects that may be seen. An object without materials gets a white
/// material, unless no object has materials.
void l3d_world_surfaces::gather_materials(const l3d_polygon_settings& settings) {
    materials_.clear();
    const bool all_plain = !settings.material && std::ranges::all_of(seen_, [](const placed* p) {
        return p->model().materials().empty();
    });
    for (placed* p : seen_) {
        p->first_material = static_cast<std::uint32_t>(materials_.size());
        const auto own = p->model().materials();
        if (settings.material)
            materials_.resize(materials_.size() + std::max<std::size_t>(own.size(), 1),
                              *settings.material);
        else if (!own.empty())
            materials_.insert(materials_.end(), own.begin(), own.end());
        else if (!all_plain)
            materials_.emplace_back();
        else
            p->first_material = 0;
    }
}

/// Names the triangles that have paint. Returns the paints for the shading, or null if there are
/// none.
/// Expects: gather_materials was called.
const l3d_face_paints* l3d_world_surfaces::gather_paints(const l3d_polygon_settings& settings) {
    l3d_detail::paint_gatherer gatherer(settings, materials_.size(), paints_);
    for (placed* p : seen_)
        p->first_painted = gatherer.add(p->model(), *p->view, p->first_material);
    return gatherer.paints();
}

void l3d_world_surfaces::make_frames(const frame_input& in, l3d_workers& workers) {
    while (alone_.size() < static_cast<std::size_t>(workers.count()))
        alone_.push_back(std::make_unique<l3d_workers>(1));
    const auto make = [&](placed& p, l3d_workers& by) {
        p.frame.make(p.model(), *p.view,
                     {.cull = in.settings.cull,
                      .smooth = in.settings.shade != l3d_shade::flat,
                      .antialias = in.shading.antialias,
                      .parts = true,
                      .cull_hidden = true,
                      .first_material = p.first_material,
                      .first_painted = in.shading.paints ? p.first_painted : std::nullopt},
                     by);
    };
    const auto is_large = [](const placed& p) { return p.model().triangles().size() > large; };
    for (placed* p : seen_)
        if (is_large(*p))
            make(*p, workers);
    workers.for_each(static_cast<int>(seen_.size()), [&](int i, int worker) {
        placed& p = *seen_[static_cast<std::size_t>(i)];
        if (!is_large(p))
            make(p, *alone_[static_cast<std::size_t>(worker)]);
    });
}

std::size_t l3d_world_surfaces::draw_wires(const frame_input& in, const l3d_world_target& target) {
    l3d_detail::wire_picture picture(target.rasterizer, target.pixels, in.shading,
                                     in.settings.antialias, 1);
    std::size_t count = 0;
    for (placed* p : seen_) {
        const auto lines = p->wires.make(p->model(), *p->view, in.settings.cull);
        picture.draw(lines);
        count += lines.size();
    }
    picture.finish();
    return count;
}

std::size_t l3d_world_surfaces::fill(const frame_input& in, const l3d_world_target& target) {
    parts_.clear();
    std::size_t count = 0;
    for (const placed* p : seen_) {
        parts_.insert(parts_.end(), p->frame.parts().begin(), p->frame.parts().end());
        count += static_cast<std::size_t>(p->frame.counts().drawn);
    }
    const bool lines = in.settings.style == l3d_polygon_style::hidden_lines;
    target.rasterizer.finish();
    if (lines)
        depth_.resize(in.size);
    target.surfaces->count_pixels(in.settings.count_pixels);
    target.surfaces->use_materials(materials_);
    target.surfaces->begin(target.pixels, lines ? &depth_ : nullptr, in.shading);
    target.surfaces->draw(parts_);
    target.surfaces->finish();
    if (lines) {
        triangles_.clear();
        for (const placed* p : seen_) {
            p->frame.list(of_object_, *target.workers);
            triangles_.insert(triangles_.end(), of_object_.begin(), of_object_.end());
        }
        l3d_draw_seen_sides(target.pixels, depth_, triangles_, in.shading,
                            {l3d_detail::wire_color, in.settings.antialias});
    }
    return count;
}
