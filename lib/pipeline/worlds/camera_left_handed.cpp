// SPDX-License-Identifier: MIT
// l3d_camera_left_handed: converts perspective in the book's terms to our own camera.
#include "pipeline/worlds/camera_left_handed.h"

#include <cmath>
#include <numbers>

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Mirrors a vector of the left-handed world into the right-handed world.
template <class T> l3d_camera::vector mirrored(const l3d_vector<T, 3>& v) {
    return {l3d_to_double(v[0]), l3d_to_double(v[1]), -l3d_to_double(v[2])};
}

} // namespace

double l3d_fov_term(double degrees) {
    return 0.5 / std::tan(degrees / 2 * degree);
}

double l3d_fov_degrees(double term) {
    return 2 * std::atan(0.5 / term) / degree;
}

template <class T>
l3d_camera_left_handed<T>::l3d_camera_left_handed(l3d_size size)
    : fovx(l3d_fov_term(100)), fovy(fovx * size.width / size.height) {}

template <class T> void l3d_camera_left_handed<T>::change_size(l3d_size from, l3d_size to) {
    fovy *= static_cast<double>(to.width) / to.height * from.height / from.width;
}

template <class T> void l3d_camera_left_handed<T>::drag(double right, double down, l3d_size size) {
    this->turn_about_up(-std::atan(right / (fovx * size.width)) / degree);
    this->turn_about_right(-std::atan(down / (fovy * size.height)) / degree);
}

template <class T>
typename l3d_camera_left_handed<T>::pixel l3d_camera_left_handed<T>::project(const l3d_point<T>& p,
                                                                             l3d_size size) const {
    const T x = p[0] / p[2] * l3d_from_double<T>(fovx * size.width);
    const T y = p[1] / p[2] * l3d_from_double<T>(fovy * size.height);
    return {size.width / 2.0 + l3d_to_double(x), size.height / 2.0 - l3d_to_double(y)};
}

template <class T> l3d_camera l3d_right_handed(const l3d_camera_left_handed<T>& camera) {
    l3d_camera ours;
    ours.eye = mirrored(camera.place.from_origin);
    ours.target = ours.eye + mirrored(camera.forward());
    ours.up = mirrored(camera.up());
    ours.fov = l3d_fov_degrees(camera.fovy);
    ours.near_z = camera.near_z;
    ours.far_z = camera.far_z;
    return ours;
}

template class l3d_camera_left_handed<float>;
template class l3d_camera_left_handed<double>;
template class l3d_camera_left_handed<l3d_fixed<std::int64_t, 32>>;
template l3d_camera l3d_right_handed(const l3d_camera_left_handed<float>&);
template l3d_camera l3d_right_handed(const l3d_camera_left_handed<double>&);
template l3d_camera l3d_right_handed(const l3d_camera_left_handed<l3d_fixed<std::int64_t, 32>>&);
