// SPDX-License-Identifier: MIT
// Reader and writer of .bpt patch files, and degree elevation.
#include "geom/patch_file.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <system_error>

namespace {

using point = std::array<double, 3>;

std::size_t points_along(int degree) {
    return static_cast<std::size_t>(degree) + 1;
}

/// A token fit for a message: quoted, of bounded length, nothing in it but printable ASCII.
std::string quoted(std::string_view token) {
    constexpr std::size_t longest = 24;
    constexpr std::string_view digits = "0123456789abcdef";
    std::string result = "'";
    for (const char c : token.substr(0, longest)) {
        const auto code = static_cast<unsigned char>(c);
        if (code > ' ' && code < 127 && c != '\'' && c != '\\')
            result += c;
        else
            result.append("\\x").append(1, digits[code / 16]).append(1, digits[code % 16]);
    }
    return result + (token.size() > longest ? "...'" : "'");
}

class bpt_parser {
public:
    bpt_parser(std::string_view text, std::string_view name) : rest_(text), name_(name) {}

    std::optional<std::vector<l3d_patch_points>> patches() {
        std::int64_t count = 0;
        if (!integer(count, "the number of patches") || !plausible(count))
            return std::nullopt;
        std::vector<l3d_patch_points> result(static_cast<std::size_t>(count));
        for (l3d_patch_points& patch : result) {
            place_ = " in patch " + std::to_string(&patch - result.data() + 1) + " of " +
                     std::to_string(count);
            if (!read(patch))
                return std::nullopt;
        }
        if (next()) {
            fail(quoted(token_) + " follows the last of " + std::to_string(count) + " patches");
            return std::nullopt;
        }
        return result;
    }

    const std::string& why() const { return why_; }

private:
    /// Fails, for use as a result. The message names the line of the current token.
    bool fail(const std::string& what) {
        why_ = name_ + ":" + std::to_string(line_) + ": " + what;
        return false;
    }

    /// Takes the next token; false at the end of the text.
    bool next() {
        constexpr std::string_view blanks = " \t\r\n\v\f";
        const std::size_t begin = std::min(rest_.find_first_not_of(blanks), rest_.size());
        if (begin == rest_.size())
            return false;
        line_ +=
            std::count(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(begin), '\n');
        rest_.remove_prefix(begin);
        token_ = rest_.substr(0, rest_.find_first_of(blanks));
        rest_.remove_prefix(token_.size());
        return true;
    }

    /// Takes the next token as a number; `what` names it in messages.
    template <class Number> bool number(Number& value, const char* what, const char* kind) {
        if (!next()) {
            line_ += std::count(rest_.begin(), rest_.end(), '\n');
            return fail("the text ends where " + std::string(what) + place_ + " should be");
        }
        // from_chars takes no plus sign, which printf("%+g") writes.
        const bool plus = token_.size() > 1 && token_[0] == '+' && token_[1] != '-';
        const char* const end = token_.data() + token_.size();
        const auto [stop, error] = std::from_chars(token_.data() + (plus ? 1 : 0), end, value);
        if (error == std::errc::result_out_of_range && stop == end)
            return fail(quoted(token_) + ", " + what + place_ + ", is out of range");
        if (error != std::errc() || stop != end)
            return fail(quoted(token_) + ", " + what + place_ + ", is not " + kind);
        return true;
    }

    bool integer(std::int64_t& value, const char* what) {
        return number(value, what, "a whole number");
    }

    bool plausible(std::int64_t count) {
        if (count <= 0)
            return fail("the number of patches is " + std::to_string(count) + ", not positive");
        // The least patch has 2 degrees and 4 points, 14 numbers of one digit and one blank.
        constexpr std::size_t shortest = std::size_t{2} * (2 + 4 * 3);
        if (static_cast<std::uint64_t>(count) > rest_.size() / shortest)
            return fail("the text is too short for " + std::to_string(count) + " patches");
        return true;
    }

    bool degree(int& value, const char* what) {
        std::int64_t wide = 0;
        if (!integer(wide, what))
            return false;
        if (wide < 1 || wide > l3d_bpt_largest_degree)
            return fail(quoted(token_) + ", " + what + place_ + ", is not in 1 to " +
                        std::to_string(l3d_bpt_largest_degree));
        value = static_cast<int>(wide);
        return true;
    }

