// SPDX-License-Identifier: MIT
// l3d_cell_bounds: joins pieces to sheets, proves that one fills a cell, and bounds its light.
#include "dice/certificate/cell_bounds.h"

#include "dice/certificate/doubt_light_p.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

using l3d_detail::infinite;

/// The largest number of pieces in a cell that are joined to sheets. If there are more pieces, each
/// piece is a sheet that may end in the cell.
constexpr std::size_t most_pieces = 256;

using l3d_detail::interval;

bool meet(double low_a, double high_a, double low_b, double high_b) {
    return low_a <= high_b && low_b <= high_a;
}

/// The range of a piece's parameters along a side of its patch, in the direction in which one walks
/// round the patch.
interval along_side(const l3d_cell_bounds::member& p, std::size_t side) {
    switch (side) {
    case 0:
        return {p.u0, p.u1};
    case 1:
        return {p.v0, p.v1};
    case 2:
        return {1 - p.u1, 1 - p.u0};
    default:
        return {1 - p.v1, 1 - p.v0};
    }
}

/// Whether two pieces meet, and whether the surface may fold where they do.
struct meeting {
    bool is_there = false, may_fold = false;

    meeting(const l3d_cell_bounds::member& p, const l3d_cell_bounds::member& q) {
        if (p.of->instance != q.of->instance)
            return;
        is_there = p.of == q.of && meet(p.u0, p.u1, q.u0, q.u1) && meet(p.v0, p.v1, q.v0, q.v1);
        look_beyond(p, q, true);
        look_beyond(q, p, false); // only the half knows the side that it is a half of
    }

private:
    void look_beyond(const l3d_cell_bounds::member& p, const l3d_cell_bounds::member& q,
                     bool counts_pairs) {
        for (std::size_t k = 0; k < l3d_side_pairs::sides && p.sides != 0; ++k) {
            if ((p.sides >> k & 1) == 0)
                continue;
            const l3d_side_pairs::beyond& next = p.of->sides->at(p.of->patch, k);
            const bool is_half = next.is == l3d_side_pairs::kind::half;
            if (!(is_half || (counts_pairs && next.is == l3d_side_pairs::kind::paired)) ||
                next.patch != q.of->patch || (q.sides >> next.side & 1) == 0)
                continue;
            interval of_p = along_side(p, k);
            const interval of_q = along_side(q, next.side);
            if (!next.turns)
                of_p = {1 - of_p.high, 1 - of_p.low};
            if (is_half)
                of_p = {(next.part + of_p.low) / 2, (next.part + of_p.high) / 2};
            if (!meet(of_p.low, of_p.high, of_q.low, of_q.high))
                continue;
            is_there = true;
            may_fold = may_fold || p.facing != (next.turns ? -q.facing : q.facing);
        }
    }
};

/// Whether some place of a piece is proven to lie in a cell. Newton's method looks for the place
/// nearest to the cell's middle. The search begins with the piece's linear picture, and evaluates
/// the exact piece at each step.
bool is_in(const l3d_doubt_leaf& leaf, const l3d_image_box& cell, const l3d_dice_view& view) {
    constexpr int steps = 3;
    const l3d_doubt_bounds& b = leaf.bounds;
    if (!(b.u_off + b.v_off < infinite) || !(b.w.least > leaf.piece.of->error_w))
        return false;
    const double x = (cell.left + cell.right) / 2, y = (cell.top + cell.bottom) / 2;
    const double error = l3d_vertex_error(leaf.piece.of->error_xy, leaf.piece.of->error_w,
                                          view.size.width + view.size.height, b.w.least) +
                         0x1p-30 * (1 + view.size.width + view.size.height);
    const auto& to = b.parameters;
    double dx = x - b.at_x, dy = y - b.at_y, u = 0.5, v = 0.5;
    for (int i = 0; i < steps; ++i) {
        u = std::clamp(u + to[0] * dx + to[1] * dy, 0.0, 1.0);
        v = std::clamp(v + to[2] * dx + to[3] * dy, 0.0, 1.0);
        const l3d_image_point p = leaf.piece.net.evaluate(u, v);
        const double px = p[0] / p[2] + view.size.width / 2.0;
        const double py = p[1] / p[2] + view.size.height / 2.0;
        if (px - error > cell.left && px + error < cell.right && py - error > cell.top &&
            py + error < cell.bottom)
            return true;
        dx = x - px;
        dy = y - py;
    }
    return false;
}

