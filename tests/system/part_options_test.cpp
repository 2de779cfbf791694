// SPDX-License-Identifier: MIT
// l3d_part_options: models of parts as the command line asks for them, and what it is refused.
#include "system/options/part_options.h"

#include "pipeline/polygons/polygon_model.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace {

/// A program with these options, and what it makes of the teapot.
struct program {
    explicit program(std::vector<const char*> arguments) {
        arguments.insert(arguments.begin(), "tester");
        options.parse(static_cast<int>(arguments.size()), arguments.data(), out);
    }

    l3d_patch_model patches() const { return parts.applied(l3d_patch_model::teapot()); }
    l3d_polygon_model polygons() const {
        return parts.applied(l3d_polygon_model(l3d_tessellated(l3d_patch_model::teapot(), 2).mesh));
    }

    std::ostringstream out;
    l3d_options options{"tester", "Tests.", {64, 48}};
    l3d_part_options parts{options};
};

std::string refusal_of(const std::vector<const char*>& arguments) {
    try {
        program(arguments).patches();
    } catch (const l3d_error& error) {
        EXPECT_EQ(error.code(), l3d_exit::usage);
        return error.what();
    }
    return "";
}

TEST(part_options, leave_a_model_alone_unless_they_are_given) {
    const program plain({});
    EXPECT_EQ(plain.patches().patches().size(), 28u);
    EXPECT_TRUE(plain.patches().materials().empty());
    EXPECT_FALSE(plain.parts.lists());
    EXPECT_TRUE(program({"--list-parts"}).parts.lists());
}

TEST(part_options, make_parts_with_an_opacity_instances_of_their_own) {
    const program some({"--opacity", "lid=0.4", "--opacity", "spout=1", "--opacity", "handle=0.5",
                        "--hide", "handle", "--color", "lid=255,128,0"});
    const l3d_patch_scene scene = some.parts.scene(l3d_patch_model::teapot());
    ASSERT_EQ(scene.instances().size(), 3u); // the spout, the lid, the body
    EXPECT_EQ(scene.instances()[0].model().patches().size(), 4u);
    EXPECT_EQ(scene.instances()[0].opacity(), 1);
    EXPECT_EQ(scene.instances()[1].model().patches().size(), 8u);
    EXPECT_EQ(scene.instances()[1].opacity(), 0.4);
    EXPECT_EQ(scene.instances()[1].model().materials()[0].color, 0xff8000u);
    EXPECT_EQ(scene.instances()[2].model().patches().size(), 12u);
    EXPECT_EQ(scene.instances()[2].opacity(), 1);
    const l3d_patch_scene all = program({}).parts.scene(l3d_patch_model::teapot());
    EXPECT_EQ(all.instances().size(), 1u);
    try {
        program({"--opacity", "lid=0.4"}).polygons();
        FAIL();
    } catch (const l3d_error& error) { // they may be the patches of a model, as here
        EXPECT_STREQ(error.what(), "--opacity: polygons are opaque; only --pipeline afd, which "
                                   "draws patches, has it");
    }
    EXPECT_THROW(program({"--opacity", "leg=1"}).parts.scene(l3d_patch_model::teapot()), l3d_error);
}

TEST(part_options, are_listed_with_how_much_they_have) {
    const std::vector<l3d_part_run> runs{{"one", 0}, {"two", 1}};
    const l3d_parts parts(runs, 3);
    testing::internal::CaptureStdout();
    l3d_part_options::list(parts, "patches");
    l3d_part_options::list(parts, "faces");
    EXPECT_EQ(testing::internal::GetCapturedStdout(),
              "one: 1 patch\ntwo: 2 patches\none: 1 face\ntwo: 2 faces\n");
}

TEST(part_options, refuse_what_is_no_opacity) {
    for (const char* const wrong :
         {"lid", "=0.5", "lid=", "lid=half", "lid=1.5", "lid=-0.1", "lid=nan", "lid=0.5,0.5"})
        EXPECT_NE(refusal_of({"--opacity", wrong}).find(wrong), std::string::npos) << wrong;
}

TEST(part_options, hide_show_and_colour_parts_of_both_kinds_of_models) {
    const program some({"--show-only", "lid", "--show-only", "spout", "--hide", "spout", "--color",
                        "lid=#ff8000", "--color", "body=navy"});
    const l3d_patch_model lid = some.patches();
    ASSERT_EQ(lid.patches().size(), 8u);
    ASSERT_EQ(lid.materials().size(), 1u);
    EXPECT_EQ(lid.materials()[0].color, 0xff8000u);
    const l3d_polygon_model polygons = some.polygons();
    ASSERT_FALSE(polygons.triangles().empty());
    for (const l3d_model_triangle& t : polygons.triangles()) {
        EXPECT_EQ(polygons.parts().name_of(t.face), "lid");
        EXPECT_EQ(polygons.materials()[polygons.material_of(t.face)].color, 0xff8000u);
    }
    EXPECT_EQ(program({"--hide", "body"}).patches().patches().size(), 16u);
}

TEST(part_options, name_the_option_and_the_known_parts_in_an_error) {
    EXPECT_EQ(refusal_of({"--hide", "nose"}),
              "--hide: 'nose' names no part; there are body, handle, spout, lid");
    EXPECT_EQ(refusal_of({"--show-only", "Lid"}),
              "--show-only: 'Lid' names no part; there are body, handle, spout, lid; "
              "did you mean 'lid'?");
    EXPECT_EQ(refusal_of({"--color", "nose=1,2,3"}),
              "--color: 'nose' names no part; there are body, handle, spout, lid");
    for (const char* const color : {"lid", "lid=", "lid=1,2", "lid=1,2,256", "lid=1,2,x", "=1,2,3",
                                    "lid=1,2,3,4", "lid=-1,2,3"})
        EXPECT_EQ(refusal_of({"--color", color}),
                  "--color: '" + std::string(color) +
                      "' is not PART=COLOR with a colour: R,G,B from 0 to 255, #RGB, #RRGGBB or a "
                      "name such as orange");
    EXPECT_EQ(refusal_of({"--color", "lid=ornage"}),
              "--color: 'lid=ornage' is not PART=COLOR with a colour: R,G,B from 0 to 255, #RGB, "
              "#RRGGBB or a name such as orange; did you mean 'orange'?");
    EXPECT_EQ(refusal_of({"--show-only", "lid", "--hide", "lid"}),
              "--hide: nothing of the model is left");
    const program hides({"--hide", "lid"});
    try {
        hides.parts.applied(l3d_patch_model());
        FAIL();
    } catch (const l3d_error& error) {
        EXPECT_STREQ(error.what(), "--hide: 'lid' names no part; the model has none");
    }
}

} // namespace
