// SPDX-License-Identifier: MIT
// Random nets of control points in the picture, (x w, y w, w), on which bounds are tried.
#pragma once

#include "geom/bezier_oracle.h"
#include "geom/step_bound.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace random_nets {

using point = l3d_image_point;
using pixel = l3d_vector<double, 2>;

constexpr std::uint64_t seed = 20260121;
constexpr l3d_image_box window{-512, -384, 512, 384};

/// How a random net looks.
enum class kind {
    moderate, ///< gently curved, w within a tenth
    thin,     ///< one side a ten thousandth of the other
    deep,     ///< w changes up to twentyfold, control points thrown about
};
constexpr kind kinds[] = {kind::moderate, kind::thin, kind::deep};
inline const char* name(kind k) {
    return k == kind::moderate ? "moderate" : k == kind::thin ? "thin" : "deep";
}

inline point in_front(oracle::random_values& random, kind k, double x, double y) {
    const double w =
        k == kind::deep ? std::exp(random.within(0, std::log(20))) : random.within(5, 5.5);
    return {x * w, y * w, w};
}

inline l3d_image_patch random_patch(oracle::random_values& random, kind k) {
    const double x = random.within(-400, 200), y = random.within(-300, 150);
    const double width = random.within(40, 300), height = random.within(30, 200);
    const double narrow = k == kind::thin ? 1e-4 : 1;
    const double bend = k == kind::deep ? 0.5 : 0.12;
    l3d_image_patch patch;
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) {
            const double u = c / 3.0 + random.within(-bend, bend);
            const double v = r / 3.0 + random.within(-bend, bend);
            patch.at(r, c) = in_front(random, k, x + width * u + 0.2 * height * v,
                                      y + narrow * height * v - 0.3 * width * u);
        }
    return patch;
}

inline l3d_image_curve random_curve(oracle::random_values& random, kind k) {
    return random_patch(random, k).row(random.up_to(4) - 1);
}

inline pixel projected(const point& h) {
    return {h[0] / h[2], h[1] / h[2]};
}

inline double distance(const pixel& a, const pixel& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1]);
}

inline bool holds(const l3d_image_box& box, const pixel& p) {
    return p[0] >= box.left && p[0] <= box.right && p[1] >= box.top && p[1] <= box.bottom;
}

inline point mixed(const point& a, const point& b, double t) {
    return a + (b - a) * t;
}

} // namespace random_nets
