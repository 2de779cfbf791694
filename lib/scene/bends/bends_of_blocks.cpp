// SPDX-License-Identifier: MIT
// bends_of_blocks: bounds the parts of a patch, quarters loose ones, and takes the largest bounds.
#include "scene/bends/bends_of_blocks.h"

#include <algorithm>
#include <cmath>

namespace l3d_detail {
namespace {

/// Limits of good bounds, which need no quartering. A bound is good up to `good_enough` times the
/// true number, or up to an eighth of the largest number of its kind. A bound is also good if it is
/// too small to matter. A turn up to a thousandth of a radian does not matter. Nor does a bend up
/// to 2^-14 of the patch's size, a 16th of a pixel on a thousand pixels.
constexpr double of_its_kind = 1.0 / 8, no_turn = 0x1p-10, no_bend = 0x1p-14;
constexpr struct {
    std::size_t first, end;
    double good_enough;
} kinds[]{{turn_u, turn_uu, 1.2},
          {turn_uu, turn_uuu, 1.3},
          {turn_uuu, bend_numbers, 1.6},
          {bend_uu, bend_uuu, 1.2},
          {bend_uuu, bend_uuvv, 1.5}};

/// The largest number of halvings of a block's sides. The second number is for parts without
/// bounds, as around a corner without a normal.
constexpr int most_halvings = 4, most_halvings_of_unknown = 3;

/// Turns a derivative by a part's parameters into the derivative by its block's parameters.
double of_block(double x, std::size_t number, int halvings) {
    return x * static_cast<double>(1 << (bend_orders[number] * halvings));
}

bend_nets nets_of(const l3d_bezier_patch<double, 3>& patch, const l3d_normal_net& normals) {
    bend_nets nets;
    nets.size = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const int component = static_cast<int>(c);
        for (int row = 0; row < 6; ++row)
            for (int column = 0; column < 6; ++column)
                nets.normals[c][row][column] = normals.at(row, column)[component];
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column) {
                const double from_first =
                    patch.at(row, column)[component] - patch.at(0, 0)[component];
                nets.points[c][row][column] = from_first;
                nets.size = std::max(nets.size, std::abs(from_first));
            }
    }
    return nets;
}

void copy_lane(const part_group& from, std::size_t lane, part_group& to, std::size_t to_lane) {
    for (std::size_t k = 0; k < 6; ++k)
        for (std::size_t l = 0; l < 6; ++l)
            for (std::size_t c = 0; c < 3; ++c)
                to.normals[k][l][c][to_lane] = from.normals[k][l][c][lane];
    for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t l = 0; l < 4; ++l)
            for (std::size_t c = 0; c < 3; ++c)
                to.points[k][l][c][to_lane] = from.points[k][l][c][lane];
}

} // namespace

bends_of_blocks::bends_of_blocks(const l3d_bezier_patch<double, 3>& patch,
                                 const l3d_normal_net& normals)
    : least_{}, most_{} {
    const bend_nets nets = nets_of(patch, normals);
    size_ = nets.size;
    make_parts(nets, parts_);
    leaves_.reserve(groups * part_lanes);
    for (std::size_t row = 0; row < bend_parts; ++row) {
        bound_parts(parts_[row], size_, bounds_[row]);
        for (std::size_t lane = 0; lane < part_lanes; ++lane)
            add(row, lane, row / 2 * 4 + lane / 2, 1);
    }
    judge();
    for (part& p : leaves_)
        p.looseness = looseness(p);
    while (used_ < groups && quarter_loosest()) {
    }
    for (const part& p : leaves_)
        for (std::size_t n = 0; n < bend_numbers; ++n)
            most_[n][p.block] = std::max(most_[n][p.block],
                                         of_block(bounds_[p.group].most[n][p.lane], n, p.halvings));
}

void bends_of_blocks::add(std::size_t group, std::size_t lane, std::size_t block, int halvings) {
    leaves_.push_back({group, lane, block, halvings, 0});
    const group_bounds& of = bounds_[group];
    if (!std::isfinite(of.most[turn_u][lane]))
        return;
    for (std::size_t n = 0; n < bend_numbers; ++n)
        least_[n][block] = std::max(least_[n][block], of_block(of.middle[n][lane], n, halvings));
}

/// Finds, for each number in each block, up to which bound no quartering is needed. by_good_ gets
/// the reciprocal of that bound.
void bends_of_blocks::judge() {
    for (const auto& kind : kinds)
        for (std::size_t block = 0; block < blocks; ++block) {
            double matters = kind.first < turn_u ? no_bend * size_ : no_turn;
            for (std::size_t n = kind.first; n < kind.end; ++n)
                matters = std::max(matters, least_[n][block] * of_its_kind);
            for (std::size_t n = kind.first; n < kind.end; ++n)
                by_good_[n][block] = 1 / (std::max(least_[n][block], matters) * kind.good_enough);
        }
}

/// The factor by which the worst bound of a part exceeds a good bound. It is 0 for a part that is
/// not quartered any more. It is HUGE_VAL for a part without bounds, if another part of its block
/// has bounds.
double bends_of_blocks::looseness(const part& p) const {
    if (p.halvings == most_halvings)
        return 0;
    if (!std::isfinite(bounds_[p.group].most[turn_u][p.lane])) {
        const bool hope = least_[turn_u][p.block] + least_[turn_v][p.block] > 0;
        return hope && p.halvings < most_halvings_of_unknown ? HUGE_VAL : 0;
    }
    double worst = 0;
    for (const auto& kind : kinds)
        for (std::size_t n = kind.first; n < kind.end; ++n)
            worst = std::max(worst, of_block(bounds_[p.group].most[n][p.lane], n, p.halvings) *
                                        by_good_[n][p.block]);
    return worst;
}

/// Quarters the two loosest parts; their eight quarters become a group. Returns false if all parts
/// are good enough.
bool bends_of_blocks::quarter_loosest() {
    constexpr std::size_t quarters = 4;
    std::array<part, part_lanes / quarters> parents;
    std::size_t found = 0;
    for (part& parent : parents) {
        const auto loosest =
            std::max_element(leaves_.begin(), leaves_.end(), [](const part& a, const part& b) {
                return a.looseness < b.looseness;
            });
        parent = *loosest;
        if (!(parent.looseness > 1))
            break;
        ++found;
        *loosest = leaves_.back();
        leaves_.pop_back();
    }
    if (found == 0)
        return false;
    part_group& quartered = parts_[used_];
    for (std::size_t lane = 0; lane < part_lanes; ++lane) {
        const part& parent = parents[std::min(lane / quarters, found - 1)];
        copy_lane(parts_[parent.group], parent.lane, quartered, lane);
    }
    quarter_parts(quartered);
    bound_parts(quartered, size_, bounds_[used_]);
    for (std::size_t lane = 0; lane < found * quarters; ++lane) {
        const part& parent = parents[lane / quarters];
        add(used_, lane, parent.block, parent.halvings + 1);
    }
    for (std::size_t lane = 0; lane < found * quarters; ++lane) {
        part& p = leaves_[leaves_.size() - 1 - lane];
        p.looseness = looseness(p);
    }
    ++used_;
    return true;
}

} // namespace l3d_detail
