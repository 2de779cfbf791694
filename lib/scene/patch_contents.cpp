// SPDX-License-Identifier: MIT
// The data of l3d_patch_model: found once for each patch, and for each level when it is asked for.
#include "scene/patch_contents_p.h"

#include "scene/closed_body.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace {

using vector = l3d_patch_model::vector;

l3d_slanted_box upright_box(const vector& least, const vector& most) {
    l3d_slanted_box box;
    box.centre = (least + most) * 0.5;
    for (int k = 0; k < 3; ++k)
        box.axes[static_cast<std::size_t>(k)][k] = (most[k] - least[k]) * 0.5;
    return box;
}

/// The largest coordinates of points from, from + step, and so on: four of them, or all sixteen.
vector largest_of(const l3d_patch_model::patch& p, std::size_t from, std::size_t step,
                  std::size_t count) {
    vector result{0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < count; ++i)
        for (int k = 0; k < 3; ++k)
            result[k] = std::max(result[k], std::abs(p.points[from + i * step][k]));
    return result;
}

l3d_patch_reach reach_of(const l3d_patch_model::patch& p) {
    return {largest_of(p, 0, 1, 16),
            {largest_of(p, 0, 1, 4), largest_of(p, 12, 1, 4), largest_of(p, 0, 4, 4),
             largest_of(p, 3, 4, 4)}};
}

} // namespace

l3d_patch_model::contents::contents(std::vector<patch> of, const contents* like)
    : patches(std::move(of)) {
    normals.reserve(patches.size());
    for (const patch& p : patches) {
        const std::size_t i = normals.size();
        if (like != nullptr && i < like->patches.size() && like->patches[i].points == p.points) {
            normals.push_back(like->normals[i]);
            facing.push_back(like->facing[i]);
            bends.push_back(like->bends[i]);
        } else {
            normals.emplace_back(p);
            facing.emplace_back(p, normals.back());
            bends.push_back(std::make_shared<bends_on_demand>());
        }
        reaches.push_back(reach_of(p));
        const auto [lowest, highest] = p.bounds();
        boxes.add(upright_box(lowest, highest));
        if (normals.size() == 1) {
            least = lowest;
            most = highest;
        }
        for (int k = 0; k < 3; ++k) {
            least[k] = std::min(least[k], lowest[k]);
            most[k] = std::max(most[k], highest[k]);
        }
    }
    orientation = l3d_orientation_of(patches, facing);
}

const l3d_curved_pieces::cuts& l3d_patch_model::source::cuts_at(int places, int normals) const {
    const auto kept = cuts_.find({places, normals});
    if (kept != cuts_.end())
        return kept->second;
    const l3d_curved_pieces::cuts none;
    const l3d_curved_pieces::cuts& from = places > 0    ? cuts_at(places - 1, normals)
                                          : normals > 0 ? cuts_at(0, normals - 1)
                                                        : none;
    return cuts_[{places, normals}] = pieces.cuts_at(places, normals, from);
}

std::shared_ptr<const l3d_patch_model::contents>
l3d_patch_model::source::at_level(int places, int normals) const {
    const std::scoped_lock lock(mutex_);
    std::shared_ptr<const contents>& kept = levels_[{places, normals}];
    if (!kept) {
        const l3d_curved_pieces::cuts& by = cuts_at(places, normals);
        std::vector<int> cut_like = by.of_lines;
        if (pieces.has_trims()) // whose polygons differ at each level
            cut_like.push_back(places);
        std::shared_ptr<const contents>& same = made_[cut_like];
        if (same)
            return kept = same;
        l3d_curved_pieces::cells cells = pieces.cut(by);
        const auto like = like_.find({places, normals});
        const auto made = std::make_shared<contents>(
            std::move(cells.patches), like == like_.end() ? nullptr : like->second.get());
        made->pieces = std::move(cells.pieces);
        made->ranges = std::move(cells.ranges);
        made->trims = std::move(cells.trims);
        if (!made->trims.empty())
            made->orientation = 0; // an eye may look through holes
        made->surface_error = cells.error;
        made->normal_error = cells.normal_error;
        kept = same = made;
    }
    return kept;
}
