// SPDX-License-Identifier: MIT
// backend_survey: which back-ends can serve here, and the three ways to take one.
#ifndef L3D_SYSTEM_BACKEND_SURVEY_P_H
#define L3D_SYSTEM_BACKEND_SURVEY_P_H

#include "system/factory_manager.h"

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace l3d_detail {

/// Asks each row of the table at most once whether it can serve. If a display did not answer one
/// row, the next rows do not try it, since a silent display costs seconds.
///
/// Lives:   borrows the rows.
class backend_survey {
public:
    explicit backend_survey(std::span<const l3d_backend> rows)
        : rows_(rows), services_(rows.size()) {}

    /// Writes one line per row, and per variant if these are wanted: its name, whether it can
    /// serve, and why not.
    void list(std::ostream& out, bool with_variants);

    /// Writes a line for each thing that the rows depend on, with what to do about it. A line for
    /// each row follows.
    void diagnose(std::ostream& out);

    /// Finds the row of that name, and makes sure that it can serve. `named_by` is the option or
    /// variable that holds the name.
    ///
    /// Errors:  l3d_error: usage if no row has the name; as fail() if the row cannot serve.
    const l3d_backend& named(const std::string& name, const std::string& named_by);

    /// The first automatic row that serves fully, else the first that serves. A display that was
    /// named but cannot be opened is an error: a user who set DISPLAY wants a window.
    ///
    /// Errors:  l3d_error: no_display, or no_backend with all reasons.
    const l3d_backend& automatic();

    /// The row that the user takes from a numbered list; null for q, which ends the program. A
    /// wrong answer is asked again; an empty line and the end of the input take the default.
    ///
    /// Errors:  l3d_error(no_backend), with all reasons, if there is nothing to choose from.
    const l3d_backend* asked(std::istream& in, std::ostream& out);

    /// Throws the error of a program that wanted `what` and got this answer.
    [[noreturn]] static void fail(const std::string& what, const l3d_service& answer);

    /// Whether somebody sees the pictures of a row. Expects: a row of the table.
    bool is_seen(const l3d_backend& row) {
        return service(static_cast<std::size_t>(&row - rows_.data())).is_seen;
    }

private:
    const l3d_service& service(std::size_t i);
    bool serves(std::size_t i) { return service(i).serves(); }
    bool serves_fully(std::size_t i) { return service(i).how == l3d_service::level::fully; }
    bool lacks_display(std::size_t i) {
        return service(i).how == l3d_service::level::no_display ||
               service(i).how == l3d_service::level::display_lost;
    }
    std::size_t preset(const std::vector<std::size_t>& serving);
    [[noreturn]] void fail_with_all_reasons();

    std::span<const l3d_backend> rows_;
    std::vector<std::optional<l3d_service>> services_;
    std::optional<l3d_service> display_problem_; ///< the answer of the first row without a display
};

} // namespace l3d_detail

#endif
