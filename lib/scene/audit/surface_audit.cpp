// SPDX-License-Identifier: MIT
// l3d_surface_audit: bounds triangles of one side by searches of the other, by branch and bound.
#include "scene/audit/surface_audit.h"

#include "base/number_hash_p.h"
#include "geom/trims/trim_triangles.h"
#include "scene/audit/part_tree_p.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

namespace {

using l3d_detail::audit_part;
using l3d_detail::bent_patch;
using l3d_detail::flat_triangle;
using l3d_detail::part_tree;
using l3d_detail::patch_place;
using l3d_detail::patch_sheet;
using vector = l3d_surface_audit::vector;

/// The rounding of a distance, relative to the largest coordinate: some hundred units in the last
/// place.
constexpr double rounding = 0x1p-45;

/// The place where a triangle is cut in two: on a side, at a share of its length.
struct cut_place {
    std::size_t side;
    double share;
};

/// Chooses where to cut a part. The best place is where the surface with which the part is compared
/// ends, since neither half needs another cut there. If there are several such places, the one that
/// cuts off most of a side is taken. If there is no such place, or all such places cut off little,
/// the longest side is halved, lest parts become slivers.
class cut_choice {
public:
    explicit cut_choice(const audit_part& part)
        : corners_(part.flat.corners()), best_{part.longest_side(), 0.5},
          most_(least_share * length(best_.side)) {}

    /// Offers a place of a side for the cut. `a` and `b` are the values of a function at the side's
    /// two ends. If their signs differ, the surface ends between them.
    void offer(std::size_t side, double a, double b) {
        const double share = a / (a - b);
        const double off = std::min(share, 1 - share) * length(side);
        if (off > most_) { // false if share is NaN
            best_ = {side, share};
            most_ = off;
        }
    }

    const cut_place& best() const { return best_; }

private:
    static constexpr double least_share = 1.0 / 16;

    double length(std::size_t side) const {
        return l3d_length(corners_[(side + 1) % 3] - corners_[side]);
    }

    const std::array<vector, 3>& corners_;
    cut_place best_;
    double most_;
};

/// Finds the largest distance from the places of some parts to the nearest part of a tree.
class largest_distance {
public:
    largest_distance(const part_tree& to, double slack) : to_(to), slack_(slack) {}

    l3d_audited_way from(std::span<const audit_part> parts) {
        // Some good samples come first. They let most searches for parts and places end early.
        constexpr std::size_t first_samples = 16;
        for (std::size_t i = 0; i < parts.size(); i += first_samples)
            sample(parts[i].middle(), parts[i]);
        std::unordered_set<std::array<double, 3>, l3d_detail::number_hash> sampled;
        for (const audit_part& part : parts)
            for (const vector& p : part.flat.corners())
                if (sampled.insert({p[0], p[1], p[2]}).second)
                    sample(p, part);
        for (const audit_part& part : parts)
            judge(part, sample(part.middle(), part).most + part.size() + part.off);
        const std::size_t most_cuts =
            std::max(l3d_surface_audit::least_cuts, parts.size() + to_.parts().size());
        for (std::size_t cuts = 0; !open_.empty() && open_.front().most > enough(); ++cuts) {
            if (cuts == most_cuts)
                break;
            std::ranges::pop_heap(open_, is_nearer);
            const open_part next = std::move(open_.back());
            open_.pop_back();
            const auto halves = next.part.cut(next.at.side, next.at.share);
            if (next.part.size() < large * enough()) // samples the corner that the cut has made
                sample(halves[0].flat.corners()[1], next.part);
            for (const audit_part& half : halves)
                judge(half, next.most);
        }
        result_.most = std::max(settled_, result_.least);
        if (!open_.empty())
            result_.most = std::max(result_.most, open_.front().most);
        return result_;
    }

private:
    /// A part that may hold the largest distance.
    struct open_part {
        audit_part part;
        double most;
        cut_place at;
    };
    static bool is_nearer(const open_part& a, const open_part& b) { return a.most < b.most; }

    double enough() const { return result_.least + slack_; }

    /// Measures the distance at a place of a part, and remembers it if it is the largest so far.
    /// Returns the nearest part of the tree.
    part_tree::found sample(const vector& place, const audit_part& of) {
        constexpr double share = 0.125; // a small part of the slack, so that most is left to parts
        auto found = to_.nearest(std::span(&place, 1),
                                 {.enough = result_.least,
                                  .hopeless = std::numeric_limits<double>::infinity(),
                                  .slack = share * slack_},
                                 memory_);
        if (found.least > result_.least) {
            result_.least = found.least;
            result_.place = place;
            result_.index = of.index;
        }
        return found;
    }

