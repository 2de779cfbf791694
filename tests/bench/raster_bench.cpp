// SPDX-License-Identifier: MIT
// Points, lines and polygons per second, 1024 x 768, one core; and what setting memory takes.
//
// The work is that by which the original l3d was measured. There are 2000 equilateral triangles of
// random turn and sub-pixel centre, wholly inside the picture. There are lines of 10, of up to 100
// pixels and from anywhere to anywhere, and dots anywhere. All goes through l3d_rasterizer_2d, one
// call each, and clipping is part of every call. After each measurement the picture is compared,
// word by word, with that of the slow twin in tests/raster/slow_2d.h. The same work is then done at
// the original's price of a pixel (book_raster), so that both are timed on one machine.
#include "book_raster.h"
#include "raster/shapes/rasterizer_2d_sw.h"
#include "raster/parallel/simd_target.h"
#include "raster/slow_2d.h"
#include "tool_2d/screen_memory.h"

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace {

constexpr l3d_size size{1024, 768};
constexpr std::size_t count = 2000;

/// Each thing has a colour of its own, so that the order of drawing is checked, too.
std::uint32_t color_of(std::size_t i) {
    return 0x00102030 + static_cast<std::uint32_t>(i) * 0x0101;
}

using triangle = std::array<l3d_point_2d, 3>;

double uniform(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

std::vector<triangle> triangles(double area) {
    const double radius = std::sqrt(area / (0.75 * std::numbers::sqrt3));
    std::mt19937 random(1);
    std::vector<triangle> result(count);
    for (triangle& t : result) {
        const double x = uniform(random, radius, size.width - radius);
        const double y = uniform(random, radius, size.height - radius);
        const double turn = uniform(random, 0, 2 * std::numbers::pi);
        for (std::size_t k = 0; k < 3; ++k) {
            const double angle = turn + static_cast<double>(k) * 2 * std::numbers::pi / 3;
            t[k] = {x + radius * std::cos(angle), y + radius * std::sin(angle)};
        }
    }
    return result;
}

/// Lines of a length in any direction, as long as they stay inside; length 0: anywhere to anywhere.
std::vector<l3d_line_2d> lines(double length) {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> x(0, size.width - 1), y(0, size.height - 1);
    const auto inside = [](double at, int end) {
        return std::clamp(static_cast<int>(std::lrint(at)), 0, end - 1);
    };
    std::vector<l3d_line_2d> result(count);
    for (l3d_line_2d& l : result) {
        l = {x(random), y(random), x(random), y(random)};
        const double turn = uniform(random, 0, 2 * std::numbers::pi);
        if (length > 0) {
            l.x1 = inside(l.x0 + length * std::cos(turn), size.width);
            l.y1 = inside(l.y0 + length * std::sin(turn), size.height);
        }
    }
    return result;
}

/// A picture and what draws into it.
struct canvas {
    canvas() { draw.clear_buffer(); }

    std::uint32_t& at(int x, int y) { return screen.pixels().row(y)[static_cast<std::size_t>(x)]; }

    l3d_screen_memory screen{size};
    l3d_rasterizer_2d_sw_imp imp{screen.pixels()};
    l3d_rasterizer_2d draw{imp};
};

std::int64_t lit(canvas& c) {
    std::int64_t n = 0;
    for (int y = 0; y < size.height; ++y)
        n += size.width - std::ranges::count(c.screen.pixels().row(y), 0u);
    return n;
}

/// Draws all things again and again; then both twins draw them once, and must agree.
template <class Things, class Fast, class Slow>
void measure(benchmark::State& state, const Things& things, const Fast& fast, const Slow& slow,
             bool measure_slow) {
    canvas c, expected;
    for (auto _ : state)
        for (std::size_t i = 0; i < things.size(); ++i)
            measure_slow ? slow(expected, things[i], color_of(i))
                         : fast(c.draw, things[i], color_of(i));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(things.size()));
    for (std::size_t i = 0; i < things.size(); ++i) {
        fast(c.draw, things[i], color_of(i));
        slow(expected, things[i], color_of(i));
    }
    for (int y = 0; y < size.height; ++y)
        if (!std::ranges::equal(c.screen.pixels().row(y), expected.screen.pixels().row(y)))
            return state.SkipWithError("the picture differs from the slow twin's");
    if (lit(c) == 0)
        state.SkipWithError("nothing was drawn");
}

/// What is measured is a closure, as for the book: the compiler would call a function by address.
constexpr auto draw_triangle = [](l3d_rasterizer_2d& draw, const triangle& t, std::uint32_t color) {
    draw.draw_polygon_flatshaded(t, color);
};

void draw_triangle_slowly(canvas& c, const triangle& t, std::uint32_t color) {
    const slow_2d::outline v = slow_2d::rounded(t);
    const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
    const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
    for (int y = static_cast<int>(top); y <= std::min<int>(int(bottom) + 1, size.height - 1); ++y)
        for (int x = static_cast<int>(left); x <= std::min<int>(int(right) + 1, size.width - 1);
             ++x)
            if (slow_2d::winding(v, x, y) != 0)
                c.at(x, y) = color;
}

void bench_triangles(benchmark::State& state, double area, bool slow) {
    measure(state, triangles(area), draw_triangle, draw_triangle_slowly, slow);
    state.counters["pixels/s"] = benchmark::Counter(
        area * static_cast<double>(state.iterations()) * count, benchmark::Counter::kIsRate);
}

/// Columns first <= x < last of a row.
struct row_span {
    int row, first, last;
};

/// The pixels of a triangle, as its slow twin finds them.
std::vector<row_span> spans_of(const triangle& t) {
    canvas one;
    draw_triangle_slowly(one, t, 1);
    std::vector<row_span> spans;
    for (int y = 0; y < size.height; ++y) {
        const auto row = one.screen.pixels().row(y);
        const auto begin = std::ranges::find(row, 1u), end = std::find(begin, row.end(), 0u);
        if (begin != end)
            spans.push_back({y, int(begin - row.begin()), int(end - row.begin())});
    }
    return spans;
}

/// A plain loop, which the compiler makes one of vector stores, as wide as the processor has.
[[gnu::target_clones("default", "avx2", "avx512f")]] void
store_spans(std::uint32_t* words, std::ptrdiff_t stride, const row_span* span, const row_span* end,
            std::uint32_t color) {
    for (; span != end; ++span) {
        const row_span s = *span; // which the stores might change, for all that the compiler knows
        std::uint32_t* const row = words + s.row * stride;
        for (std::int64_t x = s.first; x < s.last; ++x)
            row[x] = color;
    }
}

/// What the pixels of triangles cost if nothing but storing is left: their spans are known before.
void bench_stores(benchmark::State& state, double area) {
    std::vector<std::vector<row_span>> all;
    for (const triangle& t : triangles(area))
        all.push_back(spans_of(t));
    canvas c;
    const l3d_pixels pixels = c.screen.pixels();
    for (auto _ : state)
        for (std::size_t i = 0; i < all.size(); ++i)
            store_spans(pixels.words, pixels.stride, all[i].data(), all[i].data() + all[i].size(),
                        color_of(i));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
    if (lit(c) == 0)
        state.SkipWithError("nothing was drawn");
}

constexpr auto draw_line = [](l3d_rasterizer_2d& draw, const l3d_line_2d& l, std::uint32_t color) {
    draw.draw_line(l.x0, l.y0, l.x1, l.y1, color);
};

void draw_line_slowly(canvas& c, const l3d_line_2d& l, std::uint32_t color) {
    const int length = std::max(std::abs(l.x1 - l.x0), std::abs(l.y1 - l.y0));
    for (int i = 0; i <= length; ++i) {
        const auto [x, y] = slow_2d::pixel_of_line(l, i);
        c.at(static_cast<int>(x), static_cast<int>(y)) = color;
    }
}

void bench_lines(benchmark::State& state, double length, bool slow) {
    const std::vector<l3d_line_2d> all = lines(length);
    measure(state, all, draw_line, draw_line_slowly, slow);
    double pixels = 0;
    for (const l3d_line_2d& l : all)
        pixels += std::max(std::abs(l.x1 - l.x0), std::abs(l.y1 - l.y0)) + 1;
    state.counters["pixels/line"] = pixels / static_cast<double>(count);
}

constexpr auto draw_dot = [](l3d_rasterizer_2d& draw, const l3d_line_2d& l, std::uint32_t color) {
    draw.draw_point(l.x0, l.y0, color);
};

void draw_dot_slowly(canvas& c, const l3d_line_2d& l, std::uint32_t color) {
    c.at(l.x0, l.y0) = color;
}

/// Its picture is near ours, and not compared: the original was up to 0.53 pixels off.
template <class Things, class Draw>
void measure_book(benchmark::State& state, const Things& things, const Draw& draw) {
    canvas c;
    bench::book_raster book(c.screen.pixels());
    for (auto _ : state)
        for (std::size_t i = 0; i < things.size(); ++i)
            draw(book, things[i], color_of(i));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(things.size()));
    if (lit(c) == 0)
        state.SkipWithError("nothing was drawn");
}

