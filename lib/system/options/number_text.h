// SPDX-License-Identifier: MIT
// Numbers from and to text, the same in every locale.
#ifndef L3D_SYSTEM_OPTIONS_NUMBER_TEXT_H
#define L3D_SYSTEM_OPTIONS_NUMBER_TEXT_H

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>

/// Reads a text that consists of one number, the same in every locale.
/// Errors: returns false for other texts, for NaN and infinity, and for numbers that T cannot hold.
template <class T> bool l3d_read_number(std::string_view text, T& number) {
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc{} || stop != end)
        return false;
    if constexpr (std::is_floating_point_v<T>)
        return std::isfinite(number);
    return true;
}

/// Reads N numbers with `separator` between them. Errors: returns false, as l3d_read_number.
template <class T, std::size_t N>
bool l3d_read_numbers(std::string_view text, char separator, std::array<T, N>& numbers) {
    for (std::size_t i = 0; i + 1 < N; ++i) {
        const std::size_t at = text.find(separator);
        if (at == std::string_view::npos || !l3d_read_number(text.substr(0, at), numbers[i]))
            return false;
        text.remove_prefix(at + 1);
    }
    return l3d_read_number(text, numbers[N - 1]);
}

/// The shortest text from which l3d_read_number reads this number again.
template <class T> std::string l3d_number_text(T number) {
    std::array<char, 32> text{}; // the longest, -2.2250738585072014e-308, has 24
    const auto result = std::to_chars(text.data(), text.data() + text.size(), number);
    return {text.data(), result.ptr};
}

#endif
