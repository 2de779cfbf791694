// SPDX-License-Identifier: MIT
// How frames grow: with the number of teapots, with the picture, and as the tolerance shrinks.
//
// Each scene is drawn by one thread and by two, which must give the same bits, and every patch must
// be either drawn or left out for a reason. The cost of what is left out is the difference to the
// scene without it, which is the baseline.
#include "bench/bench_frame.h"
#include "geom/teapot.h"
#include "processor_time.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>
#include <vector>

namespace {

using vector = l3d_camera::vector;

constexpr l3d_size usual{1024, 768};
const l3d_camera& full = bench_views[0].camera;

[[noreturn]] void fail(const char* what) {
    std::fprintf(stderr, "scaling_bench: %s\n", what);
    std::exit(EXIT_FAILURE);
}

/// Units: milliseconds.
struct cost {
    double one = 0; ///< of the processor, by one thread: what it would take if nobody else ran
    double two = 0; ///< by the wall's clock, by two threads
    l3d_frame_report report;

    double drawn() const { return static_cast<double>(report.dice.drawn); }
    double left_out() const { return static_cast<double>(report.patches - report.dice.drawn); }
};

double median(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

cost measured(const l3d_patch_scene& scene, l3d_size size, double tolerance, int frames) {
    cost result;
    std::vector<double> times;
    bench_frame one(scene, full, size, tolerance, 1);
    const std::uint64_t hash = one.hash();
    result.report = one.report();
    const l3d_dice_counts& d = result.report.dice;
    if (d.drawn + d.offscreen + d.behind + d.beyond + d.subpixel + d.hidden + d.backfacing !=
        result.report.patches)
        fail("patches are lost");
    for (int i = 0; i < frames; ++i) {
        const double before = processor_seconds();
        one.draw();
        times.push_back(1000 * (processor_seconds() - before));
    }
    result.one = median(times);

    bench_frame two(scene, full, size, tolerance, 2);
    if (two.hash() != hash)
        fail("two threads draw another picture than one");
    times.clear();
    for (int i = 0; i < frames; ++i)
        times.push_back(two.draw());
    result.two = median(times);
    return result;
}

l3d_matrix<double> random_turn(std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(-1, 1);
    return l3d_rotation<double>({unit(random), unit(random), 1.0}, 172 * unit(random));
}

/// Uniformly within a ball around the eye, or in that part of it which the picture shows.
vector random_place(std::mt19937_64& random, double radius, bool in_picture) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const l3d_camera::frame axes = full.axes();
    const double down = std::tan(full.fov / 2 * 0.017453292519943295);
    const double across = down * usual.width / usual.height;
    for (;;) {
        const vector p(unit(random), unit(random), unit(random));
        const double w = l3d_dot(p, axes.forward);
        const bool shown = w > 0 && std::abs(l3d_dot(p, axes.right)) < across * w &&
                           std::abs(l3d_dot(p, axes.up)) < down * w;
        if (l3d_dot(p, p) <= 1 && (shown || !in_picture))
            return full.eye + p * radius;
    }
}

/// The teapot of the view, and others that are small, as they are far away, or off-screen. Every
/// second one is placed anywhere around the eye, where the picture shows a twentieth of all.
l3d_patch_scene crowd(const l3d_patch_model& model, int count) {
    constexpr double radius = 1500; // a teapot is 5 pixels wide there
    std::mt19937_64 random(20061);
    l3d_patch_scene scene = model;
    for (int i = 1; i < count; ++i) {
        const vector p = random_place(random, radius, i % 2 == 0);
        scene.add(model, l3d_translation<double>(p[0], p[1], p[2]) * random_turn(random));
    }
    return scene;
}

/// Slope of log y over log x between two points.
double exponent(double x0, double y0, double x1, double y1) {
    return std::log(y1 / y0) / std::log(x1 / x0);
}

void print_crowds(const l3d_patch_model& model, int most) {
    std::printf(
        "teapots at %dx%d, tolerance 0.5 px; exponent: of the time of one thread over drawn "
        "patches, from the line above\n",
        usual.width, usual.height);
    std::printf("%7s %8s %9s %9s %9s %9s %9s %13s %9s\n", "teapots", "patches", "drawn", "left out",
                "quads", "ms, 1", "ms, 2", "us/drawn, 1", "exponent");
    cost before;
    for (int count = 1; count <= most; count *= 10) {
        const cost c = measured(crowd(model, count), usual, 0.5, count < 1000 ? 41 : 11);
        std::printf("%7d %8lld %9.0f %9.0f %9lld %9.3f %9.3f %13.2f", count,
                    static_cast<long long>(c.report.patches), c.drawn(), c.left_out(),
                    static_cast<long long>(c.report.surface.quads), c.one, c.two,
                    1000 * c.one / c.drawn());
        if (count > 1)
            std::printf(" %9.2f", exponent(before.drawn(), before.one, c.drawn(), c.one));
        std::printf("\n");
        before = c;
    }
}

void print_left_out(const char* what, const l3d_patch_scene& without, const l3d_patch_scene& with) {
    const cost base = measured(without, usual, 0.5, 31), all = measured(with, usual, 0.5, 31);
    const double more = all.left_out() - base.left_out();
    std::printf("%-20s %8.0f patches left out: %8.3f ms without them, %8.3f with: %7.4f us each\n",
                what, more, base.one, all.one, 1000 * (all.one - base.one) / more);
}

/// A flat patch across the whole picture, so far in front of the eye.
l3d_patch_model wall_model(double distance) {
    const l3d_camera::frame axes = full.axes();
    l3d_patch_model::patch patch;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            patch.at(row, column) =
                full.eye +
                (axes.forward + axes.right * (column - 1.5) + axes.up * (row - 1.5)) * distance;
    return l3d_patch_model({patch});
}

/// Many bumps in a row along the view axis: one instance of many patches, as a terrain is.
l3d_patch_model tail_model(double from, int patches) {
    const l3d_camera::frame axes = full.axes();
    std::vector<l3d_patch_model::patch> result(static_cast<std::size_t>(patches));
    for (std::size_t i = 0; i < result.size(); ++i)
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column) {
                const double w = from + 0.01 * static_cast<double>(i) + 0.1 * (row % 2);
                result[i].at(row, column) = full.eye + axes.forward * w +
                                            axes.right * (0.1 * column) + axes.up * (0.1 * row);
            }
    return l3d_patch_model(std::move(result));
}

