// SPDX-License-Identifier: MIT
// Texts of model files, and what readers say of them.
#ifndef L3D_TESTS_GEOM_MODEL_TEXT_H
#define L3D_TESTS_GEOM_MODEL_TEXT_H

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace model_text {

inline std::string of_file(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    EXPECT_TRUE(file) << path << ": the tests run in the project's folder";
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// A text with another part in place of the first `old`.
inline std::string with(std::string_view text, std::string_view old, std::string_view replacement) {
    std::string result(text);
    const auto at = result.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return result.replace(at, old.size(), replacement);
}

/// The result of a reader for a text that it must take, or else nothing.
template <class Reader> auto read_by(Reader reader, std::string_view text, const char* name) {
    std::string why;
    auto result = reader(text, name, why);
    EXPECT_TRUE(result) << why;
    EXPECT_EQ(why, "");
    return result ? *result : typename decltype(result)::value_type{};
}

/// The error of a reader for a text that it must refuse.
template <class Reader>
std::string complaint_of(Reader reader, std::string_view text, const char* name) {
    std::string why;
    EXPECT_FALSE(reader(text, name, why)) << text.substr(0, 200);
    return why;
}

} // namespace model_text

#endif
