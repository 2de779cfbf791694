// SPDX-License-Identifier: MIT
// How much a run of the tests judges.
#ifndef L3D_TESTS_EFFORT_H
#define L3D_TESTS_EFFORT_H

#include <cstdlib>

/// Whether tests run with AddressSanitizer, which makes them several times slower.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif
#else
inline constexpr bool sanitized = false;
#endif

/// Whether a run judges many cases of each kind in place of a few: WITH=thorough.
inline const bool thorough = !sanitized && std::getenv("L3D_THOROUGH") != nullptr;

#endif
