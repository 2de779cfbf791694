// SPDX-License-Identifier: MIT
// l3d_pipeline_polygons: frames and picks models, and gives the reasons for an empty picture.
#include "pipeline/polygons/pipeline_polygons.h"

#include "geom/transform.h"
#include "pipeline/empty_picture_p.h"
#include "scene/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using vector = l3d_camera::vector;

/// How far the corners of a model's triangles reach in the world. Other vertices are not drawn.
l3d_reach reach_of(const l3d_polygon_model& model, const l3d_matrix<double>& placement) {
    return [&model, placement](const vector& direction) {
        // The direction in the model's coordinates, and the height of their origin.
        const auto in_model = l3d_transposed(placement) * l3d_vector<double, 4>(direction, 0.0);
        double most = -std::numeric_limits<double>::infinity();
        for (const l3d_model_triangle& triangle : model.triangles())
            for (const std::uint32_t corner : triangle.corners)
                most = std::max(most, l3d_dot(vector(in_model), model.mesh().vertices[corner]));
        return most + in_model[3];
    };
}

bool is_without_area(const l3d_polygon_model& model) {
    return !model.triangles().empty() &&
           std::ranges::all_of(model.triangles(), [&](const l3d_model_triangle& triangle) {
               return model.face_normals()[triangle.face] == l3d_polygon_model::direction(0);
           });
}

} // namespace

l3d_polygon_view l3d_pipeline_polygons::view() const {
    return l3d_polygon_view(
        camera_, screen_->pixels().size(),
        l3d_euler_rotation(settings_.rotation, model_.centre(), settings_.rotation_order));
}

l3d_camera l3d_pipeline_polygons::framed(const l3d_camera& camera) const {
    const l3d_polygon_view now = view();
    const l3d_reach reach = reach_of(model_, now.placement());
    return l3d_framed(camera, now.size(), reach);
}

l3d_camera l3d_pipeline_polygons::framed_unless_well(const l3d_camera& usual) const {
    const l3d_polygon_view now = view();
    return l3d_framed_unless_well(usual, now.size(), reach_of(model_, now.placement()));
}

void l3d_pipeline_polygons::frame_all() {
    camera_ = framed(camera_);
    redraw();
}

std::string l3d_pipeline_polygons::why_empty() const {
    const l3d_polygon_view now = view();
    const auto is_empty = [&] {
        return l3d_detail::is_empty(screen_->pixels(), settings_.background);
    };
    if (is_without_area(model_) && is_empty()) // lines may be seen all the same
        return l3d_without_area;
    std::string why = l3d_why_unseen(camera_, now.size(), reach_of(model_, now.placement()));
    const l3d_polygon_counts& polygons = report_.polygons;
    const bool left_all_out =
        polygons.drawn == 0 && // lines are not counted
        polygons.back + polygons.offscreen + polygons.subpixel >= report_.triangles;
    if (why == l3d_smaller_than_a_pixel && !is_empty())
        return "";
    if (!why.empty() || !left_all_out)
        return why;
    return polygons.back == report_.triangles ? l3d_turning_its_back : "not where a pixel shows it";
}

std::optional<l3d_polygon_pick> l3d_pipeline_polygons::pick(double x, double y) const {
    return l3d_polygon_pick_at(model_, view(), settings_.cull, x, y);
}

l3d_viewed l3d_pipeline_polygons::viewed() {
    const auto place_at = [this](double x, double y) -> std::optional<l3d_pointed_place> {
        const auto found = pick(x, y);
        if (!found)
            return std::nullopt;
        return l3d_pointed_place{found->point, found->point_error, found->line(), found->normal,
                                 found->normal_error};
    };
    return {.framed = [this](const l3d_camera& camera) { return framed(camera); },
            .place_at = place_at};
}
