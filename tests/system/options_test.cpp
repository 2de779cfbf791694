// SPDX-License-Identifier: MIT
// l3d_options: what is read, what is refused and how that is said.
#include "system/options/options.h"
#include "system/temporary_folder.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <new>
#include <optional>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace {

enum class fruit { apple, quince };

/// A program with one option of every kind.
struct program {
    program() {
        options.add("--tolerance", tolerance, "pixels", 0.01, 8);
        options.add("-t,--threads", threads, "how many", 1, 64);
        options.add("--model", model, "patches", "FILE");
        options.add("--net", net, "draw it");
        options.add("--eye", eye, "where from");
        options.add("--window", window, "its size");
        options.add("--background", background, "what is behind");
        options.add_choice<fruit>("--fruit", kind, "which",
                                  {{"apple", fruit::apple}, {"quince", fruit::quince}});
    }

    bool parse(std::vector<const char*> arguments) {
        arguments.insert(arguments.begin(), "tester");
        return options.parse(static_cast<int>(arguments.size()), arguments.data(), out);
    }

    double tolerance = 0.25;
    int threads = 3;
    std::string model = "teapot.bpt";
    bool net = false;
    l3d_vector<double, 3> eye{1.5, -2.0, 7.0};
    l3d_size window{64, 48};
    std::optional<l3d_background> background;
    fruit kind = fruit::quince;
    std::ostringstream out;
    l3d_options options{"tester", "Tests.", {640, 400}};
};

TEST(options, help_and_messages_have_the_name_that_the_program_was_called_by) {
    l3d_options options("tester", "Tests.", {640, 400});
    std::ostringstream out;
    const char* arguments[] = {"/opt/l3d/bin/l3d-tester", "--help"};
    EXPECT_FALSE(options.parse(2, arguments, out));
    EXPECT_NE(out.str().find("l3d-tester [OPTIONS]"), std::string::npos) << out.str();
    EXPECT_EQ(options.command(), "l3d-tester");
    EXPECT_EQ(options.frame_settings().program, "l3d-tester");
    EXPECT_EQ(options.screen_request().title, "tester");
}

/// An option whose name may be left out.
struct viewer {
    viewer() { options.add("FILE,--model", model, "patches", "FILE"); }

    std::string read(std::vector<const char*> arguments) {
        arguments.insert(arguments.begin(), "viewer");
        std::ostringstream out;
        options.parse(static_cast<int>(arguments.size()), arguments.data(), out);
        return model;
    }

    std::string model = "teapot.bpt";
    l3d_options options{"viewer", "Views.", {640, 400}};
};

TEST(options, a_file_needs_no_option) {
    EXPECT_EQ(viewer().read({}), "teapot.bpt");
    EXPECT_EQ(viewer().read({"spoon.bpt"}), "spoon.bpt");
    EXPECT_EQ(viewer().read({"--no-input", "spoon.bpt", "--size", "3x4"}), "spoon.bpt");
    EXPECT_EQ(viewer().read({"--model", "spoon.bpt"}), "spoon.bpt");
    try {
        viewer().read({"spoon.bpt", "cup.bpt"});
        ADD_FAILURE() << "took two files";
    } catch (const l3d_error& error) {
        EXPECT_STREQ(error.what(), "one argument too many: 'cup.bpt' (see --help)");
    }
}

TEST(options, end_at_two_dashes) {
    EXPECT_EQ(viewer().read({"--no-input", "--", "-spoon.bpt"}), "-spoon.bpt");
    EXPECT_EQ(viewer().read({"--", "--size="}), "--size=");
    EXPECT_EQ(viewer().read({"spoon.bpt", "--"}), "spoon.bpt");
    EXPECT_EQ(viewer().read({"--"}), "teapot.bpt");
    EXPECT_EQ(viewer().read({"--", "--"}), "--");
    const auto message = [](std::vector<const char*> arguments) -> std::string {
        try {
            viewer().read(std::move(arguments));
        } catch (const l3d_error& error) {
            return error.what();
        }
        return "taken";
    };
    EXPECT_EQ(message({"--", "spoon.bpt", "--size"}),
              "one argument too many: '--size' (see --help)");
    EXPECT_EQ(message({"--sise", "--", "spoon.bpt"}),
              "unknown option '--sise'; did you mean '--size'? (see --help)");
}

