// SPDX-License-Identifier: MIT
// Polygons from 10^2 to 10^6 faces: painted in order, through our depth buffer, through Mesa's.
//
// A torus turned a little between frames, 1024 x 768, lambert shading, one thread of ours (llvmpipe
// takes all processors) or as many of both as one says. All three must show the same picture. The
// sort alone, without comparing and cutting, is the naive twin of zsort: its picture may be wrong.
// Then the exponent of the time in the number of faces, by least squares over the logarithms.
#include "hard_edged.h"
#include "geom/polygon_shapes.h"
#include "pipeline/zsort/painter_order.h"
#include "pipeline/polygons/pipeline_zbuffer.h"
#include "pipeline/zsort/pipeline_zsort.h"
#include "raster/rasterizer_factory.h"
#include "tool_2d/screen_memory.h"
#include "pipeline/polygons/polygon_frame.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace {

constexpr l3d_size size{1024, 768};

struct shape {
    int around, across;
};
constexpr std::array<shape, 9> shapes{{{10, 5},
                                       {16, 10},
                                       {25, 20},
                                       {50, 32},
                                       {100, 50},
                                       {160, 100},
                                       {250, 200},
                                       {500, 320},
                                       {1000, 500}}};

struct measured {
    double total = 0, place = 0, order = 0, raster = 0; ///< medians, milliseconds
    std::vector<std::uint32_t> picture;                 ///< of the last frame
    l3d_polygon_report last;
};

double median(std::vector<double> values) {
    std::ranges::nth_element(values,
                             values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
    return values[values.size() / 2];
}

measured measure(l3d_pipeline_polygons& pipeline, int frames) {
    std::vector<double> total, place, order, raster;
    for (int i = 0; i < frames + 2; ++i) {
        pipeline.key_event('x');
        pipeline.key_event(l3d_key_right);
        pipeline.draw_event();
        if (i < 2)
            continue; // its memory was still growing
        const l3d_polygon_times times = pipeline.report().time_ms;
        total.push_back(times.total);
        place.push_back(times.place);
        order.push_back(times.order);
        raster.push_back(times.raster);
    }
    measured result{median(total),    median(place), median(order), median(raster), {},
                    pipeline.report()};
    const l3d_pixels pixels = pipeline.screen().pixels();
    for (int y = 0; y < pixels.height; ++y)
        result.picture.insert(result.picture.end(), pixels.row(y).begin(), pixels.row(y).end());
    return result;
}

/// Pixels that are more than `levels` of grey apart.
long differing(const measured& a, const measured& b, int levels) {
    long count = 0;
    for (std::size_t i = 0; i < a.picture.size(); ++i)
        count += std::abs(static_cast<int>(a.picture[i] & 255) -
                          static_cast<int>(b.picture[i] & 255)) > levels;
    return count;
}

l3d_camera camera() {
    l3d_camera result;
    result.eye = {1.1, -5.2, 4.3};
    result.target = {0.05, 0.02, -0.1};
    result.up = {0, 0, 1};
    return result;
}

l3d_canvas canvas(std::shared_ptr<const l3d_rasterizer_factory> rasterizers) {
    return {std::make_unique<l3d_screen_memory>(size), std::move(rasterizers)};
}

/// The slope of log ms over log faces, of those of at least 10^4 faces.
class exponent {
public:
    void add(double faces, double ms) {
        if (faces < 9999)
            return;
        const double x = std::log(faces), y = std::log(ms);
        n_ += 1;
        x_ += x;
        y_ += y;
        xx_ += x * x;
        xy_ += x * y;
    }
    double slope() const { return (n_ * xy_ - x_ * y_) / (n_ * xx_ - x_ * x_); }

private:
    double n_ = 0, x_ = 0, y_ = 0, xx_ = 0, xy_ = 0;
};

/// Sorting without comparing: the naive twin.
double sorted_only_ms(const l3d_polygon_model& model, bool cull, int frames, int threads) {
    l3d_workers workers(threads);
    l3d_polygon_frame frame;
    const l3d_polygon_view view(camera(), size, l3d_identity<double>());
    frame.make(model, view, {.cull = cull, .smooth = true}, workers);
    std::vector<l3d_painter_triangle> triangles;
    l3d_painter_order order(workers);
    std::vector<double> times;
    for (int i = 0; i < frames; ++i) {
        const auto start = std::chrono::steady_clock::now();
        frame.list(triangles, workers);
        order.make(triangles, size, {.resolve = false, .sides = false});
        times.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                .count());
    }
    return median(times);
}

