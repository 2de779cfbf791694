// SPDX-License-Identifier: MIT
// l3d_world: updates, draws and removes its objects.
#include "pipeline/worlds/world.h"

#include "pipeline/worlds/world_surfaces.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>
#include <utility>

/// Keeps removed objects alive until an update ends, even if an object throws.
class l3d_world::update_scope {
public:
    explicit update_scope(l3d_world& world) : world_(world) { ++world_.updates_; }
    update_scope(const update_scope&) = delete;
    update_scope& operator=(const update_scope&) = delete;
    ~update_scope() {
        if (--world_.updates_ == 0)
            world_.drop_removed();
    }

private:
    l3d_world& world_;
};

l3d_world::l3d_world(std::unique_ptr<camera_type> seen_by)
    : camera(*seen_by), owned_camera_(std::move(seen_by)) {}

l3d_world::~l3d_world() = default;

l3d_object& l3d_world::add(std::unique_ptr<l3d_object> object) {
    assert(object);
    objects_.push_back(std::move(object));
    return *objects_.back();
}

bool l3d_world::remove(const l3d_object& object) {
    const auto found = std::ranges::find(objects_, &object, &std::unique_ptr<l3d_object>::get);
    if (found == objects_.end())
        return false;
    if (updates_ > 0)
        return removed_.insert(&object).second;
    // Its destructor may remove more objects.
    const std::unique_ptr<l3d_object> leaving = std::move(*found);
    objects_.erase(found);
    return true;
}

void l3d_world::drop_removed() {
    std::vector<std::unique_ptr<l3d_object>> leaving; // their destructors may remove more
    for (auto& object : objects_)
        if (removed_.contains(object.get()))
            leaving.push_back(std::move(object));
    std::erase(objects_, nullptr);
    removed_.clear();
}

void l3d_world::update_all(double seconds) {
    {
        const update_scope scope(*this);
        const std::size_t count = frozen ? 0 : objects_.size();
        for (std::size_t i = 0; i < count; ++i)
            if (!removed_.contains(objects_[i].get()))
                objects_[i]->update(seconds);
    }
    camera.update(seconds);
}

std::size_t l3d_world::draw_all(const l3d_world_target& target) {
    if (order == l3d_draw_order::by_depth && target.surfaces) {
        if (!drawn_)
            drawn_ = std::make_unique<l3d_world_surfaces>();
        return drawn_->draw(objects_, camera, surfaces, target);
    }
    facets_.begin(camera, target.pixels.size());
    for (const auto& object : objects_)
        facets_.add(*object);
    facets_.draw(target.rasterizer, order);
    return facets_.polygons();
}

namespace {

/// Polygons are cut where they reach further than this from the picture's centre. Units: pixels.
/// Pictures have at most 2^14 pixels a side, so nothing seen is cut. Positions this large, times
/// 256 for the fractions of a pixel that rasterizers count in, are far from 2^31.
constexpr double farthest_pixel = 0x1p15;

/// A key for sorting that falls as depth rises. It is made of a positive float's bits, which are
/// ordered like the float. Expects: depth > 0.
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
        points_.resize(vertices.size()); // drops the vertices that clipping made
    }
    return vertices.size();
}

/// Clips a face of points_ at the near plane and far outside the picture. clipped_ gets the result.
/// Returns false if nothing is left.
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

/// Cuts the polygon in clipped_ where coordinate `axis` times `scale` exceeds z. A negative scale
/// cuts at the opposite side. Scales are small, so that fixed point does not overflow.
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

/// Projects the polygon in clipped_ and adds it to the list, unless it lies beside the picture.
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
        order_.emplace_back(order == l3d_draw_order::as_added ? 0 : key_of(p.depth),
                            static_cast<std::uint32_t>(order_.size()));
    std::sort(order_.begin(), order_.end());
    for (const auto& [key, which] : order_)
        rasterizer.draw_polygon_flatshaded(corners(which), polygons_[which].color);
}
