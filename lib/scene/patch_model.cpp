// SPDX-License-Identifier: MIT
// l3d_patch_model: makes models of patches, surfaces and files, with materials, parts and levels.
#include "scene/levels/patch_contents_p.h"

#include "base/counted_p.h"
#include "base/formatted_p.h"
#include "geom/files/model_file.h"
#include "geom/files/patch_file.h"
#include "geom/nurbs_surface.h"
#include "geom/teapot.h"
#include "scene/model_loader.h"
#include "scene/sides/shared_edges.h"
#include "scene/space_curve.h"
#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace {

using vector = l3d_patch_model::vector;

/// The error message for a patch that cannot be a piece of a curved model; "" if it can.
std::string complaint_of(const l3d_patch_points& patch) {
    const auto well = [](int degree) { return degree >= 1 && degree <= l3d_bpt_largest_degree; };
    const std::string of_degree =
        " of degree " + std::to_string(patch.degree_u) + " by " + std::to_string(patch.degree_v);
    if (!well(patch.degree_u) || !well(patch.degree_v))
        return of_degree + ": degrees are from 1 to " + std::to_string(l3d_bpt_largest_degree);
    const auto wanted = static_cast<std::size_t>((patch.degree_u + 1) * (patch.degree_v + 1));
    if (patch.points.size() != wanted || (!patch.weights.empty() && patch.weights.size() != wanted))
        return of_degree + " has " + std::to_string(patch.points.size()) + " points and " +
               std::to_string(patch.weights.size()) + " weights";
    for (std::size_t i = 0; i < wanted; ++i) {
        const std::string point = ": point " + std::to_string(i + 1);
        for (std::size_t k = 0; k < 3; ++k)
            if (!(std::abs(patch.points[i][k]) <= l3d_bpt_largest_coordinate))
                return point +
                       l3d_detail::formatted(": %c is not finite, or beyond 1e12", "xyz"[k]);
        if (!patch.weights.empty() && !l3d_is_weight(patch.weights[i]))
            return point +
                   l3d_detail::formatted(" has the weight %g, which is not from 1e-100 to 1e12",
                                         patch.weights[i]);
    }
    const std::string of_trims = l3d_trims_complaint(patch.trims);
    return of_trims.empty() ? "" : ": " + of_trims;
}

/// The error message for patches that cannot make a model, naming the first number at fault; "" if
/// they can.
std::string complaint_of(const std::vector<l3d_patch_model::patch>& patches) {
    for (std::size_t p = 0; p < patches.size(); ++p)
        for (std::size_t i = 0; i < 16; ++i)
            for (int k = 0; k < 3; ++k) {
                const double value = patches[p].points[i][k];
                if (!(std::abs(value) <= l3d_bpt_largest_coordinate))
                    return l3d_detail::formatted(": patch %zu, row %zu, column %zu: %c is %g, %s",
                                                 p + 1, i / 4 + 1, i % 4 + 1, "xyz"[k], value,
                                                 std::isfinite(value) ? "beyond 1e12"
                                                                      : "not finite");
            }
    return "";
}

std::vector<l3d_patch_model::patch> without_fault(std::vector<l3d_patch_model::patch> patches) {
    if (const std::string what = complaint_of(patches); !what.empty())
        throw l3d_error(l3d_exit::bad_input, "model" + what);
    return patches;
}

std::vector<l3d_patch_points> pieces_of(std::span<const l3d_nurbs_surface> surfaces) {
    std::vector<l3d_patch_points> pieces;
    for (const l3d_nurbs_surface& surface : surfaces) {
        std::vector<l3d_patch_points> more = surface.pieces();
        pieces.insert(pieces.end(), std::make_move_iterator(more.begin()),
                      std::make_move_iterator(more.end()));
    }
    return pieces;
}

/// The curves of a file, a pixel wide and in their materials' colours.
std::vector<l3d_space_curve> curves_of(const l3d_model_file& file) {
    std::vector<l3d_space_curve> result;
    for (std::size_t i = 0; i < file.curves.size(); ++i) {
        const bool has_look = !file.curve_materials.empty() && !file.mesh.looks.empty();
        const l3d_material look =
            has_look ? file.mesh.looks[file.curve_materials[i]] : l3d_material();
        result.emplace_back(file.curves[i], look.color);
    }
    return result;
}

} // namespace

struct l3d_patch_model::paint {
    std::vector<l3d_material> materials; ///< the different materials, each once
    /// For each piece, the index of its material; empty if all have the same.
    std::vector<std::uint32_t> of_pieces;
};

