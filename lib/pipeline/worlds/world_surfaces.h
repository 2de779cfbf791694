// SPDX-License-Identifier: MIT
// l3d_world_surfaces: draws a world's objects through a depth buffer.
#ifndef L3D_PIPELINE_WORLDS_WORLD_SURFACES_H
#define L3D_PIPELINE_WORLDS_WORLD_SURFACES_H

#include "pipeline/polygons/polygon_frame.h"
#include "pipeline/polygons/polygon_wires.h"
#include "pipeline/worlds/world.h"
#include "raster/depth_buffer.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

/// Draws all objects of a world into one picture through a depth buffer. An l3d_polygon_frame
/// places the triangles of each object.
///
/// An object is left out as a whole if the ball around it is outside of the view. For an object
/// that its placement scales or shears, a model of the resulting shape is made, so that its normals
/// are right.
/// Cost:    linear in the triangles of objects that may be seen. One thread places a small object;
///          all threads together place a large object.
class l3d_world_surfaces {
public:
    /// Draws a frame. Returns: the number of triangles drawn, or of lines for a wireframe.
    /// Expects: target.surfaces and target.workers are not null.
    std::size_t draw(std::span<const std::unique_ptr<l3d_object>> objects,
                     const l3d_world::camera_type& camera, const l3d_polygon_settings& settings,
                     const l3d_world_target& target);

private:
    /// An object's model and its triangles in the picture. They are kept from frame to frame, to
    /// reuse their memory and `shaped`.
    struct placed {
        /// The object, to compare addresses only: it may be destroyed.
        const l3d_object* object = nullptr;
        /// The object's own model, from which `shaped` is made.
        std::optional<l3d_polygon_model> plain;
        /// The model scaled and sheared; none if the placement does neither.
        std::optional<l3d_polygon_model> shaped;
        /// The inverse of the placement that `shaped` was made for. The object's placement times
        /// this inverse places `shaped`, even after the object has turned.
        l3d_matrix<double> unshape = l3d_identity<double>();
        std::optional<l3d_polygon_view> view;
        l3d_polygon_frame frame;
        l3d_polygon_wires wires;
        std::uint32_t first_material = 0;
        /// Name of the object's first triangle, for its paint.
        std::optional<std::uint32_t> first_painted;

        const l3d_polygon_model& model() const { return shaped ? *shaped : *plain; }
    };

    struct frame_input;

    void place_all(const frame_input& in, std::span<const std::unique_ptr<l3d_object>> objects);
    bool place(const frame_input& in, const l3d_object& object, placed& to) const;
    void gather_materials(const l3d_polygon_settings& settings);
    const l3d_face_paints* gather_paints(const l3d_polygon_settings& settings);
    void make_frames(const frame_input& in, l3d_workers& workers);
    std::size_t draw_wires(const frame_input& in, const l3d_world_target& target);
    std::size_t fill(const frame_input& in, const l3d_world_target& target);

    /// The placed objects, in the order of the world's objects.
    std::vector<std::unique_ptr<placed>> placed_;
    std::vector<placed*> seen_; ///< the placed objects that this frame may show
    std::vector<l3d_material> materials_;
    l3d_face_paints paints_;
    std::vector<const l3d_surface_part*> parts_;
    std::vector<l3d_painter_triangle> triangles_, of_object_; ///< triangles, for hidden lines
    /// For each thread, an l3d_workers of that thread alone, to place small objects.
    std::vector<std::unique_ptr<l3d_workers>> alone_;
    l3d_depth_buffer depth_;
};

#endif
