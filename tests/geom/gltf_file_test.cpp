// SPDX-License-Identifier: MIT
// glTF 2.0: what becomes of a scene, and what each broken document is told.
#include "geom/files/model_file.h"

#include "model_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace {

std::string scene() {
    return model_text::of_file("tests/fuzz/corpus/gltf/scene.gltf");
}

/// Why a text is refused; nothing if it is not.
std::string complaint(std::string_view text) {
    std::string why;
    l3d_read_model(text, "name", why);
    return why;
}

/// A triangle in its smallest document; the buffer has three floats for each corner.
std::string triangle(const std::string& more = "") {
    return R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[)"
           R"({"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,)"
           R"("count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
           R"("buffers":[{"byteLength":36,"uri":"data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAA)"
           R"(AAAAgD8AAAAA"}])" +
           more + "}";
}

TEST(gltf_file, is_the_scene_in_its_own_coordinates) {
    const l3d_model_file file = model_text::read_by(l3d_read_model, scene(), "name");
    const l3d_polygon_mesh& mesh = file.mesh;
    EXPECT_EQ(mesh.parts, (std::vector<l3d_part_run>{{"big", 0}, {"turned", 12}, {"flat", 24}}));
    EXPECT_EQ(mesh.faces(), 12u + 12 + 6 + 6); // eight vertices are a strip and a fan of six each
    EXPECT_EQ(mesh.vertices[6], l3d_polygon_mesh::vector(2, 1, 1)); // twice as long along x
    // A child: turned by 45 degrees about y, moved by 1.5, then twice as long.
    const l3d_polygon_mesh::vector corner = mesh.vertices[8 + 1]; // (1, 0, 0)
    EXPECT_NEAR(corner[0], 2 * (1.5 + std::sqrt(0.5)), 1e-6);
    EXPECT_NEAR(corner[2], -std::sqrt(0.5), 1e-6);
    EXPECT_EQ(mesh.vertices[8 + 6][1], 1.5); // its sparse accessor lifts the corners 6 and 7
    EXPECT_EQ(mesh.vertices[8 + 5][1], 0.0);
    EXPECT_EQ(mesh.look_of(0).color, 0xff0000u);
    // 0.2 of linear light is 0.485 as encoded.
    EXPECT_EQ(mesh.look_of(24).color, 0x7c7cffu);
    EXPECT_EQ(mesh.look_of(24).opacity, 0.5F); // it blends
    EXPECT_TRUE(mesh.face_colors.empty());
    ASSERT_EQ(mesh.vertex_colors.size(), mesh.vertices.size());
    EXPECT_EQ(mesh.vertex_colors[0], 0xffffffu);
    EXPECT_NE(mesh.vertex_colors[8 + 1], 0xffffffu);
    EXPECT_EQ(file.notes.size(), 4u);
}

TEST(gltf_file, turns_faces_of_mirrored_nodes_round) {
    const l3d_polygon_mesh mesh = model_text::read_by(l3d_read_model, scene(), "name").mesh;
    // The first triangle of the strip, 0 1 2, and the second, 2 1 3, each turned round.
    const std::uint32_t first = mesh.face(24)[0];
    EXPECT_EQ(mesh.face(24)[1], first + 2);
    EXPECT_EQ(mesh.face(24)[2], first + 1);
    EXPECT_EQ(mesh.face(25)[0], first + 2);
    EXPECT_EQ(mesh.face(25)[1], first + 3);
    EXPECT_EQ(mesh.face(25)[2], first + 1);
}

TEST(gltf_file, of_bytes_is_that_of_text) {
    std::string why;
    const auto text = l3d_read_model(scene(), "name", why);
    const auto bytes =
        l3d_read_model(model_text::of_file("tests/fuzz/corpus/gltf/scene.glb"), "name", why);
    ASSERT_TRUE(text && bytes) << why;
    EXPECT_TRUE(*text == *bytes);
}

