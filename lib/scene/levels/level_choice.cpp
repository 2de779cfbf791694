// SPDX-License-Identifier: MIT
// Chooses the levels of curved models by the view alone (NUMERICS, section 25).
#include "scene/levels/level_choice.h"

#include "geom/transform.h"
#include "scene/levels/curved_pieces.h"
#include "scene/patch_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace {

using vector = l3d_patch_scene::vector;

/// Frobenius' norm of a matrix' upper left three by three. It bounds the factor by which a vector's
/// length grows.
double norm_of(const l3d_matrix<double>& m) {
    double squares = 0;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            squares += m(row, column) * m(row, column);
    return std::sqrt(squares);
}

/// The largest number of patches of a level that is drawn. Where more would be needed, the picture
/// gets cells for its own region instead. So many patches take a quarter of a second to make, once.
constexpr double most_of_all = 8192;

/// How an instance multiplies errors, and where it stands in the picture.
struct seen_instance {
    double stretch = 1; ///< the factor by which lengths grow
    double turn = 1;    ///< the factor by which errors of unit normals grow
    double least_w = 0, most_w = 0;
    /// The pixels of a unit at depth 1, at the farthest corner of the window, where a unit has most
    /// pixels.
    double focal = 0;
    double near = 0;

    seen_instance(const l3d_patch_instance& instance, const l3d_level_view& view) {
        stretch = instance.stretch();
        if (!(instance.scale() > 0)) {
            // n / |n| and m / |m| turn by no more than twice the condition of the normals' matrix.
            const auto back = l3d_inverted(instance.normal_matrix());
            turn = back ? 2 * norm_of(instance.normal_matrix()) * norm_of(*back)
                        : std::numeric_limits<double>::infinity();
        }
        const vector ahead = view.camera.axes().forward;
        const vector middle =
            (instance.model().pieces_least() + instance.model().pieces_most()) * 0.5;
        const vector half =
            (instance.model().pieces_most() - instance.model().pieces_least()) * 0.5;
        const l3d_matrix<double>& to_world = instance.placement();
        double at = 0, reach = 0;
        for (int row = 0; row < 3; ++row)
            at += ahead[row] *
                  (to_world(row, 0) * middle[0] + to_world(row, 1) * middle[1] +
                   to_world(row, 2) * middle[2] + to_world(row, 3) - view.camera.eye[row]);
        for (int k = 0; k < 3; ++k)
            reach += half[k] * std::abs(ahead[0] * to_world(0, k) + ahead[1] * to_world(1, k) +
                                        ahead[2] * to_world(2, k));
        if (view.camera.is_parallel()) {
            least_w = most_w = 1;
            focal = view.camera.scale_at_target(view.size);
            return;
        }
        least_w = at - reach;
        most_w = at + reach;
        focal = std::hypot(view.camera.focal_length(view.size), view.size.width / 2.0,
                           view.size.height / 2.0);
        near = view.camera.near_z;
    }

    /// The errors that the picture allows to a model's cells. Nothing if the view has no region.
    ///
    /// At depth w >= near, an error e of places is e stretch focal / w pixels. Nearer places are
    /// not drawn, except by error. So an error for which pixels() is places_px is always allowed.
    std::optional<l3d_cell_wish> wish(const l3d_patch_instance& instance,
                                      const l3d_level_view& view, int normals) const {
        const l3d_patch_model& model = instance.model();
        double reach = 0;
        for (int corner = 0; corner < 8; ++corner) {
            l3d_point<double> at{vector(0.0)};
            for (int k = 0; k < 3; ++k)
                at.from_origin[k] =
                    (corner >> k & 1) != 0 ? model.pieces_most()[k] : model.pieces_least()[k];
            at = l3d_transformed(instance.placement(), at);
            reach = std::max(reach, l3d_length(at.from_origin - view.camera.target));
        }
        const auto in_world =
            l3d_seen_region::of(view.camera, view.size, std::max(least_w, near), reach);
        if (!in_world)
            return std::nullopt;
        const double at_1 = view.places_px / (stretch * focal);
        const double anywhere = view.camera.is_parallel()
                                    ? at_1
                                    : view.places_px * near / (stretch * (focal + view.places_px));
        return l3d_cell_wish{.places = anywhere,
                             .normals = normals,
                             .region = in_world->in(instance.placement()),
                             .places_by_depth = at_1};
    }

    /// The largest error in pixels of a place in front of the near plane, if its error in the model
    /// is `error`.
    double pixels(double error) const {
        const double e = error * stretch;
        const double w = std::max(least_w, near - e);
        return w > 0 ? e * focal / w : std::numeric_limits<double>::infinity();
    }
};

} // namespace

l3d_curved_error l3d_patch_scene::choose_levels(const l3d_level_view& view) {
    l3d_curved_error result;
    if (curved_count_ == 0)
        return result;
    for (std::size_t i = 0; i < instances_.size(); ++i) {
        const l3d_patch_model& model = instances_[i].model();
        if (model.is_exact())
            continue;
        const seen_instance seen(instances_[i], view);
        if (seen.most_w <= seen.near)
            continue; // behind the near plane
        const auto first = [&](const auto& is_well) {
            int level = 0;
            while (level < model.most_level() && !is_well(level))
                ++level;
            return level;
        };
        const int normals = first(
            [&](int level) { return seen.turn * model.normal_target(level) <= view.normals; });
        // This compares the errors that patches really have. They are often less than the level
        // asks for.
        const auto is_well = [&](double error) { return seen.pixels(error) <= view.places_px; };
        std::optional<l3d_cell_wish> wanted;
        const int places = first([&](int level) {
            if (is_well(model.error_at_level(level, normals)))
                return true;
            if (model.patches_at_level(level, normals) > most_of_all / 2)
                wanted = seen.wish(instances_[i], view, normals);
            return wanted.has_value();
        });
        const std::optional<l3d_patch_model> part = wanted ? model.seen(*wanted) : std::nullopt;
        take_level(i, part ? *part : model.at_level(places, normals));
        const l3d_patch_model& drawn = instances_[i].model();
        result.places_px = std::max(result.places_px, part ? view.places_px * drawn.share_of_wish()
                                                           : seen.pixels(drawn.surface_error()));
        result.places = std::max(result.places, seen.stretch * drawn.surface_error());
        result.normals = std::max(result.normals, seen.turn * drawn.normal_error());
    }
    return result;
}

/// Gives an instance another level of its model. The change does not count as a change of the
/// scene.
void l3d_patch_scene::take_level(std::size_t index, const l3d_patch_model& finer) {
    l3d_patch_instance& instance = instances_[index];
    if (finer.identity() == instance.model().identity())
        return;
    patch_count_ += static_cast<std::int64_t>(finer.patches().size()) -
                    static_cast<std::int64_t>(instance.model().patches().size());
    instance.take_level(finer);
    boxes_.set(index, instance.box());
    extent_count_ = 0;
}
