// SPDX-License-Identifier: MIT
// backend_survey: asks the back-ends whether they serve, and asks the user.
#include "system/backend_survey_p.h"

#include "base/did_you_mean_p.h"
#include "base/error.h"

#include <algorithm>
#include <cstdlib>
#include <iomanip>
#include <iostream>

namespace {

/// Lists of back-ends have a column of names of at least this width. A space follows the column.
constexpr int name_column = 7;

std::string without_blanks_around(const std::string& text) {
    const char* const blanks = " \t\r";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string::npos)
        return {};
    return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

void put_name(std::ostream& out, const std::string& name, int column = name_column) {
    out << std::left << std::setw(column) << name << ' ';
}

} // namespace

namespace l3d_detail {

const l3d_service& backend_survey::service(std::size_t i) {
    if (!services_[i]) {
        if (rows_[i].on_display && display_problem_)
            services_[i] = display_problem_;
        else
            services_[i] = rows_[i].screen_factory->service();
        if (lacks_display(i))
            display_problem_ = services_[i];
    }
    return *services_[i];
}

void backend_survey::list(std::ostream& out, bool with_variants) {
    const auto is_wanted = [&](const l3d_backend& row) { return with_variants || !row.variant; };
    int column = name_column;
    for (const l3d_backend& row : rows_)
        if (is_wanted(row))
            column = std::max(column, static_cast<int>(row.name.size()));
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (!is_wanted(rows_[i]))
            continue;
        put_name(out, rows_[i].name, column);
        if (serves_fully(i))
            out << "yes  " << rows_[i].purpose << '\n';
        else
            out << (serves(i) ? "yes, but " : "no   ") << service(i).why << '\n';
    }
    out << std::flush;
}

void backend_survey::diagnose(std::ostream& out) {
    l3d_probes probes;
    for (const l3d_backend& row : rows_)
        if (!row.variant)
            row.screen_factory->diagnose(probes);
    for (const l3d_probe& probe : probes) {
        // The display is not asked again: it would answer the same, and libraries would print that
        // to stderr once more.
        if (probe.what == l3d_display_probe && probe.outcome == l3d_probe::verdict::bad)
            display_problem_ = {l3d_service::level::no_display, probe.result};
        const bool good = probe.outcome == l3d_probe::verdict::good;
        out << (good                                           ? "ok   "
                : probe.outcome == l3d_probe::verdict::limited ? "note "
                                                               : "bad  ")
            << probe.what << ": " << probe.result << '\n';
        if (!probe.remedy.empty())
            out << "     " << probe.remedy << '\n';
    }
    list(out, false);
}

const l3d_backend& backend_survey::named(const std::string& name, const std::string& named_by) {
    const std::string what = named_by + ": back-end '" + name + "'";
    std::vector<std::string> names{"ask", "auto"};
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        names.push_back(rows_[i].name);
        if (rows_[i].name != name)
            continue;
        if (!serves(i))
            fail(what, service(i));
        return rows_[i];
    }
    std::string list;
    for (const std::string& known : names)
        list += ' ' + known;
    throw l3d_error(l3d_exit::usage,
                    named_by + ": '" + name + "' is none of" + list + did_you_mean(name, names));
}

const l3d_backend& backend_survey::automatic() {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (!rows_[i].automatic)
            continue;
        if (serves_fully(i))
            return rows_[i];
        const char* const display = std::getenv("DISPLAY");
        if (display && *display && lacks_display(i))
            fail("back-end '" + rows_[i].name + "'", service(i));
    }
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (rows_[i].automatic && serves(i))
            return rows_[i];
    fail_with_all_reasons();
}

const l3d_backend* backend_survey::asked(std::istream& in, std::ostream& out) {
    std::vector<std::size_t> serving;
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (!rows_[i].variant && serves(i))
            serving.push_back(i);
    if (serving.empty())
        fail_with_all_reasons();
    const std::size_t usual = preset(serving);

    out << "Which back-end shall show the pictures?\n";
    for (std::size_t k = 0; k < serving.size(); ++k) {
        out << std::right << std::setw(3) << k + 1 << "  ";
        put_name(out, rows_[serving[k]].name);
        out << (serves_fully(serving[k]) ? rows_[serving[k]].purpose : service(serving[k]).why)
            << (k == usual ? "  (default)" : "") << '\n';
    }
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (!rows_[i].variant && !serves(i)) {
            out << "  -  ";
            put_name(out, rows_[i].name);
            out << "cannot serve here: " << service(i).why << '\n';
        }
    for (;;) {
        out << "Number or name [" << usual + 1 << "], or q to quit: " << std::flush;
        std::string line;
        if (!std::getline(in, line)) {
            out << rows_[serving[usual]].name << '\n'; // ends the question's line
            return &rows_[serving[usual]];
        }
        const std::string answer = without_blanks_around(line);
        if (answer.empty())
            return &rows_[serving[usual]];
        if (answer == "q")
            return nullptr;
        for (std::size_t k = 0; k < serving.size(); ++k)
            if (answer == rows_[serving[k]].name || answer == std::to_string(k + 1))
                return &rows_[serving[k]];
        out << "'" << answer << "' is neither the number nor the name of one, nor q.\n";
    }
}

std::size_t backend_survey::preset(const std::vector<std::size_t>& serving) {
    const auto found = std::ranges::find_if(
        serving, [this](std::size_t i) { return rows_[i].automatic && serves_fully(i); });
    return found == serving.end() ? 0 : static_cast<std::size_t>(found - serving.begin());
}

void backend_survey::fail(const std::string& what, const l3d_service& answer) {
    switch (answer.how) {
    case l3d_service::level::no_display:
        throw l3d_error(l3d_exit::no_display,
                        answer.why + "; without a display use --backend memory --output FILE");
    case l3d_service::level::display_lost:
        throw l3d_error(l3d_exit::display_lost, answer.why);
    default:
        throw l3d_error(l3d_exit::no_backend, what + " cannot serve here: " + answer.why);
    }
}

void backend_survey::fail_with_all_reasons() {
    std::string text = "no back-end can serve here";
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (!rows_[i].variant && !serves(i))
            text += "; " + rows_[i].name + ": " + service(i).why;
    throw l3d_error(l3d_exit::no_backend, text);
}

} // namespace l3d_detail
