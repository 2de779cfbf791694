// SPDX-License-Identifier: MIT
// curve_measure: walks random cubics in one dimension and in two.
#include "curve_measure.h"

#include <l3d/bezier_patch.h>
#include "geom/block_fixed.h"
#include "geom/forward_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

namespace {

using cubic = std::array<double, 4>;
using plane_curve = l3d_bezier_curve<double, 2>;

/// Random numbers that are the same with every library. The standard specifies mt19937_64, but not
/// distributions.
class number_source {
public:
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    cubic curve(double range) {
        cubic c{};
        for (double& point : c)
            point = between(-range / 2, range / 2);
        return c;
    }
    plane_curve flat_curve(double range) {
        plane_curve result;
        for (auto& point : result.points)
            point = {between(-range / 2, range / 2), between(-range / 2, range / 2)};
        return result;
    }

private:
    std::mt19937_64 engine_{20240611};
};

double value_of(const cubic& b, double t) {
    const double s = 1 - t;
    return ((b[0] * s + 3 * b[1] * t) * s + 3 * b[2] * t * t) * s + b[3] * t * t * t;
}

double bend_of(const cubic& b) {
    return 6 * std::max(std::abs(b[2] - 2 * b[1] + b[0]), std::abs(b[3] - 2 * b[2] + b[1]));
}

/// The largest error of a walk by sums of integers. Register k counts in units of 2^-bits[k]. Sums
/// are rounded to nearest.
double graded_error(const cubic& b, int steps, const std::array<int, 4>& bits) {
    const auto exact = l3d_forward_difference<double, 3>::build(b, steps).d;
    std::array<std::int64_t, 4> d{};
    for (std::size_t k = 0; k < 4; ++k)
        d[k] = std::llrint(std::ldexp(exact[k], bits[k]));
    double worst = 0;
    for (int i = 0; i <= steps; ++i) {
        const double off =
            std::ldexp(static_cast<double>(d[0]), -bits[0]) - value_of(b, double(i) / steps);
        worst = std::max(worst, std::abs(off));
        for (std::size_t k = 0; k < 3; ++k) {
            const int shift = bits[k + 1] - bits[k];
            d[k] += shift == 0 ? d[k + 1] : (d[k + 1] + (std::int64_t{1} << (shift - 1))) >> shift;
        }
    }
    return worst;
}

/// The number of fraction bits with which values up to `largest` fit 32 bits: with their sign, and
/// one bit to spare.
int bits_for(double largest) {
    return 30 - (std::ilogb(std::max(largest, 1e-300)) + 1);
}

/// Fraction bits of the registers for all curves of a range: D1 <= 3 range / n and so on. They are
/// the same for each curve, as in hardware.
std::array<int, 4> graded_bits(double range, int steps) {
    const double n = steps;
    const double d3 = 6 * 8 * (range / 2) / (n * n * n), d2 = 6 * 4 * (range / 2) / (n * n) + d3;
    const double d1 = 3 * range / n + 2 * d2;
    std::array<int, 4> bits{bits_for(range / 2), bits_for(d1), bits_for(d2), bits_for(d3)};
    for (std::size_t k = 1; k < 4; ++k)
        bits[k] = std::clamp(bits[k], bits[k - 1], bits[k - 1] + 31);
    return bits;
}

template <class T> double walk_error(const cubic& b, int steps) {
    auto walk = l3d_forward_difference<T, 3>::build(b, steps);
    double worst = 0;
    for (int i = 0; i <= steps; ++i, walk.step())
        worst = std::max(
            worst, std::abs(static_cast<double>(walk.value()) - value_of(b, double(i) / steps)));
    return worst;
}

double error_of(curve_numbers numbers, const cubic& b, int steps, double range) {
    switch (numbers) {
    case curve_numbers::float_32:
        return walk_error<float>(b, steps);
    case curve_numbers::float_64:
        return walk_error<double>(b, steps);
    case curve_numbers::fixed_16_16:
        return graded_error(b, steps, {16, 16, 16, 16});
    case curve_numbers::block_32: {
        const int bits = l3d_block_fraction_bits(range / 2);
        return graded_error(b, steps, {bits, bits, bits, bits});
    }
    case curve_numbers::graded_32:
        return graded_error(b, steps, graded_bits(range, steps));
    case curve_numbers::fixed_32_32:
        return graded_error(b, steps, {32, 32, 32, 32});
    }
    return 0;
}

/// The bound of a walk's error: half units of the registers' last bits, times binomials. With
/// rounded sums, each register also errs by half a unit of its own in every sum.
double theory_of(curve_numbers numbers, int steps, double range) {
    const double n = steps, pairs = n * (n - 1) / 2, triples = pairs * (n - 2) / 3;
    switch (numbers) {
    case curve_numbers::float_32:
        return l3d_forward_difference_error<float>(steps, range / 2, range, 2 * range, 4 * range);
    case curve_numbers::float_64:
        return l3d_forward_difference_error<double>(steps, range / 2, range, 2 * range, 4 * range);
    case curve_numbers::fixed_16_16:
        return l3d_block_walk_error(16, steps);
    case curve_numbers::block_32:
        return l3d_block_walk_error(l3d_block_fraction_bits(range / 2), steps);
    case curve_numbers::graded_32: {
        const auto bits = graded_bits(range, steps);
        return std::ldexp(1 + n, -bits[0] - 1) + std::ldexp(n + pairs, -bits[1] - 1) +
               std::ldexp(pairs + triples, -bits[2] - 1) + std::ldexp(triples, -bits[3] - 1);
    }
    case curve_numbers::fixed_32_32:
        return l3d_block_walk_error(32, steps);
    }
    return 0;
}

/// The number of steps that keeps a curve's points within a pixel of each other. Its derivative is
/// three times a mean of the control points' differences.
int steps_of(const plane_curve& c) {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
        for (int k = 0; k < 2; ++k)
            longest = std::max(longest, std::abs(c.points[i + 1][k] - c.points[i][k]));
    return std::max(1, static_cast<int>(std::ceil(3 * longest)));
}

int steps_of(const plane_curve& c, int halvings) {
    if (halvings == 0)
        return steps_of(c);
    const auto [low, high] = c.split();
    return steps_of(low, halvings - 1) + steps_of(high, halvings - 1);
}

/// The largest derivative of a coordinate: that of a cubic is a quadratic, largest at an end or
/// where its own derivative is 0.
double speed_of(const plane_curve& c) {
    double fastest = 0;
    for (int k = 0; k < 2; ++k) {
        const auto d = c.derivative();
        const double a = d[0][k], b = d[1][k], e = d[2][k];
        const double t = a - 2 * b + e != 0 ? (a - b) / (a - 2 * b + e) : 0;
        fastest = std::max({fastest, std::abs(a), std::abs(e)});
        if (t > 0 && t < 1)
            fastest = std::max(fastest, std::abs(a * (1 - t) + b * t));
    }
    return fastest;
}

/// The number of steps of all pieces of a halved curve, by their largest derivatives.
double true_steps_of(const plane_curve& c, int halvings) {
    if (halvings == 0)
        return std::ceil(speed_of(c));
    const auto [low, high] = c.split();
    return true_steps_of(low, halvings - 1) + true_steps_of(high, halvings - 1);
}

/// The larger side of a curve's box, and the number of pixels that it passes through, at least.
struct extent {
    double box, pixels;
};

extent extent_of(const plane_curve& c) {
    constexpr int points = 2048;
    auto least = c.points[0], most = least, before = least;
    double pixels = 0;
    for (int i = 1; i <= points; ++i) {
        const auto p = c.evaluate(double(i) / points);
        pixels += std::max(std::abs(p[0] - before[0]), std::abs(p[1] - before[1]));
        before = p;
        for (int k = 0; k < 2; ++k) {
            least[k] = std::min(least[k], p[k]);
            most[k] = std::max(most[k], p[k]);
        }
    }
    return {std::max(most[0] - least[0], most[1] - least[1]), pixels};
}

} // namespace