    /// Settles a part if it is certainly within enough() of the tree's parts. Any other part is
    /// kept to be cut. `most` is a bound of the part's distance.
    void judge(const audit_part& part, double most) {
        const auto& corners = part.flat.corners();
        cut_choice at(part);
        near_.clear();
        const bool is_near_few = to_.find_near(part, enough(), most_near, near_);
        if (is_near_few || part.size() < large * enough()) {
            double here = 0;
            if (is_near_few && is_settled(part, 0, cuts_at_once, here)) {
                settled_ = std::max(settled_, here);
                return;
            }
            // Where Newton's method fails, as at a pole, a search in the tree may find a part.
            const double wanted = enough() - part.off;
            const auto by_search = to_.nearest(
                corners,
                {.enough = wanted, .hopeless = wanted, .slack = 0, .steps = steps_for_parts},
                memory_);
            if (by_search.most <= wanted) {
                settled_ = std::max(settled_, by_search.most + part.off);
                return;
            }
            const vector middle = part.middle();
            const auto found = sample(middle, part);
            double radius = 0;
            for (const vector& corner : corners)
                radius = std::max(radius, l3d_length(corner - middle));
            most = std::min(most, found.most + radius + part.off);
            if (!found.part->sheet)
                offer_borders(found.part->flat, part, at);
            else if (found.part->sheet->is_whole)
                matched_part(part, *found.part->sheet, at);
        }
        open_.push_back({part, most, chosen(part, at)});
        std::ranges::push_heap(open_, is_nearer);
    }

    /// Whether every place of `part` is within enough() of one of the parts near_[first] and after.
    /// `part` is halved up to `cuts` times to find out. `most` grows to the largest bound of a
    /// half's distance.
    bool is_settled(const audit_part& part, std::size_t first, int cuts, double& most) {
        const std::size_t end = near_.size();
        const vector middle = part.middle();
        const audit_part* nearest = nullptr;
        double square = std::numeric_limits<double>::infinity();
        // Boxes of long slanted triangles meet many that are nowhere near them.
        for (std::size_t i = first; i < end; ++i) {
            const audit_part& other = to_.parts()[near_[i]];
            const double by = enough() + other.off + part.off;
            if (part.flat.is_apart(other.flat, by) || other.flat.is_apart(part.flat, by))
                continue;
            near_.push_back(near_[i]);
            if (const double here = other.flat.square_distance(middle); here < square) {
                square = here;
                nearest = &other;
            }
        }
        const bool result = nearest && is_settled_by(*nearest, part, end, cuts, most);
        near_.resize(end);
        return result;
    }

    /// Does the work of is_settled when the nearest of the parts near_[first] and after is known.
    bool is_settled_by(const audit_part& nearest, const audit_part& part, std::size_t first,
                       int cuts, double& most) {
        cut_choice at(part);
        double bound = part.off;
        if (nearest.sheet && nearest.sheet->is_whole)
            bound += matched_part(part, *nearest.sheet, at);
        else {
            bound += nearest.off + farthest(nearest.flat, part.flat.corners());
            offer_borders(nearest.flat, part, at);
        }
        if (bound <= enough()) {
            most = std::max(most, bound);
            return true;
        }
        if (cuts == 0)
            return false;
        const cut_place place = chosen(part, at);
        return std::ranges::all_of(part.cut(place.side, place.share), [&](const audit_part& half) {
            return is_settled(half, first, cuts - 1, most);
        });
    }

    cut_place chosen(const audit_part& part, const cut_choice& at) const {
        return 2 * part.off > enough() ? cut_place{part.bent_side(), 0.5} : at.best();
    }

    static double distance_at(const patch_sheet& sheet, const patch_place& p, const vector& from) {
        return l3d_length(sheet.patch->of.evaluate(p[0], p[1]) - from);
    }

