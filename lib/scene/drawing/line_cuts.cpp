// SPDX-License-Identifier: MIT
// cut_lines: finds crossings of chords by a grid over the picture.
#include "scene/drawing/line_cuts_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace l3d_detail {

namespace {

/// Crossings of lines are found by a grid of squares. This is the side of a square. Units: pixels.
constexpr double square = 16;

/// Depths of chords are less exact than places. If the depths of two chords differ by less than
/// this, either chord may be in front. Units: pixels of depth.
constexpr double depth_doubt = 0.5;

struct chord {
    std::size_t chain, first; ///< the chord from this vertex to the next
};

class chord_grid {
public:
    chord_grid(std::span<const drawn_chain> chains, const drawing_view& view, double tolerance)
        : chains_(chains), half_width_(view.size().width / 2.0),
          half_height_(view.size().height / 2.0), tolerance_(tolerance),
          columns_(static_cast<std::size_t>(std::ceil(view.size().width / square)) + 2),
          rows_(static_cast<std::size_t>(std::ceil(view.size().height / square)) + 2),
          squares_(columns_ * rows_), cuts_(chains.size()) {
        for (std::size_t i = 0; i < chains_.size(); ++i) {
            lengths_.push_back(lengths_along(chains_[i].points));
            cuts_[i] = {0, lengths_[i].back()};
            for (std::size_t k = 0; k + 1 < chains_[i].points.size(); ++k)
                enter({i, k});
        }
        for (std::size_t i = 0; i < chains_.size(); ++i)
            for (std::size_t k = 0; k + 1 < chains_[i].points.size(); ++k)
                cut_at_border({i, k});
        for (std::size_t at = 0; at < squares_.size(); ++at)
            cross_in(at);
        for (std::size_t i = 0; i < chains_.size(); ++i)
            for (const surface_vertex* const end :
                 {&chains_[i].points.front(), &chains_[i].points.back()})
                end_on_others(i, *end);
        for (std::vector<double>& cuts : cuts_)
            std::ranges::sort(cuts);
    }

    std::vector<std::vector<double>> take() { return std::move(cuts_); }

private:
    const image_place& from(const chord& c) const { return chains_[c.chain].points[c.first].at; }
    const image_place& to(const chord& c) const { return chains_[c.chain].points[c.first + 1].at; }

    double column_of(double x) const { return std::floor((x + half_width_) / square) + 1; }
    double row_of(double y) const { return std::floor((y + half_height_) / square) + 1; }

    /// Visits the squares of the grid that a box reaches.
    template <class Visit>
    void for_squares(double left, double right, double top, double bottom,
                     const Visit& visit) const {
        const auto index = [](double at, std::size_t count) {
            return static_cast<std::size_t>(std::clamp(at, 0.0, double(count - 1)));
        };
        if (column_of(right) < 0 || column_of(left) >= double(columns_) || row_of(bottom) < 0 ||
            row_of(top) >= double(rows_))
            return;
        for (std::size_t r = index(row_of(top), rows_); r <= index(row_of(bottom), rows_); ++r)
            for (std::size_t c = index(column_of(left), columns_);
                 c <= index(column_of(right), columns_); ++c)
                visit(r * columns_ + c);
    }

    void enter(const chord& c) {
        const image_place &a = from(c), &b = to(c);
        // A long chord is cut into stretches as long as a square, so that it enters only squares
        // near it.
        const double long_side = std::max(std::abs(b.x - a.x), std::abs(b.y - a.y));
        const int parts = static_cast<int>(std::clamp(long_side / square, 1.0, 4096.0));
        for (int i = 0; i < parts; ++i) {
            const double s = double(i) / parts, t = double(i + 1) / parts;
            const double x0 = a.x + (b.x - a.x) * s, x1 = a.x + (b.x - a.x) * t;
            const double y0 = a.y + (b.y - a.y) * s, y1 = a.y + (b.y - a.y) * t;
            for_squares(std::min(x0, x1), std::max(x0, x1), std::min(y0, y1), std::max(y0, y1),
                        [&](std::size_t at) {
                            std::vector<chord>& here = squares_[at];
                            if (here.empty() || here.back().chain != c.chain ||
                                here.back().first != c.first)
                                here.push_back(c);
                        });
        }
    }

