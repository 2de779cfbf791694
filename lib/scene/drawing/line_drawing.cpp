// SPDX-License-Identifier: MIT
// l3d_draw_lines: turns pieces into lines, and finds the visible parts of these.
#include "scene/line_drawing.h"

#include "base/error.h"
#include "base/formatted_p.h"
#include "geom/nurbs_surface.h"
#include "scene/drawing/borders_p.h"
#include "scene/drawing/contours_p.h"
#include "scene/drawing/edge_joints_p.h"
#include "scene/drawing/image_piece_p.h"
#include "scene/drawing/line_cuts_p.h"
#include "scene/drawing/line_joints_p.h"
#include "scene/drawing/sight_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

namespace {

using namespace l3d_detail;

/// The shares of the tolerance for errors of chords, for errors of polygons that stand for trims,
/// and for moving ends of contours onto an edge. Ends are moved by at most half of their share. The
/// rest is for the shear and for rounding.
constexpr double chord_share = 0.5, trim_share = 0.25, joint_share = 0.25;

/// A stretch that is shorter than this becomes seen or hidden as its neighbours are. Units: pixels.
constexpr double sliver = 0.75;

/// Distance of samples along a stretch. A line that passes through a surface is certainly found if
/// the surface hides a stretch as long as this. Units: pixels.
constexpr double sample_distance = 32;

/// The distance of the first and last sample of a long stretch from its ends. Units: pixels.
constexpr double from_ends = 3;

/// Error of the place where a line changes between seen and hidden, in pixels.
constexpr double break_error = 1.0 / 32;

drawing_view view_of(const l3d_patch_scene& scene, const l3d_camera& camera, l3d_size size) {
    const auto middle = (scene.least() + scene.most()) * 0.5;
    return {camera, size, camera.depth_of(middle), l3d_length(scene.most() - scene.least()) / 2};
}

std::vector<l3d_patch_points> pieces_of(const l3d_patch_model& model) {
    std::vector<l3d_patch_points> result;
    for (const l3d_nurbs_surface& surface : model.surfaces())
        std::ranges::move(surface.pieces(), std::back_inserter(result));
    return result;
}

class drawer {
public:
    drawer(const l3d_patch_scene& scene, const l3d_camera& camera, l3d_size size,
           const l3d_line_settings& settings)
        : settings_(settings), chord_(chord_share * settings.tolerance),
          view_(view_of(scene, camera, size)) {
        double trims = 0, edges_off = 0;
        for (std::size_t i = 0; i < scene.instances().size(); ++i) {
            const l3d_patch_instance& instance = scene.instances()[i];
            if (instance.opacity() == 0)
                continue;
            const std::vector<l3d_patch_points> pieces = pieces_of(instance.model());
            for (std::size_t p = 0; p < pieces.size(); ++p) {
                image_piece& piece = pieces_.emplace_back(pieces[p], instance.placement(), view_);
                piece.instance = i;
                piece.number = p;
                if (!pieces[p].trims.empty())
                    trims = std::max(
                        trims, piece.trim(pieces[p].trims, trim_share * settings.tolerance, view_));
                piece.first_edge = edges_.size();
            }
            for (const l3d_shared_edge& edge : instance.model().edges()) {
                edges_.emplace_back(edge, instance, view_);
                edges_off = std::max(edges_off, edges_.back().off);
            }
        }
        result_.size = size;
        // Two ends of contours that become one place each move by half of their distance.
        const double joints = edges_.empty() ? 0 : joint_share * settings.tolerance / 2;
        result_.bound = chord_ + trims + edges_off + joints + view_.error();
    }

    l3d_line_drawing draw() {
        find_chains();
        std::vector<std::vector<double>> cuts = cut_lines(chains_, view_, settings_.tolerance);
        line_of_sight sight(pieces_, view_);
        for (std::size_t i = 0; i < chains_.size(); ++i)
            add_stretches(chains_[i], cuts[i], sight);
        join();
        return std::move(result_);
    }

private:
    /// A part of a chain, from one length along the chain to another, which is seen or hidden as a
    /// whole.
    struct stretch {
        double from, to;
        bool is_seen;
    };
    /// A stretch of the drawing, before it is joined with others.
    struct drawn_stretch {
        surface_line points;
        l3d_line_kind kind;
        bool is_seen;
        std::vector<std::size_t> pieces; ///< indices in pieces_ of the pieces that it runs on
    };

