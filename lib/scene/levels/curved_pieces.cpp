// SPDX-License-Identifier: MIT
// l3d_curved_pieces: cuts pieces into as many cells as a level needs.
#include "scene/levels/curved_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace {

using patch = l3d_curved_pieces::patch;

/// A part of a curved piece, and its range of the piece's parameters.
struct ranged_part {
    l3d_rational_piece part;
    l3d_parameter_range range{};

    ranged_part half(bool along_u, bool second) const {
        auto halves = part.halves(along_u);
        return {std::move(second ? halves.second : halves.first), range.half(along_u, second)};
    }
};

/// Calls visit(part) with the cells of a part, except for cells in parts for which is_hidden(part)
/// is true. All cuts along u come before all cuts along v. So cells on both sides of a common
/// boundary halve it in the same order.
template <class Cut, class Hidden, class Visit>
void for_each_cell(const ranged_part& of, const Cut& is_cut, const Hidden& is_hidden,
                   const Visit& visit) {
    if (is_hidden(of.part))
        return;
    const l3d_parameter_range& at = of.range;
    const bool in_u = is_cut(true, at.u0, at.u1);
    if (!in_u && !is_cut(false, at.v0, at.v1))
        return visit(of);
    for (const bool second : {false, true})
        for_each_cell(of.half(in_u, second), is_cut, is_hidden, visit);
}

/// The share of the allowed error of places that cells of trimmed pieces may take. The polygons of
/// trims have the other three quarters. Cells need hardly more halvings for this share.
constexpr double share_of_cells = 0.25;

/// A cell of a piece.
struct cell {
    patch of;
    l3d_normal_net normals;
    l3d_parameter_range range;
    double error, allowed; ///< the error of places, and the allowed one
};

/// Bounds the lengths in space of a unit of a piece's u and of its v, from the piece's cells. For a
/// cell's own parameters, 3 times the largest difference of control points is a bound.
l3d_trim_place lengths_of(std::span<const cell> cells) {
    l3d_trim_place result{0, 0};
    for (const cell& one : cells)
        for (int i = 0; i < 4; ++i)
            for (int k = 0; k < 3; ++k) {
                const double by_u = l3d_length(one.of.at(i, k + 1) - one.of.at(i, k));
                const double by_v = l3d_length(one.of.at(k + 1, i) - one.of.at(k, i));
                result[0] = std::max(result[0], 3 * by_u / (one.range.u1 - one.range.u0));
                result[1] = std::max(result[1], 3 * by_v / (one.range.v1 - one.range.v0));
            }
    return result;
}

/// Finds the error of places that is allowed in a part of a piece, and up to the distance `beside`
/// around the part in space. The error is infinite if the wish's region shows nothing of these
/// places. `cells` are the piece's cells that may be seen; `lengths` is the result of lengths_of
/// for these cells.
double allowed_in(const l3d_trim_box& part, std::span<const cell> cells,
                  const l3d_trim_place& lengths, const l3d_cell_wish& wanted, double beside) {
    double result = std::numeric_limits<double>::infinity();
    for (const cell& one : cells) {
        const l3d_parameter_range& at = one.range;
        const double u0 = std::max(part.least[0], at.u0), u1 = std::min(part.most[0], at.u1);
        const double v0 = std::max(part.least[1], at.v0), v1 = std::min(part.most[1], at.v1);
        if (u0 > u1 || v0 > v1)
            continue;
        const auto middle = one.of.evaluate(((u0 + u1) / 2 - at.u0) / (at.u1 - at.u0),
                                            ((v0 + v1) / 2 - at.v0) / (at.v1 - at.v0));
        // A box in space that holds the whole part.
        const double reach =
            ((u1 - u0) * lengths[0] + (v1 - v0) * lengths[1]) / 2 + beside + one.error;
        std::array<l3d_vector<double, 4>, 8> corners;
        for (std::size_t k = 0; k < corners.size(); ++k)
            corners[k] = {middle[0] + ((k & 1) != 0 ? reach : -reach),
                          middle[1] + ((k & 2) != 0 ? reach : -reach),
                          middle[2] + ((k & 4) != 0 ? reach : -reach), 1.0};
        if (!wanted.region->hides(corners))
            result = std::min(result, wanted.allowed(corners));
    }
    return result;
}

