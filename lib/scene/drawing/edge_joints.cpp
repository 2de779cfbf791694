// SPDX-License-Identifier: MIT
// edge_joints: finds which pieces have each part of an edge, and which kind of line it is there.
#include "scene/drawing/edge_joints_p.h"

#include "scene/drawing/curve_chords_p.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace l3d_detail {

namespace {

/// Parameters that differ by less than this part of an edge count as the same.
constexpr double same_part = 1e-9;

double length_between(const image_place& a, const image_place& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

l3d_trim_place between(const l3d_trim_place& a, const l3d_trim_place& b, double t) {
    return {a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t};
}

/// The share of the way from a to b, along the side of a polygon, at which a place lies. It is
/// below 0 if the place does not lie on the side.
double part_on(const l3d_trim_place& a, const l3d_trim_place& b, const surface_vertex& at) {
    constexpr double rounding = 1e-9; // cuts at a side err by less; any side is far longer
    const double du = b[0] - a[0], dv = b[1] - a[1], square = du * du + dv * dv;
    const double t = ((at.u - a[0]) * du + (at.v - a[1]) * dv) / square;
    if (!(t >= -rounding && t <= 1 + rounding))
        return -1;
    const l3d_trim_place on = between(a, b, t);
    return std::hypot(at.u - on[0], at.v - on[1]) <= rounding ? std::clamp(t, 0.0, 1.0) : -1;
}

} // namespace

image_edge::image_edge(const l3d_shared_edge& edge, const l3d_patch_instance& instance,
                       const drawing_view& view) {
    double least_z = 0;
    bool is_ahead = true;
    for (const l3d_shared_edge::span& one : edge.spans) {
        bernstein_net net(static_cast<int>(one.points.size()) - 1, 0, 4);
        for (std::size_t i = 0; i < one.points.size(); ++i) {
            const l3d_vector<double, 4> p = instance.placement() * one.points[i];
            std::ranges::copy(view.placed({p[0], p[1], p[2], p[3]}),
                              net.at(0, static_cast<int>(i)));
        }
        is_ahead = is_ahead && side_of_near(net, view) == ahead_of_near::all;
        if (is_ahead)
            least_z = std::min(least_z, bounds_of(net).near);
        spans.push_back({one.from, one.to, std::move(net)});
    }
    const double longer = instance.scale() > 0 ? instance.scale() : l3d_length(instance.terms());
    if (is_ahead) // where an edge reaches the near plane, nothing is bounded
        off = edge.off * longer * view.scale_at(least_z);
}

std::vector<image_edge::span> image_edge::between(double from, double to) const {
    std::vector<span> result;
    for (const span& one : spans) {
        const double range = one.to - one.from;
        const double first = std::max((from - one.from) / range, 0.0);
        const double last = std::min((to - one.from) / range, 1.0);
        if (first < last)
            result.push_back({std::lerp(one.from, one.to, first), std::lerp(one.from, one.to, last),
                              one.net.part(first, last, 0, 1)});
    }
    return result;
}

image_place image_edge::at(double t) const {
    const auto next = std::ranges::find_if(spans, [&](const span& one) { return t <= one.to; });
    const span& one = next == spans.end() ? spans.back() : *next;
    const auto p = one.net.evaluate(std::clamp((t - one.from) / (one.to - one.from), 0.0, 1.0), 0);
    return {p.value[0] / p.value[2], p.value[1] / p.value[2], p.value[3] / p.value[2]};
}

edge_joints::edge_joints(std::span<const image_piece> pieces, std::span<const image_edge> edges,
                         const drawing_view& view, double tolerance)
    : pieces_(pieces), edges_(edges), view_(view), tolerance_(tolerance), uses_(edges.size()),
      contours_(edges.size()) {
    for (std::size_t i = 0; i < pieces.size(); ++i)
        add_uses(i);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const double same = same_part * (edges[i].spans.back().to - edges[i].spans.front().from);
        for (edge_use& use : uses_[i]) {
            std::ranges::sort(use.sides, {}, &trim_side::from);
            for (const trim_side& one : use.sides)
                if (!use.stretches.empty() && one.from <= use.stretches.back()[1] + same)
                    use.stretches.back()[1] = std::max(use.stretches.back()[1], one.to);
                else
                    use.stretches.push_back({one.from, one.to});
            // A place beside the middle of the longest side tells where the piece lies.
            const trim_side& side = *std::ranges::max_element(use.sides, {}, [](const auto& one) {
                return std::hypot(one.b[0] - one.a[0], one.b[1] - one.a[1]);
            });
            constexpr double beside = 1e-6;
            const l3d_trim_place middle = l3d_detail::between(side.a, side.b, 0.5);
            use.is_left = pieces_[use.piece].contains(middle[0] - beside * (side.b[1] - side.a[1]),
                                                      middle[1] + beside * (side.b[0] - side.a[0]));
        }
    }
}

