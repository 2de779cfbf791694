// SPDX-License-Identifier: MIT
// light_in, lone_sheet: bound light by the levels of one white lamp, or by Blinn's rule and fog.
#include "dice/certificate/doubt_light_p.h"

#include "raster/color/srgb_light.h"

#include <cmath>

namespace l3d_detail {
namespace {

/// If the shade level changes by more than even_levels over a cell, the cell is cut into finer_cuts
/// rows and columns, to average its light.
constexpr double even_levels = 4;
constexpr int finer_cuts = 4;

/// The mean light of lamps should be known to within known_levels. Until then, cells are cut into
/// more rows and columns, as long as each cut reduces the uncertainty by a quarter.
constexpr double known_levels = 0.5, worth_while = 0.75;
constexpr int most_cuts = 16;

/// Bounds a piece's shade levels above that of ambient light, in a cell.
interval levels_in(const l3d_doubt_bounds& b, const l3d_image_box& cell) {
    const auto [least, most] = b.range(b.level, cell);
    return {std::max(0.0, least), std::max(0.0, most)};
}

/// The level above ambient light, by a piece's line, at a place in the picture.
double level_at(const l3d_doubt_bounds& b, double x, double y) {
    return b.level.at(x - b.at_x, y - b.at_y);
}

/// The light of a channel whose colour is `part` of white, at a shade level. `level` is counted
/// from the level of ambient light.
double light_above_ambient(double level, double part) {
    return l3d_light_of_level(part * (l3d_ambient_level + std::max(0.0, level)));
}

/// Bounds a material's light for shade levels between two bounds.
l3d_light_bounds light_of(const interval& levels, const l3d_color_parts& color) {
    return l3d_light_bounds::by_parts(color, [&](double part) {
        return std::array{light_above_ambient(levels.low, part),
                          light_above_ambient(levels.high, part)};
    });
}

/// Bounds the mean light of a cell whose level is between line - below and line + above. Light is a
/// convex function of the level, and so of the place. So the mean over a square is at least the
/// light in its middle, and at most the mean of the light at its corners.
interval mean_light(const l3d_doubt_bounds& line, double below, double above,
                    const l3d_image_box& cell, double part) {
    const double change =
        std::abs(line.level.along_x) * cell.width() + std::abs(line.level.along_y) * cell.height();
    const int cuts = change > even_levels ? finer_cuts : 1;
    interval sum{0, 0};
    const auto level = [&](double column, double row) {
        return level_at(line, cell.left + cell.width() * column / cuts,
                        cell.top + cell.height() * row / cuts);
    };
    for (int row = 0; row < cuts; ++row)
        for (int column = 0; column < cuts; ++column)
            sum.low += light_above_ambient(level(column + 0.5, row + 0.5) - below, part);
    for (int row = 0; row <= cuts; ++row)
        for (int column = 0; column <= cuts; ++column) {
            const double weight = (row % cuts == 0 ? 0.5 : 1.0) * (column % cuts == 0 ? 0.5 : 1.0);
            sum.high += weight * light_above_ambient(level(column, row) + above, part);
        }
    return {sum.low / (cuts * cuts), sum.high / (cuts * cuts)};
}

/// Bounds of the light that a lamp adds in a cell: what a white surface scatters, and what a
/// perfect mirror reflects.
struct lamp_amounts {
    interval scattered{0, 0}, mirrored{0, 0};

