// SPDX-License-Identifier: MIT
// l3d_factory_manager: the table, a row of our own, the prompt and the ways around it.
#include "system/factory_manager.h"
#include "system/fakes.h"
#include "system/paper_row.h"
#include "system/temporary_folder.h"

#include "base/error.h"
#include "system/options/options.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

namespace {

/// No display, and two rows more than the library has: one that serves, one that does not.
class factory_manager : public testing::Test {
protected:
    factory_manager() {
        unsetenv("DISPLAY");
        unsetenv("L3D_BACKEND");
        setenv("L3D_MESA", "declined", 1); // or the table would depend on what is installed
        manager.add(paper(log, "paper"));
        manager.add(paper(log, "papyrus", "the Nile is dry"));
    }
    ~factory_manager() override {
        unsetenv("L3D_BACKEND");
        unsetenv("L3D_MESA");
    }

    bool choose(std::vector<const char*> arguments, const std::string& answers, bool may_ask) {
        arguments.insert(arguments.begin(), "tester");
        std::ostringstream ignored;
        options.parse(static_cast<int>(arguments.size()), arguments.data(), ignored);
        std::istringstream in(answers);
        testing::internal::CaptureStderr();
        struct ends_capture {
            ~ends_capture() { text = testing::internal::GetCapturedStderr(); }
            std::string& text;
        } capture{messages};
        return manager.choose(options, in, out, may_ask);
    }

    /// The name chosen at the prompt.
    std::string ask(const std::string& answers) {
        EXPECT_TRUE(choose({}, answers, true));
        return manager.chosen().name;
    }

    void expect_error(std::vector<const char*> arguments, l3d_exit code, const char* text) {
        try {
            choose(std::move(arguments), "", false);
            ADD_FAILURE() << "chose " << manager.chosen().name;
        } catch (const l3d_error& error) {
            EXPECT_EQ(error.code(), code) << error.what();
            EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
        }
    }

    long questions() const {
        long count = 0;
        for (std::size_t at = 0; (at = out.str().find("Number or name", at)) != std::string::npos;
             ++at)
            ++count;
        return count;
    }

