// SPDX-License-Identifier: MIT
// terminal_lines: the lines that a user types at a terminal, unless nobody is there.
#ifndef L3D_SYSTEM_TERMINAL_LINES_P_H
#define L3D_SYSTEM_TERMINAL_LINES_P_H

#include <ostream>
#include <streambuf>
#include <string>

namespace l3d_detail {

/// The lines that a user types at a terminal, for a std::istream. A terminal hands over whole lines
/// and hides whether somebody types, so keys are read one by one here. The user can erase them
/// as usual.
///
/// Before the first key, a countdown stands at the end of the question. When the countdown is over,
/// the input ends. The first key ends the countdown for good.
/// Lives:   borrows the terminal and the stream.
class terminal_lines : public std::streambuf {
public:
    /// Expects: a terminal, and a stream that shows what is typed. Units: `seconds` of the
    ///          countdown.
    terminal_lines(int terminal, std::ostream& out, int seconds)
        : terminal_(terminal), out_(out), seconds_(seconds) {}

protected:
    int_type underflow() override;

private:
    struct keys;

    bool read_line();
    bool first_key_comes(keys& typed);

    int terminal_;
    std::ostream& out_;
    int seconds_;
    bool is_somebody_there_ = false;
    std::string line_;
};

} // namespace l3d_detail

#endif
