#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How long it takes from the command to the first frame in a window, on a local display.

The program ends after that frame, and the time counts to its end, so it is a little too much."""

import os
import statistics
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "x11"))

from harness import BIN, environment, x_server

RUNS = 41


def run(command, env):
    """Milliseconds that passed, and milliseconds of processor time."""
    start = time.monotonic()
    child = os.posix_spawn(command[0], command, env)
    _, status, usage = os.wait4(child, 0)
    passed = time.monotonic() - start
    if status != 0:
        sys.exit("%s: status %d" % (command, status))
    return 1e3 * passed, 1e3 * (usage.ru_utime + usage.ru_stime)


def measure(name, env, *arguments):
    times = [run([os.path.join(BIN, name), *arguments], env) for _ in range(RUNS)]
    for what, column in (("ms", 0), ("ms of processor time", 1)):
        ordered = sorted(run[column] for run in times)
        print("%-11s %-30s least %5.1f, median %5.1f, largest %5.1f %s" % (
            name, " ".join(arguments), ordered[0], statistics.median(ordered), ordered[-1], what))


if __name__ == "__main__":
    with x_server() as server:
        env = environment(server.display)
        for name in ("teapot_afd", "drawdot"):
            for backend in ("xshm", "ximage"):
                measure(name, env, "--no-input", "--backend", backend, "--frames", "1")