/// Calls visit(cell, region) for each cell of a part of a piece, except for cells that trims remove
/// wholly. The region is what trims leave of the cell, or empty where they remove nothing.
template <class Visit>
void for_each_trimmed(std::span<const cell> cells, const l3d_parameter_range& part,
                      const l3d_trim_region& region, const Visit& visit) {
    const l3d_trim_box box{{part.u0, part.v0}, {part.u1, part.v1}};
    if (region.is_empty() || cells.empty())
        return;
    if (region.is_all_of(box) && !region.follows_edges()) {
        for (const cell& one : cells)
            visit(one, l3d_trim_region());
        return;
    }
    // Cells come in the order in which for_each_cell cuts. Cells that are not seen are missing.
    const l3d_parameter_range& any = cells.front().range;
    const bool along_u = any.u0 != part.u0 || any.u1 != part.u1;
    if (!along_u && any.v0 == part.v0 && any.v1 == part.v1)
        return visit(cells.front(), region.in_box(box));
    const l3d_parameter_range first = part.half(along_u, false);
    const auto [low, high] = region.halves(along_u ? 0 : 1, along_u ? first.u1 : first.v1);
    const auto half = std::ranges::partition_point(cells, [&](const cell& one) {
        return along_u ? one.range.u1 <= first.u1 : one.range.v1 <= first.v1;
    });
    const auto count = static_cast<std::size_t>(half - cells.begin());
    for_each_trimmed(cells.first(count), first, low, visit);
    for_each_trimmed(cells.subspan(count), part.half(along_u, true), high, visit);
}

/// About how long a unit of a piece's u and of its v is in space, judged by the piece's control
/// net.
l3d_trim_place rough_lengths_of(const l3d_patch_points& piece) {
    l3d_trim_place result{0, 0};
    const auto width = static_cast<std::size_t>(piece.degree_u) + 1;
    const auto take = [&](std::size_t along, int degree, std::size_t from, std::size_t to) {
        const auto &a = piece.points[from], &b = piece.points[to];
        result[along] =
            std::max(result[along], degree * std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]));
    };
    for (std::size_t i = 0; i < piece.points.size(); ++i) {
        if ((i + 1) % width != 0)
            take(0, piece.degree_u, i, i + 1);
        if (i + width < piece.points.size())
            take(1, piece.degree_v, i, i + width);
    }
    return result;
}

/// The verdict on a cell: how large its error is, and how the cell should be cut.
struct verdict {
    double error = 0;
    bool cut_u = false, cut_v = false;
};

/// Makes the part of a piece in a range by the halvings of for_each_cell, in their order, so that
/// equal parts have equal bits.
l3d_rational_piece part_of(const l3d_patch_points& piece, const l3d_parameter_range& at) {
    ranged_part result{l3d_rational_piece(piece)};
    for (const bool along_u : {true, false}) {
        const auto size = [along_u](const l3d_parameter_range& of) {
            return along_u ? of.u1 - of.u0 : of.v1 - of.v0;
        };
        while (size(result.range) > size(at)) {
            const l3d_parameter_range first = result.range.half(along_u, false);
            result = result.half(along_u, along_u ? at.u0 >= first.u1 : at.v0 >= first.v1);
        }
    }
    return result.part;
}

