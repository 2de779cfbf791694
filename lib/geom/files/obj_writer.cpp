// SPDX-License-Identifier: MIT
// l3d_write_obj: writes polygons, patches as Bezier surfaces, and curves.
#include "geom/files/model_file.h"
#include "geom/files/model_reader_p.h"
#include "geom/files/obj_tags_p.h"

namespace {

void append_vector(std::string& text, const char* word, double x, double y, double z) {
    text += word;
    l3d_detail::append(text, x, ' ');
    l3d_detail::append(text, y, ' ');
    l3d_detail::append(text, z, '\n');
}

/// Writes the names of all materials, so that a reader numbers materials in the mesh's order.
void append_uses(std::string& text, const l3d_polygon_mesh& mesh) {
    for (const std::string& material : mesh.materials)
        text += "usemtl " + material + '\n';
}

void append_window(std::string& text, const char* word,
                   const std::optional<l3d_model_window>& window) {
    if (!window)
        return;
    text += word;
    l3d_detail::append(text, window->x0, ' ');
    l3d_detail::append(text, window->y0, ' ');
    l3d_detail::append(text, window->x1, ' ');
    l3d_detail::append(text, window->y1, '\n');
}

void append_vertices(std::string& text, const l3d_polygon_mesh& mesh) {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const l3d_polygon_mesh::vector& v = mesh.vertices[i];
        append_vector(text, "v ", v[0], v[1], v[2]);
        if (!mesh.vertex_colors.empty())
            l3d_detail::append_color(text, mesh.vertex_colors[i]);
    }
    for (const l3d_polygon_mesh::vector& n : mesh.vertex_normals)
        append_vector(text, "vn ", n[0], n[1], n[2]);
}

/// Begins the parts whose first face or patch has the index `thing`. `next` is the next part to
/// begin.
void append_parts(std::string& text, const std::vector<l3d_part_run>& parts,
                  std::vector<l3d_part_run>::const_iterator& next, std::size_t thing) {
    if (thing == 0 && (next == parts.end() || next->first > 0) && text.find("\ng ") != text.npos)
        text += "g\n"; // ends the part of the last patch or face
    for (; next != parts.end() && next->first <= thing; ++next)
        text += "g " + next->name + '\n';
}

void append_faces(std::string& text, const l3d_polygon_mesh& mesh) {
    auto part = mesh.parts.begin();
    for (std::size_t i = 0; i < mesh.faces(); ++i) {
        append_parts(text, mesh.parts, part, i);
        if (!mesh.face_materials.empty() &&
            (i == 0 || mesh.face_materials[i] != mesh.face_materials[i - 1]))
            text += "usemtl " + mesh.materials[mesh.face_materials[i]] + '\n';
        text += 'f';
        for (const std::uint32_t corner : mesh.face(i)) {
            const std::string number = std::to_string(corner + std::size_t{1});
            text += ' ' + number;
            if (!mesh.vertex_normals.empty() &&
                mesh.vertex_normals[corner] != l3d_polygon_mesh::vector(0))
                text += "//" + number;
        }
        text += '\n';
    }
}

/// Writes control points of a surface as vertices, with their weights if the surface is rational.
template <class Points>
void append_points(std::string& text, const Points& points, const std::vector<double>& weights) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        append_vector(text, "v ", points[i][0], points[i][1], points[i][2]);
        if (!weights.empty()) {
            text.back() = ' '; // the weight is in the same line
            l3d_detail::append(text, weights[i], '\n');
        }
    }
}

void append_last_vertices(std::string& text, std::size_t count) {
    for (std::size_t i = count; i > 0; --i)
        text += " -" + std::to_string(i);
}

/// Writes the curves of loops, and returns the statements that give these curves to a surface.
/// Numbers count back from the last curve.
std::string trims_of(std::string& text, std::span<const l3d_trim_loop> loops, bool is_rational) {
    std::size_t left = 0;
    for (const l3d_trim_loop& loop : loops)
        left += loop.size();
    if (left == 0)
        return "";
    std::string uses;
    text += "cstype rat bezier\n";
    for (const l3d_trim_loop& loop : loops) {
        uses += "trim";
        for (const l3d_trim_curve& curve : loop) {
            for (const auto& p : curve.points)
                append_vector(text, "vp ", p[0], p[1], p[2]);
            text += "deg " + std::to_string(curve.points.size() - 1) + "\ncurv2";
            append_last_vertices(text, curve.points.size());
            text += "\nparm u 0 1\nend\n";
            uses += " 0 1 -" + std::to_string(left--);
        }
        uses += '\n';
    }
    text += is_rational ? "cstype rat bezier\n" : "cstype bezier\n";
    return uses;
}