    void find_chains();
    void join_contours(std::vector<drawn_chain> contours);
    void find_cusps(drawn_chain& chain) const;
    image_place on_curve(const drawn_chain& chain, const surface_vertex& a, const surface_vertex& b,
                         double share) const;
    double share_of_curve(const drawn_chain& chain, const surface_vertex& a,
                          const surface_vertex& b, double of_chord) const;
    void add_stretches(const drawn_chain& chain, std::vector<double>& cuts, line_of_sight& sight);
    bool is_seen(const drawn_chain& chain, const std::vector<double>& lengths, double at,
                 line_of_sight& sight) const;
    void sample(const drawn_chain& chain, const std::vector<double>& lengths, double from,
                double to, line_of_sight& sight, std::vector<stretch>& stretches) const;
    static void merge_slivers(std::vector<stretch>& stretches);
    static surface_line part_of(const drawn_chain& chain, const std::vector<double>& lengths,
                                double from, double to);
    bool is_in_picture(const image_place& p) const {
        return std::abs(p.x) <= view_.size().width / 2.0 &&
               std::abs(p.y) <= view_.size().height / 2.0;
    }
    void join();

    const l3d_line_settings settings_;
    double chord_;
    drawing_view view_;
    std::vector<image_piece> pieces_;
    std::vector<image_edge> edges_;
    std::vector<drawn_chain> chains_;
    std::vector<drawn_stretch> stretches_;
    l3d_line_drawing result_;
};

void drawer::find_chains() {
    std::vector<std::vector<surface_line>> contours(pieces_.size());
    for (std::size_t i = 0; i < pieces_.size(); ++i)
        for (const surface_line& line : contours_of(pieces_[i], i, view_, chord_))
            std::ranges::move(trimmed(pieces_[i], line), std::back_inserter(contours[i]));
    edge_joints joints(pieces_, edges_, view_, chord_);
    joints.end_on_edges(contours, joint_share * settings_.tolerance);
    std::vector<drawn_chain> parts;
    for (std::vector<drawn_chain>& chains :
         std::array{joints.chains(settings_.joints), borders_of(pieces_, contours, view_, chord_)})
        for (drawn_chain& chain : chains)
            (chain.kind == l3d_line_kind::contour ? parts : chains_).push_back(std::move(chain));
    for (std::vector<surface_line>& lines : contours)
        for (surface_line& line : lines)
            parts.push_back({l3d_line_kind::contour, std::move(line)});
    join_contours(std::move(parts));
    for (drawn_chain& chain : chains_)
        if (chain.kind == l3d_line_kind::contour && chain.sides.empty())
            find_cusps(chain);
}

std::array<line_end, 2> ends_of(const surface_line& line, std::size_t group) {
    const auto end = [&](const surface_vertex& last, const surface_vertex& before) -> line_end {
        return {last.at, last.at.x - before.at.x, last.at.y - before.at.y, group};
    };
    const std::size_t count = line.size();
    return {end(line[0], line[1]), end(line[count - 1], line[count - 2])};
}

/// Appends a line, or its reverse if `is_back`, to another line. The first vertex that is appended
/// may equal the last vertex of `to`.
void append(surface_line& to, const surface_line& line, bool is_back) {
    if (is_back)
        to.insert(to.end(), line.rbegin(), line.rend());
    else
        to.insert(to.end(), line.begin(), line.end());
}

/// Joins contours that continue each other. Contours that run inside pieces are joined across
/// pieces. They are never joined with contours along sides of pieces, whose visibility is tested
/// differently.
void drawer::join_contours(std::vector<drawn_chain> contours) {
    std::vector<std::array<line_end, 2>> ends;
    for (const drawn_chain& chain : contours)
        ends.push_back(ends_of(chain.points, chain.sides.empty() ? 0 : 1 + chain.sides[0]));
    for (const std::vector<joined_line>& row : join_lines(ends)) {
        drawn_chain& joined = chains_.emplace_back();
        joined.sides = contours[row.front().line].sides;
        for (const auto& [line, is_back] : row)
            append(joined.points, contours[line].points, is_back);
    }
}

void drawer::find_cusps(drawn_chain& chain) const {
    const surface_line old = std::exchange(chain.points, {});
    std::optional<double> last;
    for (std::size_t i = 0; i < old.size(); ++i) {
        const image_piece& piece = pieces_[old[i].piece];
        const double turn = shape_of_contour(piece, old[i]).turn;
        if (i > 0 && old[i - 1].piece == old[i].piece && last && (*last > 0) != (turn > 0)) {
            // The chord's two ends lie on both sides of the cusp.
            surface_vertex low = old[i - 1], high = old[i];
            constexpr int steps = 24; // to 2^-24 of the chord
            for (int k = 0; k < steps; ++k) {
                surface_vertex middle = low;
                middle.u = (low.u + high.u) / 2;
                middle.v = (low.v + high.v) / 2;
                const auto there = on_contour(piece, middle);
                if (!there)
                    break;
                ((shape_of_contour(piece, *there).turn > 0) == (*last > 0) ? low : high) = *there;
            }
            chain.cusps.push_back(chain.points.size());
            chain.points.push_back(low);
        }
        chain.points.push_back(old[i]);
        last = turn;
    }
}

image_place drawer::on_curve(const drawn_chain& chain, const surface_vertex& a,
                             const surface_vertex& b, double share) const {
    const double u = std::lerp(a.u, b.u, share), v = std::lerp(a.v, b.v, share);
    return chain.edge ? edges_[*chain.edge].at(u) : pieces_[a.piece].at(u, v);
}

/// Finds where the curve between vertices a and b is beside a place of its chord. The place is at
/// the share `of_chord` of the chord in the picture. The result is the share of the way from a to b
/// in parameters. Perspective and weights make these two shares differ.
double drawer::share_of_curve(const drawn_chain& chain, const surface_vertex& a,
                              const surface_vertex& b, double of_chord) const {
    const double dx = b.at.x - a.at.x, dy = b.at.y - a.at.y, square = dx * dx + dy * dy;
    if (a.piece != b.piece || !(square > 0))
        return of_chord;
    double low = 0, high = 1, at_low = -of_chord, at_high = 1 - of_chord, share = of_chord;
    constexpr double near = 1.0 / 256; // pixels
    constexpr int most_steps = 20;
    for (int i = 0; i < most_steps; ++i) {
        const image_place p = on_curve(chain, a, b, share);
        const double late = ((p.x - a.at.x) * dx + (p.y - a.at.y) * dy) / square - of_chord;
        if (late * late * square <= near * near)
            break;
        (late > 0 ? high : low) = share;
        (late > 0 ? at_high : at_low) = late;
        // Alternates between false position, which converges fast, and halving, which always ends.
        share = i % 2 == 0 ? low + (high - low) * at_low / (at_low - at_high) : (low + high) / 2;
    }
    return share;
}

bool drawer::is_seen(const drawn_chain& chain, const std::vector<double>& lengths, double at,
                     line_of_sight& sight) const {
    const auto above = std::ranges::upper_bound(lengths, at);
    const auto next = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
        above - lengths.begin(), 1, static_cast<std::ptrdiff_t>(lengths.size()) - 1));
    const surface_vertex &a = chain.points[next - 1], &b = chain.points[next];
    const double length = lengths[next] - lengths[next - 1];
    const double t = length > 0 ? (at - lengths[next - 1]) / length : 0;
    // A chord may be seen beside the surface that hides its curve, so the curve itself is tested.
    const double share = share_of_curve(chain, a, b, t);
    if (!chain.sides.empty())
        return !sight.is_hidden(on_curve(chain, a, b, share), chain.sides);
    // Tests a ray just outside the contour, where the surface's own fold does not hide it.
    surface_vertex here = a;
    here.u = std::lerp(a.u, b.u, share);
    here.v = std::lerp(a.v, b.v, share);
    const auto exact =
        a.piece == b.piece ? on_contour(pieces_[a.piece], here) : std::optional<surface_vertex>();
    const bool is_near = exact && distance_from(exact->at, a.at, b.at) <= settings_.tolerance;
    const surface_vertex& there = is_near ? *exact : t < 0.5 ? a : b;
    const contour_shape shape = shape_of_contour(pieces_[there.piece], there);
    const double beside = 2 * settings_.tolerance;
    return !sight.is_hidden(
        {there.at.x + beside * shape.out_x, there.at.y + beside * shape.out_y, there.at.z}, {});
}

