// SPDX-License-Identifier: MIT
// Judging drawn points and pictures.
#include "judge.h"

#include "dice/drawn_points.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <limits>

namespace stability {
namespace {

/// Room for what the judges themselves may be off: exact_region's outlines by 2e-3, a hit by
/// 1e-9 pixels.
constexpr double outline_slack = 3e-3;

/// Larger pictures than this have no exact twin: it takes microseconds a pixel.
constexpr std::int64_t most_judged_pixels = 300'000;

/// Pixels of a picture whose distances are looked up: each may cost milliseconds.
constexpr int most_looked_up = 60;

std::string text(const char* format, auto... values) {
    char result[400];
    std::snprintf(result, sizeof result, format, values...);
    return result;
}

} // namespace

const char* name_of(outcome what) {
    switch (what) {
    case outcome::within:
        return "within";
    case outcome::weaker:
        return "weaker";
    case outcome::unbounded:
        return "no bound";
    case outcome::refused:
        return "refused";
    case outcome::violated:
        break;
    }
    return "VIOLATED";
}

void verdict::violate(const std::string& why) {
    what = outcome::violated;
    if (!reason.empty())
        reason += "; ";
    reason += why;
}

/// Looks at drawn points, and compares those that seem worst in 100 digits.
class judge::measuring {
public:
    measuring(const judge& of, l3d_size size) : of_(of), size_(size) {}

    void operator()(std::size_t patch, std::span<const l3d_diced_piece> pieces,
                    double frame_bound) {
        part_ = of_.parts_[patch];
        surface_ = &of_.surfaces_[part_.surface];
        const double curved = of_.accepted_->curved_px;
        worst_.clear();
        std::size_t polygons = 0;
        for (const l3d_diced_piece& piece : pieces)
            polygons += quads_of(piece) + piece.part.triangles.count;
        // The parts of a surface share what one patch may have.
        const std::size_t parts = of_.parts_.size() / of_.surfaces_.size();
        const dice_tests::drawn_points some(size_, 1 + polygons * parts / of_.how_.most_polygons,
                                            of_.case_.eye.parallel);
        for (const l3d_diced_piece& piece : pieces) {
            some.of_grid(piece, [&](const auto& at) { look(at, piece.bound + curved); });
            some.of_triangles(piece, [&](const auto& at) { look(at, frame_bound + curved); });
        }
        for (const candidate& c : worst_)
            compare(c);
    }

    double measured = 0, ratio = 0, ratio_measured = 0, ratio_bound = 0;
    std::int64_t points = 0, exactly = 0;
    std::string complaint;

private:
    struct candidate {
        dice_tests::drawn_point at;
        double bound, about;
    };

    static std::size_t quads_of(const l3d_diced_piece& piece) {
        const l3d_micro_grid& grid = piece.part.grid;
        return grid.rows < 2 ? 0
                             : static_cast<std::size_t>(grid.rows - 1) *
                                   static_cast<std::size_t>(grid.columns - 1);
    }

    static bool worse(const candidate& a, const candidate& b) { return a.about > b.about; }

    /// Keeps the points with the largest ratios, as 64 bits see them.
    void look(dice_tests::drawn_point at, double bound) {
        ++points;
        at.u = part_.u + part_.du * at.u;
        at.v = part_.v + part_.dv * at.v;
        const double distance = surface_->about(at.x, at.y, at.u, at.v);
        double about = distance / bound;
        if (!(about <= std::numeric_limits<double>::max()))
            about = std::numeric_limits<double>::max(); // a NaN is worst, not unordered
        else // pieces with wide bounds may have the largest distance
            measured = std::max(measured, distance);
        if (worst_.size() == of_.how_.exact_points) {
            if (about <= worst_.front().about)
                return;
            std::pop_heap(worst_.begin(), worst_.end(), worse);
            worst_.pop_back();
        }
        worst_.push_back({at, bound, about});
        std::push_heap(worst_.begin(), worst_.end(), worse);
    }

    void compare(const candidate& c) {
        const bool is_known = c.about < of_.how_.exact_from;
        exactly += !is_known;
        const double distance = is_known ? surface_->about(c.at.x, c.at.y, c.at.u, c.at.v)
                                         : surface_->distance(c.at.x, c.at.y, c.at.u, c.at.v);
        const bool kept = distance <= c.bound;
        if (std::isfinite(distance))
            measured = std::max(measured, distance);
        if (std::isfinite(c.bound) && distance / c.bound > ratio) {
            ratio = distance / c.bound;
            ratio_measured = distance;
            ratio_bound = c.bound;
        }
        if (!kept && complaint.empty())
            complaint = text("at u %.17g v %.17g drawn at %.6f, %.6f: %.6g px off, bound %.6g px",
                             c.at.u, c.at.v, c.at.x, c.at.y, distance, c.bound);
    }

