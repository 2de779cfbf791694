// SPDX-License-Identifier: MIT
// l3d_patch_scene::from_file: makes one model for each shape of a file, however often it is placed.
#include "scene/patch_scene.h"

#include "base/printable_p.h"
#include "geom/files/model_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

/// The models of a file's shapes. Each model is made when it is first asked for.
class shape_models {
public:
    shape_models(const l3d_model_file& file, std::string_view name)
        : file_(file), name_(name), plain_(file.shapes.size()) {}

    /// The model of the shape that a placement places, in the material that the placement gives it.
    /// Errors: null, and the reason in `why`.
    const l3d_patch_model* of(const l3d_model_placement& at, std::string& why) {
        const auto known = dressed_.find({at.shape, at.material});
        if (known != dressed_.end())
            return &known->second;
        const l3d_model_file shape = l3d_shape_of(file_, at.shape, at.material);
        auto& plain = plain_[at.shape];
        if (!plain)
            plain = l3d_patch_model::from_patches(shape.patches, shape.edges, name_, why);
        if (!plain)
            return nullptr;
        return &dressed_.emplace(std::pair(at.shape, at.material), plain->dressed(shape))
                    .first->second;
    }

private:
    const l3d_model_file& file_;
    std::string_view name_;
    std::vector<std::optional<l3d_patch_model>> plain_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, l3d_patch_model> dressed_;
};

bool is_transparent(const l3d_patch_model& model) {
    return std::ranges::any_of(model.materials(),
                               [](const l3d_material& m) { return m.opacity < 1; });
}

} // namespace

std::optional<l3d_patch_scene> l3d_patch_scene::from_file(const l3d_model_file& file,
                                                          std::string_view name, std::string& why) {
    l3d_patch_scene result;
    const auto add_flattened = [&](const l3d_model_file& rest) {
        const auto model = l3d_patch_model::from_file(rest, name, why);
        if (model)
            result.add(*model);
        return model ? std::optional(result) : std::nullopt;
    };
    if (file.placements.empty())
        return add_flattened(file);
    std::vector<l3d_model_placement> transparent;
    shape_models models(file, name);
    for (const l3d_model_placement& at : file.placements) {
        const l3d_patch_model* const model = models.of(at, why);
        if (!model)
            return std::nullopt;
        if (model->pieces() == 0)
            continue;
        if (is_transparent(*model)) {
            transparent.push_back(at);
            continue;
        }
        const l3d_part_run part{at.name, 0};
        const l3d_patch_model named = model->with_parts(std::array{part});
        if (const std::string fault = complaint(named, at.place); !fault.empty()) {
            why =
                l3d_detail::printable(name) + ": " + l3d_detail::printable(at.name) + ": " + fault;
            return std::nullopt;
        }
        result.add(named, at.place);
    }
    if (transparent.empty())
        return result;
    l3d_model_file copies = file;
    copies.placements = std::move(transparent);
    return add_flattened(copies);
}

l3d_parts l3d_patch_scene::parts() const {
    std::vector<l3d_part_run> runs;
    std::size_t pieces = 0;
    for (const l3d_patch_instance& instance : instances()) {
        const l3d_patch_model& model = instance.model();
        runs.push_back({"", static_cast<std::uint32_t>(pieces)});
        for (const l3d_part_run& run : model.parts().runs())
            runs.push_back({run.name, static_cast<std::uint32_t>(run.first + pieces)});
        pieces += model.pieces();
    }
    return {runs, pieces};
}

l3d_patch_scene::vector l3d_patch_scene::pieces_middle() const {
    vector least{0.0, 0.0, 0.0}, most{0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < instances().size(); ++i) {
        const l3d_patch_model& model = instances()[i].model();
        const l3d_matrix<double>& place = instances()[i].placement();
        const vector half = (model.pieces_most() - model.pieces_least()) * 0.5;
        const vector middle = (model.pieces_least() + model.pieces_most()) * 0.5;
        const auto centre = place * l3d_vector<double, 4>(middle[0], middle[1], middle[2], 1.0);
        for (int k = 0; k < 3; ++k) {
            const double reach = std::abs(place(k, 0)) * half[0] + std::abs(place(k, 1)) * half[1] +
                                 std::abs(place(k, 2)) * half[2];
            least[k] = i == 0 ? centre[k] - reach : std::min(least[k], centre[k] - reach);
            most[k] = i == 0 ? centre[k] + reach : std::max(most[k], centre[k] + reach);
        }
    }
    return (least + most) * 0.5;
}