void bench_book_lines(benchmark::State& state, double length) {
    measure_book(state, lines(length),
                 [](bench::book_raster& book, const l3d_line_2d& l, std::uint32_t color) {
                     book.draw_line(l.x0, l.y0, l.x1, l.y1, color);
                 });
}

void bench_book_triangles(benchmark::State& state, double area) {
    measure_book(state, triangles(area),
                 [](bench::book_raster& book, const triangle& t, std::uint32_t color) {
                     std::array<std::array<float, 2>, 3> corners;
                     for (std::size_t k = 0; k < 3; ++k)
                         corners[k] = {static_cast<float>(t[k].x), static_cast<float>(t[k].y)};
                     book.draw_triangle(corners, color);
                 });
}

void bench_dots(benchmark::State& state) {
    measure(state, lines(0), draw_dot, draw_dot_slowly, false);
}

void smooth_line(l3d_rasterizer_2d& draw, const l3d_line_2d& l, std::uint32_t color) {
    draw.draw_line_antialiased({double(l.x0), double(l.y0)}, {double(l.x1), double(l.y1)}, color);
}

/// Only speed: what smooth lines look like is tested elsewhere.
void bench_smooth_lines(benchmark::State& state, double length) {
    canvas c;
    const std::vector<l3d_line_2d> all = lines(length);
    for (auto _ : state)
        for (std::size_t i = 0; i < all.size(); ++i)
            smooth_line(c.draw, all[i], color_of(i));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
    if (lit(c) == 0)
        state.SkipWithError("nothing was drawn");
}