TEST(options, that_are_unknown_are_guessed) {
    program tester;
    for (const auto& [wrong, meant] : {std::pair{"--tolarence", "--tolerance"},
                                       {"--tolerence=1", "--tolerance"},
                                       {"--EYE=1,2,3", "--eye"},
                                       {"-size", "--size"},
                                       {"--noinput", "--no-input"},
                                       {"--ouptut", "--output"},
                                       {"--quiet", ""},
                                       {"-x", ""}}) {
        try {
            tester.parse({wrong});
            ADD_FAILURE() << wrong;
        } catch (const l3d_error& error) {
            const std::string guess = *meant ? std::string("; did you mean '") + meant + "'?" : "";
            EXPECT_EQ(error.what(),
                      "unknown option '" + std::string(wrong) + '\'' + guess + " (see --help)");
        }
    }
    try {
        tester.parse({"--fruit", "qiunce"});
    } catch (const l3d_error& error) {
        EXPECT_STREQ(error.what(),
                     "--fruit: 'qiunce' is not one of apple|quince; did you mean 'quince'?");
    }
}

TEST(options, that_may_be_repeated_leave_the_file_behind_them_alone) {
    l3d_options options("tester", "Tests.", {640, 400});
    std::vector<std::string> lights;
    std::string model;
    options.add_each("--light", "from where", "X,Y,Z", "",
                     [&](const std::string& text) { lights.push_back(text); });
    options.add("FILE,--model", model, "patches", "FILE");
    std::ostringstream out;
    const char* arguments[] = {"tester", "--light", "1,2,3", "--light", "-4,5,6", "a.bpt"};
    EXPECT_TRUE(options.parse(6, arguments, out)) << out.str();
    EXPECT_EQ(lights, (std::vector<std::string>{"1,2,3", "-4,5,6"}));
    EXPECT_EQ(model, "a.bpt");
}

TEST(options, defaults) {
    program tester;
    EXPECT_TRUE(tester.parse({}));
    const l3d_common_options& common = tester.options.common();
    EXPECT_EQ(common.backend, "");
    EXPECT_EQ(common.size, (l3d_size{640, 400}));
    EXPECT_EQ(common.frames, 0);
    EXPECT_FALSE(common.fps.has_value());
    EXPECT_EQ(common.scale, 0);
    EXPECT_EQ(common.seed, 1u);
    EXPECT_FALSE(common.no_input || common.list_backends || common.diagnose || common.verbose);
    EXPECT_EQ(tester.eye, (l3d_vector<double, 3>{1.5, -2.0, 7.0}));
    EXPECT_FALSE(tester.options.frame_settings().fixed_step);
}

TEST(options, reads_every_kind) {
    program tester;
    EXPECT_TRUE(tester.parse({"--backend", "memory", "--no-input", "--size=321x97", "--frames",
                              "12", "--fps", "0", "--seed", "18446744073709551615", "--output", "-",
                              "--list-backends", "--diagnose", "--verbose"}));
    const l3d_common_options& common = tester.options.common();
    EXPECT_EQ(common.backend, "memory");
    EXPECT_EQ(common.size, (l3d_size{321, 97}));
    EXPECT_EQ(common.seed, 18446744073709551615u);
    EXPECT_TRUE(common.no_input && common.list_backends && common.diagnose && common.verbose);
    const l3d_frame_settings settings = tester.options.frame_settings();
    EXPECT_EQ(settings.frames, 12);
    EXPECT_EQ(settings.fps, 0);
    EXPECT_TRUE(settings.fixed_step);
    EXPECT_EQ(settings.output, "-");
}

