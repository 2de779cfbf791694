// SPDX-License-Identifier: MIT
// curve_measure: measures the literature's claims on forward differences of cubics.
#ifndef L3D_APPS_TEAPOT_AFD_CURVE_MEASURE_H
#define L3D_APPS_TEAPOT_AFD_CURVE_MEASURE_H

#include <array>
#include <vector>

/// The number format of the registers with which forward differences are added up.
enum class curve_numbers {
    float_32,
    float_64,
    fixed_16_16,
    block_32,  ///< one exponent for all four registers
    graded_32, ///< each register has as many fraction bits as its size leaves; sums are rounded
    fixed_32_32,
};

const char* name_of(curve_numbers numbers);
inline constexpr std::array all_curve_numbers{
    curve_numbers::fixed_16_16, curve_numbers::block_32, curve_numbers::graded_32,
    curve_numbers::fixed_32_32, curve_numbers::float_32, curve_numbers::float_64};

/// The largest round-off error of forward differences after `steps` steps, over random cubics:
/// measured, and the bound of theory.
struct growth_row {
    curve_numbers numbers;
    int steps = 0;
    double measured = 0, theory = 0; ///< pixels
};

/// Measures round-off errors of all number formats, over `curves` random cubics.
/// Units:   `range`: that of the control points' coordinates, in pixels.
/// Source: theory: docs/NUMERICS.md section 5; graded registers: Chang, Rocchetti, Shantz 1989.
std::vector<growth_row> measure_growth(double range, const std::vector<int>& steps, int curves);

/// The largest power of two, up to `limit`, that is a safe number of steps: the round-off error
/// stays below a pixel. It tries `curves` random cubics whose coordinates have this range.
int most_steps_below_a_pixel(curve_numbers numbers, double range, int limit, int curves);

/// The largest distance in pixels between random cubics and their chords, for a number of steps:
/// measured, and its bound h^2 / 8 max |f''|, where h is the step.
struct chord_row {
    int steps = 0;
    double measured = 0, theory = 0;
};
std::vector<chord_row> measure_chords(double range, const std::vector<int>& steps, int curves);

/// How many steps keep the points of a random cubic at most a pixel apart, after the curve was
/// halved `halvings` times.
struct step_row {
    int halvings = 0;
    double per_pixel = 0;  ///< mean of steps / size of the curve's box
    double most = 0;       ///< largest of steps / size of the curve's box
    double chebyshev = 0;  ///< steps / size for the cubic that is fastest at its ends
    double true_speed = 0; ///< steps / size for the same cubic, from its largest derivative itself
    double extra = 0;      ///< mean of steps / pixels that the curve passes through
};
std::vector<step_row> measure_steps(double range, int most_halvings, int curves);

#endif
