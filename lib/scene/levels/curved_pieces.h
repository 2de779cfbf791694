// SPDX-License-Identifier: MIT
// l3d_curved_pieces: cuts rational patches of any degree into cells that bicubic patches
// approximate.
#ifndef L3D_SCENE_CURVED_PIECES_H
#define L3D_SCENE_CURVED_PIECES_H

#include "base/directed_sets_p.h"
#include "base/number_hash_p.h"
#include "geom/bezier_patch.h"
#include "geom/nurbs/bicubic_approximation.h"
#include "geom/files/patch_file.h"
#include "geom/trims/trim_region.h"
#include "scene/patch_scene.h"
#include "scene/levels/seen_region.h"
#include "scene/sides/shared_edges.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

/// The errors that a picture allows for the cells of curved pieces. Cells are wanted that are fine
/// enough to keep these errors.
struct l3d_cell_wish {
    double places = 0; ///< error of places that is allowed at any depth, in the pieces' unit
    int normals = 0;   ///< the level of normals (l3d_patch_model::at_level)
    /// The region that is seen. Without a region, all cells count as seen.
    std::optional<l3d_seen_region> region{};
    double places_by_depth = 0; ///< error of places that is allowed at depth 1 in the region

    friend bool operator==(const l3d_cell_wish&, const l3d_cell_wish&) = default;

    /// The error of places that is allowed in the hull of these points (see l3d_seen_region), in
    /// the pieces' unit.
    double allowed(std::span<const l3d_vector<double, 4>> points) const;
    /// The error of unit normals that is allowed in a cell with this range of its piece's
    /// parameters. The allowed error is infinite for cells that were halved
    /// most_halvings_for_normals + `normals` times.
    double normals_of(const l3d_parameter_range& cell) const;
};

/// The key of a cell in tables: its piece, and its range of the piece's parameters.
inline std::array<double, 5> l3d_cell_key(std::size_t piece, const l3d_parameter_range& at) {
    return {static_cast<double>(piece), at.u0, at.u1, at.v0, at.v1};
}

/// A table with a value for each cell.
template <class T>
using l3d_by_cell = std::unordered_map<std::array<double, 5>, T, l3d_detail::number_hash>;

/// Keeps the bicubic patches and normals that approximate cells, so that the next search for cells
/// need not compute them again.
class l3d_found_cells {
public:
    /// Returns the patch that approximates a part of a piece. If it is not known yet, make() gives
    /// the part to be approximated.
    /// Expects: parts are the same bit for bit whenever they are made.
    /// Lives:   until forget_if_many().
    template <class Make>
    const l3d_bicubic_approximation& patch(std::size_t piece, const l3d_parameter_range& at,
                                           const Make& make) {
        return of(patches_, piece, at, make);
    }
    /// Returns the normals of a part, which take longer to compute. Expects, Lives: as patch().
    template <class Make>
    const l3d_normal_approximation& normals(std::size_t piece, const l3d_parameter_range& at,
                                            const Make& make) {
        return of(normals_, piece, at, make);
    }
    /// Forgets all cells if more than 2^15 are kept, which take some 50 MB.
    void forget_if_many() {
        if (patches_.size() > std::size_t{1} << 15) {
            patches_.clear();
            normals_.clear();
        }
    }

private:
    template <class T, class Make>
    static const T& of(l3d_by_cell<std::optional<T>>& kept, std::size_t piece,
                       const l3d_parameter_range& at, const Make& make) {
        const auto [place, is_new] = kept.try_emplace(l3d_cell_key(piece, at));
        if (is_new)
            place->second.emplace(make());
        return *place->second;
    }

    l3d_by_cell<std::optional<l3d_bicubic_approximation>> patches_;
    l3d_by_cell<std::optional<l3d_normal_approximation>> normals_;
};

/// Cuts a curved model's pieces, which are rational Bezier patches, into cells. Each cell is drawn
/// as one bicubic patch.
///
/// A piece's ranges of u and v are halved repeatedly, wherever a cell is not fine enough yet.
/// Pieces with a common boundary are halved alike along it, so their cells have the same boundaries
/// there, bit for bit.
class l3d_curved_pieces {
public:
    using patch = l3d_bezier_patch<double, 3>;
    using vector = l3d_vector<double, 3>;

    /// Expects: each piece as l3d_rational_piece expects. Trims may name edges that do not exist;
    ///          these names are ignored.
    explicit l3d_curved_pieces(std::vector<l3d_patch_points> pieces,
                               std::vector<l3d_model_edge> edges = {});

