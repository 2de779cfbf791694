#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A program that has nothing to do sleeps, and a key wakes it at once."""

import concurrent.futures
import os
import statistics
import time

import harness
from harness import Checks, Session, await_still, expect, settle, wait_for, xdotool
from manager_test import HIDDEN, unseen

TEAPOT = harness.PROGRAMS[-1]
SECONDS = 3
# Of every program with a window: the key that stops what moves; none where nothing does.
STOPS = {
    "camspikes": "0",
    "clipz": "0",
    "collide": "0",
    "curves": None,
    "dots": "space",
    "drawdot": "space",
    "fltsim": "0",
    "gallery": "space",
    "hello": None,
    "mesaflat": "space",
    "modelview": None,
    "morph2d": "space",
    "morph3d": "0",
    "objcopy": "0",
    "rotspikes": "space",
    "runway": "space",
    "spikes": "space",
    "surfview": None,
    "teapot_afd": None,
    "vidflat": "space",
    "xform": "space",
}
# The word about the help is drawn and taken away: a program that shows it wakes up so often for
# that, and for what the server has to say of its window. Its seconds have hundreds of frames.
MOST_WAKE_UPS = 30


def wake_ups(process):
    """How often threads of a process went to sleep so far: each of them woke up before."""
    count = 0
    for thread in os.listdir("/proc/%d/task" % process.pid):
        with open("/proc/%d/task/%s/status" % (process.pid, thread)) as file:
            line = next(line for line in file if line.startswith("voluntary_ctxt"))
        count += int(line.split()[1])
    return count


def expect_sleep(it):
    """Not one thread wakes up. What came before may still be under way for a moment."""
    seen = []

    def sleeps():
        before = wake_ups(it.process)
        time.sleep(SECONDS)
        seen.append(wake_ups(it.process) - before)
        return seen[-1] == 0

    wait_for(sleeps, "sleep; wake-ups in %d s each: %r" % (SECONDS, seen))


def sleeps_when_nothing_moves(name, backend):
    """At last for good, and before with one timer: the word about the help has seconds to go."""
    with Session(harness.Program(name, (320, 240)), "--backend", backend) as it:
        if STOPS[name]:
            xdotool(it.display, "key", STOPS[name])
        await_still(it)
        if name != "gallery":  # where the answer to the key takes the word's place
            hinted, before = it.picture(), wake_ups(it.process)
            wait_for(lambda: it.picture() != hinted, "the word about the help to go")
            woken = wake_ups(it.process) - before
            expect(woken <= MOST_WAKE_UPS, "wake-ups while the word was shown:", woken)
        expect_sleep(it)
        xdotool(it.display, "key", "q")
        it.expect_end(0)


def sleeps_when_nobody_sees_it(hide, show):
    with unseen(hide, show) as it:
        expect_sleep(it)


def wakes_up_for_signals():
    for number in (2, 15):
        with Session(harness.DRAWDOT) as it:
            settle(it)
            expect_sleep(it)
            it.process.send_signal(number)
            it.expect_end(-number)


def draws_a_picture_for_each_key(backend, count=40):
    """Each key after a rest leads to another picture. How soon is told, not judged."""
    taken = []
    with Session(TEAPOT, "--backend", backend) as it:
        settle(it)
        it.eyes.has_changed(it.window, *TEAPOT.size)
        for _ in range(count):
            time.sleep(0.03)
            it.eyes.has_changed(it.window, *TEAPOT.size)
            it.eyes.press_key(it.window, "Left")
            wait_for_change(it)
            taken.append(time.monotonic() - it.eyes.pressed)
    median = 1e3 * statistics.median(taken)
    print("# %s: key to picture, median of %d: %.2f ms" % (backend, count, median))


def wait_for_change(it):
    """Without a pause between looks, unlike wait_for: time is measured."""
    end = time.monotonic() + harness.PATIENCE
    while not it.eyes.has_changed(it.window, *TEAPOT.size):
        harness.expect(time.monotonic() < end, "no picture after a key")


if __name__ == "__main__":
    checks = Checks()
    # Who sleeps leaves the processors to others: some at a time, each on a server of its own.
    with concurrent.futures.ThreadPoolExecutor(5) as pool:
        for name, backend in [*((name, "ximage") for name in STOPS), ("teapot_afd", "xshm"), ("hello", "xshm")]:
            check = "rest.%s.%s.sleeps_when_nothing_moves" % (name, backend)
            pool.submit(checks.run, check, sleeps_when_nothing_moves, name, backend)
    for name, acts in HIDDEN.items():
        checks.run("rest.sleeps_when_nobody_sees_it." + name, sleeps_when_nobody_sees_it, *acts)
    checks.run("rest.wakes_up_for_signals", wakes_up_for_signals)
    for backend in ("ximage", "xshm"):
        name = "rest.%s.draws_a_picture_for_each_key" % backend
        checks.run(name, draws_a_picture_for_each_key, backend)
    checks.finish()