TEST(gltf_file, reads_buffers_from_other_files) {
    std::string asked, why;
    const auto files = [&](const std::string& name, std::string& reason) {
        asked = name;
        reason = "gone";
        return name == "a b.bin" ? std::optional(std::string(36, '\0')) : std::nullopt;
    };
    const std::string data = "data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    const std::string there = model_text::with(triangle(), data, "a%20b.bin");
    const auto model = l3d_read_model_with(files, there, "name", why);
    ASSERT_TRUE(model) << why;
    EXPECT_EQ(asked, "a b.bin");
    EXPECT_EQ(model->mesh.faces(), 1u);
    // Some programs write a name as it is.
    const auto plain = [](const std::string& name, std::string&) {
        return name == "a%20b.bin" ? std::optional(std::string(36, '\0')) : std::nullopt;
    };
    EXPECT_TRUE(l3d_read_model_with(plain, there, "name", why));
    EXPECT_FALSE(
        l3d_read_model_with(files, model_text::with(triangle(), data, "c.bin"), "name", why));
    EXPECT_EQ(why, "name: buffers[0].uri 'c.bin': gone");
    EXPECT_EQ(complaint(there),
              "name: buffers[0].uri 'a%20b.bin': cannot be read from a text alone");
}

/// The floats of a buffer, as base64.
std::string coded(const std::vector<float>& numbers) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    std::uint32_t bits = 0;
    int count = 0;
    for (const float number : numbers)
        for (int shift = 0; shift < 32; shift += 8) {
            bits = bits << 8 | (std::bit_cast<std::uint32_t>(number) >> shift & 255);
            for (count += 8; count >= 6; count -= 6)
                text += digits[bits >> (count - 6) & 63];
        }
    return count > 0 ? text + digits[bits << (6 - count) & 63] : text;
}

/// The triangle with another accessor for each list, of three or four floats, from 1 on.
std::string triangle_with(const std::vector<std::vector<float>>& lists, std::string_view attribute,
                          const std::vector<std::size_t>& widths) {
    std::string text = triangle(), accessors, views, buffers;
    for (std::size_t i = 0; i < lists.size(); ++i) {
        const std::string bytes = std::to_string(4 * lists[i].size());
        accessors +=
            ",{\"bufferView\":" + std::to_string(i + 1) +
            ",\"componentType\":5126,\"count\":" + std::to_string(lists[i].size() / widths[i]) +
            ",\"type\":\"VEC" + std::to_string(widths[i]) + "\"}";
        views += ",{\"buffer\":" + std::to_string(i + 1) + ",\"byteLength\":" + bytes + '}';
        buffers +=
            ",{\"byteLength\":" + bytes + ",\"uri\":\"data:;base64," + coded(lists[i]) + "\"}";
    }
    text = model_text::with(text, "\"VEC3\"}", "\"VEC3\"}" + accessors);
    text = model_text::with(text, "\"byteLength\":36}],", "\"byteLength\":36}" + views + "],");
    text = model_text::with(text, "AAAA\"}", "AAAA\"}" + buffers);
    return attribute.empty() ? text
                             : model_text::with(text, "\"POSITION\":0",
                                                "\"POSITION\":0," + std::string(attribute));
}

constexpr const char* instanced =
    "\"mesh\":0,\"extensions\":{\"EXT_mesh_gpu_instancing\":{\"attributes\":{\"TRANSLATION\":1,"
    "\"ROTATION\":2,\"SCALE\":3}}}";

