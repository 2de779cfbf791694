// SPDX-License-Identifier: MIT
// l3d_frame_doubts: gives patches to tiles, and compares the drawn picture with exact bounds.
#include "dice/certificate/frame_doubts.h"

#include "raster/color/srgb_light.h"
#include "scene/placed_net.h"
#include "scene/sides/shared_edges.h"

#include <algorithm>
#include <cmath>

namespace {

using vector = l3d_vector<double, 3>;
using l3d_detail::infinite;

/// Bounds the rounding of sums of light in double, and of the map's floats. Units: levels of 255.
constexpr double level_rounding = 1e-4;

/// The largest sum of the bounds of places and of depth for which a frame's pixels are searched for
/// other surfaces within the bounds. Without a search, all of a pixel may show another surface.
/// Units: pixels.
constexpr double most_searched = 2;

/// The rows of x, y and w in the matrix that maps the world, as seen from the eye, to the picture.
std::array<vector, 3> rows(const l3d_matrix<double>& m) {
    const auto row = [&](int i) -> vector { return {m(i, 0), m(i, 1), m(i, 2)}; };
    return {row(0), row(1), row(3)};
}

/// The columns of the matrix that maps (x, y, w) to the world, as seen from the eye.
/// Source: Cramer's rule.
std::array<vector, 3> world_of_image(const l3d_matrix<double>& m) {
    const auto [x, y, w] = rows(m);
    const double part = 1 / l3d_dot(x, l3d_cross<double>(y, w));
    return {l3d_cross<double>(y, w) * part, l3d_cross<double>(w, x) * part,
            l3d_cross<double>(x, y) * part};
}

/// How far a drawn pixel may be off in the worst channel, if its exact light is within these
/// bounds. Units: levels of 255.
double most_off(std::uint32_t word, const l3d_light_bounds& light) {
    double result = 0;
    for (std::size_t i = 0; i < light.least.size(); ++i) {
        const double level = word >> (16 - 8 * i) & 0xff;
        result = std::max({result, level - l3d_level_of_light(light.least[i]),
                           l3d_level_of_light(light.most[i]) - level});
    }
    return std::min(result + level_rounding, 255.0);
}

/// Bounds the relative rounding of normals. Coefficients of normals are sums of some dozens of
/// products of differences. Then they are halved some dozens of times, and multiplied by a matrix.
constexpr double normal_rounding = 0x1p-44;

/// Bounds the length of an instance's normals. The largest component of a normal net is 1
/// (l3d_normal_net) before a placement turns the net.
double longest_normal(const l3d_patch_instance& instance) {
    double sum = 2;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            sum += std::abs(instance.normal_matrix()(row, column));
    return sum;
}

/// All lamps of the frame. The first lamp stands for the first light, with the direction `first`.
std::vector<l3d_doubt_lamp> lamps_of(const l3d_doubted_frame& frame, const vector& first) {
    std::vector<l3d_doubt_lamp> result{{first, frame.lighting.color}};
    for (std::size_t i = 0; i < frame.lighting.count; ++i) {
        const l3d_far_light& light = frame.lighting.lights[i];
        const vector to{double{light.direction[0]}, double{light.direction[1]},
                        double{light.direction[2]}};
        result.push_back({to * (1 / l3d_length(to)), light.color});
    }
    return result;
}

/// The largest distance between an edge and its faces, among the edges that a patch's trims follow.
double off_edges(const l3d_patch_model& model, std::size_t patch) {
    double result = 0;
    if (const l3d_trim_region* const trims = model.trim(patch))
        for (const l3d_trim_polygon& polygon : trims->polygons)
            for (const l3d_trim_corner& corner : polygon)
                if (corner.side.edge < model.edges().size())
                    result = std::max(result, model.edges()[corner.side.edge].off);
    return result;
}

double determinant_of(const l3d_matrix<double>& m) {
    const auto column = [&](int i) -> vector { return {m(0, i), m(1, i), m(2, i)}; };
    return l3d_dot(column(0), l3d_cross<double>(column(1), column(2)));
}

} // namespace

