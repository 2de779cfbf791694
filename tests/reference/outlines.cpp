// SPDX-License-Identifier: MIT
// Borders cut into parts of a pixel, folds found where no chart exists.
#include "reference/outlines.h"
#include "reference/hits.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

namespace reference {
namespace {

constexpr int most_pieces = 20'000'000;
constexpr double border_px = 1, fold_px = 0.125;
/// What is seen edge on, as thin as this, changes no level: 1e-6 of white light are 0.003 levels. A
/// line of sight that grazes it meets too much.
constexpr double thinnest_px = 1e-6;
constexpr double margin_px = 1e-9; // as in hits.cpp
/// What changes by less within a part is flat: far above rounding, 1e-13 px, below all that is
/// seen.
constexpr double flat_px = 1e-10;
/// Halvings of a border, which end at its corners at the latest: 2^-40 of 1e6 px is 1e-6 px.
constexpr int deepest = 40;

hpoint middle(const hpoint& p, const hpoint& q) {
    return {(p.x + q.x) / 2, (p.y + q.y) / 2, (p.w + q.w) / 2};
}

std::pair<border_part, border_part> halved(const border_part& part) {
    const auto& p = part.points;
    const hpoint ab = middle(p[0], p[1]), bc = middle(p[1], p[2]), cd = middle(p[2], p[3]);
    const hpoint abc = middle(ab, bc), bcd = middle(bc, cd), all = middle(abc, bcd);
    return {{{p[0], ab, abc, all}, part.first, false}, {{all, bcd, cd, p[3]}, false, part.last}};
}

rect box_of(const border_part& part) {
    constexpr double far = std::numeric_limits<double>::infinity();
    rect box{far, far, -far, -far};
    for (const hpoint& p : part.points)
        box = {std::min(box.x0, p.x / p.w), std::min(box.y0, p.y / p.w),
               std::max(box.x1, p.x / p.w), std::max(box.y1, p.y / p.w)};
    return box;
}

range depths_of(const border_part& part) {
    const auto [low, high] =
        std::minmax_element(part.points.begin(), part.points.end(),
                            [](const hpoint& p, const hpoint& q) { return p.w < q.w; });
    return {low->w, high->w};
}

bool smaller(const rect& box, double px) {
    return box.x1 - box.x0 <= px && box.y1 - box.y0 <= px;
}

rect grown(const rect& box) {
    return {box.x0 - margin_px, box.y0 - margin_px, box.x1 + margin_px, box.y1 + margin_px};
}

bool same(const border_part& p, const border_part& q) {
    return std::equal(
        p.points.begin(), p.points.end(), q.points.begin(),
        [](const hpoint& a, const hpoint& b) { return a.x == b.x && a.y == b.y && a.w == b.w; });
}

std::array<border_part, 4> sides_of(const net& piece) {
    constexpr std::array<std::pair<std::size_t, std::size_t>, 4> first_and_step{
        {{0, 1}, {12, 1}, {0, 4}, {3, 4}}};
    std::array<border_part, 4> result;
    for (std::size_t side = 0; side < 4; ++side)
        for (std::size_t k = 0; k < 4; ++k)
            result[side].points[k] =
                piece.points[first_and_step[side].first + k * first_and_step[side].second];
    return result;
}

double nearest_of(const fold_piece& piece) {
    double result = depths_of(piece.sides[0]).low;
    for (const border_part& side : piece.sides)
        result = std::min(result, depths_of(side).low);
    return result;
}

/// Of a polynomial in Bernstein's form.
template <std::size_t N> double value_at(const std::array<double, N>& p, double t) {
    const double s = 1 - t;
    double result = p[0], power = 1, binomial = 1;
    for (std::size_t k = 1; k < N; ++k) {
        power *= t;
        binomial *= static_cast<double>(N - k) / static_cast<double>(k);
        result = result * s + binomial * power * p[k];
    }
    return result;
}

/// The parameters of a piece of a polynomial, in Bernstein's form, where it is `nothing` or changes
/// its sign. Good to 2^-30, a nanopixel of a border's part.
template <std::size_t N>
void find_roots(const std::array<double, N>& p, double nothing, double low, double high,
                std::vector<double>& roots) {
    const auto [least, most] = std::minmax_element(p.begin(), p.end());
    if (*least > 0 || *most < 0)
        return;
    if (high - low < 0x1p-30 || (*least > -nothing && *most < nothing)) {
        roots.push_back((low + high) / 2);
        return;
    }
    int changes = 0;
    for (std::size_t k = 0; k + 1 < N; ++k)
        changes += (p[k] > 0) != (p[k + 1] > 0);
    if (changes == 1 && p.front() != 0 && p.back() != 0) { // then there is one root, no more
        double from = 0, to = 1;
        while (to - from > 0x1p-30) {
            const double at = (from + to) / 2;
            ((value_at(p, at) > 0) == (p.front() > 0) ? from : to) = at;
        }
        roots.push_back(low + (high - low) * (from + to) / 2);
        return;
    }
    std::array<double, N> left = p, right = p;
    for (std::size_t round = 1; round < N; ++round)
        for (std::size_t i = 0; i + round < N; ++i)
            right[i] = (right[i] + right[i + 1]) / 2;
    for (std::size_t round = 1; round < N; ++round)
        for (std::size_t i = N - 1; i >= round; --i)
            left[i] = (left[i - 1] + left[i]) / 2;
    const double half = (low + high) / 2;
    find_roots(left, nothing, low, half, roots);
    find_roots(right, nothing, half, high, roots);
}

hpoint point_of(const border_part& p, double t) {
    const double s = 1 - t;
    const std::array<double, 4> weights{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
    hpoint result;
    for (std::size_t k = 0; k < 4; ++k) {
        result.x += weights[k] * p.points[k].x;
        result.y += weights[k] * p.points[k].y;
        result.w += weights[k] * p.points[k].w;
    }
    return result;
}

} // namespace

outline_map::outline_map(std::span<const patch> patches, const camera& view, picture_size size)
    : near_(view.near),
      size_(size), window_{0, 0, static_cast<double>(size.width), static_cast<double>(size.height)},
      borders_at_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)),
      folds_at_(borders_at_.size()) {
    const camera_frame frame(view, size);
    std::vector<border_part> whole;
    for (const patch& each : patches) {
        const net of = make_net(each, frame);
        pieces_ = 0;
        add_folds(of);
        for (const border_part& side : sides_of(of)) {
            border_part turned = side;
            std::reverse(turned.points.begin(), turned.points.end());
            // Neighbours share their borders.
            if (std::none_of(whole.begin(), whole.end(), [&](const border_part& known) {
                    return same(known, side) || same(known, turned);
                }))
                whole.push_back(side);
        }
    }
    for (const border_part& each : whole)
        add_border(each, 0);
}

