// SPDX-License-Identifier: MIT
// Faces of a shape as records: rational surfaces, and the loops that trim them.
#ifndef L3D_PLUGINS_CAD_FACES_H
#define L3D_PLUGINS_CAD_FACES_H

#include "geom/files/cad_plugin_p.h"
#include "rational.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>

namespace cad {

/// Writes faces as records for l3d, and the edges that faces share.
/// Lives: borrows the writer.
class face_writer {
public:
    explicit face_writer(l3d_detail::cad_writer& to) : to_(to) {}

    /// Writes a face, and its edges that no earlier face had. A note names anything that cannot be
    /// written.
    void write(const TopoDS_Face& face);

    /// Writes an edge that bounds no face, as a curve.
    void write_curve(const TopoDS_Edge& edge);

    /// Writes a note if any faces are approximated.
    void finish();

private:
    /// A curve of a trimming loop in the plane of parameters, and the edge that the curve follows.
    struct trim {
        std::uint32_t edge;
        double from, to; ///< the edge's parameters at the curve's ends
        rational_curve curve;
    };
    using loop = std::vector<trim>;
    /// An edge of a face's wire, with the edge's direction in the wire and its curve in the plane
    /// of parameters.
    struct edge_use;
    /// An edge that was looked at before. `number` is its number among the written edges, or none
    /// if the edge has no curve in space.
    struct known_edge {
        std::uint32_t number;
        direction along;
    };

    const known_edge* known(const TopoDS_Edge& edge);
    void write_surface(const TopoDS_Face& face);
    loop trims_of(const edge_use& use, const rational_surface& surface);
    void put(const rational_curve& curve);
    void put_points(const std::vector<point>& points);

    l3d_detail::cad_writer& to_;
    TopTools_IndexedMapOfShape edges_;
    std::vector<known_edge> known_; ///< the edges of edges_, in the same order
    std::uint32_t written_ = 0;     ///< number of edges that were written
    std::size_t faces_ = 0, approximate_ = 0;
};

} // namespace cad

#endif