void print_all_left_out(const l3d_patch_model& model, int count) {
    std::printf("\nleft out at %dx%d, by one thread\n", usual.width, usual.height);
    std::mt19937_64 random(733);
    const auto axes = full.axes();
    const auto placed = [&](const vector& p) {
        return l3d_translation<double>(p[0], p[1], p[2]) * random_turn(random);
    };

    l3d_patch_scene beside = model;
    for (int i = 0; i < count; ++i)
        beside.add(model, placed(random_place(random, 200, false) + axes.right * 400.0));
    print_left_out("off-screen teapots", model, beside);

    // Until the first batch is drawn, nothing can be hidden: three teapots go with the wall.
    const l3d_patch_model wall = wall_model(4), tail = tail_model(8, 28 * count);
    l3d_patch_scene in_front = wall;
    for (int i = 0; i < 3; ++i)
        in_front.add(model, placed(random_place(random, 10, true) + axes.forward * 12.0));
    l3d_patch_scene teapots = in_front, patches = in_front;
    for (int i = 0; i < count; ++i)
        teapots.add(model, placed(random_place(random, 300, true) + axes.forward * 30.0));
    patches.add(tail);
    print_left_out("hidden teapots", in_front, teapots);
    print_left_out("a hidden model", in_front, patches);

    // The same model, but its box reaches before the wall: its patches are tested one by one.
    l3d_patch_model::patch nearest = wall.patches()[0];
    for (auto& point : nearest.points)
        point = full.eye + (point - full.eye) * 0.9;
    std::vector<l3d_patch_model::patch> mixed{nearest};
    mixed.insert(mixed.end(), tail.patches().begin(), tail.patches().end());
    const l3d_patch_model partly(std::move(mixed));
    print_left_out("patches, one by one", in_front, partly);
}