/// Judges a cell of a piece. If the cell's error is too large, the errors of its halves decide the
/// direction of the cut.
verdict judged(std::size_t index, const l3d_patch_points& piece, const l3d_parameter_range& at,
               double allowed, double allowed_normal, l3d_found_cells& found) {
    // Where normals have no bound, as at a cusp, cuts may never give one. So lines are cut for a
    // bound only if all 16 by 16 parts of the cell have one.
    constexpr int most_without_bound = 4;
    // If a cut gains less than a tenth, rounding or a cusp is the reason.
    constexpr double gain = 0.9;
    const auto error_of = [&](const l3d_parameter_range& of, bool of_places) {
        const auto make = [&] { return part_of(piece, of); };
        return of_places ? found.patch(index, of, make).error
                         : found.normals(index, of, make).error;
    };
    verdict result{error_of(at, true)};
    const bool is_off = result.error > allowed;
    const double now = error_of(at, is_off);
    if (!is_off && !(now > allowed_normal))
        return result;
    // The error that is left after m halvings along u and n along v. It stops at the first part
    // that gains too little.
    const auto left_by = [&](int m, int n) {
        const double u = std::ldexp(at.u1 - at.u0, -m), v = std::ldexp(at.v1 - at.v0, -n);
        const auto part = [&](int i) -> l3d_parameter_range {
            const int row = i >> m, column = i & ((1 << m) - 1);
            return {at.u0 + column * u, at.u0 + (column + 1) * u, at.v0 + row * v,
                    at.v0 + (row + 1) * v};
        };
        double most = 0;
        for (int i = 0; i < 1 << (m + n) && most < gain * now; ++i)
            most = std::max(most, error_of(part(i), is_off));
        return most;
    };
    const double by_u = left_by(1, 0), by_v = left_by(0, 1);
    result.cut_u = by_u < gain * now && by_u <= by_v;
    result.cut_v = by_v < gain * now && by_v < by_u;
    if (!result.cut_u && !result.cut_v)
        result.cut_u = result.cut_v =
            left_by(1, 1) < gain * now ||
            (std::isinf(now) && std::isfinite(left_by(most_without_bound, most_without_bound)));
    return result;
}

/// The control points of a piece's boundary as numbers, to be compared. The points are in the
/// direction in which they sort first.
struct boundary {
    std::vector<double> numbers;
    bool is_turned = false;    ///< whether the points run against the parameter
    bool is_symmetric = false; ///< whether both directions give the same numbers
};

/// Finds the four boundaries of a piece, and leaves out those that are points.
std::array<std::optional<boundary>, 4> boundaries_of(const l3d_patch_points& piece) {
    const auto m = static_cast<std::size_t>(piece.degree_u);
    const auto n = static_cast<std::size_t>(piece.degree_v);
    const std::size_t width = m + 1;
    const std::array<std::array<std::size_t, 3>, 4> lines{
        {{0, 1, m}, {n * width, 1, m}, {0, width, n}, {m, width, n}}}; // first, step, degree
    std::array<std::optional<boundary>, 4> result;
    for (std::size_t side = 0; side < 4; ++side) {
        const auto [first, step, degree] = lines[side];
        std::vector<double> there, back;
        bool is_point = true;
        for (std::size_t i = 0; i <= degree; ++i) {
            for (const auto& [to, k] : {std::pair{&there, i}, std::pair{&back, degree - i}}) {
                const std::size_t at = first + k * step;
                for (const double value : piece.points[at])
                    to->push_back(value + 0.0); // no -0, which is 0
                to->push_back(piece.weights.empty() ? 1 : piece.weights[at]);
            }
            is_point = is_point && piece.points[first + i * step] == piece.points[first];
        }
        if (!is_point)
            result[side] = boundary{std::min(there, back), back < there, there == back};
    }
    return result;
}

} // namespace

l3d_curved_pieces::l3d_curved_pieces(std::vector<l3d_patch_points> pieces,
                                     std::vector<l3d_model_edge> edges)
    : pieces_(std::move(pieces)), file_edges_(std::move(edges)),
      edges_(l3d_shared_edges(file_edges_, pieces_)), alike_(2 * pieces_.size()) {
    bool is_first = true;
    for (const l3d_patch_points& piece : pieces_) {
        has_trims_ = has_trims_ || !piece.trims.empty();
        const l3d_trim_place lengths = rough_lengths_of(piece);
        for (const l3d_trim_loop& loop : piece.trims)
            for (const l3d_trim_curve& curve : loop)
                trim_bends_ += std::sqrt(l3d_off_chord(curve, lengths));
        for (const auto& p : piece.points) {
            for (int k = 0; k < 3; ++k) {
                const double value = p[static_cast<std::size_t>(k)];
                least_[k] = is_first ? value : std::min(least_[k], value);
                most_[k] = is_first ? value : std::max(most_[k], value);
            }
            is_first = false;
        }
    }
    unite_common_boundaries();
}

