// SPDX-License-Identifier: MIT
// Models of STEP and IGES files: parts, colours, places, units, edges; one line for each bad file.
#include "cad/records.h"
#include "cad/shapes.h"
#include "geom/files/model_file.h"
#include "geom/files/reading_progress_p.h"
#include "plugins/cad/document.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <gp_Ax2.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

using vector = l3d_nurbs_surface::vector;

double distance(const vector& a, const vector& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

l3d_model_file model_of(const std::string& path) {
    std::string why;
    auto model = l3d_read_model(cad_records::text_of(path), "part", why);
    EXPECT_TRUE(model) << why;
    return model ? *std::move(model) : l3d_model_file();
}

/// The model with a copy of each shape at each place.
l3d_model_file flat_model_of(const std::string& path) {
    return l3d_flattened(model_of(path));
}

/// The box of the control points of a part's patches: least and most x, y, z.
std::array<double, 6> box_of(const l3d_model_file& model, const std::string& part) {
    std::array<double, 6> box{1e9, 1e9, 1e9, -1e9, -1e9, -1e9};
    for (std::size_t run = 0; run < model.patch_parts.size(); ++run) {
        if (model.patch_parts[run].name != part)
            continue;
        const std::size_t end = run + 1 < model.patch_parts.size()
                                    ? model.patch_parts[run + 1].first
                                    : model.patches.size();
        for (std::size_t i = model.patch_parts[run].first; i < end; ++i)
            for (const auto& p : model.patches[i].points)
                for (std::size_t k = 0; k < 3; ++k) {
                    box[k] = std::min(box[k], p[k]);
                    box[k + 3] = std::max(box[k + 3], p[k]);
                }
    }
    return box;
}

void expect_box(const std::array<double, 6>& is, const std::array<double, 6>& wanted) {
    for (std::size_t k = 0; k < 6; ++k)
        EXPECT_NEAR(is[k], wanted[k], 1e-9) << k;
}

TEST(cad_file, of_an_assembly_has_its_parts_at_their_places_in_their_colors) {
    const cad_folder folder;
    write_assembly(folder.file("cart.step"));
    const l3d_model_file model = flat_model_of(folder.file("cart.step"));
    std::vector<std::string> names;
    for (const l3d_part_run& part : model.patch_parts)
        names.push_back(part.name);
    EXPECT_EQ(names, (std::vector<std::string>{"left", "right", "middle"}));
    expect_box(box_of(model, "left"), {-40, -10, 0, -20, 10, 4});
    expect_box(box_of(model, "right"), {20, -10, 0, 40, 10, 4});
    expect_box(box_of(model, "middle"), {-30, -2, 4, 30, 2, 6});
    ASSERT_EQ(model.patch_materials.size(), model.patches.size());
    const auto look = [&](std::size_t patch) {
        return model.mesh.looks[model.patch_materials[patch]];
    };
    // Both wheels are one shape, whose faces come first in the file: both ends, and what is round,
    // in pieces.
    ASSERT_EQ(model.patch_faces.size(), model.patches.size());
    const std::size_t right = model.patch_parts[1].first, beam = model.patch_parts[2].first;
    ASSERT_EQ(beam, 2 * right);
    std::set<std::uint32_t> of_wheel;
    for (std::size_t i = 0; i < right; ++i) {
        of_wheel.insert(model.patch_faces[i]);
        EXPECT_EQ(model.patch_faces[i], model.patch_faces[i + right]);
    }
    EXPECT_EQ(of_wheel, (std::set<std::uint32_t>{1, 2, 3}));
    EXPECT_EQ(model.patch_faces[beam], 4U);
    for (std::size_t i = 0; i < beam; ++i)
        EXPECT_EQ(look(i).color, 0xff0000U);
    int blue = 0;
    for (std::size_t i = beam; i < model.patches.size(); ++i)
        if (look(i).color == 0x0000ffU) {
            ++blue;
            EXPECT_FLOAT_EQ(look(i).opacity, 0.5F);
            for (const auto& p : model.patches[i].points)
                EXPECT_DOUBLE_EQ(p[0], -30) << "the first face of the box";
        } else
            EXPECT_EQ(look(i).color, 0xffffffU);
    EXPECT_EQ(blue, 1);
}

TEST(cad_file, of_a_thousand_bolts_has_one_bolt_at_a_thousand_places) {
    const cad_folder folder;
    write_rows_of_bolts(folder.file("bolts.step"), 100);
    const l3d_model_file model = model_of(folder.file("bolts.step"));
    ASSERT_EQ(model.shapes.size(), 1U);
    ASSERT_EQ(model.placements.size(), 1000U);
    EXPECT_LT(model.patches.size(), 100U);
    EXPECT_TRUE(model.patch_parts.empty());
    const l3d_model_placement& last = model.placements.back();
    EXPECT_EQ(last.name, "row 10/bolt 100");
    EXPECT_EQ(last.place(0, 3), 12 * 99);
    EXPECT_EQ(last.place(1, 3), 12 * 9);
    EXPECT_EQ(model.mesh.looks[last.material].color, 0xff0000U);
    EXPECT_EQ(model.mesh.looks[model.placements[0].material].color, 0x808c99U);
    EXPECT_TRUE(std::ranges::all_of(model.patch_materials, [](std::uint32_t material) {
        return material == l3d_material_of_place;
    }));
}

TEST(cad_file, is_read_with_progress_and_stops_when_asked) {
    const cad_folder folder;
    write_step(plate_with_holes(16), folder.file("a.step"));
    const std::string text = cad_records::text_of(folder.file("a.step"));
    std::vector<double> shares;
    std::string why;
    EXPECT_TRUE(l3d_detail::read_model({}, text, "part", why, [&](double share) {
        shares.push_back(share);
        return true;
    })) << why;
    ASSERT_FALSE(shares.empty());
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    EXPECT_GE(shares.front(), 0);
    EXPECT_EQ(shares.back(), 1);
    EXPECT_FALSE(l3d_detail::read_model({}, text, "part", why, [](double) { return false; }));
    EXPECT_EQ(why, "part: reading was stopped");
}

TEST(cad_file, tells_how_much_of_its_text_is_read) {
    constexpr std::size_t quarter = std::size_t{1} << 18;
    std::vector<double> shares;
    for (const std::size_t quarters : {1, 2, 3, 4}) {
        std::string text = "ISO-10303-21;\n" + std::string(4 * quarter, '\n');
        text.replace(quarters * quarter - 5, 5, "DATA;"); // the kernel stops: there is no header
        std::atomic<double> share = 0;
        l3d_detail::cad_writer to;
        EXPECT_EQ(cad::write_document(
                      text, false, to, [] {}, share),
                  "Open CASCADE cannot read it as STEP");
        shares.push_back(share);
    }
    EXPECT_LE(shares[3], 0.2) << "no shapes are made yet";
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(shares[i], shares[3] * static_cast<double>(i + 1) / 4, shares[3] / 16) << i;
    EXPECT_GT(shares[0], 0);
}

TEST(cad_file, has_the_same_places_as_copies_and_as_instances) {
    const cad_folder folder;
    write_assembly(folder.file("cart.step"));
    const l3d_model_file model = model_of(folder.file("cart.step"));
    const l3d_model_file flat = l3d_flattened(model);
    ASSERT_EQ(model.shapes.size(), 2U);
    ASSERT_EQ(model.placements.size(), 3U);
    EXPECT_TRUE(flat.placements.empty());
    EXPECT_TRUE(flat.shapes.empty());
    const std::size_t wheel = model.shapes[1].first_patch;
    ASSERT_EQ(flat.patches.size(), model.patches.size() + wheel);
    EXPECT_EQ(flat.edges.size(), model.edges.size() + l3d_shape_of(model, 0, 0).edges.size());
    // The second wheel is turned by 90 degrees about z, and moved by 30.
    for (std::size_t i = 0; i < wheel; ++i)
        for (std::size_t k = 0; k < model.patches[i].points.size(); ++k) {
            const auto& p = model.patches[i].points[k];
            const auto& q = flat.patches[wheel + i].points[k];
            EXPECT_NEAR(q[0], 30 - p[1], 1e-12);
            EXPECT_NEAR(q[1], p[0], 1e-12);
            EXPECT_NEAR(q[2], p[2], 1e-12);
        }
}

TEST(cad_file, has_millimetres_whatever_its_unit) {
    const cad_folder folder;
    for (const char* const unit : {"MM", "INCH", "M"}) {
        write_step(BRepPrimAPI_MakeBox(10, 20, 30).Shape(), folder.file("box.step"), "AP214IS",
                   unit);
        const l3d_model_file model = model_of(folder.file("box.step"));
        ASSERT_EQ(model.patch_parts.size(), 1U);
        expect_box(box_of(model, model.patch_parts[0].name), {0, 0, 0, 10, 20, 30});
    }
}

TEST(cad_file, has_planes_cylinders_and_tori_as_exact_rationals) {
    const cad_folder folder;
    write_step(BRepPrimAPI_MakeTorus(12, 4).Shape(), folder.file("a.step"));
    const cad_records torus = cad_records::of(cad_records::text_of(folder.file("a.step")), false);
    write_step(BRepPrimAPI_MakeCylinder(10, 20).Shape(), folder.file("a.step"));
    const cad_records drum = cad_records::of(cad_records::text_of(folder.file("a.step")), false);
    ASSERT_EQ(torus.faces.size(), 1U);
    ASSERT_EQ(drum.faces.size(), 3U);
    for (int i = 0; i <= 20; ++i)
        for (int j = 0; j <= 20; ++j) {
            const auto at = [&](const l3d_nurbs_surface& s) {
                return s.evaluate(s.u().from + (s.u().to - s.u().from) * i / 20,
                                  s.v().from + (s.v().to - s.v().from) * j / 20);
            };
            const vector p = at(torus.faces[0]), q = at(drum.faces[0]);
            EXPECT_NEAR(std::hypot(std::hypot(p[0], p[1]) - 12, p[2]), 4, 1e-13);
            EXPECT_NEAR(std::hypot(q[0], q[1]), 10, 1e-13);
        }
    for (const l3d_nurbs_surface& disc : {drum.faces[1], drum.faces[2]}) {
        EXPECT_EQ(disc.u().degree, 1);
        EXPECT_EQ(disc.v().degree, 1);
        ASSERT_EQ(disc.trims().size(), 1U);
        for (const l3d_trim_curve& arc : disc.trims()[0])
            EXPECT_EQ(arc.points.size(), 3U) << "a circle is four rational arcs";
    }
}

/// A place of a rational Bezier curve, by de Casteljau's scheme on (u w, v w, w).
std::array<double, 2> place(const l3d_trim_curve& curve, double t) {
    std::vector<std::array<double, 3>> p = curve.points;
    for (auto& q : p) {
        q[0] *= q[2];
        q[1] *= q[2];
    }
    for (std::size_t left = p.size() - 1; left > 0; --left)
        for (std::size_t i = 0; i < left; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                p[i][k] += t * (p[i + 1][k] - p[i][k]);
    return {p[0][0] / p[0][2], p[0][1] / p[0][2]};
}

TEST(cad_file, has_edges_that_trims_follow) {
    const cad_folder folder;
    std::vector<named_shape> shapes = shapes_of_many_kinds();
    for (named_shape& more : hard_shapes())
        shapes.push_back(std::move(more));
    for (const named_shape& one : shapes) {
        write_step(one.shape, folder.file("a.step"));
        const cad_records read =
            cad_records::of(cad_records::text_of(folder.file("a.step")), false);
        std::vector<int> uses(read.edges.size());
        double furthest = 0; // beyond what the file allows between edge and face
        for (const l3d_nurbs_surface& face : read.faces)
            for (const l3d_trim_loop& loop : face.trims())
                for (const l3d_trim_curve& curve : loop) {
                    if (curve.edge == l3d_no_edge)
                        continue;
                    ++uses[curve.edge];
                    for (const double t : {0.0, 0.2, 0.5, 0.7, 1.0}) {
                        const auto [u, v] = place(curve, t);
                        const vector on_face =
                            face.evaluate(std::clamp(u, face.u().from, face.u().to),
                                          std::clamp(v, face.v().from, face.v().to));
                        const auto& edge = read.edges[curve.edge];
                        const double s = curve.from + t * (curve.to - curve.from);
                        furthest = std::max(
                            furthest,
                            distance(on_face, edge.evaluate(std::clamp(s, edge.along().from,
                                                                       edge.along().to))) -
                                read.tolerances[curve.edge]);
                    }
                }
        // The kernel's own curves in the plane of parameters are this far off in its own files.
        EXPECT_LT(furthest, 1e-4) << one.name;
        EXPECT_TRUE(std::ranges::all_of(uses, [](int n) { return n > 0; })) << one.name;
    }
}

TEST(cad_file, has_lines_in_space_beside_its_faces) {
    const cad_folder folder;
    BRep_Builder builder;
    TopoDS_Compound both;
    builder.MakeCompound(both);
    builder.Add(both, BRepPrimAPI_MakeBox(1, 1, 1).Shape());
    builder.Add(both, BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 2), gp_Pnt(3, 0, 2)).Edge());
    write_step(both, folder.file("a.step"));
    const l3d_model_file model = model_of(folder.file("a.step"));
    EXPECT_EQ(model.patches.size(), 6U);
    ASSERT_EQ(model.curves.size(), 1U);
    EXPECT_EQ(model.curves[0].points().back(), (vector{3.0, 0.0, 2.0}));
}

