// SPDX-License-Identifier: MIT
// l3d_pipeline_afd_viewer: handles the keys for patches, and writes their lines of the status.
#include "pipeline/pipeline_afd_viewer.h"

#include "base/counted_p.h"
#include "base/formatted_p.h"
#include "base/printable_p.h"
#include "dice/error_color.h"
#include "scene/camera.h"
#include "scene/measured_place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>

namespace {

using l3d_detail::counted;
using l3d_detail::formatted;

constexpr double least_tolerance = 1.0 / 64, largest_tolerance = 64;

} // namespace

std::vector<l3d_viewer_row> l3d_pipeline_afd_viewer::own_rows() {
    const auto finer = [this] { scale_tolerance(0.5); };
    return {
        {"+, -",
         "finer, coarser",
         {{'+', finer}, {'=', finer}, {'-', [this] { scale_tolerance(2); }}}},
        {"c", "shading", {{'c', [this] { take_next_shade(); }}}},
        {"i", "inspect curvature, stripes", {{'i', [this] { take_next_inspection(); }}}},
        {"w", "wireframe", {{'w', [this] { switch_wireframe(); }}}},
        {"x", "line drawing", {{'x', [this] { settings().drawing = !settings().drawing; }}}},
        {"a", "smooth edges", {{'a', [this] { switch_antialias(); }}}},
        {"l",
         "light with the eye, in the world",
         {{'l', [this] { controls_.switch_headlight(settings().headlight); }}}},
        {"v", "perspective, parallel", {{'v', [this] { switch_projection(); }}}},
        {"n", "control nets", {{'n', [this] { settings().net = !settings().net; }}}},
        {"E", "edges as lines", {{'E', [this] { settings().edges = !settings().edges; }}}},
        {"e", "choose the next part", {{'e', [this] { tell_of_part(parts_.choose_next()); }}}},
        {"d", "hide or show that part", {{'d', [this] { tell_of_part(parts_.switch_chosen()); }}}}};
}

l3d_viewed l3d_pipeline_afd_viewer::viewed() {
    const auto framed = [this](const l3d_camera& camera) {
        return l3d_framed(camera, screen().pixels().size(), l3d_reach_of(scene()));
    };
    const auto place_at = [this](double x, double y) -> std::optional<l3d_pointed_place> {
        const auto found = pick(x, y);
        if (!found)
            return std::nullopt;
        const l3d_measured_place place = l3d_measured(scene(), *found);
        const std::string radii = place.radii();
        return l3d_pointed_place{place.point, place.point_error,
                                 found->line() + (radii.empty() ? "" : "; " + radii), place.normal,
                                 place.normal_error};
    };
    return {.framed = framed, .place_at = place_at};
}

void l3d_pipeline_afd_viewer::scale_tolerance(double factor) {
    settings().tolerance =
        std::clamp(settings().tolerance * factor, least_tolerance, largest_tolerance);
    controls_.say("error at most " + counted(formatted("%.3g", settings().tolerance), "pixels"));
}

/// Takes the next shade. It skips `error` if the method has no bound of the error, and skips the
/// inspecting shades, which have a key of their own.
void l3d_pipeline_afd_viewer::take_next_shade() {
    const std::size_t count = l3d_shades_of_normals + settings().method.has_bound();
    const std::size_t after = static_cast<std::size_t>(settings().shade) + 1;
    const auto& next = l3d_shade_names[after < count ? after : 0];
    settings().shade = next.second;
    controls_.say(std::string("shading: ") + next.first +
                  (next.second == l3d_shade::error
                       ? formatted(", green 0 to red %.3g px", settings().tolerance)
                       : ""));
}

