// SPDX-License-Identifier: MIT
// backend_survey: asking the rows, and asking the user.
#include "system/backend_survey_p.h"

#include "tool_2d/error.h"
#include "system/display_x11.h"

#include <algorithm>
#include <cstdlib>
#include <iomanip>
#include <iostream>

namespace {

/// Width of the column of names, with two spaces to the next.
constexpr int name_column = 8;

std::string without_blanks_around(const std::string& text) {
    const char* const blanks = " \t\r";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string::npos)
        return {};
    return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

void put_name(std::ostream& out, const std::string& name) {
    out << std::left << std::setw(name_column) << name;
}

} // namespace

namespace l3d_detail {

const std::string& backend_survey::display_problem() {
    if (!display_problem_)
        display_problem_ = l3d_display_problem();
    return *display_problem_;
}

const std::string& backend_survey::reason(std::size_t i) {
    if (!reasons_[i]) {
        std::string why;
        if (lacks_display(i))
            why = display_problem();
        else if (!rows_[i].screen_factory->can_serve(why) && why.empty())
            why = "no reason given";
        reasons_[i] = why;
    }
    return *reasons_[i];
}

void backend_survey::list(std::ostream& out) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        put_name(out, rows_[i].name);
        if (serves(i))
            out << "yes  " << rows_[i].purpose << '\n';
        else
            out << "no   " << reason(i) << '\n';
    }
    out << std::flush;
}

const l3d_backend& backend_survey::named(const std::string& name, const std::string& named_by) {
    std::string names = "ask auto";
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        names += ' ' + rows_[i].name;
        if (rows_[i].name != name)
            continue;
        if (lacks_display(i))
            fail_without_display();
        if (!serves(i))
            throw l3d_error(l3d_exit::no_backend,
                            named_by + ": back-end '" + name + "' cannot serve here: " + reason(i));
        return rows_[i];
    }
    throw l3d_error(l3d_exit::usage, named_by + ": '" + name + "' is none of " + names);
}

const l3d_backend& backend_survey::automatic() {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (!rows_[i].automatic)
            continue;
        if (serves(i))
            return rows_[i];
        const char* const display = std::getenv("DISPLAY");
        if (display && *display && lacks_display(i))
            fail_without_display();
    }
    fail_with_all_reasons();
}

const l3d_backend& backend_survey::asked(std::istream& in, std::ostream& out) {
    std::vector<std::size_t> serving;
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (serves(i))
            serving.push_back(i);
    if (serving.empty())
        fail_with_all_reasons();
    const std::size_t usual = preset(serving);

    out << "Which back-end shall show the pictures?\n";
    for (std::size_t k = 0; k < serving.size(); ++k) {
        out << std::right << std::setw(3) << k + 1 << "  ";
        put_name(out, rows_[serving[k]].name);
        out << rows_[serving[k]].purpose << (k == usual ? "  (default)" : "") << '\n';
    }
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (!serves(i)) {
            out << "  -  ";
            put_name(out, rows_[i].name);
            out << "cannot serve here: " << reason(i) << '\n';
        }
    for (;;) {
        out << "Number or name [" << usual + 1 << "]: " << std::flush;
        std::string line;
        if (!std::getline(in, line)) {
            out << '\n'; // ends the line that the question began
            return rows_[serving[usual]];
        }
        const std::string answer = without_blanks_around(line);
        if (answer.empty())
            return rows_[serving[usual]];
        for (std::size_t k = 0; k < serving.size(); ++k)
            if (answer == rows_[serving[k]].name || answer == std::to_string(k + 1))
                return rows_[serving[k]];
        out << "'" << answer << "' is neither the number nor the name of one.\n";
    }
}

std::size_t backend_survey::preset(const std::vector<std::size_t>& serving) const {
    const auto found = std::find_if(serving.begin(), serving.end(),
                                    [this](std::size_t i) { return rows_[i].automatic; });
    return found == serving.end() ? 0 : static_cast<std::size_t>(found - serving.begin());
}

void backend_survey::fail_without_display() {
    throw l3d_error(l3d_exit::no_display,
                    display_problem() + "; without a display use --backend memory --output FILE");
}

void backend_survey::fail_with_all_reasons() {
    std::string text = "no back-end can serve here";
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (!serves(i))
            text += "; " + rows_[i].name + ": " + reason(i);
    throw l3d_error(l3d_exit::no_backend, text);
}

} // namespace l3d_detail
