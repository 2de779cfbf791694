// SPDX-License-Identifier: MIT
// l3d_polygon_report: as JSON and in words.
#include "pipeline/polygons/polygon_report.h"

#include "pipeline/report_json_p.h"

#include <array>

namespace {

std::array<l3d_detail::left_out, 3> reasons_of(const l3d_polygon_counts& polygons) {
    return {{
        {"back", "the eye lies behind the planes of their faces, or these have no area",
         polygons.back},
        {"offscreen", "their corners lie beyond one side of the window", polygons.offscreen},
        {"subpixel", "the boxes of their corners hold no pixel centre", polygons.subpixel},
    }};
}

} // namespace

std::string l3d_polygon_report::json() const {
    const auto reasons = reasons_of(polygons);
    l3d_detail::json times{{"place", time_ms.place}, {"order", time_ms.order}};
    l3d_detail::add_times(times, time_ms);
    l3d_detail::json line = l3d_detail::head_json(*this);
    line.update({{"time_ms", times},
                 {"faces", faces},
                 {"triangles",
                  {{"all", triangles},
                   {"drawn", polygons.drawn},
                   {"left_out", l3d_detail::counts_json(reasons)},
                   {"clipped", polygons.clipped}}},
                 {"order",
                  {{"compared", order.pairs},
                   {"knots", order.knots},
                   {"knotted", order.knotted},
                   {"cuts", order.cuts}}}});
    l3d_detail::add_tail(line, *this, reasons);
    return line.dump();
}

std::string l3d_polygon_report::explanation() const {
    return l3d_detail::explained(reasons_of(polygons), triangles, "triangles");
}
