// SPDX-License-Identifier: MIT
// borders_of: finds sides that meet, and cuts curves into chords.
#include "scene/drawing/borders_p.h"

#include "geom/nurbs/bernstein_products_p.h"
#include "scene/drawing/curve_chords_p.h"
#include "scene/sides/side_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace l3d_detail {

namespace {

using vector = l3d_vector<double, 3>;

/// The angle from which on a side is a crease: two degrees. An angle of this size changes Lambert's
/// shade by eight levels, as in l3d_patch_neighbours.
constexpr double least_angle = 8 / 229.5;

/// A side of a piece, or a part of a side. Sides are v = 0, u = 1, v = 1, u = 0, in the order in
/// which one walks round the piece.
struct side {
    std::size_t piece, number;
    double from = 0, to = 1; ///< where the part begins and ends on the side

    /// The parameter that is constant along the side: 0 for u, 1 for v. at_end() is its value.
    std::size_t across() const { return number % 2 == 0 ? 1 : 0; }
    double at_end() const { return number == 1 || number == 2 ? 1 : 0; }
    std::array<double, 2> place(double t) const {
        return l3d_side_pairs::place_on(number, on_side(t));
    }
    /// The parameter on the whole side for the parameter t of the part.
    double on_side(double t) const { return from + (to - from) * t; }
    /// The part's parameter at the place (u, v); below 0 if the place is not on the part.
    double parameter(double u, double v) const {
        const double along = number % 2 == 0 ? u : v, across = number % 2 == 0 ? v : u;
        if (across != (number == 1 || number == 2 ? 1 : 0))
            return -1;
        const double t = ((number < 2 ? along : 1 - along) - from) / (to - from);
        return t <= 1 ? t : -1;
    }
    std::array<side, 2> halves() const {
        const double middle = (from + to) / 2;
        return {{{piece, number, from, middle}, {piece, number, middle, to}}};
    }
    friend bool operator==(const side&, const side&) = default;
};

constexpr int places_of_side = 5;

/// A side, and some of its places in the world, at equal steps of its parameter. Sides that
/// coincide are found by these places.
struct placed_side {
    side of;
    std::size_t instance;
    std::array<vector, places_of_side> places{};

    placed_side(const image_piece& piece, const side& one) : of(one), instance(piece.instance) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            const auto [u, v] = of.place(double(i) / (places_of_side - 1));
            const auto p = piece.world.evaluate(u, v).value;
            places[i] = {p[0] / p[3], p[1] / p[3], p[2] / p[3]};
        }
    }
    bool is_at(const placed_side& other, bool backwards, double same) const {
        if (instance != other.instance)
            return false;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const std::size_t k = backwards ? places.size() - 1 - i : i;
            if (!(l3d_length(places[i] - other.places[k]) <= same))
                return false;
        }
        return true;
    }
};

/// The curve along a side of a net. Shape: a net with n = 0.
bernstein_net curve_along(const bernstein_net& net, std::size_t number) {
    const int degree = number % 2 == 0 ? net.m : net.n;
    bernstein_net result(degree, 0, net.dims);
    for (int i = 0; i <= degree; ++i) {
        const auto [u, v] = l3d_side_pairs::place_on(number, double(i) / degree);
        const int column = static_cast<int>(std::lround(u * net.m));
        const int row = static_cast<int>(std::lround(v * net.n));
        std::copy_n(net.at(row, column), net.dims, result.at(0, i));
    }
    return result;
}

/// The curve on the surface over the straight line of parameters from a to b. It is the diagonal of
/// the net's part between a and b, since B_i(t) B_j(t) is a multiple of B_(i+j)(t).
bernstein_net curve_between(const bernstein_net& net, const l3d_trim_place& a,
                            const l3d_trim_place& b) {
    const bernstein_net part = net.part(a[0], b[0], a[1], b[1]);
    bernstein_net result(net.m + net.n, 0, net.dims);
    for (int r = 0; r <= net.n; ++r)
        for (int k = 0; k <= net.m; ++k)
            for (int d = 0; d < net.dims; ++d)
                result.at(0, r + k)[d] += part.at(r, k)[d] * binomial(net.m, k) *
                                          binomial(net.n, r) / binomial(net.m + net.n, r + k);
    return result;
}