    std::span<const l3d_patch_points> pieces() const { return pieces_; }
    /// The edges that trims follow, as the file has them.
    std::span<const l3d_model_edge> file_edges() const { return file_edges_; }
    /// The edges that trims follow, as Bezier curves.
    std::span<const l3d_shared_edge> edges() const { return edges_; }

    /// The box of all control points, from least() to most(). It holds all pieces.
    const vector& least() const { return least_; }
    const vector& most() const { return most_; }

    /// The finest level. Levels of places and of normals run from 0 to this number. The finest
    /// level of places asks for errors of 2^-42 of the box's diagonal. Smaller errors would be
    /// mostly rounding of doubles.
    static constexpr int most_level = 32;
    /// The error of places that a level asks for. Cells are as fine as that unless they would be
    /// more than most_cells. Two levels more ask for a quarter of the error, which takes twice the
    /// cells.
    double place_target(int level) const;
    /// The error of unit normals that a level asks for. At level 0 the error is 0.45 shade levels
    /// of Lambert's 229.5. Two levels more ask for an eighth. Cells are halved for normals at most
    /// most_halvings_for_normals + `level` times, so that cusps do not take all cells.
    static double normal_target(int level);
    /// The largest number of times that a cell is halved because of errors of normals, at level 0.
    /// A step of two halvings, one along u and one along v, divides a cell's error by 64. Two steps
    /// bring the largest possible error, 2, to 2^-11, below the target of level 0. Two more steps
    /// are for pieces that bend so much that errors fall less at first.
    static constexpr int most_halvings_for_normals = 2 * (2 + 2);
    /// The largest number of cells of a model at any level: they take some 300 MB.
    static constexpr double most_cells = 0x1p17;

    /// The cells between some cuts, as patches with bounds of their errors.
    struct cells {
        std::vector<patch> patches;
        /// For each patch, the normals of the piece itself.
        std::vector<l3d_normal_net> normals;
        /// For each patch, the part of its piece that it covers.
        std::vector<l3d_parameter_range> ranges;
        std::vector<std::uint32_t> pieces; ///< the index of each patch's piece
        /// The region of each patch that trims leave, in parameters from 0 to 1. A region is empty
        /// where all of the patch remains.
        std::vector<l3d_trim_region> trims;
        /// For each patch, a bound of errors of places, trims included, in the pieces' unit.
        std::vector<double> errors;
        double share = 0; ///< the largest ratio of a patch's error to its allowed error
        /// For each patch, how far the edges that its trims follow are off their faces; negative if
        /// the trims follow no edges.
        std::vector<double> edges_off;
        double normal_error = 0; ///< bound of errors of unit normals; may be infinite
    };
    /// Whether any piece has trims.
    bool has_trims() const { return has_trims_; }
    /// About how many corners the polygons of trims have at a level of places, without the ends of
    /// curves.
    double trim_corners(int level) const { return trim_bends_ / std::sqrt(place_target(level)); }
    /// The parameters at which all pieces are halved: all that is needed to make their cells.
    struct cuts {
        /// The parameters of cuts in ascending order: in element 2 i for u of piece i, in element 2
        /// i + 1 for v. Ranges that must be cut alike keep their cuts in one element.
        std::vector<std::vector<double>> of_lines;
        double cells = 0; ///< the number of cells
        double error = 0; ///< bound of errors of places, trims included, in the pieces' unit
    };
    /// Finds the cuts that the wanted cells need. The search begins with the cuts `from` of a
    /// coarser level.
    /// Expects: a level of normals from 0 to most_level; `from` is empty, or was made here.
    cuts cuts_for(const l3d_cell_wish& wanted, const cuts& from, l3d_found_cells& found) const;
    /// Makes the cells between these cuts, except for cells outside of the wish's region.
    cells cut(const cuts& by, const l3d_cell_wish& wanted, l3d_found_cells& found) const;

private:
    void unite_common_boundaries();
    double off_edges(const l3d_trim_region& region) const;
    bool is_cut(const cuts& by, std::size_t index, double from, double to) const;
    void halve(cuts& by, std::size_t index, double place) const;
    template <class Visit>
    void visit_cells(std::size_t piece, const cuts& by, const l3d_cell_wish& wanted,
                     const Visit& visit) const;

    std::vector<l3d_patch_points> pieces_;
    std::vector<l3d_model_edge> file_edges_;
    std::vector<l3d_shared_edge> edges_;
    l3d_detail::directed_sets alike_; ///< lines 2 i and 2 i + 1 run along u and v of piece i
    vector least_{0.0, 0.0, 0.0}, most_{0.0, 0.0, 0.0};
    bool has_trims_ = false;
    double trim_bends_ = 0; ///< sum of the square roots of the distances from trims to their chords
};

#endif
