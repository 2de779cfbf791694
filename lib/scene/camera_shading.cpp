// SPDX-License-Identifier: MIT
// l3d_camera_shading: finds the rays of a picture, in floats.
#include "scene/camera_shading.h"

#include "scene/dice_view.h"

namespace {

std::array<float, 3> to_floats(const l3d_camera::vector& v) {
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

} // namespace

l3d_frame_lights l3d_headlight(const l3d_camera& camera, const l3d_lighting& lighting) {
    constexpr l3d_camera::vector first_eye{3.0, 2.3, 7.4}; // from the target of the first view
    const l3d_camera::frame first = l3d_camera{.eye = first_eye, .target = {0.0, 0.0, 0.0}}.axes();
    const l3d_camera::frame axes = camera.axes();
    const auto along = [](const l3d_camera::vector& axis) {
        return l3d_dot(l3d_usual_light, axis);
    };
    l3d_frame_lights result{axes.right * along(first.right) + axes.up * along(first.up) +
                                axes.forward * along(first.forward),
                            {}};
    result.lighting.ambient = lighting.ambient;
    result.lighting.color = lighting.color;
    return result;
}

l3d_shading l3d_camera_shading(const l3d_camera& camera, l3d_size size, l3d_shade mode,
                               const l3d_camera::vector& light, const l3d_lighting& lighting) {
    const l3d_camera::frame axes = camera.axes();
    const auto corner = axes.forward * camera.focal_length(size) - axes.right * (size.width / 2.0) +
                        axes.up * (size.height / 2.0);
    l3d_shading result{mode, to_floats(l3d_normalized(light)), to_floats(corner),
                       to_floats(axes.right), to_floats(axes.up * -1.0)};
    result.lighting = lighting;
    result.look = result.ray;
    result.look_right = result.ray_right;
    result.look_down = result.ray_down;
    result.eye = {camera.eye[0], camera.eye[1], camera.eye[2]};
    result.look_depth = static_cast<float>(camera.focal_length(size));
    if (camera.is_parallel()) {
        const double pixel = 1 / camera.scale_at_target(size);
        const auto right = axes.right * pixel, down = axes.up * -pixel;
        result.ray = result.look = to_floats(axes.forward);
        result.ray_right = result.ray_down = result.look_right = result.look_down = {0, 0, 0};
        result.aside = to_floats(right * (-size.width / 2.0) + down * (-size.height / 2.0));
        result.aside_right = to_floats(right);
        result.aside_down = to_floats(down);
        result.look_depth = 1;
    }
    return result;
}

l3d_shading l3d_lit_while_diced(l3d_dice_view& view, const l3d_shading& shading, bool with_levels) {
    view.shading = shading;
    if (with_levels && shading.mode == l3d_shade::lambert)
        view.shading.mode = l3d_shade::levels;
    l3d_shading rest = view.shading;
    rest.ray = rest.ray_right = rest.ray_down = {};
    return rest;
}