std::string complaint(const std::string& text) {
    std::string why;
    EXPECT_FALSE(l3d_read_model(text, "part", why));
    EXPECT_EQ(why.find('\n'), why.npos) << why;
    EXPECT_TRUE(why.starts_with("part:")) << why;
    return why;
}

TEST(cad_file, that_is_bad_gives_one_line) {
    const cad_folder folder;
    write_step(BRepPrimAPI_MakeBox(10, 20, 30).Shape(), folder.file("a.step"));
    write_iges(BRepPrimAPI_MakeBox(10, 20, 30).Shape(), folder.file("a.igs"), true);
    const std::string step = cad_records::text_of(folder.file("a.step"));
    const std::string iges = cad_records::text_of(folder.file("a.igs"));
    EXPECT_EQ(complaint(step.substr(0, step.size() / 2)),
              "part: it is cut off: END-ISO-10303-21 is not at its end");
    EXPECT_EQ(complaint(iges.substr(0, iges.size() / 2)),
              "part: it is cut off: its last line is not the one of kind T");
    EXPECT_NE(complaint("ISO-10303-21;\nEND-ISO-10303-21;\n"), "");
    EXPECT_NE(complaint("ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n"),
              "");
    EXPECT_NE(complaint("ISO-10303-21;\n" + std::string(1000, '\1') + "END-ISO-10303-21;"), "");
    EXPECT_EQ(complaint(""), "part:1: the text is empty");
}