/// The largest distance between an edge and its faces, among the edges that a region follows. It is
/// negative if the region follows no edge.
double l3d_curved_pieces::off_edges(const l3d_trim_region& region) const {
    double result = -1;
    for (const l3d_trim_polygon& polygon : region.polygons)
        for (const l3d_trim_corner& corner : polygon)
            if (corner.side.edge < edges_.size())
                result = std::max(result, edges_[corner.side.edge].off);
    return result;
}

/// Notes which ranges of u or v of pieces (lines) have to be cut alike, since the pieces have a
/// common boundary. A line that meets itself in reverse, as on a Moebius band, is cut
/// symmetrically.
void l3d_curved_pieces::unite_common_boundaries() {
    std::map<std::vector<double>, l3d_detail::directed_sets::place> lines;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const auto boundaries = boundaries_of(pieces_[i]);
        for (std::size_t side = 0; side < 4; ++side) {
            if (!boundaries[side])
                continue;
            const auto& [numbers, is_turned, is_symmetric] = *boundaries[side];
            const l3d_detail::directed_sets::place here{2 * i + side / 2, is_turned};
            alike_.join(lines.try_emplace(numbers, here).first->second, here);
            if (is_symmetric)
                alike_.join(here, {here.line, !is_turned});
        }
    }
}

double l3d_curved_pieces::place_target(int level) const {
    return std::ldexp(l3d_length(most_ - least_), -10 - level);
}

double l3d_curved_pieces::normal_target(int level) {
    return std::exp2(-9 - 1.5 * level);
}

double l3d_cell_wish::allowed(std::span<const l3d_vector<double, 4>> points) const {
    return region ? std::max(places, places_by_depth * region->least_depth(points)) : places;
}

double l3d_cell_wish::normals_of(const l3d_parameter_range& cell) const {
    const int halvings = -std::ilogb(cell.u1 - cell.u0) - std::ilogb(cell.v1 - cell.v0);
    return halvings < l3d_curved_pieces::most_halvings_for_normals + normals
               ? l3d_curved_pieces::normal_target(normals)
               : std::numeric_limits<double>::infinity();
}

bool l3d_curved_pieces::is_cut(const cuts& by, std::size_t index, double from, double to) const {
    const auto [root, is_turned] = alike_.find(index);
    const std::vector<double>& places = by.of_lines[root];
    const auto next = std::ranges::upper_bound(places, is_turned ? 1 - to : from);
    return next != places.end() && *next < (is_turned ? 1 - from : to);
}

template <class Visit>
void l3d_curved_pieces::visit_cells(std::size_t piece, const cuts& by, const l3d_cell_wish& wanted,
                                    const Visit& visit) const {
    for_each_cell(
        ranged_part{l3d_rational_piece(pieces_[piece])},
        [&](bool along_u, double from, double to) {
            return is_cut(by, 2 * piece + (along_u ? 0 : 1), from, to);
        },
        [&](const l3d_rational_piece& part) {
            return wanted.region && wanted.region->hides(part.points);
        },
        visit);
}

void l3d_curved_pieces::halve(cuts& by, std::size_t index, double place) const {
    const auto [root, is_turned] = alike_.find(index);
    std::vector<double>& places = by.of_lines[root];
    const auto add = [&](double at) {
        const auto next = std::ranges::lower_bound(places, at);
        if (next == places.end() || *next != at)
            places.insert(next, at);
    };
    if (!is_turned || alike_.runs_both_ways(root))
        add(place);
    if (is_turned || alike_.runs_both_ways(root))
        add(1 - place);
}

