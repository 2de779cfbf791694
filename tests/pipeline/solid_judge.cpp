// SPDX-License-Identifier: MIT
// Exact distances come from a search that goes on by what is free.
#include "solid_judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace {

using vector = solid::vector;

/// A thousandth of a pixel: the judge's own rounding, and where its searches end.
constexpr double own_px = 1e-3;

/// The exact body as a camera sees it.
class exact_view {
public:
    exact_view(const solid& of, const camera_rays& rays) : of_(of), rays_(rays) {}

    /// The length of a pixel at this distance along the view axis.
    double pixel_at(double w) const { return w / rays_.focal; }

    /// The distance along the view axis at which a ray meets the body, infinite if it does not.
    double distance(double x, double y) const {
        const vector ray = rays_.at(x, y);
        const double length = l3d_length(ray);
        const vector along = ray / length;
        const double from_middle = l3d_length(rays_.camera.eye - of_.middle);
        double t = std::max(0.0, from_middle - of_.radius);
        for (int i = 0; i < 4000 && t < from_middle + of_.radius; ++i) {
            const double free = of_.outside(rays_.camera.eye + along * t);
            if (free < own_px / 2 * pixel_at(t / length))
                return t / length;
            t += free;
        }
        return HUGE_VAL;
    }

    /// Where a way from a pixel's place that meets the body to one that does not leaves it: the
    /// part of the way, and the distance there.
    std::array<double, 2> outline(const vector& inside, const vector& outside) const {
        double low = 0, high = 1, depth = distance(inside[0], inside[1]);
        for (int i = 0; i < 12; ++i) {
            const double part = (low + high) / 2;
            const vector at = inside + (outside - inside) * part;
            const double there = distance(at[0], at[1]);
            (std::isfinite(there) ? low : high) = part;
            if (std::isfinite(there))
                depth = there;
        }
        return {low, depth};
    }

private:
    const solid& of_;
    const camera_rays& rays_;
};

/// Notes the pixels that edges go through.
class edge_pixels {
public:
    edge_pixels(const solid& of, const camera_rays& rays, const exact_view& exact, double slack_px)
        : rays_(rays), exact_(exact), slack_px_(slack_px),
          is_on_(static_cast<std::size_t>(rays.size.width * rays.size.height)) {
        for (const l3d_model_edge& edge : of.edges) {
            const l3d_bspline_direction& along = edge.curve.along();
            constexpr int parts = 16;
            for (int i = 0; i < parts; ++i) {
                const double step = (along.to - along.from) / parts;
                add(edge.curve, along.from + i * step, along.from + (i + 1) * step, 0);
            }
        }
    }

    long count() const { return std::ranges::count(is_on_, true); }

private:
    /// Halves a part of an edge until it is shorter than a pixel, or out of the picture.
    void add(const l3d_nurbs_curve& curve, double from, double to, int halvings) {
        const double middle = (from + to) / 2;
        const vector a = curve.evaluate(from), b = curve.evaluate(to), m = curve.evaluate(middle);
        const double reach = l3d_length(a - m) + l3d_length(b - m);
        const vector way = m - rays_.camera.eye;
        const double w = l3d_dot(way, rays_.axes.forward);
        if (w < -reach || halvings > 24)
            return;
        const double x = rays_.size.width / 2.0 + l3d_dot(way, rays_.axes.right) / w * rays_.focal;
        const double y = rays_.size.height / 2.0 - l3d_dot(way, rays_.axes.up) / w * rays_.focal;
        const bool is_before = w > 2 * reach;
        if (is_before) {
            const double grown = 4 * reach / exact_.pixel_at(w);
            if (x < -grown || y < -grown || x > rays_.size.width + grown ||
                y > rays_.size.height + grown)
                return;
        }
        if (!is_before || reach > exact_.pixel_at(w)) {
            add(curve, from, middle, halvings + 1);
            add(curve, middle, to, halvings + 1);
            return;
        }
        if (x < 0 || y < 0 || x >= rays_.size.width || y >= rays_.size.height)
            return;
        const std::size_t at =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(rays_.size.width) +
            static_cast<std::size_t>(x);
        if (!is_on_[at] && exact_.distance(x, y) >= w - slack_px_ * exact_.pixel_at(w))
            is_on_[at] = true;
    }

    const camera_rays& rays_;
    const exact_view& exact_;
    double slack_px_;
    std::vector<bool> is_on_;
};

} // namespace

l3d_camera view_of(const solid& of, double zoom, bool is_near_edge, std::mt19937& random) {
    std::uniform_real_distribution<double> any(0, 1);
    for (;;) {
        l3d_camera camera = random_view(of.middle, of.radius, zoom, random);
        l3d_camera far = random_view(of.middle, of.radius, 1, random);
        vector place = far.target;
        if (is_near_edge) {
            const auto edge =
                static_cast<std::size_t>(any(random) * static_cast<double>(of.edges.size()));
            const l3d_nurbs_curve& curve = of.edges[edge].curve;
            const auto& along = curve.along();
            place = curve.evaluate(along.from + (along.to - along.from) * any(random));
        } else {
            const double w = exact_view(of, camera_rays(far, {2, 2})).distance(1, 1);
            if (!std::isfinite(w))
                continue;
            place = far.eye + l3d_normalized(far.target - far.eye) * w;
        }
        camera.eye += place - camera.target;
        camera.target = place;
        const double w = exact_view(of, camera_rays(camera, {2, 2})).distance(1, 1);
        // The near plane opens no body.
        if (w > 0.99 * l3d_length(camera.eye - place) && of.outside(camera.eye) > 2 * camera.near_z)
            return camera;
    }
}

