// SPDX-License-Identifier: MIT
// The picture of a patch in 100 decimal digits: the judge of every bound.
#ifndef L3D_TESTS_STABILITY_EXACT_SURFACE_H
#define L3D_TESTS_STABILITY_EXACT_SURFACE_H

#include "reference/exact.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <array>

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

    /// The distance of a picture point from the surface point (u, v) in the picture; infinite if
    /// that is not in front of the eye. Units: pixels.
    double distance(double x, double y, double u, double v) const;

    /// The same in 64 bits, to find out which points are worth 100 digits.
    double about(double x, double y, double u, double v) const;

private:
    std::array<exact_camera::point, 16> net_;
    std::array<std::array<long double, 3>, 16> rounded_;
};

} // namespace stability

#endif
