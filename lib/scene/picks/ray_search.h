// SPDX-License-Identifier: MIT
// l3d_ray_search: finds the nearest point of bicubic patches on a ray.
#ifndef L3D_SCENE_PICKS_RAY_SEARCH_H
#define L3D_SCENE_PICKS_RAY_SEARCH_H

#include "geom/patch_part.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

/// A patch's net as a ray sees it. Coordinates 0 and 1 are zero on the ray, and coordinate 2 is the
/// depth along the ray. So w() is the patch's range of depths.
using l3d_ray_net = l3d_image_net;

/// A place where the ray meets a patch.
struct l3d_ray_hit {
    std::size_t patch = 0; ///< the number that the patch got in add()
    double u = 0, v = 0;   ///< the patch's parameters at the hit, from 0 to 1
    double u_error = 0, v_error = 0;
    double depth = 0;
    bool is_proven = false; ///< whether Krawczyk's operator proves the hit
    /// For an unproven hit: the largest extent of the surface that cannot be told apart from the
    /// ray, and its range of depths.
    double width = 0, depth_width = 0;
};

/// Finds the nearest hit of a ray among bicubic patches. Add all patches first, then ask for
/// nearest().
class l3d_ray_search {
public:
    /// `near` and `far` limit the depth of hits. A proven hit counts only if `is_seen` returns true
    /// for it.
    l3d_ray_search(double near, double far, std::function<bool(const l3d_ray_hit&)> is_seen)
        : near_(near), far_(far), is_seen_(std::move(is_seen)) {}

    /// Adds a patch under a number. `error` bounds the rounding of the net's coordinates, and the
    /// rounding that halving and evaluating it add.
    void add(std::size_t patch, const l3d_ray_net& net, double error);

    std::optional<l3d_ray_hit> nearest();

private:
    /// A whole patch, as it was added.
    struct root {
        std::size_t patch;
        l3d_ray_net net;
        double error;
    };
    /// A part of a patch, or a hit that was found in it.
    struct part : l3d_patch_part {
        std::size_t root = 0;
        double least_depth = 0;
        std::optional<l3d_ray_hit> hit;
    };

    bool may_be_met(const l3d_ray_net& net, double error) const;
    void push(part one, const std::optional<l3d_ray_hit>& hit = std::nullopt);
    part pop();
    void look_into(const part& one);
    void split(const part& one);
    bool settle(const part& one);
    void keep_unproven(const part& one);
    l3d_ray_hit joined(l3d_ray_hit first);

    double near_, far_;
    std::function<bool(const l3d_ray_hit&)> is_seen_;
    std::vector<root> roots_;
    std::vector<part> heap_; ///< parts still to be searched, the least depth first
    long steps_ = 0;
};

#endif
