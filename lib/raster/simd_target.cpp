// SPDX-License-Identifier: MIT
// Highway's run-time dispatch, by name.
#include "raster/simd_target.h"

#include <hwy/highway.h>
#include <hwy/targets.h>

#include <bit>
#include <cstdint>

namespace {

/// Better instruction sets have lower bits.
std::int64_t best_of(std::int64_t targets) {
    return targets & -targets;
}

std::int64_t usable() {
    return hwy::SupportedTargets() & HWY_TARGETS;
}

/// What could be used, also while one is forced.
std::int64_t available() {
    const std::int64_t now = usable();
    hwy::SetSupportedTargetsForTest(0);
    const std::int64_t all = usable();
    hwy::SetSupportedTargetsForTest(now);
    return all;
}

} // namespace

std::vector<std::string> l3d_simd_targets() {
    std::vector<std::string> names;
    for (std::int64_t left = available(); left != 0; left &= left - 1)
        names.emplace_back(hwy::TargetName(best_of(left)));
    return names;
}

std::string l3d_simd_target() {
    return hwy::TargetName(best_of(usable()));
}

bool l3d_set_simd_target(std::string_view name) {
    const std::int64_t all = available();
    std::int64_t wanted = name.empty() ? all : 0;
    for (std::int64_t left = all; left != 0; left &= left - 1)
        if (hwy::TargetName(best_of(left)) == name)
            wanted = best_of(left);
    if (wanted == 0)
        return false;
    hwy::SetSupportedTargetsForTest(wanted);
    hwy::GetChosenTarget().Update(wanted);
    return true;
}