void judge_solid(const solid& of, const camera_rays& rays, const l3d_pipeline_afd& pipeline,
                 solid_verdict& sum) {
    const l3d_frame_report report = pipeline.report();
    const double tolerance = report.tolerance_px;
    ASSERT_TRUE(std::isfinite(report.dice.bound_px) && std::isfinite(report.dice.depth_bound_px));
    sum.most_bound =
        std::max(sum.most_bound, (report.dice.bound_px - report.dice.edges_px) / tolerance);
    sum.most_depth_bound = std::max(
        sum.most_depth_bound, (report.dice.depth_bound_px - report.dice.edges_px) / tolerance);
    sum.most_edges = std::max(sum.most_edges, report.dice.edges_px / tolerance);
    const exact_view exact(of, rays);
    const std::vector<float> distances = pipeline.distances();
    constexpr std::size_t directions = 32;
    for (int y = 0; y < rays.size.height; ++y)
        for (int x = 0; x < rays.size.width; ++x) {
            const vector centre{x + 0.5, y + 0.5, 0.0};
            const double drawn =
                static_cast<double>(distances[static_cast<std::size_t>(y * rays.size.width + x)]);
            const bool is_drawn = std::isfinite(drawn);
            const double here = exact.distance(centre[0], centre[1]);
            const double model_px = std::isfinite(is_drawn ? drawn : here)
                                        ? of.model_error / exact.pixel_at(is_drawn ? drawn : here)
                                        : 0;
            const double place_px = report.dice.bound_px + model_px + own_px;
            const double depth_px = report.dice.depth_bound_px + model_px + own_px;
            ++sum.pixels;
            sum.drawn += is_drawn;
            if (!is_drawn && here == HUGE_VAL)
                continue; // nothing is there, and nothing is drawn
            const vector at = rays.camera.eye + rays.at(centre[0], centre[1]) * drawn;
            double off = is_drawn ? std::abs(of.outside(at)) / exact.pixel_at(drawn) / depth_px : 0;
            const auto note_depth = [&] {
                sum.worst_depth = std::max(sum.worst_depth, off);
                sum.off += off > 1;
            };
            // A point that is off across the view is off along it by more where the surface slants.
            const double slack = is_drawn ? depth_px * exact.pixel_at(drawn) : 0;
            if (is_drawn && std::abs(here - drawn) <= slack && off <= 1) {
                note_depth();
                continue;
            }
            std::array<double, directions> around{};
            std::array<vector, directions> places;
            for (std::size_t k = 0; k < directions; ++k) {
                const double angle = static_cast<double>(k) * 2 * std::numbers::pi / directions;
                places[k] = centre + vector{std::cos(angle), std::sin(angle), 0.0} * place_px;
                around[k] = exact.distance(places[k][0], places[k][1]);
            }
            const auto misses = std::ranges::count(around, HUGE_VAL);
            if (is_drawn != std::isfinite(here)) {
                if (misses == (is_drawn ? std::ptrdiff_t{directions} : 0)) {
                    ++(is_drawn ? sum.beyond : sum.uncovered);
                    note_depth();
                    continue;
                }
                ++sum.undecided;
                double nearest = 1;
                for (std::size_t k = 0; k < directions; ++k)
                    if (std::isfinite(around[k]) == is_drawn)
                        nearest =
                            std::min(nearest, is_drawn ? 1 - exact.outline(places[k], centre)[0]
                                                       : exact.outline(centre, places[k])[0]);
                sum.worst_outline = std::max(sum.worst_outline, nearest);
            }
            if (!is_drawn)
                continue;
            const auto has = [&](double a, double b) {
                return drawn >= std::min(a, b) - slack && drawn <= std::max(a, b) + slack;
            };
            // Beyond an outline, the surface turns away as fast as it comes.
            const auto has_to_outline = [&](double near, double outline) {
                return has(near, outline + std::abs(outline - near));
            };
            const auto shows = [&](const vector& a, double at_a, const vector& b, double at_b) {
                if (std::isfinite(at_a) && std::isfinite(at_b))
                    return has(at_a, at_b);
                if (std::isfinite(at_a))
                    return has_to_outline(at_a, exact.outline(a, b)[1]);
                return std::isfinite(at_b) && has_to_outline(at_b, exact.outline(b, a)[1]);
            };
            bool is_seen = false;
            // A face may go on beyond its end by the bound of places. Then it is still within the
            // bound of depth of its own plane at a place that is seen.
            const auto plane_share = [&](const vector& place, double w) {
                if (!std::isfinite(w))
                    return HUGE_VAL;
                const vector from = rays.camera.eye + rays.at(place[0], place[1]) * w;
                const double step = exact.pixel_at(w) / 16;
                vector normal{0.0, 0.0, 0.0};
                for (int k = 0; k < 3; ++k) {
                    vector beside = from;
                    beside[k] += step;
                    normal[k] = of.outside(beside);
                    beside[k] -= 2 * step;
                    normal[k] -= of.outside(beside);
                }
                const double length = l3d_length(normal);
                return length > 0 ? std::abs(l3d_dot(normal, at - from)) / length /
                                        exact.pixel_at(drawn) / depth_px
                                  : HUGE_VAL;
            };
            double of_planes = plane_share(centre, here);
            for (std::size_t k = 0; k < directions; ++k)
                of_planes = std::min(of_planes, plane_share(places[k], around[k]));
            is_seen = of_planes <= 1;
            off = std::min(off, of_planes);
            note_depth();
            for (std::size_t k = 0; k < directions && !is_seen; ++k) {
                const std::size_t next = (k + 1) % directions;
                is_seen = shows(centre, here, places[k], around[k]) ||
                          shows(places[k], around[k], places[next], around[next]);
            }
            sum.behind += !is_seen;
        }
    sum.on_edges += edge_pixels(of, rays, exact, report.dice.bound_px + 1).count();
}
