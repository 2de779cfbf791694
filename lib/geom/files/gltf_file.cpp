// SPDX-License-Identifier: MIT
// Reads glTF 2.0: the scene's nodes become one mesh, in the scene's coordinates.
#include "geom/files/gltf_materials_p.h"
#include "base/counted_p.h"
#include "base/printable_p.h"
#include "geom/files/model_reader_p.h"
#include "geom/transform.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace {

using l3d_detail::gltf_document;
using l3d_detail::gltf_error;
using l3d_detail::gltf_numbers;
using l3d_detail::gltf_value;
using l3d_detail::read_array;
using matrix = l3d_matrix<double>;
using vector = l3d_polygon_mesh::vector;

/// The rotation of the quaternion x, y, z, w. Expects: q is not zero.
matrix rotation_of(std::array<double, 4> q) {
    const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    for (double& component : q)
        component /= length;
    const auto [x, y, z, w] = q;
    matrix m = l3d_identity<double>();
    const double rows[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                               {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                               {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            m(row, column) = rows[row][column];
    return m;
}

/// The modes in which indices make triangles, by glTF's numbers.
enum : std::uint64_t { triangles = 4, strip = 5, fan = 6 };

class gltf_reader {
public:
    gltf_reader(const gltf_document& document, l3d_model_file& model, std::string name,
                const l3d_other_files& files)
        : root_(document.root()), document_(document), model_(model), name_(std::move(name)),
          materials_(document, model, name_, files) {}

    /// Checks the version of the format. Call this before buffers are read, since other versions
    /// define buffers differently.
    void check_version() {
        const std::string version = root_.at("asset").at("version").text();
        if (!version.starts_with("2."))
            root_.at("asset").at("version").fail(l3d_detail::quoted(version) + "; 2.0 can be read");
    }

    void read() {
        check_extensions();
        note_what_is_skipped();
        note_extensions();
        materials_.read();
        read_scene();
        finish();
    }

private:
    static constexpr const char* instancing = "EXT_mesh_gpu_instancing";

    l3d_polygon_mesh& mesh() { return model_.mesh; }
    void note(const std::string& what) { model_.notes.push_back(name_ + ": " + what); }

    /// Refuses required extensions that change the meaning of the numbers read here.
    void check_extensions() {
        for (std::size_t i = 0; i < root_.count("extensionsRequired"); ++i) {
            const gltf_value extension = root_.element("extensionsRequired", i);
            const std::string_view of = extension.text();
            if (!is_read(of) && !of.starts_with("KHR_materials_") &&
                of.find("_texture_") == of.npos)
                extension.fail("asks for " + l3d_detail::quoted(of) + ", which is not read here");
        }
    }

    static bool is_read(std::string_view extension) {
        return extension == "KHR_mesh_quantization" || extension == instancing ||
               extension == l3d_detail::glossiness;
    }

    /// Adds a note on extensions that are used and not read, with the first three names. Extensions
    /// of textures have their own note, and extensions of descriptions need none.
    void note_extensions() {
        constexpr std::size_t most_named = 3;
        std::string names;
        std::size_t count = 0;
        for (std::size_t i = 0; i < root_.count("extensionsUsed"); ++i) {
            const std::string& of = root_.element("extensionsUsed", i).text();
            if (is_read(of) || of.find("_texture_") != of.npos || of.find("_xmp") != of.npos)
                continue;
            if (++count <= most_named)
                names += (count > 1 ? ", " : "") + l3d_detail::quoted(of);
        }
        if (count > most_named)
            names += " and " + std::to_string(count - most_named) + " more";
        if (count > 0)
            note("extensions are skipped: " + names);
    }

    void note_what_is_skipped() {
        constexpr std::pair<const char*, const char*> skipped[] = {
            {"animations", "animations are skipped: nodes stay where they are"},
            {"skins", "skins are skipped: meshes have the shape they are stored in"},
            {"cameras", "cameras are skipped"}};
        for (const auto& [member, words] : skipped)
            if (root_.count(member) > 0)
                note(words);
    }

    /// The rotation of a quaternion; the identity if it is zero or not finite.
    matrix turned_by(const std::array<double, 4>& q) {
        const auto is_finite = [](double component) { return std::isfinite(component); };
        const auto is_zero = [](double component) { return component == 0; };
        if (std::ranges::all_of(q, is_finite) && !std::ranges::all_of(q, is_zero))
            return rotation_of(q);
        has_odd_rotations_ = true;
        return l3d_identity<double>();
    }

    matrix transform_of(const gltf_value& node) {
        std::array<double, 16> columns{};
        if (read_array(node, "matrix", columns)) {
            matrix m = l3d_identity<double>();
            for (int row = 0; row < 3; ++row)
                for (int column = 0; column < 4; ++column)
                    m(row, column) = columns[static_cast<std::size_t>(4 * column + row)];
            return m;
        }
        std::array<double, 3> move{0, 0, 0}, scale{1, 1, 1};
        std::array<double, 4> turn{0, 0, 0, 1};
        read_array(node, "translation", move);
        read_array(node, "rotation", turn);
        read_array(node, "scale", scale);
        return l3d_translation<double>(move[0], move[1], move[2]) * turned_by(turn) *
               l3d_scaling<double>(scale[0], scale[1], scale[2]);
    }

    /// The placements of a node's mesh, in the node's coordinates. There is one placement, unless
    /// EXT_mesh_gpu_instancing lists more.
    std::vector<matrix> instances_of(const gltf_value& node) {
        if (!node.has("extensions") || !node.at("extensions").has(instancing))
            return {l3d_identity<double>()};
        const gltf_value attributes = node.at("extensions").at(instancing).at("attributes");
        std::optional<gltf_numbers> moves, turns, scales;
        std::optional<std::size_t> count;
        const auto read = [&](const char* name, const char* type, auto& into) {
            if (!attributes.has(name))
                return;
            into = document_.numbers(attributes.at(name), type, false);
            if (count && *count != into->count)
                attributes.fail("has " + std::to_string(*count) + " and " +
                                std::to_string(into->count) + " instances");
            count = into->count;
        };
        read("TRANSLATION", "VEC3", moves);
        read("ROTATION", "VEC4", turns);
        read("SCALE", "VEC3", scales);
        document_.take_memory(count.value_or(0) * sizeof(matrix));
        std::vector<matrix> result(count.value_or(0), l3d_identity<double>());
        for (std::size_t i = 0; i < result.size(); ++i) {
            if (moves)
                result[i] =
                    l3d_translation<double>(moves->at(i)[0], moves->at(i)[1], moves->at(i)[2]);
            if (turns)
                result[i] = result[i] * turned_by({turns->at(i)[0], turns->at(i)[1],
                                                   turns->at(i)[2], turns->at(i)[3]});
            if (scales)
                result[i] = result[i] * l3d_scaling<double>(scales->at(i)[0], scales->at(i)[1],
                                                            scales->at(i)[2]);
        }
        return result;
    }

    /// Reads the nodes of the scene. Without a scene, it reads all nodes that have no parent.
    void read_scene() {
        struct pending {
            std::size_t node;
            matrix to_scene;
        };
        std::vector<pending> stack;
        const std::size_t nodes = root_.count("nodes");
        if (root_.count("scenes") > 0) {
            const gltf_value scene = root_.element("scenes", root_.whole_or("scene", 0));
            for (std::size_t i = scene.count("nodes"); i-- > 0;)
                stack.push_back({scene.element("nodes", i).whole(), l3d_identity<double>()});
        } else {
            std::set<std::uint64_t> children;
            for (std::size_t n = 0; n < nodes; ++n)
                for (std::size_t i = 0; i < root_.element("nodes", n).count("children"); ++i)
                    children.insert(root_.element("nodes", n).element("children", i).whole());
            for (std::size_t n = nodes; n-- > 0;)
                if (!children.contains(n))
                    stack.push_back({n, l3d_identity<double>()});
        }
        std::vector<bool> is_seen(nodes);
        while (!stack.empty()) {
            const pending next = stack.back();
            stack.pop_back();
            const gltf_value node = root_.element("nodes", next.node);
            if (is_seen[next.node])
                node.fail("is in the scene twice");
            is_seen[next.node] = true;
            const matrix to_scene = next.to_scene * transform_of(node);
            if (node.has("mesh"))
                for (const matrix& instance : instances_of(node))
                    read_mesh(node, to_scene * instance);
            for (std::size_t i = node.count("children"); i-- > 0;)
                stack.push_back({node.element("children", i).whole(), to_scene});
        }
    }

    void read_mesh(const gltf_value& node, const matrix& to_scene) {
        const gltf_value of = root_.element("meshes", node.at("mesh").whole());
        const std::string name = node.text_or("name", of.text_or("name", ""));
        mesh().parts.push_back({name, static_cast<std::uint32_t>(mesh().faces())});
        has_morphs_ = has_morphs_ || of.count("weights") > 0;
        for (std::size_t i = 0; i < of.count("primitives"); ++i)
            read_primitive(of.element("primitives", i), to_scene);
    }

    void read_primitive(const gltf_value& primitive, const matrix& to_scene) {
        const std::uint64_t mode = primitive.whole_or("mode", triangles);
        if (mode > fan)
            primitive.fail("has mode " + std::to_string(mode) + " of 0 to 6");
        has_morphs_ = has_morphs_ || primitive.count("targets") > 0;
        const gltf_value attributes = primitive.at("attributes");
        if (mode < triangles || !attributes.has("POSITION")) {
            has_lines_ = true;
            return;
        }
        const std::uint32_t first = l3d_polygon_mesh::index_of(mesh().vertices.size());
        const std::size_t count = read_vertices(attributes, to_scene);
        const bool mirrors = l3d_determinant(to_scene) < 0;
        std::vector<std::uint32_t> indices = indices_of(primitive, count);
        check_places(attributes.at("POSITION"), indices);
        const std::size_t faces = mesh().faces();
        const auto places = read_picture_places(primitive, attributes, count);
        const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
            if (mirrors)
                std::swap(b, c);
            mesh().add_face({{first + indices[a], first + indices[b], first + indices[c]}});
            if (places.empty())
                return;
            document_.take_memory(3 * sizeof(places[0]));
            mesh().picture_places.resize(mesh().corners.size() - 3);
            for (const std::size_t corner : {a, b, c})
                mesh().picture_places.push_back(places[indices[corner]]);
        };
        if (mode == triangles && indices.size() % 3 != 0)
            primitive.fail("has " + std::to_string(indices.size()) +
                           " corners, which is no number of triangles");
        document_.take_memory(indices.size() * (mode == triangles ? 1 : 3) * sizeof(std::uint32_t));
        for (std::size_t i = 0; i + 2 < indices.size(); i += mode == triangles ? 3 : 1)
            if (mode == fan)
                add(0, i + 1, i + 2);
            else if (mode == strip && i % 2 == 1)
                add(i + 1, i, i + 2);
            else
                add(i, i + 1, i + 2);
        if (primitive.has("material")) {
            const std::uint64_t material = primitive.at("material").whole();
            if (material >= root_.count("materials"))
                primitive.at("material")
                    .fail("names material " + std::to_string(material) + " of " +
                          std::to_string(root_.count("materials")));
            mesh().face_materials.resize(faces, l3d_detail::face_materials::nothing);
            mesh().face_materials.resize(mesh().faces(), static_cast<std::uint32_t>(material));
        }
    }

    /// The picture places of a primitive's vertices; none if its material has no picture.
    std::vector<l3d_polygon_mesh::picture_place> read_picture_places(const gltf_value& primitive,
                                                                     const gltf_value& attributes,
                                                                     std::size_t vertices) {
        std::vector<l3d_polygon_mesh::picture_place> result;
        const std::uint64_t material = primitive.whole_or("material", mesh().looks.size());
        if (material >= mesh().looks.size() ||
            mesh().looks[material].picture == l3d_material::no_picture)
            return result;
        const std::string set = "TEXCOORD_" + std::to_string(materials_.set_of_places(material));
        if (!attributes.has(set.c_str())) {
            lacks_places_ = true;
            return result;
        }
        const gltf_value at = attributes.at(set.c_str());
        const gltf_numbers numbers = document_.numbers(at, "VEC2", false);
        check_count(at, numbers.count, vertices);
        for (std::size_t i = 0; i < vertices; ++i) {
            const auto& place = result.emplace_back(l3d_polygon_mesh::picture_place{
                static_cast<float>(numbers.at(i)[0]), static_cast<float>(numbers.at(i)[1])});
            if (!std::isfinite(place[0]) || !std::isfinite(place[1]))
                result.back() = {};
        }
        return result;
    }

    /// Reads places, normals and colours of a primitive's vertices, and returns their number.
    std::size_t read_vertices(const gltf_value& attributes, const matrix& to_scene) {
        const gltf_value at = attributes.at("POSITION");
        const gltf_numbers places = document_.numbers(at, "VEC3", false);
        document_.take_memory(places.count * 2 * sizeof(vector));
        odd_.clear();
        for (std::size_t i = 0; i < places.count; ++i) {
            const double* const p = places.at(i);
            const auto moved = to_scene * l3d_vector<double, 4>(p[0], p[1], p[2], 1.0);
            const auto is_place = [&](int k) {
                return std::abs(moved[k]) <= l3d_bpt_largest_coordinate;
            };
            if (is_place(0) && is_place(1) && is_place(2)) {
                mesh().vertices.emplace_back(moved[0], moved[1], moved[2]);
            } else {
                odd_.push_back(i);
                mesh().vertices.emplace_back(0);
            }
        }
        if (attributes.has("NORMAL"))
            read_normals(attributes.at("NORMAL"), to_scene, places.count);
        if (attributes.has("COLOR_0"))
            read_colors(attributes.at("COLOR_0"), places.count);
        return places.count;
    }

    /// Fails if an index names a vertex without a finite place. Ignores such vertices that no index
    /// names.
    void check_places(const gltf_value& at, std::span<const std::uint32_t> indices) {
        if (odd_.empty())
            return;
        for (const std::uint32_t index : indices)
            if (std::ranges::binary_search(odd_, index))
                at.fail("has a coordinate that is not finite or beyond 1e12, in vertex " +
                        std::to_string(index));
        has_odd_places_ = true;
    }

    static void check_count(const gltf_value& at, std::size_t count, std::size_t vertices) {
        if (count != vertices)
            at.fail("has " + l3d_detail::counted(count, "elements") + ", and the positions " +
                    std::to_string(vertices));
    }

    /// Reads the normals of a primitive, and transforms them by the cofactors of the placement.
    /// Cofactors keep normals perpendicular.
    void read_normals(const gltf_value& at, const matrix& to_scene, std::size_t vertices) {
        const gltf_numbers normals = document_.numbers(at, "VEC3", false);
        check_count(at, normals.count, vertices);
        const auto m = [&](int row, int column) { return to_scene(row % 3, column % 3); };
        const double side = l3d_determinant(to_scene) < 0 ? -1 : 1;
        mesh().vertex_normals.resize(mesh().vertices.size() - vertices, vector(0));
        for (std::size_t i = 0; i < normals.count; ++i) {
            const double* const n = normals.at(i);
            has_odd_normals_ =
                has_odd_normals_ || !l3d_detail::has_direction(vector(n[0], n[1], n[2]));
            vector turned(0);
            for (int row = 0; row < 3; ++row)
                for (int column = 0; column < 3; ++column)
                    turned[row] += side * n[column] *
                                   (m(row + 1, column + 1) * m(row + 2, column + 2) -
                                    m(row + 1, column + 2) * m(row + 2, column + 1));
            const double length = l3d_length(turned);
            mesh().vertex_normals.push_back(length > 0 && std::isfinite(length) ? turned / length
                                                                                : vector(0));
        }
    }

    void read_colors(const gltf_value& at, std::size_t vertices) {
        const gltf_numbers colors = document_.numbers(at, "VEC3 VEC4", false);
        check_count(at, colors.count, vertices);
        document_.take_memory(mesh().vertices.size() * 3 * sizeof(float) - color_bytes_);
        color_bytes_ = mesh().vertices.size() * 3 * sizeof(float);
        for (std::size_t i = 0; i < vertices; ++i) {
            std::array<double, 3> light{};
            for (std::size_t k = 0; k < light.size(); ++k)
                light[k] = l3d_detail::encoded(colors.at(i)[k]);
            colors_.give(mesh().vertices.size() - vertices + i, light.data());
        }
    }

    std::vector<std::uint32_t> indices_of(const gltf_value& primitive, std::size_t vertices) {
        std::vector<std::uint32_t> result;
        if (!primitive.has("indices")) {
            for (std::size_t i = 0; i < vertices; ++i)
                result.push_back(static_cast<std::uint32_t>(i));
            return result;
        }
        const gltf_value at = primitive.at("indices");
        const gltf_numbers numbers = document_.numbers(at, "SCALAR", true);
        result.reserve(numbers.count);
        for (const double index : numbers.values) {
            if (!(index < static_cast<double>(vertices)))
                at.fail("names vertex " + std::to_string(static_cast<std::uint64_t>(index)) +
                        " of " + std::to_string(vertices));
            result.push_back(static_cast<std::uint32_t>(index));
        }
        return result;
    }

    void finish() {
        if (has_morphs_)
            note("morph targets are skipped: meshes have the shape they are stored in");
        if (has_lines_)
            note("points, lines and what has no places are skipped");
        if (lacks_places_)
            note("meshes without places in their picture show one colour of it");
        if (has_odd_normals_)
            note(l3d_detail::odd_normals_note);
        if (has_odd_rotations_)
            note("rotations that are zero or no numbers are skipped");
        if (has_odd_places_)
            note(l3d_detail::odd_places_note);
        if (!mesh().vertex_normals.empty())
            mesh().vertex_normals.resize(mesh().vertices.size(), vector(0));
        l3d_detail::forget_odd_normals(mesh());
        if (!mesh().face_materials.empty()) {
            mesh().face_materials.resize(mesh().faces(), l3d_detail::face_materials::nothing);
            const auto without = static_cast<std::uint32_t>(mesh().materials.size());
            bool is_needed = false;
            for (std::uint32_t& material : mesh().face_materials)
                if (material == l3d_detail::face_materials::nothing) {
                    material = without;
                    is_needed = true;
                }
            if (is_needed) {
                mesh().materials.emplace_back();
                mesh().looks.emplace_back();
            }
        } else {
            mesh().materials.clear();
            mesh().looks.clear();
        }
        if (!mesh().picture_places.empty())
            mesh().picture_places.resize(mesh().corners.size());
        colors_.finish(mesh());
    }

    gltf_value root_;
    const gltf_document& document_;
    l3d_model_file& model_;
    std::string name_;
    l3d_detail::gltf_materials materials_;
    l3d_detail::vertex_colors colors_;
    std::size_t color_bytes_ = 0;
    std::vector<std::size_t> odd_; ///< vertices of the primitive without a finite place
    bool has_morphs_ = false, has_lines_ = false, lacks_places_ = false;
    bool has_odd_places_ = false, has_odd_normals_ = false, has_odd_rotations_ = false;
};

} // namespace

std::optional<l3d_model_file> l3d_read_gltf(std::string_view text, std::string_view name,
                                            std::string& why, const l3d_other_files& files) {
    const std::string called = l3d_detail::printable(name);
    try {
        gltf_document document(text);
        l3d_model_file model;
        gltf_reader reader(document, model, called, files);
        reader.check_version();
        document.read_buffers(files);
        reader.read();
        return model;
    } catch (const gltf_error& error) {
        why = called + ':' + error.what();
    } catch (const std::length_error& error) {
        why = called + ": " + error.what();
    }
    return std::nullopt;
}
