// SPDX-License-Identifier: MIT
// The exact greys of a polygon's pixels, by each mode's definition, in double.
#ifndef L3D_TESTS_RASTER_REFERENCE_LIGHT_H
#define L3D_TESTS_RASTER_REFERENCE_LIGHT_H

#include "raster/surfaces/away_from_eye_p.h"
#include "raster/surface_rasterizer.h"
#include "reference_fill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace reference {

inline double level_of(double cosine, double away) {
    return 255 * (0.1 + 0.9 * std::clamp(away > 0 ? -cosine : cosine, 0.0, 1.0));
}

/// A normal's cosine, and how far it points away from the eye.
struct light_on {
    double cosine = 0, away = 0;

    light_on(const std::array<double, 3>& normal, const l3d_shading& s, double points_away)
        : away(points_away) {
        double lit = 0, square = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            lit += normal[k] * double(s.light[k]);
            square += normal[k] * normal[k];
        }
        cosine = square > 1e-30 ? lit / std::sqrt(square) : 0;
    }

    /// Which side is seen may be a matter of rounding.
    bool doubtful() const { return std::abs(away) < 1e-5 && std::abs(cosine) > 1e-3; }
    double level() const { return level_of(cosine, away); }
};

inline double lambert_of(const corners& v, const l3d_shading& s, int x, int y) {
    std::vector<float> number(v.size());
    std::array<double, 3> normal;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < v.size(); ++i)
            number[i] = v[i].normal[k];
        normal[k] = static_cast<double>(at_centre(v, number, x, y));
    }
    for (std::size_t i = 0; i < v.size(); ++i)
        number[i] = l3d_detail::away_from_eye(v[i], s);
    const light_on light(normal, s, static_cast<double>(at_centre(v, number, x, y)));
    return light.doubtful() ? -1 : light.level();
}

inline double gouraud_of(const corners& v, const l3d_shading& s, int x, int y) {
    std::vector<float> levels;
    for (const l3d_micro_vertex& c : v) {
        const light_on light({double(c.normal[0]), double(c.normal[1]), double(c.normal[2])}, s,
                             double(l3d_detail::away_from_eye(c, s)));
        if (light.doubtful())
            return -1;
        levels.push_back(static_cast<float>(light.level()));
    }
    const auto [least, most] = std::minmax_element(levels.begin(), levels.end());
    return std::clamp(static_cast<double>(at_centre(v, levels, x, y)), double(*least),
                      double(*most));
}

inline double flat_of(const corners& v, const l3d_shading& s) {
    std::array<double, 3> sum{};
    double away = 0;
    for (const l3d_micro_vertex& c : v) {
        for (std::size_t k = 0; k < 3; ++k)
            sum[k] += double(c.normal[k]);
        away += double(l3d_detail::away_from_eye(c, s));
    }
    const light_on light(sum, s, away);
    return light.doubtful() ? -1 : light.level();
}

/// The exact grey before rounding, or a negative number where the side that is seen is a matter of
/// rounding.
inline double grey_of(const corners& v, const l3d_shading& s, int x, int y) {
    return s.mode == l3d_shade::lambert   ? lambert_of(v, s, x, y)
           : s.mode == l3d_shade::gouraud ? gouraud_of(v, s, x, y)
                                          : flat_of(v, s);
}

} // namespace reference

#endif
