// SPDX-License-Identifier: MIT
// The verdict: a product's picture measured against the exact one.
#ifndef L3D_REFERENCE_MEASURE_H
#define L3D_REFERENCE_MEASURE_H

#include "reference/exact.h"
#include "reference/region.h"

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace reference {

/// The share of the pixels covered exactly whose depth is compared. Other pixels are at outlines,
/// jumps, sharp bends or the picture's border, or are not drawn at all.
inline double judged_share(std::int64_t compared, std::int64_t covered) {
    return covered > 0 ? static_cast<double>(compared) / static_cast<double>(covered) : 0;
}

/// How a product's picture compares with the exact one. Units: counts in pixels of the picture;
/// distances in pixels; relative = |w - w'| / w'.
struct measurement {
    std::int64_t covered_product = 0, covered_exact = 0;
    std::int64_t holes = 0;   ///< not drawn although it and its 8 neighbours are covered exactly
    std::int64_t missing = 0; ///< covered exactly, but not by the product (holes included)
    std::int64_t extra = 0;   ///< covered by the product only

    double max_extra_distance = 0;   ///< of an extra pixel's centre from the exact surface
    double max_missing_distance = 0; ///< of a missing pixel's centre from the exact outside
    bool distances_complete = true;  ///< false if there were more than `most_distances` to find

    std::int64_t depth_compared = 0; ///< pixels away from outlines and jumps of depth
    double depth_share() const { return judged_share(depth_compared, covered_exact); }
    double max_depth_relative = 0, mean_depth_relative = 0;
    double max_depth_px = 0, mean_depth_px = 0; ///< see depth_error_px
    int worst_depth_x = -1, worst_depth_y = -1; ///< where max_depth_px was found
};

/// The distance of the exact point of pixel (i, j) from the tangent plane at that of pixel (x, y).
/// Units:   pixels at the depth of (i, j); infinite if (x, y) has no normal.
/// Expects: both pixels are covered.
double tangent_distance_px(const exact_sample& plane, int x, int y, const camera_frame& frame,
                           const exact_sample& other, int i, int j);

/// The shortest displacement, in pixels, that explains a depth error. It is the distance of the
/// product's point from the exact tangent plane, where depth is measured in pixels, too (one pixel
/// = w / focal).
double depth_error_px(const exact_sample& exact, const camera_frame& frame, int x, int y, double w);

/// Compares the depths and the coverage of a product's picture with the exact picture.
/// Shape:   product_depth row by row, distance along the view axis, +inf (or 0) where nothing is.
/// Expects: product_depth of the exact picture's size; region of the same patches and camera.
measurement measure(std::span<const float> product_depth, const exact_image& exact,
                    const exact_region& region, int most_distances = 20000);

/// The error of each pixel. Shape: row by row; NaN where there is nothing to compare. Units:
/// pixels.
struct error_map {
    std::vector<float> depth; ///< away from outlines and jumps of depth, as `measure` compares it
    std::vector<float>
        outline; ///< distance from the exact outline, if only one picture covers the centre
    std::vector<bool> holes; ///< covered exactly all around, but not drawn as most neighbours are
    std::int64_t covered = 0, compared = 0; ///< pixels: by the exact picture; those with a depth
    double depth_share() const { return judged_share(compared, covered); }
};

/// Maps the errors of a product's picture. If more than some `most_distances` centres are covered
/// or uncovered falsely, an evenly spread part of them is measured.
/// Shape, Expects: as for measure.
/// Errors:  as exact_region, and std::runtime_error if told to stop.
error_map map_errors(std::span<const float> product_depth, const exact_image& exact,
                     const exact_region& region, int most_distances,
                     const std::stop_token& stop = {});

/// Differences of grey levels, on the pixels whose depth `measure` compares.
struct shade_difference {
    std::int64_t covered = 0, compared = 0; ///< pixels that the exact picture covers, and those
                                            ///< among them that are judged
    int max = 0;
    double mean = 0, rms = 0;
    double share() const { return judged_share(compared, covered); }
};
/// Compares grey levels with the exact picture's. Shape: product_grey row by row, one byte per
/// pixel; product_depth as for measure.
shade_difference measure_lambert(std::span<const unsigned char> product_grey,
                                 std::span<const float> product_depth, const exact_image& exact,
                                 vec3 light);

} // namespace reference

#endif