/// Adds the stretches between two cuts of a chain. There is one stretch, unless samples tell that
/// the line passes through a surface.
void drawer::sample(const drawn_chain& chain, const std::vector<double>& lengths, double from,
                    double to, line_of_sight& sight, std::vector<stretch>& stretches) const {
    const bool is_long = to - from > 4 * from_ends;
    const double first = is_long ? from + from_ends : (from + to) / 2;
    const double between = is_long ? to - from - 2 * from_ends : 0;
    const int samples = is_long ? 2 + static_cast<int>(between / sample_distance) : 1;
    double begin = from, last = from;
    bool was_seen = false;
    for (int i = 0; i < samples; ++i) {
        const double at = first + between * i / std::max(samples - 1, 1);
        const bool seen = is_seen(chain, lengths, at, sight);
        if (i > 0 && seen != was_seen) {
            double low = last, high = at;
            while (high - low > break_error) {
                const double middle = (low + high) / 2;
                (is_seen(chain, lengths, middle, sight) == was_seen ? low : high) = middle;
            }
            stretches.push_back({begin, high, was_seen});
            begin = high;
        }
        was_seen = seen;
        last = at;
    }
    stretches.push_back({begin, to, was_seen});
}

/// Joins neighbouring stretches that are alike. A stretch shorter than `sliver` becomes like its
/// neighbours.
void drawer::merge_slivers(std::vector<stretch>& of) {
    const auto unite = [&] {
        std::size_t kept = 0;
        for (const stretch& one : of)
            if (kept > 0 && of[kept - 1].to == one.from && of[kept - 1].is_seen == one.is_seen)
                of[kept - 1].to = one.to;
            else
                of[kept++] = one;
        of.resize(kept);
    };
    unite();
    for (std::size_t i = 0; i < of.size(); ++i) {
        const bool follows = i > 0 && of[i - 1].to == of[i].from;
        const bool goes_on = i + 1 < of.size() && of[i + 1].from == of[i].to;
        if (of[i].to - of[i].from < sliver && (follows || goes_on))
            of[i].is_seen = follows ? of[i - 1].is_seen : of[i + 1].is_seen;
    }
    unite();
}