/// Takes the next inspecting shade. After the last inspecting shade, it takes the shade of light.
void l3d_pipeline_afd_viewer::take_next_inspection() {
    if (!settings().method.is_default())
        return controls_.say("no exact derivatives of " + settings().method.name());
    constexpr auto first = static_cast<std::size_t>(l3d_shade::zebra);
    const std::size_t after = static_cast<std::size_t>(settings().shade) + 1;
    const bool goes_on = l3d_is_inspection(settings().shade);
    const auto& next = l3d_shade_names[!goes_on                         ? first
                                       : after < l3d_shade_names.size() ? after
                                                                        : 0];
    settings().shade = next.second;
    controls_.say(std::string("shading: ") + next.first);
}

/// Shows or hides the wireframe. A wireframe shows the steps of dicing, so it is refused for
/// methods without dicing.
void l3d_pipeline_afd_viewer::switch_wireframe() {
    if (settings().method.is_default())
        settings().wireframe = !settings().wireframe;
    else
        controls_.say("no wireframe of " + settings().method.name());
}

void l3d_pipeline_afd_viewer::switch_antialias() {
    settings().antialias = !settings().antialias;
    controls_.say(settings().antialias ? "smooth edges" : "sharp edges");
}

void l3d_pipeline_afd_viewer::switch_projection() {
    if (settings().method.draws_parallel())
        controls_.switch_projection();
    else
        controls_.say("no parallel projection of " + settings().method.name());
}

/// Shows a line of text about a part. The picture marks the part as long as this line is shown.
void l3d_pipeline_afd_viewer::tell_of_part(std::string line) {
    controls_.say(std::move(line));
    marks_part_ = true;
}

void l3d_pipeline_afd_viewer::key_event(int key) {
    marks_part_ = false;
    if (controls_.key(key))
        redraw();
}

void l3d_pipeline_afd_viewer::pointer_event(const l3d_event& event) {
    if (controls_.pointer(event))
        redraw();
}

void l3d_pipeline_afd_viewer::resize_event(l3d_size size) {
    l3d_pipeline_afd::resize_event(size);
    controls_.resized();
}

void l3d_pipeline_afd_viewer::update_event(double seconds) {
    if (controls_.update(seconds))
        redraw();
}

void l3d_pipeline_afd_viewer::rest_event(double seconds) {
    if (controls_.rest(seconds))
        redraw();
}

/// Draws a frame and measures its time. A kept picture with new panels on top does not count.
void l3d_pipeline_afd_viewer::draw_event() {
    controls_.pace().begin();
    l3d_pipeline_afd::draw_event();
    if (last_report().pixels_kept < l3d_whole(screen().pixels().size()).area())
        controls_.pace().end();
}

void l3d_pipeline_afd_viewer::draw_panels() {
    if (screen().is_window())
        controls_.set_empty(
            last_report().dice.drawn == 0 && last_report().pixels_kept == 0 ? why_empty() : "");
    const l3d_panel key = legend();
    const l3d_standing_panel standing = standing_panel();
    screen().set_text({});
    if (!controls_.shows_text() && key.empty() && standing.panel.empty())
        return; // asking for the rasterizer makes the next frame clear the picture
    if (marks_part_)
        mark_part(parts_.chosen());
    const std::array lines{
        std::isfinite(bound())
            ? formatted("error at most %.3f pixels, of %.3g allowed", bound(), settings().tolerance)
            : "no bound of the error with " + settings().method.name()};
    controls_.draw(rasterizer(), lines, key, standing);
}

/// The scale of the shade's colours. Only windows show the scale of the error. Pictures in files
/// have the scale of an inspection if they ask for it.
l3d_panel l3d_pipeline_afd_viewer::legend() {
    l3d_panel result;
    const bool is_filled = !settings().wireframe && !settings().drawing;
    if (settings().shade == l3d_shade::error && is_filled && screen().is_window()) {
        result.add(error_scale_title());
        result.add_scale({l3d_error_color(0, 1), l3d_error_color(0.5, 1), l3d_error_color(1, 1)},
                         "0", formatted("%.3g", settings().tolerance));
    }
    if (l3d_is_inspection(settings().shade) && is_filled && settings().legend)
        add_inspection(result);
    return result;
}

