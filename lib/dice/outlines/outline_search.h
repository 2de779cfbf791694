// SPDX-License-Identifier: MIT
// l3d_outline_search: finds the outlines of exact patches in the picture.
#ifndef L3D_DICE_OUTLINES_OUTLINE_SEARCH_H
#define L3D_DICE_OUTLINES_OUTLINE_SEARCH_H

#include "scene/dice_view.h"
#include "geom/patch_part.h"
#include "raster/pixel_bits.h"
#include "raster/two_layer_depths.h"

#include <array>
#include <cstddef>
#include <cstdint>

/// A place in the picture. Units: pixels.
struct l3d_picture_place {
    double x = 0, y = 0;
};

/// The bounds of a drawn frame's errors, by which l3d_outline_search knows which pixels an outline
/// may reach.
struct l3d_outline_reach {
    double focal; ///< length in pixels of a unit at distance 1
    /// In a parallel projection, how much depth changes over a pixel's width; 0 in perspective.
    double depth_by_pixel;
    /// Error bounds of places in the picture, and of depth along the normal, in pixels.
    double places, depth;
    double farthest_near; ///< the largest w of any patch's near plane
};

/// Marks in a mask the pixels near visible outlines of exact patches.
///
/// It halves patches until each piece certainly has no visible outline, or an outline that is
/// nearly straight. It marks all pixels within the bound of a straight outline.
///
/// Three kinds of lines count as outlines: the sides that add() names, the cuts by the near and the
/// far plane, and folds. At a fold the normal is perpendicular to the line of sight. The bounds
/// hold for the exact patches, whatever grid is drawn. The drawn depths are only used to tell
/// whether an outline is hidden.
/// Cost: some 3 us a piece; 30 to 60 pieces for 10 pixels of outline.
class l3d_outline_search {
public:
    /// Prepares a search with these bounds of the drawn frame.
    ///
    /// At a fold, pixels up to half of `reach.depth` farther away are marked, too. There the two
    /// sheets of the fold are closer together than the sum of their bounds of depth. For the fold's
    /// picture is a parabola d = k t^2 / 2 over the depth t, and the normal's slope is k t. So the
    /// sheets, 2 t apart in depth, are 4 d apart along the normal, and each sheet may err.
    /// Lives: borrows view, depths and mask.
    l3d_outline_search(const l3d_dice_view& view, const l3d_outline_reach& reach,
                       const l3d_two_layer_depths& depths, l3d_pixel_bits& mask);

    /// Marks the outlines of a patch. The bits of `sides` say which sides count as outlines
    /// (l3d_patch_neighbours). `share` is l3d_dice_view::share_of for the patch's points.
    /// Shape: patch, normals and eye are in one space.
    void add(const l3d_bezier_patch<double, 3>& patch, const l3d_normal_net& normals,
             const l3d_vector<double, 3>& eye, const l3d_image_patch& net, unsigned sides,
             double share);

private:
    using vector = l3d_vector<double, 3>;
    static constexpr std::size_t order = l3d_normal_polynomial::order;

    /// A part of a patch, and the kinds of outlines that it may still have.
    struct piece : l3d_exact_part {
        l3d_bezier_patch<double, 3> patch; ///< the whole patch, with the eye as origin
        unsigned sides = 0;
        bool may_fold = true;
    };
    /// A polynomial over a piece, zero along an outline: its Bernstein coefficients, and a bound of
    /// the error of its values.
    template <std::size_t N> struct level_set {
        std::array<double, N * N> at;
        double error = 0;
    };

    void take_share(double share);
    void search(const piece& p);
    bool mark_small(piece& p, const level_set<order>& facing);
    bool mark_cuts(const piece& p);
    void split(const piece& p);
    bool hides(const l3d_image_box& box, const l3d_depth_range& w) const;
    void add_curve(const l3d_image_curve& curve, int level);
    void add_box(const l3d_image_box& box);
    void add_line(l3d_picture_place from, l3d_picture_place to, double radius);
    level_set<order> facing_of(const piece& p) const;
    template <std::size_t N> bool add_level_set(const level_set<N>& of, const piece& p);
    bool add_straight(const l3d_picture_place* places, std::size_t count, double error,
                      double radius);

    const l3d_dice_view& whole_;
    /// The view with the patch's share of errors. The members down to window_ depend on this share,
    /// too.
    l3d_dice_view view_;
    l3d_outline_reach reach_;
    /// How far pixels are marked around a side, and around a fold, in pixels.
    double radius_ = 0, fold_radius_ = 0;
    double least_near_ = 0, most_near_ = 0;
    l3d_image_box window_{};
    double allowed_; ///< the most by which a marked line may be too wide, in pixels
    const l3d_two_layer_depths& depths_;
    l3d_pixel_bits& mask_;
    std::int64_t pieces_ = 0;
};

#endif
