// SPDX-License-Identifier: MIT
// Stiff and extreme curves in the plane, as paths are made of: their chords against 100 digits.
#ifndef L3D_TESTS_STABILITY_CURVE_CASES_H
#define L3D_TESTS_STABILITY_CURVE_CASES_H

#include <cstdint>
#include <string>
#include <vector>

namespace stability {

/// A curve, and how far its chords are from it. Units: pixels.
struct curve_result {
    std::string group, name;
    double stiffness = 1; ///< as of patches: the largest of speeds, third difference and weights
    std::int64_t chords = 0;
    double bound = 0, measured = 0;

    bool kept() const { return measured <= bound; }
};

/// Speeds that differ, cusps, third differences, weights and places far away: cubics and rational
/// cubics, walked by forward differences in double as l3d_path's are.
std::vector<curve_result> all_curves();

} // namespace stability

#endif