surface_line drawer::part_of(const drawn_chain& chain, const std::vector<double>& lengths,
                             double from, double to) {
    surface_line result;
    const auto at = [&](double length) {
        const auto next = static_cast<std::size_t>(
            std::clamp<std::ptrdiff_t>(std::ranges::lower_bound(lengths, length) - lengths.begin(),
                                       1, static_cast<std::ptrdiff_t>(lengths.size()) - 1));
        const surface_vertex &a = chain.points[next - 1], &b = chain.points[next];
        const double whole = lengths[next] - lengths[next - 1];
        const double t = whole > 0 ? (length - lengths[next - 1]) / whole : 0;
        surface_vertex v = t < 1 ? a : b;
        v.at = {a.at.x + t * (b.at.x - a.at.x), a.at.y + t * (b.at.y - a.at.y),
                a.at.z + t * (b.at.z - a.at.z)};
        return v;
    };
    result.push_back(at(from));
    for (std::size_t i = 0; i < lengths.size(); ++i)
        if (lengths[i] > from && lengths[i] < to)
            result.push_back(chain.points[i]);
    result.push_back(at(to));
    return result;
}

void drawer::add_stretches(const drawn_chain& chain, std::vector<double>& cuts,
                           line_of_sight& sight) {
    const std::vector<double> lengths = lengths_along(chain.points);
    constexpr double least = 1e-3; // files keep nothing shorter
    if (lengths.back() < least)
        return;
    for (const std::size_t cusp : chain.cusps)
        cuts.push_back(lengths[cusp]);
    std::ranges::sort(cuts);
    std::vector<stretch> stretches;
    double from = cuts.front();
    for (const double to : cuts) {
        if (to - from < least && to < cuts.back())
            continue;
        const surface_line middle = part_of(chain, lengths, (from + to) / 2, (from + to) / 2);
        if (to > from && is_in_picture(middle.front().at))
            sample(chain, lengths, from, to, sight, stretches);
        from = to;
    }
    merge_slivers(stretches);
    for (const stretch& one : stretches) {
        if (!one.is_seen && !settings_.hidden)
            continue;
        drawn_stretch& drawn = stretches_.emplace_back();
        drawn = {part_of(chain, lengths, one.from, one.to), chain.kind, one.is_seen, chain.sides};
        for (const surface_vertex& v : drawn.points)
            if (chain.sides.empty() &&
                std::ranges::find(drawn.pieces, v.piece) == drawn.pieces.end())
                drawn.pieces.push_back(v.piece);
    }
}

