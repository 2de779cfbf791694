#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Each key and each gesture of the viewers changes what their windows show. F11 needs a window manager:
manager_test.py presses it."""

import contextlib
import os

import harness
from harness import Checks, folder, wait_for, xdotool
from view_test import Window

# What changes nothing in the first view comes after what makes it do so.
VIEW = ("Left", "Right", "Up", "Down", "Prior", "Next", "1", "ctrl+1", "3", "ctrl+3", "7", "ctrl+7", "9", "r", "Prior",
        "f")
TEXT = ("h", "h", "question", "question", "o", "o", "s", "p", "space")
PATCHES = ("plus", "minus", "c", "i", "w", "a", "n", "e", "d")
KEYS = {
    "teapot_afd": (*VIEW, *TEXT, *PATCHES, "k", "m"),
    "modelview": (*VIEW, *TEXT, "x", "X", "y", "Y", "z", "Z", "c", "w", "a", "b", "v"),
    "gallery": (*VIEW, *TEXT, *PATCHES),
}
# A large window: at 157x119 help is no more than a page of some lines.
SIZE = (400, 300)


class Viewer(Window):
    """Without the corner where gallery tells the time of each frame, which is never the same."""

    def picture(self):
        return [row if y < 220 else row[:200] for y, row in enumerate(super().picture())]


def rest(it):
    """No message, and nothing that moves: what changes now is done by the next key."""
    xdotool(it.display, "key", "j")  # a key without a meaning takes messages away
    pictures = [it.picture()]

    def is_still():
        pictures.append(it.picture())
        return pictures[-1] == pictures[-2]

    wait_for(is_still, "a picture that rests")


def viewer(stack, name):
    os.chdir(stack.enter_context(folder()))  # the key s writes a file
    it = Viewer(stack, name, size=SIZE)
    if name == "gallery":
        xdotool(it.display, "key", "p")  # its models turn
    return it


def obeys_every_key(name):
    with contextlib.ExitStack() as stack:
        it = viewer(stack, name)
        for key in KEYS[name]:
            if name == "gallery" and key in ("p", "space"):
                continue
            if key == "space":
                xdotool(it.display, "key", "p")  # goes on, which nobody sees of what rests
            rest(it)
            it.does(key, "key", key)
        xdotool(it.display, "key", "space")  # goes on
        if name != "gallery":
            rest(it)
            it.does("t", "key", "t")
        it.end()
        os.chdir(harness.BIN)


def obeys_every_gesture(name):
    with contextlib.ExitStack() as stack:
        it = viewer(stack, name)
        middle = it.at(200, 160)
        for what, words in (
            ("a drag", ("mousedown", 1, *it.at(230, 150), "mouseup", 1)),
            ("a drag with the middle button", ("mousedown", 2, *it.at(215, 150), "mouseup", 2)),
            ("a drag with Shift", ("keydown", "shift", "mousedown", 1, *it.at(190, 160), "mouseup", 1, "keyup", "shift")),
            ("a drag with the right button", ("mousedown", 3, *it.at(200, 140), "mouseup", 3)),
            ("the wheel", ("click", 4)),
            ("the wheel back", ("click", 5, "click", 5)),
            ("a double click", (*it.at(225, 160), "click", "--repeat", 2, "--delay", 30, 1)),
            ("a click with Ctrl", ("keydown", "ctrl", "click", 1, "keyup", "ctrl")),
        ):
            if what in ("a double click", "a click with Ctrl"):
                xdotool(it.display, "key", "r")  # where there is something to click on
            rest(it)
            it.does(what, *middle, *words)
        it.does("a second click with Ctrl", "keydown", "ctrl", *it.at(215, 165), "click", 1, "keyup", "ctrl")
        it.end()
        os.chdir(harness.BIN)


def main():
    checks = Checks()
    for name in KEYS:
        for check in (obeys_every_key, obeys_every_gesture):
            checks.run("viewer_keys.%s.%s" % (name, check.__name__), check, name)
    checks.finish()


if __name__ == "__main__":
    main()