/// Visits the sides of a region's polygons on a line of equal u (along = 0) or v (along = 1).
template <class Visit>
void for_sides_on(const l3d_trim_region& region, std::size_t along, double at, const Visit& visit) {
    for (const l3d_trim_polygon& polygon : region.polygons)
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const l3d_trim_corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            if (a[along] == at && b[along] == at)
                visit(a, b);
        }
}

/// Whether any stretch of a side is left by the piece's trims and follows no edge of the model.
bool reaches(const image_piece& piece, const side& one) {
    bool result = !piece.is_trimmed;
    if (piece.is_trimmed)
        for_sides_on(piece.region, one.across(), one.at_end(),
                     [&](const l3d_trim_corner& a, const l3d_trim_corner&) {
                         result = result || a.side.edge == l3d_no_edge;
                     });
    return result;
}

/// Sides that coincide. `forward` tells whether each runs in the direction of the first.
struct met_sides {
    std::vector<side> sides;
    std::vector<bool> forward;
};

class border_search {
public:
    border_search(std::span<const image_piece> pieces,
                  std::span<const std::vector<surface_line>> contours, const drawing_view& view,
                  double tolerance)
        : pieces_(pieces), contours_(contours), view_(view), tolerance_(tolerance) {}

    std::vector<drawn_chain> chains() {
        pair_sides();
        for (std::size_t i = 0; i < pieces_.size(); ++i)
            if (pieces_[i].is_trimmed)
                add_trims(i);
        return std::move(chains_);
    }

private:
    void pair_sides();
    static std::vector<met_sides> all_met(std::vector<placed_side> all, double same);
    void add_side(const met_sides& met);
    void add_contours(const side& a, const side& b, bool turns);
    bool is_smooth(const side& a, const side& b, bool turns) const;
    void add_trims(std::size_t piece);
    /// Adds a stretch of a side as a line.
    void add(const side& of, double from, double to, l3d_line_kind kind,
             const std::vector<std::size_t>& sides);

    std::span<const image_piece> pieces_;
    std::span<const std::vector<surface_line>> contours_;
    const drawing_view& view_;
    double tolerance_;
    std::vector<drawn_chain> chains_;
};

/// Finds sides that coincide, and adds their lines. Sides coincide if their places agree to about a
/// thousandth of a pixel. A side that coincides with no other side may coincide with a half of
/// another side, or its halves with other sides.
void border_search::pair_sides() {
    std::vector<placed_side> all;
    vector least(std::numeric_limits<double>::max()), most(-least[0]);
    for (std::size_t i = 0; i < pieces_.size(); ++i)
        for (std::size_t k = 0; k < l3d_side_pairs::sides; ++k) {
            if (!reaches(pieces_[i], {i, k}))
                continue;
            const placed_side one(pieces_[i], {i, k});
            for (const vector& p : one.places)
                for (int d = 0; d < 3; ++d) {
                    least[d] = std::min(least[d], p[d]);
                    most[d] = std::max(most[d], p[d]);
                }
            all.push_back(one);
        }
    const double same = 1e-6 * l3d_length(most - least);
    std::erase_if(all, [&](const placed_side& one) { // a point has no line
        return std::ranges::all_of(
            one.places, [&](const vector& p) { return l3d_length(p - one.places[0]) <= same; });
    });
    std::vector<side> alone;
    std::vector<placed_side> again;
    for (const met_sides& met : all_met(std::move(all), same)) {
        if (met.sides.size() > 1) {
            add_side(met);
            continue;
        }
        const side& one = met.sides[0];
        alone.push_back(one);
        again.emplace_back(pieces_[one.piece], one);
        for (const side& half : one.halves())
            again.emplace_back(pieces_[one.piece], half);
    }
    std::vector<side> met_now;
    for (const met_sides& met : all_met(std::move(again), same))
        if (met.sides.size() > 1) {
            add_side(met);
            met_now.insert(met_now.end(), met.sides.begin(), met.sides.end());
        }
    const auto is_met = [&](const side& one) {
        return std::ranges::find(met_now, one) != met_now.end();
    };
    for (const side& one : alone) {
        const auto halves = one.halves();
        if (!is_met(one) && !is_met(halves[0]) && !is_met(halves[1]))
            add_side({{one}, {true}});
        else if (!is_met(one))
            for (const side& half : halves)
                if (!is_met(half))
                    add_side({{half}, {true}});
    }
}

