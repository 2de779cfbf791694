// SPDX-License-Identifier: MIT
// l3d_afd_complaint: names values with which no frame of patches can be drawn.
#include "pipeline/afd/pipeline_afd_p.h"

#include "base/formatted_p.h"
#include "raster/parallel/workers.h"

#include <cmath>
#include <limits>
#include <string>

namespace {

constexpr double largest = std::numeric_limits<double>::max();

std::string fog_complaint(const l3d_afd_settings& settings) {
    const l3d_fog& fog = settings.fog;
    if (fog == l3d_fog())
        return "";
    if (!(fog.from >= 0 && fog.to > fog.from && std::isfinite(fog.to)))
        return l3d_detail::formatted("fog: %f to %f are not two distances, the nearer first",
                                     fog.from, fog.to);
    if (!settings.method.is_default())
        return "fog: " + settings.method.name() + " draws without";
    if (l3d_has_scale(settings.shade))
        return "fog: colours of a scale would no longer be those of the scale";
    if (!fog.color && settings.background.is_none())
        return "fog: without a background it needs a colour";
    return "";
}

std::string section_complaint(const l3d_afd_settings& settings) {
    if (!settings.section)
        return "";
    const l3d_plane<double>& plane = *settings.section;
    constexpr double rounding = 1e-9;
    if (!(std::abs(l3d_length(plane.normal) - 1) < rounding && std::isfinite(plane.d)))
        return "section: the plane has no unit normal, or no place";
    if (!settings.method.is_default())
        return "section: " + settings.method.name() + " draws whole surfaces alone";
    return "";
}

} // namespace

std::string l3d_detail::numbers_complaint(const l3d_camera& camera, l3d_size size,
                                          const l3d_afd_settings& settings) {
    const std::string most = std::to_string(l3d_largest_side);
    if (size.width < 1 || size.height < 1 || size.width > l3d_largest_side ||
        size.height > l3d_largest_side)
        return "picture: " + std::to_string(size.width) + 'x' + std::to_string(size.height) +
               " is not within 1x1 and " + most + 'x' + most;
    if (!(settings.tolerance > 0 && settings.tolerance <= l3d_largest_side))
        return "tolerance: " + std::to_string(settings.tolerance) + " px is not within 0 and " +
               most;
    if (!(settings.shade_tolerance > 0 && settings.shade_tolerance <= 255))
        return "shade tolerance: " + std::to_string(settings.shade_tolerance) +
               " levels is not within 0 and 255";
    const double length = l3d_length(settings.light);
    if (!(length > 0 && length <= largest))
        return "light: no direction";
    if (settings.most_samples < 0)
        return "most samples: " + std::to_string(settings.most_samples) + " is negative";
    if (settings.shade == l3d_shade::own && !settings.own.colors)
        return "own: shade 'own' needs a function that gives colours";
    return camera.complaint();
}

std::string l3d_afd_complaint(const l3d_camera& camera, l3d_size size,
                              const l3d_afd_settings& settings) {
    if (const std::string why = l3d_detail::numbers_complaint(camera, size, settings); !why.empty())
        return why;
    if (const std::string why = l3d_threads_complaint(settings.threads); !why.empty())
        return why;
    if (settings.shade == l3d_shade::error && !settings.method.has_bound())
        return "shade: error shows a bound of the error, and " + settings.method.name() +
               " has none";
    if (const std::string why = fog_complaint(settings); !why.empty())
        return why;
    if (const std::string why = section_complaint(settings); !why.empty())
        return why;
    if (camera.is_parallel() && !settings.method.draws_parallel())
        return "parallel projection: " + settings.method.name() + " draws perspective alone";
    if (!l3d_sees_patches(settings.shade))
        return "";
    if (!settings.method.is_default())
        return "shade: " + settings.method.name() + " has no exact derivatives to inspect";
    const double reach = l3d_length(settings.inspection.direction);
    if (!(reach > 0 && reach <= largest))
        return "inspection: no direction";
    if (!(settings.inspection.scale >= 0 && settings.inspection.scale <= largest))
        return "inspection: the scale " + std::to_string(settings.inspection.scale) +
               " is not within 0 and all numbers";
    if (!(settings.inspection.stripe > 0 && settings.inspection.stripe <= 180))
        return "inspection: stripes of " + std::to_string(settings.inspection.stripe) +
               " degrees are not within 0 and 180";
    return "";
}
