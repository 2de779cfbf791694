// SPDX-License-Identifier: MIT
// l3d_curved_pieces: as many cells as a level needs.
#include "scene/curved_pieces.h"

#include "geom/bicubic_approximation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace {

using patch = l3d_curved_pieces::patch;

/// Calls `visit` with each of 2^m by 2^n parts.
template <class Piece, class Visit>
void for_each_part(const Piece& piece, int m, int n, const Visit& visit) {
    if (m == 0 && n == 0)
        return visit(piece);
    // The direction with more cuts to come goes first, so that parts stay compact.
    const bool along_u = m >= n;
    const auto halves = piece.halves(along_u);
    for (const Piece* half : {&halves.first, &halves.second})
        for_each_part(*half, along_u ? m - 1 : m, along_u ? n : n - 1, visit);
}

/// A part of a piece, and where it is in the piece.
struct ranged_part {
    l3d_rational_piece part;
    l3d_parameter_range range{};

    std::pair<ranged_part, ranged_part> halves(bool along_u) const {
        auto [first, second] = part.halves(along_u);
        return {{std::move(first), range.half(along_u, false)},
                {std::move(second), range.half(along_u, true)}};
    }
};

/// A cell of a piece.
struct cell {
    patch of;
    l3d_parameter_range range;
};

/// How long a unit of the piece's u and v is at most in its cells: 3 differences of control points
/// for each of their own.
l3d_trim_place lengths_of(std::span<const cell> cells) {
    l3d_trim_place result{0, 0};
    for (const auto& [of, range] : cells)
        for (int i = 0; i < 4; ++i)
            for (int k = 0; k < 3; ++k) {
                const double by_u = l3d_length(of.at(i, k + 1) - of.at(i, k));
                const double by_v = l3d_length(of.at(k + 1, i) - of.at(k, i));
                result[0] = std::max(result[0], 3 * by_u / (range.u1 - range.u0));
                result[1] = std::max(result[1], 3 * by_v / (range.v1 - range.v0));
            }
    return result;
}

/// Calls visit(cell, region) for each cell of a part of a piece of which the trims leave something.
/// The region is empty where they leave all.
template <class Visit>
void for_each_trimmed(std::span<const cell> cells, const l3d_parameter_range& part,
                      const l3d_trim_region& region, const Visit& visit) {
    const l3d_trim_box box{{part.u0, part.v0}, {part.u1, part.v1}};
    if (region.is_empty())
        return;
    if (region.is_all_of(box)) {
        for (const cell& one : cells)
            visit(one, l3d_trim_region());
        return;
    }
    if (cells.size() == 1)
        return visit(cells.front(), region.in_box(box));
    // Cells come in the order of halves of halves.
    const std::size_t half = cells.size() / 2;
    const bool along_u = cells[half - 1].range.u1 < part.u1;
    const l3d_parameter_range first = part.half(along_u, false);
    const auto [low, high] = region.halves(along_u ? 0 : 1, along_u ? first.u1 : first.v1);
    for_each_trimmed(cells.first(half), first, low, visit);
    for_each_trimmed(cells.subspan(half), part.half(along_u, true), high, visit);
}

/// The part of a piece that is off the most.
struct worst_part {
    double off = 0;
    std::optional<l3d_rational_piece> part;

    void take(double here, const l3d_rational_piece& of) {
        if (!(here > off))
            return;
        off = here;
        part = of;
    }
};

/// The control points of the four boundaries, as numbers, in the direction that is first in order.
/// Nothing for a boundary that is a point.
std::array<std::optional<std::vector<double>>, 4> boundaries_of(const l3d_patch_points& piece) {
    const auto m = static_cast<std::size_t>(piece.degree_u);
    const auto n = static_cast<std::size_t>(piece.degree_v);
    const std::size_t width = m + 1;
    const std::array<std::array<std::size_t, 3>, 4> lines{
        {{0, 1, m}, {n * width, 1, m}, {0, width, n}, {m, width, n}}}; // first, step, degree
    std::array<std::optional<std::vector<double>>, 4> result;
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
            result[side] = std::min(there, back);
    }
    return result;
}

} // namespace

l3d_curved_pieces::l3d_curved_pieces(std::vector<l3d_patch_points> pieces)
    : pieces_(std::move(pieces)), alike_(2 * pieces_.size()) {
    bool is_first = true;
    for (const l3d_patch_points& piece : pieces_) {
        has_trims_ = has_trims_ || !piece.trims.empty();
        for (const auto& p : piece.points) {
            for (int k = 0; k < 3; ++k) {
                const double value = p[static_cast<std::size_t>(k)];
                least_[k] = is_first ? value : std::min(least_[k], value);
                most_[k] = is_first ? value : std::max(most_[k], value);
            }
            is_first = false;
        }
    }
    std::iota(alike_.begin(), alike_.end(), std::size_t{0});
    unite_common_boundaries();
}

std::size_t l3d_curved_pieces::root_of(std::size_t line) const {
    while (alike_[line] != line)
        line = alike_[line];
    return line;
}

void l3d_curved_pieces::unite_common_boundaries() {
    std::map<std::vector<double>, std::size_t> lines;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const auto boundaries = boundaries_of(pieces_[i]);
        for (std::size_t side = 0; side < 4; ++side) {
            if (!boundaries[side])
                continue;
            const std::size_t line = 2 * i + side / 2;
            const auto [there, is_new] = lines.try_emplace(*boundaries[side], line);
            if (!is_new)
                alike_[root_of(line)] = root_of(there->second);
        }
    }
}

