// SPDX-License-Identifier: MIT
// l3d_patch_scene: finds boxes, normals and materials of placed models.
#include "scene/patch_scene.h"

#include "base/formatted_p.h"
#include "geom/files/patch_file.h"
#include "base/error.h"
#include "geom/transform.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <string>

namespace {

using vector = l3d_patch_scene::vector;

bool is_affine(const l3d_matrix<double>& m) {
    return m(3, 0) == 0 && m(3, 1) == 0 && m(3, 2) == 0 && m(3, 3) == 1;
}

/// The largest magnitude in a matrix' upper left three by three.
double largest(const l3d_matrix<double>& m) {
    double result = 0;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            result = std::max(result, std::abs(m(row, column)));
    return result;
}

/// The cofactors of a matrix' upper left three by three, scaled so that the largest is 1. The
/// matrix is scaled first, so that products neither overflow nor vanish.
l3d_matrix<double> cofactors(const l3d_matrix<double>& m) {
    const double scale = 1 / largest(m);
    const auto at = [&](int row, int column) { return m(row % 3, column % 3) * scale; };
    l3d_matrix<double> result = l3d_identity<double>();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            result(row, column) = at(row + 1, column + 1) * at(row + 2, column + 2) -
                                  at(row + 1, column + 2) * at(row + 2, column + 1);
    const double most = largest(result);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            result(row, column) /= most;
    return result;
}

bool is_finite(const l3d_matrix<double>& m) {
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            if (!std::isfinite(m(row, column)))
                return false;
    return true;
}

/// Whether a matrix' upper left three by three certainly has an inverse: the computed determinant
/// exceeds its own rounding. Each of the six products has at most four roundings of 2^-53, and
/// their sum adds five: below 16 roundings in all.
bool can_be_inverted(const l3d_matrix<double>& m) {
    constexpr double rounding = 16 * 0x1p-53;
    const double most = largest(m);
    if (!(most > 0))
        return false;
    const auto at = [&](int row, int column) { return m(row, column % 3) / most; };
    double determinant = 0, terms = 0;
    for (int i = 0; i < 3; ++i) {
        const double down = at(0, i) * at(1, i + 1) * at(2, i + 2);
        const double up = at(0, i) * at(1, i + 2) * at(2, i + 1);
        determinant += down - up;
        terms += std::abs(down) + std::abs(up);
    }
    return std::abs(determinant) > rounding * terms;
}

/// A model's box in the world, without its reach.
l3d_slanted_box box_of(const l3d_patch_model& model, const l3d_matrix<double>& placement) {
    l3d_slanted_box box;
    box.centre = l3d_transformed(placement, l3d_point<double>((model.least() + model.most()) * 0.5))
                     .from_origin;
    const vector half = (model.most() - model.least()) * 0.5;
    for (int k = 0; k < 3; ++k) {
        vector axis{0.0, 0.0, 0.0};
        axis[k] = half[k];
        box.axes[static_cast<std::size_t>(k)] = l3d_transformed(placement, axis);
    }
    return box;
}

/// The largest coordinate of a box, as a magnitude.
double farthest(const l3d_slanted_box& box) {
    double result = 0;
    for (int i = 0; i < 3; ++i)
        result = std::max(result, std::abs(box.centre[i]) + std::abs(box.axes[0][i]) +
                                      std::abs(box.axes[1][i]) + std::abs(box.axes[2][i]));
    return result;
}

std::int64_t patches_of(const l3d_patch_model& model) {
    return static_cast<std::int64_t>(model.patches().size());
}

/// The factor by which a similarity multiplies lengths, rounded up; 0 for any other map.
double scale_of(const l3d_matrix<double>& placement) {
    constexpr double rounding = 0x1p-40; // some roundings of 2^-53
    double products[3][3] = {};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                products[i][j] += placement(k, i) * placement(k, j);
    const double square = products[0][0];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (!(std::abs(products[i][j] - (i == j ? square : 0)) <= rounding * square))
                return 0;
    return std::sqrt(square) * (1 + rounding);
}

void check(const l3d_patch_model& model, const l3d_matrix<double>& placement) {
    if (const std::string why = l3d_patch_scene::complaint(model, placement); !why.empty())
        throw l3d_error(l3d_exit::failure, why);
}

} // namespace

l3d_patch_instance::l3d_patch_instance(const l3d_patch_model& model,
                                       const l3d_matrix<double>& placement)
    : model_(model) {
    place(placement);
}

void l3d_patch_instance::place(const l3d_matrix<double>& placement) {
    assert(is_affine(placement));
    placement_ = placement;
    normal_matrix_ = cofactors(placement);
    turns_normals_ = !(normal_matrix_ == l3d_identity<double>());
    scale_ = scale_of(placement);
    terms_ = {0.0, 0.0, 0.0};
    shift_ = 0;
    for (int row = 0; row < 3; ++row) {
        for (int k = 0; k < 3; ++k)
            terms_[k] += std::abs(placement(row, k));
        shift_ += std::abs(placement(row, 3));
    }
}

