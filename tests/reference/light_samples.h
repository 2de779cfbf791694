// SPDX-License-Identifier: MIT
// The light that the exact surface sends along single lines of sight.
#ifndef L3D_REFERENCE_LIGHT_SAMPLES_H
#define L3D_REFERENCE_LIGHT_SAMPLES_H

#include "reference/exact.h"
#include "reference/hits.h"
#include "reference/second_judge.h"

#include <limits>
#include <span>
#include <vector>

namespace reference {

/// The surface point and the light that are seen along one line of sight.
struct light_sample {
    double w = std::numeric_limits<double>::infinity(); ///< distance along the view axis
    vec3 place, normal;                                 ///< along right, up and forward; unit
    double level = 0;                                   ///< encoded, 0 to 255, not rounded
    double light = 0;                                   ///< linear, 0 to 1
    /// The distance of the next surface behind this one's tangent plane, in pixels. It is more than
    /// 1e-3, so that no surface is found twice. Only samples of a grid have it.
    double gap = std::numeric_limits<double>::infinity();
    bool covered() const { return w < std::numeric_limits<double>::infinity(); }
};

/// A lamp in one channel, so far away that its rays are parallel.
struct lamp {
    vec3 direction;      ///< towards the lamp, of any length but zero; world space
    double strength = 1; ///< share of white
};

/// Light by Blinn's rule in one channel, with an exact half-way vector for each line of sight. The
/// encoded level is the smaller of 255 and
///
///     255 (color (ambient + 0.9 sum s max(0, n.l)) + highlight sum s max(0, n.h)^sharpness),
///
/// with sums over all lamps with n.l > 0; s is a lamp's strength.
struct lamp_light {
    double color = 1, highlight = 0; ///< shares of white
    int sharpness = 1;
    double ambient = 0.1;
    std::vector<lamp> lamps;
    /// Fog hides nothing up to the distance fog_near along the view axis, and all from fog_far on.
    /// Between them, its level and the surface's are mixed in proportion. There is no fog if both
    /// are equal.
    double fog_near = 0, fog_far = 0, fog_level = 0;
};

/// Converts levels of 255, encoded by the sRGB curve, to linear light from 0 to 1, and back.
double light_of_level(double level);
double level_of_light(double light);

/// Samples the light along lines of sight.
/// Expects: patches, camera and light as box_image does; the patches outlive the sampler.
class light_sampler {
public:
    light_sampler(std::span<const patch> patches, const camera& view, picture_size size, vec3 light,
                  double background);
    /// Replaces the light by lamps, if there are any.
    void take(const lamp_light& lamps);

    /// The samples at all places of a grid. Shape: row by row. Cost: some us per sample.
    std::vector<light_sample> grid(const sample_grid& places) const;
    /// The sample along one line of sight, by the second judge. If the line grazes a surface, so
    /// that the judge gives up, it is moved by up to 1.7e-7 px. Units: pixels.
    /// Errors:  std::runtime_error if the judge gives up there, too.
    light_sample look(double x, double y) const;

    /// Whether an edge may pass between two places that lie next to each other. Then only one of
    /// them is covered, or the normal turns by 3 degrees, or one is 0.1 px off the other's tangent
    /// plane.
    bool differ(const light_sample& p, const light_sample& q) const;

private:
    light_sample seen(double x, double y, double w, const vec3& world_normal) const;
    vec3 to_axes(const vec3& world) const;
    double level_by_lamps(const vec3& normal, const vec3& place) const;

    std::span<const patch> patches_;
    camera view_;
    camera_frame frame_;
    double focal_;
    std::vector<net> nets_;
    second_judge judge_;
    vec3 light_;       ///< unit, along the axes
    lamp_light lamps_; ///< their directions are unit, along the axes
    light_sample nothing_;
};

} // namespace reference

#endif
