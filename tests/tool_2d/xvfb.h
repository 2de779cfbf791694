// SPDX-License-Identifier: MIT
// xvfb: an X server of a test's own, on a display number that is free.
#ifndef L3D_TEST_TOOL_2D_XVFB_H
#define L3D_TEST_TOOL_2D_XVFB_H

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

/// Starts Xvfb, points DISPLAY at it, and ends it.
class xvfb {
public:
    /// Shape:   screen as Xvfb writes it, "WIDTHxHEIGHTxDEPTH".
    explicit xvfb(const std::string& screen, std::vector<std::string> more = {}) {
        std::array<int, 2> ends{};
        if (pipe(ends.data()) != 0)
            return;
        std::vector<std::string> words{"Xvfb", "-screen",    "0",
                                       screen, "-noreset",   "-nolisten",
                                       "tcp",  "-displayfd", std::to_string(ends[1])};
        words.insert(words.end(), more.begin(), more.end());
        process_ = fork();
        if (process_ == 0) {
            close(ends[0]);
            run(words);
        }
        close(ends[1]);
        read_number(ends[0]);
        close(ends[0]);
        if (started())
            setenv("DISPLAY", display().c_str(), 1);
    }
    xvfb(const xvfb&) = delete;
    xvfb& operator=(const xvfb&) = delete;
    ~xvfb() {
        unsetenv("DISPLAY");
        end(SIGTERM);
    }

    bool started() const { return !number_.empty(); }
    std::string display() const { return ":" + number_; }

    pid_t process() const { return process_; }

    void pause() const { kill(process_, SIGSTOP); }
    void resume() const { kill(process_, SIGCONT); }
    void end(int signal) {
        if (process_ > 0) {
            kill(process_, signal);
            waitpid(process_, nullptr, 0);
        }
        process_ = 0;
    }

private:
    [[noreturn]] static void run(std::vector<std::string>& words) {
        std::vector<char*> arguments;
        arguments.reserve(words.size() + 1);
        for (auto& word : words)
            arguments.push_back(word.data());
        arguments.push_back(nullptr);
        // Not to outlive a test that crashes.
        prctl(PR_SET_PDEATHSIG, SIGTERM);
        // It reports every display number that is taken on its way to a free one.
        if (std::freopen("/dev/null", "w", stderr) != nullptr)
            execvp("Xvfb", arguments.data());
        _exit(127);
    }

    void read_number(int from) {
        char letter = 0;
        while (read(from, &letter, 1) == 1 && letter != '\n')
            number_ += letter;
    }

    pid_t process_ = 0;
    std::string number_; ///< empty if Xvfb is not installed or did not start
};

#endif