constexpr unsigned all_corners = 15;

/// Finds the corners of a cell that a piece without any bound of its normals may reach. The result
/// has a bit for each corner.
unsigned dark_corners_of(const l3d_doubt_leaf& leaf, const l3d_image_box& cell) {
    if (leaf.piece.of->turned < infinite)
        return 0;
    const l3d_doubt_bounds& b = leaf.bounds;
    return unsigned{b.may_show(cell.left, cell.top)} |
           unsigned{b.may_show(cell.right, cell.top)} << 1 |
           unsigned{b.may_show(cell.left, cell.bottom)} << 2 |
           unsigned{b.may_show(cell.right, cell.bottom)} << 3;
}

} // namespace

void l3d_cell_bounds::gather(const l3d_image_box& cell, std::span<const std::uint32_t> touching,
                             std::span<const l3d_doubt_leaf> leaves) {
    pieces_.clear();
    members_.clear();
    joined_.clear();
    sheets_.clear();
    for (const std::uint32_t i : touching) {
        const l3d_doubt_leaf& leaf = leaves[i];
        const l3d_doubt_bounds& b = leaf.bounds;
        const l3d_doubt_piece& p = leaf.piece;
        if (!b.touches(cell))
            continue;
        unsigned sides = 0;
        for (std::size_t k = 0; k < l3d_side_pairs::sides; ++k)
            sides |= p.reaches(k) ? 1U << k : 0U;
        pieces_.push_back(&leaf);
        members_.push_back({b.box.intersected(cell), p.u0, p.u1, p.v0, p.v1, p.of, sides, b.facing,
                            i, dark_corners_of(leaf, cell)});
        joined_.add();
        sheets_.push_back(
            {.may_end = leaf.is_gone() || b.facing == 0 || b.may_be_missing || b.may_end_in(cell)});
    }
}

/// Joins all pieces that meet in the cell to sheets. The facts about a sheet are kept at its root.
void l3d_cell_bounds::connect() {
    const bool are_too_many = pieces_.size() > most_pieces;
    for (std::size_t i = 0; i < members_.size(); ++i)
        for (std::size_t k = 0; k < i && !are_too_many; ++k) {
            const member &p = members_[i], &q = members_[k];
            if (p.part.left > q.part.right || q.part.left > p.part.right ||
                p.part.top > q.part.bottom || q.part.top > p.part.bottom)
                continue;
            const meeting m(p, q);
            if (!m.is_there)
                continue;
            joined_.join({i, false}, {k, false});
            if (m.may_fold)
                sheets_[i].may_end = true;
        }
    for (std::size_t i = 0; i < pieces_.size(); ++i)
        if (sheets_[i].may_end || are_too_many)
            sheets_[root_of(i)].may_end = true;
}

/// Finds which sheets are in the cell. A sheet that does not end in the cell fills the cell if one
/// of the sheet's places is in it. Such a sheet is absent from the cell if the sheet misses the
/// cell's middle. Pieces that trims remove wholly are not seen; they only end the sheets to which
/// they are joined.
void l3d_cell_bounds::look_for(const l3d_image_box& cell, const l3d_dice_view& view,
                               double margin) {
    const double x = (cell.left + cell.right) / 2, y = (cell.top + cell.bottom) / 2;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const l3d_doubt_bounds& b = pieces_[i]->bounds;
        sheet& s = sheets_[root_of(i)];
        const auto [nearest, farthest] = b.range(b.w, cell);
        if (pieces_[i]->is_gone())
            continue;
        members_[i].nearest = nearest * (1 - margin * b.w_margin);
        s.farthest = std::max(s.farthest, farthest * (1 + margin * b.w_margin));
        const bool shows_middle = b.may_show(x, y);
        s.may_be_there = s.may_be_there || s.may_end || shows_middle;
        if (!s.is_there && !s.may_end && shows_middle)
            s.is_there = is_in(*pieces_[i], cell, view);
    }
}

