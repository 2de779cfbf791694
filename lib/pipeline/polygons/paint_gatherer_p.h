// SPDX-License-Identifier: MIT
// paint_gatherer: gives names to the painted triangles of a frame's models.
#ifndef L3D_PIPELINE_POLYGONS_PAINT_GATHERER_P_H
#define L3D_PIPELINE_POLYGONS_PAINT_GATHERER_P_H

#include "pipeline/polygons/pipeline_polygons.h"
#include "raster/surface_rasterizer.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace l3d_detail {

/// Gives each triangle of painted models a name, by which rasterizers find the triangle's paint: a
/// picture, or colours of vertices. A name is a number beyond those of the frame's materials.
/// Lives: borrows the settings and the paints that it fills.
class paint_gatherer {
public:
    paint_gatherer(const l3d_polygon_settings& settings, std::size_t materials,
                   l3d_face_paints& out)
        : settings_(settings), next_(materials), out_(out) {
        out.models.clear();
        if (settings.textures)
            out.filter = *settings.textures;
    }

    /// Adds a model, and returns the name of its first triangle. It adds nothing, and returns
    /// nothing, if the model has no paint, if the settings want none, or if too few names are left.
    /// Faces then have the colours of their materials.
    /// Lives: the model must live as long as the paints are in use.
    std::optional<std::uint32_t> add(const l3d_polygon_model& model, const l3d_polygon_view& view,
                                     std::uint32_t first_material) {
        const auto painted = model.painted();
        const bool is_wanted = settings_.textures || !model.mesh().vertex_colors.empty();
        if (painted.empty() || settings_.material || !is_wanted ||
            painted.size() > l3d_surface_rasterizer::most_materials - next_)
            return std::nullopt;
        const auto first = static_cast<std::uint32_t>(next_);
        next_ += painted.size();
        l3d_painted_model of{.first = first,
                             .first_material = first_material,
                             .to_picture = from_corner(view),
                             .vertices = model.mesh().vertices,
                             .triangles = painted,
                             .textures = {}};
        if (settings_.textures)
            of.textures = model.textures();
        out_.models.push_back(of);
        return first;
    }

    /// The paints for rasterizers: null if no model was added.
    const l3d_face_paints* paints() const { return out_.models.empty() ? nullptr : &out_; }

private:
    /// The view's matrix from the model to the picture, with places counted from the picture's top
    /// left corner instead of its middle.
    static l3d_matrix<double> from_corner(const l3d_polygon_view& view) {
        l3d_matrix<double> m = view.matrix();
        for (int column = 0; column < 4; ++column) {
            m(0, column) += view.size().width / 2.0 * m(3, column);
            m(1, column) += view.size().height / 2.0 * m(3, column);
        }
        return m;
    }

    const l3d_polygon_settings& settings_;
    std::size_t next_;
    l3d_face_paints& out_;
};

} // namespace l3d_detail

#endif