l3d_patch_model::l3d_patch_model() : l3d_patch_model(std::vector<patch>(), nullptr) {}

l3d_patch_model::l3d_patch_model(std::vector<patch> patches)
    : l3d_patch_model(without_fault(std::move(patches)), nullptr) {}

l3d_patch_model::l3d_patch_model(std::vector<patch> patches, const contents* like)
    : contents_(std::make_shared<const contents>(std::move(patches), like)) {}

l3d_patch_model::l3d_patch_model(l3d_curved_pieces pieces, const source* like)
    : source_(std::make_shared<const source>(
          std::move(pieces), like == nullptr ? source::kept_levels() : like->levels())) {
    contents_ = source_->at_level(0, 0);
}

std::size_t l3d_patch_model::pieces() const {
    return source_ ? source_->pieces.pieces().size() : patches().size();
}

std::size_t l3d_patch_model::piece_of(std::size_t index) const {
    return source_ ? contents_->pieces[index] : index;
}

l3d_parameter_range l3d_patch_model::range_in_piece(std::size_t index) const {
    return source_ ? contents_->ranges[index] : l3d_parameter_range();
}

std::uint32_t l3d_patch_model::face_of(std::size_t piece) const {
    return faces_ ? (*faces_)[piece] : 0;
}

l3d_nurbs_surface l3d_patch_model::surface(std::size_t piece) const {
    if (source_)
        return l3d_nurbs_surface::of_patch(source_->pieces.pieces()[piece]);
    l3d_patch_points points{.degree_u = 3, .degree_v = 3, .points = {}};
    for (const vector& point : patches()[piece].points)
        points.points.push_back({point[0], point[1], point[2]});
    return l3d_nurbs_surface::of_patch(points);
}

std::vector<l3d_nurbs_surface> l3d_patch_model::surfaces() const {
    std::vector<l3d_nurbs_surface> result;
    for (std::size_t i = 0; i < pieces(); ++i)
        result.push_back(surface(i));
    return result;
}

l3d_patch_model l3d_patch_model::reshaped(std::span<const l3d_nurbs_surface> surfaces) const {
    std::string why;
    const std::vector<l3d_patch_points> read = pieces_of(surfaces);
    const auto edges = source_ ? source_->pieces.file_edges() : std::span<const l3d_model_edge>();
    auto result = made_like(this, read, edges, "reshaped model", why);
    if (result && result->pieces() != pieces())
        why = "reshaped model: " + std::to_string(result->pieces()) + " pieces in place of " +
              std::to_string(pieces());
    if (!why.empty())
        throw l3d_error(l3d_exit::bad_input, why);
    result->paint_ = paint_;
    result->parts_ = parts_;
    result->curves_ = curves_;
    return *std::move(result);
}

l3d_patch_model l3d_patch_model::at_level(int places, int normals) const {
    l3d_patch_model result = *this;
    if (source_)
        result.contents_ = source_->at_level(places, normals);
    return result;
}

int l3d_patch_model::most_level() const {
    return source_ ? l3d_curved_pieces::most_level : 0;
}

double l3d_patch_model::normal_target(int level) const {
    return source_ ? l3d_curved_pieces::normal_target(level) : 0;
}

double l3d_patch_model::error_at_level(int places, int normals) const {
    return source_ ? source_->error_and_count(places, normals).first : 0;
}

double l3d_patch_model::patches_at_level(int places, int normals) const {
    return source_ ? source_->error_and_count(places, normals).second
                   : static_cast<double>(patches().size());
}

std::optional<l3d_patch_model> l3d_patch_model::seen(const l3d_cell_wish& wanted) const {
    const auto of = source_->seen(wanted);
    if (!of)
        return std::nullopt;
    l3d_patch_model result = *this;
    result.contents_ = of;
    return result;
}

double l3d_patch_model::share_of_wish() const {
    return contents_->share;
}

double l3d_patch_model::surface_error(std::size_t index) const {
    return (stated_ ? stated_->errors[piece_of(index)].places : 0) +
           (source_ ? contents_->errors[index] : 0);
}

double l3d_patch_model::surface_error() const {
    return contents_->surface_error + (stated_ ? stated_->places : 0);
}

double l3d_patch_model::normal_error() const {
    return contents_->normal_error + (stated_ ? stated_->normals : 0);
}

bool l3d_patch_model::has_normal_error(std::size_t index) const {
    return !stated_ || stated_->errors[piece_of(index)].is_of_points;
}

std::span<const l3d_halved_side> l3d_patch_model::halved_sides() const {
    return contents_->halved;
}

