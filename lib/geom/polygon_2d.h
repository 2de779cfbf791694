// SPDX-License-Identifier: MIT
// l3d_polygon_2d: a convex polygon as indices into a list of vertices, and its clipping; the
// vertices, each with its place before and after transformations.
#ifndef L3D_GEOM_POLYGON_2D_H
#define L3D_GEOM_POLYGON_2D_H

#include "base/public.h"
#include "geom/plane.h"
#include "geom/transform.h"

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <ranges>
#include <span>
#include <utility>
#include <vector>

/// A list with a fixed part, whose size is given once, and a varying part behind it.
///
/// Clipping adds vertices that last for a frame to the varying part. Drawing finds them by an
/// index, as it finds the fixed vertices. Several polygons may share a list: the varying part is
/// emptied once per frame, not per polygon.
/// Shape:   indices 0 to fixed_size() - 1 are fixed, those from there to size() - 1 vary.
/// Lives:   a value; a copy is deep. Adding an item makes references to all items invalid.
/// Cost:    no allocation once the largest frame has been seen.
template <class Item> class L3D_PUBLIC l3d_two_part_list {
public:
    l3d_two_part_list() = default;
    /// A list with this fixed part, and an empty varying part.
    explicit l3d_two_part_list(std::vector<Item> fixed)
        : items_(std::move(fixed)), fixed_size_(items_.size()) {}

    /// The number of items in both parts.
    std::size_t size() const { return items_.size(); }
    /// The number of items in the fixed part.
    std::size_t fixed_size() const { return fixed_size_; }
    /// The number of items in the varying part.
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

    /// The items of the fixed part, to be changed.
    std::span<Item> fixed() { return {items_.data(), fixed_size_}; }
    /// The items of the fixed part.
    std::span<const Item> fixed() const { return {items_.data(), fixed_size_}; }

    /// Adds an item to the varying part, and returns its index.
    std::uint32_t add_varying(const Item& item) {
        items_.push_back(item);
        return static_cast<std::uint32_t>(items_.size() - 1);
    }

    /// Empties the varying part. Cost: keeps the memory.
    void clear_varying() { items_.erase(items_.begin() + signed_fixed_size(), items_.end()); }

private:
    std::ptrdiff_t signed_fixed_size() const { return static_cast<std::ptrdiff_t>(fixed_size_); }

    std::vector<Item> items_;
    std::size_t fixed_size_ = 0;
};

/// A vertex that many polygons share, and that is moved from its definition in every frame.
///
/// Every frame starts from `original`, so no rounding adds up from frame to frame. Transformations
/// are numbered stages, so each moves a vertex once, however many polygons ask for it.
template <class T> struct L3D_PUBLIC l3d_coordinate {
    /// Uninitialised, as a point is.
    l3d_coordinate() = default;
    /// A vertex defined at this place, and not moved yet.
    explicit l3d_coordinate(const l3d_point<T>& place) : original(place) { reset(); }

    /// Undoes all transformations: `transformed` becomes `original` again.
    void reset() {
        transformed = original;
        transform_stage = 0;
    }

    /// Moves `transformed` by the matrix, unless `stage` was the last stage done.
    /// Expects: a stage that is not 0; transformations that follow each other have different
    ///          stages.
    void transform(const l3d_matrix<T>& matrix, int stage) {
        if (transform_stage == stage)
            return;
        transform_stage = stage;
        transformed = l3d_transformed(matrix, transformed);
    }

    l3d_point<T> original;    ///< the vertex's place before any transformation
    l3d_point<T> transformed; ///< after the last stage, a position in the picture, in pixels
    /// Results of stages in between, such as places in camera space, for programs that keep them.
    std::array<l3d_point<T>, 2> transformed_intermediates;
    int transform_stage = 0; ///< the stage of the last transformation; 0 if there was none
};

/// The vertices of one or several polygons.
template <class T> using l3d_vertex_list = l3d_two_part_list<l3d_coordinate<T>>;

/// Moves every vertex of a list straight and evenly to its place in another list. With the last
/// step, all arrive exactly.
///
/// Each step computes the places from both ends, not from the step before. So errors do not add up.
/// Expects: in fixed point, the distance that a vertex moves, times the steps, is in range.
template <class T> class L3D_PUBLIC l3d_vertex_interpolator {
public:
    /// Begins a movement from the fixed vertices of `from` to those of `to`, in `steps` steps. The
    /// varying parts are left out.
    /// Expects: both lists have equally many fixed vertices; steps >= 1.
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

    /// Moves all vertices one step on. Returns false if this step was the last one.
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

    /// The moving vertices. `original` and `transformed` of each vertex are the same place.
    l3d_vertex_list<T>& list() { return list_; }

private:
    static T number(int value) { return l3d_from_double<T>(value); }

    std::vector<l3d_coordinate<T>> from_;
    std::vector<l3d_point<T>> to_;
    l3d_vertex_list<T> list_;
    int steps_ = 1;
    int position_ = 0;
};