TEST(options, reads_a_part_of_a_sequence) {
    program tester;
    EXPECT_TRUE(tester.parse({"--frames", "7:19", "--output", "a%d.png", "--resume"}));
    const l3d_frame_settings settings = tester.options.frame_settings();
    EXPECT_EQ(settings.first_frame, 7);
    EXPECT_EQ(settings.frames, 19);
    EXPECT_TRUE(settings.fixed_step && settings.resume);
    EXPECT_TRUE(tester.parse({"--frames", "7:19", "--frames", "5"}));
    EXPECT_EQ(tester.options.frame_settings().first_frame, 0);
    EXPECT_EQ(tester.options.frame_settings().frames, 5);
}

TEST(options, tells_the_screen_size_name_and_scale) {
    program tester;
    EXPECT_TRUE(tester.parse({"--size", "321x97", "--scale", "3"}));
    const l3d_screen_request request = tester.options.screen_request();
    EXPECT_EQ(request.size, (l3d_size{321, 97}));
    EXPECT_EQ(request.name, "tester");
    EXPECT_EQ(request.title, "tester");
    EXPECT_EQ(request.scale, 3);
    EXPECT_EQ(tester.options.frame_settings().program, "tester");
}

TEST(options, reads_a_programs_own) {
    program tester;
    EXPECT_TRUE(tester.parse({"--tolerance", "1e-1", "-t", "7", "--model", "a b.bpt", "--net",
                              "--eye", "-1,2.5,-3e2", "--window", "16384x1", "--fruit", "apple"}));
    EXPECT_EQ(tester.tolerance, 0.1);
    EXPECT_EQ(tester.threads, 7);
    EXPECT_EQ(tester.model, "a b.bpt");
    EXPECT_TRUE(tester.net);
    EXPECT_EQ(tester.eye, (l3d_vector<double, 3>{-1.0, 2.5, -300.0}));
    EXPECT_EQ(tester.window, (l3d_size{16384, 1}));
    EXPECT_EQ(tester.kind, fruit::apple);
}

TEST(options, a_background_is_a_word_or_a_colour) {
    program tester;
    EXPECT_TRUE(tester.parse({"--net"}));
    EXPECT_FALSE(tester.background);
    EXPECT_TRUE(tester.parse({"--background", "1,20,255"}));
    EXPECT_EQ(tester.background, l3d_background::color(0x000114ff));
    EXPECT_EQ(tester.options.frame_settings().alpha, l3d_alpha::none);
    EXPECT_TRUE(tester.parse({"--background", "#0114ff"}));
    EXPECT_EQ(tester.background, l3d_background::color(0x000114ff));
    EXPECT_TRUE(tester.parse({"--background", "teal"}));
    EXPECT_EQ(tester.background, l3d_background::color(0x00008080));
    EXPECT_TRUE(tester.parse({"--background", "none", "--output", "a.png"}));
    EXPECT_EQ(tester.background, l3d_background::none());
    EXPECT_EQ(tester.options.frame_settings().alpha, l3d_alpha::transparency);
    EXPECT_TRUE(tester.parse({"--background", "none", "--background", "gradient"}));
    EXPECT_EQ(tester.background, l3d_background::gradient());
    EXPECT_EQ(tester.options.frame_settings().alpha, l3d_alpha::none);
}

TEST(options, the_last_one_counts) {
    program tester;
    EXPECT_TRUE(tester.parse({"--size", "5x7", "--threads", "2", "--size", "9x11"}));
    EXPECT_EQ(tester.options.common().size, (l3d_size{9, 11}));
}

struct refusal {
    std::vector<const char*> arguments;
    std::string option, value; ///< both must be in the message
};

void PrintTo(const refusal& test, std::ostream* out) {
    for (const char* argument : test.arguments)
        *out << argument << ' ';
}

class options_refused : public testing::TestWithParam<refusal> {};

TEST_P(options_refused, with_option_and_value_named) {
    program tester;
    try {
        tester.parse(GetParam().arguments);
        ADD_FAILURE() << "was taken";
    } catch (const l3d_error& error) {
        const std::string text = error.what();
        EXPECT_EQ(error.code(), l3d_exit::usage);
        EXPECT_NE(text.find(GetParam().option), std::string::npos) << text;
        EXPECT_NE(text.find(GetParam().value), std::string::npos) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    }
}

