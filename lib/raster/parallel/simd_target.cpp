// SPDX-License-Identifier: MIT
// Chooses vector instructions: the processor's best ones, unless others are asked for.
#include "raster/parallel/simd_target.h"

#include "raster/parallel/simd_dispatch_p.h"

#include <array>
#include <atomic>

namespace {

using l3d_detail::simd_place;

struct target {
    const char* name;
    bool (*is_there)();
};

#if HWY_ARCH_X86
#define L3D_HAS(feature) (__builtin_cpu_supports(feature) != 0)
#else
#define L3D_HAS(feature) false
#endif

/// The names of the targets (instruction sets), and the features of the processor that Highway
/// needs for each. They have the order of L3D_SIMD_TABLE.
constexpr std::array<target, 4> targets{
    {{"AVX3",
      [] {
          return (HWY_TARGETS & HWY_AVX3) != 0 && L3D_HAS("avx512f") && L3D_HAS("avx512bw") &&
                 L3D_HAS("avx512cd") && L3D_HAS("avx512dq") && L3D_HAS("avx512vl");
      }},
     {"AVX2",
      [] {
          return (HWY_TARGETS & HWY_AVX2) != 0 && L3D_HAS("avx2") && L3D_HAS("fma") &&
                 L3D_HAS("bmi") && L3D_HAS("bmi2");
      }},
     {"SSE4", [] { return (HWY_TARGETS & HWY_SSE4) != 0 && L3D_HAS("sse4.2"); }},
     {"BASE", [] { return true; }}}};

#undef L3D_HAS

std::size_t best_place() {
    std::size_t place = 0;
    while (!targets[place].is_there())
        ++place;
    return place;
}

/// The index of the chosen target. The whole process has one index, as the processor's features are
/// the same for all its threads.
std::atomic<std::size_t>& chosen_place() {
    static std::atomic<std::size_t> place = best_place();
    return place;
}

} // namespace

std::size_t l3d_detail::simd_place() {
    return chosen_place().load(std::memory_order_relaxed);
}

std::vector<std::string> l3d_simd_targets() {
    std::vector<std::string> names;
    for (const target& each : targets)
        if (each.is_there())
            names.emplace_back(each.name);
    return names;
}

std::string l3d_simd_target() {
    return targets[simd_place()].name;
}

bool l3d_set_simd_target(std::string_view name) {
    if (name.empty()) {
        chosen_place() = best_place();
        return true;
    }
    for (std::size_t place = 0; place < targets.size(); ++place)
        if (targets[place].name == name && targets[place].is_there()) {
            chosen_place() = place;
            return true;
        }
    return false;
}