void append_patch(std::string& text, const l3d_patch_points& patch) {
    const std::string trims = trims_of(text, patch.trims, !patch.weights.empty());
    append_points(text, patch.points, patch.weights);
    text += "deg " + std::to_string(patch.degree_u) + ' ' + std::to_string(patch.degree_v) +
            "\nsurf 0 1 0 1";
    append_last_vertices(text, patch.points.size());
    text += "\nparm u 0 1\nparm v 0 1\n" + trims + "end\n";
}

void append_knots(std::string& text, const char* name, const l3d_bspline_direction& along) {
    text += name;
    for (const double knot : along.knots)
        l3d_detail::append(text, knot, ' ');
    text.back() = '\n';
}

void append_patches(std::string& text, const l3d_model_file& model) {
    const std::vector<std::uint32_t>& materials = model.patch_materials;
    auto part = model.patch_parts.begin();
    for (std::size_t i = 0; i < model.patches.size(); ++i) {
        const auto is_rational = [&](std::size_t k) { return !model.patches[k].weights.empty(); };
        if (i == 0 || is_rational(i) != is_rational(i - 1))
            text += is_rational(i) ? "cstype rat bezier\n" : "cstype bezier\n";
        if (!materials.empty() && (i == 0 || materials[i] != materials[i - 1]))
            text += "usemtl " + model.mesh.materials[materials[i]] + '\n';
        append_parts(text, model.patch_parts, part, i);
        append_patch(text, model.patches[i]);
    }
}

void append_curves(std::string& text, const l3d_model_file& model) {
    const std::vector<std::uint32_t>& materials = model.curve_materials;
    for (std::size_t i = 0; i < model.curves.size(); ++i) {
        const l3d_nurbs_curve& curve = model.curves[i];
        if (!materials.empty() && (i == 0 || materials[i] != materials[i - 1]))
            text += "usemtl " + model.mesh.materials[materials[i]] + '\n';
        append_points(text, curve.points(), curve.weights());
        text += curve.weights().empty() ? "cstype bspline\n" : "cstype rat bspline\n";
        text += "deg " + std::to_string(curve.along().degree) + "\ncurv ";
        l3d_detail::append(text, curve.along().from, ' ');
        l3d_detail::append(text, curve.along().to, ' ');
        text.pop_back(); // each index begins with a blank
        append_last_vertices(text, curve.points().size());
        text += '\n';
        append_knots(text, "parm u ", curve.along());
        text += "end\n";
    }
}

} // namespace

std::string l3d_write_obj(const l3d_model_file& model) {
    std::string text;
    for (const l3d_material_file& file : model.material_files)
        text += "mtllib " + file.name + '\n';
    append_window(text, "w ", model.window);
    append_window(text, "s ", model.viewport);
    append_vertices(text, model.mesh);
    // A material applies until the next one, so patches, curves and faces without any come first.
    const bool plain_patches = model.patch_materials.empty();
    const bool plain_curves = model.curve_materials.empty();
    const bool plain_faces = model.mesh.face_materials.empty();
    if (plain_patches)
        append_patches(text, model);
    if (plain_curves)
        append_curves(text, model);
    if (plain_faces)
        append_faces(text, model.mesh);
    append_uses(text, model.mesh);
    if (!plain_faces)
        append_faces(text, model.mesh);
    if (!plain_patches)
        append_patches(text, model);
    if (!plain_curves)
        append_curves(text, model);
    return text + l3d_detail::obj_tags(model.tags);
}

std::string l3d_write_obj_surfaces(std::span<const l3d_nurbs_surface> surfaces) {
    std::string text;
    for (const l3d_nurbs_surface& surface : surfaces) {
        const std::string trims = trims_of(text, surface.trims(), !surface.weights().empty());
        append_points(text, surface.points(), surface.weights());
        text += surface.weights().empty() ? "cstype bspline\n" : "cstype rat bspline\n";
        text += "deg " + std::to_string(surface.u().degree) + ' ' +
                std::to_string(surface.v().degree) + "\nsurf ";
        l3d_detail::append(text, surface.u().from, ' ');
        l3d_detail::append(text, surface.u().to, ' ');
        l3d_detail::append(text, surface.v().from, ' ');
        l3d_detail::append(text, surface.v().to, ' ');
        text.pop_back(); // each index begins with a blank
        append_last_vertices(text, surface.points().size());
        text += '\n';
        append_knots(text, "parm u ", surface.u());
        append_knots(text, "parm v ", surface.v());
        text += trims + "end\n";
    }
    return text;
}
