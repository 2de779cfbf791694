// SPDX-License-Identifier: MIT
// Reads and writes lines of comma-separated values, the first four of which are a row's name.
#include "report_rows.h"

#include "base/formatted_p.h"
#include <l3d/error.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace {

constexpr const char* columns =
    "model,view,method,setting,patches,median_ms,least_ms,first_ms,frames,bound_px,outline_px,"
    "percentile_999_px,largest_px,mean_px,judged_share,rms_levels,holes,failures,points,quads\n";

/// The text of a value: "" if it is unknown, "none" if there is none.
std::string text_of(double value) {
    if (!std::isfinite(value))
        return std::isnan(value) ? "" : "none";
    return l3d_detail::formatted("%.6g", value);
}

std::string line_of(const frame_result& r) {
    std::string line =
        row_name{r.model, r.view, r.series, r.label}.text() + ',' + std::to_string(r.patches);
    for (const double value :
         {r.median_ms, r.least_ms, r.first_ms, double(r.frames), r.bound_px, r.outline_px,
          r.percentile_px, r.largest_px, r.mean_px, r.judged, r.rms_levels})
        line += ',' + text_of(value);
    for (const std::int64_t value : {r.holes, r.failures, r.samples, r.quads})
        line += ',' + std::to_string(value);
    return line + '\n';
}

/// A row's name: its first four fields.
std::string name_of(const std::string& line) {
    std::size_t end = 0;
    for (int i = 0; i < 4 && end != std::string::npos; ++i)
        end = line.find(',', end + (i > 0));
    return line.substr(0, end);
}

} // namespace

void write_text(const std::string& file, const std::string& text) {
    std::ofstream out(file, std::ios::binary);
    out << text;
    if (!out.flush())
        throw l3d_error(l3d_exit::failure, "cannot write " + file);
}

/// Reads the rows of an interrupted report. The last line may be half a row, so a line counts only
/// with all of its commas and its end.
row_store::row_store(const std::string& folder, const std::string& key)
    : folder_(folder), file_(folder + "/frames.part.csv") {
    const std::string head = "# " + key + '\n';
    std::string kept = head;
    std::ifstream in(file_, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    const auto commas = std::count(columns, columns + std::string(columns).size(), ',');
    if (const std::string all = text.str(); all.starts_with(head)) {
        std::size_t from = head.size();
        for (std::size_t end = all.find('\n', from); end != std::string::npos;
             from = end + 1, end = all.find('\n', from)) {
            const std::string line = all.substr(from, end + 1 - from);
            if (std::count(line.begin(), line.end(), ',') == commas) {
                lines_[name_of(line)] = line;
                kept += line;
            }
        }
    }
    write_text(file_, kept);
}

void row_store::add(const frame_result& row) {
    const std::string line = line_of(row);
    std::ofstream out(file_, std::ios::binary | std::ios::app);
    out << line;
    if (!out.flush())
        throw l3d_error(l3d_exit::failure, "cannot write " + file_);
    lines_[name_of(line)] = line;
}

void row_store::finish(const std::vector<row_name>& names) const {
    std::string text = columns;
    for (const row_name& name : names)
        text += lines_.at(name.text());
    write_text(folder_ + "/frames.csv", text);
    std::filesystem::remove(file_);
}
