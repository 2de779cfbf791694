// SPDX-License-Identifier: MIT
// l3d_frame_report, l3d_polygon_report: tell about a frame in JSON and in words.
#include "pipeline/frame_report.h"

#include "base/counted_p.h"
#include "base/formatted_p.h"
#include "pipeline/report_json_p.h"
#include "scene/culling/facing_cones.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

std::array<l3d_detail::left_out, 7> reasons_of(const l3d_dice_counts& dice) {
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
        {"backfacing",
         "their cones of normals point away from the eye, and their backs are not wanted or belong "
         "to a closed body with the eye outside",
         dice.backfacing},
    }};
}

/// A bound as JSON: its number, or null if the bound is infinite, since JSON has no infinity. Null
/// means that there is no bound.
l3d_detail::json number_or_null(double value) {
    return std::isfinite(value) ? l3d_detail::json(value) : l3d_detail::json(nullptr);
}

/// The patches over the tolerance as JSON: their number, the number of those that the budget left
/// unfinished, and the worst patch. The worst patch has its instance's index in the scene, its
/// index in its model, and its bound.
l3d_detail::json over_tolerance_of(const l3d_dice_counts& dice) {
    l3d_detail::json result{{"patches", dice.coarse}, {"for_budget", dice.unfinished}};
    if (dice.coarse > 0)
        result["worst"] = {{"instance", dice.coarsest.instance},
                           {"patch", dice.coarsest.patch},
                           {"bound_px", number_or_null(dice.coarsest.bound_px)}};
    return result;
}

} // namespace

std::string l3d_frame_report::json() const {
    const auto reasons = reasons_of(dice);
    l3d_detail::json times{{"transform", time_ms.transform}, {"dice", time_ms.dice}};
    l3d_detail::add_times(times, time_ms);
    const bool has_outlines = outline_pixels != l3d_surface_counts::none_counted;
    if (has_outlines)
        times["outlines"] = time_ms.outlines;
    if (time_ms.error_map > 0)
        times["error_map"] = time_ms.error_map;
    l3d_detail::json line = l3d_detail::head_json(*this);
    line.update({{"tolerance_px", tolerance_px},
                 {"near", near_z},
                 {"time_ms", times},
                 {"patches",
                  {{"all", patches},
                   {"drawn", dice.drawn},
                   {"left_out", l3d_detail::counts_json(reasons)},
                   {"points", dice.as_points},
                   {"back_blocks", dice.back_blocks},
                   {"back_quads", dice.back_quads},
                   {"pieces", dice.pieces},
                   {"clipped", dice.clipped}}},
                 {"over_tolerance", over_tolerance_of(dice)},
                 {"samples", dice.samples},
                 {"failures", dice.failures},
                 {"quads", surface.quads},
                 {"shaded_by_plane", surface.by_plane},
                 {"pixels_refined", surface.refined},
                 {"pixels_unsolved", surface.unsolved},
                 {"shade_error_bound", number_or_null(dice.shade_bound)},
                 {"shade_unproven_quads", dice.unproven_quads},
                 {"pixels_kept", pixels_kept},
                 {"outline_pixels",
                  has_outlines ? l3d_detail::json(outline_pixels) : l3d_detail::json(nullptr)},
                 {"error_bound_px", number_or_null(dice.bound_px)},
                 {"depth_error_bound_px", number_or_null(dice.depth_bound_px)},
                 {"curved_px", number_or_null(curved_px)},
                 {"edges_px", number_or_null(dice.edges_px)},
                 {"coverage_error_bound", number_or_null(coverage_bound)},
                 {"color_error_bound", number_or_null(color_bound)}});
    l3d_detail::add_tail(line, *this, reasons);
    return line.dump();
}

/// Makes lines of text about patches that were drawn although a part of their work was left out.
std::string l3d_frame_report::left_out_in_part() const {
    std::string text;
    if (dice.back_blocks > 0)
        text += "left out " + std::to_string(dice.back_blocks) + " of " +
                std::to_string(l3d_facing_cones::blocks * static_cast<std::uint64_t>(dice.drawn)) +
                " blocks of the others, " + std::to_string(dice.back_quads) +
                " quads (backfacing): for the same reason\n";
    if (dice.as_points > 0)
        text += "left out dicing of " + std::to_string(dice.as_points) +
                " patches, drawn as points: their hulls are no wider than the tolerance\n";
    if (surface.by_plane > 0)
        text += "left out the unit normal of each pixel in " + std::to_string(surface.by_plane) +
                " quads and triangles: the length of the interpolated one changes a grey by less "
                "than a level in them\n";
    return text;
}

std::string l3d_frame_report::explanation() const {
    const auto reasons = reasons_of(dice);
    const bool whole_patches =
        std::any_of(reasons.begin(), reasons.end(), [](const auto& r) { return r.count > 0; });
    const std::string parts = left_out_in_part();
    std::string text = parts;
    if (whole_patches || parts.empty())
        text = l3d_detail::explained(reasons, patches, "patches") + parts;
    if (dice.coarse > 0)
        text += l3d_detail::counted(static_cast<std::size_t>(dice.coarse), "patches") +
                " over the tolerance; the worst, number " + std::to_string(dice.coarsest.patch) +
                " of instance " + std::to_string(dice.coarsest.instance) + ", has a bound of " +
                l3d_detail::formatted("%.6f px\n", dice.coarsest.bound_px);
    if (dice.unfinished > 0)
        text += std::to_string(dice.unfinished) +
                " of these would be finer if the frame might cost more: --most-samples\n";
    if (pixels_kept > 0)
        text += "kept " + std::to_string(pixels_kept) + " of " +
                std::to_string(l3d_whole(size).area()) +
                " pixels of the last frame: they were not cleared, filled or shown again\n";
    if (surface.refined > 0)
        text +=
            "refined " + std::to_string(surface.refined) + " of " +
            std::to_string(l3d_whole(size).area()) +
            " pixels, whose level is far from a neighbour's: they show means over their squares\n";
    if (surface.unsolved > 0)
        text += "found no exact place on the patch for " + std::to_string(surface.unsolved) +
                " pixels, as beside outlines: they show what is between the drawn vertices\n";
    if (outline_pixels != l3d_surface_counts::none_counted)
        text += "the bound of an outline reaches " + std::to_string(outline_pixels) + " of " +
                std::to_string(l3d_whole(size).area()) +
                " pixels: what is seen there is not certified\n";
    return text;
}

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
