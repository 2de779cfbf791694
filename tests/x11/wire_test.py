#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""When pictures travel, and how much of them: pace, a network, a storm of sizes."""

import collections
import os
import signal
import time

import harness
from display_test import LAST_OF_QUESTION, MOVING, PICTURES, PUTS, TEAPOT, pictures, resident_bytes
from harness import Checks, Shown, environment, expect, expect_equal, is_quiet, wait_for, x_server
from harness import xdotool
from x_proxy import Proxy

PERIOD = 1 / 60
REMOTE_RATE = 15  # pictures per second over a network, unless --fps says otherwise


def times_of_pictures(traffic):
    return [at for name, at in zip(traffic.requests, traffic.times) if name in PICTURES]


def ends(proxy, mark):
    """When the questions were sent that follow pictures."""
    passed = proxy.mark() - mark
    return [at for name, at in zip(passed.requests, passed.times) if name == "SendEvent"]


def most_pictures(times):
    """As many as sixty per second are: both ends count, and each may come a period off its time."""
    return (times[-1] - times[0]) / PERIOD + 3


def keeps_its_pace(backend, count=60):
    """Sixty pictures per second; those that were missed are not made up for."""
    with x_server() as server, Proxy(server.display) as proxy:
        with Shown(TEAPOT, server, "--backend", backend, *MOVING[TEAPOT],
                   display=proxy.display) as it:
            mark = proxy.mark()
            wait_for(lambda: pictures(proxy.mark() - mark) > count, "pictures")
            times = times_of_pictures(proxy.mark() - mark)
            # A busy machine may miss many pictures, but the grid of times stays where it is.
            most = most_pictures(times)
            expect(len(times) <= most, "pictures", len(times), most)
            # Some pictures follow each other as they should. With half as many, no four of them took so little time.
            least = min(later - one for one, later in zip(times, times[3:]))
            expect(least < 3 * 1.5 * PERIOD, "seconds for three pictures", least)

            it.process.send_signal(signal.SIGSTOP)
            time.sleep(1.5)
            mark = proxy.mark()
            it.process.send_signal(signal.SIGCONT)
            wait_for(lambda: pictures(proxy.mark() - mark) > count / 2, "pictures after a stop")
            times = times_of_pictures(proxy.mark() - mark)
            most = most_pictures(times)
            expect(len(times) <= most, "a burst of pictures", len(times), most)
            it.press("q")
            it.expect_end(0)


def goes_slowly_over_a_network(backend):
    with x_server() as server, Proxy(server.display) as proxy:
        with Shown(TEAPOT, server, "--backend", backend, *MOVING[TEAPOT],
                   display=proxy.tcp_display):
            # The questions about window and display come first; then a picture ends with one each.
            wait_for(lambda: LAST_OF_QUESTION in proxy.mark().requests, "the question")
            asked = proxy.mark()
            wait_for(lambda: len(ends(proxy, asked)) > 5, "pictures")
            mark = proxy.mark()
            times = wait_for(lambda: len(ends(proxy, mark)) > REMOTE_RATE and ends(proxy, mark), "pictures")
            rate = (len(times) - 1) / (times[-1] - times[0])
            expect(rate < 1.1 * REMOTE_RATE, "pictures per second", rate)


def sends_only_what_changed():
    """Over a network a line of text on the picture costs less than a fortieth of it."""
    width, height = 1024, 768  # a panel of 35 rows may lie in 4 of 48 bands, and is half as wide
    program = harness.Program("teapot_afd", (width, height))
    screen = ("-screen", "0", "1100x800x24")
    with x_server(*screen) as server, Proxy(server.display) as proxy, harness.folder() as path:
        with Shown(program, server, "--backend", "ximage", display=proxy.tcp_display,
                   cwd=path) as it:
            wait_for(lambda: pictures(proxy.mark()) and is_quiet(proxy), "the first picture")
            mark, before = proxy.mark(), it.picture()
            it.press("s")  # the name of the file is shown
            wait_for(lambda: os.path.exists(os.path.join(path, "l3d-0001.png")), "the file")
            wait_for(lambda: it.picture() != before and is_quiet(proxy), "the line of text")
            sent = (proxy.mark() - mark).bytes_up
            expect(0 < sent < 4 * width * height / 40, "bytes", sent)


def sends_nothing_while_it_stands_still(backend, reach, frames=100):
    """A run of a hundred frames more has no request more than that of one frame, but for the
    questions about window and display, which a short run does not come to."""
    with x_server() as server:
        first, all_frames = (requests_of_a_run(server, backend, reach, count)
                             for count in (1, 1 + frames))
    expect_equal(all_frames - first - QUESTION, collections.Counter(), "more than the first's")
    expect_equal(sum(all_frames[name] for name in PICTURES), PUTS[backend], "pictures")