    const judge& of_;
    l3d_size size_;
    seen_part part_;
    const exact_surface* surface_ = nullptr;
    std::vector<candidate> worst_;
};

judge::judge(const test_case& c, const effort& how)
    : case_(c), how_(how), accepted_(library_case::of(c, why_)) {
    if (!accepted_)
        return;
    const exact_camera camera(c.eye, c.size);
    for (const reference::patch& p : c.patches)
        surfaces_.emplace_back(p, camera);
    for (const l3d_patch_points& p : c.curved)
        surfaces_.emplace_back(p, camera);
    if (!c.curved.empty())
        parts_ = parts_of(accepted_->model);
    for (std::size_t i = 0; i < c.patches.size(); ++i)
        parts_.push_back({.surface = i});
}

verdict judge::refused() const {
    verdict result;
    result.what = outcome::refused;
    result.reason = why_;
    if (why_.empty() || !is_malformed(case_))
        result.violate("refused: " + why_);
    return result;
}

void judge::finish(verdict& v, const l3d_dice_counts& counts, const measuring& points) const {
    v.bound = counts.bound_px + accepted_->curved_px;
    v.measured = points.measured;
    v.ratio = points.ratio;
    v.ratio_measured = points.ratio_measured;
    v.ratio_bound = points.ratio_bound;
    v.points = points.points;
    v.exactly = points.exactly;
    v.samples = counts.samples;
    v.pieces = counts.pieces;
    v.what = v.bound <= case_.tolerance                      ? outcome::within
             : v.bound <= std::numeric_limits<double>::max() ? outcome::weaker
                                                             : outcome::unbounded;
    if (is_malformed(case_))
        v.violate("not refused");
    if (!(v.bound >= 0))
        v.violate("the bound is no number");
    if (!points.complaint.empty())
        v.violate(points.complaint);
}

verdict judge::of_points(arithmetic& in) {
    if (!accepted_)
        return refused();
    measuring points(*this, accepted_->size);
    verdict result;
    const l3d_dice_counts counts = in.dice(*accepted_, std::ref(points));
    finish(result, counts, points);
    return result;
}

verdict judge::of_frame(arithmetic& in) {
    if (!accepted_)
        return refused();
    measuring points(*this, accepted_->size);
    verdict result;
    frame drawn = in.draw(*accepted_, std::ref(points));
    finish(result, drawn.counts, points);
    result.milliseconds = drawn.milliseconds;
    judge_picture(result, drawn);
    words_ = std::move(drawn.words);
    return result;
}

/// The same for every arithmetic, as `near` is. A chord's w is off by near / 2 at most where
/// something crosses the near plane: what lies beyond 3/2 of it must be drawn, what lies before
/// half of it must not.
void judge::make_exact_picture(double near) {
    picture_tried_ = true;
    const auto pixels = std::int64_t{case_.size.width} * case_.size.height;
    if (pixels > most_judged_pixels || case_.far < 1e13)
        return;
    reference::camera shy = case_.eye, bold = case_.eye;
    shy.near = 1.5 * near;
    bold.near = 0.5 * near;
    try {
        auto least = std::make_unique<reference::exact_image>(case_.patches, shy, case_.size);
        auto outlines = std::make_unique<reference::exact_region>(case_.patches, shy, case_.size);
        auto most = std::make_unique<reference::exact_region>(case_.patches, bold, case_.size);
        least_covered_ = std::move(least);
        outlines_ = std::move(outlines);
        most_covered_ = std::move(most);
    } catch (const std::exception&) {
        // The reference says so where a patch is too much for it; its points are judged all the
        // same.
    }
}

void judge::judge_picture(verdict& v, const frame& drawn) {
    if (v.what == outcome::unbounded)
        return;
    if (!picture_tried_)
        make_exact_picture(drawn.near);
    if (!least_covered_)
        return;
    v.picture_judged = true;
    int looked_up = 0;
    const double most = v.bound + outline_slack;
    for (int y = 0; y < case_.size.height; ++y)
        for (int x = 0; x < case_.size.width; ++x) {
            const float distance = drawn.distances[static_cast<std::size_t>(y) *
                                                       static_cast<std::size_t>(case_.size.width) +
                                                   static_cast<std::size_t>(x)];
            const bool is = std::isfinite(distance), should = least_covered_->covered(x, y);
            if (is == should)
                continue;
            ++(is ? v.extra : v.missing);
            if (++looked_up > most_looked_up)
                continue;
            try {
                const double off = is ? most_covered_->distance_to_exact_surface(x + 0.5, y + 0.5)
                                      : outlines_->distance_to_outline(x + 0.5, y + 0.5);
                v.off = std::max(v.off, off);
                if (off > most)
                    v.violate(text("pixel %d, %d is %s: %.4f px from any outline, bound %.4f px", x,
                                   y, is ? "drawn" : "a hole", off, v.bound));
            } catch (const std::exception&) {
                v.picture_judged = false;
            }
        }
}

} // namespace stability