    void cut(const chord& c, double t) {
        const std::vector<double>& lengths = lengths_[c.chain];
        cuts_[c.chain].push_back(lengths[c.first] + (lengths[c.first + 1] - lengths[c.first]) * t);
    }

    bool may_hide(const chord& nearer, const chord& farther) const {
        return std::min(from(nearer).z, to(nearer).z) <=
               std::max(from(farther).z, to(farther).z) + depth_doubt;
    }

    void cut_at_border(const chord& c) {
        const image_place &a = from(c), &b = to(c);
        for (const double border : {-half_width_, half_width_})
            if ((a.x < border) != (b.x < border))
                cut(c, (border - a.x) / (b.x - a.x));
        for (const double border : {-half_height_, half_height_})
            if ((a.y < border) != (b.y < border))
                cut(c, (border - a.y) / (b.y - a.y));
    }

    void cross_in(std::size_t at) {
        const std::vector<chord>& here = squares_[at];
        for (std::size_t i = 0; i < here.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                cross(here[i], here[k], at);
    }

    void cross(const chord& one, const chord& two, std::size_t at) {
        if (one.chain == two.chain &&
            std::max(one.first, two.first) - std::min(one.first, two.first) <= 1)
            return;
        const image_place &a = from(one), &b = to(one), &c = from(two), &d = to(two);
        const double ux = b.x - a.x, uy = b.y - a.y, vx = d.x - c.x, vy = d.y - c.y;
        const double area = ux * vy - uy * vx;
        const double s = ((c.x - a.x) * vy - (c.y - a.y) * vx) / area;
        const double t = ((c.x - a.x) * uy - (c.y - a.y) * ux) / area;
        if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1))
            return;
        // Chords may share several squares; one of these holds the crossing.
        const double column = column_of(a.x + ux * s), row = row_of(a.y + uy * s);
        if (column != double(at % columns_) || row != double(at / columns_))
            return;
        if (may_hide(two, one))
            cut(one, s);
        if (may_hide(one, two))
            cut(two, t);
    }

    /// Cuts other lines where a line ends on them. A surface that hides the other lines often
    /// begins at the line's end.
    void end_on_others(std::size_t chain, const surface_vertex& end) {
        const double reach = 4 * tolerance_; // both lines are off by at most the tolerance
        for_squares(end.at.x - reach, end.at.x + reach, end.at.y - reach, end.at.y + reach,
                    [&](std::size_t at) {
                        for (const chord& c : squares_[at]) {
                            const image_place &a = from(c), &b = to(c);
                            if (c.chain == chain || distance_from(end.at, a, b) > reach ||
                                end.at.z > std::max(a.z, b.z) + depth_doubt)
                                continue;
                            const double dx = b.x - a.x, dy = b.y - a.y;
                            const double length = dx * dx + dy * dy;
                            const double along = (end.at.x - a.x) * dx + (end.at.y - a.y) * dy;
                            cut(c, length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0);
                        }
                    });
    }

    std::span<const drawn_chain> chains_;
    double half_width_, half_height_, tolerance_;
    std::size_t columns_, rows_;
    std::vector<std::vector<chord>> squares_;
    std::vector<std::vector<double>> lengths_, cuts_;
};

} // namespace

std::vector<double> lengths_along(const surface_line& line) {
    std::vector<double> result{0};
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        result.push_back(result.back() + std::hypot(line[i + 1].at.x - line[i].at.x,
                                                    line[i + 1].at.y - line[i].at.y));
    return result;
}

std::vector<std::vector<double>> cut_lines(std::span<const drawn_chain> chains,
                                           const drawing_view& view, double tolerance) {
    return chord_grid(chains, view, tolerance).take();
}

} // namespace l3d_detail