    /// The place of a sheet that is nearest to `to`, among 4 by 4 places of a grid inside of the
    /// sheet.
    static patch_place best_of_grid(const patch_sheet& sheet, const vector& to) {
        constexpr int count = 4;
        patch_place best{};
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < count * count; ++i) {
            const patch_place p{
                std::lerp(sheet.least[0], sheet.most[0], (i % count + 0.5) / count),
                std::lerp(sheet.least[1], sheet.most[1], (i / count + 0.5) / count)};
            if (const double here = distance_at(sheet, p, to); here < least) {
                least = here;
                best = p;
            }
        }
        return best;
    }

    /// A bound of the distance from a triangle to a sheet. The function compares the triangle with
    /// the part of the sheet whose corners are nearest to the triangle's corners. It also offers
    /// cuts where the sheet ends.
    double matched_part(const audit_part& part, const patch_sheet& sheet, cut_choice& at) {
        if (last_sheet_ != &sheet) {
            last_sheet_ = &sheet;
            last_place_ = {(sheet.least[0] + sheet.most[0]) / 2,
                           (sheet.least[1] + sheet.most[1]) / 2};
        }
        const auto& corners = part.flat.corners();
        std::array<patch_place, 3> places{}, inside{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto find = [&](const patch_place& begin) {
                places[k] = sheet.patch->place_near(corners[k], begin);
                for (std::size_t i = 0; i < 2; ++i)
                    inside[k][i] = std::clamp(places[k][i], sheet.least[i], sheet.most[i]);
            };
            find(last_place_);
            // Beside a pole, Newton's method fails from most places, but seldom from a place
            // farther away.
            if (distance_at(sheet, inside[k], corners[k]) > enough())
                find(best_of_grid(sheet, corners[k]));
        }
        last_place_ = inside[0];
        for (std::size_t i = 0; i < 2; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                for (const double border : {sheet.least[i], sheet.most[i]})
                    at.offer(k, places[k][i] - border, places[(k + 1) % 3][i] - border);
        const audit_part matched(sheet, inside);
        return matched.off + farthest(matched.flat, corners);
    }

    /// Offers cuts where the sides of a part leave the prism over a triangle.
    void offer_borders(const flat_triangle& of, const audit_part& part, cut_choice& to) const {
        const auto& corners = part.flat.corners();
        for (std::size_t side = 0; side < 3; ++side) {
            std::array<double, 3> beyond{};
            for (std::size_t k = 0; k < 3; ++k)
                beyond[k] = of.beyond(side, corners[k]);
            // A part that hardly leaves it needs no cut there: rounding would choose the place.
            if (std::ranges::max(beyond) <= (enough() - part.off) / 2)
                continue;
            for (std::size_t k = 0; k < 3; ++k)
                to.offer(k, beyond[k], beyond[(k + 1) % 3]);
        }
    }

    /// Limits of the tests before a part is sampled and kept. A part is cut `cuts_at_once` times,
    /// and compared with at most `most_near` parts. If more are near, a part larger than `large`
    /// times the distance is cut at once.
    static constexpr int cuts_at_once = 16;
    static constexpr std::size_t most_near = 256;
    static constexpr double large = 8;
    /// The steps after which a search for a part that is near enough gives up. Many parts may be
    /// just a little too far.
    static constexpr std::size_t steps_for_parts = 1024;

    const part_tree& to_;
    const double slack_;
    l3d_audited_way result_;
    double settled_ = 0; ///< the largest bound of a settled part's distance
    std::vector<open_part> open_;
    part_tree::memory memory_;
    std::vector<std::uint32_t> near_;
    const patch_sheet* last_sheet_ = nullptr; ///< the sheet on which Newton's method ended last
    patch_place last_place_{};
};

/// Divides the region that trims leave of a patch into rectangles, and triangles along the region's
/// border. Calls add_whole(box) and add(corners).
template <class Add, class Whole>
void divide(const l3d_trim_region& region, const l3d_trim_box& box, int depth,
            l3d_trim_triangles& use, const Add& add, const Whole& add_whole) {
    constexpr std::size_t most_corners = 16;
    constexpr int most_depth = 16;
    if (region.is_empty())
        return;
    if (region.is_all_of(box))
        return add_whole(box);
    std::size_t corners = 0;
    for (const l3d_trim_polygon& polygon : region.polygons)
        corners += polygon.size();
    if (corners <= most_corners || depth == most_depth) {
        use.cut(region, box);
        for (const auto& triangle : use.triangles())
            add(triangle);
        return;
    }
    const std::size_t along = depth % 2 == 0 ? 0 : 1;
    const double half = (box.least[along] + box.most[along]) / 2;
    l3d_trim_box low = box, high = box;
    low.most[along] = high.least[along] = half;
    const auto halves = region.halves(along, half);
    divide(halves[0], low, depth + 1, use, add, add_whole);
    divide(halves[1], high, depth + 1, use, add, add_whole);
}

} // namespace

