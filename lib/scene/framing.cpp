// SPDX-License-Identifier: MIT
// l3d_framed: lays four planes through the eye that touch the model.
#include "scene/camera.h"

#include "geom/transform.h"
#include "scene/patch_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace {

using vector = l3d_camera::vector;

constexpr double least_share = 0.6;

/// The largest error of a reach, as a part of the span of the control points.
constexpr double reach_error = 1e-4;
/// The largest number of times that a patch is quartered. Two times bring control points 16 times
/// nearer to the patch, so 7 times are more than enough.
constexpr int most_cuts = 7;

/// Dot products of a direction with the control points of a patch, or of a part of a patch.
using heights = std::array<double, 16>;

double corner_most(const heights& h) {
    return std::max({h[0], h[3], h[12], h[15]});
}

/// Halves a cubic by de Casteljau's scheme. Its four control values are `step` elements apart.
void halve(const double* from, double* low, double* high, std::size_t step) {
    const double ab = (from[0] + from[step]) / 2, bc = (from[step] + from[2 * step]) / 2;
    const double cd = (from[2 * step] + from[3 * step]) / 2;
    const double abc = (ab + bc) / 2, bcd = (bc + cd) / 2, middle = (abc + bcd) / 2;
    low[0] = from[0], low[step] = ab, low[2 * step] = abc, low[3 * step] = middle;
    high[0] = middle, high[step] = bcd, high[2 * step] = cd, high[3 * step] = from[3 * step];
}

std::array<heights, 4> quarters(const heights& whole) {
    std::array<heights, 2> halves;
    for (std::size_t row = 0; row < 16; row += 4)
        halve(&whole[row], &halves[0][row], &halves[1][row], 1);
    std::array<heights, 4> result;
    for (std::size_t half = 0; half < 2; ++half)
        for (std::size_t column = 0; column < 4; ++column)
            halve(&halves[half][column], &result[2 * half][column], &result[2 * half + 1][column],
                  4);
    return result;
}

/// Finds the largest height of all patches along a direction. Only parts whose control points are
/// above the highest surface point so far are cut.
class highest {
public:
    void add(const heights& patch) {
        for (const double height : patch) {
            most_ = std::max(most_, height);
            least_ = std::min(least_, height);
        }
        if (*std::ranges::max_element(patch) > found_)
            parts_.push_back(patch);
        found_ = std::max(found_, corner_most(patch));
    }

    double height() {
        const double error = (most_ - least_) * reach_error;
        for (int cut = 0; cut < most_cuts && !parts_.empty(); ++cut) {
            std::erase_if(parts_, [&](const heights& part) {
                return *std::ranges::max_element(part) <= found_ + error;
            });
            std::vector<heights> smaller;
            for (const heights& part : parts_)
                for (const heights& quarter : quarters(part)) {
                    found_ = std::max(found_, corner_most(quarter));
                    smaller.push_back(quarter);
                }
            parts_ = std::move(smaller);
        }
        return std::min(found_ + error, most_);
    }

private:
    std::vector<heights> parts_;
    double found_ = -std::numeric_limits<double>::infinity();
    double most_ = found_, least_ = -found_;
};

double reach_along(const l3d_patch_scene& scene, const vector& direction) {
    highest found;
    for (const l3d_patch_instance& instance : scene.instances()) {
        if (instance.opacity() == 0) // it is invisible
            continue;
        // The direction in the model's coordinates, and the height of their origin.
        const auto in_model =
            l3d_transposed(instance.placement()) * l3d_vector<double, 4>(direction, 0.0);
        for (const l3d_patch_model::patch& patch : instance.model().patches()) {
            heights patch_heights;
            for (std::size_t i = 0; i < 16; ++i)
                patch_heights[i] = l3d_dot(vector(in_model), patch.points[i]) + in_model[3];
            found.add(patch_heights);
        }
    }
    return found.height();
}

/// A model between two planes that meet in the eye. The planes are left and right of the model, or
/// below and above it. `slope` is the tangent of each plane's angle to the line of sight. The
/// planes of an eye at place `at` and `depth` hold the model if at - slope depth >= most and at +
/// slope depth <= least.
struct wedge {
    double slope, most, least;

    wedge(const vector& side, const vector& forward, double tangent, const l3d_reach& reach)
        : slope(tangent), most(reach(side - forward * tangent)),
          least(-reach(-side - forward * tangent)) {}

    /// The largest depth of an eye whose planes hold the model.
    double deepest() const { return (least - most) / (2 * slope); }
    /// The sideways place of the deepest eye. Eyes farther away may move from this place equally
    /// far to both sides.
    double place() const { return (most + least) / 2; }
    bool holds(double at, double depth) const {
        return at - slope * depth >= most && at + slope * depth <= least;
    }
};

