// SPDX-License-Identifier: MIT
// l3d_part_switch: puts models without their hidden parts in place of the whole ones.
#include "pipeline/part_switch.h"

#include "base/printable_p.h"

#include <algorithm>
#include <optional>

namespace {

const char* const without_parts = "the model has no named parts";

/// A model without the parts of these names.
l3d_patch_model without(const l3d_patch_model& model, const std::vector<std::string>& names) {
    std::vector<std::size_t> parts;
    for (const std::string& name : names)
        if (const auto found = model.parts().find(name))
            parts.push_back(*found);
    return parts.empty() ? model : model.without(parts);
}

} // namespace

/// Notes the parts of all models; models placed since the last call are whole.
void l3d_part_switch::note_parts() {
    const auto instances = scene_.instances();
    instances_.resize(instances.size());
    names_.clear();
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const l3d_patch_model& now = instances[i].model();
        const l3d_patch_model& placed = instances_[i].shown;
        if (now.source_identity() != placed.source_identity() ||
            now.paint_identity() != placed.paint_identity())
            instances_[i] = {now, now};
        for (const std::string& name : instances_[i].whole.parts().names())
            if (std::ranges::find(names_, name) == names_.end())
                names_.push_back(name);
    }
}

bool l3d_part_switch::is_hidden(const std::string& name) const {
    return std::ranges::find(hidden_, name) != hidden_.end();
}

std::string l3d_part_switch::choose_next() {
    note_parts();
    if (names_.empty())
        return without_parts;
    const auto at = std::ranges::find(names_, chosen_);
    const bool is_last = at == names_.end() || at + 1 == names_.end();
    const auto next = is_last ? names_.begin() : at + 1;
    chosen_ = *next;
    return "part " + std::to_string(next - names_.begin() + 1) + " of " +
           std::to_string(names_.size()) + ": " + l3d_detail::printable(chosen_) +
           (is_hidden(chosen_) ? ", hidden" : "");
}

std::string l3d_part_switch::switch_chosen() {
    note_parts();
    if (std::ranges::find(names_, chosen_) == names_.end())
        choose_next();
    if (names_.empty())
        return without_parts;
    const std::string name = l3d_detail::printable(chosen_);
    if (is_hidden(chosen_)) {
        std::erase(hidden_, chosen_);
        place_shown();
        return name + " is shown";
    }
    hidden_.push_back(chosen_);
    if (shows_nothing()) {
        hidden_.pop_back();
        return name + " stays: without it nothing is left";
    }
    place_shown();
    return name + " is hidden";
}

void l3d_part_switch::show_all() {
    note_parts();
    hidden_.clear();
    place_shown();
}

bool l3d_part_switch::shows_nothing() const {
    return std::ranges::all_of(instances_, [&](const taken& each) {
        return without(each.whole, hidden_).patches().empty();
    });
}

/// Another model takes an instance's material and opacity away, which are kept here.
void l3d_part_switch::place_shown() {
    for (std::size_t i = 0; i < instances_.size(); ++i) {
        taken& each = instances_[i];
        const l3d_patch_instance& before = scene_.instances()[i];
        const l3d_patch_model now = without(each.whole, hidden_);
        if (now.pieces() == before.model().pieces())
            continue;
        const std::optional<l3d_material> material = before.material();
        const double opacity = before.opacity();
        scene_.place(i, now, before.placement());
        scene_.paint(i, material);
        scene_.set_opacity(i, opacity);
        each.shown = now;
    }
}