void edge_joints::add_uses(std::size_t number) {
    const image_piece& piece = pieces_[number];
    for (const l3d_trim_polygon& polygon : piece.region.polygons)
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const l3d_trim_corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            const l3d_trim_use& side = a.side;
            if (side.edge == l3d_no_edge || side.from == side.to || a == b)
                continue;
            const bool is_back = side.from > side.to;
            std::vector<edge_use>& uses = uses_[piece.first_edge + side.edge];
            auto use = std::ranges::find_if(uses, [&](const edge_use& one) {
                return one.piece == number && one.is_back == is_back;
            });
            if (use == uses.end())
                use = uses.insert(use, {number, is_back, false, {}, {}});
            use->sides.push_back(is_back ? trim_side{side.to, side.from, b, a}
                                         : trim_side{side.from, side.to, a, b});
        }
}

std::array<double, 2> edge_joints::edge_use::place(double t) const {
    auto side = std::ranges::upper_bound(sides, t, {}, &trim_side::from);
    if (side != sides.begin())
        --side;
    return l3d_detail::between(side->a, side->b,
                               std::clamp((t - side->from) / (side->to - side->from), 0.0, 1.0));
}

bool edge_joints::edge_use::has(double t) const {
    return std::ranges::any_of(stretches,
                               [&](const auto& one) { return one[0] <= t && t <= one[1]; });
}

void edge_joints::end_on_edges(std::span<std::vector<surface_line>> contours, double near) {
    std::vector<std::vector<contour_end>> ends(edges_.size());
    for (std::size_t i = 0; i < pieces_.size(); ++i)
        for (surface_line& line : contours[i])
            for (surface_vertex* const vertex : {&line.front(), &line.back()})
                for (const l3d_trim_polygon& polygon : pieces_[i].region.polygons)
                    for (std::size_t k = 0; k < polygon.size(); ++k) {
                        const l3d_trim_corner& a = polygon[k];
                        if (a.side.edge == l3d_no_edge)
                            continue;
                        const double part = part_on(a, polygon[(k + 1) % polygon.size()], *vertex);
                        if (part >= 0)
                            ends[pieces_[i].first_edge + a.side.edge].push_back(
                                {a.side.at(part), vertex});
                    }
    for (std::size_t i = 0; i < edges_.size(); ++i) {
        std::ranges::sort(ends[i], {}, &contour_end::t);
        for (std::size_t k = 0; k < ends[i].size(); ++k) {
            double t = ends[i][k].t;
            const bool is_pair =
                k + 1 < ends[i].size() &&
                length_between(edges_[i].at(t), edges_[i].at(ends[i][k + 1].t)) <= near;
            if (is_pair)
                t = (t + ends[i][k + 1].t) / 2;
            ends[i][k].vertex->at = edges_[i].at(t);
            if (is_pair)
                ends[i][++k].vertex->at = edges_[i].at(t);
            contours_[i].push_back(t);
        }
    }
}

