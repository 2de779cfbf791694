// SPDX-License-Identifier: MIT
// l3d_patch_model: finds edges that are farther off their faces than the file allows.
#include "base/formatted_p.h"
#include "geom/files/patch_file.h"
#include "scene/levels/patch_contents_p.h"
#include "scene/sides/shared_edges.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

std::vector<l3d_loose_edge> l3d_patch_model::loose_edges() const {
    constexpr double rounding = 0x1p-40; // relative to the largest coordinates
    const double least = rounding * std::max(l3d_length(pieces_least()), l3d_length(pieces_most()));
    const auto beyond = [&](const l3d_loose_edge& one) {
        return one.off - std::max(one.tolerance, least);
    };
    constexpr std::size_t tight = ~std::size_t{0};
    std::vector<std::size_t> places(edges().size(), tight); // in the result
    std::vector<l3d_loose_edge> result;
    for (std::size_t i = 0; i < edges().size(); ++i) {
        const l3d_shared_edge& edge = edges()[i];
        const l3d_loose_edge one{i, edge.off, edge.tolerance, edge.worst, {}};
        if (!(beyond(one) > 0))
            continue;
        places[i] = result.size();
        result.push_back(one);
    }
    for (std::size_t piece = 0; !result.empty() && piece < pieces(); ++piece)
        for (const l3d_trim_loop& loop : source_->pieces.pieces()[piece].trims)
            for (const l3d_trim_curve& curve : loop) {
                if (curve.edge >= places.size() || places[curve.edge] == tight)
                    continue;
                std::vector<std::size_t>& of = result[places[curve.edge]].pieces;
                if (of.empty() || of.back() != piece)
                    of.push_back(piece);
            }
    std::ranges::stable_sort(result, [&](const l3d_loose_edge& a, const l3d_loose_edge& b) {
        return beyond(a) > beyond(b);
    });
    return result;
}

std::string l3d_patch_model::edges_note() const {
    const std::vector<l3d_loose_edge> loose = loose_edges();
    if (loose.empty())
        return "";
    return l3d_detail::formatted("%zu of %zu edges are off their faces by more than the file "
                                 "allows: edge %zu by %.3g, not %.3g",
                                 loose.size(), edges().size(), loose[0].edge + 1, loose[0].off,
                                 loose[0].tolerance);
}
