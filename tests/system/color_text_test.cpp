// SPDX-License-Identifier: MIT
// color_text: each way to write a colour, and every option that takes one.
#include "system/options/color_text_p.h"

#include "system/options/afd_options.h"
#include "base/error.h"

#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <string>
#include <vector>

namespace {

using levels = std::array<double, 3>;

TEST(color_text, is_read_from_numbers_digits_and_names) {
    for (const char* const text : {"255,165,0", "#ffa500", "#FFA500", "orange"}) {
        EXPECT_EQ(l3d_detail::read_color(text), (levels{255, 165, 0})) << text;
        EXPECT_EQ(l3d_detail::read_paint(text), 0x00ffa500u) << text;
    }
    EXPECT_EQ(l3d_detail::read_paint("#f0a"), 0x00ff00aau);
    EXPECT_EQ(l3d_detail::read_color("25.5,0,1e1"), (levels{25.5, 0, 10}));
    EXPECT_FALSE(l3d_detail::read_paint("25.5,0,10"));
    for (const char* const wrong :
         {"", "#", "#12", "#1234", "#12345", "#1234567", "#12345g", "#-12345", "#+1f", "1,2",
          "1,2,3,4", "1,2,256", "-1,2,3", "nan,1,2", "Orange ", "rot", "0x102030"})
        EXPECT_FALSE(l3d_detail::read_color(wrong)) << wrong;
    EXPECT_EQ(l3d_detail::meant_color("organe"), "; did you mean 'orange'?");
    EXPECT_EQ(l3d_detail::meant_color("Grey"), "; did you mean 'grey'?");
    EXPECT_EQ(l3d_detail::meant_color("1,2,256"), "");
}

l3d_afd_settings settings_of(std::vector<const char*> arguments) {
    l3d_options options("tester", "Tests.", {64, 48});
    l3d_afd_options afd(options);
    std::ostringstream out;
    arguments.insert(arguments.begin(), "tester");
    options.parse(static_cast<int>(arguments.size()), arguments.data(), out);
    return afd.settings();
}

/// The same for each way to write a colour, which stands where the argument has a @.
void expect_one_meaning(const std::string& option, const std::string& value) {
    const auto with = [&](const std::string& color) {
        const std::string text = value.substr(0, value.find('@')) + color;
        return settings_of({option.c_str(), text.c_str()});
    };
    const l3d_afd_settings expected = with("255,165,0"), other = with("255,164,0");
    for (const char* const color : {"#ffa500", "orange"}) {
        const l3d_afd_settings found = with(color);
        EXPECT_EQ(found.lighting, expected.lighting) << option << ' ' << color;
        EXPECT_EQ(found.fog, expected.fog) << option << ' ' << color;
        EXPECT_EQ(found.background, expected.background) << option << ' ' << color;
    }
    EXPECT_FALSE(other.lighting == expected.lighting && other.fog == expected.fog &&
                 other.background == expected.background)
        << option;
    try {
        with("ornage");
        ADD_FAILURE() << option;
    } catch (const l3d_error& error) {
        const std::string said = error.what();
        EXPECT_EQ(said.find(option + ": '"), 0u) << said;
        EXPECT_NE(said.find("did you mean 'orange'?"), std::string::npos) << said;
    }
    EXPECT_THROW(with(""), l3d_error) << option;
    EXPECT_THROW(with("1,2"), l3d_error) << option;
}

TEST(color_text, means_the_same_to_every_option) {
    expect_one_meaning("--background", "@");
    expect_one_meaning("--ambient", "@");
    expect_one_meaning("--light", "1,2,3,@");
    expect_one_meaning("--fog", "1,2,@");
    EXPECT_EQ(settings_of({"--light", "1,2,3"}).lighting,
              settings_of({"--light", "1,2,3,white"}).lighting);
    EXPECT_EQ(settings_of({"--ambient", "25.5,25.5,25.5"}).lighting, l3d_lighting());
    EXPECT_FALSE(settings_of({"--fog", "1,2"}).fog.color);
}

} // namespace
