// SPDX-License-Identifier: MIT
// Reports that the thread sanitizer must not make: it does not see all that libX11 does to its own
// locks.

/// Called by the sanitizer if there is one.
extern "C" const char* __tsan_default_suppressions();  // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __tsan_default_suppressions() { // NOLINT(bugprone-reserved-identifier)
    return "mutex:libX11.so\n";
}