unsigned l3d_patch_model::halved_edges(std::size_t index) const {
    return contents_->halved_edges.empty() ? 0 : contents_->halved_edges[index];
}

bool l3d_patch_model::has_trims() const {
    return source_ && source_->pieces.has_trims();
}

const l3d_trim_region* l3d_patch_model::trim(std::size_t index) const {
    return contents_->trims.empty() || contents_->trims[index].is_empty()
               ? nullptr
               : &contents_->trims[index];
}

std::span<const l3d_shared_edge> l3d_patch_model::edges() const {
    return source_ ? source_->pieces.edges() : std::span<const l3d_shared_edge>();
}

bool l3d_patch_model::follows_edges(std::size_t index) const {
    return !contents_->edges_off.empty() && contents_->edges_off[index] >= 0;
}

const void* l3d_patch_model::source_identity() const {
    return source_ ? static_cast<const void*>(source_.get()) : identity();
}

const l3d_patch_model::vector& l3d_patch_model::pieces_least() const {
    return source_ ? source_->pieces.least() : least();
}

const l3d_patch_model::vector& l3d_patch_model::pieces_most() const {
    return source_ ? source_->pieces.most() : most();
}

std::span<const l3d_patch_model::patch> l3d_patch_model::patches() const {
    return contents_->patches;
}

const l3d_normal_net& l3d_patch_model::normals(std::size_t index) const {
    return contents_->normals[index];
}

const l3d_facing_cones& l3d_patch_model::facing(std::size_t index) const {
    return contents_->facing[index];
}

const l3d_surface_bends& l3d_patch_model::bends(std::size_t index) const {
    return contents_->bends[index]->of(contents_->patches[index], contents_->normals[index]);
}

const l3d_patch_reach& l3d_patch_model::reach(std::size_t index) const {
    return contents_->reaches[index];
}

int l3d_patch_model::orientation() const {
    return contents_->orientation;
}

const l3d_patch_model::vector& l3d_patch_model::least() const {
    return contents_->least;
}

const l3d_patch_model::vector& l3d_patch_model::most() const {
    return contents_->most;
}

const l3d_box_lanes& l3d_patch_model::boxes() const {
    return contents_->boxes;
}

const void* l3d_patch_model::identity() const {
    return contents_.get();
}

const void* l3d_patch_model::paint_identity() const {
    return paint_.get();
}

std::span<const l3d_material> l3d_patch_model::materials() const {
    return paint_ ? std::span(paint_->materials) : std::span<const l3d_material>();
}

std::uint32_t l3d_patch_model::material_of(std::size_t index) const {
    return paint_ && !paint_->of_pieces.empty() ? paint_->of_pieces[piece_of(index)] : 0;
}

l3d_patch_model l3d_patch_model::painted(std::span<const l3d_material> materials) const {
    if (materials.size() != 1 && materials.size() != pieces())
        throw l3d_error(l3d_exit::failure, "materials: " + std::to_string(materials.size()) +
                                               " for " + std::to_string(pieces()) + " patches");
    l3d_patch_model result = *this;
    result.paint_ = nullptr;
    if (std::ranges::all_of(materials, &l3d_material::is_plain))
        return result;
    const auto made = std::make_shared<paint>();
    std::map<std::tuple<std::uint32_t, std::uint32_t, int, float>, std::uint32_t> places;
    for (const l3d_material& m : materials) {
        const auto next = static_cast<std::uint32_t>(made->materials.size());
        const auto [place, is_new] =
            places.try_emplace({m.color, m.highlight, m.sharpness, m.opacity}, next);
        if (is_new)
            made->materials.push_back(m);
        made->of_pieces.push_back(place->second);
    }
    if (made->materials.size() == 1)
        made->of_pieces.clear();
    result.paint_ = made;
    return result;
}

std::vector<l3d_material> l3d_patch_model::piece_materials() const {
    std::vector<l3d_material> result(pieces());
    if (paint_)
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] = paint_->materials[paint_->of_pieces.empty() ? 0 : paint_->of_pieces[i]];
    return result;
}

l3d_patch_model l3d_patch_model::with_parts(std::span<const l3d_part_run> runs) const {
    l3d_patch_model result = *this;
    result.parts_ = std::make_shared<const l3d_parts>(runs, pieces());
    return result;
}

const l3d_parts& l3d_patch_model::parts() const {
    static const l3d_parts no_parts;
    return parts_ ? *parts_ : no_parts;
}

