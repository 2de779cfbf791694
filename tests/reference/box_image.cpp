// SPDX-License-Identifier: MIT
// Means over pixels: a coarse grid of samples everywhere, exact lines where edges pass.
#include "reference/box_image.h"
#include "reference/outlines.h"
#include "reference/quadrature.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace reference {
namespace {

/// Samples are good to 1e-9 px (hits.h). Light is within 0 and 1, and no curve is steeper than
/// sRGB's near black.
constexpr double sample_levels = 1e-9 * 12.92 * 255;

/// Between two samples that differ, an edge is known to so much.
constexpr double least_width = 1.0 / 4096;

/// A border is known to 1e-9 px. Samples so far on both sides of it show what it divides; places
/// that are nearer to each other than `nearest` are one.
constexpr double aside = 1e-7, nearest = 1e-9;

/// Neighbouring lines of sight of a line differ by no more than this, or by an edge.
constexpr double smooth_levels = 1;

/// A stretch of a line whose middle is off by so many levels and pixels is straight enough: some
/// dozens of them make up a line. The middle of a jump is as light as one of its ends, so it is off
/// by half the jump.
constexpr double straight_levels = 0.005;

/// How many rows of pixels are sampled at once: 17 MB of samples where 1024 pixels make a row.
constexpr int band_rows = 16;
/// How many edge pixels of a row are sampled at once.
constexpr int most_run = 64;

double encoded_error(double light, double unsure) {
    const double level = level_of_light(light);
    return std::max(level_of_light(std::min(light + unsure, 1.0)) - level,
                    level - level_of_light(std::max(light - unsure, 0.0))) +
           sample_levels;
}

/// The samples of the squares of some pixels, `cells` + 1 along either side of each.
class sampled {
public:
    sampled(const light_sampler& from, int x0, int y0, int columns, int rows, int cells)
        : cells_(cells), width_(columns * cells + 1),
          samples_(from.grid({static_cast<double>(x0), static_cast<double>(y0), 1.0 / cells, width_,
                              rows * cells + 1})) {}

    /// Sample (i, j), each 0 to `cells`, of the pixel (x, y), counted from the first.
    const light_sample& at(int x, int y, int i, int j) const {
        return samples_[static_cast<std::size_t>(y * cells_ + j) *
                            static_cast<std::size_t>(width_) +
                        static_cast<std::size_t>(x * cells_ + i)];
    }
    /// Calls visit for all samples of a pixel that lie next to each other.
    template <class Visit> void for_neighbours(int x, int y, Visit visit) const {
        for (int j = 0; j <= cells_; ++j)
            for (int i = 0; i <= cells_; ++i) {
                if (i < cells_)
                    visit(at(x, y, i, j), at(x, y, i + 1, j), true);
                if (j < cells_)
                    visit(at(x, y, i, j), at(x, y, i, j + 1), false);
            }
    }

private:
    int cells_, width_;
    std::vector<light_sample> samples_;
};

line_node node_of(double at, const light_sample& seen) {
    return {at, seen.light, seen.covered() ? 1.0 : 0.0, 0, false};
}

box_pixel resolved(std::span<const line_node> lines, int samples, bool edge) {
    const line_node mean = integral_of(lines);
    box_pixel result;
    result.level = level_of_light(mean.light);
    result.unsure = encoded_error(mean.light, mean.unsure);
    result.covered = mean.covered;
    result.samples = samples;
    result.edge = edge;
    return result;
}

box_pixel smooth_pixel(const sampled& samples, int x, int y, int cells) {
    std::vector<line_node> lines, line;
    for (int j = 0; j <= cells; ++j) {
        line.clear();
        for (int i = 0; i <= cells; ++i)
            line.push_back(node_of(static_cast<double>(i) / cells, samples.at(x, y, i, j)));
        lines.push_back(integral_of(line));
        lines.back().at = static_cast<double>(j) / cells;
    }
    return resolved(lines, (cells + 1) * (cells + 1), false);
}

/// What the coarse samples tell of a pixel.
struct first_look {
    double farthest = 0;   ///< no surface is seen behind this distance
    bool differs = false;  ///< neighbouring samples do
    bool touching = false; ///< the two nearest surfaces may cross
};

first_look look_at(const sampled& samples, const light_sampler& exact, int x, int y) {
    first_look result;
    double closest = std::numeric_limits<double>::infinity();
    double least_gap = closest, most_gap = 0;
    samples.for_neighbours(x, y, [&](const auto& p, const auto& q, bool) {
        result.differs = result.differs || exact.differ(p, q);
        for (const light_sample& each : {p, q}) {
            result.farthest = std::max(result.farthest, each.w);
            closest = std::min(closest, each.w);
            if (std::isfinite(each.gap)) {
                least_gap = std::min(least_gap, each.gap);
                most_gap = std::max(most_gap, each.gap);
            }
        }
    });
    // Between samples, a surface may go on as steeply as it does from sample to sample.
    if (std::isfinite(result.farthest))
        result.farthest += result.farthest - closest;
    result.touching = least_gap < 2 * (most_gap - least_gap);
    return result;
}

/// What may make light jump within one pixel.
struct pixel_outlines {
    std::vector<border_part> borders;
    std::vector<fold_piece> folds;
};

/// A pixel that an edge may pass, by exact lines in that direction in which light changes more.
class edge_pixel {
public:
    edge_pixel(const light_sampler& exact, const box_settings& settings,
               const pixel_outlines& outlines, int x, int y)
        : exact_(exact), settings_(settings), outlines_(outlines), x_(x), y_(y) {}