std::vector<met_sides> border_search::all_met(std::vector<placed_side> all, double same) {
    constexpr int middle = places_of_side / 2;
    const auto x_of = [](const placed_side& one) { return one.places[middle][0]; };
    std::ranges::stable_sort(all, {}, x_of);
    std::vector<bool> is_met(all.size(), false);
    std::vector<met_sides> result;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (is_met[i])
            continue;
        met_sides& met = result.emplace_back(met_sides{{all[i].of}, {true}});
        for (std::size_t k = i + 1; k < all.size() && x_of(all[k]) - x_of(all[i]) <= same; ++k) {
            const bool there = all[k].is_at(all[i], false, same);
            if (is_met[k] || (!there && !all[k].is_at(all[i], true, same)))
                continue;
            is_met[k] = true;
            met.sides.push_back(all[k].of);
            met.forward.push_back(there);
        }
    }
    return result;
}

bool border_search::is_smooth(const side& a, const side& b, bool turns) const {
    constexpr int places = 5;
    for (int i = 0; i < places; ++i) {
        const double t = (i + 0.5) / places;
        const auto [u, v] = a.place(t);
        const auto [s, r] = b.place(turns ? t : 1 - t);
        const auto n = pieces_[a.piece].normal(u, v);
        const auto o = pieces_[b.piece].normal(s, r) * (turns ? -1.0 : 1.0);
        if (!have_one_plane(n, o))
            return false;
    }
    return true;
}

void border_search::add_side(const met_sides& met) {
    const std::vector<side>& sides = met.sides;
    std::vector<std::size_t> pieces;
    for (const side& one : sides)
        if (std::ranges::find(pieces, one.piece) == pieces.end())
            pieces.push_back(one.piece);
    if (sides.size() == 1) {
        add(sides[0], 0, 1, l3d_line_kind::border, pieces);
        return;
    }
    const bool turns = met.forward[0] == met.forward[1];
    if (sides.size() == 2 && is_smooth(sides[0], sides[1], turns))
        add_contours(sides[0], sides[1], turns);
    else
        add(sides[0], 0, 1, l3d_line_kind::crease, pieces);
}

/// Adds the stretches of a common side that are contours. A stretch lies between neighbouring ends
/// of the pieces' contours. A stretch is a contour if just one of both pieces shows its front.
void border_search::add_contours(const side& a, const side& b, bool turns) {
    std::vector<double> ends{0, 1};
    for (const side* const one : {&a, &b})
        for (const surface_line& line : contours_[one->piece])
            for (const surface_vertex* const end : {&line.front(), &line.back()})
                if (const double t = one->parameter(end->u, end->v); t >= 0)
                    ends.push_back(one == &a || turns ? t : 1 - t);
    std::ranges::sort(ends);
    constexpr double least = 1e-9; // closer ends are the same to within rounding
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        if (ends[i + 1] - ends[i] < least)
            continue;
        const double t = (ends[i] + ends[i + 1]) / 2;
        const auto [u, v] = a.place(t);
        const auto [s, r] = b.place(turns ? t : 1 - t);
        const bool one = pieces_[a.piece].contour.evaluate(u, v).value[0] >= 0;
        const bool two = pieces_[b.piece].contour.evaluate(s, r).value[0] >= 0;
        if ((one != two) != turns)
            add(a, ends[i], ends[i + 1], l3d_line_kind::contour, {a.piece, b.piece});
    }
}

/// The parts of a line of equal u (along = 0) or equal v (along = 1) that are in a region and
/// follow no edges of the model.
std::vector<std::array<double, 2>> free_stretches(const l3d_trim_region& region, std::size_t along,
                                                  double at) {
    std::vector<std::array<double, 2>> result = region.stretches(along, at), edges;
    for_sides_on(region, along, at, [&](const l3d_trim_corner& a, const l3d_trim_corner& b) {
        if (a.side.edge != l3d_no_edge)
            edges.push_back(
                {std::min(a[1 - along], b[1 - along]), std::max(a[1 - along], b[1 - along])});
    });
    for (const auto& [from, to] : edges) {
        std::vector<std::array<double, 2>> left;
        for (const auto& [low, high] : result) {
            if (low < std::min(high, from))
                left.push_back({low, std::min(high, from)});
            if (std::max(low, to) < high)
                left.push_back({std::max(low, to), high});
        }
        result = std::move(left);
    }
    return result;
}

