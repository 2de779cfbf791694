// SPDX-License-Identifier: MIT
// l3d_vertex_interpolator: vertices on their way from one form to another.
#ifndef L3D_GEOM_VERTEX_INTERPOLATOR_H
#define L3D_GEOM_VERTEX_INTERPOLATOR_H

#include "base/public.h"
#include "geom/coordinate.h"

#include <cassert>
#include <cstddef>
#include <vector>

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
