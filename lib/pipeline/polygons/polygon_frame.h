// SPDX-License-Identifier: MIT
// l3d_polygon_frame: finds the triangles of a model that may be seen, and places them.
#ifndef L3D_PIPELINE_POLYGONS_POLYGON_FRAME_H
#define L3D_PIPELINE_POLYGONS_POLYGON_FRAME_H

#include "scene/dice_view.h"
#include "dice/diced_piece.h"
#include "pipeline/polygons/polygon_model.h"
#include "pipeline/frame_report.h"
#include "pipeline/polygons/polygon_view.h"
#include "pipeline/polygons/triangle_neighbours_p.h"
#include "pipeline/polygons/vertex_lanes_p.h"
#include "raster/zsort/painter.h"
#include "raster/rasterizer_2d.h"
#include "raster/surface_part.h"
#include "raster/parallel/workers.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// Finds the triangles of a model that may be seen, and places them in the picture. It projects
/// each vertex once, and leaves out triangles that cannot be seen. It clips triangles that cross
/// the near plane or reach too far out of the picture.
///
/// Places are computed in double for every type of l3d_real, then rounded to 1/256 pixel. In a
/// parallel projection, inv_w is not 1 / distance. It is 2 at the nearest and 1 at the farthest
/// point of the sphere around the model, and linear in between.
/// Expects: workers, model and view outlive each make().
/// Cost:    memory, which is kept for the next frame: 32 bytes per vertex, 8 per drawn triangle,
///          and 72 more per triangle in parts. Anti-aliasing takes 13 more per triangle of the
///          model.
class l3d_polygon_frame {
public:
    /// Which triangles make() chooses, and in which form it keeps them.
    struct way {
        /// Whether faces seen from behind are left out.
        bool cull = true;
        /// Whether corners have the normals of the model's vertices. Otherwise each corner has the
        /// normal of its face.
        bool smooth = false;
        /// Whether triangles that hold no pixel's centre are kept, and border edges of parts are
        /// made.
        bool antialias = false;
        /// Whether parts() are made. If not, list() still lists triangles. Expects: true for
        /// anti-aliasing.
        bool parts = true;
        /// Whether faces seen from behind are left out even without `cull`, if the model consists
        /// of closed bodies whose fronts hide all such faces.
        bool cull_hidden = false;
        /// The index of the model's first material among the picture's materials.
        std::uint32_t first_material = 0;
        /// The name of the model's first triangle, if each triangle has a name for its paint
        /// (l3d_face_paints). Expects: the model has materials.
        std::optional<std::uint32_t> first_painted{};
    };

    /// Makes the frame. `ends` divide the model's triangles into parts: part i holds triangles from
    /// `ends[i - 1]` up to `ends[i]`. Without ends, parts have a size that suits the workers.
    void make(const l3d_polygon_model& model, const l3d_polygon_view& view, const way& how,
              l3d_workers& workers, std::span<const std::size_t> ends = {});

    /// Sets the pixel word that the shade l3d_shade::error shows for a part.
    void set_error_color(std::size_t part, std::uint32_t word) {
        chunks_[part].part.error_color = word;
    }

    /// The frame's triangles in the form that rasterizers take, without grids. Empty if way::parts
    /// was false.
    /// Lives: until the next make.
    std::span<const l3d_surface_part* const> parts() const { return parts_; }

    /// Lists the triangles of all parts one by one. Each triangle tells which of its sides are
    /// sides of its face. A clipped triangle comes as pieces, with the outline of the polygon that
    /// clipping leaves.
    /// Expects: model and view of the last make() still exist.
    void list(std::vector<l3d_painter_triangle>& out, l3d_workers& workers) const;

    /// The ends of the parts in the list that list() makes: part i ends before triangle ends()[i].
    std::vector<std::size_t> ends() const;
    /// Writes the triangles of one part to `out`.
    /// Expects: `out` has as many elements as the part has triangles.
    void list_part(std::size_t part, std::span<l3d_painter_triangle> out) const;

    const l3d_polygon_counts& counts() const { return counts_; }

private:
    /// The wanted number of chunks, and the least and the largest number of triangles in a chunk.
    /// Workers take one chunk at a time. 16 chunks give workers even shares. The smallest chunk
    /// takes some 10^4 cycles. Chunks larger than the largest would not stay in a cache of the
    /// second level.
    static constexpr std::size_t chunks_wanted = 16, least_chunk = 1024, most_chunk = 4096;

    struct chunk {
        l3d_surface_part part;
        /// The number in the model of each drawn triangle or piece. Pieces of a clipped triangle
        /// follow each other.
        std::vector<std::uint32_t> names;
        /// How to draw each of `names`. For a whole triangle the value is 0, or the sign bit of a
        /// float if the triangle is seen from behind. For a piece of a clipped triangle the value
        /// is 1 more than the piece's index in `pieces`.
        std::vector<std::uint32_t> signs;
        std::vector<l3d_painter_triangle> pieces; ///< pieces of all clipped triangles of the chunk
        l3d_diced_piece clipped;                  ///< pieces of the triangle that is being clipped
        l3d_polygon_counts counts;
    };

    struct frame_input {
        const l3d_polygon_model& model;
        const l3d_polygon_view& view;
        l3d_dice_view window;
        way how;
        std::span<const std::size_t> ends;
        std::size_t in_chunk; ///< number of triangles in a chunk, if make() got no `ends`
    };

    using normal = std::array<float, 3>;

    bool hides_backs(const l3d_polygon_model& model, const l3d_polygon_view& view) const;
    void place_chunk(const frame_input& in, std::size_t index);
    static std::uint32_t material_of(const frame_input& in, std::size_t triangle) {
        if (in.how.first_painted)
            return *in.how.first_painted + static_cast<std::uint32_t>(triangle);
        return in.how.first_material + in.model.material_of(in.model.triangles()[triangle].face);
    }
    static bool has_vertex_normals(const frame_input& in) {
        return in.how.smooth && !in.model.has_creases();
    }
    void add_whole(const frame_input& in, const l3d_detail::chosen_triangles& chosen, chunk& to);
    void add_to_part(const frame_input& in, const l3d_detail::chosen_triangles& chosen,
                     std::size_t count, l3d_micro_triangles& triangles) const;
    static normal normal_of(const frame_input& in, std::size_t triangle, std::size_t corner,
                            bool from_behind);
    static void add_piece(const frame_input& in, std::size_t number,
                          const std::array<l3d_micro_vertex, 3>& v, std::uint32_t sides, chunk& to);
    void add_clipped(const frame_input& in, std::size_t number, bool from_behind, chunk& to);
    void note_turns(std::size_t count, const chunk& of);
    void make_border(chunk& of) const;

    /// The direction in which a triangle's corners go round in the picture.
    enum class turn : std::uint8_t { not_drawn, none, right, left, clipped };

    std::optional<frame_input> input_; ///< input of the last make
    l3d_detail::placed_vertices vertices_;
    l3d_detail::triangle_neighbours neighbours_;
    /// For each of the model's triangles, its turn in the picture; used for anti-aliasing.
    std::vector<turn> turns_;
    std::vector<chunk> chunks_;
    std::size_t count_ = 0; ///< number of chunks that are in use
    std::vector<const l3d_surface_part*> parts_;
    l3d_polygon_counts counts_;
    l3d_view_depths depths_;
};

#endif