bool l3d_cell_bounds::may_be_seen(std::size_t i, double farthest) const {
    return sheets_[root_of(i)].may_be_there && !pieces_[i]->is_gone() &&
           members_[i].nearest <= farthest;
}

/// Finds the w beyond which everything in the cell is hidden, and marks the sheets that may be
/// seen. The w is infinite if the background may be seen. Notes whether smaller
/// cells would tell more.
double l3d_cell_bounds::farthest_seen() {
    double result = infinite;
    for (std::size_t i = 0; i < pieces_.size(); ++i)
        if (root_of(i) == i && sheets_[i].fills())
            result = std::min(result, sheets_[i].farthest);
    unsigned dark = 0;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        sheet& s = sheets_[root_of(i)];
        const bool is_seen = may_be_seen(i, result);
        s.is_seen = s.is_seen || is_seen;
        dark |= is_seen ? members_[i].dark_corners : 0;
    }
    is_hopeless_ = dark == all_corners;
    return result;
}

void l3d_cell_bounds::mark_seen(std::vector<bool>& pieces) const {
    for (std::size_t i = 0; i < pieces_.size(); ++i)
        if (sheets_[root_of(i)].is_seen)
            pieces[members_[i].index] = true;
}

l3d_doubt_verdict l3d_cell_bounds::judge(const l3d_image_box& cell,
                                         std::span<const std::uint32_t> touching,
                                         std::span<const l3d_doubt_leaf> leaves,
                                         const l3d_dice_view& view,
                                         const l3d_light_bounds& background) {
    gather(cell, touching, leaves);
    connect();
    look_for(cell, view, 0);
    const double farthest = farthest_seen();
    only_ = nowhere;
    bool is_certain = true;
    l3d_light_bounds light;
    bool is_any = false;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const std::size_t root = root_of(i);
        if (!may_be_seen(i, farthest))
            continue;
        is_certain = is_certain && sheets_[root].fills() && (only_ == nowhere || only_ == root);
        only_ = root;
        if (pieces_[i]->has_no_area) // it has no light, but other sheets may end here
            continue;
        const l3d_light_bounds here = l3d_detail::light_in(*pieces_[i], cell, background);
        if (is_any)
            light.include(here);
        else
            light = here;
        is_any = true;
    }
    if (is_certain)
        return judge_alone(cell, background);
    if (!is_any)
        light = background;
    else if (farthest == infinite)
        light.include(background);
    return {false, false, light, light.levels_apart()};
}

l3d_doubt_verdict l3d_cell_bounds::judge_alone(const l3d_image_box& cell,
                                               const l3d_light_bounds& background) const {
    if (only_ == nowhere)
        return {true, false, background, 0};
    l3d_detail::lone_sheet lone(cell, background);
    for (std::size_t i = 0; i < pieces_.size(); ++i)
        if (root_of(i) == only_)
            lone.offer(*pieces_[i]);
    for (std::size_t i = 0; i < pieces_.size(); ++i)
        if (root_of(i) == only_ && pieces_[i]->bounds.touches(cell))
            lone.add(*pieces_[i]);
    return lone.verdict();
}

bool l3d_cell_bounds::is_drawn_alone(const l3d_image_box& grown,
                                     std::span<const std::uint32_t> touching,
                                     std::span<const l3d_doubt_leaf> leaves,
                                     const l3d_dice_view& view) {
    gather(grown, touching, leaves);
    connect();
    look_for(grown, view, 1);
    const double farthest = farthest_seen();
    only_ = nowhere;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const std::size_t root = root_of(i);
        if (!may_be_seen(i, farthest))
            continue;
        if (!sheets_[root].fills() || (only_ != nowhere && only_ != root))
            return false;
        only_ = root;
    }
    return true;
}
