// SPDX-License-Identifier: MIT
// l3d_frame_report: as JSON and in words.
#include "pipeline/frame_report.h"

#include "pipeline/report_json_p.h"

#include <array>
#include <cmath>

namespace {

std::array<l3d_detail::left_out, 6> reasons_of(const l3d_dice_counts& dice) {
    return {{
        {"offscreen",
         "their control nets, and with them the patches, lie beyond one side of the window",
         dice.offscreen},
        {"behind", "their control nets lie behind the near plane", dice.behind},
        {"beyond", "their control nets lie beyond the far plane", dice.beyond},
        {"subpixel", "the hulls of their control nets hold no pixel centre", dice.subpixel},
        {"hidden", "their boxes lie behind nearer surfaces drawn before, in every pixel",
         dice.hidden},
        {"unchanged", "they touch no pixel in which anything changed since the last frame",
         dice.unchanged},
    }};
}

/// JSON has no infinity; null stands for "no bound can be given".
l3d_detail::json number_or_null(double value) {
    return std::isfinite(value) ? l3d_detail::json(value) : l3d_detail::json(nullptr);
}

} // namespace

std::string l3d_frame_report::json() const {
    const auto reasons = reasons_of(dice);
    l3d_detail::json times{{"transform", time_ms.transform}, {"dice", time_ms.dice}};
    l3d_detail::add_times(times, time_ms);
    l3d_detail::json line = l3d_detail::head_json(*this);
    line.update({{"tolerance_px", tolerance_px},
                 {"near", near},
                 {"time_ms", times},
                 {"patches",
                  {{"all", patches},
                   {"drawn", dice.drawn},
                   {"left_out", l3d_detail::counts_json(reasons)},
                   {"pieces", dice.pieces},
                   {"clipped", dice.clipped}}},
                 {"samples", dice.samples},
                 {"failures", dice.failures},
                 {"quads", surface.quads},
                 {"pixels_kept", pixels_kept},
                 {"error_bound_px", number_or_null(dice.bound_px)}});
    l3d_detail::add_tail(line, *this, reasons);
    return line.dump();
}

std::string l3d_frame_report::explanation() const {
    std::string text = l3d_detail::explained(reasons_of(dice), patches, "patches");
    if (pixels_kept > 0)
        text += "kept " + std::to_string(pixels_kept) + " of " +
                std::to_string(l3d_whole(size).area()) +
                " pixels of the last frame: they were not cleared, filled or shown again\n";
    return text;
}
