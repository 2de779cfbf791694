// SPDX-License-Identifier: MIT
// l3d_load_model: materials are looked up beside the model, and none is worth an error; pictures
// become hills.
#include "scene/model_loader.h"

#include "../system/temporary_folder.h"
#include "scene/patch_scene.h"
#include "base/error.h"
#include "tool_2d/image.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <png.h>
#include <sys/stat.h>

namespace {

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n";

void write(const std::filesystem::path& path, const std::string& text) {
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
}

TEST(model_loader, finds_materials_beside_the_model) {
    const temporary_folder folder;
    const std::string model = folder.file("here/a.obj");
    for (const std::string name : {"a b.mtl", "more/a.mtl", "/elsewhere/c.mtl"}) {
        write(model, "mtllib " + name + '\n' + triangle);
        const std::filesystem::path named(name);
        write(std::filesystem::path(model).parent_path() /
                  (named.is_absolute() ? named.filename() : named),
              "newmtl red\nKd 1 0 0\nfoo\n");
        const l3d_model_file file = l3d_load_model(model, "a.obj");
        EXPECT_EQ(file.mesh.look_of(0).color, 0xff0000u) << name;
        ASSERT_EQ(file.notes.size(), 1u) << name;
        EXPECT_TRUE(file.notes[0].ends_with(".mtl:3: 'foo' begins no statement of an .mtl file"))
            << file.notes[0];
    }
}

/// Windows writes places in its own way; a name may have a backslash on our side, too.
TEST(model_loader, finds_materials_where_windows_says) {
    const temporary_folder folder;
    const std::string model = folder.file("a.obj");
    const auto color = [&](const std::string& name) {
        write(model, "mtllib " + name + '\n' + triangle);
        return l3d_load_model(model, "a.obj").mesh.look_of(0).color;
    };
    write(folder.file("more/#1.mtl"), "newmtl red\nKd 1 0 0\n");
    write(folder.file("c.mtl"), "newmtl red\nKd 0 1 0\n");
    write(folder.file("d\\e.mtl"), "newmtl red\nKd 0 0 1\n");
    EXPECT_EQ(color("more/#1.mtl"), 0xff0000u);
    EXPECT_EQ(color(".\\more\\#1.mtl"), 0xff0000u);
    EXPECT_EQ(color("C:\\models\\c.mtl"), 0x00ff00u);
    EXPECT_EQ(color("d\\e.mtl"), 0x0000ffu);
}

TEST(model_loader, finds_materials_of_what_comes_through_a_pipe_in_the_present_folder) {
    const temporary_folder folder;
    const std::string pipe = folder.file("pipe");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::thread writer([&] { std::ofstream(pipe) << "mtllib none.mtl\n" << triangle; });
    EXPECT_EQ(
        l3d_load_model(pipe, "a.obj").notes,
        std::vector<std::string>{"a.obj:1: none.mtl: No such file or directory; its materials "
                                 "are white"});
    writer.join();
}

TEST(model_loader, notes_a_file_of_materials_that_is_not_there) {
    const temporary_folder folder;
    const std::string model = folder.file("a.obj");
    write(model, std::string(triangle) + "mtllib none.mtl\n");
    const l3d_model_file file = l3d_load_model(model, "a.obj");
    EXPECT_EQ(file.mesh.look_of(0), l3d_material());
    ASSERT_EQ(file.notes.size(), 1u);
    EXPECT_TRUE(file.notes[0].starts_with("a.obj:6: ")) << file.notes[0];
    EXPECT_NE(file.notes[0].find("none.mtl"), std::string::npos) << file.notes[0];
    EXPECT_TRUE(file.notes[0].ends_with("; its materials are white")) << file.notes[0];
    EXPECT_THROW(l3d_load_model(folder.file("b.obj"), "b.obj"), l3d_error);
}

TEST(model_loader, reads_all_files_of_materials_that_one_statement_names) {
    const temporary_folder folder;
    const std::string model = folder.file("a.obj");
    write(model, "mtllib a.mtl b.mtl\n" + std::string(triangle) + "usemtl green\nf 1 2 3\n");
    const auto color = [&](std::size_t face) {
        return l3d_load_model(model, "a.obj").mesh.look_of(face).color;
    };
    ASSERT_EQ(l3d_load_model(model, "a.obj").notes.size(), 1u);
    EXPECT_NE(l3d_load_model(model, "a.obj").notes[0].find("a.mtl b.mtl: "), std::string::npos);
    write(folder.file("b.mtl"), "newmtl green\nKd 0 1 0\n");
    EXPECT_EQ(color(1), 0x00ff00u);
    ASSERT_EQ(l3d_load_model(model, "a.obj").notes.size(), 1u);
    const std::string note = l3d_load_model(model, "a.obj").notes[0];
    EXPECT_TRUE(note.starts_with("a.obj:1: ")) << note;
    EXPECT_NE(note.find("a.mtl: "), std::string::npos) << note;
    write(folder.file("a.mtl"), "newmtl red\nKd 1 0 0\n");
    EXPECT_EQ(color(0), 0xff0000u);
    EXPECT_EQ(color(1), 0x00ff00u);
    EXPECT_TRUE(l3d_load_model(model, "a.obj").notes.empty());
    write(folder.file("a.mtl b.mtl"), "newmtl red\nKd 0 0 1\nnewmtl green\nKd 0 0 1\n");
    EXPECT_EQ(color(0), 0x0000ffu) << "the whole is a name if there is such a file";
    EXPECT_EQ(color(1), 0x0000ffu);
}

TEST(model_loader, names_materials_that_no_file_describes) {
    const temporary_folder folder;
    const std::string model = folder.file("a.obj");
    write(model, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl red\nf 1 2 3\n"); // one has none
    const l3d_model_file file = l3d_load_model(model, "a.obj");
    ASSERT_EQ(file.notes.size(), 1u);
    EXPECT_EQ(file.notes[0], "a.obj: no .mtl file describes 'red'; such materials are white");
    write(folder.file("a.mtl"), "newmtl 1\nKd 1 0 0\n");
    std::string many = "mtllib a.mtl\n" + std::string(triangle);
    for (const char* const name : {"1", "2", "3", "4", "5", "6", "7"})
        many += "usemtl " + std::string(name) + "\nf 1 2 3\n";
    write(model, many);
    ASSERT_EQ(l3d_load_model(model, "a.obj").notes.size(), 1u);
    EXPECT_EQ(l3d_load_model(model, "a.obj").notes[0],
              "a.obj: no .mtl file describes 'red', '2', '3', '4', '5' and 2 more; such materials "
              "are white");
    write(model, "Named object: \"a\"\nTri-mesh, Vertices: 3 Faces: 1\nVertex list:\n"
                 "Vertex 0: X:0 Y:0 Z:0\nVertex 1: X:1 Y:0 Z:0\nVertex 2: X:0 Y:1 Z:0\n"
                 "Face list:\nFace 0: A:0 B:1 C:2 AB:1 BC:1 CA:1\nMaterial:\"r1g2b3a0\"\n");
    EXPECT_TRUE(l3d_load_model(model, "a.asc").notes.empty());
}

TEST(model_loader, gives_patches_their_materials) {
    const temporary_folder folder;
    const std::string model = folder.file("a.obj");
    const std::string surface = "surf 0 1 0 1 1 2 3 4\nparm u 0 1\nparm v 0 1\nend\n";
    write(model, "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\ncstype bezier\ndeg 1 1\n" +
                     surface + "usemtl lid\n" + surface + surface);
    write(folder.file("a.mtl"), "newmtl lid\nKd 0 0 1\n");
    const l3d_patch_model patches = l3d_patch_model::load(model);
    ASSERT_EQ(patches.materials().size(), 2u);
    EXPECT_EQ(patches.materials()[patches.material_of(0)], l3d_material());
    for (const std::size_t i : {1u, 2u})
        EXPECT_EQ(patches.materials()[patches.material_of(i)], l3d_material{.color = 0x0000ff});
}

TEST(patch_scene, lists_the_materials_of_its_instances) {
    std::vector<l3d_patch_model::patch> two(2);
    for (std::size_t i = 0; i < 16; ++i)
        for (auto& patch : two)
            patch.points[i] = {static_cast<double>(i % 4), static_cast<double>(i / 4), 0.0};
    const l3d_patch_model plain(two);
    const l3d_material red{.color = 0xff0000}, blue{.color = 0x0000ff}, each[] = {red, blue};
    const l3d_patch_model both = plain.painted(each);
    EXPECT_EQ(both.identity(), plain.identity());
    EXPECT_NE(both.paint_identity(), plain.paint_identity());
    EXPECT_TRUE(plain.painted(l3d_material()).materials().empty());
    EXPECT_EQ(plain.painted(red).materials().size(), 1u);

    l3d_patch_scene scene;
    scene.add(plain);
    EXPECT_TRUE(scene.materials().empty());
    EXPECT_EQ(scene.material_of(0, 1), 0u);
    for (const l3d_patch_model& model : {both, both, plain})
        scene.add(model);
    scene.paint(2, blue);
    EXPECT_EQ(scene.materials().size(), 4u) << "the plain one, two of the model, one painted";
    const auto seen = [&](std::size_t instance, std::size_t patch) {
        return scene.materials()[scene.material_of(instance, patch)];
    };
    for (const std::size_t i : {0u, 1u}) {
        EXPECT_EQ(seen(0, i), l3d_material());
        EXPECT_EQ(seen(1, i), each[i]);
        EXPECT_EQ(seen(2, i), blue);
        EXPECT_EQ(seen(3, i), l3d_material());
    }
    scene.forget_changes();
    scene.paint(1, std::nullopt);
    scene.paint(2, blue);
    EXPECT_FALSE(scene.is_changed()) << "nothing looks otherwise";
    scene.paint(1, red);
    ASSERT_EQ(scene.moved().size(), 1u);
    EXPECT_EQ(scene.moved()[0], 1u);
    EXPECT_EQ(seen(1, 1), red);
    scene.forget_changes();
    scene.place(3, both, l3d_identity<double>());
    EXPECT_TRUE(scene.is_changed()) << "the same patches, painted otherwise";
    EXPECT_EQ(seen(3, 1), blue);
}

TEST(model_loader, makes_hills_of_a_picture) {
    const temporary_folder folder;
    const std::string path = folder.file("hill.png");
    std::vector<std::uint32_t> words(8 * 3, 0x00000000);
    words[8 + 2] = 0x00ffffff;
    words[8 + 3] = 0x00333333;
    l3d_write_png(path, {words.data(), 8, 3, 8});
    const std::vector<l3d_patch_points> patches = l3d_load_model(path, path).patches;
    ASSERT_EQ(patches.size(), 14U);
    EXPECT_EQ(patches[2].points[3][1], 2);             // white: a quarter of 8
    EXPECT_NEAR(patches[2].points[15][1], 0.4, 1e-15); // a fifth of that
    EXPECT_NEAR(patches[2].points[0][0], -1.5, 1e-15);
    l3d_write_png(path, {words.data(), 8, 1, 8});
    try {
        l3d_load_model(path, "hill.png");
        FAIL() << "one row is no field";
    } catch (const l3d_error& error) {
        EXPECT_STREQ(error.what(), "hill.png: height field: 8 heights make no two or more whole "
                                   "rows of 8 columns");
    }
}

/// The bytes of a grey PNG of 16 bits.
std::string png_of_16_bits(l3d_size size, const std::vector<std::uint16_t>& levels) {
    png_image picture{};
    picture.version = PNG_IMAGE_VERSION;
    picture.width = static_cast<png_uint_32>(size.width);
    picture.height = static_cast<png_uint_32>(size.height);
    picture.format = PNG_FORMAT_LINEAR_Y;
    png_alloc_size_t length = 0;
    png_image_write_to_memory(&picture, nullptr, &length, 0, levels.data(), 0, nullptr);
    std::string bytes(length, '\0');
    EXPECT_NE(
        png_image_write_to_memory(&picture, bytes.data(), &length, 0, levels.data(), 0, nullptr),
        0);
    return bytes;
}

/// Steps of one 16-bit level are there, and a file that is cut off is refused.
TEST(model_loader, makes_hills_of_all_16_bits_of_a_picture) {
    const temporary_folder folder;
    const std::string path = folder.file("fine.png");
    const std::string bytes =
        png_of_16_bits({4, 3}, {0, 1, 257, 65535, 0, 1, 258, 65535, 0, 2, 300, 65535});
    write(path, bytes);
    const std::vector<l3d_patch_points> patches = l3d_load_model(path, path).patches;
    ASSERT_EQ(patches.size(), 6U);
    EXPECT_NEAR(patches[0].points[12][1], 1 / 65535.0, 1e-15);
    EXPECT_NEAR(patches[1].points[12][1], 257 / 65535.0, 1e-15);
    EXPECT_NEAR(patches[4].points[12][1], 258 / 65535.0, 1e-15);
    EXPECT_EQ(patches[2].points[12][1], 1);
    for (const std::size_t length : {std::size_t{8}, std::size_t{20}, bytes.size() / 2}) {
        write(path, bytes.substr(0, length));
        try {
            l3d_load_model(path, "fine.png");
            FAIL() << length;
        } catch (const l3d_error& error) {
            EXPECT_EQ(std::string(error.what()).rfind("fine.png: ", 0), 0U) << error.what();
        }
    }
}

} // namespace
