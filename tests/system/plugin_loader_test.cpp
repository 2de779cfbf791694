// SPDX-License-Identifier: MIT
// l3d_plugin_loader: row "Behaviour by plug-in" of the book's table, and every way to be refused.
#include "system/plugin_loader.h"

#include "geom/transform.h"
#include "pipeline/polygons/polygon_model.h"
#include "system/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include <sys/stat.h>

namespace {

std::string file_of(const std::string& plugin) {
    return l3d_plugin_folder() + "/" + plugin + ".so";
}

/// The message about a plug-in that is refused.
std::string refusal_of(const std::string& file, const std::string& parameters = "") {
    l3d_plugin_loader loader("tester", 5);
    std::string why;
    EXPECT_EQ(loader.load(file, parameters, why), nullptr);
    return why;
}

TEST(book_plugin, behaviour_by_plugin) {
    l3d_plugin_loader loader("tester", 5);
    std::string why;
    const auto object = loader.load(file_of("pyramid"), "", why);
    ASSERT_NE(object, nullptr) << why;
    EXPECT_EQ(object->mesh().faces(), 4u);
    EXPECT_EQ(object->transforms().size(), 3u);
    object->update(1 / 60.);
    const auto p = l3d_transformed(object->modeling_transform(), l3d_point<l3d_real>::of(10, 0, 0));
    const double degree = std::numbers::pi / 180;
    EXPECT_NEAR(l3d_to_double(p[0]), 70 + 10 * std::cos(degree), 1e-5);
    EXPECT_NEAR(l3d_to_double(p[1]), 10 * std::sin(degree), 1e-5);
    EXPECT_NEAR(l3d_to_double(p[2]), 50, 1e-5);
}

TEST(book_plugin, random_numbers_come_from_the_seed) {
    const auto colors = [](std::uint64_t seed, int nth) {
        l3d_plugin_loader loader("tester", seed);
        std::string why;
        auto object = loader.load(file_of("pyramid"), "", why);
        for (int i = 0; i < nth; ++i)
            object = loader.load(file_of("pyramid"), "", why);
        return object->mesh().face_colors;
    };
    EXPECT_EQ(colors(5, 0), colors(5, 0));
    EXPECT_NE(colors(5, 0), colors(6, 0));
    EXPECT_NE(colors(5, 0), colors(5, 1));
}

TEST(book_plugin, copies_have_a_state_of_their_own) {
    l3d_plugin_loader loader("tester", 5);
    std::string why;
    auto object = loader.load(file_of("pyramid"), "", why);
    ASSERT_NE(object, nullptr) << why;
    object->update(0.5);
    const auto copy = object->clone();
    EXPECT_EQ(copy->modeling_transform(), object->modeling_transform());
    object->update(0.25);
    const auto ahead = object->modeling_transform();
    EXPECT_NE(copy->modeling_transform(), ahead);
    object.reset(); // the library stays open for the copy
    copy->update(0.25);
    EXPECT_EQ(copy->modeling_transform(), ahead);
}

TEST(book_plugin, refused_with_the_reason) {
    const auto expect = [](const std::string& plugin, const std::string& reason) {
        const std::string file = file_of(plugin);
        const std::string why = refusal_of(file);
        EXPECT_EQ(why.substr(0, file.size() + 2), file + ": ");
        EXPECT_NE(why.find(reason), std::string::npos) << why;
    };
    expect("missing", "No such file");
    expect("no_symbol", "no symbol l3d_plugin");
    expect("old_version", "version 99 of the plug-in interface, this program has version 1");
    expect("too_short", "8 bytes, not 40");
    expect("no_functions", "lacks one of the functions");
    expect("unresolved", "l3d_nobody_defines_this");
    const temporary_folder folder;
    const std::string text = folder.file("text.so");
    std::ofstream(text) << "no library\n";
    EXPECT_NE(refusal_of(text).find("text.so: "), std::string::npos);
    const std::string pipe = folder.file("pipe");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(refusal_of(pipe), pipe + ": is no regular file");
    EXPECT_NE(refusal_of("/").find("/: "), std::string::npos);
    EXPECT_NE(refusal_of("").find(": "), std::string::npos);
}

TEST(book_plugin, refuses_by_itself) {
    const std::string file = file_of("naughty");
    EXPECT_EQ(refusal_of(file, "refuses"), file + ": not today");
    EXPECT_EQ(refusal_of(file, "silent"), file + ": it failed, and does not say why");
    for (const char* fault : {"infinite", "far", "two corners", "beyond"})
        EXPECT_NE(refusal_of(file, fault).find(file + ": set_polygons: "), std::string::npos)
            << fault;
    EXPECT_NE(refusal_of(file, "far matrix").find(file + ": set_transform: matrix 0 "),
              std::string::npos);
}

TEST(book_plugin, faults_in_flight_are_told_once) {
    l3d_plugin_loader loader("tester", 5);
    std::string why;
    const auto object = loader.load(file_of("naughty"), "well", why);
    ASSERT_NE(object, nullptr) << why;
    testing::internal::CaptureStderr();
    object->update(1);
    object->update(1);
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "tester: " + file_of("naughty") + ": set_transform: there is no matrix 16\n");
    EXPECT_EQ(object->transforms().size(), 0u);
    testing::internal::CaptureStderr();
    const auto copy = object->clone(); // without the behaviour, which cannot be copied
    EXPECT_NE(testing::internal::GetCapturedStderr().find("does not say why"), std::string::npos);
    copy->update(1);
    EXPECT_EQ(copy->mesh(), object->mesh());
}