    box_pixel resolve(const sampled& samples, int column) {
        const int cells = settings_.edge_cells;
        double along_x = 0, along_y = 0;
        samples.for_neighbours(column, 0, [&](const auto& p, const auto& q, bool in_row) {
            (in_row ? along_x : along_y) += std::abs(p.light - q.light);
        });
        rows_ = along_x >= along_y;
        for (int j = 0; j <= cells; ++j)
            lines_.push_back(line(static_cast<double>(j) / cells, [&](int i) {
                return rows_ ? samples.at(column, 0, i, j) : samples.at(column, 0, j, i);
            }));
        samples_ += (cells + 1) * (cells + 1);
        for (const double turn : turning_places())
            add_line(turn);
        meet_folds();
        while (static_cast<int>(lines_.size()) < settings_.most_lines && put_between()) {
        }
        return resolved(lines_, samples_, true);
    }

private:
    light_sample look(double along, double across) {
        ++samples_;
        return rows_ ? exact_.look(x_ + along, y_ + across) : exact_.look(x_ + across, y_ + along);
    }

    /// Where the sums of lines may jump or bend because of a border.
    std::vector<double> turning_places() const {
        std::vector<double> result;
        const double start = rows_ ? y_ : x_, side = rows_ ? x_ : y_;
        for (const border_part& each : outlines_.borders)
            for (const auto& places : {turns(each, rows_), crossings(each, !rows_, side),
                                       crossings(each, !rows_, side + 1)})
                for (const double place : places)
                    result.push_back(place - start);
        return both_sides(result);
    }

    /// How far a piece reaches across the lines, by its sides. The hull reaches farther.
    range reach_of(const fold_piece& fold) const {
        range result{std::numeric_limits<double>::infinity(),
                     -std::numeric_limits<double>::infinity()};
        for (const border_part& side : fold.sides)
            for (const double place : turns(side, rows_))
                result = {std::min(result.low, place), std::max(result.high, place)};
        return result;
    }

    /// Lines through all that folds and lies between the lines.
    void meet_folds() {
        const double start = rows_ ? y_ : x_;
        for (const fold_piece& each : outlines_.folds) {
            const range reach = reach_of(each);
            if (std::none_of(lines_.begin(), lines_.end(), [&](const line_node& line) {
                    return reach.low <= start + line.at && start + line.at <= reach.high;
                }))
                add_line((reach.low + reach.high) / 2 - start);
        }
    }

    /// The places where light may jump along a line, and some in between, so that nothing is
    /// passed over.
    std::vector<double> breaks(double across) const {
        std::vector<double> jumps, result;
        const double start = rows_ ? x_ : y_, line = across + (rows_ ? y_ : x_);
        for (const border_part& each : outlines_.borders)
            for (const double place : crossings(each, rows_, line))
                jumps.push_back(place - start);
        result = both_sides(jumps);
        // A sheet however thin is met where the line meets the sides of its pieces.
        for (const fold_piece& each : outlines_.folds)
            for (const border_part& side : each.sides)
                for (const double place : crossings(side, rows_, line))
                    result.push_back(place - start);
        std::sort(result.begin(), result.end());
        return result;
    }

    /// On both sides of each, once of those that coincide.
    static std::vector<double> both_sides(std::vector<double>& places) {
        std::sort(places.begin(), places.end());
        std::vector<double> result;
        for (const double place : places)
            if (place > -aside && place < 1 + aside &&
                (result.empty() || place - aside > result.back() + 2 * aside)) {
                result.push_back(place - aside);
                result.push_back(place + aside);
            }
        return result;
    }

    template <class Sample> line_node line(double across, Sample sample) {
        const int cells = settings_.edge_cells;
        const std::vector<double> between = breaks(across);
        auto next = between.begin();
        light_sample before = sample(0);
        nodes_.assign(1, node_of(0, before));
        bool after_break = false;
        const auto go_to = [&](double at, const light_sample& seen, bool is_break) {
            refine(across, nodes_.back().at, before, at, seen, after_break + is_break);
            before = seen;
            after_break = is_break;
        };
        for (int i = 1; i <= cells; ++i) {
            const double end = static_cast<double>(i) / cells;
            for (; next != between.end() && *next < end - nearest; ++next)
                if (*next > nodes_.back().at + nearest)
                    go_to(*next, look(*next, across), true);
            go_to(end, sample(i), false);
        }
        line_node result = integral_of(nodes_);
        result.at = across;
        return result;
    }