/// Half a turn about z, by a rotation of no length 1, and one that turns nothing.
TEST(gltf_file, draws_each_instance_of_a_mesh) {
    const std::string text = model_text::with(
        triangle_with({{10, 0, 0, 20, 0, 0}, {0, 0, 2, 0, 0, 0, 0, 0}, {1, 1, 1, 2, 3, 4}}, "",
                      {3, 4, 3}),
        "\"mesh\":0", instanced);
    const l3d_model_file file = model_text::read_by(l3d_read_model, text, "name");
    ASSERT_EQ(file.mesh.faces(), 2u);
    EXPECT_EQ(file.mesh.vertices[1], l3d_polygon_mesh::vector(9, 0, 0));
    EXPECT_EQ(file.mesh.vertices[2], l3d_polygon_mesh::vector(10, -1, 0));
    EXPECT_EQ(file.mesh.vertices[4], l3d_polygon_mesh::vector(22, 0, 0));
    EXPECT_EQ(file.mesh.vertices[5], l3d_polygon_mesh::vector(20, 3, 0));
    EXPECT_EQ(file.notes,
              std::vector<std::string>{"name: rotations that are zero or no numbers are "
                                       "skipped"});
    EXPECT_EQ(complaint(model_text::with(text, "\"SCALE\":3", "\"SCALE\":0")),
              "name: nodes[0].extensions.EXT_mesh_gpu_instancing.attributes has 2 and 3 instances");
    std::string required = text;
    required.insert(1, R"("extensionsRequired":["EXT_mesh_gpu_instancing"],)");
    EXPECT_EQ(complaint(required), "");
}

TEST(gltf_file, has_normals_computed_that_are_none) {
    const std::string note =
        "name: normals that are zero or no numbers are computed from the faces";
    const auto read = [](const std::vector<float>& normals) {
        return model_text::read_by(l3d_read_model, triangle_with({normals}, "\"NORMAL\":1", {3}),
                                   "name");
    };
    const l3d_model_file none = read({0, 0, 0, 0, 0, 0, 0, 0, 0});
    EXPECT_TRUE(none.mesh.vertex_normals.empty());
    EXPECT_EQ(none.notes, std::vector<std::string>{note});
    const l3d_model_file some = read({0, 0, 5, std::nanf(""), 0, 0, 0, 0, 1e-30f});
    EXPECT_EQ(some.mesh.vertex_normals,
              (std::vector<l3d_polygon_mesh::vector>{{0, 0, 1}, {0, 0, 0}, {0, 0, 1}}));
    EXPECT_EQ(some.notes, std::vector<std::string>{note});
}

TEST(gltf_file, needs_no_more_than_it_uses) {
    const auto notes_of = [](const std::string& text) {
        return model_text::read_by(l3d_read_model, text, "name").notes;
    };
    const std::string unused = model_text::with(
        triangle(), "\"buffers\":[", "\"buffers\":[{\"byteLength\":9,\"uri\":\"none.bin\"},");
    EXPECT_EQ(notes_of(model_text::with(unused, "\"buffer\":0", "\"buffer\":1")),
              std::vector<std::string>{});
    EXPECT_EQ(complaint(unused),
              "name: buffers[0].uri 'none.bin': cannot be read from a text alone");
    // Four vertices, of which the last is nowhere; and indices, which do not name it.
    const std::vector<float> indices{0, std::bit_cast<float>(1), std::bit_cast<float>(2)};
    std::string four =
        triangle_with({{0, 0, 0, 1, 0, 0, 0, 1, 0, std::nanf(""), 0, 0}, indices}, "", {3, 1});
    four = model_text::with(four, "5126,\"count\":3,\"type\":\"VEC1\"",
                            "5125,\"count\":3,\"type\":\"SCALAR\"");
    four = model_text::with(four, "\"POSITION\":0}", "\"POSITION\":1},\"indices\":2");
    EXPECT_EQ(notes_of(four), std::vector<std::string>{"name: vertices that no face uses are not "
                                                       "finite, or beyond 1e12: they are skipped"});
    EXPECT_EQ(
        complaint(model_text::with(four, ",\"indices\":2", ",\"mode\":6")),
        "name: meshes[0].primitives[0].attributes.POSITION has a coordinate that is not finite "
        "or beyond 1e12, in vertex 3");
}

