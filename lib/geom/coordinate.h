// SPDX-License-Identifier: MIT
// l3d_coordinate: a place with its history: its definition, and its transformed places; vertices
// between them.
#ifndef L3D_GEOM_COORDINATE_H
#define L3D_GEOM_COORDINATE_H

#include "base/public.h"
#include "geom/transform.h"

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

/// A fixed part, whose size is given once, and a varying part behind it.
///
/// Clipping makes vertices that last for a frame. Drawing finds them by an index like any other.
/// Several polygons may share a list: the varying part is emptied once per frame, not per polygon.
/// Shape:   indices 0 to fixed_size() - 1 are fixed, those from there to size() - 1 vary.
/// Lives:   a value; a copy is deep. Adding an item makes references to others invalid.
/// Cost:    no allocation once the largest frame has been seen.
template <class Item> class L3D_PUBLIC l3d_two_part_list {
public:
    l3d_two_part_list() = default;
    /// A list with this fixed part, and nothing behind it.
    explicit l3d_two_part_list(std::vector<Item> fixed)
        : items_(std::move(fixed)), fixed_size_(items_.size()) {}

    /// The number of items in both parts.
    std::size_t size() const { return items_.size(); }
    /// The number of items that stay.
    std::size_t fixed_size() const { return fixed_size_; }
    /// The number of items that come and go.
    std::size_t varying_size() const { return items_.size() - fixed_size_; }

    /// An item of either part, to be changed. Expects: index < size().
    Item& operator[](std::size_t index) {
        assert(index < items_.size());
        return items_[index];
    }
    /// An item of either part. Expects: index < size().
    const Item& operator[](std::size_t index) const {
        assert(index < items_.size());
        return items_[index];
    }

    /// The items that stay, to be changed.
    std::span<Item> fixed() { return {items_.data(), fixed_size_}; }
    /// The items that stay.
    std::span<const Item> fixed() const { return {items_.data(), fixed_size_}; }

    /// Adds to the varying part; returns the item's index.
    std::uint32_t add_varying(const Item& item) {
        items_.push_back(item);
        return static_cast<std::uint32_t>(items_.size() - 1);
    }

    /// Takes away the items that come and go. Cost: keeps the memory.
    void clear_varying() { items_.erase(items_.begin() + signed_fixed_size(), items_.end()); }

private:
    std::ptrdiff_t signed_fixed_size() const { return static_cast<std::ptrdiff_t>(fixed_size_); }

    std::vector<Item> items_;
    std::size_t fixed_size_ = 0;
};

/// A vertex that many polygons share, and that is moved from its definition in every frame.
///
/// Every frame starts from `original`, so no rounding adds up from frame to frame. The stage is
/// counted, so a vertex is moved once however many polygons ask for it.
template <class T> struct L3D_PUBLIC l3d_coordinate {
    /// Uninitialised, as a point is.
    l3d_coordinate() = default;
    /// A vertex defined at this place, and not moved yet.
    explicit l3d_coordinate(const l3d_point<T>& place) : original(place) { reset(); }

    /// Forgets all transformations.
    void reset() {
        transformed = original;
        transform_stage = 0;
    }

    /// Applies the matrix, unless `stage` was the last stage done. Expects: a stage that is not 0;
    /// transformations that follow each other have different stages.
    void transform(const l3d_matrix<T>& matrix, int stage) {
        if (transform_stage == stage)
            return;
        transform_stage = stage;
        transformed = l3d_transformed(matrix, transformed);
    }

    l3d_point<T> original;    ///< its definition, before any transformation
    l3d_point<T> transformed; ///< in the end a position in the picture, in pixels
    /// For programs that need places between the two again, in camera space for example.
    std::array<l3d_point<T>, 2> transformed_intermediates;
    int transform_stage = 0; ///< the last stage done; 0 for none
};

/// The vertices of one or several polygons.
template <class T> using l3d_vertex_list = l3d_two_part_list<l3d_coordinate<T>>;

/// Moves every vertex of a list straight and evenly to its place in another list. With the last
/// step, all arrive exactly.
///
/// Each step starts from the two ends, not from the step before: nothing drifts.
/// Expects: in fixed point, that a vertex's way times the number of steps is in range.
template <class T> class L3D_PUBLIC l3d_vertex_interpolator {
public:
    /// Begins at `from`; the varying parts are left out.
    /// Expects: both lists with as many fixed vertices; steps >= 1.
    void start(const l3d_vertex_list<T>& from, const l3d_vertex_list<T>& to, int steps) {
        assert(from.fixed_size() == to.fixed_size() && steps >= 1);
        from_.clear();
        to_.clear();
        for (std::size_t i = 0; i < from.fixed_size(); ++i) {
            from_.emplace_back(from[i].original);
            to_.push_back(to[i].original);
        }
        list_ = l3d_vertex_list<T>(from_);
        steps_ = steps;
        position_ = 0;
    }

    /// Moves all vertices one step on; false if they have arrived.
    /// Expects: start() was called, and the last call returned true.
    bool step() {
        assert(position_ < steps_);
        ++position_;
        for (std::size_t i = 0; i < to_.size(); ++i) {
            const l3d_point<T>& from = from_[i].original;
            list_[i].original = position_ == steps_
                                    ? to_[i]
                                    : from + (to_[i] - from) * number(position_) / number(steps_);
            list_[i].reset();
        }
        return position_ < steps_;
    }

    /// The moving vertices, original and transformed alike.
    l3d_vertex_list<T>& list() { return list_; }

private:
    static T number(int value) { return l3d_from_double<T>(value); }

    std::vector<l3d_coordinate<T>> from_;
    std::vector<l3d_point<T>> to_;
    l3d_vertex_list<T> list_;
    int steps_ = 1;
    int position_ = 0;
};

#endif
