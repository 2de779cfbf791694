// SPDX-License-Identifier: MIT
// in_child: fork, work, and a pipe for the result.
#include "bench/child_process.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>

#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

void stay_on_one_processor() {
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(static_cast<std::size_t>(sched_getcpu()), &one);
    sched_setaffinity(0, sizeof one, &one);
}

[[noreturn]] void be_child(int out, const child_setting& setting,
                           const std::function<std::vector<double>()>& work) {
    for (const auto& [name, value] : setting.environment)
        setenv(name.c_str(), value.c_str(), 1);
    if (setting.one_processor)
        stay_on_one_processor();
    int status = 1;
    try {
        const std::vector<double> result = work();
        std::FILE* const pipe = fdopen(out, "w");
        const std::size_t written = std::fwrite(result.data(), sizeof(double), result.size(), pipe);
        status = std::fclose(pipe) == 0 && written == result.size() ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
    }
    // No destructors: what Mesa has started ends with the process.
    _exit(status);
}

} // namespace

std::vector<double> in_child(const child_setting& setting,
                             const std::function<std::vector<double>()>& work) {
    int ends[2];
    if (pipe(ends) != 0)
        throw std::runtime_error("no pipe");
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0)
        throw std::runtime_error("no child process");
    if (child == 0) {
        close(ends[0]);
        be_child(ends[1], setting, work);
    }
    close(ends[1]);
    std::vector<double> result;
    std::FILE* const pipe = fdopen(ends[0], "r");
    for (double value = 0; std::fread(&value, sizeof value, 1, pipe) == 1;)
        result.push_back(value);
    std::fclose(pipe);
    int status = 0;
    waitpid(child, &status, 0);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw std::runtime_error("a child process failed");
    return result;
}