TEST(gltf_file, says_what_it_skips_of_the_picture) {
    const auto notes_of = [](const std::string& more) {
        return model_text::read_by(l3d_read_model, triangle(more), "name").notes;
    };
    using texts = std::vector<std::string>;
    const std::string materials =
        "name: of materials, metalness, roughness, own light and cut-outs "
        "are skipped";
    EXPECT_EQ(
        notes_of(R"(,"extensionsUsed":["KHR_lights_punctual","KHR_texture_transform",)"
                 R"("KHR_materials_unlit","a","b","KHR_xmp_json_ld"])"),
        texts{"name: extensions are skipped: 'KHR_lights_punctual', 'KHR_materials_unlit', 'a' "
              "and 1 more"});
    EXPECT_EQ(notes_of(R"(,"materials":[{"emissiveFactor":[0,1,0]}])"), texts{materials});
    EXPECT_EQ(notes_of(R"(,"materials":[{"alphaMode":"MASK"}])"), texts{materials});
    EXPECT_EQ(notes_of(R"(,"materials":[{"pbrMetallicRoughness":{}}])"), texts{materials});
    EXPECT_EQ(notes_of(R"(,"materials":[{},{"pbrMetallicRoughness":{"metallicFactor":0}}])"),
              texts{});
}

TEST(gltf_file, takes_colours_of_the_older_kind_of_materials) {
    const l3d_polygon_mesh mesh =
        model_text::read_by(l3d_read_model,
                            model_text::with(triangle(R"(,"materials":[{"extensions":{)"
                                                      R"("KHR_materials_pbrSpecularGlossiness":)"
                                                      R"({"diffuseFactor":[1,0,0,1]}}}])"),
                                             "\"POSITION\":0}", "\"POSITION\":0},\"material\":0"),
                            "name")
            .mesh;
    EXPECT_EQ(mesh.look_of(0).color, 0xff0000u);
}