    /// Bounds both lights from the ranges of their cosines. A lamp behind the surface adds nothing,
    /// so its mirrored light ends abruptly where n.l is 0.
    lamp_amounts(const interval& lit, const interval& facing, const l3d_doubt_patch& of) {
        constexpr double of_lamps = 0.9;
        scattered = {of_lamps * std::max(0.0, lit.low), of_lamps * std::max(0.0, lit.high)};
        if (of.highlight == l3d_color_parts{})
            return;
        const auto peak = [&](double cosine) {
            return std::pow(std::clamp(cosine, 0.0, 1.0), of.sharpness);
        };
        mirrored = {lit.low > 0 ? peak(facing.low) : 0, lit.high > 0 ? peak(facing.high) : 0};
    }
};

/// Bounds a channel's level that is blended with the level of fog. The extremes lie at the ends of
/// the range of the fog's shares.
interval faded(const interval& level, double fog, const interval& share) {
    const auto mean = [&](double of, double part) { return of + part * (fog - of); };
    return {std::min(mean(level.low, share.low), mean(level.low, share.high)),
            std::max(mean(level.high, share.low), mean(level.high, share.high))};
}

/// Bounds the light of lamps and fog, from ranges of the cosines and of w.
l3d_light_bounds light_by_lamps(const l3d_doubt_patch& of, const light_ranges& ranges,
                                const l3d_light_bounds& background) {
    const l3d_doubt_lighting& lighting = *of.lighting;
    std::array<interval, 3> channels;
    for (std::size_t i = 0; i < channels.size(); ++i)
        channels[i].low = channels[i].high = of.color[i] * double{lighting.ambient[i]};
    std::size_t next = 0;
    for (const l3d_doubt_lamp& lamp : lighting.lamps) {
        const lamp_amounts amounts(ranges[next], ranges[next + 1], of);
        next += 2;
        for (std::size_t i = 0; i < channels.size(); ++i) {
            const double strength = double{lamp.color[i]};
            channels[i].low += strength * (of.color[i] * amounts.scattered.low +
                                           of.highlight[i] * amounts.mirrored.low);
            channels[i].high += strength * (of.color[i] * amounts.scattered.high +
                                            of.highlight[i] * amounts.mirrored.high);
        }
    }
    interval share{0, 0};
    const l3d_fog& fog = lighting.fog;
    const auto share_at = [&](double w) {
        const double near = double{fog.from}, distance = w / lighting.depth_scale - lighting.nearer;
        return std::clamp((distance - near) / (double{fog.to} - near), 0.0, 1.0);
    };
    if (fog.is_on())
        share = {share_at(ranges[next].low), share_at(ranges[next].high)};
    l3d_light_bounds result;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        interval level{255 * std::min(1.0, channels[i].low), 255 * std::min(1.0, channels[i].high)};
        if (fog.is_on())
            level = faded(level,
                          fog.color ? *fog.color >> (16 - 8 * i) & 255
                                    : l3d_level_of_light(background.least[i]),
                          share);
        result.least[i] = l3d_light_of_level(level.low);
        result.most[i] = l3d_light_of_level(level.high);
    }
    return result;
}

light_ranges ranges_in(const l3d_doubt_bounds& b, const l3d_image_box& cell) {
    const light_lines lines(b);
    light_ranges result;
    for (std::size_t i = 0; i < lines.count; ++i) {
        const auto [least, most] = b.range(*lines.lines[i], cell);
        result[i] = {std::min(least, most), std::max(least, most)};
    }
    return result;
}

} // namespace

light_lines::light_lines(const l3d_doubt_bounds& b) {
    if (b.lamps.empty()) {
        lines[count++] = &b.level;
        return;
    }
    for (const l3d_doubt_cosines& each : b.lamps) {
        lines[count++] = &each.lit;
        lines[count++] = &each.facing;
    }
    lines[count++] = &b.w;
}

l3d_light_bounds light_in(const l3d_doubt_leaf& leaf, const l3d_image_box& cell,
                          const l3d_light_bounds& background) {
    const l3d_doubt_patch& of = *leaf.piece.of;
    if (!of.lighting)
        return light_of(levels_in(leaf.bounds, cell), of.color);
    if (leaf.bounds.lamps.empty())
        return l3d_light_bounds::any();
    return light_by_lamps(of, ranges_in(leaf.bounds, cell), background);
}

void lone_sheet::offer(const l3d_doubt_leaf& leaf) {
    if (best_ == nullptr || leaf.bounds.level.off < best_->bounds.level.off)
        best_ = &leaf;
}

