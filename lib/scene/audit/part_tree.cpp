// SPDX-License-Identifier: MIT
// part_tree: searches best-first by branch and bound.
#include "scene/audit/part_tree_p.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace l3d_detail {
namespace {

constexpr std::uint32_t most_in_leaf = 4;

} // namespace

double farthest(const flat_triangle& flat, std::span<const part_tree::vector> places) {
    double square = 0;
    for (const auto& p : places)
        square = std::max(square, flat.square_distance(p));
    return std::sqrt(square);
}

audit_box audit_box::of(const audit_part& part) {
    const auto& [a, b, c] = part.flat.corners();
    audit_box result{a, a};
    for (int i = 0; i < 3; ++i) {
        result.least[i] = std::min({a[i], b[i], c[i]}) - part.off;
        result.most[i] = std::max({a[i], b[i], c[i]}) + part.off;
    }
    return result;
}

audit_box audit_box::grown(double by) const {
    const vector all(by, by, by);
    return {least - all, most + all};
}

bool audit_box::meets(const audit_box& other) const {
    bool result = true;
    for (int i = 0; i < 3; ++i)
        result = result && least[i] <= other.most[i] && most[i] >= other.least[i];
    return result;
}

void audit_box::hold(const audit_box& other) {
    for (int i = 0; i < 3; ++i) {
        least[i] = std::min(least[i], other.least[i]);
        most[i] = std::max(most[i], other.most[i]);
    }
}

double audit_box::distance(std::span<const vector> places) const {
    double square = 0;
    for (const vector& p : places) {
        double here = 0;
        for (int i = 0; i < 3; ++i) {
            const double d = std::max({least[i] - p[i], p[i] - most[i], 0.0});
            here += d * d;
        }
        square = std::max(square, here);
    }
    return std::sqrt(square);
}

part_tree::part_tree(std::vector<audit_part> parts) : parts_(std::move(parts)) {
    nodes_.reserve(parts_.size());
    nodes_.emplace_back();
    build(0, 0, static_cast<std::uint32_t>(parts_.size()));
}

void part_tree::build(std::uint32_t at, std::uint32_t first, std::uint32_t end) {
    const auto from = parts_.begin() + first, to = parts_.begin() + end;
    node here{audit_box::of(*from)};
    for (auto p = from; p != to; ++p)
        here.box.hold(audit_box::of(*p));
    if (end - first <= most_in_leaf) {
        here.first = first;
        here.end = end;
        nodes_[at] = here;
        return;
    }
    const vector size = here.box.most - here.box.least;
    const int axis = size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
    const auto middle = [axis](const audit_part& p) {
        const auto& c = p.flat.corners();
        return c[0][axis] + c[1][axis] + c[2][axis];
    };
    const std::uint32_t half = first + (end - first) / 2;
    std::nth_element(from, parts_.begin() + half, to,
                     [&](const auto& a, const auto& b) { return middle(a) < middle(b); });
    here.first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[at] = here;
    nodes_.resize(nodes_.size() + 2);
    build(here.first, first, half);
    build(here.first + 1, half, end);
}

bool part_tree::find_near(const audit_part& other, double distance, std::size_t most,
                          std::vector<std::uint32_t>& to) const {
    const audit_box around = audit_box::of(other).grown(distance);
    std::vector<std::uint32_t> todo{0};
    while (!todo.empty()) {
        const node& here = nodes_[todo.back()];
        todo.pop_back();
        if (!here.box.meets(around))
            continue;
        if (here.end == 0) {
            todo.insert(todo.end(), {here.first, here.first + 1});
            continue;
        }
        for (std::uint32_t i = here.first; i < here.end; ++i)
            if (audit_box::of(parts_[i]).meets(around)) {
                if (to.size() == most)
                    return false;
                to.push_back(i);
            }
    }
    return true;
}

part_tree::found part_tree::nearest(std::span<const vector> places, const wanted& until,
                                    memory& use) const {
    found result{.least = 0, .most = std::numeric_limits<double>::infinity(), .part = {}};
    use.heap.clear();
    use.parts.clear();
    const auto is_later = [](const memory::entry& a, const memory::entry& b) {
        return a.least > b.least;
    };
    const auto add = [&](double least, std::size_t index, bool is_node) {
        if (least > until.hopeless || least > result.most)
            return;
        use.heap.push_back({least, static_cast<std::uint32_t>(index), is_node});
        std::ranges::push_heap(use.heap, is_later);
    };
    const auto look = [&](const audit_part& part) {
        const double flat = farthest(part.flat, places);
        if (flat + part.off < result.most) {
            result.most = flat + part.off;
            result.part = part;
        }
        if (part.off > 0 && flat - part.off <= std::min(until.hopeless, result.most)) {
            use.parts.push_back(part);
            add(flat - part.off, use.parts.size() - 1, false);
        }
    };
    add(nodes_[0].box.distance(places), 0, true);
    for (std::size_t step = 0; !use.heap.empty(); ++step) {
        if (step == until.steps)
            return result;
        const memory::entry next = use.heap.front();
        if (result.most <= until.enough || next.least >= result.most - until.slack) {
            result.least = std::clamp(next.least, 0.0, result.most);
            return result;
        }
        std::ranges::pop_heap(use.heap, is_later);
        use.heap.pop_back();
        if (!next.is_node) {
            const audit_part& part = use.parts[next.index];
            const auto halves = part.cut(part.bent_side(), 0.5);
            look(halves[0]);
            look(halves[1]);
            continue;
        }
        const node& here = nodes_[next.index];
        if (here.end == 0) {
            add(nodes_[here.first].box.distance(places), here.first, true);
            add(nodes_[here.first + 1].box.distance(places), here.first + 1, true);
            continue;
        }
        for (std::uint32_t i = here.first; i < here.end; ++i)
            look(parts_[i]);
    }
    result.least = std::min(result.most, until.hopeless);
    return result;
}

} // namespace l3d_detail
