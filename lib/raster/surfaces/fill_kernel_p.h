// SPDX-License-Identifier: MIT
// fill_kernel: fills micro-quads and triangles into a band, many at a time in SIMD lanes.
#ifndef L3D_RASTER_SURFACES_FILL_KERNEL_P_H
#define L3D_RASTER_SURFACES_FILL_KERNEL_P_H

#include "raster/surface_part.h"
#include "raster/surface_rasterizer.h"

#include <array>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace l3d_detail {

/// A band: rows [top, bottom) of a picture while they are filled.
///
/// Shape:   words and depths point at column 0 of row `top`. Pitches are in elements, >= width. If
///          words hold normals (fill_words::has_normals), `normals` points there, too, with the
///          pitch of depths.
/// Expects: width >= fill_least_width; depths not negative, also where nobody has set them yet.
///          Nothing outside [0, width) x [top, bottom) is touched. Pixels of the band beside
///          polygons may be read and written back, so nobody else writes to the band meanwhile.
struct fill_band {
    std::uint32_t* words;
    std::ptrdiff_t word_pitch;
    float* depths;
    std::ptrdiff_t depth_pitch;
    std::int32_t width, top, bottom;
    std::uint32_t* normals = nullptr;
};

/// The least width of a picture: a whole vector of pixels must fit a row.
inline constexpr std::int32_t fill_least_width = 16;

/// Whether the lanes can shade this mode.
inline bool fill_shades(l3d_shade mode) {
    return mode == l3d_shade::lambert || mode == l3d_shade::gouraud || mode == l3d_shade::flat ||
           mode == l3d_shade::levels;
}

struct fill_counts {
    std::int64_t samples = 0; ///< pixel centres tested against the depth buffer
    std::int64_t written = 0; ///< samples that were nearer than the depth of their pixels

    /// Polygons whose light is computed as a plane, not by a unit normal in each pixel. A polygon
    /// counts once in every band in which it is filled.
    std::int64_t by_plane = 0;

    /// In mode `levels`, the largest error of levels, as in l3d_surface_counts.
    float level_error = 0;
    std::int64_t unproven_levels = 0;
    /// In lit frames, the largest error of normals, as in l3d_surface_counts.
    float normal_error = 0;

    std::int64_t unsolved = 0; ///< tested pixels without an exact place, as in l3d_surface_counts

    void note_level_error(float error) {
        note(error, static_cast<float>(l3d_most_level_error), level_error);
    }
    void note_normal_error(float error) {
        note(error, static_cast<float>(l3d_most_normal_error), normal_error);
    }

    void add(const fill_counts& other) {
        samples += other.samples;
        written += other.written;
        by_plane += other.by_plane;
        level_error = std::max(level_error, other.level_error);
        normal_error = std::max(normal_error, other.normal_error);
        unproven_levels += other.unproven_levels;
        unsolved += other.unsolved;
    }

private:
    void note(float error, float most, float& largest) {
        if (error <= most)
            largest = std::max(largest, error);
        else
            ++unproven_levels;
    }
};

/// Polygons that the lanes do not take: they are larger than 64 pixels or, for lambert, their
/// normals differ too much. After fill_finish, the caller fills these polygons by the scalar
/// filler.
struct fill_rest {
    struct quad {
        const l3d_micro_grid* grid;
        std::size_t index;      ///< l3d_micro_grid::index of the quad's first corner
        std::uint32_t material; ///< as fill_words::of_material gives it
    };
    struct triangle {
        const l3d_micro_triangles* triangles;
        std::size_t index;
        std::uint32_t material;
    };

    std::vector<quad> quads;
    std::vector<triangle> triangles;

    void clear() {
        quads.clear();
        triangles.clear();
    }
};

/// The meaning of pixel words while a frame is filled.
///
/// Without materials, a word is a grey pixel. With materials, its lowest byte is the grey's level,
/// and its upper bytes are the material's index. At the end of the frame, material_words replaces
/// words with materials by colours.
///
/// In lit frames the lanes write normals in normal_code, and lit_words lights each visible pixel
/// once at the end. The upper half of a word is the z of a normal, the lower half the material.
struct fill_words {
    bool has_materials = false; ///< whether words name materials; true if has_normals is true
    bool has_normals = false;   ///< whether words hold normals; expects at most most_lit_materials
    static constexpr std::size_t most_lit_materials = std::size_t{1} << 16;

    /// The part of a word that tells the material, beside the level or the normal.
    std::uint32_t of_material(std::uint32_t material) const {
        if (has_normals)
            return material;
        return has_materials ? material << 8 : 0;
    }

    /// of_material(m + 1) - of_material(m), which is the same for every material m.
    std::uint32_t next_material() const { return of_material(1); }

    /// The word of level 1, without the material.
    std::uint32_t unit() const { return has_materials ? 1 : 0x010101; }
};

