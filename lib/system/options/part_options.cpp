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
#include <set>
#include <span>
#include <string>

namespace {

[[noreturn]] void refuse(const std::string& why) {
    throw l3d_error(l3d_exit::usage, why);
}

void check_name(const l3d_parts& parts, const char* option, const std::string& name) {
    if (const std::string why = parts.complaint(name); !why.empty())
        refuse(std::string(option) + ": " + why);
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

/// Adds a colour from a text PART=COLOR. The last equals sign separates part and colour, since only
/// names of parts may have equals signs.
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

/// Refuses names of --color, --show-only and --hide that are no parts.
void l3d_part_options::check(const l3d_parts& parts) const {
    for (const colored& color : colors_)
        check_name(parts, "--color", color.part);
    for (const std::string& name : shown_)
        check_name(parts, "--show-only", name);
    for (const std::string& name : hidden_)
        check_name(parts, "--hide", name);
}

void l3d_part_options::check_opacities(const l3d_parts& parts) const {
    std::set<std::string> names;
    for (const opacity& o : opacities_) {
        check_name(parts, "--opacity", o.part);
        names.insert(o.part);
    }
    if (names.size() > l3d_patch_scene::most_transparent)
        refuse("--opacity: more than " + std::to_string(l3d_patch_scene::most_transparent) +
               " parts");
}

/// The model with --color, --hide and --show-only applied, as far as it has the named parts. The
/// result may be empty.
template <class Model> Model l3d_part_options::as_asked(const Model& model) const {
    Model result = model;
    for (const colored& color : colors_)
        if (const auto part = model.parts().find(color.part))
            result = result.part_painted(*part, {.color = color.color});
    std::vector<std::size_t> hidden, kept;
    for (const std::string& name : hidden_)
        if (const auto part = model.parts().find(name))
            hidden.push_back(*part);
    for (const std::string& name : shown_)
        if (const auto part = model.parts().find(name);
            part && std::ranges::find(hidden, *part) == hidden.end())
            kept.push_back(*part);
    if (!shown_.empty())
        return result.only(kept);
    return hidden.empty() ? result : result.without(hidden);
}

template <class Model> Model l3d_part_options::applied_to(const Model& model) const {
    check(model.parts());
    Model result = as_asked(model);
    if (is_empty(result) && !is_empty(model))
        refuse("--hide: nothing of the model is left");
    return result;
}

l3d_patch_scene l3d_part_options::scene(const l3d_patch_scene& whole) const {
    const l3d_parts parts = whole.parts();
    check_opacities(parts);
    check(parts);
    l3d_patch_scene result;
    bool was_empty = true;
    for (const l3d_patch_instance& instance : whole.instances()) {
        was_empty = was_empty && is_empty(instance.model());
        const l3d_patch_model model = as_asked(instance.model());
        if (!is_empty(model))
            add_by_opacity({model, instance.placement()}, result);
    }
    if (result.instances().empty() && !was_empty)
        refuse("--hide: nothing of the model is left");
    return result;
}

l3d_patch_scene l3d_part_options::scene_by_opacity(const l3d_patch_scene& whole) const {
    check_opacities(whole.parts());
    l3d_patch_scene result;
    for (const l3d_patch_instance& instance : whole.instances())
        add_by_opacity(instance, result);
    return result;
}

/// Divides `whole` by opacity, and adds the results to the scene `to`. Each part that --opacity
/// names becomes an instance. The rest is divided by the opacities of its materials, as
/// l3d_patch_scene::add_by_opacity does. If a part is named twice, the last opacity counts. Parts
/// that the model does not have, such as hidden ones, add nothing.
void l3d_part_options::add_by_opacity(const l3d_patch_instance& whole, l3d_patch_scene& to) const {
    std::map<std::size_t, double> by_part;
    for (const opacity& o : opacities_)
        if (const auto part = whole.model().parts().find(o.part))
            by_part[*part] = o.value;
    if (by_part.empty())
        return to.add_by_opacity(whole.model(), whole.placement());
    std::vector<std::size_t> apart;
    for (const auto& [part, value] : by_part) {
        apart.push_back(part);
        to.add(whole.model().only(std::span(&part, 1)), whole.placement());
        to.set_opacity(to.instances().size() - 1, value);
    }
    if (const l3d_patch_model rest = whole.model().without(apart); !is_empty(rest))
        to.add_by_opacity(rest, whole.placement());
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
    check(parts);
    const auto has = [](const std::vector<std::string>& names, const std::string& name) {
        return std::ranges::find(names, name) != names.end();
    };
    for (std::size_t i = 0; i < parts.names().size(); ++i) {
        l3d_listed_part part{.name = parts.names()[i]};
        part.is_hidden = has(hidden_, part.name) || (!shown_.empty() && !has(shown_, part.name));
        for (const colored& color : colors_)
            if (color.part == part.name)
                part.color = color.color;
        list.set(part);
    }
}
