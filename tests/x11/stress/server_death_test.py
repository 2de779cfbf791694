#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A server that is killed at each request while a window opens, and at many of its pictures."""

import concurrent.futures
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

import display_test
import harness
from harness import Checks, wait_for, x_server
from x_proxy import Proxy

# A window opens with some 30 requests, and each picture sends one to three. So after a dozen pictures
# each seventh is enough: it shares no divisor with these numbers, and meets every kind.
REQUESTS = (*range(1, 61), *range(61, 301, 7))
AT_ONCE = 4  # servers; most of the time goes into their start
# Pictures that the socket's buffer holds, and larger ones, which are cut off in the middle.
PROGRAMS = [harness.Program("teapot_afd", size) for size in ((157, 119), (401, 307))]


def survives_every_death(program, backend):
    command = program.command("--backend", backend, "--turntable", "3", "--fps", "500")
    with x_server() as server:
        last = display_test.last_of_opening(server, command)
    outlive = lambda number: outlives(command, number, number <= last)
    with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
        makers = list(pool.map(outlive, REQUESTS))
    wait_for(lambda: not display_test.segments_of(makers), "the end of the segments")


def outlives(command, number, opening):
    """Returns the number of the process whose server was killed."""
    with x_server() as server:
        with Proxy(server.display, die_after=number, kill_server=server.pid) as proxy:
            return display_test.expect_death(command, proxy, number, opening)


if __name__ == "__main__":
    checks = Checks()
    for program in PROGRAMS:
        for backend in display_test.BACKENDS:
            name = "server_death.%s.%s.%d" % (program.name, backend, program.size[0])
            checks.run(name, survives_every_death, program, backend)
    checks.finish()
