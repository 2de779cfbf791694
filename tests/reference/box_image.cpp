// SPDX-License-Identifier: MIT
// Means over pixels: a coarse grid of samples everywhere, exact lines where edges pass.
#include "reference/box_image.h"
#include "reference/quadrature.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace reference {
namespace {

/// Samples are good to 1e-9 px (hits.h). Light is within 0 and 1, and no curve is steeper than
/// sRGB's near black.
constexpr double sample_levels = 1e-9 * 12.92 * 255;

/// Between two samples that differ, an edge is known to so much.
constexpr double least_width = 1.0 / 4096;

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

/// A pixel that an edge may pass, by exact lines in that direction in which light changes more.
class edge_pixel {
public:
    edge_pixel(const light_sampler& exact, const box_settings& settings, int x, int y)
        : exact_(exact), settings_(settings), x_(x), y_(y) {}

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
        while (static_cast<int>(lines_.size()) < settings_.most_lines && put_between()) {
        }
        return resolved(lines_, samples_, true);
    }

private:
    light_sample look(double along, double across) {
        ++samples_;
        return rows_ ? exact_.look(x_ + along, y_ + across) : exact_.look(x_ + across, y_ + along);
    }

    template <class Sample> line_node line(double across, Sample sample) {
        const int cells = settings_.edge_cells;
        light_sample before = sample(0);
        nodes_.assign(1, node_of(0, before));
        for (int i = 1; i <= cells; ++i) {
            const light_sample next = sample(i);
            refine(across, static_cast<double>(i - 1) / cells, before,
                   static_cast<double>(i) / cells, next);
            before = next;
        }
        line_node result = integral_of(nodes_);
        result.at = across;
        return result;
    }

    /// Adds the nodes beyond `low` up to `high`.
    void refine(double across, double low, const light_sample& at_low, double high,
                const light_sample& at_high) {
        const double change = std::abs(at_high.level - at_low.level), width = high - low;
        const bool same = at_low.covered() == at_high.covered();
        if ((same && change <= smooth_levels) || width <= least_width) {
            nodes_.push_back(node_of(high, at_high));
            nodes_.back().after_jump = !same || change > smooth_levels;
            return;
        }
        const double middle = (low + high) / 2;
        const light_sample between = look(middle, across);
        const double off = std::abs(between.level - (at_low.level + at_high.level) / 2);
        if (same && between.covered() == at_low.covered() && off * width <= straight_levels) {
            nodes_.push_back(node_of(middle, between));
            nodes_.push_back(node_of(high, at_high));
            return;
        }
        refine(across, low, at_low, middle, between);
        refine(across, middle, between, high, at_high);
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
        const double across = (place->at + (place + 1)->at) / 2;
        const line_node added = line(across, [&](int i) {
            return look(static_cast<double>(i) / settings_.edge_cells, across);
        });
        lines_.insert(place + 1, added);
        return true;
    }

    const light_sampler& exact_;
    const box_settings& settings_;
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
    const light_sampler exact(patches, view, size, light, settings.background);
    std::vector<std::uint8_t> differs(pixels_.size());
    const auto index = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
               static_cast<std::size_t>(x);
    };
    for (int top = 0; top < size.height; top += band_rows) {
        const int rows = std::min(band_rows, size.height - top);
        const sampled samples(exact, 0, top, size.width, rows, settings.cells);
        for (int y = top; y < top + rows; ++y)
            for (int x = 0; x < size.width; ++x) {
                samples.for_neighbours(x, y - top, [&](const auto& p, const auto& q, bool) {
                    if (exact.differ(p, q))
                        differs[index(x, y)] = 1;
                });
                pixels_[index(x, y)] = smooth_pixel(samples, x, y - top, settings.cells);
                pixels_[index(x, y)].edge = pixels_[index(x, y)].unsure > settings.wanted;
            }
    }
    const auto near_edge = [&](int x, int y) {
        if (pixels_[index(x, y)].edge)
            return true;
        for (int j = std::max(0, y - 1); j <= std::min(size.height - 1, y + 1); ++j)
            for (int i = std::max(0, x - 1); i <= std::min(size.width - 1, x + 1); ++i)
                if (differs[index(i, j)])
                    return true;
        return false;
    };
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width;) {
            int end = x;
            while (end < size.width && end - x < most_run && near_edge(end, y))
                ++end;
            if (end > x) {
                const sampled samples(exact, x, y, end - x, 1, settings.edge_cells);
                for (int i = x; i < end; ++i)
                    pixels_[index(i, y)] =
                        edge_pixel(exact, settings_, i, y).resolve(samples, i - x);
            }
            x = std::max(end, x + 1);
        }
}

} // namespace reference
