// SPDX-License-Identifier: MIT
// The data of l3d_patch_model. It computes them once for each patch, and for each level on request.
#include "scene/levels/patch_contents_p.h"

#include "scene/culling/closed_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace {

using vector = l3d_patch_model::vector;

l3d_slanted_box upright_box(const vector& least, const vector& most) {
    l3d_slanted_box box;
    box.centre = (least + most) * 0.5;
    for (int k = 0; k < 3; ++k)
        box.axes[static_cast<std::size_t>(k)][k] = (most[k] - least[k]) * 0.5;
    return box;
}

/// The largest magnitudes of coordinates among `count` points: `from`, from + step, and so on.
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

/// Computes the data of all patches, or copies those that `like` has. A patch's box grows by the
/// error of the edges that the patch follows.
void l3d_patch_model::contents::learn(const contents* like,
                                      std::span<const std::size_t> places_in_like) {
    const bool has_normals = !normals.empty(); // normals of pieces, not of patches
    normals.reserve(patches.size());
    for (const patch& p : patches) {
        const std::size_t index = facing.size();
        const std::size_t i = places_in_like.empty() ? index : places_in_like[index];
        if (like != nullptr && i < like->patches.size() && like->patches[i].points == p.points &&
            (!has_normals ||
             like->normals[i].polynomial().points == normals[index].polynomial().points)) {
            if (!has_normals)
                normals.push_back(like->normals[i]);
            facing.push_back(like->facing[i]);
            bends.push_back(like->bends[i]);
        } else {
            if (!has_normals)
                normals.emplace_back(p);
            facing.emplace_back(p, has_normals ? l3d_normal_net(p) : normals.back());
            bends.push_back(std::make_shared<bends_on_demand>());
        }
        reaches.push_back(reach_of(p));
        auto [lowest, highest] = p.bounds();
        if (index < edges_off.size() && edges_off[index] > 0)
            for (int k = 0; k < 3; ++k) {
                lowest[k] -= edges_off[index];
                highest[k] += edges_off[index];
            }
        boxes.add(upright_box(lowest, highest));
        if (index == 0) {
            least = lowest;
            most = highest;
        }
        for (int k = 0; k < 3; ++k) {
            least[k] = std::min(least[k], lowest[k]);
            most[k] = std::max(most[k], highest[k]);
        }
    }
    halved = l3d_find_halved_sides(patches);
    for (const l3d_halved_side& side : halved) {
        constexpr std::array<unsigned, 4> edge_of_side{0, 3, 1, 2};
        halved_edges.resize(patches.size());
        unsigned char& edges = halved_edges[side.of.patch];
        edges = static_cast<unsigned char>(edges | 1U << edge_of_side[side.of.side]);
    }
    orientation = l3d_orientation_of(patches, facing, halved);
}

l3d_patch_model::contents::contents(std::vector<patch> of, const contents* like)
    : patches(std::move(of)) {
    learn(like, {});
}

l3d_patch_model::contents::contents(l3d_curved_pieces::cells of, const contents* like)
    : patches(std::move(of.patches)), normals(std::move(of.normals)), pieces(std::move(of.pieces)),
      ranges(std::move(of.ranges)), trims(std::move(of.trims)), edges_off(std::move(of.edges_off)) {
    constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> places_in_like;
    if (like != nullptr) {
        l3d_by_cell<std::size_t> places;
        for (std::size_t i = 0; i < like->patches.size(); ++i)
            places.emplace(l3d_cell_key(like->pieces[i], like->ranges[i]), i);
        for (std::size_t i = 0; i < patches.size(); ++i) {
            const auto place = places.find(l3d_cell_key(pieces[i], ranges[i]));
            places_in_like.push_back(place == places.end() ? nowhere : place->second);
        }
    }
    learn(like, places_in_like);
    if (!trims.empty())
        orientation = 0; // an eye may look through holes
    errors = std::move(of.errors);
    surface_error = errors.empty() ? 0 : std::ranges::max(errors);
    normal_error = of.normal_error;
    share = of.share;
}

const l3d_curved_pieces::cuts& l3d_patch_model::source::cuts_at(int places, int normals) const {
    const auto kept = cuts_.find({places, normals});
    if (kept != cuts_.end())
        return kept->second;
    const l3d_curved_pieces::cuts none;
    const l3d_curved_pieces::cuts& from = places > 0    ? cuts_at(places - 1, normals)
                                          : normals > 0 ? cuts_at(0, normals - 1)
                                                        : none;
    found_.forget_if_many();
    return cuts_[{places, normals}] = pieces.cuts_for(wish(places, normals), from, found_);
}

