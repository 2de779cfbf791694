// SPDX-License-Identifier: MIT
// Wavefront files: polygons, names and normals, and free-form surfaces.
#include "geom/files/model_file.h"

#include "model_text.h"

#include <gtest/gtest.h>

namespace {

using point = std::array<double, 3>;
using vector = l3d_polygon_mesh::vector;
using numbers = std::vector<std::uint32_t>;

constexpr std::string_view square = "v 1.5 2 3\nv 4 5 6\nv 7 8 9\nv 10 11 12\n";

l3d_model_file read(std::string_view text) {
    return model_text::read_by(l3d_read_obj, text, "name");
}

std::string complaint(std::string_view text) {
    return model_text::complaint_of(l3d_read_obj, text, "name");
}

/// The error in statements after the four vertices, which are lines 1 to 4.
std::string complaint_after(std::string_view statements) {
    return complaint(std::string(square).append(statements));
}

l3d_model_file read_after(std::string_view statements) {
    return read(std::string(square).append(statements));
}

TEST(obj_file, has_faces_by_numbers_from_both_ends) {
    const l3d_polygon_mesh mesh =
        read_after("f 1 2 3\nf -4 -3 \\\n -2 -1 # all\nf 1/7 3/8 4/9\n").mesh;
    EXPECT_EQ(mesh.vertices[3], vector(10, 11, 12));
    EXPECT_EQ(mesh.corners, (numbers{0, 1, 2, 0, 1, 2, 3, 0, 2, 3}));
    EXPECT_EQ(mesh.face_ends, (numbers{3, 7, 10}));
}

TEST(obj_file, has_parts_and_materials) {
    const l3d_polygon_mesh mesh =
        read_after("o A body\nf 1 2 3\nusemtl red\ng\tside \nf 2 3 4\nusemtl blue\nf 1 3 4\n"
                   "usemtl red\nf 1 2 4\n")
            .mesh;
    EXPECT_EQ(mesh.parts, (std::vector<l3d_part_run>{{"A body", 0}, {"side", 1}}));
    EXPECT_EQ(mesh.materials, (std::vector<std::string>{"red", "blue", ""}));
    EXPECT_EQ(mesh.face_materials, (numbers{2, 0, 1, 0}));
}

TEST(obj_file, has_parts_of_faces_and_of_surfaces) {
    const std::string surface = "surf 0 1 0 1 1 2 3 4\nparm u 0 1\nparm v 0 1\nend\n";
    const l3d_model_file file =
        read_after("cstype bezier\ndeg 1 1\n" + surface + "g a\nf 1 2 3\n" + surface + surface +
                   "g nothing\ng b\n" + surface + "g a\n" + surface + "f 1 2 4\n");
    EXPECT_EQ(file.mesh.parts, (std::vector<l3d_part_run>{{"a", 0}, {"a", 1}}));
    EXPECT_EQ(file.patch_parts, (std::vector<l3d_part_run>{{"a", 1}, {"b", 3}, {"a", 4}}));
    const l3d_parts parts(file.patch_parts, file.patches.size());
    EXPECT_EQ(parts.of(0), l3d_parts::none);
    EXPECT_EQ(parts.of(1), parts.of(4));
    EXPECT_EQ(parts.size_of(0), 3u);
    EXPECT_EQ(parts.complaint("b"), "");
    EXPECT_EQ(parts.complaint("nothing"), "'nothing' names no part; there are a, b");
    std::string why;
    const auto again = l3d_read_obj(l3d_write_obj(file), "again", why);
    ASSERT_TRUE(again) << why;
    EXPECT_EQ(again->mesh.parts, file.mesh.parts);
    EXPECT_EQ(again->patch_parts, file.patch_parts);

    // The writer has patches before faces, and the names of those must not become names of these.
    const l3d_model_file nameless = read_after("cstype bezier\ndeg 1 1\nf 1 2 3\ng a\n" + surface);
    const auto kept = l3d_read_obj(l3d_write_obj(nameless), "again", why);
    ASSERT_TRUE(kept) << why;
    EXPECT_TRUE(kept->mesh.parts.empty());
    EXPECT_EQ(kept->patch_parts, (std::vector<l3d_part_run>{{"a", 0}}));
}

TEST(obj_file, has_normals_in_the_order_of_its_vertices) {
    const std::string normals = "vn 1 0 0\nvn 0 2 0\nvn 0 0 3\nvn 1 1 1\n";
    const l3d_model_file mixed = read_after(normals + "f 1//4 2//3 3//2\nf 2/1/3 3/1/2 4/1/1\n");
    EXPECT_EQ(mixed.mesh.vertex_normals,
              (std::vector<vector>{{1, 1, 1}, {0, 0, 3}, {0, 2, 0}, {1, 0, 0}}));
    EXPECT_EQ(mixed.notes, std::vector<std::string>{});
}

TEST(obj_file, says_where_and_what_is_wrong) {
    EXPECT_EQ(complaint_after("f 1 2 5\n"), "name:5: '5', an index, names none of the 4 before it");
    EXPECT_EQ(complaint_after("f 1 2 0\n"), "name:5: '0', an index, names none of the 4 before it");
    EXPECT_EQ(complaint_after("\nf 1 -5 2\n"),
              "name:6: '-5', an index, names none of the 4 before it");
    EXPECT_EQ(complaint_after("f 1//1 2//1 3//1\n"),
              "name:5: '1', an index, names none of the 0 before it");
    EXPECT_EQ(complaint_after("f 1 2 x"), "name:5: 'x', an index, is not a whole number");
    EXPECT_EQ(complaint_after("v 1 2"), "name:5: the line ends where a coordinate should be");
    EXPECT_EQ(complaint_after("v 1 2 inf\nf 1 2 5"), "name:5: 'inf', a coordinate, is not finite");
    EXPECT_EQ(complaint_after("v 1 2 -1e13\nf 1 2 5"),
              "name:5: '-1e13', a coordinate, is beyond 1e12");
    EXPECT_EQ(complaint_after("v 1 nan 3\ncstype bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 3 5\n"
                              "parm u 0 1\nparm v 0 1\nend\n"),
              "name:5: 'nan', a coordinate, is not finite");
}

TEST(obj_file, notes_each_kind_of_statement_that_is_skipped_once) {
    const std::vector<std::string> notes{"name:5: statements 'call' are skipped",
                                         "name:8: statements 'scrv' are skipped"};
    EXPECT_EQ(read_after("call 1 2\ncall 3\ns off\nscrv 0 1 1\nparm u 0 1\nend\n").notes, notes);
}

TEST(obj_file, has_lines_and_curves_in_space) {
    const l3d_model_file file =
        read_after("l 1/1 2/1 -1\nusemtl red\ncstype rat bspline\ndeg 2\nv 1 1 1 2\n"
                   "curv 0.25 1 1 2 5 3\nparm u 0 0 0 0.5 1 1 1\nend\n"
                   "cstype bezier\ncurv 0 2 1 2 3 2 1\nparm u 0 1 2\nend\nf 1 2 3\n");
    ASSERT_EQ(file.curves.size(), 3U);
    EXPECT_EQ(file.curves[0],
              l3d_nurbs_curve::polyline({{1.5, 2.0, 3.0}, {4.0, 5.0, 6.0}, {10.0, 11.0, 12.0}}));
    EXPECT_EQ(file.curves[1].weights(), (std::vector<double>{1, 1, 2, 1}));
    EXPECT_EQ(file.curves[1].along().from, 0.25);
    EXPECT_EQ(file.curves[1].evaluate(1), (vector{7.0, 8.0, 9.0}));
    EXPECT_EQ(file.curves[2].evaluate(1), (vector{7.0, 8.0, 9.0}));
    EXPECT_EQ(file.mesh.materials, (std::vector<std::string>{"red", ""}));
    EXPECT_EQ(file.curve_materials, (numbers{1, 0, 0}));
    EXPECT_EQ(file.mesh.vertices.size(), 3U) << "points of curves alone are no vertices";
    EXPECT_TRUE(file.notes.empty());
    EXPECT_EQ(read(l3d_write_obj(file)), file);
}

TEST(obj_file, says_what_is_wrong_with_a_curve) {
    EXPECT_EQ(complaint_after("l 1 5\n"), "name:5: '5', an index, names none of the 4 before it");
    EXPECT_EQ(complaint_after("curv 0 1 1 2\n"), "name:5: a curve before cstype");
    EXPECT_EQ(complaint_after("cstype bezier\ncurv 0 1 1 2\n"), "name:6: a curve before deg");
    const std::string begin = "cstype bspline\ndeg 1\n";
    EXPECT_EQ(complaint_after(begin + "curv 1 0 1 2\n"),
              "name:7: the range of a parameter is empty");
    EXPECT_EQ(complaint_after(begin + "curv 0 1 1 2\nparm v 0 0 1 1\n"),
              "name:8: parm of a curve is not followed by u");
    EXPECT_EQ(complaint_after(begin + "curv 0 1 1 2\nparm u 0 0 0.5 1 1\nend\n"),
              "name:9: the curve has 2 control points; its parameters ask for 3");
    EXPECT_EQ(complaint_after(begin + "curv 0 1 1 2\nparm u 0 0 1 1\n"),
              "name:9: the text ends in a curve, before its end");
    EXPECT_EQ(complaint_after("cstype rat bspline\ndeg 1\nv 1 2 3 -1\ncurv 0 1 1 5\n"
                              "parm u 0 0 1 1\nend\n"),
              "name:10: the weight of vertex 5, a control point, is not from 1e-100 to 1e12");
    EXPECT_EQ(complaint_after("cstype rat bspline\ndeg 1\nv 1 2 3 2e12\ncurv 0 1 1 5\n"
                              "parm u 0 0 1 1\nend\n"),
              "name:10: the weight of vertex 5, a control point, is not from 1e-100 to 1e12");
    EXPECT_EQ(
        read_after("cstype taylor\ndeg 1\ncurv 0 1 1 2\nparm u 0 1\nend\nl 1\n").notes,
        (std::vector<std::string>{"name:7: curves that are neither bezier nor bspline are skipped",
                                  "name:10: lines of fewer than two vertices are skipped"}));
}

TEST(obj_file, has_places_in_pictures_from_the_bottom_of_these) {
    using places = std::vector<l3d_polygon_mesh::picture_place>;
    const l3d_model_file file = read_after("vt 0.25 0.75\nvt 0.5\nvt 1 2 3\nf 1/1 2/-1/ 3/2\n"
                                           "f 1 2/3 3\nf 1/4 2/x 3/1\nf 1/1 2/1\nf 1 2 3\n");
    EXPECT_EQ(file.mesh.picture_places, (places{{0.25F, 0.25F},
                                                {1, -1},
                                                {0.5F, 1},
                                                {0, 0},
                                                {1, -1},
                                                {0, 0},
                                                {0, 0},
                                                {0, 0},
                                                {0.25F, 0.25F},
                                                {0, 0},
                                                {0, 0},
                                                {0, 0}}));
    EXPECT_TRUE(file.mesh.is_valid());
    EXPECT_EQ(file.notes, (std::vector<std::string>{
                              "name:10: places in pictures that there are not are taken for (0, 0)",
                              "name:11: a face of 2 corners is skipped"}));
}

/// Corners of one vertex with several normals become several vertices, each with its colour.
TEST(obj_file, keeps_colours_of_vertices_that_normals_divide) {
    const l3d_model_file file =
        read("v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nvn 0 0 1\nvn 0 1 0\n"
             "f 1//1 2//1 3//1\nf 1//2 2//1 3//2\n");
    ASSERT_EQ(file.mesh.vertices.size(), 5u);
    EXPECT_EQ(file.mesh.vertex_colors,
              (std::vector<std::uint32_t>{0xff0000, 0x00ff00, 0x0000ff, 0xff0000, 0x0000ff}));
}

/// The parameter file of a course's whiteboards.
TEST(obj_file, has_the_window_and_the_viewport_of_two_dimensions) {
    const l3d_model_file file = read("w 1.0 0.5 5.0 3.0\ns 0.25 0 0.75 1\nv 2 2 0\nv 2 1 0\n"
                                     "v 4 1 0\nv 4 2 0\ns off\ns 1\ns\nf 1 2 3\nf 3 4 1\n");
    EXPECT_EQ(file.window, (l3d_model_window{1, 0.5, 5, 3}));
    EXPECT_EQ(file.viewport, (l3d_model_window{0.25, 0, 0.75, 1}));
    EXPECT_EQ(file.mesh.corners, (numbers{0, 1, 2, 2, 3, 0}));
    EXPECT_TRUE(file.notes.empty());
    std::string why;
    EXPECT_EQ(l3d_read_obj(l3d_write_obj(file), "again", why), file);
    const auto alone = l3d_read_model("w 0 0 4 3\n", "name", why);
    ASSERT_TRUE(alone) << why;
    EXPECT_EQ(alone->window, (l3d_model_window{0, 0, 4, 3}));
    EXPECT_FALSE(alone->viewport);
}

TEST(obj_file, says_what_is_wrong_with_windows_and_viewports) {
    const std::string order = " is not beyond the one opposite: they are xmin ymin xmax ymax";
    EXPECT_EQ(complaint_after("w 1 2 3"),
              "name:5: the line ends where a border of the window should be");
    EXPECT_EQ(complaint_after("w"), "name:5: the line ends where a border of the window should be");
    EXPECT_EQ(complaint_after("w 1 2 3 4 5"), "name:5: '5' at the end of a statement");
    EXPECT_EQ(complaint_after("w 1 2 x 4"), "name:5: 'x', a border of the window, is not a number");
    EXPECT_EQ(complaint_after("w 1 2 nan 4"),
              "name:5: 'nan', a border of the window, is not finite");
    EXPECT_EQ(complaint_after("w 1 2 1 4"), "name:5: a border of the window" + order);
    EXPECT_EQ(complaint_after("w 1 2 5 -4"), "name:5: a border of the window" + order);
    EXPECT_EQ(complaint_after("s 0 0 1"),
              "name:5: the line ends where a border of the viewport should be");
    EXPECT_EQ(complaint_after("s 0 0.5 1 0.5"), "name:5: a border of the viewport" + order);
    EXPECT_EQ(complaint_after("s 0 0 1 1.5"),
              "name:5: the viewport leaves the picture, which is from 0 to 1");
}

TEST(obj_surface, of_several_bezier_patches_is_cut_at_its_parameters) {
    const l3d_model_file model = read_after("v 1 2 9\nv 3 4 7\n"
                                            "cstype bezier\ndeg 1 1\n"
                                            "surf 0 7 0 1 1 2 3 -3 -2/5 -1\n"
                                            "parm u 0 2 7\nparm v 0 1\nend\n");
    ASSERT_EQ(model.patches.size(), 2u);
    EXPECT_EQ(model.patches[0].degree_u, 1);
    EXPECT_EQ(model.patches[0].points,
              (std::vector<point>{{1.5, 2, 3}, {4, 5, 6}, {10, 11, 12}, {1, 2, 9}}));
    EXPECT_EQ(model.patches[1].points,
              (std::vector<point>{{4, 5, 6}, {7, 8, 9}, {1, 2, 9}, {3, 4, 7}}));
    EXPECT_TRUE(model.mesh.vertices.empty()); // they are control points
}

TEST(obj_surface, range_may_be_a_part) {
    const l3d_model_file model = read("v 1 2 3\nv 3 2 3\nv 1 2 5\nv 3 2 5\ncstype bezier\ndeg 1 1\n"
                                      "surf 0.25 0.5 0 1 1 2 3 4\nparm u 0 1\nparm v 0 1\nend\n");
    ASSERT_EQ(model.patches.size(), 1u);
    EXPECT_EQ(model.patches[0].points,
              (std::vector<point>{{1.5, 2, 3}, {2, 2, 3}, {1.5, 2, 5}, {2, 2, 5}}));
}

TEST(obj_surface, is_rational_if_its_weights_differ) {
    const std::string_view statements = "cstype rat bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\n"
                                        "parm u 0 1\nparm v 0 1\nend\n";
    const std::string equal = "v 1 2 3 2\nv 3 2 3 2\nv 1 2 5 2\nv 3 2 5 2\n";
    EXPECT_EQ(read(equal + std::string(statements)).patches.at(0).points[1], (point{3, 2, 3}));
    const std::string unequal = "v 1 2 3\nv 3 2 3\nv 1 2 5\nv 3 2 5 0.5\n";
    const l3d_patch_points rational = read(unequal + std::string(statements)).patches.at(0);
    EXPECT_EQ(rational.points[3], (point{3, 2, 5}));
    EXPECT_EQ(rational.weights, (std::vector<double>{1, 1, 1, 0.5}));
}

TEST(obj_surface, says_where_and_what_is_wrong) {
    const std::string head = "cstype bspline\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\n"; // lines 5 to 7
    EXPECT_EQ(complaint_after("surf 0 1 0 1 1"), "name:5: a surface before cstype");
    EXPECT_EQ(complaint_after("cstype taylor\ndeg 1 1\nsurf 0 1 0 1 1"),
              "name:7: a surface that is neither bezier nor bspline");
    EXPECT_EQ(complaint_after("cstype nurbs"), "name:5: 'nurbs' is no type of curve or surface");
    EXPECT_EQ(complaint_after("cstype bezier\ndeg 3\nsurf 0 1 0 1 1"),
              "name:7: a surface before deg with two degrees");
    EXPECT_EQ(complaint_after(head), "name:8: the text ends in a surface, before its end");
    EXPECT_EQ(complaint_after(head + head), "name:10: a surface begins before the last one's end");
    EXPECT_EQ(complaint_after("cstype bezier\ndeg 1 1\nsurf 1 1 0 1 1 2 3 4\n"),
              "name:7: the range of a parameter is empty");
}

TEST(obj_surface, that_names_the_same_points_again_and_again_is_refused) {
    std::string text = "v 1 2 3\ncstype bspline\ndeg 3 3\nsurf 3 100 3 100";
    for (int i = 0; i < 100 * 100; ++i)
        text += " 1";
    for (const char* const parm : {"\nparm u", "\nparm v"}) {
        text += parm;
        for (int i = 0; i < 104; ++i)
            text += ' ' + std::to_string(i);
    }
    EXPECT_EQ(complaint(text + "\nend\n"),
              "name:7: the surfaces and curves take more than 48 times the memory of the text");
}

} // namespace
