// SPDX-License-Identifier: MIT
// The cases that the stability suite draws: named ones, and random ones.
#ifndef L3D_TESTS_STABILITY_CASES_H
#define L3D_TESTS_STABILITY_CASES_H

#include "geom/files/patch_file.h"
#include "reference/exact.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace stability {

/// Units: tolerance in pixels; far along the view axis.
struct test_case {
    std::string group, name;
    std::vector<reference::patch> patches;
    std::vector<l3d_patch_points> curved; ///< in the place of `patches`: rational, or of any degree
    reference::camera eye;
    reference::picture_size size;
    double tolerance = 0.25;
    double far = 1e13;
};

/// Whether nothing can be drawn: a number that is none, a place beyond 1e12, an eye beyond 1e15, a
/// picture without a direction, an angle or a depth, or of impossible size.
bool is_malformed(const test_case& c);

/// Curves and surfaces whose parameters, shapes or weights are out of proportion.
std::vector<test_case> stiff_cases();

/// Surfaces that are folded, collapsed, or thrown far away.
std::vector<test_case> shape_cases();

/// Places, sizes and views at the ends of the range of numbers.
std::vector<test_case> extreme_cases();

/// Cases of which no picture can be made.
std::vector<test_case> malformed_cases();

/// All of them.
std::vector<test_case> named_cases();

/// Kinds of random cases: what each begins with, "" after the last.
const char* random_kind(std::size_t kind);

/// One patch, with a view, a picture and a tolerance of its own. Seeds run through the kinds in
/// turn; the same seed gives the same case everywhere.
test_case random_case(std::uint64_t seed);

/// The same kinds of patches, seen in parallel projection.
test_case parallel_case(std::uint64_t seed);

/// Gently curved patches of a few to some hundred pixels, as most are.
test_case ordinary_case(std::uint64_t seed);

} // namespace stability

#endif
