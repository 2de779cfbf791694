// SPDX-License-Identifier: MIT
// backend_survey: on tables that the library does not have.
#include "system/backend_survey_p.h"
#include "system/paper_row.h"

#include "base/error.h"

#include <gtest/gtest.h>

#include <sstream>
#include <vector>

namespace {

struct table {
    void add(const std::string& name, bool automatic, const std::string& reason = "") {
        rows.push_back(paper(log, name, reason));
        rows.back().automatic = automatic;
    }
    void answer(std::size_t i, l3d_service::level how) {
        dynamic_cast<const paper_factory&>(*rows[i].screen_factory).how = how;
    }

    call_log log;
    std::vector<l3d_backend> rows;
};

TEST(backend_survey, automatic_skips_rows_that_want_to_be_named_or_cannot_serve) {
    table table;
    table.add("slate", false);
    table.add("vellum", true, "no calf");
    table.add("paper", true);
    table.add("card", true);
    EXPECT_EQ(l3d_detail::backend_survey(table.rows).automatic().name, "paper");
}

TEST(backend_survey, default_is_the_first_that_serves_if_none_is_automatic) {
    table table;
    table.add("vellum", false, "no calf");
    table.add("slate", false);
    table.add("card", false);
    std::istringstream in("\n");
    std::ostringstream out;
    EXPECT_EQ(l3d_detail::backend_survey(table.rows).asked(in, out)->name, "slate");
    EXPECT_NE(out.str().find("Number or name [1]"), std::string::npos) << out.str();
}

TEST(backend_survey, automatic_prefers_what_serves_fully) {
    table table;
    table.add("vellum", true, "no calf");
    table.add("slate", true, "scratched");
    table.add("paper", true, "yellow");
    for (const std::size_t i : {1U, 2U})
        table.answer(i, l3d_service::level::partly);
    EXPECT_EQ(l3d_detail::backend_survey(table.rows).automatic().name, "slate");
    table.answer(2, l3d_service::level::fully);
    EXPECT_EQ(l3d_detail::backend_survey(table.rows).automatic().name, "paper");
    EXPECT_EQ(l3d_detail::backend_survey(table.rows).named("slate", "--backend").name, "slate");
    std::ostringstream out;
    l3d_detail::backend_survey(table.rows).list(out, true);
    EXPECT_NE(out.str().find("slate   yes, but scratched\n"), std::string::npos) << out.str();
}

/// Knows of three things, one of each kind.
class diagnosed_factory final : public l3d_screen_factory {
private:
    l3d_service do_service() const override { return {}; }
    std::unique_ptr<l3d_screen> do_create(const l3d_screen_request&, l3d_service&) const override {
        return nullptr;
    }
    void do_diagnose(l3d_probes& probes) const override {
        probes.push_back({"ink", "black", l3d_probe::verdict::good, ""});
        probes.push_back({"quill", "blunt", l3d_probe::verdict::limited, "sharpen it"});
        probes.push_back({"calf", "gone", l3d_probe::verdict::bad, "install calf"});
    }
};

TEST(backend_survey, diagnosis_names_outcomes_and_remedies) {
    table table;
    table.add("paper", true);
    table.rows.back().screen_factory = std::make_unique<diagnosed_factory>();
    std::ostringstream out;
    l3d_detail::backend_survey(table.rows).diagnose(out);
    EXPECT_EQ(out.str(), "ok   ink: black\n"
                         "note quill: blunt\n"
                         "     sharpen it\n"
                         "bad  calf: gone\n"
                         "     install calf\n"
                         "paper   yes  draws on paper\n");
}

/// The exit code with which a refusal ends a program.
l3d_exit code_of(l3d_service::level how) {
    l3d_service answer;
    answer.how = how;
    answer.why = "the ink is dry";
    try {
        l3d_detail::backend_survey::fail("paper", answer);
    } catch (const l3d_error& error) {
        EXPECT_NE(std::string(error.what()).find(answer.why), std::string::npos) << error.what();
        return error.code();
    }
}

TEST(backend_survey, refusals_have_their_own_exit_codes) {
    EXPECT_EQ(code_of(l3d_service::level::not_here), l3d_exit::no_backend);
    EXPECT_EQ(code_of(l3d_service::level::no_display), l3d_exit::no_display);
    EXPECT_EQ(code_of(l3d_service::level::display_lost), l3d_exit::display_lost);
}

TEST(backend_survey, a_display_that_is_silent_is_tried_once) {
    table table;
    table.add("vellum", true, "no answer");
    table.add("slate", true, "no answer");
    table.add("paper", true);
    for (const std::size_t i : {0U, 1U}) {
        table.rows[i].on_display = true;
        table.answer(i, l3d_service::level::no_display);
    }
    unsetenv("DISPLAY");
    EXPECT_EQ(l3d_detail::backend_survey(table.rows).automatic().name, "paper");
    EXPECT_EQ(count_of(table.log, "asked"), 2);
}

TEST(backend_survey, all_reasons_are_given_if_nothing_serves) {
    table table;
    table.add("slate", false, "no quarry");
    table.add("vellum", true, "no calf");
    const auto expect_reasons = [](const auto& choose) {
        try {
            choose();
            ADD_FAILURE() << "chose one";
        } catch (const l3d_error& error) {
            const std::string text = error.what();
            EXPECT_EQ(error.code(), l3d_exit::no_backend);
            EXPECT_NE(text.find("slate: no quarry"), std::string::npos) << text;
            EXPECT_NE(text.find("vellum: no calf"), std::string::npos) << text;
        }
    };
    l3d_detail::backend_survey survey(table.rows);
    std::istringstream in("1\n");
    std::ostringstream out;
    expect_reasons([&] { survey.automatic(); });
    expect_reasons([&] { survey.asked(in, out); });
    EXPECT_EQ(out.str(), "");
}

} // namespace