void print_sizes(const l3d_patch_model& model) {
    std::printf("\nsize of the picture, tolerance 0.5 px\n");
    for (const l3d_size size :
         {l3d_size{640, 480}, usual, l3d_size{1920, 1080}, l3d_size{4096, 4096}})
        for (const int teapots : {1, 100}) {
            const cost c = measured(crowd(model, teapots), size, 0.5, 15);
            std::printf("%4dx%-4d %4d teapots: %8.3f ms by one thread, %8.3f by two\n", size.width,
                        size.height, teapots, c.one, c.two);
        }
}

/// The part of a tolerance that snapping takes. A vertex and the centre of a folded quad are each
/// off by sqrt(2) / 512 px, counted with the weight 1.25 (docs/NUMERICS.md, sections 9 and 12).
constexpr double snapping = 2 * 1.25 * 1.4142135623730951 / 512;

/// Steps in each direction grow with the chord's budget to the power -1/2, so quads with its power
/// -1, while pixels do not grow: time = a + b quads, fitted by least squares of relative errors.
void print_tolerances(const l3d_patch_model& model) {
    std::printf("\ntolerance, one teapot at %dx%d, by one thread\n", usual.width, usual.height);
    constexpr std::array tolerances{1.0, 0.5, 0.25, 0.1, 0.05, 0.025, 0.01};
    constexpr std::size_t last = tolerances.size() - 1;
    std::array<double, tolerances.size()> ms{}, quads{}, bound{}, budget{};
    double s0 = 0, s1 = 0, s2 = 0, t0 = 0, t1 = 0;
    for (std::size_t i = 0; i <= last; ++i) {
        const cost c = measured(model, usual, tolerances[i], 31);
        ms[i] = c.one;
        bound[i] = c.report.dice.bound_px;
        quads[i] = static_cast<double>(c.report.surface.quads);
        budget[i] = std::max(tolerances[i] - snapping, tolerances[i] / 4);
        const double p = 1 / ms[i], q = quads[i] / ms[i];
        s0 += p * p;
        s1 += p * q;
        s2 += q * q;
        t0 += p;
        t1 += q;
    }
    const double det = s0 * s2 - s1 * s1;
    const double a = (t0 * s2 - t1 * s1) / det, b = (t1 * s0 - t0 * s1) / det;
    std::printf("%9s %9s %9s %9s %9s %9s %9s\n", "tolerance", "budget", "bound", "quads", "theory",
                "ms", "a + b n");
    for (std::size_t i = 0; i <= last; ++i)
        std::printf("%9.3f %9.4f %9.4f %9.0f %9.0f %9.3f %9.3f\n", tolerances[i], budget[i],
                    bound[i], quads[i], quads[2] * budget[2] / budget[i], ms[i], a + b * quads[i]);
    std::printf(
        "n = quads ~ budget^%.2f over all, ^%.2f from 0.25 on (theory: -1), tolerance^%.2f; "
        "ms ~ tolerance^%.2f over all (theory: 0 to -1); a = %.3f ms, b = %.1f ns\n",
        exponent(budget[0], quads[0], budget[last], quads[last]),
        exponent(budget[2], quads[2], budget[last], quads[last]),
        exponent(tolerances[0], quads[0], tolerances[last], quads[last]),
        exponent(tolerances[0], ms[0], tolerances[last], ms[last]), a, 1e6 * b);
}

} // namespace

int main(int count, char** arguments) {
    const bool quick = count > 1 && std::strcmp(arguments[1], "--quick") == 0;
    std::string why;
    const auto model = l3d_patch_model::from_bpt(l3d_teapot_bpt(), "teapot", why);
    if (!model)
        fail(why.c_str());
    print_crowds(*model, quick ? 1000 : 10000);
    print_all_left_out(*model, quick ? 1000 : 10000);
    print_sizes(*model);
    print_tolerances(*model);
    return EXIT_SUCCESS;
}
