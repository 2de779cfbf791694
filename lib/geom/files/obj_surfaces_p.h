// SPDX-License-Identifier: MIT
// obj_surfaces: reads the free-form surfaces and curves of an .obj file, and its lines.
#ifndef L3D_GEOM_FILES_OBJ_SURFACES_P_H
#define L3D_GEOM_FILES_OBJ_SURFACES_P_H

#include "geom/nurbs_surface.h"
#include "geom/polygon_mesh.h"
#include "geom/files/model_file.h"
#include "geom/files/text_cursor_p.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace l3d_detail {

/// Finds the index of a thing, such as a vertex, from its number in an .obj file. Number 1 is the
/// first thing, -1 the last one so far. Fails if the number names none of the `count` things so
/// far.
bool obj_index(text_cursor& text, std::string_view digits, std::size_t count, std::uint32_t& index);

/// Reads the statements of free-form surfaces and curves (cstype, deg, surf, curv, parm, end), of
/// connections between surfaces (con) and of lines (l). Each surface becomes patches, and each
/// connection an edge that trims follow.
///
/// Lives:   borrows the cursor and the vectors that it fills.
/// Source:  the appendix "Object Files" of Wavefront's Advanced Visualizer manual.
class obj_surfaces {
public:
    using vector = l3d_polygon_mesh::vector;

    /// `whole` gets each surface with its own knots and control points, unless it is null.
    obj_surfaces(text_cursor& text, std::vector<l3d_patch_points>& patches,
                 std::vector<l3d_nurbs_curve>& curves, std::vector<l3d_model_edge>& edges,
                 std::vector<l3d_nurbs_surface>* whole)
        : text_(text), patches_(patches), curves_(curves), edges_(edges), whole_(whole),
          text_bytes_(text.rest().size()) {}

    static bool knows(std::string_view word);

    /// Reads the rest of a statement whose first word knows() accepts. `weights`, one for each
    /// vertex, may be shorter than `vertices`; missing weights are 1.
    bool read_statement(std::string_view word, const std::vector<vector>& vertices,
                        const std::vector<double>& weights);

    /// Ends the reading. Fails if the last surface or curve has no end.
    bool finish();

    /// For each vertex, whether a surface, curve or line uses it. Vertices beyond the list's end
    /// are unused.
    const std::vector<bool>& control_points() const { return is_control_point_; }

private:
    /// A flag in l3d_trim_curve::edge. Until connections are read, the lower 31 bits are the number
    /// of a curve of curv2. Files have fewer than 2^31 such curves.
    static constexpr std::uint32_t unconnected = 0x80000000;

    enum class kind { none, bezier, bspline, other };
    enum class opened { nothing, surface, curve, trim_curve };

    bool read_kind();
    bool read_degrees();
    bool read_surface(std::size_t vertices);
    bool read_curve(std::size_t vertices);
    bool read_line(const std::vector<vector>& vertices);
    bool read_parameter_vertex();
    bool begins_curve();
    bool read_trim_curve();
    bool read_trim(bool is_hole);
    bool read_range(l3d_bspline_direction& direction);
    bool read_points(std::size_t vertices);
    bool read_parameters();
    bool end(const std::vector<vector>& vertices, const std::vector<double>& weights);
    bool end_surface(const std::vector<vector>& vertices, const std::vector<double>& weights);
    bool end_curve(const std::vector<vector>& vertices, const std::vector<double>& weights);
    bool end_trim_curve();
    bool put_trims(std::span<l3d_patch_points> patches);
    bool read_connection();
    struct connected;
    bool read_connected(connected& side);
    bool follow(const connected& side, std::uint32_t edge);
    std::optional<l3d_model_edge> edge_along(const connected& side) const;
    void forget_unconnected();
    bool weights_of(const std::vector<double>& weights, std::vector<double>& of_points);
    bool takes(std::size_t bytes);
    std::vector<vector> places_of(const std::vector<vector>& vertices);
    bool complete(l3d_bspline_direction& direction, const char* name);
    bool number_in_line(double& value, const char* what);

    text_cursor& text_;
    std::vector<l3d_patch_points>& patches_;
    std::vector<l3d_nurbs_curve>& curves_;
    std::vector<l3d_model_edge>& edges_;
    std::vector<l3d_nurbs_surface>* whole_;
    std::size_t text_bytes_, patch_bytes_ = 0;
    kind kind_ = kind::none;
    bool is_rational_ = false;
    opened open_ = opened::nothing;
    int degree_u_ = 0, degree_v_ = 0;
    l3d_bspline_direction u_, v_;
    std::vector<std::uint32_t> indices_; ///< control points of the open surface or curve
    std::vector<bool> is_control_point_;
    std::vector<std::array<double, 3>> parameter_vertices_; ///< u, v and weight
    /// The curves of curv2, in their order; nothing in the place of a skipped curve.
    std::vector<std::optional<l3d_nurbs_curve>> trim_curves_;
    std::vector<l3d_trim_loop> trims_; ///< the trims of the open surface
    /// Whether the open surface is trimmed from outside, not only by holes.
    bool has_outer_trim_ = false;

    /// A surface after its `end`. Later connections may name it.
    struct ended_surface {
        std::size_t first_patch, end_patch;
        std::optional<l3d_nurbs_surface> whole; ///< the whole surface, if it is trimmed
    };
    std::vector<ended_surface> surfaces_;
};

} // namespace l3d_detail

#endif