l3d_patch_model l3d_patch_model::part_painted(std::size_t part,
                                              const l3d_material& material) const {
    std::vector<l3d_material> materials = piece_materials();
    for (std::size_t i = 0; i < materials.size(); ++i)
        if (parts().of(i) == part)
            materials[i] = material;
    return painted(materials);
}

l3d_patch_model l3d_patch_model::only(std::span<const std::size_t> parts) const {
    return chosen(this->parts().things_of(parts, pieces()));
}

l3d_patch_model l3d_patch_model::without(std::span<const std::size_t> parts) const {
    std::vector<bool> kept = this->parts().things_of(parts, pieces());
    kept.flip();
    l3d_patch_model result = chosen(kept);
    result.curves_ = curves_;
    return result;
}

l3d_patch_model l3d_patch_model::with_curves(std::vector<l3d_space_curve> curves) const {
    l3d_patch_model result = *this;
    result.curves_ = std::make_shared<const std::vector<l3d_space_curve>>(std::move(curves));
    return result;
}

std::span<const l3d_space_curve> l3d_patch_model::curves() const {
    return curves_ ? std::span(*curves_) : std::span<const l3d_space_curve>();
}

std::vector<float> l3d_patch_model::opacities() const {
    std::vector<float> result;
    for (const l3d_material& m : piece_materials())
        if (std::ranges::find(result, m.opacity) == result.end())
            result.push_back(m.opacity);
    return result;
}

l3d_patch_model l3d_patch_model::of_opacity(float least, float most) const {
    std::vector<bool> is_chosen;
    for (const l3d_material& m : piece_materials())
        is_chosen.push_back(m.opacity >= least && m.opacity <= most);
    l3d_patch_model result = chosen(is_chosen);
    if (most >= 1)
        result.curves_ = curves_;
    return result;
}

l3d_patch_model l3d_patch_model::chosen(const std::vector<bool>& is_chosen) const {
    if (std::ranges::find(is_chosen, false) == is_chosen.end()) {
        l3d_patch_model result = *this; // shares everything that is known of the patches
        result.curves_ = nullptr;
        return result;
    }
    const std::vector<l3d_material> all = piece_materials();
    std::vector<patch> kept;
    std::vector<l3d_patch_points> curved;
    std::vector<l3d_material> materials;
    std::vector<l3d_part_run> runs;
    std::vector<l3d_patch_error> errors;
    std::vector<std::uint32_t> faces;
    for (std::size_t i = 0; i < is_chosen.size(); ++i) {
        if (!is_chosen[i])
            continue;
        runs.push_back(
            {std::string(parts().name_of(i)), static_cast<std::uint32_t>(materials.size())});
        if (source_)
            curved.push_back(source_->pieces.pieces()[i]);
        else
            kept.push_back(patches()[i]);
        materials.push_back(all[i]);
        if (stated_)
            errors.push_back(stated_->errors[i]);
        if (faces_)
            faces.push_back((*faces_)[i]);
    }
    const l3d_patch_model of =
        curved.empty() ? l3d_patch_model(std::move(kept))
                       : l3d_patch_model(l3d_curved_pieces(std::move(curved),
                                                           {source_->pieces.file_edges().begin(),
                                                            source_->pieces.file_edges().end()}),
                                         nullptr);
    l3d_patch_model result = of.with_parts(runs).standing_for(errors);
    if (faces_)
        result.faces_ = std::make_shared<const std::vector<std::uint32_t>>(std::move(faces));
    return materials.empty() ? result : result.painted(materials);
}

l3d_patch_model l3d_patch_model::teapot() {
    std::string why;
    const auto model = from_bpt(l3d_teapot_bpt(), "teapot.bpt", why);
    if (!model)
        throw l3d_error(l3d_exit::bad_input, why);
    return model->with_parts(l3d_teapot_parts());
}

l3d_patch_model l3d_patch_model::load(const std::string& file) {
    const l3d_model_file read = l3d_load_model(file, file);
    std::string why =
        file + ": holds " + l3d_detail::counted(read.mesh.faces(), "polygons") + " and no patches";
    if (!read.patches.empty())
        if (const auto model = from_file(read, file, why))
            return *model;
    throw l3d_error(l3d_exit::bad_input, why);
}

std::optional<l3d_patch_model> l3d_patch_model::from_file(const l3d_model_file& file,
                                                          std::string_view name, std::string& why) {
    if (!file.placements.empty())
        return from_file(l3d_flattened(file), name, why);
    const auto model = from_patches(file.patches, file.edges, name, why);
    return model ? std::optional(model->dressed(file)) : std::nullopt;
}

