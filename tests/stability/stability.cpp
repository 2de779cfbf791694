// SPDX-License-Identifier: MIT
// stability: patches that are meant to break the library, and whether its bounds hold.
#include "table.h"

#include "geom/real.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>
#include <thread>

namespace {

using namespace stability;

/// A part of everything for each `make test`: seconds, the sanitizers' as well.
const extent sample{14, 300, 6, 2, 24, 50, 1, "", ""};
const extent everything{1, 300'000, 2000, 2000, 10'000, 2000, 1, "", ""};

[[noreturn]] void refuse(const std::string& what) {
    std::fprintf(stderr,
                 "stability: %s\n"
                 "usage: stability [--sample] [--random N] [--curved N] [--parallel N] [--ordinary "
                 "N] [--threads N] "
                 "[--folder FOLDER] [--only TEXT]\n",
                 what.c_str());
    std::exit(2);
}

/// Errors: exits with the option and the value at fault.
std::uint64_t count_of(const std::string& option, const std::string& text) {
    char* end = nullptr;
    const unsigned long long value = std::strtoull(text.c_str(), &end, 10);
    if (text.empty() || text[0] < '0' || text[0] > '9' || *end != 0)
        refuse(option + ": '" + text + "' is not a number");
    return value;
}

} // namespace

int main(int argc, char** argv) try {
    extent how_much = everything;
    how_much.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    std::string folder;
    for (int i = 1; i < argc; ++i) {
        const std::string option = argv[i];
        if (option == "--sample") {
            how_much = sample;
            continue;
        }
        if (i + 1 == argc)
            refuse(option + ": unknown, or without its value");
        const std::string value = argv[++i];
        if (option == "--random")
            how_much.random = count_of(option, value);
        else if (option == "--curved")
            how_much.curved = count_of(option, value);
        else if (option == "--parallel")
            how_much.parallel = count_of(option, value);
        else if (option == "--ordinary")
            how_much.ordinary = count_of(option, value);
        else if (option == "--threads")
            how_much.threads =
                static_cast<int>(std::clamp<std::uint64_t>(count_of(option, value), 1, 256));
        else if (option == "--only")
            how_much = {1, 0, 0, 0, 0, 0, how_much.threads, value, ""};
        else if (option == "--folder")
            folder = value;
        else
            refuse(option + ": unknown");
    }
    if (!folder.empty())
        how_much.slices = folder + "/stability_" + l3d_real_name();
    const suite_result result = run_suite(how_much);
    if (!how_much.only.empty())
        write_cases(stdout, result);
    write_lines(stdout, result);
    if (!folder.empty())
        write_files(folder, result);
    return result.violation_count == 0 ? 0 : 1;
} catch (const std::exception& e) {
    std::fprintf(stderr, "stability: %s\n", e.what());
    return 1;
}