void l3d_pipeline_afd_viewer::add_inspection(l3d_panel& panel) {
    const l3d_inspection shown = inspection();
    const auto number = [](double of) { return formatted("%.3g", of); };
    std::string first = number(-shown.scale), last = number(shown.scale);
    switch (settings().shade) {
    case l3d_shade::gaussian:
        panel.add("Gaussian curvature per square unit, 0 is white");
        break;
    case l3d_shade::mean:
        panel.add("mean curvature per unit, 0 is white");
        break;
    case l3d_shade::draft:
        panel.add("draft angle in degrees, 0 is yellow");
        break;
    case l3d_shade::zebra:
        panel.add("zebra: angle of the reflected ray, stripes of " +
                  counted(number(shown.stripe), "degrees"));
        break;
    default:
        panel.add("isophotes: angle to the light, stripes of " +
                  counted(number(shown.stripe), "degrees"));
        break;
    }
    if (settings().shade == l3d_shade::zebra || settings().shade == l3d_shade::isophotes) {
        first = "0";
        last = "180";
    }
    panel.add_scale(l3d_inspection_colors(settings().shade, shown), first, last);
}

l3d_part_list& l3d_part_switch::list() {
    const auto instances = scene_.instances();
    instances_.resize(instances.size());
    std::vector<std::string> names;
    std::unordered_set<std::string> known;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const l3d_patch_model& now = instances[i].model();
        const l3d_patch_model& placed = instances_[i].shown;
        if (now.source_identity() != placed.source_identity() ||
            now.paint_identity() != placed.paint_identity())
            instances_[i] = {now, now}; // placed since the last call, and still whole
        for (const std::string& name : instances_[i].whole.parts().names())
            if (known.insert(name).second)
                names.push_back(name);
    }
    list_.set_names(names);
    return list_;
}

/// The model `whole` in the colours of the list, without the parts that the list hides.
l3d_patch_model l3d_part_switch::as_listed(const l3d_patch_model& whole) const {
    l3d_patch_model result = whole;
    std::vector<std::size_t> hidden;
    for (const l3d_listed_part& part : list_.parts()) {
        if (!part.is_hidden && !part.color)
            continue;
        const std::optional<std::size_t> found = whole.parts().find(part.name);
        if (found && part.is_hidden)
            hidden.push_back(*found);
        else if (found)
            result = result.part_painted(*found, {.color = *part.color});
    }
    return hidden.empty() ? result : result.without(hidden);
}

/// Places the models as the list says. If nothing would be left, undoes the list's last change and
/// returns false. Placing a model drops the material and opacity of its instance, so this function
/// sets both again.
bool l3d_part_switch::apply() {
    list();
    std::vector<l3d_patch_model> models;
    for (const taken& each : instances_)
        models.push_back(as_listed(each.whole));
    const auto is_empty = [](const l3d_patch_model& model) { return model.patches().empty(); };
    if (!models.empty() && std::ranges::all_of(models, is_empty)) {
        list_.undo();
        return false;
    }
    for (std::size_t i = 0; i < models.size(); ++i) {
        taken& each = instances_[i];
        const l3d_patch_instance& before = scene_.instances()[i];
        if (models[i].source_identity() == each.shown.source_identity() &&
            models[i].paint_identity() == each.shown.paint_identity())
            continue;
        const std::optional<l3d_material> material = before.material();
        const double opacity = before.opacity();
        scene_.place(i, models[i], before.placement());
        scene_.paint(i, material);
        scene_.set_opacity(i, opacity);
        each.shown = models[i];
    }
    return true;
}

std::string l3d_part_switch::refusal() const {
    return l3d_detail::printable(chosen()) + " stays: without it nothing is left";
}

std::string l3d_part_switch::switch_chosen() {
    const std::string said = list().switch_chosen();
    return apply() ? said : refusal();
}

void l3d_part_switch::show_all() {
    list().show_all();
    apply();
}