/// Finds the patches that may reach the picture. Only the patches' boxes are kept, since nets are
/// large.
void l3d_frame_doubts::place(const l3d_doubted_frame& frame) {
    sides_.clear(); // a new model may have the identity of a gone one
    patches_.clear();
    const l3d_dice_view& view = view_.view;
    const double near = view.camera_near > 0 ? view.camera_near : view.near;
    const l3d_image_box window =
        view.window().grown(1 + (std::isfinite(view_.bound_px) ? view_.bound_px : 0.0));
    // The far eye of a parallel projection has rays that turn by less than half of the window.
    const double off_of_normals =
        normal_rounding + (view.is_parallel() ? std::hypot(window.width(), window.height()) /
                                                    std::max(view.focal, 1.0)
                                              : 0);
    const auto [x, y, w] = rows(frame.to_image);
    const double longest_xy = std::max(l3d_length(x), l3d_length(y));
    std::uint32_t index = 0;
    for (const l3d_patch_instance& instance : frame.scene.instances()) {
        const l3d_patch_model& model = instance.model();
        const l3d_side_pairs& sides = sides_.try_emplace(model.identity(), model).first->second;
        const l3d_matrix<double> to_image = frame.to_image * instance.placement();
        const double back = determinant_of(instance.placement()) < 0 ? -1 : 1;
        for (std::size_t i = 0; i < model.patches().size(); ++i) {
            const double share = frame.view.share_of(instance.reach(model.reach(i).whole));
            // The error of the surface, and that of the edges at which it ends, in the world's
            // unit.
            const double off = instance.stretch() * (model.surface_error(i) + off_edges(model, i));
            placed p;
            p.of = {.instance = index,
                    .patch = static_cast<std::uint32_t>(i),
                    .error_xy = frame.view.error_xy * share + longest_xy * off,
                    .error_w = frame.view.error_w * share + l3d_length(w) * off,
                    .near = frame.view.near_of(share),
                    .normal_off = off_of_normals * longest_normal(instance),
                    .turned = !model.has_normal_error(i) ? infinite
                              : model.is_exact()         ? 0
                                                         : frame.curved.normals,
                    .sides = &sides,
                    .one_sided = frame.view.one_sided,
                    .back = back};
            if (const auto materials = frame.scene.materials(); !materials.empty()) {
                const l3d_material& m = materials[frame.scene.material_of(index, i)];
                p.of.color = l3d_parts_of(m.color);
                p.of.highlight = l3d_parts_of(m.highlight);
                p.of.sharpness = m.sharpness;
            }
            if (!frame.has_levels)
                p.of.lighting = &view_.lighting;
            const l3d_image_net net = l3d_placed_net(to_image, model.patches()[i]);
            const double margin = 1 + p.of.error_xy / near;
            if (l3d_outside(net.points, window.grown(margin), near - p.of.error_w, view.far))
                continue;
            p.box = {-infinite, -infinite, infinite, infinite};
            if (net.w().least > 2 * p.of.error_w)
                p.box =
                    net.box().grown(margin + l3d_vertex_error(p.of.error_xy, p.of.error_w,
                                                              net.box().reach(), net.w().least));
            patches_.push_back(p);
        }
        ++index;
    }
}

l3d_doubt_piece l3d_frame_doubts::whole_of(const l3d_doubted_frame& frame, const placed& p) const {
    const l3d_patch_instance& instance = frame.scene.instances()[p.of.instance];
    const l3d_patch_model& model = instance.model();
    l3d_doubt_piece whole;
    whole.of = &p.of;
    if (const l3d_trim_region* const trims = model.trim(p.of.patch))
        whole.take(*trims);
    whole.net = l3d_placed_net(frame.to_image * instance.placement(), model.patches()[p.of.patch]);
    const l3d_normal_net& own = model.normals(p.of.patch);
    whole.normals = instance.turns_normals()
                        ? l3d_placed_normals(instance.normal_matrix(), own).polynomial()
                        : own.polynomial();
    return whole;
}

