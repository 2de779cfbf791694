// SPDX-License-Identifier: MIT
// l3d_object: multiplies its matrices, and makes copies.
#include "pipeline/worlds/object.h"

#include <algorithm>
#include <cassert>
#include <utility>

l3d_object::l3d_object(const l3d_object& other)
    : name(other.name), mesh_(other.mesh_), textures_(other.textures_), vertices_(other.vertices_),
      transforms_(other.transforms_), product_(other.product_),
      product_is_old_(other.product_is_old_), model_(other.model_) {
    set_parent(other.parent_);
}

l3d_object::~l3d_object() {
    set_parent(nullptr);
    for (l3d_object* child : children_)
        child->parent_ = nullptr;
}

void l3d_object::set_mesh(l3d_polygon_mesh mesh,
                          std::vector<std::shared_ptr<const l3d_texture>> textures) {
    assert(mesh.is_valid());
    mesh_ = std::move(mesh);
    textures_ = std::move(textures);
    model_.reset();
    vertices_.clear();
    vertices_.reserve(mesh_.vertices.size());
    for (const auto& v : mesh_.vertices)
        vertices_.push_back(l3d_point<real>::of(v[0], v[1], v[2]));
}

const l3d_polygon_model& l3d_object::model() const {
    if (!model_)
        model_.emplace(l3d_polygon_model(mesh_).textured(textures_));
    return *model_;
}

void l3d_object::set_transform(std::size_t index, const l3d_matrix<real>& m) {
    if (index >= transforms_.size())
        transforms_.resize(index + 1, l3d_identity<real>());
    transforms_[index] = m;
    product_is_old_ = true;
}

const l3d_matrix<l3d_real>& l3d_object::modeling_transform() const {
    if (product_is_old_) {
        product_ = l3d_identity<real>();
        for (const l3d_matrix<real>& m : transforms_)
            product_ = m * product_;
        product_is_old_ = false;
    }
    return product_;
}

bool l3d_object::set_parent(l3d_object* parent) {
    for (const l3d_object* above = parent; above; above = above->parent_)
        if (above == this)
            return false;
    if (parent_)
        std::erase(parent_->children_, this);
    parent_ = parent;
    if (parent_)
        parent_->children_.push_back(this);
    return true;
}

l3d_matrix<l3d_real> l3d_object::world_transform() const {
    l3d_matrix<real> product = modeling_transform();
    for (const l3d_object* above = parent_; above; above = above->parent_)
        product = above->modeling_transform() * product;
    return product;
}

std::unique_ptr<l3d_object> l3d_object::clone() const {
    auto copy = do_clone();
    if (behaviour_)
        copy->plug(behaviour_->clone(*copy));
    return copy;
}

std::unique_ptr<l3d_object> l3d_object::do_clone() const {
    return std::unique_ptr<l3d_object>(new l3d_object(*this)); // the constructor is protected
}

void l3d_object::do_update(double seconds) {
    if (behaviour_)
        behaviour_->update(*this, seconds);
}