void bench_gouraud(benchmark::State& state, double area) {
    canvas c;
    const std::vector<triangle> all = triangles(area);
    for (auto _ : state)
        for (std::size_t i = 0; i < all.size(); ++i) {
            std::array<l3d_colored_point_2d, 3> corners;
            for (std::size_t k = 0; k < 3; ++k)
                corners[k] = {all[i][k].x, all[i][k].y, color_of(i + k * 977)};
            c.draw.draw_polygon_gouraudshaded(corners);
        }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
    if (lit(c) == 0)
        state.SkipWithError("nothing was drawn");
}

void bench_clear(benchmark::State& state, bool by_memset) {
    canvas c;
    const l3d_pixels pixels = c.screen.pixels();
    const std::size_t bytes = std::size_t(size.width) * std::size_t(size.height) * 4;
    for (auto _ : state) {
        if (by_memset)
            std::memset(pixels.words, 0, bytes);
        else
            c.draw.clear_buffer();
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes));
    state.counters["pixels/s"] =
        benchmark::Counter(static_cast<double>(bytes / 4) * static_cast<double>(state.iterations()),
                           benchmark::Counter::kIsRate);
    if (lit(c) != 0)
        state.SkipWithError("not all is black");
}

BENCHMARK_CAPTURE(bench_triangles, 10px, 10.0, false);
BENCHMARK_CAPTURE(bench_triangles, 100px, 100.0, false);
BENCHMARK_CAPTURE(bench_triangles, 10000px, 10000.0, false);
BENCHMARK_CAPTURE(bench_stores, 10px, 10.0);
BENCHMARK_CAPTURE(bench_stores, 100px, 100.0);
BENCHMARK_CAPTURE(bench_stores, 10000px, 10000.0);
BENCHMARK_CAPTURE(bench_gouraud, 10px, 10.0);
BENCHMARK_CAPTURE(bench_gouraud, 100px, 100.0);
BENCHMARK_CAPTURE(bench_gouraud, 10000px, 10000.0);
BENCHMARK_CAPTURE(bench_lines, 10px, 10.0, false);
BENCHMARK_CAPTURE(bench_lines, 100px, 100.0, false);
BENCHMARK_CAPTURE(bench_lines, anywhere, 0.0, false);
BENCHMARK_CAPTURE(bench_smooth_lines, 100px, 100.0);
BENCHMARK(bench_dots);
BENCHMARK_CAPTURE(bench_clear, clear_buffer, false);
BENCHMARK_CAPTURE(bench_clear, memset, true);
BENCHMARK_CAPTURE(bench_book_triangles, 10px, 10.0);
BENCHMARK_CAPTURE(bench_book_triangles, 100px, 100.0);
BENCHMARK_CAPTURE(bench_book_triangles, 10000px, 10000.0);
BENCHMARK_CAPTURE(bench_book_lines, 10px, 10.0);
BENCHMARK_CAPTURE(bench_book_lines, 100px, 100.0);
BENCHMARK_CAPTURE(bench_book_lines, anywhere, 0.0);
BENCHMARK_CAPTURE(bench_triangles, 100px_slow_twin, 100.0, true)->Iterations(3);
BENCHMARK_CAPTURE(bench_lines, 100px_slow_twin, 100.0, true)->Iterations(3);

} // namespace

/// The head of the figures says how they were measured.
int main(int argc, char** argv) {
    benchmark::AddCustomContext("simd", l3d_simd_target());
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    benchmark::RunSpecifiedBenchmarks();
}
