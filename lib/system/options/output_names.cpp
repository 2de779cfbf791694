// SPDX-License-Identifier: MIT
// output_names: checks the endings, folders and links of output files.
#include "system/options/output_names_p.h"

#include "base/error.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace fs = std::filesystem;

std::string l3d_detail::ending_of(const std::string& name) {
    std::string ending = fs::path(name).extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

fs::path l3d_detail::place_of(const std::string& name) {
    constexpr int most_links = 40; // as many as Linux follows
    std::error_code unknown;
    fs::path path = fs::absolute(name, unknown);
    for (int i = 0; i < most_links && fs::is_symlink(path, unknown); ++i)
        path = path.parent_path() / fs::read_symlink(path, unknown);
    return fs::weakly_canonical(path, unknown);
}

bool l3d_detail::mean_one_file(const std::string& a, const std::string& b) {
    if (a.empty() || b.empty() || a == "-" || b == "-")
        return a == "-" && b == "-";
    std::error_code unknown;
    if (fs::exists(a, unknown))
        return fs::is_regular_file(a, unknown) && fs::equivalent(a, b, unknown);
    return place_of(a) == place_of(b);
}

void l3d_detail::check_folder(const std::string& option, const std::string& name,
                              const std::string& file) {
    const fs::path folder = fs::path(file).parent_path();
    std::error_code ignored;
    if (!folder.empty() && !fs::is_directory(folder, ignored))
        throw l3d_error(l3d_exit::failure,
                        option + ": '" + name + "': there is no folder '" + folder.string() + "'");
}

void l3d_detail::check_ending(const std::string& option, const std::string& name,
                              const std::string& ending) {
    std::error_code ignored;
    const bool is_device = fs::exists(name, ignored) && !fs::is_regular_file(name, ignored);
    if (name.empty() || name == "-" || is_device)
        return;
    if (ending_of(name) != ending)
        throw l3d_error(l3d_exit::usage, option + ": '" + name + "' does not end in " + ending +
                                             ", nor is it - for the standard output");
    check_folder(option, name, name);
}
