// SPDX-License-Identifier: MIT
// edge_joints: the edges at which trimmed faces of a model meet, each as one line.
#ifndef L3D_SCENE_DRAWING_EDGE_JOINTS_P_H
#define L3D_SCENE_DRAWING_EDGE_JOINTS_P_H

#include "scene/drawing/borders_p.h"
#include "scene/sides/shared_edges.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace l3d_detail {

/// An edge of a model, placed in the picture.
struct image_edge {
    struct span {
        double from, to;   ///< the edge's parameters at the ends of the span
        bernstein_net net; ///< the curve in the picture: n = 0, 4 dims, as drawing_view::placed
    };
    std::vector<span> spans;
    double off = 0; ///< distance found between the edge and its faces, in pixels

    image_edge(const l3d_shared_edge& edge, const l3d_patch_instance& instance,
               const drawing_view& view);

    /// The parts of the edge's spans between two of its parameters.
    std::vector<span> between(double from, double to) const;
    image_place at(double t) const;
};

/// Finds the lines along the edges that trims of pieces follow. Each edge is drawn once, whichever
/// and however many pieces end at it.
///
/// An edge is a border where only one piece ends at it. Where two pieces end at it, it is a crease
/// if their normals differ by two degrees or more, and a joint otherwise. A joint is a contour
/// wherever one piece shows its front and the other its back.
class edge_joints {
public:
    /// Lives: borrows all.
    edge_joints(std::span<const image_piece> pieces, std::span<const image_edge> edges,
                const drawing_view& view, double tolerance);

    /// Ends contours on the edges of the model. An end whose parameters lie on an edge is moved to
    /// where the picture shows that edge. Two ends on an edge become one place if they are nearer
    /// than near / 2 pixels.
    /// Shape: `contours` holds the contours of each piece, which are changed.
    void end_on_edges(std::span<std::vector<surface_line>> contours, double near);

    /// Returns the lines. Lines of joints are left out unless `with_joints` is true. Expects:
    /// end_on_edges() was called.
    std::vector<drawn_chain> chains(bool with_joints) const;

private:
    /// A side of the polygon that stands for a piece's trim. The side runs along an edge of the
    /// model.
    struct trim_side {
        double from, to; ///< where the side begins and ends, as parameters of the edge
        l3d_trim_place a, b;
    };
    /// All sides of a piece's trims that run along an edge in one direction.
    struct edge_use {
        std::size_t piece;
        bool is_back; ///< whether the trim's polygon runs against the edge's direction
        bool is_left; ///< whether the piece lies to the left of the edge, in its parameters
        std::vector<trim_side> sides; ///< in the order of their parameters along the edge
        std::vector<std::array<double, 2>> stretches;

        std::array<double, 2> place(double t) const;
        bool has(double t) const;
    };
    struct contour_end {
        double t;
        surface_vertex* vertex;
    };

    void add_uses(std::size_t piece);
    std::vector<double> cuts_of(std::size_t edge) const;
    bool is_smooth(const edge_use& a, const edge_use& b, double from, double to) const;
    void add_joint(std::size_t edge, const edge_use& a, const edge_use& b, double from, double to,
                   bool with_joints, std::vector<drawn_chain>& result) const;
    void add(std::size_t edge, double from, double to, l3d_line_kind kind,
             const std::vector<std::size_t>& sides, std::vector<drawn_chain>& result) const;

    std::span<const image_piece> pieces_;
    std::span<const image_edge> edges_;
    const drawing_view& view_;
    double tolerance_;
    std::vector<std::vector<edge_use>> uses_;   ///< for each edge, the uses of it by pieces
    std::vector<std::vector<double>> contours_; ///< for each edge, parameters at which contours end
};

} // namespace l3d_detail

#endif
