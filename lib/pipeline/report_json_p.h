// SPDX-License-Identifier: MIT
// Parts of a report as JSON, and in words.
#ifndef L3D_PIPELINE_REPORT_JSON_P_H
#define L3D_PIPELINE_REPORT_JSON_P_H

#include "pipeline/frame_report.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <span>
#include <string>

namespace l3d_detail {

using json = nlohmann::ordered_json;

/// A reason for leaving things out of a picture: its name, the test that proves that the things are
/// not seen, and their number.
struct left_out {
    const char* name;
    const char* proof;
    std::int64_t count;
};

/// A JSON object that has, under the name of each reason, the number of things left out for it.
json counts_json(std::span<const left_out> reasons);

/// The first entries of a report's line of JSON: frame, method, renderer, number type, vectors,
/// size, threads.
json head_json(const l3d_common_report& report);

/// Adds the times that all frames have to `times`, the JSON object of a frame's times.
void add_times(json& times, const l3d_common_times& more);

/// Adds the last entries of a report's line: pixels, names of the reasons that occurred, and hash.
void add_tail(json& line, const l3d_common_report& report, std::span<const left_out> reasons);

/// Explains what was left out: a line for each reason that occurred, with its count. `all` is the
/// number of all things, and `what` their name, such as "patches".
std::string explained(std::span<const left_out> reasons, std::int64_t all, const std::string& what);

} // namespace l3d_detail

#endif