/// A triangle cut from a folded or skew quad. Shape: [corner][component], as in fill_queue.
struct fill_piece {
    using corner = std::array<std::int32_t, 6>;
    std::array<corner, 3> corners;
    std::uint32_t material = 0; ///< as fill_words::of_material gives it
};

/// Polygons that wait until there are enough to fill a vector's lanes.
///
/// Shape: polygon i is in element i of each array, [corner][component]. Components are x, y, 1/w
///        and the inputs of light. In modes lambert and levels, the inputs of light are the
///        vertex's three numbers, otherwise the grey level. Floats are stored by their bits. A
///        triangle has its last corner twice.
/// Lives: make one object for each worker, and keep it from frame to frame, since it keeps its
///        memory. The queue is empty between bands.
struct fill_queue {
    static constexpr std::size_t widest_vector = 16, components = fill_piece::corner().size();
    /// The number of polygons that are filled together: a multiple of every vector's width. So
    /// neither the polygons that wait, nor the results of tests for hidden shapes, depend on the
    /// width.
    static constexpr std::size_t enough = 3 * widest_vector;
    static constexpr std::size_t room = enough + 2 * widest_vector;

    alignas(64) std::int32_t corner[4][components][room];
    /// The name of each polygon: i for quad i, -(i + 1) for triangle i, `piece` for part of a quad.
    alignas(64) std::int32_t name[room];
    static constexpr std::int32_t piece = std::numeric_limits<std::int32_t>::min();

    /// The l3d_micro_grid or the l3d_micro_triangles that each polygon belongs to.
    alignas(64) std::array<const void*, room> source;
    /// 0 for each polygon that is hidden, set when the polygons are about to be filled.
    alignas(64) std::int32_t seen[room];
    /// The material, as fill_words::of_material gives it; set only in frames with materials.
    alignas(64) std::uint32_t material[room];
    std::size_t count = 0;

    /// The pieces of folded and skew quads. Pieces are filled after all other polygons. So the
    /// order of two equally near polygons does not depend on how many polygons waited together.
    std::vector<fill_piece> pieces;

    /// The grey levels of the corners of a run of polygons, written and read a vector at a time.
    static constexpr std::size_t run = 256;
    static_assert(run % widest_vector == 0);
    alignas(64) float greys[4][run] = {};
};

/// The data that filling works with: the band that it fills, and the queue, the counts and the rest
/// that it adds to.
struct fill_target {
    const fill_band& band;
    const l3d_shading& shading;
    fill_queue& queue;
    fill_counts& counts;
    fill_rest& rest;
    /// Whether polygons that are surely hidden are left out, and their pixels not counted in
    /// `samples`.
    bool leaves_out_hidden = true;
    fill_words words{};
};

/// A grid and its material. For mode `gouraud`, it also has the grey levels of the vertices, which
/// light_vertices finds.
struct fill_grid {
    const l3d_micro_grid& vertices;
    const float* levels;
    std::uint32_t material = 0; ///< as fill_words::of_material gives it
    bool names_quads = false;   ///< as l3d_surface_part::names_quads
};

/// Finds the grey level of every vertex, for mode `gouraud`.
/// Shape: levels are laid out as the grid's arrays.
void light_vertices(const l3d_shading& shading, const l3d_micro_grid& grid, float* levels);

/// Fills the quads of a grid whose first corners are in rows [row_begin, row_end) and columns
/// [column_begin, column_end). Quads may wait in the queue until fill_finish.
///
/// The picture is the same as by surface_fill with the mode's shader. Coverage is exact, and so is
/// the count `samples` unless hidden polygons are left out. Depth is within 1e-5 of its range at
/// the corners, and grey within one level. The bits are the same on every processor, and for every
/// division of the picture into bands.
/// Expects: fill_shades(mode); 0 <= row_begin, row_end < grid.rows, and the same for columns;
///          normals of unit length, or zero; inv_w > 0. Band and shading stay the same until
///          fill_finish, and grids stay in memory.
void fill_quads(const fill_target& to, const fill_grid& grid, int row_begin, int row_end,
                int column_begin, int column_end);

/// Fills triangles [first, last), with their own materials if they have some, else with `material`.
/// In all other respects the function works as fill_quads.
void fill_triangles(const fill_target& to, const l3d_micro_triangles& triangles,
                    std::uint32_t material, std::size_t first, std::size_t last);

/// Fills the polygons that still wait in the queue. Afterwards, the band is complete except for the
/// polygons in the rest.
void fill_finish(const fill_target& to);

/// If `in_pieces`, cuts polygon i of the queue as surface_fill does, and queues its pieces.
/// Otherwise adds the polygon to the rest.
/// Expects: a quad that is cut is folded or skew.
void fill_put_by(const fill_target& to, std::size_t i, bool in_pieces);

} // namespace l3d_detail

#endif
