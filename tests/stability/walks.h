// SPDX-License-Identifier: MIT
// Forward differences alone: a curve walked in up to a million steps.
#ifndef L3D_TESTS_STABILITY_WALKS_H
#define L3D_TESTS_STABILITY_WALKS_H

#include <string>
#include <vector>

namespace stability {

/// A walk's largest error, and what the library says it is at most. Units: of the curve's values.
struct walk_result {
    std::string arithmetic, curve;
    int steps = 0;
    double bound = 0, measured = 0;

    bool kept() const { return measured <= bound; }
};

/// Curves with control values up to 2000, in 10 to a million steps without a restart, in every
/// number type, against 100 digits.
std::vector<walk_result> all_walks();

} // namespace stability

#endif
