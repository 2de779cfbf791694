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

/// A count of things left out for one reason, and the proof that this is right.
struct left_out {
    const char* name;
    const char* proof;
    std::int64_t count;
};

/// The count of each reason, by its name.
json counts_json(std::span<const left_out> reasons);

/// The beginning of a line.
json head_json(const l3d_common_report& report);

/// Adds the times that every frame has.
void add_times(json& times, const l3d_common_times& more);

/// Adds the end of a line: pixels, the names of the reasons that occurred, the hash.
void add_tail(json& line, const l3d_common_report& report, std::span<const left_out> reasons);

/// A line for each reason that occurred: how many of `all` things called `what` it left out.
std::string explained(std::span<const left_out> reasons, std::int64_t all, const std::string& what);

} // namespace l3d_detail

#endif
