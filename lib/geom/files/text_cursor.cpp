// SPDX-License-Identifier: MIT
// text_cursor: reads tokens and numbers, checks their limits, and keeps errors and notes.
#include "geom/files/text_cursor_p.h"

#include "base/printable_p.h"
#include "geom/files/patch_file.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace l3d_detail {

namespace {

/// White space. The last character, SUB, ends the text files of DOS.
constexpr std::string_view blanks = " \t\r\n\v\f\x1a";

/// A mark of numbers that are not finite: Microsoft's older compilers write 1.#IND, 1.#QNAN,
/// 1.#INF.
constexpr std::string_view microsofts_odd = "1.#";

} // namespace

std::string quoted(std::string_view token) {
    constexpr std::size_t longest = 24;
    constexpr std::string_view digits = "0123456789abcdef";
    std::string result = "'";
    std::size_t at = 0;
    while (at < token.size() && at < longest) {
        const std::string_view rest = token.substr(at);
        const char c = rest.front();
        const std::size_t size = c != '\'' && c != '\\' ? printable_size(rest) : 0;
        if (size > 0) {
            result += rest.substr(0, size);
        } else {
            const auto code = static_cast<unsigned char>(c);
            result.append("\\x").append(1, digits[code / 16]).append(1, digits[code % 16]);
        }
        at += std::max<std::size_t>(size, 1);
    }
    return result + (at < token.size() ? "...'" : "'");
}

void append(std::string& text, double value, char after) {
    char digits[32]; // -1.2345678901234567e-308 has 24 characters
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
    assert(error == std::errc());
    text.append(digits, end).append(1, after);
}

text_cursor::text_cursor(std::string_view text, std::string_view name, char comment)
    : text_(text), rest_(text), name_(printable(name)), comment_(comment) {
    constexpr std::string_view mark = "\xEF\xBB\xBF"; // U+FEFF in UTF-8
    if (rest_.starts_with(mark))
        rest_.remove_prefix(mark.size());
    // In the binary part of a .ply file any byte may follow the header's lines.
    const bool is_ply = rest_.starts_with("ply\r") && !rest_.substr(4).starts_with('\n');
    // A carriage return at the very end is half of a line's end on DOS.
    const std::size_t first = rest_.find('\r');
    if (first < rest_.size() - 1 && (is_ply || rest_.find('\n') == rest_.npos))
        line_end_ = '\r';
}

bool text_cursor::fail(const std::string& what) {
    const std::string byte = " (byte " + std::to_string(text_.size() - rest_.size()) + ")";
    why_ = name_ + ":" + std::to_string(line_) + ": " + what + (is_binary_ ? byte : "");
    return false;
}

void text_cursor::note(const std::string& what) {
    if (notes_.size() < most_notes)
        notes_.push_back(name_ + ":" + std::to_string(line_) + ": " + what);
    else
        ++unkept_notes_;
}

void text_cursor::note_once(const std::string& what) {
    if (noted_once_.size() < most_notes && noted_once_.insert(what).second)
        note(what);
}

std::vector<std::string> text_cursor::take_notes() {
    if (unkept_notes_ > 0)
        notes_.push_back(name_ + ": " + std::to_string(unkept_notes_) + " more of such notes");
    return std::move(notes_);
}

std::string text_cursor::place() const {
    return of_what_ ? of_what_ + (' ' + std::to_string(index_)) + " of " + std::to_string(count_)
                    : "";
}

std::string text_cursor::shown(double value, std::string_view digits) const {
    if (!is_binary_)
        return quoted(digits.empty() ? token_ : digits);
    std::string text;
    append(text, value, '\0');
    text.pop_back();
    return quoted(text);
}

bool text_cursor::ends(const char* what) {
    line_ += is_binary_ ? 0 : std::count(rest_.begin(), rest_.end(), line_end_);
    rest_ = {};
    return fail("the text ends where " + std::string(what) + place() + " should be");
}

void text_cursor::skip_blanks(bool over_lines) {
    begin_line();
    while (!rest_.empty()) {
        const char c = rest_.front();
        if (c == line_end_) {
            if (!over_lines)
                return;
            ++line_;
        } else if (c == comment_ && comment_ != '\0') {
            rest_.remove_prefix(std::min(rest_.find(line_end_), rest_.size()));
            continue;
        } else if (c == '\\' && joins_) {
            const bool carriage = line_end_ == '\n' && rest_.substr(1, 1) == "\r";
            if (!rest_.substr(carriage ? 2 : 1).starts_with(line_end_))
                return;
            ++line_;
            rest_.remove_prefix(carriage ? 2 : 1);
        } else if (blanks.find(c) == blanks.npos) {
            return;
        }
        rest_.remove_prefix(1);
    }
}

bool text_cursor::next_in_line() {
    skip_blanks(false);
    if (rest_.empty() || rest_.front() == line_end_)
        return false;
    // A backslash that joins lines ends a token; another one is part of a token.
    const auto begins_comment = [this](std::size_t at) {
        return rest_[at] == comment_ && comment_ != '\0' &&
               !rest_.substr(0, at + 1).ends_with(microsofts_odd);
    };
    std::size_t size = 1;
    while (size < rest_.size() && blanks.find(rest_[size]) == blanks.npos &&
           !begins_comment(size) && !(rest_[size] == '\\' && joins_))
        ++size;
    token_ = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return true;
}

