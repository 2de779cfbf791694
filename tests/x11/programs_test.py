#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every program under apps/: its pictures are the stored ones; keys, close and resize in a window.

Pictures that are not the stored ones are left in the folder `different` beside L3D_BIN. So is the
difference, if memory had the stored ones and a window has others.

With --write the hashes in tests/golden/programs.txt become those of the programs in L3D_BIN."""

import hashlib
import os
import pathlib
import sys

import harness
from harness import Checks, Session, environment, expect, expect_equal, run, x_server, xdotool

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLE = ROOT / "tests" / "golden" / "programs.txt"
FRAMES = 100
DIFFERENT = pathlib.Path(harness.BIN).parent / "different"


class Row:
    """A line of the table."""

    def __init__(self, line):
        cells = [cell.strip() for cell in line.split("|")]
        expect_equal(len(cells), 6, "columns of '%s':" % line.strip())
        self.name, size, arguments, self.real, self.hash, keys = cells
        width, height = map(int, size.split("x"))
        self.program = harness.Program(self.name, (width, height))
        self.arguments = arguments.split()
        self.is_console = keys == "console"
        self.keys = keys.split()
        self.title = ".".join([self.name, *self.arguments])

    def output(self, env=None, *more):
        """What the hash is of: FRAMES pictures as a PPM stream, or what a console program prints."""
        command = self.program.command(*self.arguments)
        if not self.is_console:
            command += ["--backend", "memory", "--frames", str(FRAMES), "--output", "-", *more]
        # what is drawn with the machine's own fonts differs from machine to machine
        status, out, messages = run(command, {**(env or environment()), "L3D_FONT": "built-in"})
        expect_equal((status, messages), (0, ""))
        if not self.is_console:
            expect_equal(out.count(self.header()), FRAMES, "pictures:")
        return out

    def header(self):
        return b"P6\n%d %d\n255\n" % self.program.size

    def file_of(self, what):
        """Where a failure leaves something."""
        DIFFERENT.mkdir(exist_ok=True)
        title = "".join(letter if letter.isalnum() else "_" for letter in self.title)
        return DIFFERENT / (title + what)

    def expect_stored(self, out, what, memory=lambda: b""):
        """That the output has the stored hash; else it is left, and how it differs from what `memory` makes."""
        found = hash_of(out)
        if found == self.hash:
            return
        left = [self.file_of(".txt" if self.is_console else ".ppm")]
        left[0].write_bytes(out)
        wanted = memory()
        if hash_of(wanted) == self.hash:
            left.append(self.file_of("_difference.ppm"))
            left[1].write_bytes(self.difference(out, wanted))
        expect_equal(found, self.hash, "%s; see %s:" % (what, " and ".join(map(str, left))))

    def difference(self, out, memory):
        """The first picture that differs: how much each channel does."""
        size = len(self.header()) + 3 * self.program.size[0] * self.program.size[1]
        start = next(at for at in range(0, FRAMES * size, size)
                     if out[at:at + size] != memory[at:at + size]) + len(self.header())
        end = start + size - len(self.header())
        return self.header() + bytes(abs(one - other) for one, other in
                                     zip(out[start:end], memory[start:end]))


def hash_of(output):
    return hashlib.sha256(output).hexdigest()[:16]


def table():
    lines = TABLE.read_text().splitlines()
    return [Row(line) for line in lines if line and not line.startswith("#")]


def real_of(name):
    """The number type that a program was built with, as it says."""
    status, out, _ = run([os.path.join(harness.BIN, name), "--version"], environment())
    expect_equal(status, 0)
    return out.decode().rsplit(maxsplit=1)[-1]


def programs():
    return sorted(path.parent.name for path in ROOT.glob("apps/*/main.cpp"))


def has_a_row(name, rows):
    real = real_of(name)
    found = [row for row in rows if row.name == name and row.real in ("any", real)]
    expect(found, "no row of", str(TABLE.relative_to(ROOT)), "for", name, real)


def makes_the_stored_pictures(row):
    row.expect_stored(row.output(), "the hash of %d frames" % FRAMES)


def shows_the_stored_pictures(row, server):
    """On every kind of window, too; frames that are counted go by fixed steps of time."""
    for backend in ("ximage", "xshm"):
        out = row.output(environment(server.display), "--backend", backend, "--fps", "0")
        row.expect_stored(out, "the hash of %d frames by %s" % (FRAMES, backend), row.output)


def is_the_five_steps(name):
    """Rows 1 and 39: a reader of the book finds the steps, and no window system in a program."""
    text = (ROOT / "apps" / name / "main.cpp").read_text()
    includes = [line for line in text.splitlines() if line.startswith("#include")]
    foreign = [line for line in includes if "X11/" in line or "GL/" in line or "_p.h" in line]
    expect_equal(foreign, [])
    steps = [text.lower().find("step %d" % step) for step in (2, 1, 3, 4, 5)]
    expect(all(at >= 0 for at in steps) and steps == sorted(steps), "steps are at", steps)


def obeys_keys(row):
    with Session(row.program, *row.arguments) as it:
        for key in row.keys:
            before = it.picture()
            xdotool(it.display, "key", key)
            it.await_picture(lambda rows: rows != before, what="a change by " + key)
        xdotool(it.display, "key", "q")
        it.expect_end(0)


def obeys_the_close_button(row):
    with Session(row.program, *row.arguments) as it:
        it.eyes.ask_to_close(it.window)
        it.expect_end(0)


def fills_a_resized_window(row):
    """Larger, then smaller than at first; there is a picture in either, and Escape ends it."""
    width, height = row.program.size
    with Session(row.program, *row.arguments) as it:
        for size in ((width + 37, height + 21), (max(width - 19, 40), max(height - 9, 25))):
            xdotool(it.display, "windowsize", it.window, *size)
            it.await_picture(harness.has_picture, size, "a picture of %dx%d" % size)
        xdotool(it.display, "key", "Escape")
        it.expect_end(0)


def hello_tells_every_event():
    """Row 34: the names of what happens, as X has them, on the terminal."""
    program = harness.Program("hello", (160, 100))
    with Session(program, "--lesson", "event") as it:
        with it.eyes.cover(80, 50):
            pass
        for action in ("mousemove 30 40", "mousedown 1", "mousemove 50 60", "mouseup 1"):
            verb, *numbers = action.split()
            window = ("--window", it.window) if verb == "mousemove" else ()
            xdotool(it.display, verb, *window, *numbers)
        xdotool(it.display, "key", "x", "q")
        status, _, messages = harness.ended(it.process)
    expect_equal(status, 0, messages)
    for wanted in ("bits per pixel", "Expose\n", "KeyPress x\n", "ButtonPress button 1 30,40\n",
                   "MotionNotify 50,60\n", "ButtonRelease button 1 50,60\n"):
        expect(wanted in messages, wanted, "is not in", messages)


def morph2d_has_the_books_forms():
    """Rows 21 and 37: every pixel of the four forms, the third cut off by the window."""
    program = harness.Program("morph2d", (320, 200), "--classic")
    for frames, wanted in ((50, 5530), (100, 7132), (150, 7450), (200, 6715)):
        rows = harness.memory_picture(program, "--frames", str(frames))
        found = [pixel for row in rows for pixel in row if pixel]
        expect_equal(set(found), {0x0080FF})
        expect_equal(len(found), wanted, "pixels after %d frames" % frames)


def xform_differs_by_seed():
    """Row 36: the same seed gives the same picture, which the hash shows; another another."""
    program = harness.Program("xform", (160, 120))
    pictures = [harness.memory_picture(program, "--seed", seed) for seed in ("7", "8")]
    expect(pictures[0] != pictures[1], "two seeds, one picture")


def collide_keeps_its_bodies_together():
    """The spring pulls all back, and balls that bounce keep their energy: nothing flies away."""
    program = harness.Program("collide", (160, 120), "--classic")
    for frames in (1, 1200, 3600):
        rows = harness.memory_picture(program, "--frames", str(frames))
        expect(sum(pixel != 0 for row in rows for pixel in row) > 300, "few pixels at", frames)
    expect(rows != harness.memory_picture(program, "--frames", "3600", "--seed", "2"), "seeds")


def morph3d_comes_back_to_its_first_form():
    """After four forms of 90 steps each it is the ball again, which looks alike from all sides."""
    program = harness.Program("morph3d", (160, 120), "--classic")
    covered = []
    for frames in (2, 92, 182, 272, 362):
        rows = harness.memory_picture(program, "--frames", str(frames))
        covered.append({(x, y) for y, row in enumerate(rows) for x, pixel in enumerate(row) if pixel})
    expect(len(covered[0] ^ covered[4]) < 0.02 * len(covered[0]), "another form at the end")
    for i in range(4):
        expect(len(covered[i] ^ covered[i + 1]) > 0.1 * len(covered[i]), "no change", i)


def write():
    lines = TABLE.read_text().splitlines()
    for i, line in enumerate(lines):
        if line and not line.startswith("#"):
            row = Row(line)
            if row.real in ("any", real_of(row.name)):
                before, _, after = line.rsplit("|", 2)
                lines[i] = "%s| %s |%s" % (before, hash_of(row.output()), after)
    TABLE.write_text("\n".join(lines) + "\n")


def main():
    checks = Checks()
    rows = table()
    for name in programs():
        checks.run("programs.%s.has_a_row" % name, has_a_row, name, rows)
    for name in sorted({row.name for row in rows if not row.is_console}):
        checks.run("programs.%s.is_the_five_steps" % name, is_the_five_steps, name)
    seen = set()
    for check in (
        hello_tells_every_event,
        morph2d_has_the_books_forms,
        xform_differs_by_seed,
        collide_keeps_its_bodies_together,
        morph3d_comes_back_to_its_first_form,
    ):
        checks.run("programs." + check.__name__, check)
    with x_server() as server:
        for row in rows:
            if row.real not in ("any", real_of(row.name)):
                continue
            checks.run("programs.%s.pictures" % row.title, makes_the_stored_pictures, row)
            if row.name not in seen and not row.is_console:
                for check in (obeys_keys, obeys_the_close_button, fills_a_resized_window):
                    checks.run("programs.%s.%s" % (row.name, check.__name__), check, row)
            if not row.is_console:
                check = "programs.%s.shows_the_stored_pictures" % row.title
                checks.run(check, shows_the_stored_pictures, row, server)
            seen.add(row.name)
    checks.finish()


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        write()
    else:
        main()
