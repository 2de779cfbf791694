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

/// Cuts rational Bezier patches, the pieces, into cells, which models draw as bicubic patches.
///
/// A piece is cut into 2^m by 2^n cells. Pieces with a common boundary have equally many cells
/// along it, and these cells have the same boundaries there, bit for bit.
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

    /// Levels of places and of normals are from 0 to this. The finest level of places asks for
    /// errors of 2^-42 of the box's diagonal; rounding of doubles would leave little of a finer
    /// one.
    static constexpr int most_level = 16;
    /// The bound of errors of places that a level asks for. Cells keep it if there are no more than
    /// most_cells. Each level asks for a quarter of the bound before, which takes twice the cells.
    double place_target(int level) const;
    /// The bound of errors of unit normals that a level asks for: at level 0, 0.45 levels of
    /// Lambert's 229.5. Two levels more ask for an eighth of it.
    static double normal_target(int level);
    /// The most halvings of a piece for its normals alone. So a piece that nearly has a cusp does
    /// not take all cells. It has at most 4096 at level 0, and twice as many at each further level.
    static constexpr int most_halvings_for_normals(int level) { return 12 + level; }
    /// Cells that a model may have at any level: some 300 MB.
    static constexpr std::size_t most_cells = std::size_t{1} << 17;

    /// The cells of a level.
    struct cells {
        std::vector<patch> patches;
        std::vector<l3d_parameter_range> ranges; ///< the part of its piece, for each patch
        std::vector<std::uint32_t> pieces;       ///< the index of each patch's piece
        /// The region of each patch, from 0 to 1, that is there; empty where all of it is.
        std::vector<l3d_trim_region> trims;
        double error = 0;        ///< bound of errors of places, trims included, in the pieces' unit
        double normal_error = 0; ///< bound of errors of unit normals; may be infinite
    };
    /// Whether any piece has trims.
    bool has_trims() const { return has_trims_; }
    /// The numbers of halvings of all pieces.
    struct cuts {
        std::vector<int> of_lines; ///< piece i has 2 i along u, 2 i + 1 along v
        double trims = 0;          ///< how far polygons may be off that stand for trims
        double error = 0; ///< bound of errors of places, trims included, in the pieces' unit
    };
    /// Finds the cuts that a level needs. The search begins with the cuts of a coarser level.
    /// Expects: 0 <= places, normals <= most_level; `from` is empty, or was made here.
    cuts cuts_at(int places, int normals, const cuts& from) const;
    /// Makes the cells of these cuts.
    cells cut(const cuts& by) const;

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
