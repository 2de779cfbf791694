// SPDX-License-Identifier: MIT
// Whether tests run with AddressSanitizer, which makes them several times slower.
#ifndef L3D_TESTS_SANITIZED_H
#define L3D_TESTS_SANITIZED_H

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

#endif