/// Bounds the light of the pixels in a box of the picture. The light is the weighted mean over all
/// choices of the transparent instances that reach the box.
std::vector<l3d_frame_doubts::pixel> l3d_frame_doubts::find_light(const l3d_doubted_frame& frame,
                                                                  const l3d_pixel_box& box,
                                                                  l3d_doubt_tile& tile) const {
    const l3d_image_box reached =
        view_.view.window(box).grown(1 + (std::isfinite(view_.bound_px) ? view_.bound_px : 0.0));
    const auto instances = frame.scene.instances();
    std::vector<const placed*> here;
    std::vector<std::uint32_t> transparent; // instances, in their order
    for (const placed& p : patches_) {
        const std::uint32_t instance = p.of.instance;
        if (p.box.intersected(reached).empty() || instances[instance].opacity() == 0)
            continue;
        here.push_back(&p);
        if (instances[instance].opacity() < 1 &&
            (transparent.empty() || transparent.back() != instance))
            transparent.push_back(instance);
    }
    std::vector<pixel> result(static_cast<std::size_t>(box.area()));
    for (unsigned seen = 0; seen < 1U << transparent.size(); ++seen) {
        double weight = 1;
        for (std::size_t i = 0; i < transparent.size(); ++i) {
            const double opacity = instances[transparent[i]].opacity();
            weight *= seen >> i & 1 ? opacity : 1 - opacity;
        }
        tile.begin(view_, box);
        for (const placed* const p : here) {
            const auto at = std::ranges::find(transparent, p->of.instance);
            if (at == transparent.end() || seen >> (at - transparent.begin()) & 1)
                tile.add(whole_of(frame, *p));
        }
        const auto pixels = tile.finish();
        for (std::size_t i = 0; i < result.size(); ++i) {
            result[i].light.add(pixels[i].light, weight);
            result[i].unsure = std::max(result[i].unsure, pixels[i].unsure);
            result[i].unsure_drawn = std::max(result[i].unsure_drawn, pixels[i].unsure_drawn);
            result[i].covered = std::max(result[i].covered, pixels[i].covered);
        }
    }
    return result;
}

void l3d_frame_doubts::find_tile(const l3d_doubted_frame& frame, const l3d_pixel_box& box,
                                 l3d_doubt_tile& tile, tile_result& result) {
    const std::vector<pixel> pixels = find_light(frame, box, tile);
    std::size_t i = 0;
    for (int y = box.top; y < box.bottom; ++y) {
        const auto words = frame.drawn.row(y);
        for (int x = box.left; x < box.right; ++x, ++i) {
            const pixel& p = pixels[i];
            const double bound = most_off(words[static_cast<std::size_t>(x)], p.light);
            map_.set(x, y, static_cast<float>(bound));
            const double part = is_searched_ ? p.unsure_drawn : 1;
            coverage_.set(x, y, static_cast<float>(part));
            result.coverage = std::max(result.coverage, part);
            if (p.unsure > 0 || p.unsure_drawn > 0) {
                result.has_unsure = true;
                continue;
            }
            result.color = std::max(result.color, bound);
            result.has_covered = result.has_covered || p.covered > 0;
        }
    }
}

std::int64_t l3d_frame_doubts::cuts() const {
    std::int64_t result = 0;
    for (const l3d_doubt_tile& tile : tiles_)
        result += tile.cuts();
    return result;
}

void l3d_frame_doubts::find(const l3d_doubted_frame& frame, l3d_workers& workers) {
    view_.view = frame.view;
    view_.world_of_image = world_of_image(frame.to_image);
    view_.background = frame.background;
    view_.light = frame.light * (1 / l3d_length(frame.light));
    const bool has_bounds = std::isfinite(frame.bound_px + frame.depth_bound_px);
    view_.lighting = {.ambient = frame.lighting.ambient,
                      .lamps = lamps_of(frame, view_.light),
                      .fog = frame.fog,
                      .depth_scale = frame.view.depth_scale,
                      .nearer = frame.nearer};
    is_searched_ = frame.bound_px + frame.depth_bound_px <= most_searched;
    view_.bound_px = is_searched_ ? frame.bound_px : infinite;
    view_.depth_bound_px = frame.depth_bound_px;
    place(frame);
    const l3d_size size = frame.view.size;
    map_.begin(size);
    coverage_.begin(size);
    tiles_.resize(static_cast<std::size_t>(workers.count()));
    constexpr int side = l3d_doubt_tile::side;
    const int columns = (size.width + side - 1) / side, rows = (size.height + side - 1) / side;
    std::vector<tile_result> results(static_cast<std::size_t>(columns) *
                                     static_cast<std::size_t>(rows));
    workers.for_each(columns * rows, [&](int item, int worker) {
        const int left = item % columns * side, top = item / columns * side;
        find_tile(frame,
                  {left, top, std::min(left + side, size.width), std::min(top + side, size.height)},
                  tiles_[static_cast<std::size_t>(worker)],
                  results[static_cast<std::size_t>(item)]);
    });
    coverage_bound_ = has_bounds ? 0 : infinite;
    color_bound_ = 0;
    bool has_unsure = false, has_covered = false;
    for (const tile_result& r : results) {
        coverage_bound_ = std::max(coverage_bound_, r.coverage);
        color_bound_ = std::max(color_bound_, r.color);
        has_unsure = has_unsure || r.has_unsure;
        has_covered = has_covered || r.has_covered;
    }
    if (has_unsure && !has_covered)
        color_bound_ = infinite;
}