double l3d_patch_instance::stretch() const {
    double squares = 0;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            squares += placement_(row, column) * placement_(row, column);
    return scale_ > 0 ? scale_ : std::sqrt(squares);
}

l3d_slanted_box l3d_patch_instance::box() const {
    l3d_slanted_box box = box_of(model_, placement_);
    box.reach = reach();
    return box;
}

double l3d_patch_instance::reach() const {
    vector most{0.0, 0.0, 0.0};
    for (int k = 0; k < 3; ++k)
        most[k] = std::max(std::abs(model_.least()[k]), std::abs(model_.most()[k]));
    return reach(most);
}

std::string l3d_patch_scene::complaint(const l3d_patch_model& model,
                                       const l3d_matrix<double>& placement) {
    if (!is_finite(placement))
        return "placement: a number is not finite";
    if (!is_affine(placement))
        return "placement: the last row is not 0,0,0,1";
    if (!can_be_inverted(placement))
        return "placement: it flattens the model, since the matrix cannot be inverted";
    if (!(farthest(box_of(model, placement)) <= l3d_bpt_largest_coordinate))
        return "placement: it takes the model beyond 1e12";
    return "";
}

void l3d_patch_scene::add(const l3d_patch_model& model, const l3d_matrix<double>& placement) {
    check(model, placement);
    const l3d_patch_instance& instance = instances_.emplace_back(model, placement);
    boxes_.add(instance.box());
    patch_count_ += patches_of(instance.model());
    curved_count_ += model.is_exact() ? 0 : 1;
    is_moved_.push_back(false);
    is_rebuilt_ = true;
    knows_materials_ = false;
}

void l3d_patch_scene::place(std::size_t index, const l3d_patch_model& model,
                            const l3d_matrix<double>& placement) {
    l3d_patch_instance& instance = instances_.at(index);
    const bool is_same = model.source_identity() == instance.model().source_identity() &&
                         model.paint_identity() == instance.model().paint_identity();
    if (is_same && placement == instance.placement())
        return;
    check(model, placement);
    note_change(index);
    if (is_same) {
        instance.place(placement);
    } else {
        patch_count_ += patches_of(model) - patches_of(instance.model());
        curved_count_ -= instance.model().is_exact() ? 0 : 1;
        curved_count_ += model.is_exact() ? 0 : 1;
        transparent_count_ -= instance.opacity() < 1 ? 1 : 0;
        instance = l3d_patch_instance(model, placement);
        knows_materials_ = false;
    }
    boxes_.set(index, instance.box());
    extent_count_ = 0;
}

/// Notes a change of an instance. At its first change, the instance's box is kept in moved_from_.
void l3d_patch_scene::note_change(std::size_t index) {
    if (is_moved_[index])
        return;
    is_moved_[index] = true;
    moved_.push_back(index);
    moved_from_.add(instances_[index].box());
}

void l3d_patch_scene::paint(std::size_t index, const std::optional<l3d_material>& material) {
    if (instances_.at(index).material() == material)
        return;
    note_change(index);
    instances_[index].paint(material);
    knows_materials_ = false;
}

void l3d_patch_scene::lay(std::size_t index, const l3d_laid_picture& picture) {
    l3d_patch_instance& instance = instances_.at(index);
    const std::size_t pieces = picture.pieces.size();
    if (pieces != 0 && pieces != instance.model().pieces())
        throw l3d_error(l3d_exit::failure, "picture: corners for " + std::to_string(pieces) +
                                               " patches of " +
                                               std::to_string(instance.model().pieces()));
    if (instance.picture() == picture)
        return;
    note_change(index);
    instance.lay(picture);
    knows_materials_ = false;
}

bool l3d_patch_scene::has_pictures() const {
    return std::ranges::any_of(
        instances_, [](const l3d_patch_instance& i) { return i.picture().texture != nullptr; });
}

bool l3d_patch_scene::has_trims() const {
    return std::ranges::any_of(instances_,
                               [](const l3d_patch_instance& i) { return i.model().has_trims(); });
}

bool l3d_patch_scene::has_curves() const {
    return std::ranges::any_of(
        instances_, [](const l3d_patch_instance& i) { return !i.model().curves().empty(); });
}

void l3d_patch_scene::set_opacity(std::size_t index, double opacity) {
    l3d_patch_instance& instance = instances_.at(index);
    if (!(opacity >= 0 && opacity <= 1))
        throw l3d_error(l3d_exit::failure,
                        l3d_detail::formatted("opacity: %f is not from 0 to 1", opacity));
    if (opacity == instance.opacity())
        return;
    const std::size_t others = transparent_count_ - (instance.opacity() < 1 ? 1 : 0);
    const std::size_t count = others + (opacity < 1 ? 1 : 0);
    if (count > most_transparent)
        throw l3d_error(l3d_exit::failure, "opacity: more than " +
                                               std::to_string(most_transparent) +
                                               " instances would be transparent");
    note_change(index);
    instance.set_opacity(opacity);
    transparent_count_ = count;
}

