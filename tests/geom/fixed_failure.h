// SPDX-License-Identifier: MIT
// Forward differencing without an error bound: the teapot walked in steps of at most one pixel.
#ifndef L3D_TESTS_GEOM_FIXED_FAILURE_H
#define L3D_TESTS_GEOM_FIXED_FAILURE_H

#include "geom/forward_difference_surface.h"
#include "geom/files/patch_file.h"
#include "geom/step_bound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

/// Ways to walk a patch by forward differences, and how far off their points are.
namespace fixed_failure {

inline constexpr int width = 1024, height = 768;

/// Bicubic patches of a .bpt file, in the world.
/// Errors: std::runtime_error that names the file.
inline std::vector<l3d_bezier_patch<double, 3>> teapot(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    std::string why;
    const auto read = l3d_read_bpt(text, path, why);
    if (!read)
        throw std::runtime_error(why);
    std::vector<l3d_bezier_patch<double, 3>> patches;
    for (const l3d_patch_points& one : *read) {
        patches.emplace_back();
        for (std::size_t i = 0; i < 16; ++i)
            patches.back().points[i] = {one.points.at(i)[0], one.points.at(i)[1],
                                        one.points.at(i)[2]};
    }
    return patches;
}

inline constexpr l3d_vector<double, 3> eye{3.2, 3.6, 7.4};

/// A patch as the view `full` shows it: homogeneous, from the picture's centre.
inline l3d_image_patch in_view_full(const l3d_bezier_patch<double, 3>& patch) {
    using vector = l3d_vector<double, 3>;
    const vector target{0.2, 1.3, 0}, up{0, 1, 0};
    const vector forward = l3d_normalized(vector(target - eye));
    const vector right = l3d_normalized(l3d_cross<double>(forward, up));
    const vector above = l3d_cross<double>(right, forward);
    const double focal = height / 2.0 / std::tan(19 * std::numbers::pi / 180); // fov 38 degrees
    l3d_image_patch result;
    for (std::size_t i = 0; i < 16; ++i) {
        const vector p = patch.points[i] - eye;
        result.points[i] = {focal * l3d_dot(right, p), -focal * l3d_dot(above, p),
                            l3d_dot(forward, p)};
    }
    return result;
}

inline std::vector<l3d_image_patch> teapot_in_view_full(const std::string& path) {
    std::vector<l3d_image_patch> result;
    for (const auto& patch : teapot(path))
        result.push_back(in_view_full(patch));
    return result;
}

/// Steps of a walk: along u and along v.
struct steps {
    int u = 1, v = 1;
};

/// The least steps of at most one pixel, as a lattice of 33 by 33 derivatives tells.
inline steps steps_of_one_pixel(const l3d_image_patch& patch) {
    double fastest_u = 1, fastest_v = 1;
    for (int i = 0; i <= 32; ++i)
        for (int j = 0; j <= 32; ++j) {
            const auto [by_u, by_v] =
                l3d_rational_derivatives<double, 3>(patch, i / 32.0, j / 32.0);
            fastest_u = std::max(fastest_u, std::hypot(by_u[0], by_u[1]));
            fastest_v = std::max(fastest_v, std::hypot(by_v[0], by_v[1]));
        }
    return {static_cast<int>(std::ceil(fastest_u)), static_cast<int>(std::ceil(fastest_v))};
}

/// Homogeneous points; (n.u + 1) columns of (n.v + 1) rows, column after column.
using points = std::vector<l3d_image_point>;

inline points exact_points(const l3d_image_patch& patch, steps n) {
    points result;
    for (int i = 0; i <= n.u; ++i) {
        const l3d_image_curve column = patch.curve_at_u(static_cast<double>(i) / n.u);
        for (int j = 0; j <= n.v; ++j)
            result.push_back(column.evaluate(static_cast<double>(j) / n.v));
    }
    return result;
}

/// Sixteen registers a coordinate across the whole patch: each column's differences are
/// themselves walked.
template <class T> points tensor_walk(const l3d_image_patch& patch, steps n) {
    points result(static_cast<std::size_t>((n.u + 1) * (n.v + 1)));
    for (int k = 0; k < 3; ++k) {
        std::array<double, 16> b;
        const l3d_image_patch across = patch.transposed();
        for (std::size_t i = 0; i < 16; ++i)
            b[i] = across.points[i][k];
        auto walk = l3d_forward_difference_surface<T>::build(b, n.v, n.u);
        std::size_t at = 0;
        for (int i = 0; i <= n.u; ++i, walk.step_v()) {
            auto column = walk.row();
            for (int j = 0; j <= n.v; ++j, column.step())
                result[at++][k] = l3d_to_double(column.value());
        }
    }
    return result;
}

/// The curve's stretch from t0 to t1.
inline l3d_image_curve stretch(const l3d_image_curve& curve, double t0, double t1) {
    const auto below = [](const l3d_image_curve& c, double t) {
        const auto& p = c.points;
        const auto mix = [t](const l3d_image_point& a, const l3d_image_point& b) {
            return l3d_lerp<double, 3>(a, b, t);
        };
        const l3d_image_point a = mix(p[0], p[1]), b = mix(p[1], p[2]), d = mix(p[2], p[3]);
        const l3d_image_point ab = mix(a, b), bd = mix(b, d);
        return l3d_image_curve{{p[0], a, ab, mix(ab, bd)}};
    };
    const l3d_image_curve low = below(curve, t1);
    return t0 == 0 ? low : below(low.reversed(), 1 - t0 / t1).reversed();
}

/// Isocurves, each started from the exact curve, and started anew after every `strip` steps.
template <class T, int strip> points isocurve_walk(const l3d_image_patch& patch, steps n) {
    points result;
    for (int i = 0; i <= n.u; ++i) {
        const l3d_image_curve column = patch.curve_at_u(static_cast<double>(i) / n.u);
        for (int start = 0; start < n.v; start += strip) {
            const int end = std::min(start + strip, n.v);
            const l3d_image_curve part =
                stretch(column, static_cast<double>(start) / n.v, static_cast<double>(end) / n.v);
            std::array<l3d_forward_difference<T, 3>, 3> walk;
            for (std::size_t k = 0; k < 3; ++k) {
                std::array<double, 4> b;
                for (std::size_t c = 0; c < 4; ++c)
                    b[c] = part.points[c][static_cast<int>(k)];
                walk[k] = l3d_forward_difference<T, 3>::build(b, end - start);
            }
            for (int j = start; j < end || (j == n.v && end == n.v); ++j) {
                result.emplace_back(l3d_to_double(walk[0].value()), l3d_to_double(walk[1].value()),
                                    l3d_to_double(walk[2].value()));
                for (auto& coordinate : walk)
                    coordinate.step();
            }
        }
    }
    return result;
}

/// Distances in the image between walked and exact points. Units: pixels.
class error_statistics {
public:
    /// A walked point with w <= 0 is nowhere in the picture: infinitely far off.
    void add(const points& exact, const points& walked) {
        for (std::size_t i = 0; i < exact.size(); ++i) {
            const l3d_image_point &e = exact[i], &w = walked.at(i);
            const double dx = w[0] / w[2] - e[0] / e[2], dy = w[1] / w[2] - e[1] / e[2];
            errors_.push_back(w[2] > 0 ? static_cast<float>(std::hypot(dx, dy))
                                       : std::numeric_limits<float>::infinity());
        }
    }

