// SPDX-License-Identifier: MIT
// glTF 2.0: what becomes of a scene, and what each broken document is told.
#include "geom/files/model_file.h"

#include "model_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

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
    EXPECT_EQ(mesh.face_colors[0], 0xffffffu);
    EXPECT_NE(mesh.face_colors[12], 0xffffffu);
    ASSERT_EQ(file.notes.size(), 4u);
    EXPECT_TRUE(file.notes[0].starts_with("name: textures are skipped")) << file.notes[0];
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
    EXPECT_FALSE(
        l3d_read_model_with(files, model_text::with(triangle(), data, "c.bin"), "name", why));
    EXPECT_EQ(why, "name: buffers[0].uri 'c.bin': gone");
    EXPECT_EQ(complaint(there),
              "name: buffers[0].uri 'a%20b.bin': cannot be read from a text alone");
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
