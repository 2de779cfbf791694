// SPDX-License-Identifier: MIT
// Serves the plug-in's interface. The kernel works in a process of its own, so its messages to the
// terminal are not seen, and a crash ends that process alone.
#include "geom/files/cad_plugin_p.h"

#include "document.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

constexpr std::size_t chunk = std::size_t{1} << 20; // bytes that are sent at once

/// The longest computing time that the CAD kernel gets for a file's text of `size` bytes, in
/// seconds. A megabyte takes about a second; broken files can make the kernel compute for ever.
rlim_t most_seconds(std::size_t size) {
    constexpr rlim_t at_least = 10, per_megabyte = 30;
    return at_least + per_megabyte * (size >> 20);
}

/// Owns a file descriptor, and closes it at the end.
class open_file {
public:
    explicit open_file(int file) : file_(file) {}
    open_file(const open_file&) = delete;
    open_file& operator=(const open_file&) = delete;
    ~open_file() { close(); }

    int get() const { return file_; }
    void close() {
        if (file_ >= 0)
            ::close(file_);
        file_ = -1;
    }

private:
    int file_;
};

/// Memory that parent and child process use together. It holds the share of the work that is done,
/// and a text about a fault.
class shared_state {
public:
    shared_state()
        : at_(mmap(nullptr, sizeof(state), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1,
                   0)) {
        if (is_there())
            new (at_) state;
    }
    shared_state(const shared_state&) = delete;
    shared_state& operator=(const shared_state&) = delete;
    ~shared_state() {
        if (is_there())
            munmap(at_, sizeof(state));
    }

    bool is_there() const { return at_ != MAP_FAILED; }
    std::atomic<double>& share() { return get().share; }
    std::string fault() { return get().fault.data(); }
    void set_fault(std::string_view text) {
        std::snprintf(get().fault.data(), get().fault.size(), "%.*s", static_cast<int>(text.size()),
                      text.data());
    }

private:
    struct state {
        std::atomic<double> share = 0;
        std::array<char, 512> fault{};
    };
    static_assert(std::atomic<double>::is_always_lock_free); // a lock would serve only one process
    state& get() { return *static_cast<state*>(at_); }

    void* at_;
};

bool send(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::write(file, bytes.data(), bytes.size());
        if (sent < 0 && errno != EINTR)
            return false;
        bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(sent, 0)));
    }
    return true;
}

/// Prepares the child process: drops the parent's signal handlers, limits computing time to
/// `seconds`, and asks the system to end this process when the parent dies.
void stand_alone(pid_t parent, rlim_t seconds) {
    for (const int one : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE, SIGSEGV, SIGBUS, SIGFPE,
                          SIGILL, SIGABRT, SIGCHLD, SIGALRM, SIGXCPU})
        std::signal(one, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    const rlimit limit{seconds, seconds + 1}; // SIGXCPU comes first
    setrlimit(RLIMIT_CPU, &limit);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
        _exit(1);
    const int nowhere = open("/dev/null", O_RDWR);
    for (const int standard : {0, 1, 2})
        dup2(nowhere, standard);
}

/// The child's work: reads the file's text, and sends records of its faces to the parent. Returns
/// the process's exit status.
int work(std::string_view text, bool is_iges, int records, shared_state& state) {
    l3d_detail::cad_writer to;
    bool is_lost = false;
    const auto send_all = [&] {
        is_lost = is_lost || !send(records, to.bytes);
        to.bytes.clear();
    };
    const auto send_much = [&] {
        if (to.bytes.size() > chunk)
            send_all();
    };
    const std::string fault = cad::write_document(text, is_iges, to, send_much, state.share());
    send_all();
    state.set_fault(fault);
    return fault.empty() && !is_lost ? 0 : 1;
}

int read(const char* text, std::size_t size, int is_iges, void* to,
         void (*take)(void* to, const void* bytes, std::size_t size),
         int (*tell)(void* to, double share), char* why, std::size_t room) {
    const auto fail = [&](const std::string& reason) {
        std::snprintf(why, room, "%s", reason.c_str());
        return 0;
    };
    shared_state state;
    std::array<int, 2> ends{-1, -1};
    if (!state.is_there() || pipe2(ends.data(), O_CLOEXEC) != 0)
        return fail(std::string("no process can be made for Open CASCADE: ") +
                    std::strerror(errno));
    open_file records(ends[0]), sent(ends[1]);
    const auto start = std::chrono::steady_clock::now();
    const pid_t parent = getpid(), child = fork();
    if (child < 0)
        return fail(std::string("no process can be made for Open CASCADE: ") +
                    std::strerror(errno));
    if (child == 0) {
        stand_alone(parent, most_seconds(size));
        int status = 1;
        try {
            status = work({text, size}, is_iges != 0, sent.get(), state);
        } catch (const std::exception& failure) {
            state.set_fault(std::string("Open CASCADE fails: ") + failure.what());
        }
        _exit(status); // the parent's exit handlers do not run twice
    }
    sent.close();
    std::string bytes(chunk, '\0');
    bool goes_on = true;
    for (ssize_t got = 1; got != 0;) {
        constexpr int between_calls = 100; // milliseconds
        pollfd news{records.get(), POLLIN, 0};
        const int has_news = poll(&news, 1, between_calls);
        goes_on = tell(to, state.share()) != 0;
        if (!goes_on)
            kill(child, SIGKILL);
        if (!goes_on || (has_news < 0 && errno != EINTR))
            break;
        if (has_news <= 0)
            continue;
        got = ::read(records.get(), bytes.data(), bytes.size());
        if (got > 0)
            take(to, bytes.data(), static_cast<std::size_t>(got));
        else if (got < 0 && errno != EINTR)
            break;
    }
    int status = 0;
    rusage used{};
    while (wait4(child, &status, 0, &used) < 0 && errno == EINTR)
        continue;
    if (!goes_on)
        return fail("reading was stopped");
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
        l3d_detail::cad_writer effort;
        effort.begin(l3d_detail::cad_record::effort);
        effort.number(
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        constexpr double unit_of_rusage = 1024;
        effort.number(unit_of_rusage * static_cast<double>(used.ru_maxrss));
        take(to, effort.bytes.data(), effort.bytes.size());
        return 1;
    }
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
        return fail("Open CASCADE comes to no end: it computed for " +
                    std::to_string(most_seconds(size)) + " seconds");
    if (WIFSIGNALED(status))
        return fail(std::string("Open CASCADE crashes on it: ") + strsignal(WTERMSIG(status)));
    const std::string fault = state.fault();
    return fail(fault.empty() ? "Open CASCADE ends without a word" : fault);
}

} // namespace

extern "C" {
extern __attribute__((visibility("default"))) const l3d_detail::cad_plugin l3d_cad_plugin;
const l3d_detail::cad_plugin l3d_cad_plugin{
    {l3d_detail::cad_version, sizeof(l3d_detail::cad_plugin)}, read};
}