/// Halves cells with too large an error until there is no such cell. A halving cuts all cells of
/// the piece at this parameter, and the cells of all pieces that are cut alike.
l3d_curved_pieces::cuts l3d_curved_pieces::cuts_for(const l3d_cell_wish& wanted, const cuts& from,
                                                    l3d_found_cells& found) const {
    using places = std::vector<double>;
    struct seen_cells {
        double count = 0, error = 0;
        std::array<places, 2> halvings{}; ///< parameters of u and v at which cells are halved
    };
    const double of_cells = has_trims_ ? share_of_cells : 1;
    const double of_trims = (1 - of_cells) * wanted.places;
    std::vector<seen_cells> seen(pieces_.size());
    l3d_by_cell<verdict> known;
    const auto look = [&](std::size_t i, const cuts& by) {
        seen_cells result;
        visit_cells(i, by, wanted, [&](const ranged_part& of) {
            const l3d_parameter_range& at = of.range;
            const auto [place, is_new] = known.try_emplace(l3d_cell_key(i, at));
            if (is_new)
                place->second = judged(i, pieces_[i], at, of_cells * wanted.allowed(of.part.points),
                                       wanted.normals_of(at), found);
            const verdict& v = place->second;
            ++result.count;
            result.error = std::max(result.error, v.error);
            if (v.cut_u)
                result.halvings[0].push_back((at.u0 + at.u1) / 2);
            if (v.cut_v)
                result.halvings[1].push_back((at.v0 + at.v1) / 2);
        });
        return result;
    };
    cuts now = from;
    now.of_lines.resize(alike_.count());
    std::optional<cuts> before;
    std::vector<bool> is_new(alike_.count(), true); // whether a line was halved, by its root
    for (bool goes_on = true; goes_on;) {
        goes_on = false;
        cuts next = now;
        std::vector<bool> is_next_new(alike_.count(), false);
        now.cells = now.error = 0;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            const std::array roots{alike_.find(2 * i).line, alike_.find(2 * i + 1).line};
            if (is_new[roots[0]] || is_new[roots[1]])
                seen[i] = look(i, now);
            now.cells += seen[i].count;
            now.error = std::max(now.error, seen[i].error + of_trims);
            if (before && now.cells > most_cells)
                return *before;
            for (std::size_t along = 0; along < 2; ++along)
                for (const double place : seen[i].halvings[along]) {
                    halve(next, 2 * i + along, place);
                    is_next_new[roots[along]] = goes_on = true;
                }
        }
        before = std::exchange(now, std::move(next));
        is_new = std::move(is_next_new);
    }
    return *before;
}

l3d_curved_pieces::cells l3d_curved_pieces::cut(const cuts& by, const l3d_cell_wish& wanted,
                                                l3d_found_cells& found) const {
    cells result;
    std::vector<cell> all;
    double off = 0;
    for (const l3d_shared_edge& edge : edges_)
        off = std::max(off, edge.off);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        all.clear();
        visit_cells(i, by, wanted, [&](const ranged_part& of) {
            const auto make = [&]() -> const l3d_rational_piece& { return of.part; };
            const l3d_bicubic_approximation& one = found.patch(i, of.range, make);
            const l3d_normal_approximation& normals = found.normals(i, of.range, make);
            all.push_back(
                {one.patch, normals.net, of.range, one.error, wanted.allowed(of.part.points)});
            result.normal_error = std::max(result.normal_error, normals.error);
        });
        l3d_flatness of_trims;
        const auto add = [&](const cell& one, l3d_trim_region region) {
            result.patches.push_back(one.of);
            result.normals.push_back(one.normals);
            result.ranges.push_back(one.range);
            result.pieces.push_back(static_cast<std::uint32_t>(i));
            result.errors.push_back(one.error + of_trims.off);
            result.share = std::max(result.share, one.error / one.allowed +
                                                      (1 - share_of_cells) * of_trims.share);
            if (!edges_.empty())
                result.edges_off.push_back(off_edges(region));
            if (has_trims_)
                result.trims.push_back(std::move(region));
        };
        if (pieces_[i].trims.empty() || all.empty()) {
            for (const cell& one : all)
                add(one, {});
            continue;
        }
        l3d_trim_region region;
        const l3d_trim_place lengths = lengths_of(all);
        const auto allowed = [&](const l3d_trim_box& part) {
            return (1 - share_of_cells) *
                   (wanted.region ? allowed_in(part, all, lengths, wanted, off) : wanted.places);
        };
        of_trims = l3d_flat_trims(pieces_[i].trims, lengths, allowed, region);
        for_each_trimmed(all, {}, region.within({}), add);
    }
    return result;
}
