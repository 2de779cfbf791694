// SPDX-License-Identifier: MIT
// Pictures in glTF: the three ways in which a file holds them, and what is said of broken ones.
#include "geom/files/model_file.h"

#include "model_text.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace {

/// A square of a strip, whose places in the picture are the corners' x and y.
///
/// The buffer has x, y, z of four corners: (0, 0, 0), (1, 0, 0), (0, 1, 0) and (1, 1, 0).
std::string square(const std::string& image, const std::string& texture = R"("source":0)",
                   const std::string& more = "") {
    const std::string zero = "AAAAAAAAAAAAAAAA", x = "AACAPwAAAAAAAAAA", y = "AAAAAAAAgD8AAAAA",
                      both = "AACAPwAAgD8AAAAA";
    return R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[)"
           R"({"attributes":{"POSITION":0,"TEXCOORD_1":1},"mode":5,"material":0}]}],)"
           R"("materials":[{"pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":)"
           R"({"index":0,"texCoord":1}}}],"textures":[{)" +
           texture + R"(}],"images":[{)" + image +
           R"(}],"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
           R"({"bufferView":1,"componentType":5126,"count":4,"type":"VEC2"}],)"
           R"("bufferViews":[{"buffer":0,"byteLength":48},)"
           R"({"buffer":0,"byteLength":48,"byteStride":12}],)"
           R"("buffers":[{"byteLength":48,"uri":"data:;base64,)" +
           zero + x + y + both + R"("}])" + more + "}";
}

l3d_model_file read_with(const l3d_other_files& files, const std::string& text) {
    std::string why;
    const auto model = l3d_read_model_with(files, text, "name", why);
    EXPECT_TRUE(model) << why;
    EXPECT_TRUE(!model || model->mesh.is_valid());
    return model.value_or(l3d_model_file());
}

l3d_model_file read(const std::string& text) {
    return read_with({}, text);
}

TEST(gltf_picture, is_in_a_uri_a_buffer_view_or_a_file) {
    using places = std::vector<l3d_polygon_mesh::picture_place>;
    const l3d_mesh_picture wanted{"name: images[0]", "abc"};
    const l3d_model_file of_uri = read(square(R"("uri":"data:image/png;base64,YWJj")"));
    ASSERT_EQ(of_uri.mesh.pictures, std::vector{wanted});
    EXPECT_EQ(of_uri.mesh.looks[0].picture, 0);
    EXPECT_EQ(of_uri.mesh.picture_places,
              (places{{0, 0}, {1, 0}, {0, 1}, {0, 1}, {1, 0}, {1, 1}})); // of two triangles
    EXPECT_TRUE(of_uri.notes.empty()) << of_uri.notes[0];

    const l3d_model_file of_view = read(square(R"("bufferView":0,"mimeType":"image/png")"));
    ASSERT_EQ(of_view.mesh.pictures.size(), 1u);
    EXPECT_EQ(of_view.mesh.pictures[0].bytes.size(), 48u);

    const auto file = [](const std::string& name, std::string& why) {
        why = "is not there";
        return name == "a b.png" ? std::optional<std::string>("abc") : std::nullopt;
    };
    EXPECT_EQ(read_with(file, square(R"("uri":"a%20b.png")")).mesh.pictures, std::vector{wanted});
}

TEST(gltf_picture, is_clamped_where_its_sampler_says_so) {
    const std::string uri = R"("uri":"data:image/png;base64,YWJj")";
    const l3d_mesh_picture picture =
        read(square(uri, R"("source":0,"sampler":0)", R"(,"samplers":[{"wrapT":33071}])"))
            .mesh.pictures.at(0);
    EXPECT_TRUE(picture.repeats_u);
    EXPECT_FALSE(picture.repeats_v);
    EXPECT_FALSE(picture.mirrors_u || picture.mirrors_v);
}

TEST(gltf_picture, is_mirrored_where_its_sampler_says_so) {
    const std::string uri = R"("uri":"data:image/png;base64,YWJj")";
    const l3d_mesh_picture picture =
        read(square(uri, R"("source":0,"sampler":0)", R"(,"samplers":[{"wrapT":33648}])"))
            .mesh.pictures.at(0);
    EXPECT_TRUE(picture.repeats_u && picture.repeats_v);
    EXPECT_FALSE(picture.mirrors_u);
    EXPECT_TRUE(picture.mirrors_v);
}

/// The model stays, without the picture.
TEST(gltf_picture, that_is_broken_is_noted) {
    const auto note = [](const std::string& text) {
        const l3d_model_file file = read(text);
        EXPECT_TRUE(file.mesh.pictures.empty());
        EXPECT_EQ(file.mesh.faces(), 2u);
        return file.notes.size() == 1 ? file.notes[0] : std::to_string(file.notes.size());
    };
    const std::string rest = "; its faces have the colours of their materials";
    EXPECT_EQ(note(square(R"("uri":"a.png")")),
              "name: images[0].uri 'a.png': cannot be read from a text alone" + rest);
    EXPECT_EQ(note(square(R"("uri":"data:image/png;base64,?")")),
              "name: images[0].uri is no base64" + rest);
    EXPECT_EQ(note(square(R"("bufferView":7)")),
              "name: bufferViews: number 7 of 2 is asked for" + rest);
    EXPECT_EQ(note(square(R"("uri":"data:;base64,")")), "name: images[0] is empty" + rest);
    EXPECT_EQ(note(square("", R"("source":3)")), "name: images: number 3 of 1 is asked for" + rest);
    EXPECT_EQ(note(square("", "")),
              "name: textures[0] has no source of a kind that is read here" + rest);
}

} // namespace