TEST(cad_file, whose_edge_is_farther_off_than_a_face_is_large_loses_that_face) {
    const cad_folder folder;
    const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(gp_Ax2({4, 0, -20}, {0, 0, 1}), 4, 40);
    write_step(BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(10).Shape(), drill).Shape(),
               folder.file("a.step"));
    std::string text = cad_records::text_of(folder.file("a.step"));
    // A control point in the middle of the first spline goes a kilometre away.
    std::size_t at = text.find("B_SPLINE_CURVE_WITH_KNOTS");
    for (int i = 0; i < 12; ++i)
        at = text.find('#', at + 1);
    const std::string point = text.substr(at, text.find_first_not_of("0123456789", at + 1) - at);
    const std::size_t first = text.find("('',(", text.find("\n" + point + " =")) + 5;
    text.replace(first, text.find("))", first) - first, "1.E6,1.E6,1.E6");
    std::string why;
    EXPECT_FALSE(l3d_read_model(text, "part", why));
    EXPECT_EQ(why, "part: it holds no surfaces; face 1 is left out: an edge's tolerance is more "
                   "than the size of the face");
}

/// Bytes changed, taken out or doubled; also whole numbers of entities, which connect the file.
std::string changed(std::string text, std::mt19937& random) {
    const auto below = [&](std::size_t n) { return random() % n; };
    for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
        const std::size_t at = below(text.size());
        switch (below(5)) {
        case 0:
            text[at] = static_cast<char>(below(256));
            break;
        case 1:
            text.erase(at, 1 + below(40));
            break;
        case 2:
            text.insert(at, text.substr(below(text.size()), 1 + below(40)));
            break;
        case 3: // a digit
            if (const std::size_t digit = text.find_first_of("0123456789", at); digit != text.npos)
                text[digit] = static_cast<char>('0' + below(10));
            break;
        default: // one reference becomes another
            if (const std::size_t from = text.find('#', at),
                to = text.find('#', below(text.size()));
                from != text.npos && to != text.npos)
                text.replace(from, text.find_first_not_of("0123456789", from + 1) - from,
                             text.substr(to, text.find_first_not_of("0123456789", to + 1) - to));
        }
        if (text.empty())
            text = " ";
    }
    return text;
}