std::string_view text_cursor::name_in_line() {
    begin_line();
    token_ = rest_.substr(0, rest_.find(line_end_));
    rest_.remove_prefix(token_.size());
    token_.remove_prefix(std::min(token_.find_first_not_of(blanks), token_.size()));
    token_ = token_.substr(0, token_.find_last_not_of(blanks) + 1);
    return token_;
}

bool text_cursor::next() {
    skip_blanks(true);
    return next_in_line();
}

bool text_cursor::take_in_line(std::string_view word) {
    skip_blanks(false);
    const std::string_view rest = rest_;
    const std::string_view token = token_;
    if (next_in_line() && token_ == word)
        return true;
    rest_ = rest;
    token_ = token;
    return false;
}

bool text_cursor::at_end() {
    skip_blanks(true);
    return rest_.empty();
}

void text_cursor::go_back(const reading_place& to) {
    rest_ = to.rest;
    token_ = to.token;
    line_ = to.line;
    set_place(to.of_what, to.index, to.count);
}

bool text_cursor::next_line() {
    begin_line();
    if (rest_.empty())
        return false;
    const std::size_t size = rest_.find(line_end_);
    token_ = rest_.substr(0, size);
    rest_.remove_prefix(token_.size() + (size == rest_.npos ? 0 : 1));
    ended_line_ = size != rest_.npos;
    return true;
}

template <class Number>
bool text_cursor::parsed(std::string_view digits, Number& value, const char* what,
                         const char* kind) {
    // from_chars takes no plus sign, which printf("%+g") writes.
    const bool plus = digits.size() > 1 && digits[0] == '+' && digits[1] != '-';
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data() + (plus ? 1 : 0), end, value);
    const bool is_out = error == std::errc::result_out_of_range && stop == end;
    if (is_out && (digits.find("e-") != digits.npos || digits.find("E-") != digits.npos)) {
        value = 0; // the number is nearer to 0 than any double
        return true;
    }
    if (is_out)
        return fail(quoted(digits) + ", " + what + place() + ", is out of range");
    if (error != std::errc() || stop != end)
        return fail(quoted(digits) + ", " + what + place() + ", is not " + kind);
    return true;
}

bool text_cursor::number_in(std::string_view digits, double& value, const char* what) {
    return any_number_in(digits, value, what) && is_finite(value, what, digits);
}

bool text_cursor::any_number_in(std::string_view digits, double& value, const char* what) {
    if (const std::size_t sharp = digits.find(microsofts_odd); sharp != digits.npos) {
        value = digits.substr(sharp).starts_with("1.#INF") ? std::numeric_limits<double>::infinity()
                                                           : std::nan("");
        return true;
    }
    return parsed(digits, value, what, "a number");
}

bool text_cursor::integer_in_text(std::string_view digits, std::int64_t& value, const char* what) {
    return parsed(digits, value, what, "a whole number");
}

bool text_cursor::number(double& value, const char* what) {
    return next() ? number_in(token_, value, what) : ends(what);
}

bool text_cursor::any_number(double& value, const char* what) {
    return next() ? any_number_in(token_, value, what) : ends(what);
}

bool text_cursor::integer(std::int64_t& value, const char* what) {
    return next() ? integer_in_text(token_, value, what) : ends(what);
}

bool text_cursor::integer_in(std::int64_t& value, const char* what, std::int64_t least,
                             std::int64_t most) {
    return integer(value, what) && is_in(value, what, least, most);
}

bool text_cursor::coordinate(double& value) {
    return number(value, "a coordinate") && is_coordinate(value);
}

bool text_cursor::weight(double& value) {
    return number(value, "a weight") &&
           is_weight(value, quoted(token_) + ", a weight" + place() + ",");
}

bool text_cursor::is_finite(double value, const char* what, std::string_view digits) {
    return std::isfinite(value) ||
           fail(shown(value, digits) + ", " + what + place() + ", is not finite");
}

bool text_cursor::is_coordinate(double value, std::string_view digits) {
    if (!is_finite(value, "a coordinate", digits))
        return false;
    return std::abs(value) <= l3d_bpt_largest_coordinate ||
           fail(shown(value, digits) + ", a coordinate" + place() + ", is beyond 1e12");
}

bool text_cursor::is_weight(double value, const std::string& what) {
    return l3d_is_weight(value) || fail(what + " is not from 1e-100 to 1e12");
}

bool text_cursor::is_in(std::int64_t value, const char* what, std::int64_t least,
                        std::int64_t most) {
    return (value >= least && value <= most) ||
           fail("'" + std::to_string(value) + "', " + what + place() + ", is not in " +
                std::to_string(least) + " to " + std::to_string(most));
}

bool text_cursor::plausible(std::int64_t count, const char* things, std::size_t shortest) {
    if (count < 0)
        return fail("the number of " + std::string(things) + " is " + std::to_string(count) +
                    ", negative");
    return static_cast<std::uint64_t>(count) <= rest_.size() / shortest ||
           fail("the text is too short for " + std::to_string(count) + " " + things);
}

} // namespace l3d_detail