struct l3d_surface_audit::contents {
    contents(const l3d_patch_model& of, double tolerance) : model(of) {
        // Patches as near as this are small, so that the search needs fewer cuts.
        constexpr double share = 1.0 / 32;
        int level = 0;
        while (level < of.most_level() && of.error_at_level(level, 0) > share * tolerance)
            ++level;
        model = of.at_level(level, 0);
        error = model.surface_error();
        // Both the surface's error and the search widen the bounds.
        slack = std::max(tolerance - 2 * error, tolerance / 2);
        patches.reserve(model.patches().size());
        for (const l3d_patch_model::patch& patch : model.patches())
            patches.emplace_back(patch);
        std::vector<audit_part> parts;
        l3d_trim_triangles trimmed;
        for (std::size_t i = 0; i < patches.size(); ++i) {
            const patch_sheet border{&patches[i], static_cast<std::uint32_t>(i)};
            sheets.push_back(border);
            const patch_sheet& beside = sheets.back();
            const auto add = [&](const std::array<l3d_trim_place, 3>& corners) {
                parts.emplace_back(beside, corners);
            };
            const auto add_whole = [&](const l3d_trim_box& box) {
                sheets.push_back(
                    {&patches[i], static_cast<std::uint32_t>(i), true, box.least, box.most});
                const auto& [u0, v0] = box.least;
                const auto& [u1, v1] = box.most;
                parts.emplace_back(sheets.back(),
                                   std::array<patch_place, 3>{{{u0, v0}, {u1, v0}, {u1, v1}}});
                parts.emplace_back(sheets.back(),
                                   std::array<patch_place, 3>{{{u0, v0}, {u1, v1}, {u0, v1}}});
            };
            if (const l3d_trim_region* const region = model.trim(i))
                divide(*region, {}, 0, trimmed, add, add_whole);
            else
                add_whole({});
        }
        tree.emplace(std::move(parts));
    }

    l3d_patch_model model;
    double error = 0, slack = 0;
    std::vector<bent_patch> patches;
    std::deque<patch_sheet> sheets; ///< parts borrow the sheets
    std::optional<part_tree> tree;
};

l3d_surface_audit::l3d_surface_audit(const l3d_patch_model& model, double tolerance)
    : contents_(std::make_unique<contents>(model, tolerance)) {
    assert(!model.patches().empty() && tolerance > 0);
}

l3d_surface_audit::l3d_surface_audit(l3d_surface_audit&& other) noexcept = default;
l3d_surface_audit::~l3d_surface_audit() = default;

std::array<double, 2> l3d_surface_audit::distance(const vector& from) const {
    part_tree::memory memory;
    const auto found =
        contents_->tree->nearest(std::span(&from, 1),
                                 {.enough = 0,
                                  .hopeless = std::numeric_limits<double>::infinity(),
                                  .slack = contents_->slack},
                                 memory);
    return {std::max(0.0, found.least - contents_->error), found.most + contents_->error};
}

l3d_mesh_audit l3d_surface_audit::compare(std::span<const triangle> mesh) const {
    assert(!mesh.empty());
    double reach =
        std::max(l3d_length(contents_->model.least()), l3d_length(contents_->model.most()));
    std::vector<audit_part> triangles;
    triangles.reserve(mesh.size());
    for (const triangle& t : mesh) {
        triangles.emplace_back(t, static_cast<std::uint32_t>(triangles.size()));
        for (const vector& corner : t)
            reach = std::max(reach, l3d_length(corner));
    }
    const part_tree& surface = *contents_->tree;
    const part_tree tree(std::move(triangles));
    l3d_mesh_audit result;
    result.from_mesh = largest_distance(surface, contents_->slack).from(tree.parts());
    result.from_surface = largest_distance(tree, contents_->slack).from(surface.parts());
    result.from_surface.index = contents_->model.piece_of(result.from_surface.index);
    const double off = contents_->error + rounding * reach;
    for (l3d_audited_way* const way : {&result.from_mesh, &result.from_surface}) {
        way->least = std::max(0.0, way->least - off);
        way->most += off;
    }
    return result;
}