template <class Visit> void outline_map::for_pixels(const rect& box, Visit visit) const {
    const auto place = [](double at, int count) {
        return static_cast<int>(std::clamp(std::floor(at), 0.0, static_cast<double>(count - 1)));
    };
    const rect around = grown(box);
    for (int y = place(around.y0, size_.height); y <= place(around.y1, size_.height); ++y)
        for (int x = place(around.x0, size_.width); x <= place(around.x1, size_.width); ++x)
            visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
                  static_cast<std::size_t>(x));
}

void outline_map::add_border(const border_part& part, int depth) {
    const range depths = depths_of(part);
    if (depths.high < near_)
        return;
    if (depths.low > 0) {
        const rect box = box_of(part);
        if (!grown(box).touches(window_))
            return;
        if (smaller(box, border_px)) {
            for_pixels(box, [&](std::size_t pixel) {
                borders_at_[pixel].push_back(static_cast<std::uint32_t>(borders_.size()));
            });
            borders_.push_back(part);
            return;
        }
    }
    if (depth == deepest)
        return;
    const auto [low, high] = halved(part);
    add_border(low, depth + 1);
    add_border(high, depth + 1);
}

void outline_map::add_folds(const net& piece) {
    if (++pieces_ > most_pieces)
        throw std::runtime_error("outlines: a patch needs too many pieces");
    const range depth = depth_range(piece);
    if (!(depth.high >= near_) || is_outside(piece, grown(window_)))
        return;
    if (depth.low > 0) {
        const rect box = bounding_box(piece);
        if (depth.low >= near_ && make_chart(piece, grown(window_)))
            return;
        if (is_line(piece, thinnest_px))
            return;
        if (smaller(box, fold_px)) {
            for_pixels(box, [&](std::size_t pixel) {
                folds_at_[pixel].push_back(static_cast<std::uint32_t>(folds_.size()));
            });
            folds_.push_back({box, sides_of(piece)});
            return;
        }
    }
    const auto [low, high] = halves(piece);
    add_folds(low);
    add_folds(high);
}

std::vector<border_part> outline_map::borders(int x, int y, double w) const {
    std::vector<border_part> result;
    for (const std::uint32_t k :
         borders_at_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
                     static_cast<std::size_t>(x)])
        if (depths_of(borders_[k]).low < w)
            result.push_back(borders_[k]);
    return result;
}

std::vector<fold_piece> outline_map::folds(int x, int y, double w) const {
    std::vector<fold_piece> result;
    for (const std::uint32_t k :
         folds_at_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
                   static_cast<std::size_t>(x)])
        if (nearest_of(folds_[k]) < w)
            result.push_back(folds_[k]);
    return result;
}

bool outline_map::any(int x, int y, double w) const {
    return !borders(x, y, w).empty() || !folds(x, y, w).empty();
}

std::vector<double> crossings(const border_part& of, bool along_x, double c) {
    std::array<double, 4> off{};
    for (std::size_t k = 0; k < 4; ++k)
        off[k] = (along_x ? of.points[k].y : of.points[k].x) - c * of.points[k].w;
    std::vector<double> result;
    find_roots(off, flat_px * depths_of(of).low, 0, 1, result);
    for (double& at : result) {
        const hpoint p = point_of(of, at);
        at = (along_x ? p.x : p.y) / p.w;
    }
    return result;
}

/// The slope of f / w vanishes where f' w - f w' does. Products of Bernstein's polynomials are such
/// polynomials: their factors are the binomials.
std::vector<double> turns(const border_part& of, bool along_x) {
    const auto value = [along_x](const hpoint& p) { return along_x ? p.y : p.x; };
    const auto& p = of.points;
    constexpr std::array<double, 4> cubic{1, 3, 3, 1};
    constexpr std::array<double, 3> square{1, 2, 1};
    constexpr std::array<double, 6> quintic{1, 5, 10, 10, 5, 1};
    std::array<double, 6> slope{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 4; ++k)
            slope[i + k] +=
                square[i] * cubic[k] / quintic[i + k] *
                ((value(p[i + 1]) - value(p[i])) * p[k].w - (p[i + 1].w - p[i].w) * value(p[k]));
    std::vector<double> result;
    const double least = depths_of(of).low;
    find_roots(slope, flat_px * least * least, 0, 1, result);
    if (of.first)
        result.push_back(0);
    if (of.last)
        result.push_back(1);
    for (double& at : result) {
        const hpoint there = point_of(of, at);
        at = value(there) / there.w;
    }
    return result;
}

} // namespace reference
