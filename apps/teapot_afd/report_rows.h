// SPDX-License-Identifier: MIT
// The rows of a report that is measured in many minutes, and may be stopped at any time.
#ifndef L3D_APPS_TEAPOT_AFD_REPORT_ROWS_H
#define L3D_APPS_TEAPOT_AFD_REPORT_ROWS_H

#include "frame_measure.h"

#include <map>
#include <string>
#include <vector>

/// Writes a text as a whole file. Errors: l3d_error(failure) that names the file.
void write_text(const std::string& file, const std::string& text);

/// The key of a row of the report: the model, the view, and the setting's series and label.
struct row_name {
    std::string model, view, series, label;

    std::string text() const { return model + ',' + view + ',' + series + ',' + label; }
};

/// The rows that a report has measured so far, kept in a file of the report's folder. Each row is
/// written at once, so that a report that was stopped need not measure it again.
///
/// Errors: l3d_error(failure) that names the file.
class row_store {
public:
    /// Reads the rows in the folder. `key` names the machine, the build and the picture's size.
    /// Rows that were measured with another key are dropped.
    row_store(const std::string& folder, const std::string& key);

    bool has(const row_name& name) const { return lines_.contains(name.text()); }
    std::size_t count() const { return lines_.size(); }
    void add(const frame_result& row);

    /// Writes the rows with these names as frames.csv, and removes the file of the rows so far.
    /// Expects: all these rows are measured.
    void finish(const std::vector<row_name>& names) const;

private:
    std::string folder_, file_;
    std::map<std::string, std::string> lines_; ///< each row's line, by the row's name
};

#endif
