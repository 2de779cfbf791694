// SPDX-License-Identifier: MIT
// terminal_lines: at a terminal whose other side is the test.
#include "system/terminal_lines_p.h"

#include <gtest/gtest.h>

#include <csignal>
#include <istream>
#include <sstream>
#include <string>
#include <thread>

#include <pty.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace {

class terminal_lines : public testing::Test {
protected:
    terminal_lines() { EXPECT_EQ(openpty(&user_, &terminal_, nullptr, nullptr, nullptr), 0); }
    ~terminal_lines() override {
        close(user_);
        close(terminal_);
    }

    void type(const std::string& keys) const {
        EXPECT_EQ(write(user_, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
    }

    /// The same once keys are read one by one: in lines, the terminal itself takes keys back.
    std::thread type_when_asked(const std::string& keys) const {
        return std::thread([this, keys] {
            while (takes_whole_lines() || keys_waiting() > 0)
                std::this_thread::yield();
            type(keys);
        });
    }

    /// A line, with its end in the text; what came before the end of the input, without.
    std::string a_line(int seconds) {
        l3d_detail::terminal_lines typed(terminal_, out_, seconds);
        std::istream in(&typed);
        std::string line;
        std::getline(in, line);
        return in.eof() ? line : line + '\n';
    }

    bool takes_whole_lines() const {
        termios now{};
        tcgetattr(terminal_, &now);
        return (now.c_lflag & ICANON) != 0 && (now.c_lflag & ECHO) != 0;
    }

    int keys_waiting() const {
        int count = 0;
        ioctl(terminal_, FIONREAD, &count);
        return count;
    }

    int user_ = -1, terminal_ = -1;
    std::ostringstream out_;
};

TEST_F(terminal_lines, end_after_a_countdown_without_a_key) {
    EXPECT_EQ(a_line(1), "");
    EXPECT_EQ(out_.str(), "(1 s) \b\b\b\b\b\b      \b\b\b\b\b\b");
    EXPECT_TRUE(takes_whole_lines());
}

TEST_F(terminal_lines, wait_for_the_rest_once_a_key_has_come) {
    type("m");
    std::thread user = type_when_asked("emory\n");
    EXPECT_EQ(a_line(0), "memory\n");
    user.join();
    EXPECT_EQ(out_.str(), "memory\n");
    EXPECT_TRUE(takes_whole_lines());
}

TEST_F(terminal_lines, let_the_user_take_keys_back) {
    std::thread user = type_when_asked("xy\x7f\x7f\x7fq\x15"
                                       "2\x1b\n");
    EXPECT_EQ(a_line(1000), "2\n");
    user.join();
    EXPECT_EQ(out_.str().substr(out_.str().find('x')), "xy\b \b\b \bq\b \b2\n");
}

TEST_F(terminal_lines, end_by_a_key_and_go_on_for_the_next_question) {
    type("no\nme\n");
    l3d_detail::terminal_lines typed(terminal_, out_, 0);
    std::istream in(&typed);
    std::string first, second;
    std::getline(std::getline(in, first), second);
    EXPECT_EQ(first + second, "nome");
    std::thread user = type_when_asked("\x04");
    EXPECT_EQ(in.get(), std::istream::traits_type::eof());
    user.join();
}

TEST_F(terminal_lines, leave_the_terminal_as_it_was_when_a_signal_ends_the_program) {
    const auto interrupted = [&] {
        std::thread user([&] {
            while (takes_whole_lines())
                std::this_thread::yield();
            kill(getpid(), SIGINT);
        });
        a_line(1000);
        user.join();
    };
    EXPECT_EXIT(interrupted(), testing::KilledBySignal(SIGINT), "");
    EXPECT_TRUE(takes_whole_lines());
}

} // namespace
