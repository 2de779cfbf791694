// SPDX-License-Identifier: MIT
// l3d_clip_to_plane: the part of a convex polygon on one side of a plane in space, or a line in 2D.
#ifndef L3D_GEOM_CLIP_TO_PLANE_H
#define L3D_GEOM_CLIP_TO_PLANE_H

#include <cstdint>
#include <span>
#include <vector>

/// Keeps the part of a convex polygon that is in front of a plane.
///
/// A corner within `thickness` of the plane counts as on it: it is kept, and no edge is cut there.
/// So a plane through corners cuts between them, and leaves no slivers.
/// Shape:   `side` gives the signed distance of a vertex, front positive. `cut` gives the index of
///          the vertex where the edge between two vertices crosses the plane; the one in front
///          comes first. The two polygons of an edge get the same cut, without a crack, if `cut`
///          depends on these two vertices alone. `kept` gets the corners, in order, and loses its
///          contents.
/// Expects: a corner at least.
/// Errors:  false, and `kept` is empty, if nothing is in front.
/// Cost:    a call of `side` for each corner, at most two of `cut`.
/// Source:  one step of Sutherland and Hodgman's Reentrant Polygon Clipping (1974).
template <class T, class Side, class Cut>
bool l3d_clip_to_plane(std::span<const std::uint32_t> corners, T thickness, Side side, Cut cut,
                       std::vector<std::uint32_t>& kept) {
    kept.clear();
    bool in_front = false;
    std::uint32_t before = corners.back();
    T before_side = side(before);
    for (const std::uint32_t corner : corners) {
        const T corner_side = side(corner);
        if (corner_side > thickness && before_side < -thickness)
            kept.push_back(cut(corner, before));
        if (corner_side < -thickness && before_side > thickness)
            kept.push_back(cut(before, corner));
        if (!(corner_side < -thickness))
            kept.push_back(corner);
        in_front = in_front || corner_side > thickness;
        before = corner;
        before_side = corner_side;
    }
    if (!in_front)
        kept.clear();
    return in_front;
}

#endif