/// Row "Parameter string", and "Videoscape import" by way of the plug-in.
TEST(book_plugin, parameter_string) {
    const temporary_folder folder;
    std::ofstream(folder.file("m.obj")) << "3DG1\n3\n0 0 0\n2 0 0\n0 0 3\n3 0 1 2 0xff\n";
    std::ofstream(folder.file("cut.obj")) << "3DG1\n3\n0 0 0\n2 0 0\n0 0 3\n3 0 1\n";
    l3d_plugin_loader loader("tester", 5, folder.file(""));
    std::string why;
    const auto load = [&](const std::string& parameters) {
        return loader.load(file_of("videoscape"), parameters, why);
    };
    const auto object = load("0 0 0 1 0 0 0 1 0 0 0 1 m.obj");
    ASSERT_NE(object, nullptr) << why;
    EXPECT_EQ(object->modeling_transform(), l3d_identity<l3d_real>());
    EXPECT_EQ(object->vertices()[2], l3d_point<l3d_real>::of(0, 3, 0)); // z up became y up

    const auto placed = load("10 20 30 1 2 3 4 5 6 7 8 9 m.obj"); // (A, D, G) is the x axis
    ASSERT_NE(placed, nullptr) << why;
    EXPECT_EQ(l3d_transformed(placed->modeling_transform(), l3d_point<l3d_real>::of(1, 0, 0)),
              l3d_point<l3d_real>::of(11, 24, 37));
    EXPECT_NE(placed->clone(), nullptr);

    const auto expect = [&](const std::string& parameters, const std::string& reason) {
        EXPECT_EQ(load(parameters), nullptr);
        EXPECT_NE(why.find(reason), std::string::npos) << why;
    };
    expect("", "lack the position's x");
    expect("1 2", "lack the position's z");
    expect("1 2 3 1 0 0 0 1 0 0 0 m.obj", "lack the orientation's I");
    expect("0 0 0 1 0 0 0 1 0 0 0 1", "lack the name of a file");
    expect("0 0 0 1 0 0 0 1 0 0 0 1 m.obj m2.obj", "'m2.obj' after the name");
    expect("0 0 0 1 0 0 0 1 0 0 0 1 none.obj", "none.obj: No such file");
    expect("0 0 0 1 0 0 0 1 0 0 0 1 cut.obj", "cut.obj:6:");
    expect("0 0 0 1 0 0 0 1 0 0 0 1e999 m.obj", "lack the orientation's I");
}

/// Plug-ins read what the program reads: formats by content, materials, patches as polygons.
TEST(book_plugin, any_model_file) {
    const temporary_folder folder;
    std::ofstream(folder.file("m.obj")) << "mtllib m.mtl\nv 0 0 1\nv 2 0 1\nv 0 3 1\nusemtl red\n"
                                           "f 1 2 3\n";
    std::ofstream(folder.file("m.mtl")) << "newmtl red\nKd 1 0 0\n";
    std::ofstream(folder.file("plain.off")) << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    std::ofstream patch(folder.file("p.bpt"));
    patch << "1\n3 3\n";
    for (int i = 0; i < 16; ++i)
        patch << i % 4 << ' ' << i / 4 << " 0\n";
    patch.close();
    l3d_plugin_loader loader("tester", 5, folder.file(""));
    std::string why;
    const auto load = [&](const std::string& file) {
        return loader.load(file_of("videoscape"), "0 0 0 1 0 0 0 1 0 0 0 1 " + file, why);
    };
    const auto red = load("m.obj");
    ASSERT_NE(red, nullptr) << why;
    EXPECT_EQ(red->mesh().look_of(0).color, 0xff0000u);
    EXPECT_EQ(red->vertices()[2], l3d_point<l3d_real>::of(0, 3, -1)); // y is up already
    const auto plain = load("plain.off");
    ASSERT_NE(plain, nullptr) << why;
    EXPECT_EQ(plain->mesh().face_colors.size(), 1u); // a random one
    const auto patches = load("p.bpt");
    ASSERT_NE(patches, nullptr) << why;
    EXPECT_EQ(patches->mesh().faces(), 2u * l3d_usual_facets * l3d_usual_facets);
    EXPECT_EQ(load("m.mtl"), nullptr);
    EXPECT_NE(why.find("m.mtl"), std::string::npos) << why;
}

} // namespace
