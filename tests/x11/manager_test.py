#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Windows and their managers: fullscreen, whoever began it, and windows that nobody can see."""

import contextlib
import os
import signal
import sys

import harness
from harness import COUNTED, Checks, Session, await_heard, await_motion, await_rest, environment
from harness import expect, expect_equal, started, wait_for, window_size, xdotool

TEAPOT = harness.PROGRAMS[-1]
WHOLE = (800, 600)
MANAGER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "small_manager.py")


@contextlib.contextmanager
def managed(display):
    """A window manager, for a while; its end is that of a program that is killed."""
    with started([sys.executable, MANAGER], environment(display)) as manager:
        expect_equal(manager.stdout.readline(), b"ready\n")
        yield manager


class Managed(Session):
    """A program that starts under a window manager."""

    def __init__(self, *arguments, **options):
        self.manager = contextlib.ExitStack()

        def prepare(display):
            self.managing = self.manager.enter_context(managed(display))

        super().__init__(TEAPOT, *arguments, prepare=prepare, **options)

    def __exit__(self, *error):
        self.manager.close()
        super().__exit__(*error)


def await_size(it, size):
    wait_for(lambda: window_size(it) == size, "the size %dx%d" % size)
    it.await_picture(harness.has_picture, size)


def await_fullscreen(it, on):
    """Comes or goes, and the program has heard of it."""
    wait_for(lambda: (window_size(it) == WHOLE) == on, "the whole screen: %s" % on)
    await_heard(it, on)


def end_manager(it):
    it.manager.close()
    wait_for(lambda: not it.eyes.has_manager(), "the manager's end")
    xdotool(it.display, "windowfocus", it.window)


def press(it, *keys):
    xdotool(it.display, "key", *keys)


def state_is(it, *names):
    it.eyes.set_atoms(it.window, "_NET_WM_STATE", names)


def escape_leaves_what_the_manager_began():
    with Managed(counted=True) as it:
        it.eyes.ask_manager(it.window, "_NET_WM_STATE_FULLSCREEN", 1)
        await_fullscreen(it, True)
        press(it, "Escape")
        await_fullscreen(it, False)
        press(it, "Escape")
        it.expect_end(0)


def f11_goes_by_what_the_manager_says():
    """The manager's way back is noticed, so the next F11 leads there again."""
    with Managed(counted=True) as it:
        press(it, "F11")
        await_fullscreen(it, True)
        it.eyes.ask_manager(it.window, "_NET_WM_STATE_FULLSCREEN", 0)
        await_fullscreen(it, False)
        press(it, "F11")
        await_fullscreen(it, True)
        press(it, "F11")
        await_fullscreen(it, False)


def escape_right_after_f11_leaves_fullscreen():
    """The manager has not even heard of F11 when the next key comes."""
    with Managed(counted=True) as it:
        await_rest(it)
        it.managing.send_signal(signal.SIGSTOP)
        mark = it.proxy.mark()
        press(it, "F11", "Escape")
        # For each, the program sends itself a question's end, and then the manager a message.
        wait_for(lambda: (it.proxy.mark() - mark).requests.count("SendEvent") >= 4, "both requests")
        it.managing.send_signal(signal.SIGCONT)
        await_rest(it, 2)
        await_fullscreen(it, False)
        press(it, "Escape")
        it.expect_end(0)


def escape_goes_by_what_came_before_it():
    """What the manager did is known one way later, and understood two ways after that."""
    with Managed(counted=True, faults={"delay": 0.6}) as it:
        press(it, "Left")  # with the first key comes the map of the keyboard
        await_rest(it, 2)
        it.eyes.ask_manager(it.window, "_NET_WM_STATE_FULLSCREEN", 1)
        wait_for(lambda: window_size(it) == WHOLE, "the size of the screen")
        press(it, "Escape")
        await_fullscreen(it, False)
        press(it, "Escape")
        it.expect_end(0)


def f11_works_after_the_manager_has_gone():
    with Managed(counted=True) as it:
        end_manager(it)
        press(it, "F11")
        await_fullscreen(it, True)
        press(it, "Escape")
        await_size(it, TEAPOT.size)
        await_fullscreen(it, False)
        press(it, "Escape")
        it.expect_end(0)


def a_manager_that_goes_leaves_fullscreen_to_us():
    with Managed(counted=True) as it:
        press(it, "F11")
        await_fullscreen(it, True)
        end_manager(it)
        press(it, "Escape")
        await_size(it, TEAPOT.size)


