// SPDX-License-Identifier: MIT
// The data of l3d_patch_model: facts about its patches, and the levels of a curved model.
#ifndef L3D_SCENE_PATCH_CONTENTS_P_H
#define L3D_SCENE_PATCH_CONTENTS_P_H

#include "geom/files/model_file.h"
#include "geom/normal_net.h"
#include "scene/bends/surface_bends.h"
#include "scene/levels/curved_pieces.h"
#include "scene/culling/facing_cones.h"
#include "scene/sides/halved_sides.h"
#include "scene/patch_model.h"
#include "scene/patch_scene.h"

#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

/// The bends of a patch, computed at the first call. A patch that no frame dices never needs its
/// bends: it lies outside of the window, shows only its back, or is as small as a point.
class l3d_patch_model::bends_on_demand {
public:
    const l3d_surface_bends& of(const patch& p, const l3d_normal_net& normals) {
        std::call_once(known_, [&] { bends_.emplace(p, normals); });
        return *bends_;
    }

private:
    std::once_flag known_;
    std::optional<l3d_surface_bends> bends_;
};

struct l3d_patch_model::contents {
    /// Computes the data of patches. If `like` is not null, the data of patches that `like` has at
    /// the same index are copied.
    contents(std::vector<patch> of, const contents* like);
    /// Computes the data of a curved model's cells. If `like` is not null, the data of cells that
    /// are equal to cells of `like` are copied.
    contents(l3d_curved_pieces::cells of, const contents* like);

    std::vector<patch> patches;
    std::vector<l3d_normal_net> normals;
    std::vector<l3d_facing_cones> facing;
    std::vector<std::shared_ptr<bends_on_demand>> bends;
    std::vector<l3d_patch_reach> reaches;
    std::vector<l3d_halved_side> halved; ///< sides beyond which two smaller patches follow
    /// For each patch, a bit for each side in `halved`, in the order of l3d_patch_reach::edges.
    /// Empty if no side is halved.
    std::vector<unsigned char> halved_edges;
    int orientation = 0;
    vector least{0.0, 0.0, 0.0}, most{0.0, 0.0, 0.0};
    l3d_box_lanes boxes;

    // The following are for a curved model.
    std::vector<std::uint32_t> pieces;       ///< the piece that each patch belongs to
    std::vector<l3d_parameter_range> ranges; ///< the part of its piece that each patch covers
    /// The region of each patch that trims leave. The list is empty if no piece is trimmed.
    std::vector<l3d_trim_region> trims;
    std::vector<double> edges_off; ///< see l3d_curved_pieces::cells::edges_off
    std::vector<double> errors;    ///< errors of places, one for each patch
    /// The results of l3d_patch_model::surface_error() and normal_error().
    double surface_error = 0, normal_error = 0;
    /// The largest ratio of a patch's error of places to the error that is allowed there.
    double share = 0;

private:
    void learn(const contents* like, std::span<const std::size_t> places_in_like);
};

/// The errors that a program states for pieces that approximate another surface
/// (l3d_patch_model::standing_for).
struct l3d_patch_model::stated {
    /// Takes the stated errors. Clears `is_of_points` where errors of points may turn normals by
    /// any angle.
    stated(std::span<const l3d_patch_error> of, const l3d_patch_model& model);

    std::vector<l3d_patch_error> errors; ///< one for each piece
    double places = 0;                   ///< largest error of places
    double normals = 0; ///< largest error of normals among pieces with is_of_points
};

/// The pieces of a curved model, and its levels that were made so far. Levels of another model,
/// `like`, save work for equal cells.
struct l3d_patch_model::source {
    using kept_levels = std::map<std::pair<int, int>, std::shared_ptr<const contents>>;

    source(l3d_curved_pieces of, kept_levels like)
        : pieces(std::move(of)), like_(std::move(like)) {}

    kept_levels levels() const {
        const std::scoped_lock lock(mutex_);
        return levels_;
    }

    std::shared_ptr<const contents> at_level(int places, int normals) const;
    /// The largest error of places of a level, and about how many patches it has. Each corner of a
    /// trim counts as a share of a patch, since frames cut quads there.
    std::pair<double, double> error_and_count(int places, int normals) const {
        const std::scoped_lock lock(mutex_);
        const l3d_curved_pieces::cuts& by = cuts_at(places, normals);
        constexpr double of_corner = 1.0 / 4;
        return {by.error, by.cells + of_corner * pieces.trim_corners(places)};
    }
    /// Makes the contents for a wish with a region, or finds the contents that were made for an
    /// equal wish before. Null if no cell may be seen in the region.
    std::shared_ptr<const contents> seen(const l3d_cell_wish& wanted) const;

    l3d_curved_pieces pieces;

private:
    /// For how many wishes contents are kept: enough for some instances, or for some views in turn.
    static constexpr std::size_t most_seen = 8;

    l3d_cell_wish wish(int places, int normals) const {
        return {.places = pieces.place_target(places), .normals = normals};
    }
    /// The cuts of a level. The search starts from the cuts of the next coarser level of places or,
    /// at level 0 of places, of normals. So a level does not depend on the order of requests.
    const l3d_curved_pieces::cuts& cuts_at(int places, int normals) const;

    mutable std::mutex mutex_;
    mutable std::map<std::pair<int, int>, l3d_curved_pieces::cuts> cuts_;
    /// Contents by their cuts: levels with the same cuts share their contents.
    mutable std::map<std::vector<std::vector<double>>, std::shared_ptr<const contents>> made_;
    mutable kept_levels levels_;
    mutable l3d_found_cells found_;
    /// Contents by their wishes with regions. The last request comes first.
    mutable std::list<std::pair<l3d_cell_wish, std::shared_ptr<const contents>>> seen_;
    const kept_levels like_;
};

#endif
