// SPDX-License-Identifier: MIT
// l3d_walk_cells: paths of cells from one cell to another.
#ifndef L3D_COMPARE_CELLS_CELL_PATH_H
#define L3D_COMPARE_CELLS_CELL_PATH_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

/// The way in which two neighbouring cells of a path touch. Its value is the number of axes along
/// which one step may go at once.
enum class l3d_cell_touch {
    face = 1,   ///< 6 neighbours; most of the change is along one axis
    edge = 2,   ///< 18 neighbours; two axes
    corner = 3, ///< 26 neighbours; three axes
};

/// The order in which a path takes its steps.
enum class l3d_cell_order {
    /// Every cell is as near to the straight line as steps across such touches allow.
    near_line,
    diagonal_first, ///< diagonal steps until the rest of the way is along fewer axes
};

using l3d_cell = std::array<int, 3>;

namespace l3d_detail {

/// Walks from one cell to another. It tells how far the end still is along each axis, and along
/// which axis the straight line asks for the next step.
class cell_walk {
public:
    cell_walk(const l3d_cell& from, const l3d_cell& to) : cell_(from) {
        for (std::size_t i = 0; i < 3; ++i) {
            ways_[i] = std::abs(to[i] - from[i]);
            signs_[i] = to[i] < from[i] ? -1 : 1;
        }
    }

    const l3d_cell& cell() const { return cell_; }

    int left() const { return ways_[0] + ways_[1] + ways_[2] - done_[0] - done_[1] - done_[2]; }
    int left(std::size_t i) const { return ways_[i] - done_[i]; }
    bool has(std::size_t i) const { return left(i) > 0; }

    void step(std::size_t i) {
        cell_[i] += signs_[i];
        ++done_[i];
    }

    /// Whether the line leaves the cell along axis a before axis b. From centre to centre, step
    /// number k of n is at (2 k + 1) / (2 n) of the line.
    bool is_sooner(std::size_t a, std::size_t b) const {
        return !has(b) || (has(a) && (2 * std::int64_t{done_[a]} + 1) * ways_[b] <
                                         (2 * std::int64_t{done_[b]} + 1) * ways_[a]);
    }

    /// The axis along which the line leaves the cell first; among equals the first axis.
    std::size_t soonest() const {
        const std::size_t i = is_sooner(1, 0) ? 1 : 0;
        return is_sooner(2, i) ? 2 : i;
    }

    /// The axis along which the end is farthest.
    std::size_t longest() const {
        return static_cast<std::size_t>(std::max_element(ways_.begin(), ways_.end()) -
                                        ways_.begin());
    }

    /// Whether axis i lags behind the line after `steps` steps along the longest axis. Then the
    /// line is nearer to the next cell along i than to this one.
    bool is_due(std::size_t i, int steps) const {
        const std::int64_t longest_way = ways_[longest()];
        return has(i) &&
               2 * std::int64_t{steps} * ways_[i] > (2 * std::int64_t{done_[i]} + 1) * longest_way;
    }

private:
    l3d_cell cell_, ways_, signs_, done_{};
};

} // namespace l3d_detail

/// Visits the cells of a path from `from` to `to`, both included, until visit(cell) is false.
/// Returns the number of steps.
///
/// Let a >= b >= c be the distances along the axes, in cells. A path across faces has a + b + c
/// steps; near the line, it meets every cell that the line pierces. A path across corners has a
/// steps. A path across edges has a steps, and one more for each step that would go along three
/// axes.
///
/// With diagonal_first, each step goes along the axes with the longest distances left, whatever the
/// line. Across corners there are a steps: c along three axes, b - c along two, a - b along one.
/// Across edges their number is the larger of a and half the sum of the distances. The path (2, 1)
/// then takes 2 steps, where a path across faces takes 3. Such a path bends away from the line, so
/// it serves short distances only.
/// Source: Kaufman, Shimony, 3D Scan-Conversion Algorithms for Voxel-Based Graphics, Workshop on
/// Interactive 3D Graphics 1986, for the three kinds of touch.
template <class Visit>
int l3d_walk_cells(const l3d_cell& from, const l3d_cell& to, l3d_cell_touch touch,
                   l3d_cell_order order, const Visit& visit) {
    l3d_detail::cell_walk walk(from, to);
    const auto most = static_cast<std::size_t>(touch);
    int steps = 0;
    const auto arrive = [&] {
        ++steps;
        return visit(walk.cell());
    };
    if (!visit(walk.cell()))
        return steps;
    if (order == l3d_cell_order::diagonal_first || touch == l3d_cell_touch::face) {
        while (walk.left() > 0) {
            if (order == l3d_cell_order::diagonal_first) {
                std::array<std::size_t, 3> axes{0, 1, 2};
                std::sort(axes.begin(), axes.end(), [&](std::size_t a, std::size_t b) {
                    return walk.left(a) != walk.left(b) ? walk.left(a) > walk.left(b) : a < b;
                });
                for (std::size_t k = 0; k < most && walk.left(axes[k]) > 0; ++k)
                    walk.step(axes[k]);
            } else
                walk.step(walk.soonest());
            if (!arrive())
                break;
        }
        return steps;
    }
    const std::size_t first = walk.longest();
    for (int along = 1; walk.left() > 0; ++along) {
        walk.step(first);
        std::size_t axes = 1;
        for (std::size_t i = 0; i < 3; ++i) {
            if (i == first || !walk.is_due(i, along))
                continue;
            if (axes == most) {
                if (!arrive())
                    return steps;
                axes = 0;
            }
            walk.step(i);
            ++axes;
        }
        if (!arrive())
            return steps;
    }
    return steps;
}

#endif
