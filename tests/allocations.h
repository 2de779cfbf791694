// SPDX-License-Identifier: MIT
// Counts what a test program allocates. Included by one file of a program.
#ifndef L3D_TESTS_ALLOCATIONS_H
#define L3D_TESTS_ALLOCATIONS_H

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> allocations{0};

} // namespace

// Not inlined, or the compiler sees free() called on what new returned.
[[gnu::noinline]] void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size > 0 ? size : 1))
        return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

#endif
