#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A line of 1 MB a second with 20 ms each way: what a picture costs on it, and that it gets fine."""

import contextlib
import statistics
import struct
import time

import harness
from harness import Checks, Shown, expect, expect_equal, is_quiet, wait_for, x_server
from x_proxy import Proxy

SIZE = (1024, 768)
WHOLE = 4 * SIZE[0] * SIZE[1]  # bytes
TEAPOT = harness.Program("teapot_afd", SIZE)
LINE = {"delay": 0.02, "rate": 1e6}  # seconds each way, bytes a second
SCREEN = ("-screen", "0", "1100x800x24")
# A picture sends 80 000 bytes of what moves at most, but for one of more than 16 times as many; 20 000
# of text and of what has come to rest beside; and those of its requests. A tile of 2 kB may go beyond.
MOST = 120_000


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


PANEL = 0x12161B  # the ground of panels, which hides all over a slow line
TURNING = ("--backend", "ximage", "--turntable", "3", "--remote", "on")


def panel_in(rows):
    """The box around the ground of panels: left, top, right, bottom."""
    places = [(x, y) for y, row in enumerate(rows) for x, pixel in enumerate(row) if pixel == PANEL]
    columns, lines = zip(*places)
    return min(columns), min(lines), max(columns) + 1, max(lines) + 1


@contextlib.contextmanager
def asked_by(key, server, *view, **line):
    """A turning teapot, asked by a key for a panel, and how to learn what passed since. This looks at pixels as
    bytes: rows of numbers take this program the time in which its proxy would pass pictures on."""
    with Proxy(server.display, **line) as proxy:
        with Shown(TEAPOT, server, *TURNING, *view, display=proxy.tcp_display) as it:
            has_panel = lambda: struct.pack("<I", PANEL) in it.eyes.image(it.window, *SIZE)[2]
            wait_for(has_panel, "the word about the help")
            it.eyes.press_key(it.window, "j")  # takes it away
            wait_for(lambda: not has_panel(), "a picture without a panel")
            mark = proxy.mark()
            it.eyes.press_key(it.window, key)
            yield it, lambda: proxy.mark() - mark
            it.press("q")
            it.expect_end(0)


def part(it, left, top, right, bottom):
    """The bytes of a part of the window."""
    return it.eyes.image(it.window, right - left, bottom - top, left, top)[2]


def says_at_once_what_a_key_asks_for(rate, key):
    """The panel is exact after its own bytes and those of the pictures before, although the teapot goes on turning."""
    with x_server(*SCREEN) as server:
        # The panel hides less than half. Beside a teapot that small, each picture takes along 80 000 fine bytes of it.
        with asked_by(key, server, "--eye", "160,180,370") as (it, passed):
            wait_for(lambda: ends(passed()) > 2 + WHOLE / 2 / 80_000, "pictures with the whole panel")
            place = left, top, right, bottom = panel_in(it.picture())
            wanted = part(it, *place)
        with asked_by(key, server, delay=0.02, rate=rate) as (it, passed):
            wait_for(lambda: part(it, *place) == wanted, "the panel, exact")
            sent = passed().bytes_up
    box = 4 * (right - left) * (bottom - top)
    print("# %d bytes a second, key %s: %d bytes until a panel of %d is exact" % (rate, key, sent, box))
    expect(sent < box + 3 * MOST, "bytes", sent, "for a panel of", box)


def main():
    checks = Checks()
    for rate in (1e6, 2e5):
        for key in ("h", "c"):
            checks.run("remote.says_at_once_what_a_key_asks_for.%d.%s" % (rate, key),
                       says_at_once_what_a_key_asks_for, rate, key)
    for check in (sends_little_for_a_picture_that_moves, becomes_fine_when_it_rests,
                  takes_two_round_trips_at_most):
        checks.run("remote." + check.__name__, check)
    checks.finish()


if __name__ == "__main__":
    main()