def f11_asks_a_manager_that_came_later():
    with Session(TEAPOT, counted=True) as it:
        await_rest(it)
        with managed(it.display):
            press(it, "F11")
            wait_for(lambda: "_NET_WM_STATE_FULLSCREEN" in it.eyes.atoms(it.window, "_NET_WM_STATE"),
                     "the manager's word")
            await_fullscreen(it, True)
            press(it, "Escape")
            await_fullscreen(it, False)


@contextlib.contextmanager
def unseen(hide, show):
    """A turning model that nobody sees for a while. By properties alone: the window stays mapped
    and uncovered, as under a compositor."""
    with Managed("--turntable", "2", counted=True) as it:
        await_motion(it)
        hide(it)
        await_rest(it)
        yield it
        show(it)
        await_motion(it)


def draws_nothing_that_nobody_sees(hide, show):
    with unseen(hide, show):
        pass


def sets(name, *values, root=False, kind="CARDINAL"):
    def act(it):
        it.eyes.set_numbers(it.eyes.root if root else it.window, name, kind, values)

    return act


def both(*acts):
    return lambda it: [act(it) for act in acts]


HIDDEN = {
    "minimised": (lambda it: state_is(it, "_NET_WM_STATE_HIDDEN"), lambda it: state_is(it)),
    "iconic": (sets("WM_STATE", 3, 0, kind="WM_STATE"), sets("WM_STATE", 1, 0, kind="WM_STATE")),
    "withdrawn": (sets("WM_STATE", 0, 0, kind="WM_STATE"), sets("WM_STATE", 1, 0, kind="WM_STATE")),
    "other_workspace": (
        both(sets("_NET_WM_DESKTOP", 0), sets("_NET_CURRENT_DESKTOP", 1, root=True)),
        sets("_NET_CURRENT_DESKTOP", 0, root=True),
    ),
}


def is_seen_on_all_workspaces():
    with Managed("--turntable", "2", counted=True) as it:
        it.eyes.set_numbers(it.window, "_NET_WM_DESKTOP", "CARDINAL", [-1])
        it.eyes.set_numbers(it.eyes.root, "_NET_CURRENT_DESKTOP", "CARDINAL", [3])
        for _ in range(5):
            await_motion(it)


def a_workspace_that_does_not_exist_hides_nothing():
    """Matchbox has one workspace, number 0, and says that windows are on number 1."""
    with Managed("--turntable", "2", counted=True) as it:
        it.eyes.set_numbers(it.window, "_NET_WM_DESKTOP", "CARDINAL", [4])
        for _ in range(5):
            await_motion(it)


def stale_words_hide_nothing():
    """What a manager left behind when it went is nobody's word."""
    with Managed("--turntable", "2", counted=True) as it:
        state_is(it, "_NET_WM_STATE_HIDDEN")
        await_rest(it)
        it.manager.close()
        await_motion(it)


def sizes_that_others_tell_are_not_believed():
    """A synthetic event tells a place; its size takes no memory and leaves the picture."""
    with Session(TEAPOT, *COUNTED, counted=True) as it:
        before = it.picture()
        for size in ((60000, 60000), (15000, 15000), (0, 0), (10, 10)):
            it.eyes.send_size(it.window, *size)
            await_rest(it)
        xdotool(it.display, "windowsize", it.window, 200, 150)
        await_size(it, (200, 150))
        xdotool(it.display, "windowsize", it.window, *TEAPOT.size)
        it.await_picture(lambda rows: rows == before, what="the same picture")
        with open("/proc/%d/status" % it.process.pid) as file:
            peak = next(line for line in file if line.startswith("VmHWM"))
        expect(int(peak.split()[1]) < 400_000, "kB at the peak", peak)


CHECKS = (
    escape_leaves_what_the_manager_began,
    f11_goes_by_what_the_manager_says,
    escape_right_after_f11_leaves_fullscreen,
    escape_goes_by_what_came_before_it,
    f11_works_after_the_manager_has_gone,
    a_manager_that_goes_leaves_fullscreen_to_us,
    f11_asks_a_manager_that_came_later,
    is_seen_on_all_workspaces,
    a_workspace_that_does_not_exist_hides_nothing,
    stale_words_hide_nothing,
    sizes_that_others_tell_are_not_believed,
)

if __name__ == "__main__":
    checks = Checks()
    for check in CHECKS:
        checks.run("manager." + check.__name__, check)
    for name, acts in HIDDEN.items():
        checks.run("manager.draws_nothing." + name, draws_nothing_that_nobody_sees, *acts)
    checks.finish()
