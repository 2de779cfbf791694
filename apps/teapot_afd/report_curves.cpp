// SPDX-License-Identifier: MIT
// Makes tables of cubic curves: their rounding errors, limits and steps.
#include "report_curves.h"

#include "curve_measure.h"
#include "report_rows.h"
#include "report_table.h"

#include <vector>

namespace {

/// Numbers from `from` to `to`, each twice as large as the one before.
std::vector<int> doubled(int from, int to) {
    std::vector<int> result;
    for (int n = from; n <= to; n *= 2)
        result.push_back(n);
    return result;
}

// The ranges of control points to which figures in the literature apply, in pixels.
constexpr double chang_range = 1024, rappoport_range = 131072;

std::string growth(int curves, bool quick) {
    std::string text = "numbers,steps,measured_px,theory_px\n";
    for (const growth_row& r : measure_growth(chang_range, doubled(4, quick ? 1024 : 8192), curves))
        text += table_row(name_of(r.numbers), r.steps, r.measured, r.theory);
    for (const chord_row& r : measure_chords(chang_range, doubled(1, 256), curves))
        text += table_row("chord", r.steps, r.measured, r.theory);
    return text;
}

std::string limits(int curves, int tried) {
    std::string text = "numbers,in_1024_px,in_131072_px,tried\n";
    for (const curve_numbers numbers : all_curve_numbers)
        text += table_row(name_of(numbers),
                          most_steps_below_a_pixel(numbers, chang_range, tried, curves),
                          most_steps_below_a_pixel(numbers, rappoport_range, tried, curves), tried);
    return text;
}

std::string steps(int curves) {
    std::string text = "halvings,mean,largest,chebyshev,by_derivative,per_pixel\n";
    for (const step_row& r : measure_steps(chang_range, 5, curves))
        text += table_row(r.halvings, r.per_pixel, r.most, r.chebyshev, r.true_speed, r.extra);
    return text;
}

} // namespace

void write_curve_tables(const std::string& folder, bool quick) {
    const int curves = quick ? 40 : 400;
    write_text(folder + "/curves.csv", growth(curves, quick));
    write_text(folder + "/limits.csv", limits(curves / 4, 1 << (quick ? 11 : 14)));
    write_text(folder + "/steps.csv", steps(curves));
}