struct wedges {
    wedge across, along;

    wedges(const l3d_camera::frame& axes, const l3d_camera& camera, l3d_size size, double share,
           const l3d_reach& reach)
        : across(axes.right, axes.forward, share * size.width / 2.0 / camera.focal_length(size),
                 reach),
          along(axes.up, axes.forward, share * size.height / 2.0 / camera.focal_length(size),
                reach) {}

    double deepest() const { return std::min(across.deepest(), along.deepest()); }
};

/// Whether a model lies at one side of the picture. It reaches beyond nine tenths of the half on
/// this side, and nowhere beyond two thirds of the other half. `slope` is the tangent of the
/// border's angle.
bool is_aside(const vector& side, const l3d_camera::frame& axes, const l3d_camera& camera,
              double slope, const l3d_reach& reach) {
    const double depth = l3d_dot(camera.eye, axes.forward), at = l3d_dot(camera.eye, side);
    const auto reaches = [&](double sign, double tangent) {
        return reach(side * sign - axes.forward * tangent) > sign * at - tangent * depth;
    };
    constexpr double near_border = 0.9, much_room = 0.66;
    return (reaches(1, near_border * slope) && !reaches(-1, much_room * slope)) ||
           (reaches(-1, near_border * slope) && !reaches(1, much_room * slope));
}

/// The depths at which a model begins and ends along the line of sight, counted from the world's
/// origin.
struct depths {
    double nearest, farthest;

    depths(const vector& forward, const l3d_reach& reach)
        : nearest(-reach(-forward)), farthest(reach(forward)) {}

    bool empty() const { return !(nearest <= farthest); }
    double middle() const { return (nearest + farthest) / 2; }

    bool is_flat() const { return nearest == farthest; }

    /// The least distance of the eye from the model that framing allows. A model without any size
    /// may be seen from anywhere.
    double least_distance() const {
        const double size = (farthest - nearest) * 1e-6;
        const double largest = std::max(std::abs(nearest), std::abs(farthest));
        return size > 0 ? size : largest > 0 ? largest : 1;
    }
};

/// The camera with eye and target at these depths, on the line of sight through the place `line`.
/// The eye is moved into its allowed range. Returns nothing if the eye is too near to the target,
/// as for tiny models.
/// Expects: the model begins at depth `nearest`.
std::optional<l3d_camera> placed(const l3d_camera& camera, const vector& line, double eye,
                                 double target, double nearest) {
    l3d_camera result = camera;
    const vector forward = camera.axes().forward;
    result.target = line + forward * target;
    result.eye = line + forward * eye;
    const vector arm = result.eye - result.target;
    double part = 1;
    for (int i = 0; i < 3; ++i)
        if (std::abs(result.eye[i]) > l3d_farthest_eye)
            part = std::min(part,
                            (std::copysign(l3d_farthest_eye, arm[i]) - result.target[i]) / arm[i]);
    if (part < 1) // a little less, so that rounding stays inside
        result.eye = result.target + arm * (part * (1 - 0x1p-40));
    // Depth is kept as 1 / distance in floats, which are as exact near the eye as far from it.
    const double near = std::min(1e-3 * (target - eye), 0.5 * (nearest - eye));
    result.near_z = std::clamp(near, l3d_least_distance, camera.near_z);
    return result.is_valid() ? std::optional(result) : std::nullopt;
}

/// Does what l3d_framed does in perspective. Returns nothing if no eye is near enough to a tiny
/// model.
/// Expects: the model is not empty.
std::optional<l3d_camera> framed_perspective(const l3d_camera& camera, l3d_size size,
                                             const l3d_reach& reach) {
    const l3d_camera::frame axes = camera.axes();
    const depths depth(axes.forward, reach);
    const wedges all(axes, camera, size, l3d_framed_share, reach);
    const double deepest = all.deepest();
    // The width or height of a flat model keeps the eye away from it, unless both are 0.
    const double eye = depth.is_flat() && deepest < depth.nearest
                           ? deepest
                           : std::min(deepest, depth.nearest - depth.least_distance());
    const vector line = axes.right * all.across.place() + axes.up * all.along.place();
    return placed(camera, line, eye, depth.middle(), depth.nearest);
}

/// Does what l3d_framed does in a parallel projection. Returns nothing if no eye is near enough to
/// a tiny model.
std::optional<l3d_camera> framed_parallel(const l3d_camera& camera, l3d_size size,
                                          const l3d_reach& reach) {
    const l3d_camera::frame axes = camera.axes();
    const depths depth(axes.forward, reach);
    const double left = -reach(-axes.right), right = reach(axes.right);
    const double bottom = -reach(-axes.up), top = reach(axes.up);
    const double pixel = std::max((right - left) / size.width, (top - bottom) / size.height);
    const double distance = pixel * camera.focal_length(size) / l3d_framed_share;
    const vector line = axes.right * ((left + right) / 2) + axes.up * ((bottom + top) / 2);
    const double eye = depth.middle() - (distance > 0 ? distance : depth.least_distance());
    return placed(camera, line, eye, depth.middle(), depth.nearest);
}

