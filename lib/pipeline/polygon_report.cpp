// SPDX-License-Identifier: MIT
// l3d_polygon_report: as JSON.
#include "pipeline/polygon_report.h"

#include "geom/real.h"
#include "raster/simd_target.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>

std::string l3d_polygon_report::json() const {
    std::array<char, 17> hash_text{};
    std::snprintf(hash_text.data(), hash_text.size(), "%016llx",
                  static_cast<unsigned long long>(hash));
    nlohmann::ordered_json names = nlohmann::ordered_json::array();
    const auto name_if = [&](std::int64_t count, const char* name) {
        if (count > 0)
            names.push_back(name);
    };
    name_if(polygons.back, "back");
    name_if(polygons.outside, "offscreen");
    name_if(polygons.subpixel, "subpixel");
    nlohmann::ordered_json line{
        {"frame", frame},
        {"method", method},
        {"real", l3d_real_name()},
        {"simd", l3d_simd_target()},
        {"size", std::to_string(size.width) + 'x' + std::to_string(size.height)},
        {"threads", threads},
        {"time_ms",
         {{"place", time_ms.place},
          {"order", time_ms.order},
          {"raster", time_ms.raster},
          {"overlay", time_ms.overlay},
          {"total", time_ms.total},
          {"show", time_ms.show},
          {"write", time_ms.write}}},
        {"faces", faces},
        {"triangles",
         {{"all", triangles},
          {"drawn", polygons.drawn},
          {"left_out",
           {{"back", polygons.back},
            {"offscreen", polygons.outside},
            {"subpixel", polygons.subpixel}}},
          {"clipped", polygons.clipped}}},
        {"order",
         {{"compared", order.pairs},
          {"knots", order.knots},
          {"knotted", order.knotted},
          {"cuts", order.cuts}}},
        {"pixels_tested", surface.samples},
        {"pixels_written", surface.written},
        {"left_out", names},
        {"hash", hash_text.data()}};
    if (surface.covered > 0) // the painter does not know
        line["pixels_covered"] = surface.covered;
    return line.dump();
}