    /// Adds the nodes beyond `low` up to `high`. What may be all of a thin sheet is halved a few
    /// times whatever its ends show.
    void refine(double across, double low, const light_sample& at_low, double high,
                const light_sample& at_high, int least_halvings) {
        const double change = std::abs(at_high.level - at_low.level), width = high - low;
        const bool same = at_low.covered() == at_high.covered();
        if (width <= least_width ||
            (least_halvings <= 0 && change <= smooth_levels && !exact_.differ(at_low, at_high))) {
            nodes_.push_back(node_of(high, at_high));
            nodes_.back().after_jump = width <= least_width;
            return;
        }
        const double middle = (low + high) / 2;
        const light_sample between = look(middle, across);
        const double off = std::abs(between.level - (at_low.level + at_high.level) / 2);
        if (least_halvings <= 1 && same && between.covered() == at_low.covered() &&
            off * width <= straight_levels) {
            nodes_.push_back(node_of(middle, between));
            nodes_.push_back(node_of(high, at_high));
            return;
        }
        refine(across, low, at_low, middle, between, least_halvings - 1);
        refine(across, middle, between, high, at_high, least_halvings - 1);
    }

    /// Another line where the mean is least sure; false if all is as sure as is wanted, or no
    /// more can be had.
    bool put_between() {
        const line_node mean = integral_of(lines_);
        if (encoded_error(mean.light, mean.unsure) <= settings_.wanted)
            return false;
        const auto errors = stretch_errors(lines_);
        const auto worst = std::max_element(errors.begin(), errors.end()) - errors.begin();
        const auto place = lines_.begin() + worst;
        if (!(errors[static_cast<std::size_t>(worst)] > 0) ||
            (place + 1)->at - place->at <= least_width)
            return false;
        add_line((place->at + (place + 1)->at) / 2);
        return true;
    }

    void add_line(double across) {
        const auto place = std::lower_bound(
            lines_.begin(), lines_.end(), across,
            [](const line_node& known, double wanted) { return known.at < wanted; });
        if (place == lines_.begin() || place == lines_.end() || place->at - across < nearest ||
            across - (place - 1)->at < nearest)
            return;
        const line_node added = line(across, [&](int i) {
            return look(static_cast<double>(i) / settings_.edge_cells, across);
        });
        const auto after = lines_.insert(place, added) + 1;
        for (const auto& end : {after - 1, after})
            end->after_jump = end->at - (end - 1)->at <= 2.5 * aside;
    }

    const light_sampler& exact_;
    const box_settings& settings_;
    const pixel_outlines& outlines_;
    int x_, y_;
    bool rows_ = true;
    int samples_ = 0;
    std::vector<line_node> lines_, nodes_;
};

} // namespace

box_image::box_image(std::span<const patch> patches, const camera& view, picture_size size,
                     vec3 light, const box_settings& settings)
    : size_(size), settings_(settings),
      pixels_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)) {
    light_sampler exact(patches, view, size, light, settings.background);
    exact.take(settings.lamps);
    const outline_map outlines(patches, view, size);
    std::vector<first_look> looks(pixels_.size());
    const auto index = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
               static_cast<std::size_t>(x);
    };
    for (int top = 0; top < size.height; top += band_rows) {
        const int rows = std::min(band_rows, size.height - top);
        const sampled samples(exact, 0, top, size.width, rows, settings.cells);
        for (int y = top; y < top + rows; ++y)
            for (int x = 0; x < size.width; ++x) {
                looks[index(x, y)] = look_at(samples, exact, x, y - top);
                pixels_[index(x, y)] = smooth_pixel(samples, x, y - top, settings.cells);
            }
    }
    const auto is_edge = [&](int x, int y) {
        const first_look& own = looks[index(x, y)];
        if (own.touching || pixels_[index(x, y)].unsure > settings.wanted ||
            outlines.any(x, y, own.farthest))
            return true;
        for (int j = std::max(0, y - 1); j <= std::min(size.height - 1, y + 1); ++j)
            for (int i = std::max(0, x - 1); i <= std::min(size.width - 1, x + 1); ++i)
                if (looks[index(i, j)].differs)
                    return true;
        return false;
    };
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width;) {
            int end = x;
            while (end < size.width && end - x < most_run && is_edge(end, y))
                ++end;
            if (end > x) {
                const sampled samples(exact, x, y, end - x, 1, settings.edge_cells);
                for (int i = x; i < end; ++i) {
                    const double farthest = looks[index(i, y)].farthest;
                    const pixel_outlines own{outlines.borders(i, y, farthest),
                                             outlines.folds(i, y, farthest)};
                    pixels_[index(i, y)] =
                        edge_pixel(exact, settings_, own, i, y).resolve(samples, i - x);
                }
            }
            x = std::max(end, x + 1);
        }
}

} // namespace reference
