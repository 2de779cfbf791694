// SPDX-License-Identifier: MIT
// inspection_shader: finds points by Newton's method, and how normals change between pixels.
#include "raster/shaders/inspection_shader_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace l3d_detail {

namespace {

using vector = l3d_inspected_patches::vector;

constexpr double degrees = 180 / std::numbers::pi;

/// The distance of a point from the ray through a pixel, along the picture's axes. For a direction,
/// it is the change of this distance along the direction.
struct offset {
    double x, y;
    offset(const vector& of, const vector& ray)
        : x(of[0] - ray[0] * of[2]), y(of[1] - ray[1] * of[2]) {}
};

/// The inverse of the map from small steps of parameters to a point's offset.
class parameter_steps {
public:
    parameter_steps(const l3d_patch_place& at, const vector& ray)
        : u_(at.along_u, ray), v_(at.along_v, ray), determinant_(u_.x * v_.y - v_.x * u_.y) {}

    /// Whether the inverse exists in spite of rounding.
    bool exists() const {
        constexpr double least = 0x1p-40;
        return std::abs(determinant_) > least * (std::abs(u_.x * v_.y) + std::abs(v_.x * u_.y));
    }
    double of_u(double x, double y) const { return (v_.y * x - v_.x * y) / determinant_; }
    double of_v(double x, double y) const { return (u_.x * y - u_.y * x) / determinant_; }

private:
    offset u_, v_;
    double determinant_;
};

/// The change of an angle for a change of its cosine. At 0 and at 180 degrees, this change has no
/// bound. Stripes are widest at these angles, so the bound of 1 / `least` is enough.
double angle_change(double cosine, double change) {
    constexpr double least = 1e-4;
    return change / std::max(std::sqrt(std::max(0.0, 1 - cosine * cosine)), least);
}

} // namespace

patch_parameters seen_parameters(const l3d_inspected_patches& frame,
                                 const l3d_bezier_patch<double, 3>& net, double x, double y,
                                 double u, double v) {
    const vector ray = frame.ray(x, y);
    // Each step doubles the number of exact digits. A guess is at most a part of a quad away.
    constexpr int most_steps = 12;
    constexpr double farthest = 0.5; // from the guess; points further away are on another sheet
    constexpr double exact = 1e-6;   // pixels: the largest offset that may remain
    const patch_parameters guess{std::clamp(u, 0.0, 1.0), std::clamp(v, 0.0, 1.0)};
    patch_parameters at = guess;
    double first_miss = std::numeric_limits<double>::infinity();
    for (int i = 0; i < most_steps; ++i) {
        const l3d_patch_place place = l3d_place_of(net, at.u, at.v);
        if (!(place.point[2] > 0))
            return guess;
        const offset off(place.point, ray);
        const double miss = frame.focal * std::hypot(off.x, off.y) / place.point[2];
        if (i == 0)
            first_miss = miss;
        at.is_solved = miss <= exact;
        const parameter_steps steps(place, ray);
        if (at.is_solved || !steps.exists())
            break;
        // A pixel beside a border may show the border itself.
        const patch_parameters next{std::clamp(at.u - steps.of_u(off.x, off.y), 0.0, 1.0),
                                    std::clamp(at.v - steps.of_v(off.x, off.y), 0.0, 1.0)};
        const bool is_border = next.u == at.u || next.v == at.v;
        const bool stays = std::abs(next.u - at.u) <= 0x1p-30 && std::abs(next.v - at.v) <= 0x1p-30;
        at = {next.u, next.v, stays && is_border && miss <= first_miss};
        if (at.is_solved || std::abs(at.u - guess.u) > farthest ||
            std::abs(at.v - guess.v) > farthest)
            break;
    }
    const bool is_near =
        std::abs(at.u - guess.u) <= farthest && std::abs(at.v - guess.v) <= farthest;
    return at.is_solved && is_near ? at : guess;
}

/// The eye's view of a patch, and its change from a pixel to the next ones.
struct inspection_shader::sight {
    vector ray; ///< unit vector from the eye to the patch's point
    /// The change of `ray` to the next pixel on the right, and to the next below.
    std::array<vector, 2> ray_change;
    l3d_patch_bend bend; ///< normal and curvature of the patch; the normal is turned to the eye
    std::array<vector, 2> turn; ///< the change of the normal over the same two steps
};

