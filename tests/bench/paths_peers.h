// SPDX-License-Identifier: MIT
// A picture of each library that fills smooth paths, and a row of the comparison.
#ifndef L3D_TESTS_BENCH_PATHS_PEERS_H
#define L3D_TESTS_BENCH_PATHS_PEERS_H

#include "processor_time.h"
#include "raster/paths/path.h"
#include "raster/shapes/rasterizer_2d_sw.h"
#include "tool_2d/screen_memory.h"

#include <agg2/agg_path_storage.h>
#include <agg2/agg_pixfmt_rgba.h>
#include <agg2/agg_rasterizer_scanline_aa.h>
#include <agg2/agg_renderer_scanline.h>
#include <agg2/agg_scanline_p.h>
#include <cairo/cairo.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace path_bench {

inline constexpr l3d_size size{1024, 768};
inline constexpr std::uint32_t color = 0x00e0a040;
/// AGG's arcs are within 1/8 pixel at scale 1.
inline constexpr double agg_scale = 0.125 / l3d_flat_enough;

/// A picture for each library.
struct peers {
    peers()
        : surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.width, size.height)),
          cairo(cairo_create(surface)), agg_words(std::size_t(size.width) * size.height),
          buffer(reinterpret_cast<unsigned char*>(agg_words.data()), unsigned(size.width),
                 unsigned(size.height), size.width * 4),
          format(buffer), renderer(format), solid(renderer) {
        cairo_set_source_rgb(cairo, 0xe0 / 255.0, 0xa0 / 255.0, 0x40 / 255.0);
        solid.color(agg::rgba8(0xe0, 0xa0, 0x40));
        cairo_set_tolerance(cairo, l3d_flat_enough);
        rasterizer.clip_box(0, 0, size.width, size.height);
    }
    ~peers() {
        cairo_destroy(cairo);
        cairo_surface_destroy(surface);
    }
    peers(const peers&) = delete;
    peers& operator=(const peers&) = delete;

    void clear() {
        draw.clear_buffer();
        std::ranges::fill(agg_words, 0u);
        cairo_save(cairo);
        cairo_set_source_rgb(cairo, 0, 0, 0);
        cairo_paint(cairo);
        cairo_restore(cairo);
    }

    template <class Source> void agg_fill(Source& source) {
        rasterizer.reset();
        rasterizer.add_path(source);
        agg::render_scanlines(rasterizer, line, solid);
    }

    l3d_screen_memory screen{size};
    l3d_rasterizer_2d_sw_imp imp{screen.pixels()};
    l3d_rasterizer_2d draw{imp};
    l3d_path path;
    cairo_surface_t* surface;
    cairo_t* cairo;
    std::vector<std::uint32_t> agg_words;
    agg::rendering_buffer buffer;
    using format_type = agg::pixfmt_bgra32;
    using base_type = agg::renderer_base<format_type>;
    format_type format;
    base_type renderer;
    agg::renderer_scanline_aa_solid<base_type> solid;
    agg::rasterizer_scanline_aa<> rasterizer;
    agg::scanline_p8 line;
    agg::path_storage agg_path;
};

inline double mean_difference(peers& p, const std::uint32_t* words, std::ptrdiff_t stride) {
    double sum = 0, count = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const std::uint32_t a = p.screen.pixels().row(y)[std::size_t(x)];
            const std::uint32_t b = words[y * stride + x];
            if (((a | b) & 0x00ffffff) == 0)
                continue;
            ++count;
            for (const int shift : {0, 8, 16})
                sum += std::abs(int(a >> shift & 255) - int(b >> shift & 255)) / 3.0;
        }
    return count > 0 ? sum / count : 0;
}

/// The median of a few turns, in microseconds.
inline double median(const std::function<void()>& turn) {
    std::vector<double> times;
    const double end = processor_seconds() + 0.4;
    while (times.size() < 5 || (processor_seconds() < end && times.size() < 2000)) {
        const double begin = processor_seconds();
        turn();
        times.push_back(1e6 * (processor_seconds() - begin));
    }
    std::ranges::nth_element(times, times.begin() + std::ptrdiff_t(times.size() / 2));
    return times[times.size() / 2];
}

using turn = std::function<void(peers&)>;

inline void row(const std::string& name, const turn& ours, const turn& cairo, const turn& agg) {
    peers p;
    p.clear();
    ours(p);
    cairo(p);
    cairo_surface_flush(p.surface);
    const double cairo_off = mean_difference(
        p, reinterpret_cast<const std::uint32_t*>(cairo_image_surface_get_data(p.surface)),
        cairo_image_surface_get_stride(p.surface) / 4);
    double agg_off = 0;
    if (agg) {
        agg(p);
        agg_off = mean_difference(p, p.agg_words.data(), size.width);
    }
    const double mine = median([&] { ours(p); });
    const double his = median([&] { cairo(p); });
    std::printf("%-34s %10.1f us   cairo %7.2f x, off %5.2f", name.c_str(), mine, his / mine,
                cairo_off);
    if (agg)
        std::printf("   agg %7.2f x, off %5.2f", median([&] { agg(p); }) / mine, agg_off);
    std::printf("\n");
}

} // namespace path_bench

#endif
