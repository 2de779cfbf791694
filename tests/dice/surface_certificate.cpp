// SPDX-License-Identifier: MIT
// Planes and parabolas against exact points and normals.
#include "surface_certificate.h"

#include "scene/exact_bends.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dice_tests {
namespace {

using real = long double;

long_vec operator+(const long_vec& a, const long_vec& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
long_vec operator-(const long_vec& a, const long_vec& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
long_vec operator*(real s, const long_vec& a) {
    return {s * a.x, s * a.y, s * a.z};
}
real dot(const long_vec& a, const long_vec& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
long_vec cross(const long_vec& a, const long_vec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
real length(const long_vec& a) {
    return std::sqrt(dot(a, a));
}

/// Bernstein polynomials of degree 3 and their derivatives.
struct weights {
    std::array<real, 4> of, by;

    explicit weights(real t) {
        const real s = 1 - t;
        of = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
        by = {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t};
    }
};

/// Where the normal has less than this of what it is the product of, rounding decides about it.
constexpr real no_normal = 1e-9L;

/// A derivative of less than this part of the net's coordinates is nothing but rounding: four times
/// three products and sums in long double err by 12 * 2^-64 of them. So it is where a side of the
/// patch is a point.
constexpr real no_derivative = 1e-17L;

/// Room for what a level of a corner may be off by: normals in floats.
constexpr double of_corner = 0.05;

constexpr std::array<double, 5> lattice{0, 0.21, 0.5, 0.79, 1};

/// Between which parameters of a grid one lies.
int cell_of(const std::vector<double>& at, double parameter) {
    const auto next = std::upper_bound(at.begin() + 1, at.end() - 1, parameter);
    return static_cast<int>(next - at.begin()) - 1;
}

/// A block of a grid, its range of parameters and its step as a part of that.
struct block_range {
    std::size_t block;
    double low, high, step;
};

double turn(const auto& a, const auto& b, const auto& c) {
    return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
}

} // namespace

surface_certificate::surface_certificate(const scene& s) : scene_(s), frame_(s.eye, s.picture()) {
    const auto& l = reference::project_light;
    const auto along = [&](const real(&axis)[3]) {
        return axis[0] * real{l.x} + axis[1] * real{l.y} + axis[2] * real{l.z};
    };
    light_ = {along(frame_.right), -along(frame_.up), along(frame_.forward)};
    light_ = (1 / length(light_)) * light_;
    l3d_patch_scene world;
    world.add(s.model, s.placement);
    l3d_image_transform(s.camera, s.size, world).set_depths(depths_);
}

/// The line of sight, of any length.
long_vec surface_certificate::ray_to(const long_vec& place) const {
    return frame_.parallel ? long_vec{0, 0, 1} : place;
}

void surface_certificate::next(std::size_t patch) {
    patch_ = patch;
    bends_.emplace(scene_.model.bends(patch).under(scene_.placement));
    for (std::size_t i = 0; i < 16; ++i) {
        const reference::vec3& p = scene_.patches[patch].points[i];
        const real d[3] = {real{p.x} - frame_.eye[0], real{p.y} - frame_.eye[1],
                           real{p.z} - frame_.eye[2]};
        const auto along = [&](const real(&axis)[3]) {
            return axis[0] * d[0] + axis[1] * d[1] + axis[2] * d[2];
        };
        net_[i] = {along(frame_.right), -along(frame_.up), along(frame_.forward)};
        reach_ = i == 0 ? length(net_[i]) : std::max(reach_, length(net_[i]));
    }
}

auto surface_certificate::corner_of(const l3d_micro_vertex& vertex, double u, double v) const
    -> corner {
    const double x = vertex.x / double{l3d_subpixel_one}, y = vertex.y / double{l3d_subpixel_one};
    const real w = frame_.parallel
                       ? (real{vertex.inv_w} - real{depths_.depth_base}) / real{depths_.depth_step}
                       : 1 / real{vertex.inv_w};
    const real pixel = (frame_.parallel ? 1 : w) / frame_.focal;
    return {{(x - frame_.center_x) * pixel, (y - frame_.center_y) * pixel, w}, u, v, x, y, vertex};
}

auto surface_certificate::exact_at(double u, double v) const -> exact {
    const weights in_u(u), in_v(v);
    long_vec place, by_u, by_v;
    for (std::size_t r = 0; r < 4; ++r) {
        long_vec row, row_by_u;
        for (std::size_t c = 0; c < 4; ++c) {
            row = row + in_u.of[c] * net_[4 * r + c];
            row_by_u = row_by_u + in_u.by[c] * net_[4 * r + c];
        }
        place = place + in_v.of[r] * row;
        by_u = by_u + in_v.of[r] * row_by_u;
        by_v = by_v + in_v.by[r] * row;
    }
    const long_vec normal = cross(by_u, by_v);
    const real size = length(normal);
    const real of_u = length(by_u), of_v = length(by_v);
    const bool has_normal =
        std::min(of_u, of_v) > no_derivative * reach_ && size > no_normal * of_u * of_v;
    exact result{place, {}, 0, has_normal};
    if (has_normal) {
        result.normal = (1 / size) * normal;
        result.level = 229.5 * static_cast<double>(dot(result.normal, light_));
    }
    return result;
}

/// Which side all corners show, 1 or -1; false if they show both.
template <std::size_t N>
bool surface_certificate::side_of(const std::array<corner, N>& corners, double& side) const {
    bool front = true, back = true;
    double off_front = 0, off_back = 0;
    for (const corner& c : corners) {
        const exact at = exact_at(c.u, c.v);
        if (!at.has_normal)
            continue;
        const double of_front = std::abs(double{c.vertex.normal[0]} - at.level);
        const double of_back = std::abs(double{c.vertex.normal[0]} + at.level);
        off_front = std::max(off_front, of_front);
        off_back = std::max(off_back, of_back);
        front = front && of_front <= of_back + of_corner;
        back = back && of_back <= of_front + of_corner;
    }
    side = front && (!back || off_front <= off_back) ? 1 : -1;
    return front || back;
}

bool surface_certificate::is_seen(const long_vec& at) const {
    const real w = frame_.parallel ? 1 : at.z;
    if (!(w >= scene_.eye.least_w()))
        return false;
    const real x = frame_.center_x + frame_.focal * at.x / w;
    const real y = frame_.center_y + frame_.focal * at.y / w;
    return x >= 0 && y >= 0 && x <= scene_.size.width && y <= scene_.size.height;
}

/// One point that is drawn, and its levels as the fast and the slow rasterizer make them.
void surface_certificate::compare(const long_vec& at, double u, double v,
                                  std::span<const double> drawn, double side, bool in_slit) {
    if (!is_seen(at))
        return;
    const exact here = exact_at(u, v);
    const real w = frame_.parallel ? 1 : here.place.z;
    if (!here.has_normal || !(w > 0))
        return;
    ++samples;
    const real off = std::abs(dot(here.normal, at - here.place));
    depth.take({static_cast<double>(off * frame_.focal / w), patch_, u, v, in_slit});
    for (const double level : drawn) {
        ++levels;
        const double error = std::max(0.0, level) - std::max(0.0, side * here.level);
        shade.take({std::abs(error), patch_, u, v, in_slit});
    }
}

/// Corners a, b, c, d; bends of the sides ab, bc, dc, ad.
void surface_certificate::quad(const std::array<corner, 4>& c, const std::array<double, 4>& bends,
                               bool with_levels) {
    const long_vec mean = 0.25L * (c[0].place + c[1].place + c[2].place + c[3].place);
    const long_vec along1 = 0.5L * (c[2].place - c[0].place);
    const long_vec along2 = 0.5L * (c[3].place - c[1].place);
    double side = 1;
    if (with_levels && !side_of(c, side)) {
        ++mixed;
        with_levels = false;
    }
    const auto level = [&](std::size_t i) { return double{c[i].vertex.normal[0]}; };
    for (const double s : lattice)
        for (const double t : lattice) {
            const long_vec at = mean + (s + t - 1) * along1 + (t - s) * along2;
            const double corners = (1 - t) * ((1 - s) * level(0) + s * level(1)) +
                                   t * ((1 - s) * level(3) + s * level(2));
            const double of_u = 4 * s * (1 - s), of_v = 4 * t * (1 - t);
            const std::array<double, 2> both{corners + of_u * (bends[0] + bends[2]) / 2 +
                                                 of_v * (bends[1] + bends[3]) / 2,
                                             corners + of_u * ((1 - t) * bends[0] + t * bends[2]) +
                                                 of_v * ((1 - s) * bends[3] + s * bends[1])};
            compare(at, (1 - s) * c[0].u + s * c[1].u, (1 - t) * c[0].v + t * c[3].v,
                    std::span(both).first(with_levels ? 2 : 0), side, false);
        }
}

void surface_certificate::triangle(const std::array<corner, 3>& c, bool with_levels) {
    double side = 1;
    if (with_levels && !side_of(c, side)) {
        ++mixed;
        with_levels = false;
    }
    for (const double s : lattice)
        for (const double t : lattice) {
            if (s + t > 1)
                continue;
            const double r = 1 - s - t;
            const auto &a = c[0].vertex.normal, &b = c[1].vertex.normal;
            const double level =
                r * double{a[0]} + s * double{b[0]} + t * double{c[2].vertex.normal[0]} +
                4 * (r * s * double{a[1]} + r * t * double{a[2]} + s * t * double{b[2]});
            compare(r * c[0].place + s * c[1].place + t * c[2].place,
                    r * c[0].u + s * c[1].u + t * c[2].u, r * c[0].v + s * c[1].v + t * c[2].v,
                    std::span(&level, with_levels ? 1 : 0), side, true);
        }
}

/// Whether levels of a quad's block are within the tolerance, as the certificate decides it.
bool surface_certificate::keeps_levels(const l3d_diced_piece& piece, int row, int column,
                                       bool in_slit) const {
    const auto range_of = [](const std::vector<double>& at, const l3d_block_starts& starts, int i) {
        std::size_t block = 0;
        while (starts.first[block + 1] <= i)
            ++block;
        const auto first = static_cast<std::size_t>(starts.first[block]);
        const auto end = static_cast<std::size_t>(starts.first[block + 1]);
        return block_range{block, at[first], at[end], 1.0 / static_cast<double>(end - first)};
    };
    const auto [column_block, u0, u1, h_u] = range_of(piece.u, piece.part.block_columns, column);
    const auto [row_block, v0, v1, h_v] = range_of(piece.v, piece.part.block_rows, row);
    bend_numbers most{};
    for (std::size_t block = 0; block < l3d_surface_bends::blocks; ++block) {
        const double low_u = static_cast<double>(block % 4) / 4;
        const double low_v = static_cast<double>(block / 4) / 4;
        constexpr double inside = 1e-9;
        if (low_u > u1 - inside || low_u + 0.25 < u0 + inside || low_v > v1 - inside ||
            low_v + 0.25 < v0 + inside)
            continue;
        const bend_numbers of = bends_of_block(*bends_, block);
        const double a = 4 * (u1 - u0), b = 4 * (v1 - v0);
        most.n_uu = std::max(most.n_uu, a * a * of.n_uu);
        most.n_uv = std::max(most.n_uv, a * b * of.n_uv);
        most.n_vv = std::max(most.n_vv, b * b * of.n_vv);
        most.n_uuu = std::max(most.n_uuu, a * a * a * of.n_uuu);
        most.n_uuv = std::max(most.n_uuv, a * a * b * of.n_uuv);
        most.n_uvv = std::max(most.n_uvv, a * b * b * of.n_uvv);
        most.n_vvv = std::max(most.n_vvv, b * b * b * of.n_vvv);
    }
    const bool clipped = piece.part.grid.rows < 2;
    double off = clipped ? 229.5 * ((h_u * h_u * most.n_uu + h_v * h_v * most.n_vv) / 8 +
                                    h_u * h_v * most.n_uv / 4)
                         : l3d_levels_off(most, h_u, h_v);
    const auto take_slit = [&](std::size_t direction, std::size_t block, double size, double h,
                               double n_2, double n_3) {
        const double bent = piece.slits.bent[direction][block] / size;
        const double straight = piece.slits.straight[direction][block] / size;
        if (std::isinf(bent + straight))
            off = bent + straight;
        else if (bent > 0)
            off = std::max(off, 229.5 * 0.00802 * (bent * bent * bent + 5 * h * h * h / 3) * n_3);
        if (straight > 0)
            off = std::max(off, 229.5 * (straight * straight + h * h) / 8 * n_2);
    };
    if (in_slit) {
        take_slit(0, column_block, u1 - u0, h_u, most.n_uu, most.n_uuu);
        take_slit(1, row_block, v1 - v0, h_v, most.n_vv, most.n_vvv);
    }
    constexpr double rounding_and_shapes = 0.76;
    return off <= scene_.shade_tolerance - rounding_and_shapes;
}

/// Whether the grid beside a triangle does: where a row of it crosses an outline, levels go from
/// those of one side to those of the other.
bool surface_certificate::row_shows_both(const l3d_diced_piece& piece,
                                         const std::array<corner, 3>& c) const {
    const l3d_micro_grid& g = piece.part.grid;
    const auto [low_u, high_u] = std::minmax({c[0].u, c[1].u, c[2].u});
    const auto [low_v, high_v] = std::minmax({c[0].v, c[1].v, c[2].v});
    bool front = false, back = false;
    for (int row = cell_of(piece.v, low_v); row <= cell_of(piece.v, high_v) + 1; ++row)
        for (int column = cell_of(piece.u, low_u); column <= cell_of(piece.u, high_u) + 1;
             ++column) {
            const auto r = static_cast<std::size_t>(row), at = static_cast<std::size_t>(column);
            const double u = piece.u[at], v = piece.v[r];
            // Only the side itself, without the rows beside it.
            if ((low_u == high_u && u != low_u) || (low_v == high_v && v != low_v))
                continue;
            double side = 1;
            if (g.rows < 2) { // clipped: each vertex shows the side that is turned to the eye
                const exact here = exact_at(u, v);
                side = dot(here.normal, ray_to(here.place)) > 0 ? -1 : 1;
            } else {
                const l3d_micro_vertex vertex = g.vertex(row, column);
                if (std::abs(double{vertex.normal[0]}) < of_corner)
                    continue;
                side_of(std::array{corner_of(vertex, u, v)}, side);
            }
            (side > 0 ? front : back) = true;
        }
    return front && back;
}

/// Whether those of the cell are that a triangle lies in, or beside.
bool surface_certificate::keeps_levels(const l3d_diced_piece& piece,
                                       const std::array<corner, 3>& c) const {
    if (!piece.has_levels || piece.u.size() < 2 || piece.v.size() < 2 || row_shows_both(piece, c))
        return false;
    for (const corner& at : c)
        if (!keeps_levels(piece, cell_of(piece.v, at.v), cell_of(piece.u, at.u), true))
            return false;
    return keeps_levels(piece, cell_of(piece.v, (c[0].v + c[1].v + c[2].v) / 3),
                        cell_of(piece.u, (c[0].u + c[1].u + c[2].u) / 3), true);
}

void surface_certificate::grid(const l3d_diced_piece& piece) {
    const l3d_micro_grid& g = piece.part.grid;
    std::size_t count = 0;
    for (int r = 0; r + 1 < g.rows; ++r)
        for (int c = 0; c + 1 < g.columns; ++c) {
            if (count++ % every_ != 0)
                continue;
            const auto at = [&](int row, int column) {
                return corner_of(g.vertex(row, column), piece.u[static_cast<std::size_t>(column)],
                                 piece.v[static_cast<std::size_t>(row)]);
            };
            const std::array corners{at(r, c), at(r, c + 1), at(r + 1, c + 1), at(r + 1, c)};
            bool right = true, left = true;
            for (std::size_t i = 0; i < 4; ++i) {
                const double turned = turn(corners[i], corners[(i + 1) % 4], corners[(i + 2) % 4]);
                right = right && turned > 0;
                left = left && turned < 0;
            }
            if (!right && !left)
                continue;
            const bool promised = piece.has_levels && keeps_levels(piece, r, c, false);
            unshaded += piece.has_levels && !promised;
            const auto bend = [&](std::size_t i, std::size_t k) {
                return double{corners[i].vertex.normal[k]};
            };
            quad(corners, {bend(0, 1), bend(1, 2), bend(3, 1), bend(0, 2)}, promised);
        }
}

void surface_certificate::draw(std::span<const l3d_diced_piece> pieces) {
    for (const l3d_diced_piece& piece : pieces) {
        if (piece.part.grid.rows > 1)
            grid(piece);
        const l3d_micro_triangles& triangles = piece.part.triangles;
        for (std::size_t i = 0; i < triangles.count; i += every_) {
            const auto at = [&](std::size_t k) {
                const auto& [u, v] = piece.triangle_uv[k].at(i);
                return corner_of(triangles.vertex(i, k), u, v);
            };
            const std::array corners{at(0), at(1), at(2)};
            triangle(corners, keeps_levels(piece, corners));
        }
    }
}

} // namespace dice_tests
