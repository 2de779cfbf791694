// SPDX-License-Identifier: MIT
// All readers of models: which is chosen, and what holds for every text, whole, cut or damaged.
#include "fuzz/check_model.h"

#include "model_text.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <vector>

namespace {

struct sample {
    const named_model_reader* reader;
    std::string path, text;
};

/// The corpus of fuzzing: files that were written for it, which have an extension, or those that
/// fuzzing found to take ways of their own through a reader.
std::vector<sample> samples(bool written) {
    std::vector<sample> result;
    for (const named_model_reader& reader : model_readers)
        for (const auto& file :
             std::filesystem::directory_iterator(std::string("tests/fuzz/corpus/") + reader.name))
            if (file.path().has_extension() == written)
                result.push_back({&reader, file.path(), model_text::of_file(file.path())});
    return result;
}

std::string complaint(std::string_view text) {
    return model_text::complaint_of(l3d_read_model, text, "name");
}

/// In a buffer of its own, so that the sanitizer sees a read beyond its end.
std::string wrong_with_copy(const sample& of, std::string_view text) {
    const std::vector<char> copy(text.begin(), text.end());
    return wrong_with(*of.reader->read, {copy.data(), copy.size()}, of.reader->has_plain_names);
}

TEST(model_file, knows_formats_by_their_first_word) {
    using enum l3d_model_format;
    EXPECT_EQ(l3d_model_format_of("Ambient light color: Red=0"), asc);
    EXPECT_EQ(l3d_model_format_of("\r\nNamed object: \"x\""), asc);
    EXPECT_EQ(l3d_model_format_of("# a comment\n\nv 1 2 3"), obj);
    EXPECT_EQ(l3d_model_format_of("mtllib a.mtl"), obj);
    EXPECT_EQ(l3d_model_format_of("OFF 1 2 3"), off);
    EXPECT_EQ(l3d_model_format_of("# geomview\nSTCNOFF\n"), off);
    EXPECT_EQ(l3d_model_format_of("ply\r\nformat"), ply);
    EXPECT_EQ(l3d_model_format_of("3DG1\n4"), videoscape);
    EXPECT_EQ(l3d_model_format_of(" 28\n3 3"), bpt);
    EXPECT_EQ(l3d_model_format_of("STBBP\n"), bez);
    EXPECT_EQ(l3d_model_format_of("CBEZ334_ST\n"), bez);
    EXPECT_EQ(l3d_model_format_of("ISO-10303-21;\nHEADER;"), step);
    const std::string first_of_iges = std::string(72, ' ') + "S      1\r\n";
    EXPECT_EQ(l3d_model_format_of(first_of_iges), iges);
    EXPECT_EQ(l3d_model_format_of(std::string(72, ' ') + "S0000001\n"), iges);
    EXPECT_NE(l3d_model_format_of(std::string(72, ' ') + "S      2\n"), iges);
    // They are cut off, with or without a plug-in.
    EXPECT_EQ(complaint("ISO-10303-21;\nHEADER;"),
              "name: it is cut off: END-ISO-10303-21 is not at its end");
    EXPECT_EQ(complaint(first_of_iges),
              "name: it is cut off: its last line is not the one of kind T");
    for (const std::string_view text :
         {"", "\n", "# v 1 2 3", "plywood", "3DG2", "2.5", "-", "\x7f"})
        EXPECT_FALSE(l3d_model_format_of(text)) << text;
    EXPECT_EQ(complaint("\n# nothing\n"), "name:3: the text is empty");
    EXPECT_EQ(complaint("\n\nsolids x"), "name:3: 'solids' begins none of asc, obj, off, ply, "
                                         "3DG1, bpt, BBP, BEZ, stl, glTF, ncols, STEP and IGES");
}

TEST(model_file, every_sample_is_read_by_content_and_survives_the_writers) {
    int read = 0;
    for (const sample& s : samples(true)) {
        EXPECT_EQ(wrong_with_copy(s, s.text), "") << s.path;
        std::string why;
        std::string other;
        const auto by_content = l3d_read_model(s.text, "name", why);
        const auto by_name = s.reader->read(s.text, "name", other);
        EXPECT_EQ(why, other) << s.path;
        EXPECT_TRUE(by_content == by_name) << s.path;
        read += by_content ? 1 : 0;
    }
    EXPECT_GE(read, 15);
}

TEST(model_file, cut_anywhere_is_read_well_or_an_error_with_its_line) {
    for (const sample& s : samples(true)) {
        int errors = 0;
        for (std::size_t length = 0; length < s.text.size(); ++length) {
            const std::string_view cut = std::string_view(s.text).substr(0, length);
            ASSERT_EQ(wrong_with_copy(s, cut), "") << s.path << " cut at " << length;
            std::string why;
            if (s.reader->read(cut, "name", why))
                continue;
            ++errors;
            // The line is the last, but where binary numbers begin it is the one before them.
            const std::size_t digits = why.find_first_not_of("0123456789", 5);
            ASSERT_TRUE(why.starts_with("name:") && digits > 5 && why[digits] == ':') << why;
            const long line = std::stol(why.substr(5));
            ASSERT_GE(line, 1) << why;
            const auto ends = [cut](char c) { return std::count(cut.begin(), cut.end(), c); };
            ASSERT_LE(line, 1 + std::max(ends('\n'), ends('\r'))) << why;
        }
        EXPECT_GT(errors, 0) << s.path;
    }
}

TEST(model_file, what_fuzzing_found_is_survived_whole_and_cut) {
    const std::vector<sample> found = samples(false);
    EXPECT_GE(found.size(), 50u);
    for (const sample& s : found)
        for (std::size_t length = 0; length <= s.text.size(); ++length)
            ASSERT_EQ(wrong_with_copy(s, std::string_view(s.text).substr(0, length)), "")
                << s.path << " cut at " << length;
}

TEST(model_file, damage_is_survived_and_explained) {
    constexpr unsigned seed = 27182;
    SCOPED_TRACE("seed " + std::to_string(seed));
    static constexpr std::string_view pieces[] = {
        "nan", "-inf", "1e999", "-1", "4294967296", "99999999999999999999", " ",   "\n", "\\\n",
        "0",   "#",    "/",     "\"", ":",          "1000000000",           "0x1", "\r", "-0"};
    std::mt19937 random(seed);
    const auto below = [&](std::size_t end) { return random() % std::max<std::size_t>(end, 1); };
    int read = 0;
    int all = 0;
    for (const sample& s : samples(true))
        for (int i = 0; i < 1000; ++i) {
            std::string text = s.text;
            for (auto count = 1 + below(3); count > 0; --count) {
                const std::size_t at = below(text.size() + 1);
                switch (below(4)) {
                case 0:
                    text.erase(at, below(9));
                    break;
                case 1:
                    text.insert(at, 1, static_cast<char>(random()));
                    break;
                case 2:
                    text.replace(at, std::min(below(4), text.size() - at),
                                 pieces[below(std::size(pieces))]);
                    break;
                default:
                    text.insert(at, text.substr(below(text.size()), below(60)));
                }
            }
            ASSERT_EQ(wrong_with_copy(s, text), "") << s.path << "\n" << text;
            std::string why;
            read += s.reader->read(text, "name", why) ? 1 : 0;
            ++all;
        }
    EXPECT_GT(read, all / 20); // the damage is not always fatal, else the test shows little
    EXPECT_LT(read, all / 2);
}

l3d_polygon_mesh random_mesh(std::mt19937_64& random, bool normals, bool colors) {
    l3d_polygon_mesh mesh;
    const auto number = [&random] {
        double value = 0;
        do
            value = std::bit_cast<double>(random());
        while (!(std::abs(value) <= l3d_bpt_largest_coordinate));
        return value;
    };
    for (int i = 0; i < 57; ++i)
        mesh.vertices.emplace_back(number(), number(), number());
    mesh.vertices[7] = {-0.0, 5e-324, -1e12};
    for (int i = 0; i < 91; ++i) {
        std::vector<std::uint32_t> face(3 + random() % 5);
        for (std::uint32_t& corner : face)
            corner = static_cast<std::uint32_t>(random() % mesh.vertices.size());
        mesh.add_face(face);
        if (colors)
            mesh.face_colors.push_back(static_cast<std::uint32_t>(random() & 0xffffff));
    }
    for (std::size_t i = 0; normals && i < mesh.vertices.size(); ++i)
        mesh.vertex_normals.emplace_back(number(), number(), number());
    return mesh;
}

TEST(model_file, writing_and_reading_gives_the_same_bits) {
    constexpr unsigned seed = 161;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    for (int i = 0; i < 20; ++i) {
        const l3d_polygon_mesh mesh = random_mesh(random, i % 2 == 0, i % 3 == 0);
        std::string why;
        const auto off = l3d_read_off(l3d_write_off(mesh), "off", why);
        ASSERT_TRUE(off) << why;
        EXPECT_EQ(off->mesh, mesh);
        EXPECT_TRUE(std::signbit(off->mesh.vertices[7][0]));

        l3d_model_file model{mesh, {}, {}};
        model.mesh.face_colors.clear();
        model.mesh.parts = {{"first part", 0}, {"", 3}, {"next", 40}, {"end", 90}};
        model.mesh.materials = {"not used", "red", "blue \\ green", ""};
        for (std::size_t face = 0; face < model.mesh.faces(); ++face)
            model.mesh.face_materials.push_back(static_cast<std::uint32_t>(1 + random() % 3));
        for (const int degree : {1, 3, 15}) {
            l3d_patch_points& patch = model.patches.emplace_back();
            patch.degree_u = degree;
            patch.degree_v = 2;
            const double* const numbers = &mesh.vertices[0][0];
            for (int k = 0; k < 3 * (degree + 1); ++k)
                patch.points.push_back({numbers[k], numbers[k + 1], numbers[k + 2]});
        }
        model.patch_parts = {{"a patch", 1}, {"first part", 2}};
        const auto obj = l3d_read_obj(l3d_write_obj(model), "obj", why);
        ASSERT_TRUE(obj) << why;
        EXPECT_EQ(obj->mesh, model.mesh);
        EXPECT_EQ(obj->patches, model.patches);
        EXPECT_EQ(obj->patch_parts, model.patch_parts);
        EXPECT_EQ(obj->notes, model.notes);
    }
}

} // namespace
