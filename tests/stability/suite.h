// SPDX-License-Identifier: MIT
// Running the cases, and what came of them.
#ifndef L3D_TESTS_STABILITY_SUITE_H
#define L3D_TESTS_STABILITY_SUITE_H

#include "curve_cases.h"
#include "judge.h"
#include "stiffness.h"
#include "walks.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace stability {

/// How much is run.
struct extent {
    std::size_t every_named = 1; ///< only each n-th named case
    std::uint64_t random = 0;    ///< random cases, whose points are judged
    std::uint64_t frames = 0;    ///< of those, the first ones have their pictures judged, too
    std::uint64_t curved = 0;    ///< curved ones, whose points are judged
    std::uint64_t parallel = 0;  ///< random cases in parallel projection, with their pictures
    std::uint64_t ordinary = 0;  ///< ordinary patches, for how tight the bound is
    int threads = 1;
    std::string only;   ///< if not empty, only named cases whose "group: name" has this
    std::string slices; ///< if not empty, what the files begin with that random cases are kept in
};

inline constexpr std::size_t arithmetic_count = 4;

/// The largest median of bound / measured of ordinary patches that is allowed.
inline constexpr double most_median_looseness = 4;

/// A case that was among the worst, to find it again.
struct worst_case {
    double ratio = 0; ///< measured / bound
    std::string arithmetic, group, name;
    double measured = 0, bound = 0;
};

/// The results of many cases in one arithmetic.
struct tally {
    std::array<std::int64_t, 5> outcomes{}; ///< by outcome
    std::int64_t points = 0, exactly = 0, pictures = 0;
    double slowest_ms = 0;
    std::int64_t most_samples = 0, most_pieces = 0;
    double worst_ratio = 0;                   ///< of measured / bound
    std::string slowest, most_sampled, worst; ///< the cases

    void add(const test_case& c, const verdict& v);
    void add(const tally& other);
    std::int64_t cases() const;
};

struct named_result {
    std::string group, name;
    double tolerance = 0;
    stiffness how_stiff; ///< ones for malformed cases
    std::array<verdict, arithmetic_count> verdicts;
    verdict as_polygons; ///< the same patch as a mesh, by the pipelines of polygons
};

struct suite_result {
    std::array<std::string, arithmetic_count> arithmetics;
    std::vector<named_result> named;
    std::array<tally, arithmetic_count> named_tally, random_tally, curved_tally, parallel_tally;
    tally polygon_tally; ///< of the named cases as polygons
    std::vector<curve_result> curves;
    std::vector<worst_case> worst;       ///< five, the worst first
    std::vector<std::string> violations; ///< one line each, the first hundred
    std::int64_t violation_count = 0;
    std::array<double, arithmetic_count> median_looseness{}; ///< of bound / measured
    std::uint64_t ordinary = 0;
    std::vector<walk_result> walks;
    double seconds = 0;
};

/// Runs everything, with progress on the standard error.
suite_result run_suite(const extent& how_much);

} // namespace stability

#endif
