// SPDX-License-Identifier: MIT
// How far a picture point is from what the exact surface covers, and from what it does not.
#ifndef L3D_REFERENCE_REGION_H
#define L3D_REFERENCE_REGION_H

#include "reference/exact.h"
#include "reference/hits.h"

#include <limits>
#include <span>
#include <stop_token>
#include <vector>

namespace reference {

/// The part of the picture plane that the patches cover, also outside of the window. It is the
/// union of the images of all surface points with w >= near.
///
/// Errors:  distances throw std::runtime_error if they need more than 200000 pieces, or if told to
///          stop. They may need so many if the near plane cuts a surface that reaches a million
///          times as far.
/// Shape: holds the patches cut into pieces of about 32 pixels.
class exact_region {
public:
    exact_region(std::span<const patch> patches, const camera& view, picture_size size,
                 std::stop_token stop = {});

    bool covers(double x, double y) const;

    /// The least distance from the picture point to the image of any patch; 0 if the point is
    /// covered, infinite if there is no image. Units: pixels; too large by 1e-4 at most.
    double distance_to_exact_surface(double x, double y) const;

    /// A proved lower bound of the distance to the nearest point of any outline: patch boundary,
    /// silhouette or near plane. Seams inside the region count, too. The bound is short of the
    /// distance by at most 2e-3.
    double distance_to_outline(double x, double y) const;

    /// Bounds of a distance. `lower` is that of distance_to_outline. `upper` is the distance of an
    /// uncovered point that was found. It is about 1 % too large unless the uncovered part is a
    /// sliver.
    struct interval {
        double lower = 0, upper = std::numeric_limits<double>::infinity();
    };
    /// The distance to the nearest uncovered point. Both bounds are 0 if the point itself is
    /// uncovered; `upper` is infinite if no uncovered point was found within `limit`.
    interval distance_to_uncovered(double x, double y, double limit = 32) const;

private:
    struct piece {
        net surface;
        rect box;
        bool bounded; ///< false: the piece reaches w <= 0, and has no box
    };
    void add(const net& surface, const rect& window, int depth);
    double nearest_gap(double x, double y, double radius) const;

    double near_;
    std::stop_token stop_;
    std::vector<piece> pieces_;
};

} // namespace reference

#endif