void lone_sheet::add(const l3d_doubt_leaf& leaf) {
    const l3d_doubt_bounds &b = leaf.bounds, &best = best_->bounds;
    const l3d_light_bounds here = light_in(leaf, cell_, background_);
    if (first_ == nullptr)
        light_ = here;
    else
        light_.include(here);
    is_one_look_ = is_one_look_ && (!first_ || leaf.piece.of->looks_like(*first_->piece.of));
    first_ = &leaf;
    const light_lines own(b), of_best(best);
    is_known_ = is_known_ && own.count == of_best.count;
    if (!is_known_)
        return;
    const l3d_image_box part = b.box.intersected(cell_);
    for (std::size_t i = 0; i < own.count; ++i) {
        const l3d_doubt_line &line = *own.lines[i], &beside = *of_best.lines[i];
        const auto [least, most] = b.range(line, cell_);
        ranges_[i].add({least, most});
        for (const double x : {part.left, part.right})
            for (const double y : {part.top, part.bottom}) {
                const double higher =
                    line.at(x - b.at_x, y - b.at_y) - beside.at(x - best.at_x, y - best.at_y);
                beside_[i].add({higher - line.off, higher + line.off});
            }
    }
}

double lone_sheet::at(std::size_t line, double x, double y) const {
    const l3d_doubt_bounds& b = best_->bounds;
    return light_lines(b).lines[line]->at(x - b.at_x, y - b.at_y);
}

l3d_doubt_verdict lone_sheet::of_levels() const {
    const interval levels{std::max(0.0, ranges_[0].low), std::max(0.0, ranges_[0].high)};
    const double below = std::max(0.0, -beside_[0].low), above = std::max(0.0, beside_[0].high);
    const auto of_part = [&](double part) {
        const interval mean = mean_light(best_->bounds, below, above, cell_, part);
        return std::array{std::max(light_above_ambient(levels.low, part), mean.low),
                          std::min(light_above_ambient(levels.high, part), mean.high)};
    };
    return {true, true, l3d_light_bounds::by_parts(first_->piece.of->color, of_part),
            std::min(levels.high - levels.low, below + above)};
}

/// Bounds the mean light of lamps in the cell. Splits the cell into squares and averages the
/// squares' bounds.
l3d_light_bounds lone_sheet::mean_by_lamps(int cuts) const {
    const light_lines lines(best_->bounds);
    const double width = cell_.width() / cuts, height = cell_.height() / cuts;
    l3d_light_bounds sum;
    light_ranges here;
    for (int row = 0; row < cuts; ++row)
        for (int column = 0; column < cuts; ++column) {
            const double x = cell_.left + (column + 0.5) * width;
            const double y = cell_.top + (row + 0.5) * height;
            for (std::size_t i = 0; i < lines.count; ++i) {
                const l3d_doubt_line& line = *lines.lines[i];
                const double middle = at(i, x, y);
                const double reach =
                    (std::abs(line.along_x) * width + std::abs(line.along_y) * height) / 2;
                const double low = std::max(ranges_[i].low, middle - reach + beside_[i].low);
                const double high = std::min(ranges_[i].high, middle + reach + beside_[i].high);
                here[i] = {std::min(low, high), std::max(low, high)};
            }
            sum.add(light_by_lamps(*first_->piece.of, here, background_), 1.0 / (cuts * cuts));
        }
    return sum;
}

l3d_doubt_verdict lone_sheet::of_lamps() const {
    if (best_->bounds.lamps.empty())
        return {false, false, l3d_light_bounds::any(), 255};
    l3d_light_bounds light = mean_by_lamps(1);
    double apart = light.levels_apart();
    for (int cuts = finer_cuts; apart > known_levels && cuts <= most_cuts; cuts *= finer_cuts) {
        light = mean_by_lamps(cuts);
        const double now = light.levels_apart();
        const bool helps = now < worth_while * apart;
        apart = now;
        if (!helps)
            break;
    }
    return {true, true, light, apart};
}

l3d_doubt_verdict lone_sheet::verdict() const {
    if (first_ == nullptr || !is_known_ || !(ranges_[0].low <= ranges_[0].high))
        return {false, false, l3d_light_bounds::any(), 255}; // rounding left no piece of the sheet
    if (!is_one_look_)
        return {false, false, light_, light_.levels_apart()};
    return first_->piece.of->lighting ? of_lamps() : of_levels();
}

} // namespace l3d_detail