void border_search::add(const side& of, double from, double to, l3d_line_kind kind,
                        const std::vector<std::size_t>& sides) {
    const image_piece& piece = pieces_[of.piece];
    from = of.on_side(from);
    to = of.on_side(to);
    std::vector<std::array<double, 2>> stretches{{from, to}};
    if (piece.is_trimmed) {
        // The walk along sides 2 and 3 goes down.
        stretches.clear();
        const bool is_back = of.number >= 2;
        for (const auto& [low, high] : free_stretches(piece.region, of.across(), of.at_end())) {
            const double first = std::max(from, is_back ? 1 - high : low);
            const double last = std::min(to, is_back ? 1 - low : high);
            if (first < last)
                stretches.push_back({first, last});
        }
    }
    const bernstein_net curve = curve_along(piece.net, of.number);
    for (const auto& [first, last] : stretches) {
        curve_chords flat(of.piece, view_, tolerance_);
        flat.add(curve.part(first, last, 0, 1), [&, first = first, last = last](double t) {
            return l3d_side_pairs::place_on(of.number, first + (last - first) * t);
        });
        for (surface_line& line : flat.take())
            chains_.push_back({kind, std::move(line), sides});
    }
}

void border_search::add_trims(std::size_t number) {
    const image_piece& piece = pieces_[number];
    for (const l3d_trim_polygon& polygon : piece.region.polygons) {
        curve_chords flat(number, view_, tolerance_);
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const l3d_trim_corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            const auto on_side = [&](std::size_t k) {
                return a[k] == b[k] && (a[k] == 0 || a[k] == 1);
            };
            if (a.side.edge != l3d_no_edge || on_side(0) || on_side(1))
                continue;
            flat.add(curve_between(piece.net, a, b), [&](double t) -> std::array<double, 2> {
                return {a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t};
            });
        }
        for (surface_line& line : flat.take())
            chains_.push_back({l3d_line_kind::border, std::move(line), {number}});
    }
}

} // namespace

std::vector<drawn_chain> borders_of(std::span<const image_piece> pieces,
                                    std::span<const std::vector<surface_line>> contours,
                                    const drawing_view& view, double tolerance) {
    return border_search(pieces, contours, view, tolerance).chains();
}

bool have_one_plane(const l3d_vector<double, 3>& n, const l3d_vector<double, 3>& o) {
    return l3d_length(n) == 0 || l3d_length(o) == 0 ||
           (l3d_dot(n, o) > 0 && l3d_length(l3d_cross(n, o)) < least_angle);
}

std::vector<surface_line> trimmed(const image_piece& piece, const surface_line& line) {
    if (!piece.is_trimmed)
        return {line};
    std::vector<surface_line> result;
    bool goes_on = false;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const surface_vertex &a = line[i], &b = line[i + 1];
        const double du = b.u - a.u, dv = b.v - a.v;
        std::vector<double> cuts{0, 1};
        for (const l3d_trim_polygon& polygon : piece.region.polygons)
            for (std::size_t k = 0; k < polygon.size(); ++k) {
                const l3d_trim_place &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
                const double pu = q[0] - p[0], pv = q[1] - p[1];
                const double across = du * pv - dv * pu;
                const double t = ((p[0] - a.u) * pv - (p[1] - a.v) * pu) / across;
                const double s = ((p[0] - a.u) * dv - (p[1] - a.v) * du) / across;
                if (t > 0 && t < 1 && s >= 0 && s <= 1)
                    cuts.push_back(t);
            }
        std::ranges::sort(cuts);
        const auto vertex = [&](double t) {
            if (t == 0 || t == 1)
                return t == 0 ? a : b;
            surface_vertex c{.piece = a.piece, .u = a.u + du * t, .v = a.v + dv * t};
            // The parameters stay on the polygon, as they tell on which edge the place lies.
            const auto exact = on_contour(piece, c);
            c.at = exact ? exact->at : piece.at(c.u, c.v);
            return c;
        };
        for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
            const double middle = (cuts[k] + cuts[k + 1]) / 2;
            const bool is_there = piece.contains(a.u + du * middle, a.v + dv * middle);
            if (is_there && !goes_on)
                result.push_back({vertex(cuts[k])});
            if (is_there)
                result.back().push_back(vertex(cuts[k + 1]));
            goes_on = is_there;
        }
    }
    return result;
}

} // namespace l3d_detail
