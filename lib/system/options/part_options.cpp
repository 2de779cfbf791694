// SPDX-License-Identifier: MIT
// l3d_part_options: declares the options, and makes models of the parts that they choose.
#include "system/options/part_options.h"

#include "base/counted_p.h"
#include "base/printable_p.h"
#include "system/options/color_text_p.h"
#include "system/options/number_text.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <map>
#include <span>
#include <string>

namespace {

[[noreturn]] void refuse(const std::string& why) {
    throw l3d_error(l3d_exit::usage, why);
}

std::size_t found(const l3d_parts& parts, const char* option, const std::string& name) {
    if (const std::string why = parts.complaint(name); !why.empty())
        refuse(std::string(option) + ": " + why);
    return *parts.find(name);
}

std::vector<std::size_t> all_found(const l3d_parts& parts, const char* option,
                                   const std::vector<std::string>& names) {
    std::vector<std::size_t> result;
    for (const std::string& name : names)
        result.push_back(found(parts, option, name));
    return result;
}

bool is_empty(const l3d_patch_model& model) {
    return model.patches().empty();
}

bool is_empty(const l3d_polygon_model& model) {
    return model.triangles().empty();
}

} // namespace

l3d_part_options::l3d_part_options(l3d_options& options) {
    options.begin_group("Parts");
    options.add("--list-parts", lists_, "draw nothing; list the named parts of the model");
    options.add_each("--hide", "leave out a part of the model; may be given for several", "PART",
                     "", [this](const std::string& name) { hidden_.push_back(name); });
    options.add_each("--show-only",
                     "leave out all but this part of the model; may be given for several", "PART",
                     "", [this](const std::string& name) { shown_.push_back(name); });
    options.add_each("--color",
                     "part of the model and its colour, as lid=orange; may be given for several",
                     "PART_COLOR", "", [this](const std::string& text) { add_color(text); });
    options.add_each("--opacity",
                     "part of a model of patches and how opaque it is, as lid=0.4: 0 is not there, "
                     "1 hides all behind it; may be given for several",
                     "PART_OPACITY", "", [this](const std::string& text) { add_opacity(text); });
    options.has_result("--list-parts");
}

/// Adds a part's colour. The last equals sign separates the two, as only names may have some.
void l3d_part_options::add_color(const std::string& text) {
    const std::size_t at = text.rfind('=');
    const bool has_both = at != text.npos && at > 0;
    const auto color = l3d_detail::read_paint(has_both ? text.substr(at + 1) : "");
    if (!color)
        refuse("--color: '" + l3d_detail::printable(text) + "' is not PART=COLOR with " +
               l3d_detail::color_forms +
               (has_both ? l3d_detail::meant_color(text.substr(at + 1)) : ""));
    colors_.push_back({text.substr(0, at), *color});
}

void l3d_part_options::add_opacity(const std::string& text) {
    const std::size_t at = text.rfind('=');
    std::array<double, 1> value{};
    const bool is_opacity = at != text.npos && at > 0 &&
                            l3d_read_numbers(std::string_view(text).substr(at + 1), ',', value) &&
                            value[0] >= 0 && value[0] <= 1;
    if (!is_opacity)
        refuse("--opacity: '" + l3d_detail::printable(text) +
               "' is not PART=A with a number A from 0 to 1");
    opacities_.push_back({text.substr(0, at), value[0]});
}

void l3d_part_options::list(const l3d_parts& parts, std::string_view things) {
    if (parts.names().empty())
        std::cout << "no parts\n";
    for (std::size_t i = 0; i < parts.names().size(); ++i)
        std::cout << l3d_detail::printable(parts.names()[i]) << ": "
                  << l3d_detail::counted(parts.size_of(i), things) << '\n';
    if (!std::cout.flush())
        throw l3d_error(l3d_exit::failure, "cannot write to the standard output");
}

template <class Model> Model l3d_part_options::applied_to(const Model& model) const {
    Model result = model;
    for (const colored& color : colors_)
        result = result.part_painted(found(model.parts(), "--color", color.part),
                                     {.color = color.color});
    const auto shown = all_found(model.parts(), "--show-only", shown_);
    std::vector<std::size_t> hidden = all_found(model.parts(), "--hide", hidden_);
    if (shown.empty() && hidden.empty())
        return result;
    std::vector<std::size_t> kept;
    for (const std::size_t part : shown)
        if (std::ranges::find(hidden, part) == hidden.end())
            kept.push_back(part);
    result = shown.empty() ? result.without(hidden) : result.only(kept);
    if (is_empty(result))
        refuse("--hide: nothing of the model is left");
    return result;
}

/// The scene of a model. A part's last opacity counts, in place of those of its materials. A hidden
/// part has none.
l3d_patch_scene l3d_part_options::scene(const l3d_patch_model& model) const {
    for (const opacity& o : opacities_)
        found(model.parts(), "--opacity", o.part);
    return of_shown(applied(model));
}

l3d_patch_scene l3d_part_options::scene_by_opacity(const l3d_patch_model& model) const {
    for (const opacity& o : opacities_)
        found(model.parts(), "--opacity", o.part);
    return of_shown(model);
}

l3d_patch_scene l3d_part_options::of_shown(const l3d_patch_model& whole) const {
    std::map<std::size_t, double> by_part;
    for (const opacity& o : opacities_)
        if (const auto part = whole.parts().find(o.part))
            by_part[*part] = o.value;
    l3d_patch_scene result;
    if (by_part.empty()) {
        result.add_by_opacity(whole);
        return result;
    }
    if (by_part.size() > l3d_patch_scene::most_transparent)
        refuse("--opacity: more than " + std::to_string(l3d_patch_scene::most_transparent) +
               " parts");
    std::vector<std::size_t> apart;
    for (const auto& [part, value] : by_part) {
        apart.push_back(part);
        result.add(whole.only(std::span(&part, 1)));
        result.set_opacity(result.instances().size() - 1, value);
    }
    if (const l3d_patch_model rest = whole.without(apart); !is_empty(rest))
        result.add_by_opacity(rest);
    return result;
}

l3d_patch_model l3d_part_options::applied(const l3d_patch_model& model) const {
    return applied_to(model);
}

l3d_polygon_model l3d_part_options::applied(const l3d_polygon_model& model) const {
    refuse_for_polygons();
    return applied_to(model);
}

void l3d_part_options::refuse_for_polygons() const {
    if (!opacities_.empty())
        refuse("--opacity: polygons are opaque; only --pipeline afd, which draws patches, has it");
}

void l3d_part_options::put_into(l3d_part_list& list, const l3d_parts& parts) const {
    const auto shown = all_found(parts, "--show-only", shown_);
    const auto hidden = all_found(parts, "--hide", hidden_);
    for (const colored& color : colors_)
        found(parts, "--color", color.part);
    const auto has = [](const std::vector<std::size_t>& indices, std::size_t part) {
        return std::ranges::find(indices, part) != indices.end();
    };
    for (std::size_t i = 0; i < parts.names().size(); ++i) {
        l3d_listed_part part{.name = parts.names()[i]};
        part.is_hidden = has(hidden, i) || (!shown.empty() && !has(shown, i));
        for (const colored& color : colors_)
            if (color.part == part.name)
                part.color = color.color;
        list.set(part);
    }
}
