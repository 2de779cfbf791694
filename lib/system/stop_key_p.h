// SPDX-License-Identifier: MIT
// stop_key: Escape, pressed in the terminal, stops long work before there is a window.
#ifndef L3D_SYSTEM_STOP_KEY_P_H
#define L3D_SYSTEM_STOP_KEY_P_H

#include "system/signal_watch.h"

#include <array>
#include <string_view>

#include <termios.h>
#include <unistd.h>

namespace l3d_detail {

/// Tells long work, before there is a window, that Escape was pressed in the terminal. While the
/// object lives, the terminal hands over each key at once, without showing it. Signals are noted
/// and act at the object's end (l3d_signal_watch), so that the terminal never stays in this mode.
///
/// The object does nothing if the standard input is no terminal, or if another program is in the
/// terminal's foreground.
/// Expects: no l3d_signal_watch lives meanwhile. Keys other than Escape are lost.
class stop_key {
public:
    stop_key() {
        if (tcgetpgrp(STDIN_FILENO) != getpgrp() || tcgetattr(STDIN_FILENO, &before_) != 0)
            return;
        termios each_key = before_;
        each_key.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
        each_key.c_cc[VMIN] = each_key.c_cc[VTIME] = 0; // reading does not wait
        is_taken_ = tcsetattr(STDIN_FILENO, TCSANOW, &each_key) == 0;
    }
    stop_key(const stop_key&) = delete;
    stop_key& operator=(const stop_key&) = delete;
    ~stop_key() {
        if (is_taken_)
            tcsetattr(STDIN_FILENO, TCSANOW, &before_);
    }

    /// Whether Escape was pressed, or a signal asks for the end. Some other keys send the byte of
    /// Escape first, but send further bytes after it.
    bool is_pressed() {
        std::array<char, 16> keys{};
        const ssize_t got = is_taken_ ? read(STDIN_FILENO, keys.data(), keys.size()) : 0;
        const std::string_view text(keys.data(), got > 0 ? static_cast<std::size_t>(got) : 0);
        return watch_.caught() || text.ends_with('\x1b');
    }

private:
    l3d_signal_watch watch_; ///< ends after the terminal is restored, and then raises the signal
    termios before_{};
    bool is_taken_ = false;
};

} // namespace l3d_detail

#endif