INSTANTIATE_TEST_SUITE_P(
    all, options_refused,
    testing::Values(
        refusal{{"--nonsense"}, "--nonsense", ""}, refusal{{"--nonsense=5"}, "--nonsense", "5"},
        refusal{{"-x"}, "-x", ""}, refusal{{"stray"}, "stray", ""},
        refusal{{"--size"}, "--size", ""}, refusal{{"--size="}, "--size", "''"},
        refusal{{"--size", ""}, "--size", "''"}, refusal{{"--size", "640"}, "--size", "'640'"},
        refusal{{"--size", "0x5"}, "--size", "'0x5'"},
        refusal{{"--size", "5x-3"}, "--size", "'5x-3'"},
        refusal{{"--size", "16385x3"}, "--size", "'16385x3'"},
        refusal{{"--size", "5x4294967297"}, "--size", "'5x4294967297'"},
        refusal{{"--size", "5x7x9"}, "--size", "'5x7x9'"},
        refusal{{"--size", "nanxnan"}, "--size", "'nanxnan'"},
        refusal{{"--size", "5 x7"}, "--size", "'5 x7'"},
        refusal{{"--frames", "-1"}, "--frames", "'-1'"},
        refusal{{"--frames", "2147483648"}, "--frames", "'2147483648'"},
        refusal{{"--frames", "1.5"}, "--frames", "'1.5'"},
        refusal{{"--frames", "0x10"}, "--frames", "'0x10'"},
        refusal{{"--frames", "3:3"}, "--frames", "'3:3'"},
        refusal{{"--frames", "5:3"}, "--frames", "'5:3'"},
        refusal{{"--frames", "-2:3"}, "--frames", "'-2:3'"},
        refusal{{"--frames", "3:"}, "--frames", "'3:'"},
        refusal{{"--frames", "1:2:3"}, "--frames", "'1:2:3'"},
        refusal{{"--resume", "--output", "a.png"}, "--resume", "%"},
        refusal{{"--resume"}, "--resume", "%"}, refusal{{"--fps", "nan"}, "--fps", "'nan'"},
        refusal{{"--fps", "inf"}, "--fps", "'inf'"}, refusal{{"--fps", "-1"}, "--fps", "'-1'"},
        refusal{{"--fps", "1e999"}, "--fps", "'1e999'"},
        refusal{{"--fps", "60fps"}, "--fps", "'60fps'"}, refusal{{"--fps", ""}, "--fps", "''"},
        refusal{{"--scale", "0"}, "--scale", "'0'"}, refusal{{"--scale", "9"}, "--scale", "'9'"},
        refusal{{"--seed", "-1"}, "--seed", "'-1'"},
        refusal{{"--seed", "18446744073709551616"}, "--seed", "'18446744073709551616'"},
        refusal{{"--output", "a.gif"}, "--output", "'a.gif'"},
        refusal{{"--output="}, "--output", "''"}, refusal{{"--output", ""}, "--output", "''"},
        refusal{{"--no-input=perhaps"}, "--no-input", "perhaps"},
        refusal{{"--tolerance", "0.001"}, "--tolerance", "'0.001'"},
        refusal{{"--tolerance", "0,5"}, "--tolerance", "'0,5'"},
        refusal{{"-t", "65"}, "--threads", "'65'"}, refusal{{"--model", ""}, "--model", "''"},
        refusal{{"--eye", "1,2"}, "--eye", "'1,2'"},
        refusal{{"--eye", "1,2,3,4"}, "--eye", "'1,2,3,4'"},
        refusal{{"--eye", "1,nan,3"}, "--eye", "'1,nan,3'"},
        refusal{{"--background", "1,2"}, "--background", "'1,2'"},
        refusal{{"--background", "1,2,256"}, "--background", "'1,2,256'"},
        refusal{{"--background", "1,-2,6"}, "--background", "'1,-2,6'"},
        refusal{{"--background", "rde"}, "--background", "'rde'"},
        refusal{{"--background", "1.5,2,3"}, "--background", "'1.5,2,3'"},
        refusal{{"--background", "#12345"}, "--background", "'#12345'"},
        refusal{{"--background", "none", "--output", "a.ppm"}, "--output", "'a.ppm'"},
        refusal{{"--output", "-", "--background", "none"}, "--background none", "'-'"},
        refusal{{"--fruit", "pear"}, "--fruit", "'pear'"},
        refusal{{"--fruit", ""}, "--fruit", "''"}));