    call_log log;
    l3d_factory_manager manager;
    l3d_options options{"tester", "Tests.", {37, 23}};
    std::ostringstream out;
    std::string messages;
};

TEST_F(factory_manager, prompt_lists_numbers_reasons_and_the_default) {
    ask("\n");
    const std::string text = out.str();
    EXPECT_NE(text.find("1  memory"), std::string::npos) << text;
    EXPECT_NE(text.find("(default)"), std::string::npos) << text;
    EXPECT_NE(text.find("2  paper   draws on paper\n"), std::string::npos) << text;
    EXPECT_NE(text.find("-  papyrus cannot serve here: the Nile is dry"), std::string::npos)
        << text;
    EXPECT_NE(text.find("-  ximage  cannot serve here: DISPLAY is not set"), std::string::npos)
        << text;
    EXPECT_LT(text.find("(default)"), text.find("paper"));
}

TEST_F(factory_manager, enter_takes_the_default) {
    EXPECT_EQ(ask("\npaper\n"), "memory");
    EXPECT_EQ(questions(), 1);
}

TEST_F(factory_manager, number_is_taken) {
    EXPECT_EQ(ask("2\n"), "paper");
}

TEST_F(factory_manager, name_is_taken) {
    EXPECT_EQ(ask("  paper\t\r\n"), "paper");
    EXPECT_EQ(questions(), 1);
}

TEST_F(factory_manager, nonsense_is_asked_again) {
    EXPECT_EQ(ask("9\n0\n-1\n02\npap\n2 2\npapyrus\nximage\n\xff\n%s\n2\n"), "paper");
    EXPECT_EQ(questions(), 11);
}

TEST_F(factory_manager, q_quits) {
    EXPECT_FALSE(choose({}, "what?\n q \n2\n", true));
    EXPECT_EQ(questions(), 2);
    EXPECT_EQ(options.common().output, "");
    EXPECT_EQ(messages, "");
}

TEST_F(factory_manager, end_of_input_takes_the_default) {
    EXPECT_EQ(ask(""), "memory");
}

TEST_F(factory_manager, end_of_input_after_nonsense_takes_the_default) {
    EXPECT_EQ(ask("what?\nhm"), "memory");
    EXPECT_EQ(out.str().back(), '\n');
}

TEST_F(factory_manager, last_line_without_an_end_counts) {
    EXPECT_EQ(ask("2"), "paper");
}

TEST_F(factory_manager, never_asks_without_a_terminal) {
    EXPECT_TRUE(choose({}, "2\n", false));
    EXPECT_EQ(manager.chosen().name, "memory");
    EXPECT_EQ(out.str(), "");
    EXPECT_EQ(count_of(log, "asked"), 0); // neither row is automatic
}

TEST_F(factory_manager, never_asks_against_the_option) {
    EXPECT_TRUE(choose({"--no-input", "--backend", "ask"}, "2\n", true));
    EXPECT_EQ(manager.chosen().name, "memory");
    EXPECT_EQ(out.str(), "");
}

TEST_F(factory_manager, auto_does_not_ask) {
    EXPECT_TRUE(choose({"--backend", "auto"}, "2\n", true));
    EXPECT_EQ(manager.chosen().name, "memory");
    EXPECT_EQ(out.str(), "");
}

TEST_F(factory_manager, option_names_a_row) {
    EXPECT_TRUE(choose({"--backend", "paper"}, "1\n", true));
    EXPECT_EQ(manager.chosen().name, "paper");
    EXPECT_EQ(out.str(), "");
}

TEST_F(factory_manager, environment_names_a_row) {
    setenv("L3D_BACKEND", "paper", 1);
    EXPECT_TRUE(choose({}, "1\n", true));
    EXPECT_EQ(manager.chosen().name, "paper");
    EXPECT_EQ(out.str(), "");
}

TEST_F(factory_manager, option_beats_environment) {
    setenv("L3D_BACKEND", "paper", 1);
    EXPECT_TRUE(choose({"--backend", "memory"}, "", true));
    EXPECT_EQ(manager.chosen().name, "memory");
}

TEST_F(factory_manager, option_ask_beats_environment) {
    setenv("L3D_BACKEND", "memory", 1);
    EXPECT_TRUE(choose({"--backend", "ask"}, "2\n", true));
    EXPECT_EQ(manager.chosen().name, "paper");
}

TEST_F(factory_manager, a_program_may_have_a_usual_back_end) {
    options.prefer_backend("paper");
    EXPECT_TRUE(choose({}, "1\n", true));
    EXPECT_EQ(manager.chosen().name, "paper");
    EXPECT_EQ(out.str(), "");
}

TEST_F(factory_manager, users_beat_the_usual_back_end) {
    options.prefer_backend("paper");
    setenv("L3D_BACKEND", "memory", 1);
    EXPECT_TRUE(choose({}, "", true));
    EXPECT_EQ(manager.chosen().name, "memory");
}

TEST_F(factory_manager, unseen_pictures_go_to_a_file) {
    EXPECT_TRUE(choose({}, "", false));
    EXPECT_EQ(options.common().output, "tester.png");
    EXPECT_NE(messages.find("tester.png"), std::string::npos);
    EXPECT_EQ(std::count(messages.begin(), messages.end(), '\n'), 1);
}

TEST_F(factory_manager, named_output_stays) {
    EXPECT_TRUE(choose({"--output", "other.ppm"}, "", false));
    EXPECT_EQ(options.common().output, "other.ppm");
    EXPECT_EQ(messages, "");
}

TEST_F(factory_manager, memory_by_name_writes_only_what_it_is_told) {
    EXPECT_TRUE(choose({"--backend", "memory"}, "", false));
    EXPECT_EQ(options.common().output, "");
    EXPECT_EQ(messages, "tester: nobody will see a picture: back-end 'memory' has no window, and "
                        "no --output names a file\n");
    EXPECT_TRUE(choose({"--backend", "memory", "--output", "other.ppm"}, "", false));
    EXPECT_EQ(messages, "");
}

TEST_F(factory_manager, unknown_name_is_wrong_usage) {
    expect_error({"--backend", "vellum"}, l3d_exit::usage, "--backend: 'vellum'");
}

TEST_F(factory_manager, unknown_name_in_the_environment_is_wrong_usage) {
    setenv("L3D_BACKEND", "slate", 1);
    expect_error({}, l3d_exit::usage, "L3D_BACKEND: 'slate'");
}

TEST_F(factory_manager, row_that_cannot_serve_says_why) {
    expect_error({"--backend", "papyrus"}, l3d_exit::no_backend, "the Nile is dry");
}

TEST_F(factory_manager, named_window_without_display) {
    expect_error({"--backend", "ximage"}, l3d_exit::no_display, "DISPLAY is not set");
}

TEST_F(factory_manager, wrong_display_is_named) {
    for (const char* display : {":12345", "nonsense", ":", "nowhere/else:7"}) {
        setenv("DISPLAY", display, 1);
        const std::string quoted = "'" + std::string(display) + "'";
        expect_error({"--backend", "ximage"}, l3d_exit::no_display, quoted.c_str());
        expect_error({"--backend", "auto"}, l3d_exit::no_display, quoted.c_str());
        expect_error({}, l3d_exit::no_display, "--backend memory --output FILE");
    }
    EXPECT_TRUE(choose({"--backend", "memory"}, "", false)); // which needs none
}

TEST_F(factory_manager, wrong_display_does_not_spoil_the_prompt) {
    setenv("DISPLAY", ":12345", 1);
    EXPECT_EQ(ask("\n"), "memory");
    EXPECT_NE(out.str().find("':12345'"), std::string::npos) << out.str();
}

TEST_F(factory_manager, list_shows_every_row) {
    EXPECT_FALSE(choose({"--list-backends"}, "", true));
    const std::string text = out.str();
    for (const char* line :
         {"xshm        no ", "ximage      no   DISPLAY is not set\n", "mesa        no ",
          "mesa:egl    ", "mesa:osmesa ", "memory      yes ", "paper       yes  draws on paper\n",
          "papyrus     no   the Nile is dry\n"})
        EXPECT_NE(text.find(line), std::string::npos) << text;
}

TEST_F(factory_manager, diagnosis_shows_what_the_choice_depends_on) {
    setenv("DISPLAY", ":12345", 1);
    setenv("L3D_BACKEND", "paper", 1);
    EXPECT_FALSE(choose({"--diagnose"}, "", true));
    for (const char* text : {"DISPLAY=':12345'", "L3D_BACKEND='paper'", "L3D_MESA='declined'",
                             "bad  display: cannot open the display", "papyrus no"})
        EXPECT_NE(out.str().find(text), std::string::npos) << out.str();
}

TEST_F(factory_manager, rows_are_asked_once) {
    ask("nonsense\n2\n");
    EXPECT_EQ(count_of(log, "asked"), 2); // one row each
}

TEST_F(factory_manager, rows_not_chosen_are_released) {
    EXPECT_EQ(ask("paper\n"), "paper");
    EXPECT_EQ(count_of(log, "released"), 1); // papyrus
    EXPECT_EQ(ask("memory\n"), "memory");
    EXPECT_EQ(count_of(log, "released"), 3);
}

TEST_F(factory_manager, a_new_row_runs_a_whole_program) {
    const temporary_folder folder;
    const std::string picture = folder.file("p.ppm");
    EXPECT_TRUE(
        choose({"--backend", "paper", "--frames", "3", "--output", picture.c_str()}, "", false));
    const auto dispatcher = manager.create_dispatcher(options.frame_settings());
    const auto screen = manager.create_screen({options.common().size, "paper"});
    const auto imp = manager.chosen().rasterizer_factory->create_2d(screen->pixels());
    l3d_rasterizer_2d(*imp).draw_point(11, 7, 0xABCDEF);
    EXPECT_EQ(screen->pixels().row(7)[11], 0xABCDEFu);
    fake_pipeline pipeline(log, *screen);
    dispatcher->plug(pipeline, *screen);
    EXPECT_EQ(dispatcher->start(), l3d_exit::success);
    EXPECT_EQ(count_of(log, "draw"), 3);
    EXPECT_TRUE(folder.holds("p.ppm"));
}

TEST_F(factory_manager, refuses_rows_that_cannot_serve_and_work_before_the_choice) {
    EXPECT_THROW(manager.add(paper(log, "paper")), l3d_error) << "two rows of one name";
    l3d_backend torn = paper(log, "torn");
    torn.rasterizer_factory = nullptr;
    EXPECT_THROW(manager.add(std::move(torn)), l3d_error);
    EXPECT_THROW(manager.create_dispatcher({}), l3d_error) << "no row is chosen";
}

} // namespace
