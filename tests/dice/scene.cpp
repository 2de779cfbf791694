// SPDX-License-Identifier: MIT
// Scenes, in the types of the library and of the reference.
#include "scene.h"

#include "scene/bodies.h"

#include <utility>

namespace dice_tests {
namespace {

l3d_camera::vector vector_of(const reference::vec3& v) {
    return {v.x, v.y, v.z};
}

l3d_camera camera_of(const reference::camera& view) {
    l3d_camera result;
    result.eye = vector_of(view.eye);
    result.target = vector_of(view.target);
    result.up = vector_of(view.up);
    result.fov = view.fov_degrees;
    result.near_z = view.near;
    if (view.parallel)
        result.projection = l3d_projection::parallel;
    return result;
}

l3d_patch_model model_of(const std::vector<reference::patch>& surfaces) {
    std::vector<l3d_patch_model::patch> result(surfaces.size());
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        for (std::size_t k = 0; k < 16; ++k)
            result[i].points[k] = vector_of(surfaces[i].points[k]);
    return l3d_patch_model(std::move(result));
}

} // namespace

scene::scene(std::vector<reference::patch> surfaces, const reference::camera& view, l3d_size of)
    : patches(std::move(surfaces)), eye(view), size(of), model(model_of(patches)),
      camera(camera_of(view)) {}

scene::scene(const std::vector<reference::patch>& of_model, const l3d_matrix<double>& where,
             const reference::camera& view, l3d_size of)
    : patches(placed(of_model, where)), eye(view), size(of), model(model_of(of_model)),
      placement(where), camera(camera_of(view)) {}

scene teapot(const reference::view& view, l3d_size size) {
    return {reference::load_bpt_plain("data/teapot.bpt"), view.eye, size};
}

} // namespace dice_tests
