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

/// Finds which back-ends (the rows of a table) can serve here, and chooses one. It asks each row at
/// most once. If a display did not answer one row, further rows do not try this display, since a
/// silent display costs seconds.
///
/// Lives:   borrows the rows.
class backend_survey {
public:
    explicit backend_survey(std::span<const l3d_backend> rows)
        : rows_(rows), services_(rows.size()) {}

    /// Writes one line for each row: its name, whether it can serve, and its purpose or the reason
    /// why it cannot. Variants get lines only if `with_variants` is true.
    void list(std::ostream& out, bool with_variants);

    /// Writes a line for each thing that the rows depend on, such as the display. If the thing does
    /// not work, the line has advice. The lines of list(), without variants, follow.
    void diagnose(std::ostream& out);

    /// Finds the row of this name, and makes sure that it can serve. `named_by` is the option or
    /// variable that the name was read from, for messages.
    ///
    /// Errors:  l3d_error: usage if no row has the name; the errors of fail() if the row cannot
    ///          serve.
    const l3d_backend& named(const std::string& name, const std::string& named_by);

    /// Chooses a row without a question: the first automatic row that serves fully, else the first
    /// automatic row that serves. If DISPLAY is set and the display cannot be opened, it throws,
    /// since a user who set DISPLAY wants a window.
    ///
    /// Errors:  l3d_error: no_display or display_lost for a display that cannot be opened;
    ///          otherwise no_backend, with all rows' reasons.
    const l3d_backend& automatic();

    /// Lets the user choose a row from a numbered list. The result is null for the answer q, which
    /// ends the program. After a wrong answer it asks again. An empty line, or the end of the
    /// input, chooses the default row.
    ///
    /// Errors:  l3d_error(no_backend), with all rows' reasons, if no row can serve.
    const l3d_backend* asked(std::istream& in, std::ostream& out);

    /// Throws the error for a back-end that cannot serve. `what` names the back-end, and `answer`
    /// is its reason.
    [[noreturn]] static void fail(const std::string& what, const l3d_service& answer);

    /// Whether the pictures of a row are seen, since the row opens windows here. Expects: a row of
    /// the table.
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
    /// The answer of the first row whose display could not be opened.
    std::optional<l3d_service> display_problem_;
};

} // namespace l3d_detail

#endif