/// The position of a vertex in the picture.
template <class T> l3d_position<T> l3d_in_picture(const l3d_coordinate<T>& vertex) {
    return {vertex.transformed[0], vertex.transformed[1]};
}

/// The vertex at a crossing, where the edge between two other vertices is cut. Vertex types with
/// further values overload this function to interpolate these values, too.
template <class T>
l3d_coordinate<T> l3d_cut_vertex(const l3d_coordinate<T>&, const l3d_coordinate<T>&,
                                 const l3d_crossing_2d<T>& crossing) {
    const T zero = l3d_from_double<T>(0);
    return l3d_coordinate<T>({crossing.at[0], crossing.at[1], zero});
}

/// The corners of an axis-aligned rectangle, as a window for l3d_polygon_2d::clip_to_polygon_2d.
/// Shape: `least` and `most` are the corners with the smallest and with the largest coordinates.
template <class T>
std::array<l3d_position<T>, 4> l3d_window_corners(const l3d_position<T>& least,
                                                  const l3d_position<T>& most) {
    return {least, {most[0], least[1]}, most, {least[0], most[1]}};
}

/// A convex polygon: only its geometry, without colours or materials.
///
/// The polygon knows indices, not vertices; the caller passes the vertices in each call. With
/// another list of vertices, such as the next picture of a movement, the polygon has another form.
/// There are two lists of indices: the corners of the definition, which stay, and the clipped
/// corners, which are drawn.
/// Expects: corners in clockwise order on the screen, where y is down. Anticlockwise polygons are
///          clipped and drawn as well, but cannot serve as a window.
/// Lives:   a value; a copy is deep.
class L3D_PUBLIC l3d_polygon_2d {
public:
    /// A polygon whose corners are these vertices of a list; nothing is clipped yet.
    explicit l3d_polygon_2d(std::vector<std::uint32_t> ivertices)
        : ivertices_(std::move(ivertices)), clip_ivertices_(ivertices_) {}

    /// The corners before any clipping, as indices of vertices.
    std::span<const std::uint32_t> ivertices() const { return ivertices_; }
    /// The corners that clipping has left, as indices of vertices.
    std::span<const std::uint32_t> clip_ivertices() const { return clip_ivertices_; }

    /// Undoes all clipping: the clipped polygon has the corners of the whole one again.
    void init_clip_ivertices() { clip_ivertices_ = ivertices_; }

    /// Cuts off the parts outside of a convex window. Returns false, and leaves no corners, if
    /// nothing is inside.
    ///
    /// A polygon that only touches the window from outside is outside. Corners keep their order. A
    /// corner inside the window or on its border keeps its index. Corners outside are replaced by
    /// new vertices in the varying part. If two polygons share an edge, their new vertices on it
    /// are at the same place.
    /// Shape:   `window` is an array, a vector or a span of l3d_position, its corners in clockwise
    ///          order on the screen. l3d_window_corners makes a rectangle.
    /// Expects: a window of at least three corners, and vertices as l3d_side_2d expects them.
    /// Cost:    corners * edges calls of l3d_side_2d; at most two new vertices for each edge of the
    ///          window.
    template <class Vertex, std::ranges::contiguous_range Window>
    bool clip_to_polygon_2d(l3d_two_part_list<Vertex>& vertices, const Window& window) {
        for (std::size_t i = 0; i < window.size() && !clip_ivertices_.empty(); ++i)
            clip_to_edge_2d(vertices, window[i == 0 ? window.size() - 1 : i - 1], window[i]);
        return !clip_ivertices_.empty();
    }

private:
    template <class Vertex, class T>
    void clip_to_edge_2d(l3d_two_part_list<Vertex>& vertices, const l3d_position<T>& from,
                         const l3d_position<T>& to) {
        const auto side = [&](std::uint32_t i) {
            return l3d_side_2d<T>(l3d_in_picture(vertices[i]), from, to);
        };
        const auto cut = [&](std::uint32_t inside, std::uint32_t outside) {
            const auto crossing = l3d_cross_line_2d<T>(l3d_in_picture(vertices[inside]),
                                                       l3d_in_picture(vertices[outside]), from, to);
            return vertices.add_varying(
                l3d_cut_vertex(vertices[inside], vertices[outside], crossing));
        };
        l3d_clip_to_plane(std::span<const std::uint32_t>(clip_ivertices_), 0.0, side, cut,
                          temp_clip_ivertices_);
        clip_ivertices_.swap(temp_clip_ivertices_);
    }

    std::vector<std::uint32_t> ivertices_;
    std::vector<std::uint32_t> clip_ivertices_;
    std::vector<std::uint32_t> temp_clip_ivertices_;
};

#endif
