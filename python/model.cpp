// SPDX-License-Identifier: MIT
// Models: from files, names and arrays; their parts, and their numbers as arrays.
#include "docs.h"
#include "types.h"

#include <l3d/error.h>
#include <l3d/patch_file.h>
#include <l3d/plugin_loader.h>

#include <algorithm>
#include <cstring>
#include <fstream>

namespace python {

namespace {

using patches_model = l3d_patch_model;
using polygons_model = l3d_polygon_model;

static_assert(sizeof(vector_3d) == 3 * sizeof(double));
static_assert(sizeof(l3d_patch_model::patch) == 48 * sizeof(double));

/// The least weight that l3d_patch_model::from_patches takes.
constexpr double least_weight = 1e-100;

l3d_any_model named_model(const std::string& name) {
    if (name == "teapot")
        return l3d_patch_model::teapot();
    const std::string file = l3d_data_file(name);
    if (const bool is_file = std::ifstream(file).good(); !is_file)
        if (const auto shape = l3d_exact_shape(name))
            return l3d_patch_model::from_surfaces(*shape);
    return l3d_load_any_model(file);
}

reference load(arguments& a) {
    a.are("Model.load", "file |");
    const std::string file = path_of(a.need("file"), a.what("file"));
    std::optional<l3d_any_model> model;
    try {
        const unlocked while_reading;
        model = named_model(file);
    } catch (const l3d_error& error) {
        throw file_failure{file, error.what(), !std::ifstream(l3d_data_file(file)).good()};
    }
    return made(*std::move(model));
}

// ---- from arrays --------------------------------------------------------------------------------

/// A model of bicubic patches without weights, which may be millions.
l3d_any_model bicubic_model(const number_array& points) {
    std::vector<l3d_patch_model::patch> patches(points.shape()[0]);
    points.copy_to(reinterpret_cast<double*>(patches.data()), farthest);
    const unlocked while_bounding;
    return l3d_patch_model(std::move(patches));
}

l3d_any_model rational_model(const number_array& points, std::span<const double> weights) {
    const auto& shape = points.shape();
    const std::size_t each = shape[1] * shape[2];
    const std::vector<double> numbers = points.doubles(farthest);
    std::vector<l3d_patch_points> patches(shape[0]);
    for (std::size_t i = 0; i < patches.size(); ++i) {
        patches[i].degree_u = static_cast<int>(shape[2]) - 1;
        patches[i].degree_v = static_cast<int>(shape[1]) - 1;
        patches[i].points.resize(each);
        std::memcpy(patches[i].points.data(), &numbers[3 * each * i], 24 * each);
        if (!weights.empty())
            patches[i].weights.assign(&weights[each * i], &weights[each * i] + each);
    }
    std::string why;
    const auto model = l3d_patch_model::from_patches(patches, "Model.from_patches", why);
    if (!model)
        throw value_error(why);
    return *model;
}

reference from_patches(arguments& a) {
    a.are("Model.from_patches", "points weights |");
    const number_array points(a.need("points"), a.what("points"));
    points.expect({-1, -1, -1, 3});
    const auto& shape = points.shape();
    constexpr std::size_t most_points = l3d_bpt_largest_degree + 1;
    for (const std::size_t n : {shape[1], shape[2]})
        if (n < 2 || n > most_points)
            throw value_error(a.what("points") +
                              ": a patch has 2 to 16 control points along u and "
                              "along v, not " +
                              std::to_string(n));
    std::vector<double> weights;
    if (PyObject* given = a.find("weights")) {
        const number_array array(given, a.what("weights"));
        array.expect(
            {static_cast<int>(shape[0]), static_cast<int>(shape[1]), static_cast<int>(shape[2])});
        weights = array.doubles(farthest);
        if (std::ranges::any_of(weights, [](double weight) { return weight < least_weight; }))
            throw value_error(a.what("weights") + ": they must be above 0");
    }
    if (shape[1] == 4 && shape[2] == 4 && weights.empty())
        return made(bicubic_model(points));
    return made(rational_model(points, weights));
}

/// Faces as rows of an array, or as lists of any lengths.
void add_faces(PyObject* faces, const std::string& what, l3d_polygon_mesh& mesh) {
    const auto most = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    const auto add = [&](const std::vector<std::uint32_t>& corners, std::size_t count) {
        if (count < 3)
            throw value_error(what + ": a face has three corners or more, not " +
                              std::to_string(count));
        const std::size_t before = mesh.corners.size();
        mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
        for (std::size_t end = before + count; end <= mesh.corners.size(); end += count)
            mesh.face_ends.push_back(l3d_polygon_mesh::index_of(end));
    };
    if (PyObject_CheckBuffer(faces) != 0) {
        const number_array array(faces, what);
        array.expect({-1, -1});
        add(array.indices(most), array.shape()[1]);
        return;
    }
    if (PySequence_Check(faces) == 0 || PyUnicode_Check(faces))
        throw type_error(what + ": an array or a list of faces is wanted, not " + shown(faces));
    const Py_ssize_t count = PySequence_Size(faces);
    for (Py_ssize_t i = 0; i < count; ++i) {
        const reference face = reference::taken(PySequence_GetItem(faces, i));
        const number_array corners(face.get(), what + "[" + std::to_string(i) + "]");
        corners.expect({-1});
        add(corners.indices(most), corners.shape()[0]);
    }
}

/// Colours of vertices or faces: three levels from 0 to 255 each, or whole words 0x00RRGGBB.
std::vector<std::uint32_t> colors_of(PyObject* value, const std::string& what, std::size_t count) {
    const number_array array(value, what);
    if (array.shape().size() == 1) {
        array.expect({static_cast<int>(count)});
        return array.indices(0xffffff);
    }
    array.expect({static_cast<int>(count), 3});
    const std::vector<std::uint32_t> levels = array.indices(255);
    std::vector<std::uint32_t> result(count);
    for (std::size_t i = 0; i < count; ++i)
        result[i] = levels[3 * i] << 16 | levels[3 * i + 1] << 8 | levels[3 * i + 2];
    return result;
}

std::vector<vector_3d> vectors_of(PyObject* value, const std::string& what, double most) {
    const number_array array(value, what);
    array.expect({-1, 3});
    std::vector<vector_3d> result(array.shape()[0]);
    array.copy_to(reinterpret_cast<double*>(result.data()), most);
    return result;
}

reference from_polygons(arguments& a) {
    a.are("Model.from_polygons", "vertices faces | colors face_colors normals crease_angle");
    l3d_polygon_mesh mesh;
    mesh.vertices = vectors_of(a.need("vertices"), a.what("vertices"), farthest);
    if (mesh.vertices.empty())
        throw value_error(a.what("vertices") + ": there are none");
    l3d_polygon_mesh::index_of(mesh.vertices.size());
    add_faces(a.need("faces"), a.what("faces"), mesh);
    if (PyObject* value = a.find("colors"))
        mesh.vertex_colors = colors_of(value, a.what("colors"), mesh.vertices.size());
    if (PyObject* value = a.find("face_colors"))
        mesh.face_colors = colors_of(value, a.what("face_colors"), mesh.faces());
    if (PyObject* value = a.find("normals")) {
        mesh.vertex_normals = vectors_of(value, a.what("normals"), farthest);
        if (mesh.vertex_normals.size() != mesh.vertices.size())
            throw value_error(a.what("normals") + ": one for each vertex is wanted");
    }
    const double crease = a.number("crease_angle", l3d_usual_crease_angle, 0, 180);
    std::optional<l3d_polygon_model> model;
    {
        const unlocked while_measuring;
        model.emplace(std::move(mesh), false, crease);
    }
    return made(l3d_any_model(*model));
}

reference from_heights(arguments& a) {
    a.are("Model.from_heights", "heights spacing |");
    const number_array heights(a.need("heights"), a.what("heights"));
    heights.expect({-1, -1});
    const l3d_height_field field{heights.shape()[1], heights.doubles_or_nan(farthest),
                                 a.number("spacing", 1, 0, farthest)};
    if (const std::string why = field.complaint(); !why.empty())
        throw value_error("Model.from_heights: " + why);
    std::string why;
    const auto model =
        l3d_patch_model::from_patches(l3d_height_patches(field), "Model.from_heights", why);
    if (!model)
        throw value_error(why);
    return made(l3d_any_model(*model));
}

reference from_surfaces(arguments& a) {
    a.are("Model.from_surfaces", "surfaces |");
    PyObject* given = a.need("surfaces");
    const auto surfaces = is_a<l3d_nurbs_surface>(given)
                              ? std::vector{value_of<l3d_nurbs_surface>(given)}
                              : list_of<l3d_nurbs_surface>(given, a.what("surfaces"));
    if (surfaces.empty())
        throw value_error(a.what("surfaces") + ": there are none");
    return made(l3d_any_model(l3d_patch_model::from_surfaces(surfaces)));
}

// ---- models of models ---------------------------------------------------------------------------

/// The same polygons, all of one material and without pictures.
l3d_polygon_model painted_polygons(const l3d_polygon_model& model, const l3d_material& material) {
    l3d_polygon_mesh mesh = model.mesh();
    mesh.vertex_colors.clear();
    mesh.face_colors.clear();
    mesh.picture_places.clear();
    mesh.pictures.clear();
    mesh.materials = {""};
    mesh.looks = {material};
    mesh.face_materials.assign(mesh.faces(), 0);
    return l3d_polygon_model(std::move(mesh));
}

reference painted(l3d_any_model& self, arguments& a) {
    a.are("Model.painted", "material part |");
    const auto& material = a.object<l3d_material>("material");
    const auto paint = [&](const auto& model) -> l3d_any_model {
        if (PyObject* part = a.find("part"))
            return model.part_painted(
                part_of(model.parts(), text_of(part, a.what("part")), a.what("part")), material);
        if constexpr (std::is_same_v<std::decay_t<decltype(model)>, l3d_patch_model>)
            return model.painted(material);
        else
            return painted_polygons(model, material);
    };
    return made(std::visit(paint, self));
}

std::vector<std::size_t> parts_of(const l3d_parts& parts, const arguments& a) {
    PyObject* names = a.need("names");
    if (PyUnicode_Check(names))
        return {part_of(parts, text_of(names, a.what("names")), a.what("names"))};
    if (PySequence_Check(names) == 0)
        throw type_error(a.what("names") + ": a name or a list of names is wanted, not " +
                         shown(names));
    std::vector<std::size_t> result;
    for (Py_ssize_t i = 0; i < PySequence_Size(names); ++i)
        result.push_back(part_of(
            parts, text_of(reference::taken(PySequence_GetItem(names, i)).get(), a.what("names")),
            a.what("names")));
    return result;
}

reference only(l3d_any_model& self, arguments& a) {
    a.are("Model.only", "names |");
    return made(std::visit(
        [&](const auto& model) -> l3d_any_model { return model.only(parts_of(model.parts(), a)); },
        self));
}
reference without(l3d_any_model& self, arguments& a) {
    a.are("Model.without", "names |");
    return made(std::visit(
        [&](const auto& model) -> l3d_any_model {
            return model.without(parts_of(model.parts(), a));
        },
        self));
}

// ---- what a model has ---------------------------------------------------------------------------

reference kind(const l3d_any_model& self) {
    return text(std::holds_alternative<l3d_patch_model>(self) ? "patches" : "polygons");
}

reference parts(const l3d_any_model& self) {
    return std::visit(
        [](const auto& model) {
            const auto names = model.parts().names();
            reference result = reference::taken(PyList_New(0));
            for (const std::string& name : names)
                if (PyList_Append(result.get(), text(name).get()) != 0)
                    throw error_is_set();
            return result;
        },
        self);
}

reference bounds(const l3d_any_model& self) {
    return std::visit(
        [](const auto& model) {
            return reference::taken(
                PyTuple_Pack(2, numbers(model.least()).get(), numbers(model.most()).get()));
        },
        self);
}

reference patches(const l3d_any_model& self) {
    const auto* model = std::get_if<l3d_patch_model>(&self);
    if (!model)
        return reference::none();
    const auto all = model->patches();
    return memory_of(array_view::of(std::make_shared<l3d_patch_model>(*model),
                                    reinterpret_cast<const double*>(all.data()),
                                    {all.size(), 4, 4, 3}));
}

reference vertices(const l3d_any_model& self) {
    const auto* model = std::get_if<l3d_polygon_model>(&self);
    if (!model)
        return reference::none();
    const auto& all = model->mesh().vertices;
    return memory_of(array_view::of(std::make_shared<l3d_polygon_model>(*model),
                                    reinterpret_cast<const double*>(all.data()), {all.size(), 3}));
}

static_assert(sizeof(l3d_model_triangle) % sizeof(std::uint32_t) == 0);

/// The corners of triangles lie among what else is known of them.
reference triangles(const l3d_any_model& self) {
    const auto* model = std::get_if<l3d_polygon_model>(&self);
    if (!model)
        return reference::none();
    const auto all = model->triangles();
    array_view view{std::make_shared<l3d_polygon_model>(*model),
                    all.empty() ? nullptr : all[0].corners.data(),
                    "I",
                    sizeof(std::uint32_t),
                    {},
                    {}};
    view.shape = {static_cast<Py_ssize_t>(all.size()), 3};
    view.strides = {sizeof(l3d_model_triangle), sizeof(std::uint32_t)};
    return memory_of(std::move(view));
}

reference png(l3d_any_model& self, arguments& a) {
    a.are("Model._repr_png_", "");
    const picture shown = shown_picture(self);
    return png_of(shown.image->pixels(), shown.is_transparent);
}

reference model_text(const l3d_any_model& self) {
    if (const auto* model = std::get_if<l3d_patch_model>(&self))
        return text("<l3d.Model: " + std::to_string(model->pieces()) + " patches>");
    return text("<l3d.Model: " + std::to_string(std::get<l3d_polygon_model>(self).mesh().faces()) +
                " polygons>");
}

} // namespace

PyTypeObject* add_model_type(PyObject* module) {
    using m = l3d_any_model;
    static PyMethodDef methods[] = {
        function<load>("load", doc("Model.load"), METH_STATIC),
        function<from_patches>("from_patches", doc("Model.from_patches"), METH_STATIC),
        function<from_polygons>("from_polygons", doc("Model.from_polygons"), METH_STATIC),
        function<from_heights>("from_heights", doc("Model.from_heights"), METH_STATIC),
        function<from_surfaces>("from_surfaces", doc("Model.from_surfaces"), METH_STATIC),
        method<m, painted>("painted", doc("Model.painted")),
        method<m, only>("only", doc("Model.only")),
        method<m, without>("without", doc("Model.without")),
        method<m, png>("_repr_png_", doc("Model._repr_png_")),
        {}};
    static PyGetSetDef attributes[] = {attribute<m, kind>("kind", doc("Model.kind")),
                                       attribute<m, parts>("parts", doc("Model.parts")),
                                       attribute<m, bounds>("bounds", doc("Model.bounds")),
                                       attribute<m, patches>("patches", doc("Model.patches")),
                                       attribute<m, vertices>("vertices", doc("Model.vertices")),
                                       attribute<m, triangles>("triangles", doc("Model.triangles")),
                                       {}};
    return new_type<m>(module, "l3d.Model", doc("Model"), methods, attributes,
                       {slot(Py_tp_repr, call_text<m, model_text>)});
}

} // namespace python
