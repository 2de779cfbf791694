#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The documented keys do what they should, under any layout and without an input method."""

import subprocess

import harness
from harness import DRAWDOT, PATIENCE, Checks, Session, environment, xdotool

TEAPOT = next((program for program in harness.PROGRAMS if program.name == "teapot_afd"), None)

# Some layouts have no Latin letters: there a letter is the key at its place on a PC keyboard, by
# number. The Greek, the Bulgarian and the Hebrew one have signs of ASCII in the place of q.
PLACES = dict(h=43, j=44, k=45, l=46, p=33, q=24, w=25, n=57, o=32, c=54)
LAYOUTS = {
    "us": {},
    "de": {},
    "fr": {},
    "ru": PLACES,
    "gr": PLACES,
    "bg": PLACES,
    "il": PLACES,
}
# Two groups of a layout of which the second, a French one, has Latin letters in other places.
FRENCH_PLACES = {**PLACES, "q": 38, "w": 52}


def set_layout(display, layout):
    subprocess.run(["setxkbmap", layout], env=environment(display), check=True, timeout=PATIENCE)


def press(it, layout, *keys):
    names = [str(LAYOUTS[layout].get(key, key)) for key in keys]
    xdotool(it.display, "key", *names)


def obeys_letters(layout):
    """Down, to the right, and the end, under a layout that comes after the first key."""
    width, height = DRAWDOT.size
    with Session(DRAWDOT) as it:
        press(it, "us", "p")
        set_layout(it.display, layout)
        for key, x, y in (("j", None, height - 1), ("l", width - 1, height - 1)):
            press(it, layout, key)
            reached = lambda rows: harness.GREEN in (rows[y] if x is None else [rows[y][x]])
            it.await_picture(reached, what="the border after " + key)
        press(it, layout, "q")
        it.expect_end(0)


def obeys_a_layout_there_from_the_start(layout):
    with Session(DRAWDOT, prepare=lambda display: set_layout(display, layout)) as it:
        press(it, layout, "p", "q")
        it.expect_end(0)


def obeys_signs(layout):
    """What is typed with Shift or AltGr here and without it there."""
    with Session(TEAPOT) as it:
        set_layout(it.display, layout)
        for key in ("plus", "minus", "w", "w", "n", "o", "Left", "Prior", "question", "question"):
            before = it.picture()
            press(it, layout, key)
            it.await_picture(lambda rows: rows != before, what="a change by " + key)
        press(it, layout, "Escape")
        it.expect_end(0)


def obeys_with_locks_on():
    """Caps Lock makes other letters, and Num Lock other number pads; the rest stays as it is."""
    with Session(TEAPOT) as it:
        for keys in (["KP_Add"], ["KP_Left"], ["Num_Lock", "Caps_Lock", "minus"], ["Left"]):
            before = it.picture()
            xdotool(it.display, "key", *keys)
            it.await_picture(lambda rows: rows != before, what="a change by " + keys[-1])
        xdotool(it.display, "key", "Escape")
        it.expect_end(0)


def obeys_letters_with_locks_on():
    """Caps Lock and Num Lock make no other keys."""
    for lock in ("Caps_Lock", "Num_Lock"):
        with Session(DRAWDOT) as it:
            xdotool(it.display, "key", lock)
            xdotool(it.display, "key", "q")
            it.expect_end(0)


def leaves_keys_with_modifiers_alone():
    """Those are for others: Ctrl+Q is not the letter."""
    width, height = DRAWDOT.size
    with Session(DRAWDOT) as it:
        for modifier in ("ctrl", "alt", "super"):
            xdotool(it.display, "key", modifier + "+q")
        xdotool(it.display, "key", "alt+Escape", "j")
        wanted = lambda rows: harness.GREEN in rows[height - 1]
        it.await_picture(wanted, what="the border after j")
        xdotool(it.display, "key", "q")
        it.expect_end(0)


def takes_the_layouts_own_latin_group():
    """With a Greek group first and a French one, letters are where the French one has them."""
    with Session(DRAWDOT) as it:
        set_layout(it.display, "gr,fr")
        xdotool(it.display, "key", "24")  # a in the French group: nothing
        xdotool(it.display, "key", str(FRENCH_PLACES["j"]))
        wanted = lambda rows: harness.GREEN in rows[DRAWDOT.size[1] - 1]
        it.await_picture(wanted, what="the border after j")
        xdotool(it.display, "key", str(FRENCH_PLACES["q"]))
        it.expect_end(0)


def needs_no_input_method():
    for more in (
        {"XMODIFIERS": "@im=ibus", "GTK_IM_MODULE": "ibus"},
        {"LANG": "C", "LC_ALL": "C"},
        {"LANG": "nonsense", "LC_ALL": "nonsense"},
    ):
        with Session(DRAWDOT, **more) as it:
            xdotool(it.display, "key", "q")
            it.expect_end(0)


if __name__ == "__main__":
    checks = Checks()
    for layout in LAYOUTS:
        checks.run("keys.obeys_letters." + layout, obeys_letters, layout)
        checks.run("keys.from_the_start." + layout, obeys_a_layout_there_from_the_start, layout)
        if TEAPOT:
            checks.run("keys.obeys_signs." + layout, obeys_signs, layout)
    if TEAPOT:
        checks.run("keys.obeys_with_locks_on", obeys_with_locks_on)
    for check in (
        obeys_letters_with_locks_on,
        leaves_keys_with_modifiers_alone,
        takes_the_layouts_own_latin_group,
    ):
        checks.run("keys." + check.__name__, check)
    checks.run("keys.needs_no_input_method", needs_no_input_method)
    checks.finish()
