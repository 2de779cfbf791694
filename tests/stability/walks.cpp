// SPDX-License-Identifier: MIT
// Long walks and their bounds.
#include "walks.h"
#include "exact_surface.h"

#include "geom/block_fixed.h"
#include "geom/fixed.h"
#include "geom/forward_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace stability {
namespace {

using control = std::array<double, 4>;

/// The cubic in powers of i / steps, times the least common denominator: what remains is a
/// polynomial of integers i and exact doubles.
class exact_cubic {
public:
    explicit exact_cubic(const control& b)
        : a_{digits(b[0]), 3 * (digits(b[1]) - digits(b[0])),
             3 * (digits(b[2]) - 2 * digits(b[1]) + digits(b[0])),
             digits(b[3]) - 3 * digits(b[2]) + 3 * digits(b[1]) - digits(b[0])} {}

    double off(double drawn, int i, int steps) const {
        const digits t = digits(i) / steps;
        return static_cast<double>(
            abs(((a_[3] * t + a_[2]) * t + a_[1]) * t + a_[0] - digits(drawn)));
    }

private:
    std::array<digits, 4> a_;
};

/// Largest differences of control values: of order 0 to 3.
control magnitudes(control b) {
    control result{};
    for (std::size_t order = 0; order < 4; ++order) {
        for (std::size_t i = 0; i + order < 4; ++i)
            result[order] = std::max(result[order], std::abs(b[i]));
        for (std::size_t i = 0; i + order + 1 < 4; ++i)
            b[i] = b[i + 1] - b[i];
    }
    return result;
}

/// Walks and compares some hundred places, the last ones among them.
template <class T> double walked(const control& b, double scale, int steps) {
    control scaled = b;
    for (double& value : scaled)
        value *= scale;
    auto walker = l3d_forward_difference<T, 3>::build(scaled, steps);
    const exact_cubic exact(b);
    const int every = std::max(1, steps / 300);
    double worst = 0;
    for (int i = 0;; ++i) {
        if (i % every == 0 || i + 4 > steps)
            worst = std::max(worst, exact.off(l3d_to_double(walker.value()) / scale, i, steps));
        if (i == steps)
            return worst;
        walker.step();
    }
}

template <class T>
void add(std::vector<walk_result>& to, const char* arithmetic, const char* curve, const control& b,
         int steps) {
    const control size = magnitudes(b);
    to.push_back({arithmetic, curve, steps,
                  l3d_forward_difference_error<T>(steps, size[0], size[1], size[2], size[3]),
                  walked<T>(b, 1, steps)});
}

/// One exponent for the curve, as patches have one for each coordinate.
void add_block(std::vector<walk_result>& to, const char* curve, const control& b, int steps) {
    constexpr int own_bits = 16;
    using block = l3d_fixed<std::int32_t, own_bits>;
    const int bits = l3d_block_fraction_bits(magnitudes(b)[0]);
    to.push_back({"block 32", curve, steps, l3d_block_walk_error(bits, steps),
                  walked<block>(b, std::ldexp(1.0, bits - own_bits), steps)});
}

} // namespace

std::vector<walk_result> all_walks() {
    constexpr std::pair<const char*, control> curves[] = {
        {"gentle", {103.3, 411.7, 700.1, 1023.9}},
        {"third difference dwarfs first", {0.3, 1999.7, -1999.1, 0.9}},
        {"speeds differ by 1e9", {0.1, 0.1 + 1e-6, 0.1 + 3e-2, 1000.7}},
        {"constant", {777.7, 777.7, 777.7, 777.7}},
    };
    std::vector<walk_result> result;
    for (const auto& [name, b] : curves)
        for (const int steps : {10, 32, 100, 1000, 10'000, 100'000, 1'000'000}) {
            add<float>(result, "float", name, b, steps);
            add<double>(result, "double", name, b, steps);
            add_block(result, name, b, steps);
            add<l3d_fixed<std::int64_t, 32>>(result, "32.32", name, b, steps);
        }
    return result;
}

} // namespace stability
