// SPDX-License-Identifier: MIT
// directed_sets: disjoint sets of lines that have directions, such as borders that are cut alike.
#ifndef L3D_BASE_DIRECTED_SETS_P_H
#define L3D_BASE_DIRECTED_SETS_P_H

#include <cstddef>
#include <utility>
#include <vector>

namespace l3d_detail {

/// Disjoint sets of lines, such as borders that are cut alike. Lines are numbered from 0. Each line
/// runs in its set's direction or backwards. A set's representative is one of its lines, and has
/// the set's direction.
class directed_sets {
public:
    /// A line, and whether it is taken in reverse.
    struct place {
        std::size_t line;
        bool is_backwards;
    };

    directed_sets() = default;
    explicit directed_sets(std::size_t count) {
        for (std::size_t i = 0; i < count; ++i)
            add();
    }

    std::size_t count() const { return lines_.size(); }

    /// Forgets all lines. Cost: keeps the memory.
    void clear() { lines_.clear(); }
    /// Adds a line, in a set of its own.
    void add() { lines_.push_back({{lines_.size(), false}}); }

    /// The representative of a line's set, and whether the line runs against the representative.
    /// Cost: logarithmic, as the smaller set always joins the larger one.
    place find(std::size_t line) const {
        place result{line, false};
        while (lines_[result.line].above.line != result.line) {
            const place& above = lines_[result.line].above;
            result = {above.line, result.is_backwards != above.is_backwards};
        }
        return result;
    }

    /// Unites the sets of two lines, so that the two lines run the same way. A line whose
    /// `is_backwards` is set is reversed first.
    void join(const place& a, const place& b) {
        place root = find(a.line), other = find(b.line);
        const bool turns =
            (a.is_backwards != root.is_backwards) != (b.is_backwards != other.is_backwards);
        if (lines_[root.line].size < lines_[other.line].size)
            std::swap(root, other);
        member &larger = lines_[root.line], &smaller = lines_[other.line];
        if (root.line == other.line) {
            larger.runs_both_ways = larger.runs_both_ways || turns;
            return;
        }
        larger.size += smaller.size;
        larger.runs_both_ways = larger.runs_both_ways || smaller.runs_both_ways;
        smaller.above = {root.line, turns};
    }

    /// Whether some line of a set was joined to itself in reverse, as on a Moebius band.
    /// Expects: `line` is the set's representative.
    bool runs_both_ways(std::size_t line) const { return lines_[line].runs_both_ways; }

private:
    struct member {
        place above; ///< the next line on the way to the representative, which has itself here
        std::size_t size = 1;
        /// Whether a line of the set was joined to itself in reverse. Only representatives keep
        /// this member and `size` up to date.
        bool runs_both_ways = false;
    };

    std::vector<member> lines_;
};

} // namespace l3d_detail

#endif
