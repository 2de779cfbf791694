// SPDX-License-Identifier: MIT
// Settings read from keyword arguments.
#include "look.h"

#include "types.h"

#include <algorithm>

namespace python {

namespace {

/// Refuses settings that only the other kind of frames has.
void refuse(const arguments& a, std::initializer_list<const char*> names, const char* why) {
    for (const char* name : names)
        if (a.find(name))
            throw value_error(a.what(name) + ": " + why);
}

l3d_background background_of(PyObject* value, const std::string& what) {
    const bool is_pair = PyTuple_Check(value) && PyTuple_Size(value) == 2;
    if (!is_pair)
        return l3d_background::color(color_of(value, what));
    return {color_of(PyTuple_GetItem(value, 0), what), color_of(PyTuple_GetItem(value, 1), what)};
}

/// Two distances, and a colour behind them if it is not that of the background.
l3d_fog fog_of(PyObject* value, const std::string& what) {
    if (!PyTuple_Check(value) || PyTuple_Size(value) < 2 || PyTuple_Size(value) > 3)
        throw type_error(what + ": a tuple (near, far) or (near, far, color) is wanted, not " +
                         shown(value));
    l3d_fog result;
    result.from = static_cast<float>(number_of(PyTuple_GetItem(value, 0), what, 0, farthest));
    result.to = static_cast<float>(number_of(PyTuple_GetItem(value, 1), what, 0, farthest));
    if (!(result.to > result.from))
        throw value_error(what + ": the first distance must be the nearer one");
    if (PyTuple_Size(value) == 3)
        result.color = color_of(PyTuple_GetItem(value, 2), what);
    return result;
}

void read_lights(const arguments& a, l3d_lighting& lighting) {
    a.read("light_color", lighting.color, light_color_of);
    a.read("ambient", lighting.ambient, light_color_of);
    PyObject* given = a.find("lights");
    if (!given)
        return;
    lighting.count = lighting.point_count = 0;
    for (const light& one : list_of<light>(given, a.what("lights"))) {
        const auto* far = std::get_if<l3d_far_light>(&one);
        if (lighting.count == l3d_lighting::most_further && far)
            throw value_error(a.what("lights") + ": 7 with a direction are the most");
        if (lighting.point_count == l3d_lighting::most_points && !far)
            throw value_error(a.what("lights") + ": 8 with a position are the most");
        if (far)
            lighting.lights[lighting.count++] = *far;
        else
            lighting.add_point(std::get<l3d_point_light>(one));
    }
}

/// Shades come in the order of l3d_shade_names, first those that polygons have, too.
void read_shade(const arguments& a, l3d_shade& shade, std::size_t count) {
    std::vector<std::string_view> names;
    for (const auto& [name, value] : l3d_shade_names)
        names.emplace_back(name);
    names.resize(count);
    if (PyObject* value = a.find("shade"))
        shade = l3d_shade_names[choice_of(value, a.what("shade"), names)].second;
}

/// The settings that all frames have.
template <class Settings> void read_common(const arguments& a, Settings& settings) {
    a.read("light", settings.light, vector_of, farthest);
    if (!(l3d_length(settings.light) > 0))
        throw value_error(a.what("light") + ": zero is no direction");
    read_lights(a, settings.lighting);
    a.read("headlight", settings.headlight, flag_of);
    a.read("antialias", settings.antialias, flag_of);
    a.read("fog", settings.fog, fog_of);
    if (a.given("background") == Py_None)
        settings.background = l3d_background::none();
    a.read("background", settings.background, background_of);
    if (settings.fog.is_on() && !settings.fog.color && settings.background.is_none())
        throw value_error(a.what("fog") + ": without a background it needs a colour");
    a.read("count_pixels", settings.count_pixels, flag_of);
    if (PyObject* value = a.find("threads"))
        settings.threads =
            static_cast<int>(whole_of(value, a.what("threads"), 1, l3d_most_threads));
}

/// A curve, or a tuple of a curve, a colour and a width.
l3d_space_curve curve_of(PyObject* value, const std::string& what) {
    if (is_a<l3d_nurbs_curve>(value))
        return l3d_space_curve(value_of<l3d_nurbs_curve>(value));
    if (!PyTuple_Check(value) || PyTuple_Size(value) < 1 || PyTuple_Size(value) > 3)
        throw type_error(what + ": a Curve or a tuple (curve, color, width) is wanted, not " +
                         shown(value));
    const auto& curve = object_of<l3d_nurbs_curve>(PyTuple_GetItem(value, 0), what);
    const bool has_color = PyTuple_Size(value) > 1, has_width = PyTuple_Size(value) > 2;
    const std::uint32_t color = has_color ? color_of(PyTuple_GetItem(value, 1), what) : 0xffffff;
    const double width =
        has_width ? number_of(PyTuple_GetItem(value, 2), what, 0, l3d_space_curve::most_width) : 1;
    return l3d_space_curve(curve, color, width);
}

} // namespace

l3d_light_color light_color_of(PyObject* value, const std::string& what) {
    constexpr double brightest = 1e6;
    const auto numbers = numbers_of(value, what, 3, brightest);
    if (*std::ranges::min_element(numbers) < 0)
        throw value_error(what + ": no light takes light away");
    return {static_cast<float>(numbers[0]), static_cast<float>(numbers[1]),
            static_cast<float>(numbers[2])};
}

void read_look(const arguments& a, l3d_afd_settings& settings,
               std::vector<l3d_space_curve>& curves) {
    refuse(a, {"style", "rotation", "cull", "material"}, "only frames of polygons have it");
    settings.tolerance = a.number("tolerance", settings.tolerance, 1e-6, l3d_largest_side);
    settings.shade_tolerance = a.number("shade_tolerance", settings.shade_tolerance, 1e-6, 255);
    a.read("lateral_only", settings.lateral_only, flag_of);
    read_shade(a, settings.shade, l3d_shade_names.size());
    if (PyObject* value = a.find("inspection_direction")) {
        const vector_3d to = vector_of(value, a.what("inspection_direction"));
        settings.inspection.direction = {to[0], to[1], to[2]};
    }
    auto& inspection = settings.inspection;
    inspection.scale = a.number("inspection_scale", inspection.scale, 0, farthest);
    inspection.stripe = a.number("inspection_stripe", inspection.stripe, 0, 180);
    read_common(a, settings);
    a.read("wireframe", settings.wireframe, flag_of);
    a.read("net", settings.net, flag_of);
    a.read("one_sided", settings.one_sided, flag_of);
    a.read("depth", settings.depth, flag_of);
    a.read("error_map", settings.error_map, flag_of);
    if (PyObject* value = a.find("most_samples"))
        settings.most_samples =
            whole_of(value, a.what("most_samples"), 0, std::numeric_limits<std::int64_t>::max());
    if (PyObject* value = a.find("curves")) {
        if (PySequence_Check(value) == 0 || PyUnicode_Check(value))
            throw type_error(a.what("curves") + ": a list is wanted, not " + shown(value));
        curves.clear();
        for (Py_ssize_t i = 0; i < PySequence_Size(value); ++i)
            curves.push_back(curve_of(reference::taken(PySequence_GetItem(value, i)).get(),
                                      a.what("curves") + "[" + std::to_string(i) + "]"));
    }
}

void read_look(const arguments& a, l3d_polygon_settings& settings) {
    refuse(a,
           {"tolerance", "shade_tolerance", "lateral_only", "inspection_direction",
            "inspection_scale", "inspection_stripe", "wireframe", "net", "one_sided", "depth",
            "most_samples", "error_map", "curves"},
           "only frames of patches have it");
    read_shade(a, settings.shade, l3d_shades_of_normals);
    read_common(a, settings);
    read_choice(a, "style", settings.style, style_names);
    a.read("rotation", settings.rotation, vector_of, 1e6); // degrees, as in Scene.add
    a.read("cull", settings.cull, flag_of);
    if (a.find("material"))
        settings.material = a.object<l3d_material>("material");
}

} // namespace python
