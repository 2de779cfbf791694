// SPDX-License-Identifier: MIT
// The rows of a report that is measured in many minutes, and may be stopped at any time.
#ifndef L3D_APPS_TEAPOT_AFD_REPORT_ROWS_H
#define L3D_APPS_TEAPOT_AFD_REPORT_ROWS_H

#include "frame_measure.h"

#include <map>
#include <string>
#include <vector>

/// Writes a whole text file. Errors: l3d_error(failure) that names the file.
void write_text(const std::string& file, const std::string& text);

/// The key of a row: the model, the view, the method and its setting.
struct row_name {
    std::string model, view, series, label;

    std::string text() const { return model + ',' + view + ',' + series + ',' + label; }
};

/// The rows measured so far, in a file of the report's folder. Each row is written at once, so that
/// a stopped report goes on where it was.
///
/// Errors: l3d_error(failure) that names the file.
class row_store {
public:
    /// The `key` names the machine, the build and the picture's size. Rows of a report with another
    /// key are dropped.
    row_store(const std::string& folder, const std::string& key);

    bool has(const row_name& name) const { return lines_.contains(name.text()); }
    std::size_t count() const { return lines_.size(); }
    void add(const frame_result& row);

    /// Writes the rows of these names as frames.csv, and removes the file of rows so far.
    /// Expects: all of them measured.
    void finish(const std::vector<row_name>& names) const;

private:
    std::string folder_, file_;
    std::map<std::string, std::string> lines_; ///< each row's line, by the row's name
};

#endif
