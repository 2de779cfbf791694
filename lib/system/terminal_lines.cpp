// SPDX-License-Identifier: MIT
// terminal_lines: reads lines key by key, with a countdown before the first key.
#include "system/terminal_lines_p.h"

#include "system/signal_watch.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace l3d_detail {

/// Makes a terminal hand over each key and show none. The destructor restores the terminal's mode.
/// The mode is restored also after a signal, since the signal watch keeps the signal back and
/// raises it last.
struct terminal_lines::keys {
    explicit keys(int terminal) : terminal_(terminal) {
        tcgetattr(terminal, &before);
        termios each_key = before;
        each_key.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
        each_key.c_cc[VMIN] = 1;
        each_key.c_cc[VTIME] = 0;
        tcsetattr(terminal, TCSANOW, &each_key);
    }
    keys(const keys&) = delete;
    keys& operator=(const keys&) = delete;
    ~keys() { tcsetattr(terminal_, TCSANOW, &before); }

    /// Whether a key, a signal or the end of input comes within this time.
    /// Units: milliseconds; -1 waits without an end.
    bool come_within(int time) const {
        std::array<pollfd, 2> files{pollfd{terminal_, POLLIN, 0},
                                    pollfd{watch_.waker(), POLLIN, 0}};
        return poll(files.data(), files.size(), time) != 0;
    }

    /// The next key; nothing if the input has ended or a signal came.
    std::optional<unsigned char> next() const {
        unsigned char key = 0;
        if (come_within(-1) && !watch_.caught() && read(terminal_, &key, 1) == 1)
            return key;
        return {};
    }

    /// Whether a key has this meaning at the terminal, such as VERASE.
    bool mean(unsigned char key, int meaning) const {
        return key == before.c_cc[meaning] && key != _POSIX_VDISABLE;
    }

private:
    l3d_signal_watch watch_;
    int terminal_;
    termios before{};
};

terminal_lines::int_type terminal_lines::underflow() {
    if (!read_line())
        return traits_type::eof();
    setg(line_.data(), line_.data(), line_.data() + line_.size());
    return traits_type::to_int_type(line_.front());
}

/// Shows the countdown, and returns whether a key comes before its end. The countdown's text is
/// erased afterwards.
bool terminal_lines::first_key_comes(keys& typed) {
    bool has_come = false;
    for (int left = seconds_; left > 0 && !has_come; --left) {
        const std::string told = "(" + std::to_string(left) + " s) ";
        out_ << told << std::flush;
        has_come = typed.come_within(1000);
        for (const char* const step : {"\b", " ", "\b"})
            for (std::size_t i = 0; i < told.size(); ++i)
                out_ << step;
    }
    out_ << std::flush;
    return has_come || typed.come_within(0);
}

/// Reads a whole line, with the line's end, into line_. Returns whether there is such a line.
bool terminal_lines::read_line() {
    line_.clear();
    keys typed(terminal_);
    if (!is_somebody_there_ && !first_key_comes(typed))
        return false;
    is_somebody_there_ = true;
    while (const auto key = typed.next()) {
        if (typed.mean(*key, VEOF))
            return false;
        if (*key == '\n') {
            line_ += '\n';
            out_ << '\n' << std::flush;
            return true;
        }
        const bool takes_one = typed.mean(*key, VERASE);
        if (takes_one || typed.mean(*key, VKILL)) {
            for (std::size_t left = takes_one ? 1 : line_.size(); left > 0 && !line_.empty();
                 --left) {
                line_.pop_back();
                out_ << "\b \b";
            }
        } else if (*key >= ' ' && *key < 0x7f) { // names have only these characters
            line_ += static_cast<char>(*key);
            out_ << static_cast<char>(*key);
        }
        out_ << std::flush;
    }
    return false;
}

} // namespace l3d_detail