TEST(options, help_names_options_and_defaults) {
    program tester;
    EXPECT_FALSE(tester.parse({"--frames", "3", "--help"}));
    for (const char* text : {"tester", "Tests.", "--backend", "--no-input", "640x400", "--frames",
                             "--fps", "--seed", "--output", "--version", "0.25", "1.5,-2,7",
                             "apple|quince", "L3D_BACKEND", "L3D_NO_SHM", "L3D_MESA"})
        EXPECT_NE(tester.out.str().find(text), std::string::npos) << text;
}

TEST(options, help_has_headings_examples_and_lines_that_fit) {
    program tester;
    tester.options.begin_group("More");
    bool more = false;
    tester.options.add("--more", more, "one two three four five six seven eight nine ten eleven");
    tester.options.add_note("FRUIT grows.");
    tester.options.add_example("--more --net", "more, and a net");
    EXPECT_FALSE(tester.parse({"--help"}));
    const std::string text = tester.out.str();
    for (const char* part :
         {"\nHelp:\n  -h,--help", "\n\nMore:\n  --more ", "\n\nFRUIT grows.\n\nEnvironment: ",
          "\n\nExamples:\n  tester --more --net\n      more, and a net\n"})
        EXPECT_NE(text.find(part), std::string::npos) << part << text;
    EXPECT_EQ(text.find("\n\n\n"), std::string::npos) << text;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        EXPECT_LE(line.size(), 80u) << line;
}

TEST(options, version_is_one_line) {
    program tester;
    EXPECT_FALSE(tester.parse({"--version"}));
    EXPECT_EQ(tester.out.str().rfind("tester ", 0), 0u);
    EXPECT_EQ(tester.out.str().find('\n'), tester.out.str().size() - 1);
}

TEST(options, no_arguments_at_all) {
    program tester;
    EXPECT_TRUE(tester.options.parse(0, nullptr, tester.out));
}

TEST(options, output_that_cannot_be_written_to) {
    program tester;
    tester.out.setstate(std::ios::badbit);
    EXPECT_THROW(tester.parse({"--help"}), l3d_error);
}

TEST(options, one_file_for_two_options_is_refused) {
    const temporary_folder folder;
    const std::string twin = folder.file("./b.png");
    program tester;
    std::string first, second;
    tester.options.add("--first", first, "a file", "FILE");
    tester.options.add("--second", second, "a file", "FILE");
    const auto fails = [&](const std::string& a, const std::string& b) {
        try {
            tester.parse({"--first", a.c_str(), "--second", b.c_str()});
        } catch (const l3d_error& error) {
            EXPECT_EQ(error.code(), l3d_exit::usage);
            EXPECT_EQ(std::string(error.what()),
                      "--second: '" + b + "' is the file of --first, too");
            return true;
        }
        return false;
    };
    EXPECT_TRUE(fails(folder.file("a.png"), folder.file("a.png")));
    EXPECT_TRUE(fails(folder.file("b.png"), twin));
    EXPECT_TRUE(fails("a.png", "./a.png"));
    EXPECT_TRUE(fails("-", "-"));
    std::ofstream(folder.file("c.png")) << "old";
    std::filesystem::create_hard_link(folder.file("c.png"), folder.file("d.png"));
    std::filesystem::create_symlink("c.png", folder.file("e.png"));
    EXPECT_TRUE(fails(folder.file("c.png"), folder.file("d.png")));
    EXPECT_TRUE(fails(folder.file("e.png"), folder.file("c.png")));
    // links may lead to what is not there yet, by way of each other
    std::filesystem::create_symlink("new.png", folder.file("f.png"));
    std::filesystem::create_symlink(folder.file("f.png"), folder.file("g.png"));
    std::filesystem::create_symlink("h.png", folder.file("i.png"));
    std::filesystem::create_symlink("i.png", folder.file("h.png"));
    EXPECT_TRUE(fails(folder.file("f.png"), folder.file("new.png")));
    EXPECT_TRUE(fails(folder.file("f.png"), folder.file("g.png")));
    EXPECT_FALSE(fails(folder.file("g.png"), folder.file("a.png")));
    EXPECT_FALSE(fails(folder.file("h.png"), folder.file("a.png")));
    EXPECT_FALSE(fails(folder.file("a.png"), folder.file("b.png")));
    EXPECT_FALSE(fails("/dev/null", "/dev/null"));
    EXPECT_FALSE(fails("a.png", "-"));
}

