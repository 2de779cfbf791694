// SPDX-License-Identifier: MIT
// l3d_patch_model: from files, and why not.
#include "scene/patch_model.h"

#include "geom/files/model_file.h"
#include "geom/teapot.h"
#include "base/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

/// A file of that text, until it dies.
class text_file {
public:
    explicit text_file(std::string_view text) { std::ofstream(path) << text; }
    text_file(const text_file&) = delete;
    text_file& operator=(const text_file&) = delete;
    ~text_file() { std::filesystem::remove(path); }

    const std::string path =
        testing::TempDir() + testing::UnitTest::GetInstance()->current_test_info()->name();
};

std::string refusal_of(const std::string& file) {
    try {
        l3d_patch_model::load(file);
    } catch (const l3d_error& error) {
        EXPECT_EQ(error.code(), l3d_exit::bad_input);
        return error.what();
    }
    return "";
}

TEST(patch_model, of_a_file_is_that_of_its_text) {
    const text_file file(l3d_teapot_bpt());
    const l3d_patch_model model = l3d_patch_model::load(file.path);
    const l3d_patch_model teapot = l3d_patch_model::teapot();
    ASSERT_EQ(model.patches().size(), 28u);
    for (std::size_t i = 0; i < 28; ++i)
        EXPECT_EQ(model.patches()[i].points, teapot.patches()[i].points);
}

TEST(patch_model, knows_the_faces_of_its_pieces_whatever_is_shown) {
    l3d_model_file file;
    for (int i = 0; i < 4; ++i) {
        const double x = i;
        file.patches.push_back({1, 1, {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, {x + 1, 1, 0}}});
    }
    file.patch_parts = {{"left", 0}, {"right", 2}};
    std::string why;
    const auto of = [&] { return l3d_patch_model::from_file(file, "file", why).value(); };
    EXPECT_EQ(of().face_of(3), 0U) << "the file numbers none";
    file.patch_faces = {1, 1, 2, 7};
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(of().face_of(i), file.patch_faces[i]);
    const l3d_patch_model right = of().only(std::array{std::size_t{1}});
    ASSERT_EQ(right.pieces(), 2U);
    EXPECT_EQ(right.face_of(0), 2U);
    EXPECT_EQ(right.face_of(1), 7U);
}

TEST(patch_model, shows_hides_and_paints_the_parts_of_the_teapot) {
    const l3d_patch_model teapot = l3d_patch_model::teapot();
    const l3d_parts& parts = teapot.parts();
    ASSERT_EQ(std::vector(parts.names().begin(), parts.names().end()),
              (std::vector<std::string>{"body", "handle", "spout", "lid"}));
    const std::size_t lid = *parts.find("lid");
    // The lid is all that is above the rim's lower edge and nearer to the axis than the rim.
    for (std::size_t i = 0; i < teapot.patches().size(); ++i) {
        const auto [least, most] = teapot.patches()[i].bounds();
        const bool is_lid = least[1] >= 2.25 && std::max(most[0], -least[0]) <= 1.3;
        EXPECT_EQ(parts.of(i) == lid, is_lid) << i;
        EXPECT_EQ(parts.name_of(i) == "handle", most[0] < -1) << i;
        EXPECT_EQ(parts.name_of(i) == "spout", least[0] > 1) << i;
    }
    const l3d_patch_model painted = teapot.part_painted(lid, {.color = 0xff0000});
    const std::array<std::size_t, 1> chosen{lid};
    const l3d_patch_model alone = painted.only(chosen), rest = painted.without(chosen);
    ASSERT_EQ(alone.patches().size(), 8u);
    ASSERT_EQ(rest.patches().size(), 20u);
    ASSERT_EQ(alone.materials().size(), 1u);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(alone.patches()[i].points, teapot.patches()[20 + i].points);
        EXPECT_EQ(alone.materials()[alone.material_of(i)].color, 0xff0000u);
        EXPECT_EQ(alone.parts().name_of(i), "lid");
    }
    for (std::size_t i = 0; i < 20; ++i)
        EXPECT_EQ(rest.patches()[i].points, teapot.patches()[i].points);
    EXPECT_TRUE(rest.materials().empty());
    EXPECT_EQ(rest.parts().names().size(), 3u);
    EXPECT_EQ(painted.identity(), teapot.identity());
}

TEST(patch_model, says_why_a_file_has_none) {
    EXPECT_EQ(refusal_of("nowhere/at all.bpt"), "nowhere/at all.bpt: No such file or directory");
    {
        const text_file polygon("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
        EXPECT_EQ(refusal_of(polygon.path), polygon.path + ": holds 1 polygon and no patches");
    }
    std::string text = "1\n3 3\n0 0 zero\n";
    for (int i = 1; i < 16; ++i)
        text += "0 0 0\n";
    const text_file broken(text);
    EXPECT_EQ(refusal_of(broken.path).find(broken.path + ":3: "), 0u) << refusal_of(broken.path);
}

TEST(patch_model, names_the_coordinate_that_is_not_finite) {
    l3d_patch_model::patch flat{};
    flat.at(2, 1) = {0.0, std::nan(""), 0.0};
    try {
        const l3d_patch_model model({flat});
        ADD_FAILURE() << model.patches().size();
    } catch (const l3d_error& error) {
        EXPECT_STREQ(error.what(), "model: patch 1, row 3, column 2: y is nan, not finite");
    }
}

TEST(patch_model, wants_a_material_for_all_patches_or_for_each) {
    const l3d_patch_model teapot = l3d_patch_model::teapot();
    EXPECT_THROW(teapot.painted(std::vector<l3d_material>(3)), l3d_error);
    EXPECT_NO_THROW(teapot.painted(std::vector<l3d_material>(teapot.pieces())));
}

} // namespace