bool bench(bool cull, int threads) {
    std::printf("\n%s\n%8s %8s | %8s %8s %8s %8s %8s | %8s | %8s | %6s %6s %8s %8s\n",
                cull ? "faces seen from behind left out" : "all faces drawn", "faces", "drawn",
                "zsort", "place", "order", "(sort)", "paint", "zbuffer", "mesa", "knots", "cuts",
                "differ", "B/face");
    const auto sw = std::make_shared<l3d_rasterizer_factory_sw>();
    const auto mesa = std::make_shared<l3d_rasterizer_factory_mesa>();
    exponent of_zsort, of_zbuffer, of_mesa, of_order;
    bool good = true;
    for (const shape s : shapes) {
        const l3d_polygon_model model(l3d_torus_mesh(s.around, s.across));
        const auto faces = static_cast<double>(model.mesh().faces());
        const int frames = std::clamp(static_cast<int>(3e5 / faces), 3, 25);
        l3d_polygon_settings settings = hard_edged_polygons();
        settings.shade = l3d_shade::lambert;
        settings.cull = cull;
        settings.threads = threads;
        l3d_pipeline_zsort zsort(canvas(sw), model, camera(), settings);
        l3d_pipeline_zbuffer zbuffer(canvas(sw), model, camera(), settings, *sw);
        l3d_pipeline_zbuffer gl(canvas(sw), model, camera(), settings, *mesa, "mesa");
        const measured by_order = measure(zsort, frames), by_depth = measure(zbuffer, frames),
                       by_gl = measure(gl, frames);
        const double sorted = sorted_only_ms(model, cull, frames, threads);
        // Grey by lanes may be a level off; where two depths tie, either may be seen.
        const long wrong = differing(by_order, by_depth, 1);
        const long covered =
            std::ssize(by_depth.picture) - std::ranges::count(by_depth.picture, 0u);
        good = good && wrong * 1000 <= covered && covered > size.width * size.height / 20;
        std::printf("%8.0f %8lld | %8.3f %8.3f %8.3f %8.3f %8.3f | %8.3f | %8.3f | %6lld %6lld "
                    "%8ld %8.1f\n",
                    faces, static_cast<long long>(by_order.last.polygons.drawn), by_order.total,
                    by_order.place, by_order.order, sorted, by_order.raster, by_depth.total,
                    by_gl.total, static_cast<long long>(by_order.last.order.knots),
                    static_cast<long long>(by_order.last.order.cuts), wrong,
                    static_cast<double>(model.bytes()) / faces);
        std::fflush(stdout);
        of_zsort.add(faces, by_order.total);
        of_order.add(faces, by_order.order);
        of_zbuffer.add(faces, by_depth.total);
        of_mesa.add(faces, by_gl.total);
    }
    std::printf("exponents from 10^4 faces on: zsort %.3f (order alone %.3f), zbuffer %.3f, "
                "mesa %.3f\n",
                of_zsort.slope(), of_order.slope(), of_zbuffer.slope(), of_mesa.slope());
    return good;
}

} // namespace

int main(int argc, char** argv) {
    // "cull" or "all" measures one half, for machines that others use, too. A number of threads
    // after it is that of zbuffer, of placing, and of llvmpipe. Without it, ours have one.
    const std::string half = argc > 1 ? argv[1] : "";
    const char* const given = argc > 2 ? argv[2] : nullptr;
    const int threads = given ? std::max(std::atoi(given), 1) : 1;
    if (given)
        setenv("LP_NUM_THREADS", given, 1);
    std::printf("milliseconds per frame, medians; threads: %d of ours, %s of llvmpipe\n", threads,
                given ? "as many" : "all");
    bool good = true;
    if (half != "all")
        good = bench(true, threads) && good;
    if (half != "cull")
        good = bench(false, threads) && good;
    if (!good)
        std::printf("WRONG: zsort and zbuffer do not show the same picture\n");
    return good ? 0 : 1;
}
