// SPDX-License-Identifier: MIT
// l3d_frame_report: as JSON and in words.
#include "pipeline/frame_report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace {

/// What patches can be left out for, and why that is right.
struct reason {
    const char* name;
    const char* proof;
    std::int64_t l3d_dice_counts::*count;
};

constexpr std::array<reason, 5> reasons{{
    {"offscreen",
     "their control nets, and with them the patches, lie beyond one side of the window",
     &l3d_dice_counts::offscreen},
    {"behind", "their control nets lie behind the near plane", &l3d_dice_counts::behind},
    {"beyond", "their control nets lie beyond the far plane", &l3d_dice_counts::beyond},
    {"subpixel", "the hulls of their control nets hold no pixel centre",
     &l3d_dice_counts::subpixel},
    {"hidden", "their boxes lie behind nearer surfaces drawn before, in every pixel",
     &l3d_dice_counts::hidden},
}};

/// JSON has no infinity; null stands for "no bound can be given".
nlohmann::ordered_json number_or_null(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

} // namespace

std::string l3d_frame_report::json() const {
    nlohmann::ordered_json left_out = nlohmann::ordered_json::object();
    nlohmann::ordered_json names = nlohmann::ordered_json::array();
    for (const reason& r : reasons) {
        left_out[r.name] = dice.*r.count;
        if (dice.*r.count > 0)
            names.push_back(r.name);
    }
    const nlohmann::ordered_json line{
        {"frame", frame},
        {"method", method},
        {"real", real},
        {"simd", simd},
        {"size", std::to_string(size.width) + 'x' + std::to_string(size.height)},
        {"threads", threads},
        {"tolerance_px", tolerance_px},
        {"time_ms",
         {{"transform", time_ms.transform},
          {"dice", time_ms.dice},
          {"raster", time_ms.raster},
          {"overlay", time_ms.overlay},
          {"total", time_ms.total},
          {"show", time_ms.show},
          {"write", time_ms.write}}},
        {"patches",
         {{"all", patches},
          {"drawn", dice.drawn},
          {"left_out", left_out},
          {"pieces", dice.pieces},
          {"clipped", dice.clipped}}},
        {"samples", dice.samples},
        {"failures", dice.failures},
        {"quads", surface.quads},
        {"pixels_tested", surface.samples},
        {"pixels_written", surface.written},
        {"pixels_covered", surface.covered},
        {"error_bound_px", number_or_null(dice.bound_px)},
        {"left_out", names},
        {"hash", [this] {
             std::array<char, 17> text{};
             std::snprintf(text.data(), text.size(), "%016llx",
                           static_cast<unsigned long long>(hash));
             return std::string(text.data());
         }()}};
    return line.dump();
}

std::string l3d_frame_report::explanation() const {
    std::string text;
    for (const reason& r : reasons)
        if (const std::int64_t n = dice.*r.count; n > 0)
            text += "left out " + std::to_string(n) + " of " + std::to_string(patches) +
                    " patches (" + r.name + "): " + r.proof + '\n';
    if (text.empty())
        text = "left out nothing: every patch may be seen\n";
    return text;
}

std::uint64_t l3d_hash(const l3d_pixels& pixels) {
    constexpr std::uint64_t offset_basis = 0xcbf29ce484222325, prime = 0x100000001b3;
    std::uint64_t hash = offset_basis;
    for (int y = 0; y < pixels.height; ++y)
        for (const std::uint32_t word : pixels.row(y))
            for (int byte = 0; byte < 4; ++byte)
                hash = (hash ^ ((word >> (8 * byte)) & 0xff)) * prime;
    return hash;
}
