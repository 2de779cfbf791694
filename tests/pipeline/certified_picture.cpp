// SPDX-License-Identifier: MIT
// certified_picture: drawn, and summed up beside the exact picture.
#include "certified_picture.h"

#include "words_of.h"

#include "raster/depth_buffer.h"
#include "raster/rasterizer_factory.h"
#include "tool_2d/screen_memory.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>

namespace pipeline_tests {

certified_picture certified(const dice_tests::scene& s, const l3d_afd_settings& settings) {
    l3d_patch_scene world;
    world.add(s.model, s.placement);
    l3d_afd_settings with_map = settings;
    with_map.error_map = true;
    l3d_pipeline_afd pipeline(l3d_memory_canvas(s.size), world, s.camera, with_map);
    pipeline.draw_event();
    certified_picture result;
    for (const std::uint32_t word : words_of(pipeline.screen().pixels()))
        result.levels.push_back(word & 0xff);
    const auto bounds = pipeline.error_map()->levels();
    result.bounds.assign(bounds.begin(), bounds.end());
    return result;
}

void certified_sum::add(const certified_picture& drawn, const reference::box_image& exact) {
    for (std::size_t i = 0; i < drawn.levels.size(); ++i) {
        const reference::box_pixel& p = exact.pixels()[i];
        const double off = std::abs(drawn.levels[i] - p.level);
        const double bound = static_cast<double>(drawn.bounds[i]);
        ++pixels;
        largest_unsure = std::max(largest_unsure, p.unsure);
        if (!(off <= bound + p.unsure) && ++exceptions == 1) {
            const auto width = static_cast<std::size_t>(exact.size().width);
            char text[200];
            std::snprintf(text, sizeof text,
                          "(%zu, %zu): drawn %.0f, exact %.3f +- %.3f, bound %.3f\n", i % width,
                          i / width, drawn.levels[i], p.level, p.unsure, bound);
            where += text;
        }
        if (!(p.covered > 0))
            continue;
        ++shown;
        squares += off * off;
        bounds += bound;
        vacuous += bound >= std::max(drawn.levels[i], 255 - drawn.levels[i]);
        if (!p.edge)
            continue;
        ++edges;
        edge_squares += off * off;
        edge_bounds += bound;
    }
}

void certified_sum::add(const certified_sum& more) {
    pixels += more.pixels;
    shown += more.shown;
    edges += more.edges;
    vacuous += more.vacuous;
    exceptions += more.exceptions;
    unjudged += more.unjudged;
    squares += more.squares;
    edge_squares += more.edge_squares;
    bounds += more.bounds;
    edge_bounds += more.edge_bounds;
    largest_unsure = std::max(largest_unsure, more.largest_unsure);
    where += more.where;
}

void certified_sum::print(const std::string& name) const {
    const auto of = [](double sum, std::int64_t count) {
        return count > 0 ? sum / static_cast<double>(count) : 0;
    };
    std::printf("%-22s %9ld pixels, %8ld shown, %8ld edges; %ld exceptions, %ld pictures not "
                "judged; rms %.2f, of edges "
                "%.2f; bound %.2f, of edges %.2f; %.2f %% say nothing; unsure by %.2f at most\n",
                name.c_str(), static_cast<long>(pixels), static_cast<long>(shown),
                static_cast<long>(edges), static_cast<long>(exceptions),
                static_cast<long>(unjudged), std::sqrt(of(squares, shown)),
                std::sqrt(of(edge_squares, edges)), of(bounds, shown), of(edge_bounds, edges),
                100 * of(static_cast<double>(vacuous), shown), largest_unsure);
    std::fflush(stdout);
}

} // namespace pipeline_tests