/// Joins stretches of one kind that continue each other, and turns them into lines of the drawing.
void drawer::join() {
    std::vector<std::array<line_end, 2>> ends;
    for (const drawn_stretch& one : stretches_)
        ends.push_back(
            ends_of(one.points, 2 * static_cast<std::size_t>(one.kind) + (one.is_seen ? 1 : 0)));
    const double left = view_.size().width / 2.0, top = view_.size().height / 2.0;
    for (const std::vector<joined_line>& row : join_lines(ends)) {
        const drawn_stretch& first = stretches_[row.front().line];
        l3d_drawn_line& line = result_.lines.emplace_back();
        line.kind = first.kind;
        line.is_seen = first.is_seen;
        line.instance = pieces_[first.pieces.front()].instance;
        surface_line points;
        for (const auto& [number, is_back] : row) {
            append(points, stretches_[number].points, is_back);
            for (const std::size_t piece : stretches_[number].pieces)
                if (std::ranges::find(line.pieces, pieces_[piece].number) == line.pieces.end())
                    line.pieces.push_back(pieces_[piece].number);
        }
        for (const surface_vertex& v : points) {
            constexpr double same = 1e-4; // joints and cuts repeat a vertex
            const l3d_drawn_place p{v.at.x + left, v.at.y + top, view_.depth_of(v.at.z)};
            if (line.points.empty() ||
                std::hypot(line.points.back().x - p.x, line.points.back().y - p.y) > same)
                line.points.push_back(p);
        }
        constexpr double closed = 1e-3;
        l3d_drawn_place &begin = line.points.front(), &end = line.points.back();
        if (line.points.size() > 2 && std::hypot(begin.x - end.x, begin.y - end.y) < closed)
            end = begin;
        if (lengths_along(points).back() < sliver) // a dot
            result_.lines.pop_back();
    }
    std::ranges::stable_sort(result_.lines, {}, [](const l3d_drawn_line& line) {
        return std::pair(line.instance, line.kind);
    });
}

} // namespace

l3d_line_drawing l3d_draw_lines(const l3d_patch_scene& scene, const l3d_camera& camera,
                                l3d_size size, const l3d_line_settings& settings) {
    constexpr double least = l3d_line_settings::least_tolerance;
    constexpr double most = l3d_line_settings::most_tolerance;
    if (!(settings.tolerance >= least && settings.tolerance <= most))
        throw l3d_error(l3d_exit::bad_input,
                        l3d_detail::formatted("line drawing: the tolerance %g is not from %g to %g "
                                              "pixels",
                                              settings.tolerance, least, most));
    if (const std::string why = camera.complaint(); !why.empty())
        throw l3d_error(l3d_exit::bad_input, why);
    return drawer(scene, camera, size, settings).draw();
}