/// The view of a point of the patch. The result is empty where the surface has no normal.
std::optional<inspection_shader::sight> inspection_shader::look_at(patch_parameters at, double x,
                                                                   double y) const {
    const l3d_patch_jet jet = l3d_jet_of(*net_, at.u, at.v);
    const auto bend = l3d_bend_of(jet);
    if (!bend)
        return std::nullopt;
    sight result;
    const vector ray = patches_.ray(x, y);
    const double inverse = 1 / std::sqrt(l3d_dot(ray, ray));
    result.ray = ray * inverse;
    result.bend = *bend;
    if (l3d_dot(bend->normal, ray) > 0) {
        result.bend.normal = -bend->normal;
        result.bend.normal_u = -bend->normal_u;
        result.bend.normal_v = -bend->normal_v;
        result.bend.mean = -bend->mean;
    }
    // From pixel to pixel, the seen point moves by its distance over the focal length.
    const parameter_steps steps(jet, ray);
    const double pixel = jet.point[2] / patches_.focal;
    for (std::size_t i = 0; i < 2; ++i) {
        const double right = i == 0 ? pixel : 0, down = i == 0 ? 0 : pixel;
        const double du = steps.of_u(right, down), dv = steps.of_v(right, down);
        result.turn[i] = result.bend.normal_u * du + result.bend.normal_v * dv;
        vector change{0.0, 0.0, 0.0};
        change[static_cast<int>(i)] = inverse / patches_.focal;
        result.ray_change[i] = change - result.ray * l3d_dot(result.ray, change);
    }
    return result;
}

/// The colour of a stripe of `zebra` or `isophotes`. This colour is the mean over the pixel, as if
/// the angle changed linearly in it.
std::uint32_t inspection_shader::stripe(const sight& of) const {
    const vector& n = of.bend.normal;
    const bool is_zebra = shading_.mode == l3d_shade::zebra;
    const double against = l3d_dot(of.ray, n);
    const vector& towards = is_zebra ? patches_.direction : patches_.light;
    const vector seen = is_zebra ? of.ray - n * (2 * against) : n;
    const double cosine = std::clamp(l3d_dot(seen, towards), -1.0, 1.0);
    std::array<double, 2> changes{};
    for (std::size_t i = 0; i < 2; ++i) {
        const vector &dn = of.turn[i], &dray = of.ray_change[i];
        const vector change = is_zebra ? dray - n * (2 * (l3d_dot(dray, n) + l3d_dot(of.ray, dn))) -
                                             dn * (2 * against)
                                       : dn;
        changes[i] = std::abs(angle_change(cosine, l3d_dot(change, towards))) * degrees;
    }
    return l3d_stripe_color(std::acos(cosine) * degrees, changes[0], changes[1],
                            shading_.inspection.stripe);
}

patch_parameters patch_shader::solved(const float* guess, double x, double y) const {
    const auto held = [&](std::size_t i) {
        return double{std::clamp(guess[i], least_[i], most_[i])};
    };
    return seen_parameters(patches_, *net_, x, y, held(0), held(1));
}

std::uint32_t inspection_shader::word_at(const float* guess, double x, double y) {
    return word_of(solved(guess, x, y), x, y);
}

std::uint32_t inspection_shader::word_around(const float* guess, double x, double y) {
    const double middle_x = std::floor(x) + 0.5, middle_y = std::floor(y) + 0.5;
    const patch_parameters at = solved(guess, middle_x, middle_y);
    return at.is_solved ? word_of(at, middle_x, middle_y) : word_at(guess, x, y);
}

std::uint32_t inspection_shader::word_of(patch_parameters place, double x, double y) {
    auto seen = look_at(place, x, y);
    if (!seen) {
        // At a pole, where a side is a single point, the nearest normals are a little inside of the
        // patch.
        constexpr double inside = 0x1p-10;
        place.u += inside * (0.5 - place.u);
        place.v += inside * (0.5 - place.v);
        place.is_solved = false;
        seen = look_at(place, x, y);
    }
    unsolved_ += !place.is_solved;
    const l3d_inspection& inspection = shading_.inspection;
    if (!seen)
        return l3d_inspection_color(l3d_shade::draft, std::numeric_limits<double>::quiet_NaN(), 1);
    switch (shading_.mode) {
    case l3d_shade::gaussian:
        return l3d_inspection_color(shading_.mode, seen->bend.gaussian, inspection.scale);
    case l3d_shade::mean:
        return l3d_inspection_color(shading_.mode, seen->bend.mean, inspection.scale);
    case l3d_shade::draft: {
        const double sine = std::clamp(l3d_dot(seen->bend.normal, patches_.direction), -1.0, 1.0);
        return l3d_inspection_color(shading_.mode, std::asin(sine) * degrees, inspection.scale);
    }
    default:
        return stripe(*seen);
    }
}

} // namespace l3d_detail