    bool coordinate(double& value) {
        if (!number(value, "a coordinate", "a number"))
            return false;
        if (!std::isfinite(value))
            return fail(quoted(token_) + ", a coordinate" + place_ + ", is not finite");
        if (std::abs(value) > l3d_bpt_largest_coordinate)
            return fail(quoted(token_) + ", a coordinate" + place_ + ", is beyond 1e12");
        return true;
    }

    bool read(l3d_patch_points& patch) {
        if (!degree(patch.degree_u, "the degree in u") ||
            !degree(patch.degree_v, "the degree in v"))
            return false;
        patch.points.resize(points_along(patch.degree_u) * points_along(patch.degree_v));
        for (point& p : patch.points)
            for (double& value : p)
                if (!coordinate(value))
                    return false;
        return true;
    }

    std::string_view rest_;  ///< what has not been taken yet
    std::string_view token_; ///< what has been taken last
    std::string name_, place_, why_;
    std::ptrdiff_t line_ = 1;
};

void append(std::string& text, double value, char after) {
    char digits[32]; // -1.2345678901234567e-308 has 24
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
    assert(error == std::errc());
    text.append(digits, end).append(1, after);
}

/// Raises the degree of the curve in the first degree + 1 places of `line` to 3.
/// Source: Farin, Curves and Surfaces for CAGD: q_i = (i p_{i-1} + (n - i) p_i) / n, n = degree
/// + 1.
void elevate(std::array<point, 4>& line, int degree) {
    for (int n = degree + 1; n <= 3; ++n) {
        const auto last = static_cast<std::size_t>(n);
        line[last] = line[last - 1];
        for (std::size_t i = last - 1; i > 0; --i)
            for (std::size_t k = 0; k < 3; ++k)
                line[i][k] = (static_cast<double>(i) * line[i - 1][k] +
                              static_cast<double>(last - i) * line[i][k]) /
                             n;
    }
}

} // namespace

std::optional<std::vector<l3d_patch_points>> l3d_read_bpt(std::string_view text,
                                                          std::string_view name, std::string& why) {
    bpt_parser parser(text, name);
    auto result = parser.patches();
    if (!result)
        why = parser.why();
    return result;
}

std::string l3d_write_bpt(std::span<const l3d_patch_points> patches) {
    std::string text = std::to_string(patches.size()) + '\n';
    for (const l3d_patch_points& patch : patches) {
        text += std::to_string(patch.degree_u) + ' ' + std::to_string(patch.degree_v) + '\n';
        for (const point& p : patch.points) {
            append(text, p[0], ' ');
            append(text, p[1], ' ');
            append(text, p[2], '\n');
        }
    }
    return text;
}

std::optional<std::array<std::array<double, 3>, 16>>
l3d_elevated_to_bicubic(const l3d_patch_points& patch) {
    const auto cubic_or_less = [](int degree) { return degree >= 1 && degree <= 3; };
    if (!cubic_or_less(patch.degree_u) || !cubic_or_less(patch.degree_v))
        return std::nullopt;
    const std::size_t columns = points_along(patch.degree_u);
    const std::size_t rows = points_along(patch.degree_v);
    if (patch.points.size() != columns * rows)
        return std::nullopt;

    std::array<std::array<point, 4>, 4> grid{}; // grid[column][row]
    for (std::size_t row = 0; row < rows; ++row) {
        std::array<point, 4> line{};
        std::copy_n(patch.points.begin() + static_cast<std::ptrdiff_t>(row * columns), columns,
                    line.begin());
        elevate(line, patch.degree_u);
        for (std::size_t column = 0; column < 4; ++column)
            grid[column][row] = line[column];
    }
    std::array<point, 16> result;
    for (std::size_t column = 0; column < 4; ++column) {
        elevate(grid[column], patch.degree_v);
        for (std::size_t row = 0; row < 4; ++row)
            result[4 * row + column] = grid[column][row];
    }
    return result;
}
