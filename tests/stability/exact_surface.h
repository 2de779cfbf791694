// SPDX-License-Identifier: MIT
// The picture of a patch in 100 decimal digits: the judge of every bound.
#ifndef L3D_TESTS_STABILITY_EXACT_SURFACE_H
#define L3D_TESTS_STABILITY_EXACT_SURFACE_H

#include "geom/files/patch_file.h"
#include "reference/exact.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <array>
#include <vector>

namespace stability {

/// 100 digits: control points are doubles up to 1e12; what they cancel to may be as small as 1e-30
/// and still has 58 digits.
using digits = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>,
                                             boost::multiprecision::et_off>;

/// A camera, in 100 digits. Shares nothing with the library.
class exact_camera {
public:
    exact_camera(const reference::camera& view, reference::picture_size size);

    using point = std::array<digits, 3>;

    /// (x, y, w): the pixel is (x / w, y / w) from the picture's upper left corner.
    point project(const reference::vec3& world) const;

private:
    std::array<point, 3> axes_; ///< right, down, forward
    point eye_;
    digits focal_, centre_x_, centre_y_;
    bool is_parallel_ = false;
};

/// A patch as the camera sees it.
class exact_surface {
public:
    exact_surface(const reference::patch& surface, const exact_camera& camera);
    exact_surface(const l3d_patch_points& surface, const exact_camera& camera);

    /// The distance of a picture point from the surface point (u, v) in the picture; infinite if
    /// that is not in front of the eye. Units: pixels.
    double distance(double x, double y, double u, double v) const;

    /// The same in 64 bits, to find out which points are worth 100 digits.
    double about(double x, double y, double u, double v) const;

private:
    void append(const reference::vec3& point, double weight, const exact_camera& camera);
    template <class Number>
    std::array<Number, 3> value(const std::vector<std::array<Number, 3>>& net, double u,
                                double v) const;

    int degree_u_ = 3, degree_v_ = 3;
    std::vector<exact_camera::point> net_; ///< u fastest, times the weights
    std::vector<std::array<long double, 3>> rounded_;
};

} // namespace stability

#endif