TEST(gltf_file, says_where_and_what_is_wrong) {
    struct mistake {
        const char *right, *wrong, *complaint;
    };
    const std::vector<mistake> mistakes{
        {"2.0", "1.0", "name: asset.version '1.0'; 2.0 can be read"},
        {"\"mesh\":0", "\"mesh\":7", "name: meshes: number 7 of 1 is asked for"},
        {"\"mesh\":0", "\"mesh\":-1", "name: nodes[0].mesh is no whole number from 0 on"},
        {"\"mesh\":0", "\"mesh\":\"x\"", "name: nodes[0].mesh is no number"},
        {"\"mesh\":0", "\"mesh\":0,\"children\":[0]", ""}, // nobody's child is left
        {"\"mesh\":0}", "\"children\":[1,1]},{}", "name: nodes[1] is in the scene twice"},
        {"\"mesh\":0", "\"matrix\":[1,2]", "name: nodes[0].matrix has 2 numbers, not 16"},
        {"\"mesh\":0", "\"mesh\":0,\"scale\":[1e300,1,1]",
         "name: meshes[0].primitives[0].attributes.POSITION has a coordinate that is not finite "
         "or beyond 1e12, in vertex 1"},
        {"5126", "5124", "name: accessors[0].componentType is no type of numbers: 5124"},
        {"VEC3", "VEC2",
         "name: accessors[0] has the type 'VEC2', where "
         "meshes[0].primitives[0].attributes.POSITION needs VEC3"},
        {"\"count\":3", "\"count\":4",
         "name: accessors[0] has 4 elements, more than the bytes of its bufferView, 36"},
        {"\"count\":3", "\"count\":9007199254740992",
         "name: accessors[0] has 9007199254740992 elements, more than the bytes of its "
         "bufferView, 36"},
        {"\"bufferView\":0,", "\"byteOffset\":9007199254740992,\"bufferView\":0,",
         "name: accessors[0] has 3 elements, more than the bytes of its bufferView, 36"},
        {"\"bufferView\":0,\"componentType\":5126,\"count\":3",
         "\"componentType\":5126,\"count\":1000000",
         "name: accessors[0] has 1000000 elements and no bufferView"},
        {"\"byteLength\":36}]", "\"byteLength\":37}]",
         "name: bufferViews[0] reaches to byte 37 of 36"},
        {"\"buffers\":[{\"byteLength\":36", "\"buffers\":[{\"byteLength\":64",
         "name: buffers[0] promises 64 bytes; there are 36"},
        {"base64,A", "base64,?", "name: buffers[0].uri is no base64"},
        {"\"POSITION\":0", "\"POSITION\":0,\"NORMAL\":1",
         "name: accessors: number 1 of 1 is asked for"},
        {"\"POSITION\":0}", "\"POSITION\":0},\"indices\":0",
         "name: accessors[0] has the type 'VEC3', where "
         "meshes[0].primitives[0].indices needs SCALAR"},
        {"\"POSITION\":0}", "\"POSITION\":0},\"mode\":9",
         "name: meshes[0].primitives[0] has mode 9 of 0 to 6"},
        {"\"POSITION\":0}", "\"POSITION\":0},\"material\":2",
         "name: meshes[0].primitives[0].material names material 2 of 0"},
    };
    ASSERT_EQ(complaint(triangle()), "");
    for (const mistake& m : mistakes)
        EXPECT_EQ(complaint(model_text::with(triangle(), m.right, m.wrong)), m.complaint)
            << m.wrong;
    EXPECT_EQ(complaint("{\n \"asset\": {,"), "name:2: no JSON is possible at byte 14");
    EXPECT_EQ(complaint("{}"), "name: the document has no asset");
    EXPECT_EQ(complaint(R"({"asset":{"version":"1.0"},"buffers":{"one":{}}})"),
              "name: asset.version '1.0'; 2.0 can be read");
    EXPECT_EQ(complaint(triangle(R"(,"extensionsRequired":["KHR_draco_mesh_compression"])")),
              "name: extensionsRequired[0] asks for 'KHR_draco_mesh_compressi...', which is not "
              "read here");
    EXPECT_EQ(complaint(model_text::with(scene(), "\"count\": 36", "\"count\": 35")),
              "name: meshes[0].primitives[0] has 35 corners, which is no number of triangles");
}

/// A scene that draws a triangle so often.
std::string crowd(int count, int copies) {
    std::string nodes, primitives = R"({"attributes":{"POSITION":0}})";
    for (int i = 0; i < count; ++i)
        nodes += "{\"mesh\":0},";
    const std::string one = primitives;
    for (int i = 1; i < copies; ++i)
        primitives += ',' + one;
    return model_text::with(model_text::with(triangle(), "{\"mesh\":0}", nodes + "{}"), one,
                            primitives);
}

TEST(gltf_file, of_a_small_scene_may_draw_a_mesh_as_often_as_it_likes) {
    EXPECT_EQ(complaint(crowd(3000, 1)), ""); // 12 bytes of text for a triangle
    EXPECT_EQ(complaint(crowd(3000, 3)), "");
}

TEST(gltf_file, that_names_a_mesh_again_and_again_is_refused) {
    EXPECT_EQ(complaint(crowd(3000, 100)),
              "name: what the scene names again and again takes more than 32 times the memory of "
              "the file, and more than 16 MB");
}

TEST(gltf_file, of_bytes_that_are_cut_off_is_refused) {
    const std::string whole = model_text::of_file("tests/fuzz/corpus/gltf/scene.glb");
    ASSERT_EQ(complaint(whole), "");
    for (std::size_t size = 4; size < whole.size(); size += 1 + size / 16)
        EXPECT_NE(complaint(whole.substr(0, size)), "") << size;
    EXPECT_EQ(complaint(whole.substr(0, 15)), "name:1: the file ends in its header");
    std::string old = whole;
    old[4] = 1;
    EXPECT_EQ(complaint(old), "name:1: version 1 of the container; 2 can be read");
}

} // namespace
