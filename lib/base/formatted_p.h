// SPDX-License-Identifier: MIT
// formatted: a short line of text with numbers in it.
#ifndef L3D_BASE_FORMATTED_P_H
#define L3D_BASE_FORMATTED_P_H

#include <array>
#include <cstdio>
#include <locale.h>
#include <string>

namespace l3d_detail {

/// Sets the locale "C" for this thread while an object of this class lives. So decimal points are
/// points in every host program.
class without_locale {
public:
    without_locale() : before_(uselocale(newlocale(LC_ALL_MASK, "C", locale_t{}))) {}
    without_locale(const without_locale&) = delete;
    without_locale& operator=(const without_locale&) = delete;
    // The locale "C" is the library's own, and is not freed.
    ~without_locale() { uselocale(before_); }

private:
    locale_t before_;
};

/// Formats as std::snprintf does in the locale "C"; texts of more than 159 characters are cut.
template <class... Values> std::string formatted(const char* format, Values... values) {
    const without_locale numbers;
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(), format, values...);
    return text.data();
}

} // namespace l3d_detail

#endif