# Of the state of the window, of the resolution of the display, of fine wheels and of the keyboard.
QUESTION = collections.Counter({"InternAtom": 14, "QueryExtension": 2, "GetProperty": 10,
                                "ChangeProperty": 3, "XKEYBOARD.1": 2, "XKEYBOARD.8": 1,
                                "XKEYBOARD.21": 1,
                                "GetWindowAttributes": 2, "ChangeWindowAttributes": 1,
                                "GetSelectionOwner": 1, "SendEvent": 7, "RANDR.0": 1,
                                "RANDR.42": 1, "XInputExtension.46": 1, "XInputExtension.47": 1,
                                "XInputExtension.48": 1})


def requests_of_a_run(server, backend, reach, frames):
    """How many there were of each name, from the first to the goodbye."""
    with Proxy(server.display) as proxy, harness.folder() as path:
        command = TEAPOT.command("--backend", backend, "--frames", str(frames), "--fps", "200",
                                 "--output", "%d.png")
        done = harness.run(command, environment(getattr(proxy, reach)), cwd=path)
        expect_equal(done, (0, b"", ""))
        expect_equal(len(os.listdir(path)), frames, "frames that passed")
        return collections.Counter(proxy.mark().requests)


def puts_all_of_it_again(backend, reach):
    """Whatever part of a window was uncovered, the whole picture follows once, text first, the same."""
    width, height = TEAPOT.size
    with x_server() as server, Proxy(server.display) as proxy:
        with Shown(TEAPOT, server, "--backend", backend, display=getattr(proxy, reach)) as it:
            wait_for(lambda: pictures(proxy.mark()) >= PUTS[backend] and is_quiet(proxy),
                     "the first picture")
            before = it.picture()
            expect(harness.has_picture(before), "nothing is shown")
            for what, harm in (
                ("a corner", lambda: cover_for_a_while(it, proxy, width // 2, height - 7)),
                ("all", lambda: cover_for_a_while(it, proxy, 800, 600)),
                ("one pixel", lambda: it.eyes.expose(it.window, width - 3, 5, 1, 1)),
            ):
                mark = proxy.mark()
                harm()
                wait_for(lambda: (proxy.mark() - mark).boxes and is_quiet(proxy), "the repair")
                boxes = (proxy.mark() - mark).boxes
                if reach == "display":
                    expect_equal(boxes, [(0, 0, width, height)], what)
                else: # text goes first: the server fills its grounds, and letters travel
                    seen = [(x, y) for left, top, columns, rows in boxes
                            for x in range(left, left + columns) for y in range(top, top + rows)]
                    expect(0.9 * width * height < len(seen) <= width * height, what, boxes)
                expect(it.picture() == before, what, "another picture")


def cover_for_a_while(it, proxy, width, height):
    with it.eyes.cover(width, height):
        expect(is_quiet(proxy), "requests about what is covered")


def weathers_a_storm_of_sizes(backend, count=300):
    """The picture has the last size, and memory did not grow with their number."""
    last = (233, 144)
    with x_server() as server, Proxy(server.display) as proxy:
        with Shown(TEAPOT, server, "--backend", backend, *harness.COUNTED,
                   display=proxy.display) as it:
            steps = []
            for i in range(count):
                steps += ["windowsize", it.window, 60 + 7 * i % 301, 50 + 11 * i % 211]
            storm = lambda: xdotool(server.display, *steps, "windowsize", it.window, *last)
            storm()
            wait_for(lambda: it.eyes.picture(it.window, *last) and is_quiet(proxy), "the last size")
            size, mark = resident_bytes(it.process), proxy.mark()
            storm()
            wait_for(lambda: is_quiet(proxy), "rest")
            grown = resident_bytes(it.process) - size
            # 300 pictures of up to 360 x 260 are 110 MB; sanitizers keep some of what is freed.
            expect(grown < 16 << 20, "bytes more in memory", grown)
            made = (proxy.mark() - mark).requests.count("MIT-SHM.Attach")
            expect(made <= count + 1, "segments made", made)
            wanted = harness.memory_picture(harness.Program("teapot_afd", last))
            expect(it.eyes.picture(it.window, *last) == wanted, "another picture")
            it.press("q")
            it.expect_end(0)


def main():
    checks = Checks()
    for backend in ("ximage", "xshm"):
        for check in (keeps_its_pace, goes_slowly_over_a_network, weathers_a_storm_of_sizes):
            checks.run("wire.%s.%s" % (backend, check.__name__), check, backend)
    for backend, reach in (("ximage", "display"), ("ximage", "tcp_display"), ("xshm", "display")):
        for check in (sends_nothing_while_it_stands_still, puts_all_of_it_again):
            name = "wire.%s.%s.%s" % (backend, reach, check.__name__)
            checks.run(name, check, backend, reach)
    checks.run("wire.sends_only_what_changed", sends_only_what_changed)
    checks.finish()


if __name__ == "__main__":
    main()
