// SPDX-License-Identifier: MIT
// l3d_polygon_2d: a convex polygon as indices into a list of vertices, and its clipping.
#ifndef L3D_GEOM_POLYGON_2D_H
#define L3D_GEOM_POLYGON_2D_H

#include "base/public.h"
#include "geom/plane.h"
#include "geom/coordinate.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <ranges>
#include <span>
#include <utility>
#include <vector>

/// The position of a vertex in the picture.
template <class T> l3d_position<T> l3d_in_picture(const l3d_coordinate<T>& vertex) {
    return {vertex.transformed[0], vertex.transformed[1]};
}

/// The vertex where an edge was cut, `t` of the way between two others. A vertex type with values
/// of its own overloads this function, to interpolate them, too.
template <class T>
l3d_coordinate<T> l3d_cut_vertex(const l3d_coordinate<T>&, const l3d_coordinate<T>&,
                                 const l3d_crossing_2d<T>& crossing) {
    const T zero = l3d_from_double<T>(0);
    return l3d_coordinate<T>({crossing.at[0], crossing.at[1], zero});
}

/// The four corners of an upright rectangle in the order that clipping expects.
template <class T>
std::array<l3d_position<T>, 4> l3d_window_corners(const l3d_position<T>& least,
                                                  const l3d_position<T>& most) {
    return {least, {most[0], least[1]}, most, {least[0], most[1]}};
}

/// A convex polygon: geometry alone, without looks.
///
/// It knows indices, not vertices. The caller passes the vertices in each call. Another list, such
/// as the next picture of a movement, gives the same polygon another form. Two index lists: the
/// definition, which stays, and the clipped one, which is drawn.
/// Expects: corners in clockwise order on the screen, where y is down; anticlockwise polygons are
///          clipped and drawn as well, but cannot serve as a window.
/// Lives:   a value; a copy is deep.
class L3D_PUBLIC l3d_polygon_2d {
public:
    /// A polygon whose corners are these vertices of a list; nothing is clipped yet.
    explicit l3d_polygon_2d(std::vector<std::uint32_t> ivertices)
        : ivertices_(std::move(ivertices)), clip_ivertices_(ivertices_) {}

    /// The corners of its definition, as indices of vertices.
    std::span<const std::uint32_t> ivertices() const { return ivertices_; }
    /// The corners that clipping has left, as indices of vertices.
    std::span<const std::uint32_t> clip_ivertices() const { return clip_ivertices_; }

    /// Makes the clipped polygon the whole one again.
    void init_clip_ivertices() { clip_ivertices_ = ivertices_; }

    /// Cuts off what is outside a convex window; false, and no corners, if nothing is left.
    ///
    /// A polygon that only touches the window from outside is outside. Corners keep their order; a
    /// corner inside or on the edge keeps its index, others are replaced by new vertices in the
    /// varying part. Two polygons with the same two vertices at a cut edge get the same new corner.
    /// Shape:   `window` is an array, a vector or a span of l3d_position, its corners in clockwise
    ///          order on the screen; l3d_window_corners.
    /// Expects: a window of at least three corners, and vertices as l3d_side_2d expects them.
    /// Cost:    corners * edges sides; at most two new vertices for each edge of the window.
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
