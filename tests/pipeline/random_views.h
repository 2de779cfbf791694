// SPDX-License-Identifier: MIT
// Random cameras, and the rays that pixels stand for.
#ifndef L3D_TESTS_PIPELINE_RANDOM_VIEWS_H
#define L3D_TESTS_PIPELINE_RANDOM_VIEWS_H

#include "scene/camera.h"
#include "tool_2d/pixels.h"

#include <cmath>
#include <random>

/// The rays through a picture's pixels.
struct camera_rays {
    using vector = l3d_vector<double, 3>;
    l3d_camera camera;
    l3d_size size;
    l3d_camera::frame axes;
    double focal;

    camera_rays(const l3d_camera& of, l3d_size pixels)
        : camera(of), size(pixels), axes(of.axes()), focal(of.focal_length(pixels)) {}

    /// Its length along the view axis is 1.
    vector at(double x, double y) const {
        return axes.forward + axes.right * ((x - size.width / 2.0) / focal) -
               axes.up * ((y - size.height / 2.0) / focal);
    }
};

/// A camera anywhere around a ball; at zoom 1, all of the ball fills the picture.
inline l3d_camera random_view(const l3d_vector<double, 3>& middle, double radius, double zoom,
                              std::mt19937& random) {
    using vector = l3d_vector<double, 3>;
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> any(-1, 1);
    l3d_camera camera;
    const vector away = l3d_normalized(vector{normal(random), normal(random), normal(random)});
    camera.target = middle + vector{any(random), any(random), any(random)} * (0.3 * radius);
    camera.eye = camera.target + away * (4 * radius / zoom);
    camera.up = std::abs(away[1]) < 0.9 ? vector{0.0, 1.0, 0.0} : vector{1.0, 0.0, 0.0};
    camera.near_z = radius / zoom / 100;
    return camera;
}

#endif