TEST(options, numbers_that_must_be_whole_are_called_so) {
    program tester;
    int count = 1;
    double share = 0;
    tester.options.add("--count", count, "how many", 1, 8);
    tester.options.add("--share", share, "how much", 0.0, 1.0);
    const auto complaint = [&](const char* option, const char* value) -> std::string {
        try {
            tester.parse({option, value});
        } catch (const l3d_error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(complaint("--count", "1.5"), "--count: '1.5' is not a whole number from 1 to 8");
    EXPECT_EQ(complaint("--share", "2"), "--share: '2' is not a number from 0 to 1");
}

TEST(options, the_standard_output_takes_one_text) {
    program tester;
    std::string file;
    bool tells = false;
    tester.options.add("--file", file, "a file", "FILE");
    tester.options.add("--tell", tells, "print something");
    tester.options.prints_result("--tell");
    tester.parse({"--file", "a.png", "--tell"});
    EXPECT_TRUE(tester.options.wants_result());
    tester.parse({"--file", "-"});
    try {
        tester.parse({"--file", "-", "--tell"});
        FAIL();
    } catch (const l3d_error& error) {
        EXPECT_EQ(error.code(), l3d_exit::usage);
        EXPECT_STREQ(error.what(),
                     "--tell: its text goes to the standard output, as that of --file does");
    }
}

TEST(report, texts_of_the_libraries_become_words) {
    const auto text_of = [](const std::exception& error) {
        testing::internal::CaptureStderr();
        l3d_report("tester", error);
        return testing::internal::GetCapturedStderr();
    };
    EXPECT_EQ(text_of(std::bad_alloc()), "tester: there is not enough memory\n");
    EXPECT_EQ(text_of(std::length_error("vector::_M_default_append")),
              "tester: something is larger than memory can hold\n");
    EXPECT_EQ(text_of(std::filesystem::filesystem_error(
                  "cannot do", "some/file", std::make_error_code(std::errc::permission_denied))),
              "tester: some/file: Permission denied\n");
    EXPECT_EQ(text_of(std::system_error(EMFILE, std::generic_category(), "thread")),
              "tester: Too many open files\n");
}

TEST(report, control_characters_are_written_out) {
    testing::internal::CaptureStderr();
    l3d_report("tester",
               l3d_error(l3d_exit::usage, "--size: '\x1b[31m\n\xC2\x9b\x7f\xE9' \xC3\xA9"));
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "tester: --size: '\\x1b[31m\\x0a\\xc2\\x9b\\x7f\\xe9' \xC3\xA9\n");
}

TEST(report, one_line_and_the_exit_code) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(l3d_report("tester", l3d_error(l3d_exit::bad_input, "a.bpt:7: no number")), 5);
    EXPECT_EQ(l3d_report("tester", std::bad_alloc()), 1);
    EXPECT_EQ(l3d_report("tester", l3d_exit::display_lost), 6);
    EXPECT_EQ(l3d_report("tester", l3d_exit::success), 0);
    const std::string text = testing::internal::GetCapturedStderr();
    EXPECT_EQ(text.rfind("tester: a.bpt:7: no number\ntester: ", 0), 0u) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3) << text;
}

} // namespace
