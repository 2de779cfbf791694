// SPDX-License-Identifier: MIT
// terminal_lines: the lines that a user types at a terminal, unless nobody is there.
#ifndef L3D_SYSTEM_TERMINAL_LINES_P_H
#define L3D_SYSTEM_TERMINAL_LINES_P_H

#include <ostream>
#include <streambuf>
#include <string>

namespace l3d_detail {

/// The lines that a user types at a terminal, for a std::istream, with a countdown in case nobody
/// is there. By default a terminal hands over whole lines, and hides whether somebody types. So
/// this class reads keys one by one. The user can erase typed keys as usual.
///
/// Until the first key, a countdown stands at the end of the program's question. When the countdown
/// is over, the input ends. The first key stops the countdown for good.
/// Lives:   borrows the terminal and the stream.
class terminal_lines : public std::streambuf {
public:
    /// Reads from this terminal, and shows the typed keys on `out`. `seconds` is the length of the
    /// countdown.
    /// Expects: a terminal's file descriptor, and a stream to the same terminal.
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
