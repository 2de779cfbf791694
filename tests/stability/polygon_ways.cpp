// SPDX-License-Identifier: MIT
// Frames of polygons.
#include "hard_edged.h"
#include "polygon_ways.h"

#include "compare/method_choice.h"
#include "pipeline/pipeline_afd.h"
#include "pipeline/polygons/polygon_model.h"
#include "pipeline/polygons/pipeline_zbuffer.h"
#include "pipeline/zsort/pipeline_zsort.h"
#include "raster/rasterizer_factory.h"
#include "tool_2d/screen_memory.h"

#include <cmath>
#include <cstdlib>
#include <string>

namespace stability {
namespace {

constexpr int quads = 8;

/// Larger pictures say nothing new of an order, and a painter writes all of their layers.
constexpr std::int64_t most_compared_pixels = 1'000'000;

std::vector<std::uint32_t> words_of(const l3d_pixels& pixels) {
    std::vector<std::uint32_t> words;
    for (int y = 0; y < pixels.height; ++y)
        words.insert(words.end(), pixels.row(y).begin(), pixels.row(y).end());
    return words;
}

class tessellation_way final : public arithmetic {
public:
    const char* name() const override { return "polygons"; }

    l3d_dice_counts dice(const library_case& c, const piece_sink& sink) override {
        return draw(c, sink).counts;
    }

    frame draw(const library_case& c, const piece_sink&) override {
        l3d_afd_settings settings = hard_edged();
        settings.depth = true;
        settings.method = l3d_method_choice{l3d_method::tessellation, quads}.factory();
        l3d_pipeline_afd pipeline(l3d_memory_canvas(c.size), c.model, c.camera, settings);
        pipeline.draw_event();
        frame result;
        result.counts = pipeline.report().dice;
        result.near = pipeline.report().near_z;
        result.milliseconds = pipeline.report().time_ms.total;
        result.words = words_of(pipeline.screen().pixels());
        result.distances = l3d_distances(pipeline.depth());
        return result;
    }
};

template <class Pipeline, class... More>
std::vector<std::uint32_t> drawn(const library_case& c, const More&... more) {
    l3d_polygon_settings settings = hard_edged_polygons();
    settings.shade = l3d_shade::lambert;
    settings.cull = false;
    Pipeline pipeline(l3d_memory_canvas(c.size),
                      l3d_polygon_model(l3d_tessellated(c.model, quads).mesh), c.camera, settings,
                      more...);
    pipeline.draw_event();
    return words_of(pipeline.screen().pixels());
}

/// "" or what differs.
std::string difference(const std::vector<std::uint32_t>& by_order,
                       const std::vector<std::uint32_t>& by_depth) {
    std::size_t covered = 0, other_cover = 0, other_level = 0;
    for (std::size_t i = 0; i < by_depth.size(); ++i) {
        covered += by_depth[i] != 0;
        if ((by_order[i] != 0) != (by_depth[i] != 0))
            ++other_cover;
        else
            other_level += std::abs(static_cast<int>(by_order[i] & 255) -
                                    static_cast<int>(by_depth[i] & 255)) > 1;
    }
    constexpr std::size_t a_part = 50; // ties of folded and collapsed patches
    if (other_cover > 0)
        return "zsort and zbuffer cover different pixels: " + std::to_string(other_cover);
    if (other_level > 2 + covered / a_part)
        return "zsort and zbuffer differ in " + std::to_string(other_level) + " of " +
               std::to_string(covered) + " pixels";
    return "";
}

} // namespace

verdict judged_as_polygons(const test_case& c) {
    judge j(c, {});
    tessellation_way way;
    verdict result = j.of_frame(way);
    result.measured = result.off;
    result.ratio = result.bound > 0 ? result.off / result.bound : 0;
    const auto pixels = std::int64_t{c.size.width} * c.size.height;
    if (!j.accepted() || result.what == outcome::violated || pixels > most_compared_pixels)
        return result;
    const std::string off =
        difference(drawn<l3d_pipeline_zsort>(*j.accepted()),
                   drawn<l3d_pipeline_zbuffer>(*j.accepted(), l3d_rasterizer_factory_sw()));
    if (!off.empty())
        result.violate(off);
    return result;
}

} // namespace stability