std::optional<l3d_camera> framed(const l3d_camera& camera, l3d_size size, const l3d_reach& reach) {
    return camera.is_parallel() ? framed_parallel(camera, size, reach)
                                : framed_perspective(camera, size, reach);
}

bool is_empty(const l3d_camera& camera, const l3d_reach& reach) {
    return depths(camera.axes().forward, reach).empty();
}

} // namespace

l3d_reach l3d_reach_of(const l3d_patch_scene& scene) {
    return [&scene](const vector& direction) { return reach_along(scene, direction); };
}

l3d_camera l3d_framed(const l3d_camera& camera, l3d_size size, const l3d_reach& reach) {
    return is_empty(camera, reach) ? camera : framed(camera, size, reach).value_or(camera);
}

bool l3d_shows_well(const l3d_camera& camera, l3d_size size, const l3d_reach& reach) {
    if (camera.is_parallel())
        return false;
    const l3d_camera::frame axes = camera.axes();
    const double depth = l3d_dot(camera.eye, axes.forward);
    const wedges whole(axes, camera, size, 1, reach), part(axes, camera, size, least_share, reach);
    return whole.across.holds(l3d_dot(camera.eye, axes.right), depth) &&
           whole.along.holds(l3d_dot(camera.eye, axes.up), depth) && part.deepest() <= depth &&
           !is_aside(axes.right, axes, camera, whole.across.slope, reach) &&
           !is_aside(axes.up, axes, camera, whole.along.slope, reach) &&
           depths(axes.forward, reach).nearest > depth + camera.near_z;
}

l3d_camera l3d_framed_unless_well(const l3d_camera& camera, l3d_size size, const l3d_reach& reach) {
    return l3d_shows_well(camera, size, reach) ? camera : l3d_framed(camera, size, reach);
}

namespace {

/// Facts about a model's picture in one direction, across or along: whether the model is beside the
/// picture, and whether it is within a pixel.
struct side_of_picture {
    bool is_beside, is_within_a_pixel;
};

/// Compares the model with the planes through the eye and two opposite sides of the picture.
/// `slope` is the tangent of the planes' angle with `forward`.
side_of_picture seen_along(const vector& side, const vector& forward, const vector& eye,
                           double slope, int pixels, const l3d_reach& reach) {
    const double at = l3d_dot(eye, side), depth = l3d_dot(eye, forward);
    const bool after = -reach(forward * slope - side) > at - slope * depth;
    const bool before = reach(side + forward * slope) < at + slope * depth;
    return {after || before, wedge(side, forward, slope / pixels, reach).deepest() > depth};
}

/// Compares the model with two parallel planes at the distance `half` to both sides of the eye.
side_of_picture seen_parallel(const vector& side, const vector& eye, double half, int pixels,
                              const l3d_reach& reach) {
    const double at = l3d_dot(eye, side), least = -reach(-side), most = reach(side);
    return {least > at + half || most < at - half, most - least < 2 * half / pixels};
}

} // namespace

std::string l3d_why_unseen(const l3d_camera& camera, l3d_size size, const l3d_reach& reach) {
    const bool is_parallel = camera.is_parallel();
    const l3d_camera::frame axes = camera.axes();
    const depths depth(axes.forward, reach);
    const double eye = l3d_dot(camera.eye, axes.forward);
    if (depth.empty())
        return "without any surface";
    if (!is_parallel && depth.farthest < eye)
        return "behind the eye";
    if (!is_parallel && depth.farthest < eye + camera.near_z)
        return "nearer than the near plane";
    if (!is_parallel && depth.nearest > eye + camera.far_z)
        return "beyond the far plane";
    const double distance = l3d_length(camera.target - camera.eye);
    const auto seen = [&](const vector& side, int pixels) {
        const double slope = pixels / 2.0 / camera.focal_length(size);
        return is_parallel ? seen_parallel(side, camera.eye, slope * distance, pixels, reach)
                           : seen_along(side, axes.forward, camera.eye, slope, pixels, reach);
    };
    const side_of_picture across = seen(axes.right, size.width), along = seen(axes.up, size.height);
    if (across.is_beside || along.is_beside)
        return "outside of the picture";
    if (!across.is_within_a_pixel || !along.is_within_a_pixel)
        return "";
    return framed(camera, size, reach) ? l3d_smaller_than_a_pixel : l3d_too_small;
}
