// SPDX-License-Identifier: MIT
// ordered_components: an order in which everything comes after what it needs, and its cycles.
#ifndef L3D_PIPELINE_POLYGONS_PAINTER_COMPONENTS_P_H
#define L3D_PIPELINE_POLYGONS_PAINTER_COMPONENTS_P_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Strong components of a graph that is found while it is walked.
///
/// Cost:    linear in nodes and edges; depth costs no stack of the processor. Keeps its memory.
/// Source:  Tarjan: Depth-first search and linear graph algorithms (SIAM J. Computing 1, 1972).
class ordered_components {
public:
    /// Calls emit(component) for each strongly connected component of nodes [0, count), after those
    /// that its nodes need. Where there is a choice, the order is that of the least node.
    ///
    /// `needed(node, in_turn, out)` adds to `out` what a node needs before it. Members that are
    /// emitted already may be left out. If it is the node's turn, all lesser ones are emitted.
    /// Nodes of a component are in rising order.
    template <class Needed, class Emit>
    void walk(std::uint32_t count, const Needed& needed, const Emit& emit) {
        marks_.assign(count, mark{});
        next_ = 0;
        for (std::uint32_t root = 0; root < count; ++root) {
            if (marks_[root].index != unseen)
                continue;
            enter(root, true, needed);
            if (edges_.empty()) { // most need nothing: each is a component by itself
                leave_alone(root, emit);
                continue;
            }
            while (!calls_.empty())
                advance(needed, emit);
        }
    }

    bool emitted(std::uint32_t node) const { return marks_[node].index == finished; }

private:
    static constexpr std::uint32_t unseen = 0xffffffff, finished = 0xfffffffe;

    struct mark {
        std::uint32_t index = unseen; ///< when it was first seen
        std::uint32_t low = 0;        ///< the earliest that can be reached from it
    };

    struct call {
        std::uint32_t node;
        std::size_t first_edge, next_edge;
    };

    template <class Needed> void enter(std::uint32_t node, bool in_turn, const Needed& needed) {
        marks_[node] = {next_, next_};
        ++next_;
        open_.push_back(node);
        calls_.push_back({node, edges_.size(), edges_.size()});
        needed(node, in_turn, edges_);
    }

    /// The end of a root that needs nothing.
    template <class Emit> void leave_alone(std::uint32_t root, const Emit& emit) {
        calls_.pop_back();
        open_.pop_back();
        marks_[root].index = finished;
        emit(std::span<const std::uint32_t>(&root, 1));
    }

    /// One step of the walk: the next edge of the node at hand, or its end.
    template <class Needed, class Emit> void advance(const Needed& needed, const Emit& emit) {
        call& at = calls_.back();
        if (at.next_edge < edges_.size()) {
            const std::uint32_t to = edges_[at.next_edge++];
            if (marks_[to].index == unseen)
                enter(to, false, needed);
            else if (marks_[to].index != finished)
                marks_[at.node].low = std::min(marks_[at.node].low, marks_[to].index);
            return;
        }
        const std::uint32_t node = at.node;
        edges_.resize(at.first_edge);
        calls_.pop_back();
        if (!calls_.empty())
            marks_[calls_.back().node].low =
                std::min(marks_[calls_.back().node].low, marks_[node].low);
        if (marks_[node].low == marks_[node].index)
            close(node, emit);
    }

    template <class Emit> void close(std::uint32_t node, const Emit& emit) {
        std::size_t first = open_.size();
        do {
            --first;
            marks_[open_[first]].index = finished;
        } while (open_[first] != node);
        const std::span<std::uint32_t> component(open_.data() + first, open_.size() - first);
        std::ranges::sort(component);
        emit(std::span<const std::uint32_t>(component));
        open_.resize(first);
    }

    std::vector<mark> marks_;
    std::vector<call> calls_;
    std::vector<std::uint32_t> edges_; ///< of all nodes in calls_, the last one's at the end
    std::vector<std::uint32_t> open_;  ///< seen, not yet in a component
    std::uint32_t next_ = 0;
};

} // namespace l3d_detail

#endif
