// SPDX-License-Identifier: MIT
// text_cursor: walks through a model file, token by token or byte by byte, and knows its line.
#ifndef L3D_GEOM_FILES_TEXT_CURSOR_P_H
#define L3D_GEOM_FILES_TEXT_CURSOR_P_H

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace l3d_detail {

/// A token in a form for messages: quoted, of bounded length, and harmless to a terminal. Control
/// characters, bytes that are not UTF-8, quotes and backslashes are shown as \xNN.
std::string quoted(std::string_view token);

/// Appends the shortest form of `value` that is read as the same bits, then `after`.
void append(std::string& text, double value, char after);

/// The base of all readers of model files: takes tokens and numbers from a text, keeps limits, and
/// makes error messages that name the line.
///
/// Every function that returns bool fails with the reason in why(): "name:line: what is wrong".
/// Numbers do not depend on the locale. Tokens stand apart by white space of any kind.
/// Lives:   borrows the text.
/// Cost:    memory for the name, one error and at most most_notes notes.
class text_cursor {
public:
    /// The limit of notes: without it, a text of short odd lines would cost a multiple of its size.
    static constexpr std::size_t most_notes = 20;

    /// A comment begins with the character `comment` and ends with its line; 0 means that there are
    /// no comments. A byte order mark at the beginning is passed over. Lines end as on Unix, as on
    /// DOS, or with carriage returns only.
    text_cursor(std::string_view text, std::string_view name, char comment = '\0');

    /// Sets the error to `what`, with the line of the current token, and returns false.
    bool fail(const std::string& what);
    /// The message of the last error.
    /// Errors:  none: the message is empty if nothing has failed.
    const std::string& why() const { return why_; }

    /// Keeps a remark on a skipped statement, with the line of the current token.
    void note(const std::string& what);
    /// Keeps a remark as note() does, unless a remark with the same text was kept before.
    void note_once(const std::string& what);
    std::vector<std::string> take_notes();

    /// Sets the owner that messages name with values from now on, such as " of vertex 3 of 8".
    /// Lives: `of_what` is kept, not copied.
    void set_place(const char* of_what, std::size_t index, std::size_t count) {
        of_what_ = of_what;
        index_ = index;
        count_ = count;
    }
    void forget_place() { of_what_ = nullptr; }

    /// Takes the next token on this line or a later one; false, without error, at the end.
    bool next();
    /// Takes the next token of this line; false, without error, where the line or the text ends.
    bool next_in_line();
    /// Takes the rest of this line and the line's end; the token is the text before this end.
    /// Returns false, without error, at the end of the text.
    bool next_line();

    /// Takes the rest of this line as a name, without the blanks around it. In a name, no character
    /// begins a comment or joins lines.
    std::string_view name_in_line();

    /// Takes the next token if it is `word` and on this line.
    bool take_in_line(std::string_view word);
    /// Whether nothing but white space and comments is left.
    bool at_end();

    std::string_view token() const { return token_; }
    /// The line of the current token, from 1 on.
    std::size_t line() const { return static_cast<std::size_t>(line_); }
    std::string_view rest() const { return rest_; }

    /// A place in the text. It is kept with a number that is an error only if something depends on
    /// the number.
    struct reading_place {
        std::string_view rest, token;
        std::ptrdiff_t line;
        const char* of_what;
        std::size_t index, count;
    };
    reading_place here() const { return {rest_, token_, line_, of_what_, index_, count_}; }
    /// Goes back to a place, so that a message can name its line. Afterwards, nothing can be taken
    /// from the text.
    void go_back(const reading_place& to);

    /// From here on, a newline after a backslash is white space, but still counts as a line.
    void join_lines_at_backslash() { joins_ = true; }

    /// Takes the next token as a number; `what` names it in messages.
    bool number(double& value, const char* what);
    /// Takes the next token as a number that may be infinite or NaN.
    bool any_number(double& value, const char* what);
    bool integer(std::int64_t& value, const char* what);
    bool integer_in(std::int64_t& value, const char* what, std::int64_t least, std::int64_t most);
    bool coordinate(double& value);
    bool weight(double& value);

    /// Checks a number that was not taken by number(). `digits` is the number's text, if this is
    /// not the current token.
    bool is_finite(double value, const char* what, std::string_view digits = {});
    bool is_coordinate(double value, std::string_view digits = {});
    bool is_weight(double value, const std::string& what);
    bool is_in(std::int64_t value, const char* what, std::int64_t least, std::int64_t most);

    /// Reads `digits`, a part of the current token, as a number.
    bool number_in(std::string_view digits, double& value, const char* what);
    bool any_number_in(std::string_view digits, double& value, const char* what);
    bool integer_in_text(std::string_view digits, std::int64_t& value, const char* what);

    /// Whether the rest of the text can hold `count` things of at least `shortest` bytes each. Call
    /// it before taking memory for these things.
    bool plausible(std::int64_t count, const char* things, std::size_t shortest);

    /// Takes a number of type T from binary data in the byte order `order`.
    template <class T> bool binary(T& value, std::endian order, const char* what) {
        begin_line();
        is_binary_ = true;
        if (rest_.size() < sizeof(T))
            return ends(what);
        char bytes[sizeof(T)];
        for (std::size_t i = 0; i < sizeof(T); ++i)
            bytes[order == std::endian::native ? i : sizeof(T) - 1 - i] = rest_[i];
        std::memcpy(&value, bytes, sizeof(T));
        token_ = rest_.substr(0, sizeof(T));
        rest_.remove_prefix(sizeof(T));
        return true;
    }

    /// Takes a number as Geomview writes it: text, or a float in a binary file. The number may be
    /// infinite or NaN.
    bool any_number_or_float(double& value, bool is_float, const char* what) {
        if (!is_float)
            return any_number(value, what);
        float bits = 0;
        if (!binary(bits, std::endian::big, what))
            return false;
        value = bits;
        return true;
    }

private:
    bool ends(const char* what);
    std::string place() const;
    /// A number's text for a message: the token, or the decoded number in a binary file.
    std::string shown(double value, std::string_view digits) const;
    template <class Number>
    bool parsed(std::string_view digits, Number& value, const char* what, const char* kind);
    void skip_blanks(bool over_lines);
    void begin_line() {
        line_ += ended_line_ ? 1 : 0;
        ended_line_ = false;
    }

    std::string_view text_;
    std::string_view rest_;  ///< text not yet taken
    std::string_view token_; ///< the token taken last
    std::string name_, why_;
    std::vector<std::string> notes_;
    std::size_t unkept_notes_ = 0;
    std::unordered_set<std::string> noted_once_;
    const char* of_what_ = nullptr;
    std::size_t index_ = 0, count_ = 0;
    std::ptrdiff_t line_ = 1;
    char comment_;
    char line_end_ = '\n';
    bool ended_line_ = false; ///< whether the line's end is taken and the next line has not begun
    bool joins_ = false, is_binary_ = false;
};

} // namespace l3d_detail

#endif
