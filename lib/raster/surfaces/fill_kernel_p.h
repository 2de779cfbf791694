// SPDX-License-Identifier: MIT
// fill_kernel: micro-quads and triangles into a band of rows, many at a time in SIMD lanes.
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

/// Rows [top, bottom) of a picture while they are filled.
///
/// Shape:   words and depths point at column 0 of row `top`. Pitches in elements, >= width. So do
///          normals, if words are materials (fill_words); their pitch is that of depths.
/// Expects: width >= fill_least_width; depths not negative, also where nobody has set them yet.
///          Nothing outside [0, width) x [top, bottom) is touched; inside, what lies beside
///          polygons may be read and written back, so nobody else writes there meanwhile.
struct fill_band {
    std::uint32_t* words;
    std::ptrdiff_t word_pitch;
    float* depths;
    std::ptrdiff_t depth_pitch;
    std::int32_t width, top, bottom;
    std::uint32_t* normals = nullptr;
};

/// A whole vector of pixels must fit a row.
inline constexpr std::int32_t fill_least_width = 16;

/// The modes that the lanes can shade.
inline bool fill_shades(l3d_shade mode) {
    return mode == l3d_shade::lambert || mode == l3d_shade::gouraud || mode == l3d_shade::flat ||
           mode == l3d_shade::levels;
}

struct fill_counts {
    std::int64_t samples = 0; ///< pixel centres tested against the depth buffer
    std::int64_t written = 0; ///< samples nearer than the pixel's depth

    /// Polygons, each in every band, whose light is a plane instead of that of a unit normal in
    /// each pixel.
    std::int64_t by_plane = 0;

    /// Mode `levels`: as l3d_surface_counts has them.
    float level_error = 0;
    std::int64_t unproven_levels = 0;
    float normal_error = 0; ///< lit frames, likewise

    std::int64_t unsolved = 0; ///< as l3d_surface_counts has it

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

/// Polygons that the lanes do not take: larger than 64 pixels, or, for lambert, of too different
/// normals. The caller fills them by the scalar filler after fill_finish.
struct fill_rest {
    struct quad {
        const l3d_micro_grid* grid;
        std::size_t index;      ///< l3d_micro_grid::index of the first corner
        std::uint32_t material; ///< as fill_words has it
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

/// How pixels are written down while a frame is filled.
///
/// Without materials a word is a grey. With them it is the grey's level and, above it, the material
/// (material_words makes colours of that when all is filled). So the lanes fill either alike.
///
/// In lit frames the lanes write normals, as normal_code has them, and lit_words shades each pixel
/// that is seen once. The upper half of a word is a normal's z, the lower half the material.
struct fill_words {
    bool has_materials = false; ///< also if has_normals
    bool has_normals = false;   ///< expects the next
    static constexpr std::size_t most_lit_materials = std::size_t{1} << 16;

    /// The part of a word that does not depend on the level or normal.
    std::uint32_t of_material(std::uint32_t material) const {
        if (has_normals)
            return material;
        return has_materials ? material << 8 : 0;
    }

    /// The step of that part from a material to the next.
    std::uint32_t next_material() const { return of_material(1); }

    /// A level of 1 in a word.
    std::uint32_t unit() const { return has_materials ? 1 : 0x010101; }
};

/// A piece of a folded or skew quad. Shape: [corner][component], as in fill_queue.
struct fill_piece {
    using corner = std::array<std::int32_t, 6>;
    std::array<corner, 3> corners;
    std::uint32_t material = 0; ///< as fill_words has it
};

/// Polygons that wait until a vector of them can be set up together.
///
/// Shape: polygon i is in element i of each array, [corner][component]. Components are x, y, 1/w
///        and the light's inputs: the vertex's three numbers for lambert and levels, else the grey
///        level. Floats as their bits. A triangle's last corner is there twice.
/// Lives: one per worker, kept for its memory. Empty between bands.
struct fill_queue {
    static constexpr std::size_t widest_vector = 16, components = fill_piece::corner().size();
    /// Number of polygons that are filled together: whole vectors of every width. So the set of
    /// waiting polygons does not depend on the width, nor what is drawn when somebody asks what is
    /// hidden.
    static constexpr std::size_t enough = 3 * widest_vector;
    static constexpr std::size_t room = enough + 2 * widest_vector;

    alignas(64) std::int32_t corner[4][components][room];
    /// The index of a quad; minus the index - 1 of a triangle; `piece` for a piece of a quad.
    alignas(64) std::int32_t name[room];
    static constexpr std::int32_t piece = std::numeric_limits<std::int32_t>::min();

    alignas(64) std::array<const void*, room> source; ///< the grid or triangles it comes from
    alignas(64) std::int32_t seen[room]; ///< 0: hidden; found out when the polygon is to be filled
    alignas(64) std::uint32_t material[room]; ///< as fill_words has it; only if there are any
    std::size_t count = 0;

    /// Folded and skew quads in pieces. They are filled after all others. So the order of two that
    /// are equally near does not depend on how many waited together.
    std::vector<fill_piece> pieces;

    /// Grey levels of a run of polygons' corners, made and read a vector at a time.
    static constexpr std::size_t run = 256;
    static_assert(run % widest_vector == 0);
    alignas(64) float greys[4][run] = {};
};

/// Where polygons go, and what is written down of it: counts and rest are added to.
struct fill_target {
    const fill_band& band;
    const l3d_shading& shading;
    fill_queue& queue;
    fill_counts& counts;
    fill_rest& rest;
    bool leaves_out_hidden = true; ///< polygons behind what is there; `samples` then lacks theirs
    fill_words words{};
};

/// A grid and its material, and, for gouraud, the grey levels of its vertices, from light_vertices.
struct fill_grid {
    const l3d_micro_grid& vertices;
    const float* levels;
    std::uint32_t material = 0; ///< as fill_words has it
    bool names_quads = false;   ///< as l3d_surface_part has it
};

/// The grey level of every vertex, as gouraud interpolates it. Shape: levels like the grid's
/// arrays.
void light_vertices(const l3d_shading& shading, const l3d_micro_grid& grid, float* levels);

/// Fills the quads of a grid whose first corner is in rows [row_begin, row_end) and columns
/// [column_begin, column_end), now or later: at the latest in fill_finish.
///
/// Gives the same picture as surface_fill with the mode's shader. Coverage is exact, and so is
/// `samples` unless hidden polygons are left out. Depth is within 1e-5 of the corners' range, grey
/// within one level. The same bits whatever the processor and however a picture is divided into
/// bands.
/// Expects: fill_shades(mode); 0 <= row_begin, row_end < grid.rows, and so for columns; normals of
///          unit length, or zero; inv_w > 0. Band and shading are the same until fill_finish, and
///          grids stay.
void fill_quads(const fill_target& to, const fill_grid& grid, int row_begin, int row_end,
                int column_begin, int column_end);

/// Fills triangles [first, last) of the material, or of their own if they have; otherwise like
/// fill_quads.
void fill_triangles(const fill_target& to, const l3d_micro_triangles& triangles,
                    std::uint32_t material, std::size_t first, std::size_t last);

/// Fills what still waits, and only now is the band done but for the rest.
void fill_finish(const fill_target& to);

/// Queues the pieces of a folded or skew quad, cut as by surface_fill; or puts a polygon to the
/// rest. Expects: polygon i of the queue is folded or skew if `in_pieces` and it is a quad.
void fill_put_by(const fill_target& to, std::size_t i, bool in_pieces);

} // namespace l3d_detail

#endif