l3d_patch_model l3d_patch_model::dressed(const l3d_model_file& file) const {
    l3d_patch_model result = standing_for(file.patch_errors);
    if (!file.patch_faces.empty())
        result.faces_ = std::make_shared<const std::vector<std::uint32_t>>(file.patch_faces);
    if (!file.patch_parts.empty())
        result = result.with_parts(file.patch_parts);
    if (!file.curves.empty())
        result = result.with_curves(curves_of(file));
    if (file.patch_materials.empty() || file.mesh.looks.empty())
        return result;
    std::vector<l3d_material> materials;
    materials.reserve(file.patch_materials.size());
    for (const std::uint32_t material : file.patch_materials) {
        materials.push_back(file.mesh.looks[material]);
        materials.back().picture = l3d_material::no_picture;
    }
    return result.painted(materials);
}

std::optional<l3d_patch_model> l3d_patch_model::checked(std::vector<patch> patches,
                                                        std::string_view name, std::string& why) {
    const std::string what = complaint_of(patches);
    if (!what.empty()) {
        why = std::string(name) + what;
        return std::nullopt;
    }
    return l3d_patch_model(std::move(patches), nullptr);
}

std::optional<l3d_patch_model> l3d_patch_model::from_bpt(std::string_view text,
                                                         std::string_view name, std::string& why) {
    const auto read = l3d_read_bpt(text, name, why);
    return read ? from_patches(*read, name, why) : std::nullopt;
}

std::optional<l3d_patch_model> l3d_patch_model::from_patches(std::span<const l3d_patch_points> read,
                                                             std::string_view name,
                                                             std::string& why) {
    return made_like(nullptr, read, {}, name, why);
}

std::optional<l3d_patch_model> l3d_patch_model::from_patches(std::span<const l3d_patch_points> read,
                                                             std::span<const l3d_model_edge> edges,
                                                             std::string_view name,
                                                             std::string& why) {
    for (std::size_t i = 0; i < read.size(); ++i)
        for (const l3d_trim_loop& loop : read[i].trims)
            for (const l3d_trim_curve& one : loop)
                if (one.edge != l3d_no_edge && one.edge >= edges.size()) {
                    why = std::string(name) + ": patch " + std::to_string(i + 1) +
                          ": a trim follows edge " + std::to_string(one.edge + 1) + " of " +
                          std::to_string(edges.size());
                    return std::nullopt;
                }
    return made_like(nullptr, read, edges, name, why);
}

std::optional<l3d_patch_model> l3d_patch_model::made_like(const l3d_patch_model* like,
                                                          std::span<const l3d_patch_points> read,
                                                          std::span<const l3d_model_edge> edges,
                                                          std::string_view name, std::string& why) {
    std::vector<patch> patches;
    patches.reserve(read.size());
    for (const l3d_patch_points& points : read) {
        const auto bicubic = l3d_as_bicubic(points);
        if (!bicubic || !points.trims.empty())
            return curved(like, read, edges, name, why);
        patch& p = patches.emplace_back();
        for (std::size_t i = 0; i < 16; ++i)
            for (int k = 0; k < 3; ++k)
                p.points[i][k] = (*bicubic)[i][static_cast<std::size_t>(k)];
    }
    const std::string what = complaint_of(patches);
    if (!what.empty()) {
        why = std::string(name) + what;
        return std::nullopt;
    }
    return l3d_patch_model(std::move(patches), like == nullptr ? nullptr : like->contents_.get());
}

std::optional<l3d_patch_model> l3d_patch_model::curved(const l3d_patch_model* like,
                                                       std::span<const l3d_patch_points> read,
                                                       std::span<const l3d_model_edge> edges,
                                                       std::string_view name, std::string& why) {
    for (std::size_t i = 0; i < read.size(); ++i) {
        const std::string what = complaint_of(read[i]);
        if (what.empty())
            continue;
        why = std::string(name) + ": patch " + std::to_string(i + 1) + what;
        return std::nullopt;
    }
    return l3d_patch_model(
        l3d_curved_pieces({read.begin(), read.end()}, {edges.begin(), edges.end()}),
        like == nullptr ? nullptr : like->source_.get());
}

l3d_patch_model l3d_patch_model::from_surfaces(std::span<const l3d_nurbs_surface> surfaces,
                                               std::span<const l3d_model_edge> edges) {
    std::string why;
    const auto model = from_patches(pieces_of(surfaces), edges, "surfaces", why);
    if (!model)
        throw l3d_error(l3d_exit::bad_input, why);
    return *model;
}
