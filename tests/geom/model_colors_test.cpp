// SPDX-License-Identifier: MIT
// Colours from every format of models that has them.
#include "geom/files/model_file.h"
#include "geom/polygon_shapes.h"

#include "model_text.h"

#include <gtest/gtest.h>

namespace {

using words = std::vector<std::uint32_t>;
using texts = std::vector<std::string>;

l3d_polygon_mesh mesh_of(l3d_model_reader& reader, std::string_view text) {
    return model_text::read_by(reader, text, "name").mesh;
}

/// Faces whose corners are alike have colours of their own; one that differs is blended.
TEST(model_colors, of_vertices_are_kept_to_be_blended) {
    const std::string_view ply =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
        "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n1 1 0 255 255 255\n3 0 1 2\n4 0 1 3 2\n";
    const l3d_model_file of_ply = model_text::read_by(l3d_read_ply, ply, "name");
    EXPECT_EQ(of_ply.mesh.vertex_colors, (words{0xff0000, 0x00ff00, 0x0000ff, 0xffffff}));
    EXPECT_TRUE(of_ply.mesh.face_colors.empty());
    EXPECT_TRUE(of_ply.notes.empty());
    EXPECT_EQ(mesh_of(l3d_read_off, "COFF 3 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 0 0.4 1 0 1\n"
                                    "3 0 1 2\n")
                  .vertex_colors,
              (words{0xff0000, 0xff0000, 0x66ff00}));
    EXPECT_EQ(mesh_of(l3d_read_obj, "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 1\n")
                  .vertex_colors,
              (words{0xff0000, 0xff0000, 0xffffff}));
    EXPECT_EQ(mesh_of(l3d_read_obj, "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0\nf 1 2 1\n").face_colors,
              words{0xff0000});
}

/// By all the names and types that programs write.
TEST(model_colors, of_ply_have_many_names_and_types) {
    const auto colors = [](const std::string& type, const std::string& r, const std::string& g,
                           const std::string& b, const std::string& values) {
        const std::string color = "property " + type + ' ';
        const std::string properties = color + r + '\n' + color + g + '\n' + color + b + '\n';
        const std::string head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                                 "property float y\nproperty float z\n";
        const std::string list = "property list uchar int vertex_indices\n";
        const words of_vertices =
            mesh_of(l3d_read_ply, head + properties + "element face 1\n" + list +
                                      "end_header\n0 0 0 " + values + "\n1 0 0 " + values +
                                      "\n0 1 0 " + values + "\n3 0 1 2\n")
                .face_colors;
        EXPECT_EQ(of_vertices,
                  mesh_of(l3d_read_ply, head + "element face 1\n" + list + properties +
                                            "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 " + values +
                                            '\n')
                      .face_colors);
        return of_vertices;
    };
    EXPECT_EQ(colors("uchar", "red", "green", "blue", "255 128 0"), words{0xff8000});
    EXPECT_EQ(colors("uchar", "diffuse_red", "diffuse_green", "diffuse_blue", "255 128 0"),
              words{0xff8000});
    EXPECT_EQ(colors("uint8", "r", "g", "b", "255 128 0"), words{0xff8000});
    EXPECT_EQ(colors("ushort", "red", "green", "blue", "65535 32896 0"), words{0xff8000});
    EXPECT_EQ(colors("int", "red", "green", "blue", "255 128 0"), words{0xff8000});
    EXPECT_EQ(colors("float", "red", "green", "blue", "1 0.5 0"), words{0xff8000});
    EXPECT_EQ(colors("double", "r", "g", "b", "1 0.5 -0.25"), words{0xff8000});
}

/// Numbers up to 255 where others are up to 1: the largest tells.
TEST(model_colors, of_vertices_may_be_levels) {
    EXPECT_EQ(mesh_of(l3d_read_obj, "v 0 0 0 255 0 1\nv 1 0 0 255 0 1\nv 0 1 0 255 0 1\nf 1 2 3\n")
                  .face_colors,
              words{0xff0001});
    EXPECT_EQ(mesh_of(l3d_read_obj, "v 0 0 0 1.001 0 1\nv 1 0 0 1 0 1\nv 0 1 0 1 0 1\nf 1 2 3\n")
                  .face_colors,
              words{0xff00ff});
}

/// Those of control points, which go, do not move to the vertices behind them.
TEST(model_colors, of_vertices_stay_with_theirs_beside_surfaces) {
    EXPECT_EQ(mesh_of(l3d_read_obj, "v 0 0 0 0 1 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\ncstype bezier\n"
                                    "deg 1 1\nsurf 0 1 0 1 1 2 3 4\nparm u 0 1\nparm v 0 1\nend\n"
                                    "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nf 5 6 7\n")
                  .face_colors,
              words{0xff0000});
}

TEST(model_colors, of_faces_come_before_those_of_vertices) {
    EXPECT_EQ(mesh_of(l3d_read_off, "COFF 3 2 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 0 1 0 0 1\n"
                                    "3 0 1 2 0 0 255\n3 0 2 1\n")
                  .face_colors,
              (words{0x0000ff, 0xaaaaaa}));
}

TEST(model_colors, of_3d_studio_are_the_names_of_materials) {
    const std::string head =
        "Named object: \"a\"\nTri-mesh, Vertices: 3 Faces: 3\nVertex list:\n"
        "Vertex 0: X:0 Y:0 Z:0\nVertex 1: X:1 Y:0 Z:0\nVertex 2: X:0 Y:1 Z:0\nFace list:\n";
    const auto face = [](int i, const std::string& material) {
        return "Face " + std::to_string(i) + ": A:0 B:1 C:2\nMaterial:\"" + material + "\"\n";
    };
    const l3d_polygon_mesh mesh = mesh_of(
        l3d_read_asc, head + face(0, "r255g128b0a0") + face(1, "BLUE") + face(2, "r1g2b256a0"));
    EXPECT_EQ(mesh.look_of(0).color, 0xff8000u);
    EXPECT_EQ(mesh.look_of(1).color, 0xffffffu);
    EXPECT_EQ(mesh.look_of(2).color, 0xffffffu) << "no component is more than 255";
    EXPECT_TRUE(mesh_of(l3d_read_asc, head + face(0, "BLUE") + face(1, "BLUE") + face(2, "r"))
                    .looks.empty());
}

TEST(model_colors, of_obj_files_are_looked_up_by_name) {
    l3d_model_file model = model_text::read_by(
        l3d_read_obj,
        "mtllib a b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\nusemtl none\nf 1 2 3\n"
        "mtllib more.mtl\n",
        "name");
    EXPECT_EQ(model.material_files,
              (std::vector<l3d_material_file>{{"a b.mtl", 1}, {"more.mtl", 9}}));
    EXPECT_EQ(model.material_files[1].line, 9u);
    EXPECT_EQ(model.notes, texts{});
    EXPECT_TRUE(model.mesh.looks.empty());
    const l3d_named_material materials[] = {{"red", {.color = 0x800000}},
                                            {"red", {.color = 0xff0000}}};
    l3d_give_looks(model.mesh, materials);
    EXPECT_EQ(model.mesh.look_of(0).color, 0xff0000u);
    EXPECT_EQ(model.mesh.look_of(1), l3d_material());
    EXPECT_TRUE(model.mesh.is_valid());
}

TEST(model_colors, of_vertices_survive_both_writers) {
    l3d_model_file model;
    model.mesh = l3d_torus_mesh(5, 4);
    for (std::uint32_t i = 0; i < model.mesh.vertices.size(); ++i)
        model.mesh.vertex_colors.push_back(0x0c4321 * i & 0xffffff);
    EXPECT_EQ(model_text::read_by(l3d_read_obj, l3d_write_obj(model), "name").mesh, model.mesh);
    for (const bool normals : {false, true}) {
        if (normals)
            model.mesh.vertex_normals = model.mesh.vertices;
        const std::string text = l3d_write_off(model.mesh);
        EXPECT_TRUE(text.starts_with(normals ? "CNOFF\n" : "COFF\n"));
        EXPECT_EQ(model_text::read_by(l3d_read_off, text, "name").mesh, model.mesh);
    }
}

TEST(model_colors, of_patches_of_obj_files_are_those_before_surf) {
    std::string text = "cstype bezier\ndeg 1 1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
    const std::string surface = "surf 0 1 0 1 1 2 3 4\nparm u 0 1\nparm v 0 1\nend\n";
    const l3d_model_file plain = model_text::read_by(l3d_read_obj, text + surface, "name");
    EXPECT_TRUE(plain.patch_materials.empty());
    text +=
        surface + "usemtl lid\n" + surface + "usemtl body\n" + surface + "usemtl lid\n" + surface;
    const l3d_model_file model = model_text::read_by(l3d_read_obj, text, "name");
    EXPECT_EQ(model.mesh.materials, (texts{"lid", "body", ""}));
    EXPECT_EQ(model.patch_materials, (words{2, 0, 1, 0}));
    EXPECT_EQ(model_text::read_by(l3d_read_obj, l3d_write_obj(model), "name"), model);
}

std::vector<l3d_named_material> read_mtl(std::string_view text, texts expected_notes = {}) {
    texts notes;
    const auto result = l3d_read_mtl(text, "a.mtl", notes);
    EXPECT_EQ(notes, expected_notes);
    return result;
}

TEST(mtl_file, has_colors_and_highlights) {
    EXPECT_EQ(read_mtl("# by hand\nnewmtl shiny red\nKa 0 0 0\nKd 1 .5 0\nKs 0.2\nNs 90.5\n"
                       "illum 2\nnewmtl matt\r\n\tKd 0.1 0.2 0.3\r\nKs 1 1 1\nillum 1\n"),
              (std::vector<l3d_named_material>{
                  {"shiny red", {.color = 0xff8000, .highlight = 0x333333, .sharpness = 91}},
                  {"matt", {.color = 0x1a334d}}}));
    EXPECT_EQ(
        read_mtl("newmtl a\nNs 0\nnewmtl b\nNs 5000"),
        (std::vector<l3d_named_material>{{"a", {.sharpness = 1}}, {"b", {.sharpness = 1000}}}));
}

TEST(mtl_file, takes_colours_out_of_range_for_the_nearest) {
    EXPECT_EQ(read_mtl("newmtl a\nKd 1.001 0.5 -0.1\n",
                       {"a.mtl:2: colours out of range are taken for the nearest"}),
              (std::vector<l3d_named_material>{{"a", {.color = 0xff8000}}}));
}

TEST(mtl_file, notes_what_it_cannot_read_and_goes_on) {
    EXPECT_EQ(read_mtl("Kd 1 1 1\nnewmtl a\nKd 1 x 1\nKd 1 1\nKd 2 0 0\nKd nan 0 0\nKd spectral a\n"
                       "Ns\nNs many\nfoo 1\nmap_Ks a.png\nmap_Ks b.png\nTf 0.5 0 0\nKd 0 1 0\n",
                       {"a.mtl:1: 'Kd' before the first newmtl is skipped",
                        "a.mtl:3: 'x', a colour, is not a number: skipped",
                        "a.mtl:4: a colour of 2 components is skipped",
                        "a.mtl:5: colours out of range are taken for the nearest",
                        "a.mtl:6: 'nan', a colour, is not a number: skipped",
                        "a.mtl:7: 'spectral', a colour, is not a number: skipped",
                        "a.mtl:8: Ns without a number is skipped",
                        "a.mtl:9: Ns without a number is skipped",
                        "a.mtl:10: 'foo' begins no statement of an .mtl file",
                        "a.mtl:11: statements 'map_Ks' are skipped",
                        "a.mtl:13: statements 'Tf' are skipped"}),
              (std::vector<l3d_named_material>{{"a", {.color = 0x00ff00}}}));
}

TEST(mtl_file, names_pictures_behind_options) {
    const auto materials =
        read_mtl("newmtl a\nmap_Kd -s 2 2 1 -blendu off -o 0.5 -clamp on  my wood.png\n"
                 "newmtl b\nmap_Kd a.png\nmap_Kd -clamp off b.jpg\nnewmtl c\nmap_Kd -bm 2\n",
                 {"a.mtl:2: the option '-s' of a picture is skipped",
                  "a.mtl:2: the option '-blendu' of a picture is skipped",
                  "a.mtl:2: the option '-o' of a picture is skipped",
                  "a.mtl:7: the option '-bm' of a picture is skipped",
                  "a.mtl:7: 'map_Kd' without a name is skipped"});
    ASSERT_EQ(materials.size(), 3u);
    EXPECT_EQ(materials[0].picture, (l3d_mesh_picture{"my wood.png", "", false, false}));
    EXPECT_EQ(materials[1].picture, (l3d_mesh_picture{"b.jpg"}));
    EXPECT_EQ(materials[2].picture, l3d_mesh_picture());
    l3d_polygon_mesh mesh;
    mesh.materials = {"a", "b", "none", "b"};
    l3d_give_looks(mesh, materials);
    EXPECT_EQ(mesh.pictures.size(), 2u);
    EXPECT_EQ(mesh.looks[0].picture, 0);
    EXPECT_EQ(mesh.looks[1].picture, 1);
    EXPECT_EQ(mesh.looks[2].picture, l3d_material::no_picture);
    EXPECT_EQ(mesh.looks[3].picture, 1);
}

/// What every program writes says nothing; the rest makes a note for each kind.
TEST(mtl_file, notes_light_of_its_own_and_physical_models) {
    read_mtl("newmtl a\nKa 1.000 1.000 1.000\nKe 0.0 0.0 0.0\nNi 1.45\nPr 0\n");
    read_mtl("newmtl a\nKa 0.2 0.2 0.2\nKe 0 1 0\nKe 0 1 0\nPr 0.5\nPm 1\n",
             {"a.mtl:2: statements 'Ka' are skipped", "a.mtl:3: statements 'Ke' are skipped",
              "a.mtl:5: statements 'Pr' are skipped", "a.mtl:6: statements 'Pm' are skipped"});
}

TEST(mtl_file, has_opacity_by_d_or_by_its_opposite_tr) {
    using materials = std::vector<l3d_named_material>;
    EXPECT_EQ(read_mtl("newmtl a\nd 0.25\nnewmtl b\nTr 0.25\nnewmtl c\nd 0.4\nTr 0.6\nnewmtl d\n"),
              (materials{{"a", {.opacity = 0.25F}},
                         {"b", {.opacity = 0.75F}},
                         {"c", {.opacity = 0.4F}},
                         {"d", {}}}));
    EXPECT_EQ(read_mtl("newmtl a\nd 0.5\nTr 0.1\nnewmtl b\nTr 0.125\nd 0.5\n",
                       {"a.mtl:3: 'Tr' and 'd' do not add up to 1: 'd' is taken",
                        "a.mtl:6: 'Tr' and 'd' do not add up to 1: 'd' is taken"}),
              (materials{{"a", {.opacity = 0.5F}}, {"b", {.opacity = 0.5F}}}));
    EXPECT_EQ(read_mtl("d 1\nnewmtl a\nd 1.5\nTr -0.1\nd\nd much\nd nan\nd -halo 0.5\nTr\n",
                       {"a.mtl:1: 'd' before the first newmtl is skipped",
                        "a.mtl:3: 'd' is '1.5', which is not from 0 to 1: skipped",
                        "a.mtl:4: 'Tr' is '-0.1', which is not from 0 to 1: skipped",
                        "a.mtl:5: 'd' without a number is skipped",
                        "a.mtl:6: 'd' without a number is skipped",
                        "a.mtl:7: 'd' without a number is skipped",
                        "a.mtl:8: '-halo' is not drawn: the material is as opaque from all sides",
                        "a.mtl:9: 'Tr' without a number is skipped"}),
              (materials{{"a", {.opacity = 0.5F}}}));
}

TEST(polygon_mesh, keeps_colors_and_materials_when_another_is_appended) {
    const auto triangle = [] {
        l3d_polygon_mesh mesh;
        mesh.vertices.assign(3, {0.0, 0.0, 0.0});
        mesh.add_face(words{0, 1, 2});
        return mesh;
    };
    l3d_polygon_mesh red = triangle(), brass = triangle(), all;
    red.face_colors = {0xff0000};
    brass.face_materials = {0};
    brass.materials = {"brass"};
    brass.looks = {{.color = 0xb08020}};
    for (const l3d_polygon_mesh& mesh : {triangle(), red, brass, triangle(), brass})
        all.append(mesh);
    EXPECT_TRUE(all.is_valid());
    words colors;
    for (std::size_t f = 0; f < all.faces(); ++f)
        colors.push_back(all.look_of(f).color);
    EXPECT_EQ(colors, (words{0xffffff, 0xff0000, 0xb08020, 0xffffff, 0xb08020}));
    l3d_polygon_mesh plain = triangle();
    plain.append(triangle());
    EXPECT_TRUE(plain.face_colors.empty() && plain.face_materials.empty() && plain.looks.empty());
}

} // namespace
