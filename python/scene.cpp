// SPDX-License-Identifier: MIT
// Scenes: models of patches, each at places of its own.
#include "docs.h"
#include "types.h"

#include <l3d/error.h>
#include <l3d/plugin_loader.h>
#include <l3d/polygon_view.h>
#include <l3d/texture.h>

#include <fstream>

namespace python {

namespace {

const l3d_patch_model& patches_of(const arguments& a, const char* name) {
    const auto& model = a.object<l3d_any_model>(name);
    if (const auto* patches = std::get_if<l3d_patch_model>(&model))
        return *patches;
    throw value_error(a.what(name) +
                      ": a scene holds models of patches, and this one has polygons");
}

/// A matrix, or a size, a turn and a move, one after the other.
l3d_matrix<double> placement_of(const arguments& a) {
    if (PyObject* matrix = a.find("placement")) {
        if (a.find("at") || a.find("turn") || a.find("scale"))
            throw type_error(a.what("placement") + ": a matrix says all of place, turn and scale");
        return matrix_of(matrix, a.what("placement"));
    }
    vector_3d at{0.0, 0.0, 0.0}, turn{0.0, 0.0, 0.0};
    a.read("at", at, vector_of, farthest);
    a.read("turn", turn, vector_of, 1e6); // degrees: beyond, doubles tell no small angles apart
    const double scale = a.number("scale", 1, 1 / farthest, farthest);
    l3d_matrix<double> scaled = l3d_identity<double>();
    for (int i = 0; i < 3; ++i)
        scaled(i, i) = scale;
    return l3d_translation<double>(at[0], at[1], at[2]) *
           l3d_euler_rotation(turn, {0.0, 0.0, 0.0}) * scaled;
}

std::size_t index_of(const scene& self, const arguments& a) {
    const auto count = static_cast<std::int64_t>(self.instances.instances().size());
    if (count == 0)
        throw value_error(a.what("index") + ": the scene is empty");
    return static_cast<std::size_t>(whole_of(a.need("index"), a.what("index"), 0, count - 1));
}

std::optional<l3d_material> material_of(const arguments& a) {
    if (!a.find("material"))
        return std::nullopt;
    return a.object<l3d_material>("material");
}

reference make_scene(arguments& a) {
    a.are("Scene", "model |");
    scene result;
    if (a.find("model"))
        result.instances.add(patches_of(a, "model"));
    return made(std::move(result));
}

reference load(arguments& a) {
    a.are("Scene.load", "file |");
    const std::string file = path_of(a.need("file"), a.what("file"));
    std::optional<l3d_any_scene> found;
    try {
        const unlocked while_reading;
        found = l3d_load_any_scene(l3d_data_file(file));
    } catch (const l3d_error& error) {
        throw file_failure{file, error.what(), !std::ifstream(l3d_data_file(file)).good()};
    }
    scene result;
    if (auto* instances = std::get_if<l3d_patch_scene>(&*found))
        result.instances = std::move(*instances);
    else
        throw file_failure{
            file, file + ": a scene holds models of patches, and this file has polygons", false};
    return made(std::move(result));
}

reference add(scene& self, arguments& a) {
    a.are("Scene.add", "model placement | at turn scale material opacity");
    l3d_patch_scene& instances = self.instances;
    const auto material = material_of(a);
    const double opacity = a.number("opacity", 1, 0, 1);
    if (opacity < 1 && instances.transparent_count() == l3d_patch_scene::most_transparent)
        throw value_error(a.what("opacity") + ": 8 transparent instances are the most");
    instances.add(patches_of(a, "model"), placement_of(a)); // all that may fail comes before
    ++self.changes;
    const std::size_t index = instances.instances().size() - 1;
    instances.paint(index, material);
    instances.set_opacity(index, opacity);
    return number(static_cast<std::int64_t>(index));
}

reference place(scene& self, arguments& a) {
    a.are("Scene.place", "index placement | at turn scale");
    self.instances.place(index_of(self, a), placement_of(a));
    ++self.changes;
    return reference::none();
}

reference paint(scene& self, arguments& a) {
    a.are("Scene.paint", "index material |");
    self.instances.paint(index_of(self, a), material_of(a));
    ++self.changes;
    return reference::none();
}

reference set_opacity(scene& self, arguments& a) {
    a.are("Scene.set_opacity", "index opacity |");
    const double opacity = number_of(a.need("opacity"), a.what("opacity"), 0, 1);
    self.instances.set_opacity(index_of(self, a), opacity);
    ++self.changes;
    return reference::none();
}

reference lay(scene& self, arguments& a) {
    a.are("Scene.lay", "index picture |");
    const std::size_t index = index_of(self, a);
    l3d_laid_picture laid;
    if (a.find("picture"))
        laid.texture =
            std::make_shared<const l3d_texture>(a.object<picture>("picture").image->pixels());
    self.instances.lay(index, laid);
    ++self.changes;
    return reference::none();
}

reference clear(scene& self, arguments& a) {
    a.are("Scene.clear", "");
    self.instances.clear();
    ++self.changes;
    return reference::none();
}

reference png(scene& self, arguments& a) {
    a.are("Scene._repr_png_", "");
    const picture shown = shown_picture(self);
    return png_of(shown.image->pixels(), shown.is_transparent);
}

reference bounds(const scene& self) {
    return reference::taken(PyTuple_Pack(2, numbers(self.instances.least()).get(),
                                         numbers(self.instances.most()).get()));
}

Py_ssize_t length(PyObject* self) {
    return static_cast<Py_ssize_t>(value_of<scene>(self).instances.instances().size());
}

reference scene_text(const scene& self) {
    return text("<l3d.Scene: " + std::to_string(self.instances.instances().size()) +
                " instances, " + std::to_string(self.instances.patch_count()) + " patches>");
}

} // namespace

PyTypeObject* add_scene_type(PyObject* module) {
    static PyMethodDef methods[] = {
        function<load>("load", doc("Scene.load"), METH_STATIC),
        method<scene, add>("add", doc("Scene.add")),
        method<scene, place>("place", doc("Scene.place")),
        method<scene, paint>("paint", doc("Scene.paint")),
        method<scene, set_opacity>("set_opacity", doc("Scene.set_opacity")),
        method<scene, lay>("lay", doc("Scene.lay")),
        method<scene, clear>("clear", doc("Scene.clear")),
        method<scene, png>("_repr_png_", doc("Scene._repr_png_")),
        {}};
    static PyGetSetDef attributes[] = {attribute<scene, bounds>("bounds", doc("Scene.bounds")), {}};
    return new_type<scene>(module, "l3d.Scene", doc("Scene"), methods, attributes,
                           {slot(Py_tp_new, construct<make_scene>), slot(Py_sq_length, length),
                            slot(Py_tp_repr, call_text<scene, scene_text>)});
}

} // namespace python
