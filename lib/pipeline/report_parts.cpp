// SPDX-License-Identifier: MIT
// Parts of reports: JSON, words, hash.
#include "base/formatted_p.h"
#include "pipeline/report_json_p.h"

namespace l3d_detail {

json counts_json(std::span<const left_out> reasons) {
    json counts = json::object();
    for (const left_out& reason : reasons)
        counts[reason.name] = reason.count;
    return counts;
}

json head_json(const l3d_common_report& report) {
    json head{{"frame", report.frame}, {"method", report.method}};
    if (!report.renderer.empty())
        head["renderer"] = report.renderer;
    head.update(
        {{"real", report.real},
         {"simd", report.simd},
         {"size", std::to_string(report.size.width) + 'x' + std::to_string(report.size.height)},
         {"threads", report.threads}});
    return head;
}

void add_times(json& times, const l3d_common_times& more) {
    times.update({{"raster", more.raster},
                  {"overlay", more.overlay},
                  {"total", more.total},
                  {"show", more.show},
                  {"write", more.write}});
}

void add_tail(json& line, const l3d_common_report& report, std::span<const left_out> reasons) {
    line["pixels_tested"] = report.surface.samples;
    line["pixels_written"] = report.surface.written;
    if (report.surface.covered != l3d_surface_counts::none_counted)
        line["pixels_covered"] = report.surface.covered;
    json& names = line["left_out"] = json::array();
    for (const left_out& reason : reasons)
        if (reason.count > 0)
            names.push_back(reason.name);
    line["hash"] = formatted("%016llx", static_cast<unsigned long long>(report.hash));
}

std::string explained(std::span<const left_out> reasons, std::int64_t all,
                      const std::string& what) {
    std::string text;
    for (const left_out& reason : reasons)
        if (reason.count > 0)
            text += "left out " + std::to_string(reason.count) + " of " + std::to_string(all) +
                    ' ' + what + " (" + reason.name + "): " + reason.proof + '\n';
    return text.empty() ? "left out nothing: all " + what + " may be seen\n" : text;
}

} // namespace l3d_detail

std::uint64_t l3d_hash(const l3d_pixels& pixels) {
    constexpr std::uint64_t offset_basis = 0xcbf29ce484222325, prime = 0x100000001b3;
    std::uint64_t hash = offset_basis;
    for (int y = 0; y < pixels.height; ++y)
        for (const std::uint32_t word : pixels.row(y))
            for (int byte = 0; byte < 4; ++byte)
                hash = (hash ^ ((word >> (8 * byte)) & 0xff)) * prime;
    return hash;
}
