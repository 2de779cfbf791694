// SPDX-License-Identifier: MIT
// ordered_components: puts nodes into an order after those they need, and finds cycles.
#ifndef L3D_PIPELINE_ZSORT_PAINTER_COMPONENTS_P_H
#define L3D_PIPELINE_ZSORT_PAINTER_COMPONENTS_P_H

#include "geom/radix_sort.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// A thing that is put into an order, such as a triangle: its sort key in the upper 32 bits, its
/// number in the lower 32 bits.
///
/// Sorted nodes stand in the order of these integers. So two nodes can be compared without a table
/// of their places in the sorted list.
using order_node = std::uint64_t;

constexpr order_node order_node_of(std::uint32_t key, std::uint32_t number) {
    return std::uint64_t{key} << 32 | number;
}
constexpr std::uint32_t number_of(order_node node) {
    return static_cast<std::uint32_t>(node);
}

/// Puts nodes into an order in which each node comes after the nodes that it needs. Nodes that need
/// each other in a cycle form one strongly connected component. The graph's edges are computed
/// while it is walked.
///
/// Cost:   linear in nodes and edges; deep graphs take no stack. A node without edges costs a bit
///         and a call. Memory is kept for the next walk.
/// Source: Tarjan: Depth-first search and linear graph algorithms (SIAM J. Computing 1, 1972).
class ordered_components {
public:
    /// Calls emit(component) for each strongly connected component of nodes, after the components
    /// that its nodes need. If several components could be next, the component with the least node
    /// comes first.
    ///
    /// `is_free(node)` tells whether a node needs no greater node. `needed(node, in_turn, out)`
    /// adds to `out` the nodes that must come before `node`; it may leave out nodes that were
    /// emitted. If `in_turn` is true, all lesser nodes were emitted. The nodes of a component are
    /// in rising order.
    /// Expects: nodes are sorted by rising keys, then numbers. All numbers are less than `numbers`.
    template <class Free, class Needed, class Emit>
    void walk(std::span<const l3d_sort_item> nodes, std::size_t numbers, const Free& is_free,
              const Needed& needed, const Emit& emit) {
        marks_.resize(std::max(marks_.size(), numbers));
        is_seen_.assign(numbers, false);
        next_ = 0;
        for (const l3d_sort_item& next : nodes) {
            if (is_seen_[next.index])
                continue;
            turn_ = order_node_of(next.key, next.index);
            if (is_free(turn_)) { // most are: each makes a component
                emit(std::span<const order_node>(&turn_, 1));
                continue;
            }
            enter(turn_, true, needed);
            while (!calls_.empty())
                advance(needed, emit);
        }
    }

    bool emitted(order_node node) const {
        return node < turn_ || (is_seen(node) && mark_of(node).index == finished);
    }

private:
    static constexpr std::uint32_t finished = 0xffffffff;

    struct mark {
        std::uint32_t index; ///< number of nodes that were seen before this one
        std::uint32_t low;   ///< least index of the open nodes that this node is known to reach
    };

    struct call {
        order_node node;
        std::size_t first_edge, next_edge;
    };

    bool is_seen(order_node node) const { return is_seen_[number_of(node)]; }
    mark& mark_of(order_node node) { return marks_[number_of(node)]; }
    const mark& mark_of(order_node node) const { return marks_[number_of(node)]; }

    template <class Needed> void enter(order_node node, bool in_turn, const Needed& needed) {
        is_seen_[number_of(node)] = true;
        mark_of(node) = {next_, next_};
        ++next_;
        open_.push_back(node);
        calls_.push_back({node, edges_.size(), edges_.size()});
        needed(node, in_turn, edges_);
    }

    /// Makes one step of the walk: takes the next edge of the current node, or ends the node.
    template <class Needed, class Emit> void advance(const Needed& needed, const Emit& emit) {
        call& at = calls_.back();
        if (at.next_edge < edges_.size()) {
            const order_node to = edges_[at.next_edge++];
            if (emitted(to))
                return;
            if (!is_seen(to))
                enter(to, false, needed);
            else
                mark_of(at.node).low = std::min(mark_of(at.node).low, mark_of(to).index);
            return;
        }
        const order_node node = at.node;
        edges_.resize(at.first_edge);
        calls_.pop_back();
        if (!calls_.empty())
            mark_of(calls_.back().node).low =
                std::min(mark_of(calls_.back().node).low, mark_of(node).low);
        if (mark_of(node).low == mark_of(node).index)
            close(node, emit);
    }

    template <class Emit> void close(order_node node, const Emit& emit) {
        std::size_t first = open_.size();
        do {
            --first;
            mark_of(open_[first]).index = finished;
        } while (open_[first] != node);
        const std::span<order_node> component(open_.data() + first, open_.size() - first);
        std::ranges::sort(component);
        emit(std::span<const order_node>(component));
        open_.resize(first);
    }

    std::vector<mark> marks_; ///< marks of the nodes that were seen, by number
    std::vector<bool> is_seen_;
    std::vector<call> calls_;
    /// Edges of all nodes in calls_. The edges of the last node stand at the end.
    std::vector<order_node> edges_;
    std::vector<order_node> open_; ///< nodes that were seen and are not in a component yet
    order_node turn_ = 0; ///< the node from which the walk goes on; all lesser nodes were emitted
    std::uint32_t next_ = 0;
};

} // namespace l3d_detail

#endif
