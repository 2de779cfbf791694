// SPDX-License-Identifier: MIT
// l3d_facet_list: the steps from an object's polygons to pixels.
#include "pipeline/worlds/facet_list.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace {

/// Polygons are cut where they reach further than this from the picture's centre. Units: pixels.
/// Pictures have at most 2^14 pixels a side, so nothing seen is cut. Positions this large, times
/// 256 for the fractions of a pixel that rasterizers count in, are far from 2^31.
constexpr double farthest_pixel = 0x1p15;

/// A key that falls as depth rises: positive floats are ordered like their bits. Expects: depth >
/// 0.
std::uint32_t key_of(l3d_real depth) {
    return ~std::bit_cast<std::uint32_t>(static_cast<float>(l3d_to_double(depth)));
}

} // namespace

void l3d_facet_list::begin(const l3d_camera_left_handed<real>& camera, l3d_size size) {
    camera_ = camera;
    size_ = size;
    viewing_ = camera.viewing_transform();
    corners_.clear();
    polygons_.clear();
}

std::size_t l3d_facet_list::add(const l3d_object& object) {
    const l3d_matrix<real> to_camera = viewing_ * object.world_transform();
    const auto vertices = object.vertices();
    points_.clear();
    for (const l3d_point<real>& v : vertices)
        points_.push_back(l3d_transformed(to_camera, v));
    const l3d_polygon_mesh& mesh = object.mesh();
    for (std::size_t i = 0; i < mesh.faces(); ++i) {
        if (clip(mesh.face(i)))
            project(mesh.look_of(i).color);
        points_.resize(vertices.size()); // drops what clipping made
    }
    return vertices.size();
}

/// Clips a face: the rest is in `clipped_`; false if there is none.
bool l3d_facet_list::clip(std::span<const std::uint32_t> face) {
    const real far = l3d_from_double<real>(camera_.far_z);
    if (std::all_of(face.begin(), face.end(), [&](auto i) { return points_[i][2] > far; }) ||
        !l3d_clip_near_z(face, l3d_from_double<real>(camera_.near_z), points_, clipped_))
        return false;
    const real right = l3d_from_double<real>(camera_.fovx * size_.width / farthest_pixel);
    const real up = l3d_from_double<real>(camera_.fovy * size_.height / farthest_pixel);
    return clip_sideways(0, right) && clip_sideways(0, -right) && clip_sideways(1, up) &&
           clip_sideways(1, -up);
}

/// Cuts where a coordinate, times `scale`, exceeds z. The scale is small, so that fixed point does
/// not overflow here either; one that is negative is for the other side.
bool l3d_facet_list::clip_sideways(int axis, real scale) {
    const real zero = l3d_from_double<real>(0);
    const auto side = [&](std::uint32_t i) { return points_[i][2] - points_[i][axis] * scale; };
    const auto is_inside = [&](std::uint32_t i) { return !(side(i) < zero); };
    if (std::all_of(clipped_.begin(), clipped_.end(), is_inside))
        return true;
    const auto cut = [&](std::uint32_t inside, std::uint32_t outside) {
        points_.push_back(
            l3d_between(points_[inside], points_[outside], side(inside), side(outside)));
        return static_cast<std::uint32_t>(points_.size() - 1);
    };
    before_.swap(clipped_);
    return l3d_clip_to_plane<real>(before_, zero, side, cut, clipped_);
}

/// Adds the polygon in `clipped_`, unless it is beside the picture.
void l3d_facet_list::project(std::uint32_t color) {
    const std::size_t first = corners_.size();
    double left = std::numeric_limits<double>::max(), right = -left, top = left, bottom = -left;
    real depth = l3d_from_double<real>(0);
    for (const std::uint32_t corner : clipped_) {
        const auto pixel = camera_.project(points_[corner], size_);
        corners_.push_back({pixel.x, pixel.y});
        left = std::min(left, pixel.x);
        right = std::max(right, pixel.x);
        top = std::min(top, pixel.y);
        bottom = std::max(bottom, pixel.y);
        depth += points_[corner][2];
    }
    if (!(right >= 0 && left < size_.width && bottom >= 0 && top < size_.height))
        corners_.resize(first);
    else
        polygons_.push_back({first, clipped_.size(), color,
                             depth / l3d_from_double<real>(static_cast<double>(clipped_.size()))});
}

std::span<const l3d_point_2d> l3d_facet_list::corners(std::size_t which) const {
    return {corners_.data() + polygons_[which].first_corner, polygons_[which].corners};
}

void l3d_facet_list::draw(l3d_rasterizer_2d& rasterizer, l3d_draw_order order) {
    order_.clear();
    for (const polygon& p : polygons_)
        order_.push_back({order == l3d_draw_order::as_added ? 0 : key_of(p.depth),
                          static_cast<std::uint32_t>(order_.size())});
    l3d_radix_sort(order_, sorting_);
    for (const l3d_sort_item& item : order_)
        rasterizer.draw_polygon_flatshaded(corners(item.index), polygons_[item.index].color);
}