std::shared_ptr<const l3d_patch_model::contents>
l3d_patch_model::source::at_level(int places, int normals) const {
    const std::scoped_lock lock(mutex_);
    std::shared_ptr<const contents>& kept = levels_[{places, normals}];
    if (!kept) {
        const l3d_curved_pieces::cuts& by = cuts_at(places, normals);
        std::vector<std::vector<double>> cut_like = by.of_lines;
        if (pieces.has_trims()) // polygons differ at each level
            cut_like.push_back({static_cast<double>(places)});
        std::shared_ptr<const contents>& same = made_[cut_like];
        if (same)
            return kept = same;
        const auto like = like_.find({places, normals});
        kept = same =
            std::make_shared<const contents>(pieces.cut(by, wish(places, normals), found_),
                                             like == like_.end() ? nullptr : like->second.get());
    }
    return kept;
}

/// Makes the contents for a wish. The contents' orientation is 0, since a part of a closed body is
/// not closed. The contents' box also holds parts of the model outside of the wish's region.
std::shared_ptr<const l3d_patch_model::contents>
l3d_patch_model::source::seen(const l3d_cell_wish& wanted) const {
    const std::scoped_lock lock(mutex_);
    const auto same = std::ranges::find(seen_, wanted, [](const auto& of) { return of.first; });
    if (same != seen_.end()) {
        seen_.splice(seen_.begin(), seen_, same);
    } else {
        found_.forget_if_many();
        const l3d_curved_pieces::cuts by = pieces.cuts_for(wanted, {}, found_);
        const contents* like = seen_.empty() ? nullptr : seen_.front().second.get();
        if (like == nullptr && !levels_.empty()) // most cells of large models are those of level 0
            like = levels_.begin()->second.get();
        const auto made = std::make_shared<contents>(pieces.cut(by, wanted, found_), like);
        made->orientation = 0;
        for (int k = 0; k < 3; ++k) {
            made->least[k] = std::min(made->least[k], pieces.least()[k]);
            made->most[k] = std::max(made->most[k], pieces.most()[k]);
        }
        seen_.emplace_front(wanted, made->patches.empty() ? nullptr : made);
        if (seen_.size() > most_seen)
            seen_.pop_back();
    }
    return seen_.front().second;
}

namespace {

/// Bounds the change of unit normals if control points move by `off`.
///
/// Derivatives are means of differences of control points, and move by at most 6 off, so n = S_u x
/// S_v moves by some d. S_u and S_v are means of control vectors, and n.a is bilinear in these. So
/// the least value of n.a is that of a pair of control vectors. Unit vectors then differ by at most
/// twice d over the length of n.
double turn_of(const l3d_bezier_patch<double, 3>& p, double off) {
    std::vector<vector> along_u, along_v;
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 3; ++k) {
            along_u.push_back((p.at(i, k + 1) - p.at(i, k)) * 3.0);
            along_v.push_back((p.at(k + 1, i) - p.at(k, i)) * 3.0);
        }
    vector u{0.0, 0.0, 0.0}, v{0.0, 0.0, 0.0};
    double longest = 0;
    for (std::size_t i = 0; i < along_u.size(); ++i) {
        u = u + along_u[i];
        v = v + along_v[i];
        longest = std::max({longest, l3d_length(along_u[i]), l3d_length(along_v[i])});
    }
    const vector middle = l3d_cross(u, v);
    const double length = l3d_length(middle);
    if (!(length > 0))
        return std::numeric_limits<double>::infinity();
    double least = std::numeric_limits<double>::infinity();
    for (const vector& a : along_u)
        for (const vector& b : along_v)
            least = std::min(least, l3d_dot(l3d_cross(a, b), middle) / length);
    const double moved = 6 * off * (2 * longest + 6 * off);
    return least > moved ? 2 * moved / (least - moved) : std::numeric_limits<double>::infinity();
}

} // namespace

l3d_patch_model::stated::stated(std::span<const l3d_patch_error> of, const l3d_patch_model& model)
    : errors(of.begin(), of.end()) {
    for (std::size_t i = 0; i < errors.size(); ++i) {
        places = std::max(places, errors[i].places);
        if (!errors[i].is_of_points || errors[i].places == 0)
            continue;
        // The patches of a curved model are not its pieces.
        const double turn = model.is_curved() ? std::numeric_limits<double>::infinity()
                                              : turn_of(model.patches()[i], errors[i].places);
        errors[i].is_of_points = turn < 1;
        if (errors[i].is_of_points)
            normals = std::max(normals, turn);
    }
}

l3d_patch_model l3d_patch_model::standing_for(std::span<const l3d_patch_error> errors) const {
    l3d_patch_model result = *this;
    result.stated_ = errors.empty() ? nullptr : std::make_shared<const stated>(errors, *this);
    return result;
}
