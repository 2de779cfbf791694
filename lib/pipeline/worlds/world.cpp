// SPDX-License-Identifier: MIT
// l3d_world: updates, draws and removes its objects.
#include "pipeline/worlds/world.h"

#include "pipeline/worlds/world_surfaces.h"

#include <algorithm>
#include <cassert>
#include <utility>

/// Keeps removed objects alive while it lives, also when an object throws.
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
    const std::unique_ptr<l3d_object> leaving = std::move(*found); // it may remove more as it goes
    objects_.erase(found);
    return true;
}

void l3d_world::drop_removed() {
    std::vector<std::unique_ptr<l3d_object>> leaving; // they may remove more as they go
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
