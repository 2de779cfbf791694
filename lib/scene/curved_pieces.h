// SPDX-License-Identifier: MIT
// l3d_curved_pieces: rational patches of any degree, cut until bicubic ones can stand for them.
#ifndef L3D_SCENE_CURVED_PIECES_H
#define L3D_SCENE_CURVED_PIECES_H

#include "geom/bezier_patch.h"
#include "geom/files/patch_file.h"
#include "geom/trim_region.h"
#include "scene/patch_scene.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Rational Bezier patches, the pieces, that models draw as bicubic ones, the cells.
///
/// A piece is cut into 2^m by 2^n cells. Pieces with a common boundary have as many cells along it,
/// and these have the same boundaries, bit for bit. Pieces may have trims; then there are cells for
/// what these leave.
class l3d_curved_pieces {
public:
    using patch = l3d_bezier_patch<double, 3>;
    using vector = l3d_vector<double, 3>;

    /// Expects: each piece as l3d_rational_piece expects.
    explicit l3d_curved_pieces(std::vector<l3d_patch_points> pieces);

    std::span<const l3d_patch_points> pieces() const { return pieces_; }

    /// The box of all control points, which holds all pieces.
    const vector& least() const { return least_; }
    const vector& most() const { return most_; }

    /// Levels of places and of normals are from 0 to this. The finest of places asks for 2^-42 of
    /// the diagonal of the box; rounding of doubles would leave little of a finer one.
    static constexpr int most_level = 16;
    /// The bound of places at a level, which cells keep if there are no more than most_cells. Each
    /// level's bound is a quarter of the one before, with twice the cells.
    double place_target(int level) const;
    /// The same for unit normals: 0.45 levels of Lambert's 229.5 at level 0, and two levels
    /// have an eighth of it.
    static double normal_target(int level);
    /// Pieces are not cut more often than this for their normals alone. So one that nearly has a
    /// cusp does not take all cells. Each level has twice as many; level 0 has 4096.
    static constexpr int most_halvings_for_normals(int level) { return 12 + level; }
    /// Cells that a model may have at any level: some 300 MB.
    static constexpr std::size_t most_cells = std::size_t{1} << 17;

    /// The cells of a level.
    struct cells {
        std::vector<patch> patches;
        std::vector<l3d_parameter_range> ranges; ///< the part of its piece that each patch is
        std::vector<std::uint32_t> pieces;       ///< the piece of each patch, which is a cell of it
        /// The region of each patch, from 0 to 1, that is there; empty where all of it is.
        std::vector<l3d_trim_region> trims;
        double error = 0;        ///< how far places are off, trims included, in the pieces' unit
        double normal_error = 0; ///< how far unit normals are off; infinite if nothing is known
    };
    /// Whether any piece has trims.
    bool has_trims() const { return has_trims_; }
    /// How often pieces are halved, and how far cells are off then.
    struct cuts {
        std::vector<int> of_lines; ///< along u and v of each piece; equal where lines are joined
        double trims = 0;          ///< how far polygons may be off that stand for trims
        double error = 0;          ///< how far places are off, trims included, in the pieces' unit
    };
    /// The cuts that a level needs, which begin with those of a coarser one. That saves finding
    /// these again.
    /// Expects: 0 <= places, normals <= most_level; `from` was made here.
    cuts cuts_at(int places, int normals, const cuts& from) const;
    cells cut(const cuts& by) const;

    /// The cells of a level that is found without coarser ones. Expects: as cuts_at.
    cells at_level(int places, int normals) const { return cut(cuts_at(places, normals, {})); }

private:
    void unite_common_boundaries();
    std::size_t root_of(std::size_t line) const;

    std::vector<l3d_patch_points> pieces_;
    /// For lines 2 i and 2 i + 1, along u and v of the piece i: another line that is cut alike, or
    /// itself.
    std::vector<std::size_t> alike_;
    vector least_{0.0, 0.0, 0.0}, most_{0.0, 0.0, 0.0};
    bool has_trims_ = false;
};

#endif