/// The parameters that divide an edge into stretches, so that the same pieces end at all of a
/// stretch. Pieces of one face may have ends that differ a little, as each piece makes polygons of
/// its own.
std::vector<double> edge_joints::cuts_of(std::size_t edge) const {
    std::vector<double> all;
    for (const edge_use& use : uses_[edge])
        for (const auto& [from, to] : use.stretches)
            all.insert(all.end(), {from, to});
    std::ranges::sort(all);
    std::vector<double> result;
    for (const double t : all)
        if (result.empty() ||
            length_between(edges_[edge].at(result.back()), edges_[edge].at(t)) > 2 * tolerance_)
            result.push_back(t);
    if (result.size() > 1)
        result.back() = all.back();
    else if (!all.empty())
        result = {all.front(), all.back()};
    return result;
}

bool edge_joints::is_smooth(const edge_use& a, const edge_use& b, double from, double to) const {
    const bool turns = a.is_left == b.is_left;
    constexpr int places = 5;
    for (int i = 0; i < places; ++i) {
        const double t = from + (to - from) * (i + 0.5) / places;
        const auto [u, v] = a.place(t);
        const auto [s, r] = b.place(t);
        if (!have_one_plane(pieces_[a.piece].normal(u, v),
                            pieces_[b.piece].normal(s, r) * (turns ? -1.0 : 1.0)))
            return false;
    }
    return true;
}

/// Adds the lines along a stretch of an edge. A smooth edge is divided at the ends of the pieces'
/// contours. A stretch is a contour if just one of both pieces shows its front there.
void edge_joints::add_joint(std::size_t edge, const edge_use& a, const edge_use& b, double from,
                            double to, bool with_joints, std::vector<drawn_chain>& result) const {
    const std::vector<std::size_t> sides{a.piece, b.piece};
    std::vector<double> ends{from};
    for (const double t : contours_[edge])
        if (t > from && t < to)
            ends.push_back(t);
    ends.push_back(to);
    const bool turns = a.is_left == b.is_left;
    const auto is_front = [&](const edge_use& use, double t) {
        const auto [u, v] = use.place(t);
        return pieces_[use.piece].contour.evaluate(u, v).value[0] >= 0;
    };
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double middle = (ends[i] + ends[i + 1]) / 2;
        if ((is_front(a, middle) != is_front(b, middle)) != turns)
            add(edge, ends[i], ends[i + 1], l3d_line_kind::contour, sides, result);
        else if (with_joints)
            add(edge, ends[i], ends[i + 1], l3d_line_kind::joint, sides, result);
    }
}

void edge_joints::add(std::size_t edge, double from, double to, l3d_line_kind kind,
                      const std::vector<std::size_t>& sides,
                      std::vector<drawn_chain>& result) const {
    curve_chords chords(sides.front(), view_, tolerance_);
    for (const image_edge::span& part : edges_[edge].between(from, to))
        chords.add(part.net, [&](double t) {
            return std::array{std::lerp(part.from, part.to, t), 0.0};
        });
    for (surface_line& line : chords.take())
        result.push_back({kind, std::move(line), sides, {}, edge});
}

std::vector<drawn_chain> edge_joints::chains(bool with_joints) const {
    std::vector<drawn_chain> result;
    for (std::size_t edge = 0; edge < edges_.size(); ++edge) {
        const std::vector<double> cuts = cuts_of(edge);
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            const double from = cuts[i], to = cuts[i + 1];
            std::vector<const edge_use*> here;
            std::vector<std::size_t> sides;
            for (const edge_use& use : uses_[edge])
                if (use.has((from + to) / 2)) {
                    here.push_back(&use);
                    if (std::ranges::find(sides, use.piece) == sides.end())
                        sides.push_back(use.piece);
                }
            if (here.size() == 2 && is_smooth(*here[0], *here[1], from, to))
                add_joint(edge, *here[0], *here[1], from, to, with_joints, result);
            else if (!here.empty())
                add(edge, from, to,
                    here.size() == 1 ? l3d_line_kind::border : l3d_line_kind::crease, sides,
                    result);
        }
    }
    return result;
}

} // namespace l3d_detail
