// SPDX-License-Identifier: MIT
// cycle_cutter: cuts triangles where they meet, then divides them by planes.
#include "pipeline/zsort/cycle_cutter_p.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <numeric>
#include <utility>

namespace l3d_detail {

cycle_cutter::fragment cycle_cutter::whole(std::uint32_t triangle) const {
    const auto& v = triangles_[triangle].v;
    fragment result{
        {triangle, l3d_painter_cut::last}, l3d_picture_plane(v), region_of(v), 0, 0, 0, 0};
    set_box(result);
    return result;
}

void cycle_cutter::set_box(fragment& of) {
    const auto [left, right] = std::ranges::minmax(of.region, {}, &picture_point::x);
    const auto [top, bottom] = std::ranges::minmax(of.region, {}, &picture_point::y);
    of.left = left.x;
    of.right = right.x;
    of.top = top.y;
    of.bottom = bottom.y;
}

double cycle_cutter::tie(const fragment& a, const fragment& b) const {
    return tie_of(triangles_[a.piece.triangle].v, triangles_[b.piece.triangle].v);
}

front_parts cycle_cutter::front(const fragment& a, const fragment& b) {
    if (same(a, b) || !insides_meet(triangles_[a.piece.triangle].v, triangles_[b.piece.triangle].v))
        return {};
    intersect(a.region, b.region, common_, scratch_);
    return front_over(common_, a.plane, b.plane, tie(a, b));
}

/// Calls visit(a, b), with a < b, for each pair of fragments whose boxes meet. It finds the pairs
/// by a sweep from left to right.
template <class Visit> void cycle_cutter::visit_pairs(const fragments& set, const Visit& visit) {
    std::vector<std::uint32_t> by_left(set.size()), open;
    std::iota(by_left.begin(), by_left.end(), 0u);
    std::ranges::stable_sort(by_left, {}, [&](std::uint32_t i) { return set[i].left; });
    for (const std::uint32_t i : by_left) {
        workers_->ask();
        std::erase_if(open, [&](std::uint32_t j) { return set[j].right < set[i].left; });
        for (const std::uint32_t j : open)
            if (set[j].top <= set[i].bottom && set[i].top <= set[j].bottom)
                visit(std::min(i, j), std::max(i, j));
        open.push_back(i);
    }
}

cycle_cutter::fragment cycle_cutter::cut_side(const fragment& of, const fragment& by,
                                              bool in_front) {
    fragment result{
        {of.piece.triangle, static_cast<std::uint32_t>(cuts_->size())}, of.plane, {}, 0, 0, 0, 0};
    cuts_->push_back({by.piece.triangle, in_front, of.piece.cut});
    keep_side(of.region, of.plane, by.plane, in_front, result.region);
    if (result.region.empty()) // rounding may leave nothing, though a pixel's centre is there
        result.region = of.region;
    set_box(result);
    return result;
}

/// Cuts fragments that go through each other, only where they meet. If too many pairs go through
/// each other, it does nothing and returns false. In this case, cuts would make more pieces than
/// dividing the set.
bool cycle_cutter::cut_where_they_meet(fragments& set) {
    std::vector<std::vector<std::uint32_t>> cutters(set.size());
    std::size_t crossings = 0;
    visit_pairs(set, [&](std::uint32_t a, std::uint32_t b) {
        if (!front(set[a], set[b]).mixed())
            return;
        ++crossings;
        const bool cut_first = cutters[a].size() <= cutters[b].size();
        cutters[cut_first ? a : b].push_back(cut_first ? b : a);
    });
    constexpr std::size_t most_cuts_each = 3;
    if (crossings > most_cuts_each * set.size())
        return false;
    fragments result;
    for (std::size_t i = 0; i < set.size(); ++i) {
        fragments parts{set[i]};
        for (const std::uint32_t by : cutters[i]) {
            const std::size_t count = parts.size();
            for (std::size_t p = 0; p < count; ++p) {
                if (!front(parts[p], set[by]).mixed())
                    continue;
                parts.push_back(cut_side(parts[p], set[by], true));
                parts[p] = cut_side(parts[p], set[by], false);
            }
        }
        std::ranges::move(parts, std::back_inserter(result));
    }
    set = std::move(result);
    return true;
}

/// Adds the strongly connected components of a set to the list of tasks. The component in front of
/// all other components comes last.
void cycle_cutter::arrange(fragments&& set) {
    std::vector<std::vector<order_node>> needs(set.size());
    std::vector<l3d_sort_item> nodes;
    for (std::uint32_t i = 0; i < set.size(); ++i)
        nodes.push_back({0, i});
    visit_pairs(set, [&](std::uint32_t a, std::uint32_t b) {
        const front_parts parts = front(set[a], set[b]);
        if (parts.first)
            needs[a].push_back(order_node_of(0, b));
        if (parts.second)
            needs[b].push_back(order_node_of(0, a));
    });
    components_.walk(
        nodes, set.size(), [&](order_node node) { return needs[number_of(node)].empty(); },
        [&](order_node node, bool, std::vector<order_node>& out) {
            const std::vector<order_node>& of = needs[number_of(node)];
            out.insert(out.end(), of.begin(), of.end());
        },
        [&](std::span<const order_node> component) {
            task& next = tasks_.emplace_back();
            next.cyclic = component.size() > 1;
            for (const order_node node : component)
                next.set.push_back(std::move(set[number_of(node)]));
        });
}

/// Chooses the member whose plane divides a set best. Among some eight members, it takes the one
/// whose plane cuts the fewest members and divides the set most equally. Returns the member's
/// index.
std::size_t cycle_cutter::best_splitter(const fragments& set) const {
    constexpr std::size_t tried = 8;
    constexpr long price_of_cut = 4; // a cut costs as much as halves that differ by so many members
    std::size_t best = 0;
    long least = -1;
    const std::size_t step = std::max<std::size_t>(set.size() / tried, 1);
    for (std::size_t s = 0; s < set.size(); s += step) {
        workers_->ask();
        long cut = 0, front_more = 0;
        for (const fragment& f : set) {
            const front_parts parts = front_over(f.region, f.plane, set[s].plane, tie(f, set[s]));
            cut += parts.mixed();
            front_more += parts.first - parts.second;
        }
        const long price = price_of_cut * cut + std::abs(front_more);
        if (least < 0 || price < least) {
            least = price;
            best = s;
        }
    }
    return best;
}

void cycle_cutter::divide(fragments&& set) {
    const std::size_t at = best_splitter(set);
    const fragment splitter = std::move(set[at]);
    set.erase(set.begin() + static_cast<std::ptrdiff_t>(at));
    fragments behind, in_front;
    for (fragment& f : set) {
        const front_parts parts =
            same(f, splitter) ? front_parts{}
                              : front_over(f.region, f.plane, splitter.plane, tie(f, splitter));
        if (parts.mixed()) {
            behind.push_back(cut_side(f, splitter, false));
            in_front.push_back(cut_side(f, splitter, true));
        } else {
            (parts.first ? in_front : behind).push_back(std::move(f));
        }
    }
    tasks_.push_back({std::move(behind), false});
    tasks_.push_back({{splitter}, false});
    tasks_.push_back({std::move(in_front), false});
}

void cycle_cutter::leave_out_hidden(fragments& set) {
    if (covers_)
        std::erase_if(set, [this](const fragment& f) { return cover_.hides(f.piece); });
}

void cycle_cutter::emit(const fragment& f) {
    pieces_->push_back(f.piece);
    if (covers_)
        cover_.add(f.piece);
}

void cycle_cutter::untie(l3d_workers& workers, l3d_size size,
                         std::span<const l3d_painter_triangle> triangles,
                         std::span<const std::uint32_t> members,
                         std::vector<l3d_painter_piece>& pieces,
                         std::vector<l3d_painter_cut>& cuts) {
    workers_ = &workers;
    tasks_.clear(); // an interrupted call may leave some
    triangles_ = triangles;
    pieces_ = &pieces;
    cuts_ = &cuts;
    const auto first_piece = static_cast<std::ptrdiff_t>(pieces.size());
    covers_ = members.size() > most_without_search_;
    if (covers_)
        cover_.begin(size, triangles, cuts);
    fragments set;
    for (const std::uint32_t member : members)
        set.push_back(whole(member));
    if (cut_where_they_meet(set))
        arrange(std::move(set));
    else
        tasks_.push_back({std::move(set), true});
    while (!tasks_.empty()) {
        workers.ask();
        task next = std::move(tasks_.back());
        tasks_.pop_back();
        leave_out_hidden(next.set);
        if (next.set.empty())
            continue;
        if (next.set.size() == 1)
            emit(next.set.front());
        // In a larger set, pairs are not compared again after each division: halving is quicker
        // than finding out whether an order exists.
        else if (next.cyclic || next.set.size() > few)
            divide(std::move(next.set));
        else
            arrange(std::move(next.set));
    }
    std::reverse(pieces.begin() + first_piece, pieces.end());
}

} // namespace l3d_detail
