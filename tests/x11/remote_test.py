#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A line of 1 MB a second with 20 ms each way: what a picture costs on it, and that it gets fine."""

import statistics
import time

import harness
from harness import Checks, Shown, expect, expect_equal, is_quiet, wait_for, x_server
from x_proxy import Proxy

SIZE = (1024, 768)
WHOLE = 4 * SIZE[0] * SIZE[1]  # bytes
TEAPOT = harness.Program("teapot_afd", SIZE)
LINE = {"delay": 0.02, "rate": 1e6}  # seconds each way, bytes a second
SCREEN = ("-screen", "0", "1100x800x24")
# A picture sends 80 000 bytes at most, but for one of more than 16 times as many, and those of its
# requests; and a tile of 2 kB may go beyond.
MOST = 100_000


def ends(traffic):
    """How many pictures are whole: each ends with a question."""
    return traffic.requests.count("SendEvent")


def sent_for_each(proxy, count=20):
    """Bytes a picture, in the mean of so many."""
    # The questions about window and display come before.
    wait_for(lambda: "GetSelectionOwner" in proxy.mark().requests, "the questions")
    first = proxy.mark()
    wait_for(lambda: ends(proxy.mark() - first) > 2, "the first pictures")
    mark = proxy.mark()
    wait_for(lambda: ends(proxy.mark() - mark) >= count, "pictures")
    passed = proxy.mark() - mark
    return passed.bytes_up / ends(passed)


def sends_little_for_a_picture_that_moves():
    bytes_of = {}
    for remote, wire, count in (("auto", LINE, 20), ("off", {}, 20)):
        with x_server(*SCREEN) as server, Proxy(server.display, **wire) as proxy:
            with Shown(TEAPOT, server, "--backend", "ximage", "--turntable", "20", "--remote",
                       remote, display=proxy.tcp_display):
                bytes_of[remote] = sent_for_each(proxy, count)
    print("# bytes a picture of a turning teapot at %dx%d: %d, without --remote %d, whole %d"
          % (*SIZE, bytes_of["auto"], bytes_of["off"], WHOLE))
    expect(bytes_of["auto"] < MOST, "bytes", bytes_of)
    expect(bytes_of["off"] > 4 * bytes_of["auto"], "bytes", bytes_of)


def becomes_fine_when_it_rests():
    with x_server(*SCREEN) as server, Proxy(server.display, **LINE) as proxy:
        with Shown(TEAPOT, server, "--backend", "ximage", *harness.COUNTED,
                   display=proxy.tcp_display) as it:
            wanted = harness.memory_picture(TEAPOT)
            wait_for(lambda: harness.has_picture(it.picture()), "a picture")
            expect(it.picture() != wanted or proxy.mark().bytes_up > WHOLE, "all of it at once")
            wait_for(lambda: it.picture() == wanted, "the picture that memory holds")
            it.press("q")
            it.expect_end(0)


def takes_two_round_trips_at_most(count=8):
    """From a key to its picture: the key comes, perhaps something is asked, and the picture goes."""
    taken, asked = [], []
    with x_server(*SCREEN) as server, Proxy(server.display, **LINE) as proxy:
        with Shown(TEAPOT, server, "--backend", "ximage", *harness.COUNTED,
                   display=proxy.tcp_display) as it:
            wait_for(lambda: harness.has_picture(it.picture()), "a picture")
            it.press("Left")  # Xlib asks for the map of the keyboard with the first
            for _ in range(count):
                wait_for(lambda: is_quiet(proxy, 0.6), "rest")
                mark = proxy.mark()
                it.eyes.has_changed(it.window, *SIZE)
                it.eyes.press_key(it.window, "Left")
                wait_for(lambda: it.eyes.has_changed(it.window, *SIZE), "a picture")
                taken.append(time.monotonic() - it.eyes.pressed)
                asked.append(len((proxy.mark() - mark).replied))
            it.press("q")
            it.expect_end(0)
    print("# key to picture over 2 x 20 ms and 1 MB/s: median of %d: %.0f ms, answers waited for: %d"
          % (count, 1e3 * statistics.median(taken), max(asked)))
    expect(1 + max(asked) <= 2, "round trips", asked)


def main():
    checks = Checks()
    for check in (sends_little_for_a_picture_that_moves, becomes_fine_when_it_rests,
                  takes_two_round_trips_at_most):
        checks.run("remote." + check.__name__, check)
    checks.finish()


if __name__ == "__main__":
    main()