double l3d_curved_pieces::place_target(int level) const {
    return std::ldexp(l3d_length(most_ - least_), -10 - 2 * level);
}

double l3d_curved_pieces::normal_target(int level) {
    return std::exp2(-9 - 1.5 * level);
}

/// Each line is halved until places are well in all cells along it, and then until normals are. The
/// worst cell of a piece decides which way the piece is cut: its halves tell.
l3d_curved_pieces::cuts l3d_curved_pieces::cuts_at(int places, int normals,
                                                   const cuts& from) const {
    // Where normals have no bound, as at a cusp, cutting may never give one. The cells along whole
    // lines are cut for one only if 16 by 16 parts of it all have one.
    constexpr int most_without_bound = 4;
    // Rounding, or a cusp, is reached where halving no longer gains a tenth.
    constexpr double gain = 0.9;
    // Trims get three quarters of the error of places. For a quarter, cells need hardly more
    // halvings.
    const double wanted_place = place_target(places) / (has_trims_ ? 4 : 1);
    const double wanted_normal = normal_target(normals);
    std::vector<int> of_line = from.of_lines;
    of_line.resize(alike_.size());
    std::vector<bool> is_done(pieces_.size(), false);
    std::vector<double> off(pieces_.size(), 0);
    const auto halvings = [&](std::size_t i) {
        return std::pair(of_line[root_of(2 * i)], of_line[root_of(2 * i + 1)]);
    };
    const auto cells_now = [&] {
        double sum = 0;
        for (std::size_t i = 0; i < pieces_.size(); ++i)
            sum += std::ldexp(1.0, halvings(i).first + halvings(i).second);
        return sum;
    };
    for (bool goes_on = true; goes_on;) {
        goes_on = false;
        std::vector<int> next = of_line;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (is_done[i])
                continue;
            const auto [along_u, along_v] = halvings(i);
            worst_part of_places, of_normals;
            for_each_part(l3d_rational_piece(pieces_[i]), along_u, along_v,
                          [&](const l3d_rational_piece& part) {
                              const l3d_bicubic_approximation by(part);
                              of_places.take(by.error, part);
                              of_normals.take(by.normal_error, part);
                          });
            off[i] = of_places.off;
            const bool is_off = of_places.off > wanted_place;
            if (!is_off && (!(of_normals.off > wanted_normal) ||
                            along_u + along_v >= most_halvings_for_normals(normals))) {
                is_done[i] = true; // finer cells of neighbours make it no worse
                continue;
            }
            const worst_part& worst = is_off ? of_places : of_normals;
            const double now_off = worst.off;
            const auto left_by = [&](int m, int n) {
                double most = 0;
                for_each_part(*worst.part, m, n, [&](const l3d_rational_piece& part) {
                    const l3d_bicubic_approximation by(part);
                    most = std::max(most, is_off ? by.error : by.normal_error);
                });
                return most;
            };
            const double by_u = left_by(1, 0), by_v = left_by(0, 1);
            bool in_u = by_u < gain * now_off && by_u <= by_v;
            bool in_v = by_v < gain * now_off && by_v < by_u;
            if (!in_u && !in_v) {
                const bool helps = left_by(1, 1) < gain * now_off;
                const bool may_help =
                    std::isinf(now_off) &&
                    std::isfinite(left_by(most_without_bound, most_without_bound));
                in_u = in_v = helps || may_help;
                is_done[i] = !in_u;
            }
            for (const auto& [line, is_cut] : {std::pair{2 * i, in_u}, std::pair{2 * i + 1, in_v}})
                if (is_cut)
                    next[root_of(line)] = of_line[root_of(line)] + 1;
            goes_on = goes_on || in_u || in_v;
        }
        std::swap(of_line, next);
        if (cells_now() > static_cast<double>(most_cells)) {
            of_line = next; // as it was before
            break;
        }
    }
    cuts result;
    for (std::size_t line = 0; line < alike_.size(); ++line)
        result.of_lines.push_back(of_line[root_of(line)]);
    for (const double here : off)
        result.error = std::max(result.error, here);
    result.trims = has_trims_ ? 3 * wanted_place : 0;
    result.error += result.trims;
    return result;
}

l3d_curved_pieces::cells l3d_curved_pieces::cut(const cuts& by) const {
    cells result;
    double of_trims = 0;
    std::vector<cell> all;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        all.clear();
        for_each_part(ranged_part{l3d_rational_piece(pieces_[i])}, by.of_lines[2 * i],
                      by.of_lines[2 * i + 1], [&](const ranged_part& of) {
                          const l3d_bicubic_approximation one(of.part);
                          all.push_back({one.patch, of.range});
                          result.error = std::max(result.error, one.error);
                          result.normal_error = std::max(result.normal_error, one.normal_error);
                      });
        const auto add = [&](const cell& one, l3d_trim_region region) {
            result.patches.push_back(one.of);
            result.ranges.push_back(one.range);
            result.pieces.push_back(static_cast<std::uint32_t>(i));
            if (has_trims_)
                result.trims.push_back(std::move(region));
        };
        if (pieces_[i].trims.empty()) {
            for (const cell& one : all)
                add(one, {});
            continue;
        }
        l3d_trim_region region;
        of_trims =
            std::max(of_trims, l3d_flat_trims(pieces_[i].trims, lengths_of(all), by.trims, region));
        for_each_trimmed(all, {}, region.within({}), add);
    }
    result.error += of_trims;
    return result;
}
