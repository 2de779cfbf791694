// SPDX-License-Identifier: MIT
// cycle_cutter: cuts triangles that no order paints right, until there is an order.
#ifndef L3D_PIPELINE_ZSORT_CYCLE_CUTTER_P_H
#define L3D_PIPELINE_ZSORT_CYCLE_CUTTER_P_H

#include "pipeline/zsort/painter_components_p.h"
#include "pipeline/zsort/painter_cover_p.h"
#include "pipeline/zsort/painter_overlap_p.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Finds a painting order for a knot: a set of triangles that have no right painting order unless
/// some triangles are cut.
///
/// First, members that go through each other are cut at each other's planes, but only where they
/// meet. Where two surfaces cross, each triangle along the curve gets a cut or two. This step is
/// left out if more pairs go through each other than three times the number of members. Then each
/// set without an order is divided by the plane of one of its members. Pieces behind the plane are
/// painted first, pieces in front of it last. The division always ends, since the same plane never
/// divides a piece again.
class cycle_cutter {
public:
    /// The most members of a knot that is not searched for hidden members. In such a small knot,
    /// clearing the bits of the picture would take longer than painting the hidden members.
    static constexpr std::size_t few = 48;

    explicit cycle_cutter(std::size_t most_without_search = few)
        : most_without_search_(most_without_search) {}

    /// Orders a knot: adds the members' pieces in painting order to `pieces`, and the pieces' cuts
    /// to `cuts`.
    /// Expects: members are rising indices of triangles.
    /// Errors:  l3d_interrupted, if the workers are interrupted.
    void untie(l3d_workers& workers, l3d_size size, std::span<const l3d_painter_triangle> triangles,
               std::span<const std::uint32_t> members, std::vector<l3d_painter_piece>& pieces,
               std::vector<l3d_painter_cut>& cuts);

private:
    struct fragment {
        l3d_painter_piece piece;
        l3d_picture_plane plane;
        picture_region region;
        double left, right, top, bottom; ///< sides of the region's box
    };
    using fragments = std::vector<fragment>;

    fragment whole(std::uint32_t triangle) const;
    static void set_box(fragment& of);
    double tie(const fragment& a, const fragment& b) const;
    bool same(const fragment& a, const fragment& b) const {
        return a.piece.triangle == b.piece.triangle;
    }
    front_parts front(const fragment& a, const fragment& b);
    template <class Visit> void visit_pairs(const fragments& set, const Visit& visit);
    fragment cut_side(const fragment& of, const fragment& by, bool in_front);

    bool cut_where_they_meet(fragments& set);
    void arrange(fragments&& set);
    void divide(fragments&& set);
    std::size_t best_splitter(const fragments& set) const;
    void emit(const fragment& f);
    void leave_out_hidden(fragments& set);

    std::span<const l3d_painter_triangle> triangles_;
    std::vector<l3d_painter_piece>* pieces_ = nullptr;
    std::vector<l3d_painter_cut>* cuts_ = nullptr;
    l3d_workers* workers_ = nullptr; ///< tell whether the work is interrupted

    struct task {
        fragments set;
        bool cyclic; ///< whether it is known that the set has no order
    };
    /// Sets that are still to be ordered. The last set is in front of all other sets, and is
    /// ordered next.
    std::vector<task> tasks_;
    painter_cover cover_; ///< pixels that later pieces cover, for a large knot
    std::size_t most_without_search_;
    bool covers_ = false;
    ordered_components components_;
    picture_region common_, scratch_;
};

} // namespace l3d_detail

#endif