TEST(cad_file, that_is_changed_at_random_gives_a_model_or_one_line) {
    const cad_folder folder;
    std::vector<std::string> texts;
    // The kernel writes time and path, which would change the places of changes.
    const auto add = [&] {
        const std::string text = cad_records::text_of(folder.file("a.step"));
        texts.push_back("ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
                        "FILE_NAME('','',(''),(''),'','','');\n"
                        "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\n" +
                        text.substr(text.find("DATA;")));
        std::string why;
        EXPECT_TRUE(l3d_read_model(texts.back(), "part", why)) << why;
    };
    for (const auto& shapes : {shapes_of_many_kinds(), hard_shapes()})
        for (const named_shape& one : shapes) {
            write_step(one.shape, folder.file("a.step"));
            add();
        }
    write_assembly(folder.file("a.step"));
    add();
    write_iges(shapes_of_many_kinds()[0].shape, folder.file("a.igs"), true);
    texts.push_back(cad_records::text_of(folder.file("a.igs")));
    // Some files each time; L3D_CAD_FUZZ asks for so many seconds of them.
    using clock = std::chrono::steady_clock;
    const char* const asked = std::getenv("L3D_CAD_FUZZ");
    const auto end = clock::now() + std::chrono::seconds(asked ? std::atoi(asked) : 0);
    constexpr int at_least = 40;
    std::mt19937 random(asked ? std::random_device()() : 1);
    int count = 0, read = 0, crashed = 0, endless = 0;
    for (; count < at_least || clock::now() < end; ++count) {
        const std::string text = changed(texts[random() % texts.size()], random);
        std::string why;
        const auto model = l3d_read_model(text, "part", why);
        read += model.has_value();
        crashed += why.find("crashes") != why.npos;
        endless += why.find("comes to no end") != why.npos;
        EXPECT_EQ(model.has_value(), why.empty()) << why;
        EXPECT_EQ(why.find('\n'), why.npos) << why;
    }
    std::cout << read << " of " << count << " are read; the kernel's process crashed " << crashed
              << " times, and came to no end " << endless << " times" << std::endl;
}

} // namespace
