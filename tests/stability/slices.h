// SPDX-License-Identifier: MIT
// Random cases by the hundred thousand, in slices that are kept: the run may be stopped at any
// time.
#ifndef L3D_TESTS_STABILITY_SLICES_H
#define L3D_TESTS_STABILITY_SLICES_H

#include "suite.h"

#include <array>
#include <cstdint>
#include <set>
#include <string>

namespace stability {

/// Seeds of a slice: a few minutes' work at most.
inline constexpr std::uint64_t slice_size = 2000;

/// A file of comma-separated values with a row for each slice and arithmetic.
///
/// Errors: std::runtime_error that names the file.
class slice_file {
public:
    /// Reads what is there. Slices that were made by another `build` are dropped.
    slice_file(std::string file, const std::string& build);

    /// Whether the slice that begins at this seed is there, and free of violations.
    bool has(std::uint64_t first) const { return done_.contains(first); }

    void add(std::uint64_t first, const suite_result& names,
             const std::array<tally, arithmetic_count>& tallies);

private:
    std::string file_;
    std::set<std::uint64_t> done_;
};

} // namespace stability

#endif