    std::size_t count() const { return errors_.size(); }

    /// The error that `part` (0 to 1) of the points do not exceed.
    double quantile(double part) {
        const auto at = static_cast<std::ptrdiff_t>(part * static_cast<double>(count() - 1));
        std::nth_element(errors_.begin(), errors_.begin() + at, errors_.end());
        return errors_[static_cast<std::size_t>(at)];
    }

    /// Of the points that are anywhere.
    double mean() const {
        double sum = 0;
        std::size_t finite = 0;
        for (const float e : errors_)
            if (std::isfinite(e)) {
                sum += e;
                ++finite;
            }
        return sum / static_cast<double>(finite);
    }

    /// The part of the points that is farther off than `limit`.
    double beyond(double limit) const {
        const auto far =
            std::count_if(errors_.begin(), errors_.end(), [limit](float e) { return e > limit; });
        return static_cast<double>(far) / static_cast<double>(count());
    }

private:
    std::vector<float> errors_;
};

/// A way of walking a patch.
struct method {
    const char* number;
    const char* way;
    points (*walk)(const l3d_image_patch& patch, steps n);
};

inline constexpr int whole_curve = std::numeric_limits<int>::max() / 2;
inline constexpr int short_strip = 16;

/// Every number type across whole patches, along whole isocurves, and in strips of 16 steps.
inline std::vector<method> methods() {
    using fixed_16 = l3d_fixed<std::int32_t, 16>;
    using fixed_32 = l3d_fixed<std::int64_t, 32>;
    return {{"16.16", "tensor", tensor_walk<fixed_16>},
            {"16.16", "isocurves", isocurve_walk<fixed_16, whole_curve>},
            {"16.16", "strips of 16", isocurve_walk<fixed_16, short_strip>},
            {"float", "tensor", tensor_walk<float>},
            {"float", "isocurves", isocurve_walk<float, whole_curve>},
            {"float", "strips of 16", isocurve_walk<float, short_strip>},
            {"32.32", "tensor", tensor_walk<fixed_32>},
            {"32.32", "isocurves", isocurve_walk<fixed_32, whole_curve>},
            {"32.32", "strips of 16", isocurve_walk<fixed_32, short_strip>}};
}

inline void print_header() {
    std::printf("    %-6s %-12s %10s %10s %10s %8s\n", "", "error in px:", "median", "mean", "most",
                ">1 px");
}

inline void print_row(const method& m, error_statistics& errors) {
    std::printf("    %-6s %-12s %10.2g %10.2g %10.2g %7.1f%%\n", m.number, m.way,
                errors.quantile(0.5), errors.mean(), errors.quantile(1), 100 * errors.beyond(1));
}

} // namespace fixed_failure

#endif