const char* name_of(curve_numbers numbers) {
    constexpr std::array names{"float",        "double",        "16.16",
                               "32-bit block", "32-bit graded", "32.32"};
    return names.at(static_cast<std::size_t>(numbers));
}

std::vector<growth_row> measure_growth(double range, const std::vector<int>& steps, int curves) {
    std::vector<growth_row> rows;
    for (const curve_numbers numbers : all_curve_numbers)
        for (const int n : steps) {
            number_source random;
            growth_row row{numbers, n, 0, theory_of(numbers, n, range)};
            for (int i = 0; i < curves; ++i)
                row.measured =
                    std::max(row.measured, error_of(numbers, random.curve(range), n, range));
            rows.push_back(row);
        }
    return rows;
}

int most_steps_below_a_pixel(curve_numbers numbers, double range, int limit, int curves) {
    int most = 0;
    for (int n = 1; n <= limit; n *= 2) {
        number_source random;
        double worst = 0;
        for (int i = 0; i < curves; ++i)
            worst = std::max(worst, error_of(numbers, random.curve(range), n, range));
        if (!(worst < 1))
            break;
        most = n;
    }
    return most;
}

std::vector<chord_row> measure_chords(double range, const std::vector<int>& steps, int curves) {
    std::vector<chord_row> rows;
    for (const int n : steps) {
        number_source random;
        chord_row row{n, 0, 0};
        for (int i = 0; i < curves; ++i) {
            const cubic b = random.curve(range);
            for (int k = 0; k < n; ++k) {
                const double from = double(k) / n, to = double(k + 1) / n;
                const double chord = (value_of(b, from) + value_of(b, to)) / 2;
                row.measured =
                    std::max(row.measured, std::abs(value_of(b, (from + to) / 2) - chord));
            }
            row.theory = std::max(row.theory, bend_of(b) / (8.0 * n * n));
        }
        rows.push_back(row);
    }
    return rows;
}

/// Measures Chebyshev's cubic beside random ones. It rises fastest at its end among all cubics
/// within bounds (Markov).
std::vector<step_row> measure_steps(double range, int most_halvings, int curves) {
    const double r = range / 2;
    const plane_curve chebyshev{{{{-r, -r}, {5 * r, 5 * r}, {-5 * r, -5 * r}, {r, r}}}};
    std::vector<step_row> rows;
    for (int halvings = 0; halvings <= most_halvings; ++halvings) {
        number_source random;
        step_row row{halvings, 0, 0, 0, 0, 0};
        for (int i = 0; i < curves; ++i) {
            const plane_curve c = random.flat_curve(range);
            const extent size = extent_of(c);
            const double steps = steps_of(c, halvings);
            row.per_pixel += steps / size.box / curves;
            row.most = std::max(row.most, steps / size.box);
            row.extra += steps / size.pixels / curves;
        }
        row.chebyshev = steps_of(chebyshev, halvings) / extent_of(chebyshev).box;
        row.true_speed = true_steps_of(chebyshev, halvings) / extent_of(chebyshev).box;
        rows.push_back(row);
    }
    return rows;
}