void l3d_patch_scene::add_by_opacity(const l3d_patch_model& model,
                                     const l3d_matrix<double>& placement) {
    std::vector<float> opacities = model.opacities();
    const bool is_opaque = std::ranges::all_of(opacities, [](float o) { return o == 1; });
    const std::size_t room = most_transparent - transparent_count_;
    if (is_opaque || room == 0)
        return add(model, placement);
    std::ranges::sort(opacities);
    const auto below_1 =
        static_cast<std::size_t>(std::ranges::count_if(opacities, [](float o) { return o < 1; }));
    if (below_1 > room) {
        // Opacities above (i - 1) / room, up to i / room, share an instance of opacity i / room.
        // The last one is opaque.
        opacities.clear();
        for (std::size_t i = 0; i <= room; ++i)
            opacities.push_back(static_cast<float>(i) / static_cast<float>(room));
    }
    float above = -1;
    for (const float opacity : opacities) {
        const l3d_patch_model part = model.of_opacity(std::nextafter(above, 2.0F), opacity);
        above = opacity;
        if (part.patches().empty())
            continue;
        add(part, placement);
        set_opacity(instances_.size() - 1, double{opacity});
    }
}

l3d_patch_scene l3d_patch_scene::only(std::span<const std::size_t> indices) const {
    l3d_patch_scene result;
    const std::span<const l3d_material> all = materials();
    for (const std::size_t index : indices) {
        const l3d_patch_instance& instance = result.instances_.emplace_back(instances_[index]);
        result.instances_.back().set_opacity(1);
        result.boxes_.add(instance.box());
        result.patch_count_ += patches_of(instance.model());
        result.is_moved_.push_back(false);
        if (!all.empty())
            result.first_materials_.push_back(first_materials_[index]);
    }
    result.materials_.assign(all.begin(), all.end());
    return result;
}

/// Collects the materials of all instances. Instances of one model share its materials.
std::span<const l3d_material> l3d_patch_scene::materials() const {
    if (knows_materials_)
        return materials_;
    knows_materials_ = true;
    materials_.clear();
    first_materials_.clear();
    const auto is_plain = [](const l3d_patch_instance& i) {
        return i.material() ? i.material()->is_plain() : i.model().materials().empty();
    };
    if (std::ranges::all_of(instances_, is_plain) && !has_pictures())
        return materials_;
    materials_.emplace_back(); // the material of all plain instances
    std::map<const void*, std::uint32_t> firsts;
    for (const l3d_patch_instance& instance : instances_) {
        const auto next = static_cast<std::uint32_t>(materials_.size());
        if (is_plain(instance)) {
            first_materials_.push_back(0);
        } else if (instance.material()) {
            first_materials_.push_back(next);
            materials_.push_back(*instance.material());
        } else {
            const l3d_patch_model& model = instance.model();
            const auto [place, is_new] = firsts.try_emplace(model.paint_identity(), next);
            if (is_new)
                materials_.insert(materials_.end(), model.materials().begin(),
                                  model.materials().end());
            first_materials_.push_back(place->second);
        }
    }
    return materials_;
}

/// The box of all instances. Each call adds the instances that were added to the scene since the
/// last call. After an instance was moved, all instances are looked at, since the box without the
/// moved instance is unknown.
const l3d_patch_scene::whole& l3d_patch_scene::extent() const {
    if (extent_count_ == 0)
        extent_ = {};
    for (; extent_count_ < instances_.size(); ++extent_count_) {
        const l3d_patch_instance& instance = instances_[extent_count_];
        const l3d_slanted_box box = instance.box();
        for (int i = 0; i < 3; ++i) {
            const double half =
                std::abs(box.axes[0][i]) + std::abs(box.axes[1][i]) + std::abs(box.axes[2][i]);
            const double low = box.centre[i] - half, high = box.centre[i] + half;
            const bool is_first = extent_count_ == 0;
            extent_.least[i] = is_first ? low : std::min(extent_.least[i], low);
            extent_.most[i] = is_first ? high : std::max(extent_.most[i], high);
        }
        extent_.reach = std::max(extent_.reach, box.reach);
    }
    return extent_;
}

void l3d_patch_scene::clear() {
    instances_.clear();
    boxes_.clear();
    patch_count_ = 0;
    transparent_count_ = curved_count_ = 0;
    extent_ = {};
    extent_count_ = 0;
    knows_materials_ = false;
    forget_changes();
    is_moved_.clear();
    is_rebuilt_ = true;
}

void l3d_patch_scene::forget_changes() {
    for (const std::size_t index : moved_)
        is_moved_[index] = false;
    moved_.clear();
    moved_from_.clear();
    is_rebuilt_ = false;
}
