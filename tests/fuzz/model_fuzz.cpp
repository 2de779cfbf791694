// SPDX-License-Identifier: MIT
// Fuzzes one reader of models, whose name is L3D_FUZZED; libFuzzer and AddressSanitizer call it.
#include "check_model.h"

#include <sanitizer/allocator_interface.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace {

constexpr const named_model_reader& fuzzed = *std::ranges::find_if(
    model_readers, [](const auto& r) { return r.name == std::string_view(L3D_FUZZED); });

// The sanitizer offers its hooks no place for data.
bool is_counting = false;
std::size_t live_bytes = 0, most_bytes = 0;

void count_malloc(const volatile void* memory, std::size_t size) {
    if (!is_counting || !memory)
        return;
    live_bytes += size;
    most_bytes = std::max(most_bytes, live_bytes);
}

void count_free(const volatile void* memory) {
    if (is_counting && memory)
        live_bytes -=
            std::min(live_bytes, __sanitizer_get_allocated_size(const_cast<const void*>(memory)));
}

void fail(const std::string& what) {
    std::fprintf(stderr, "%s: %s\n", fuzzed.name, what.c_str());
    std::abort();
}

/// The bound that model_file.h states, with room for the messages and the smallest arrays.
void check_memory(std::string_view text) {
    constexpr std::size_t room = 16384;
    live_bytes = most_bytes = 0;
    is_counting = true;
    {
        std::string why;
        const auto model = fuzzed.read(text, "name", why);
        is_counting = false;
    }
    if (most_bytes > std::max(fuzzed.always, fuzzed.per_byte * text.size() + room))
        fail(std::to_string(most_bytes) + " bytes of memory for a text of " +
             std::to_string(text.size()));
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    return __sanitizer_install_malloc_and_free_hooks(count_malloc, count_free) > 0 ? 0 : 1;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    check_memory(text);
    const std::string wrong = wrong_with(*fuzzed.read, text, fuzzed.has_plain_names);
    if (!wrong.empty())
        fail(wrong);
    return 0;
}
