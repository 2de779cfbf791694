#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The program curves: its help, handles that are dragged out of the window, a magnifier and numbers in windows
that have little room for them."""

import harness
from harness import Checks, Session, await_rest, expect, xdotool

CURVES = harness.Program("curves", (480, 320))
FIRST, SECOND, THIRD, LAST = (29, 122), (144, 262), (288, 109), (451, 144)


def begin(it):
    """Hides what tells about the keys at first: help takes its place, and goes."""
    before = it.picture()
    it.press("h")
    it.await_picture(lambda rows: rows != before, what="the help")
    it.press("h")
    await_rest(it)


def drag(it, start, end):
    """To a place in the window, or beside it."""
    for place, button in ((start, "mousedown"), (end, "mouseup")):
        xdotool(it.display, "mousemove", "--window", it.window, *place)
        xdotool(it.display, button, "1")
    await_rest(it)


def handles_stay_where_they_can_be_held():
    with Session(CURVES, counted=True, L3D_FONT="built-in") as it:
        begin(it)
        drag(it, SECOND, (240, 160))
        wanted = it.picture()
        drag(it, (240, 160), (700, 500))
        expect(it.picture() != wanted, "nothing was dragged")
        drag(it, (479, 319), (240, 160))
        expect(it.picture() == wanted, "the handle is lost")
        it.press("q")
        it.expect_end(0)


def the_magnifier_stays_in_a_low_window():
    with Session(harness.Program("curves", (600, 100)), counted=True, L3D_FONT="built-in") as it:
        begin(it)
        before = it.picture()
        it.press("z")
        it.await_picture(lambda rows: rows != before, what="the magnifier")
        expect(it.picture()[0] == before[0], "it reaches the top")
        it.press("q")
        it.expect_end(0)


def wide_numbers_leave_their_labels_free():
    """One step from border to border has the largest differences."""
    with Session(CURVES, counted=True, L3D_FONT="built-in") as it:
        begin(it)
        for start, end in ((FIRST, (1, 319)), (SECOND, (479, 319)), (THIRD, (1, 300)), (LAST, (479, 300))):
            drag(it, start, end)
        it.press(*12 * "l")
        await_rest(it)
        rows = it.picture()
        letters = range(48, 53)  # of the line that begins with d3
        empty = [not any(rows[y][x] & 0xFF for y in letters) for x in range(480)]
        label = empty.index(False)
        expect(empty[label + 12:label + 15] == 3 * [True], "no gap behind d3:", "".join(".#"[not e] for e in empty[:90]))
        it.press("q")
        it.expect_end(0)


def numbers_lie_above_the_curve():
    """A black row is between them, in any size."""
    for size in ((960, 640), (480, 320), (240, 160), (700, 400), (300, 900)):
        width, height = size
        rows = harness.memory_picture(harness.Program("curves", size))
        black = [y for y in range(height) if not any(word & 0xFFFFFF for word in rows[y])]
        between = [y for y in black if y < 0.34 * height and any(word & 0xFFFFFF for row in rows[:y] for word in row)]
        expect(between, "no row between numbers and curve at %dx%d" % size)
        reaches = max(y for y in range(int(0.34 * height)) if any(word & 0xFFFFFF for word in rows[y][:width // 20]))
        expect(reaches < max(between), "numbers below the curve's top at %dx%d" % size)


def the_caption_hides_nothing():
    """It lies on black alone, with the magnifier, too; a button takes it away."""
    program = harness.Program("curves", (750, 500))  # the screen has 800x600
    plain = harness.memory_picture(program)
    with Session(program) as it:
        it.await_picture(lambda rows: rows != plain and harness.has_picture(rows), what="the caption")
        shown = it.picture()
        hidden = [(x, y) for y in range(500) for x in range(750) if shown[y][x] != plain[y][x]]
        expect(hidden and not any(plain[y][x] & 0xFFFFFF for x, y in hidden), "the caption lies on", hidden[:1])
        xdotool(it.display, "mousemove", "--window", it.window, 375, 300, "click", "1")
        it.await_picture(lambda rows: rows == plain, what="the picture without a caption")
        it.press("z")
        it.await_picture(lambda rows: rows != plain, what="the magnifier")
        magnified = it.picture()
        changed = {(x, y) for y in range(500) for x in range(750) if magnified[y][x] != plain[y][x]}
        expect(not any(plain[y][x] & 0xFFFFFF for x, y in changed), "the magnifier lies on the curve")
        expect(not changed & set(hidden), "the caption lies where the magnifier is")
        it.press("q")
        it.expect_end(0)


if __name__ == "__main__":
    checks = Checks()
    for check in (handles_stay_where_they_can_be_held, the_magnifier_stays_in_a_low_window,
                  wide_numbers_leave_their_labels_free, numbers_lie_above_the_curve, the_caption_hides_nothing):
        checks.run("curves." + check.__name__, check)
    checks.finish()
