#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""teapot_afd --compare, which shows two methods side by side, and the key m, which changes one."""

import contextlib
import json
import os

import harness
from harness import Checks, Program, environment, expect, expect_equal, folder, run
from harness import wait_for, xdotool
from teapot_test import Window

HALF = Program("teapot_afd", (320, 260))
BOTH = Program("teapot_afd", (642, 260))
LOWER = slice(140, 220)  # rows below the captions and above messages


def compares_two_methods():
    """Each half is that method's picture below the captions; times are no part of files."""
    with folder() as path:
        def rows_of(program, *arguments):
            command = program.command("--backend", "memory", *arguments, "--output", "o.png")
            expect_equal(run(command, environment(), cwd=path), (0, b"", ""), arguments)
            return harness.read_png(os.path.join(path, "o.png"))

        both = rows_of(BOTH, "--compare", "fd:3")
        again = rows_of(BOTH, "--compare", "fd:3")
        left = rows_of(HALF, "--antialias", "off")
        right = rows_of(HALF, "--antialias", "off", "--method", "fd:3")
        expect(left[LOWER] != right[LOWER], "the methods draw alike")
        expect([row[:320] for row in both[LOWER]] == left[LOWER], "the left half")
        expect([row[322:] for row in both[LOWER]] == right[LOWER], "the right half")
        expect(both[0][:320] == left[0] and both[12][:320] != left[12], "no caption on the left")
        expect(both[12][322:] != right[12], "no caption on the right")
        expect_equal(len({row[320] for row in both} | {row[321] for row in both}), 1, "the line")
        expect(again == both, "two runs differ")
        status, out, said = run(HALF.command("--backend", "memory", "--compare", "magic"), environment(), cwd=path)
        expect_equal((status, out), (2, b""))
        expect(said.startswith("teapot_afd: --compare: 'magic' is unknown"), said)


def steps_through_the_methods():
    """m: to the next that can be created, until AFD comes again."""
    with contextlib.ExitStack() as stack:
        it = Window(stack, stack.enter_context(folder()), "--background", "0,0,0")
        first = it.changes("j")
        seen = [it.changes("m") for _ in range(3)]
        expect(all(picture != first for picture in seen), "another method says so")
        for _ in range(16):
            xdotool(it.display, "key", "m")
            if it.changes("j") == first:
                break
        else:
            raise AssertionError("AFD does not come again")
        xdotool(it.display, "key", "q")
        expect_equal(harness.ended(it.process), (0, b"", ""))


def shows_both_in_a_window():
    """The right half changes with m, both turn when one is dragged, and s saves both."""
    with contextlib.ExitStack() as stack:
        path = stack.enter_context(folder())
        it = Window(stack, path, "--compare", "tessellation:2", "--background", "0,0,0",
                    program=BOTH)

        def lower(right):
            return [row[322:] if right else row[:320] for row in it.picture()[LOWER]]

        it.changes("j")
        left, right = lower(False), lower(True)
        it.changes("m")
        wait_for(lambda: lower(True) != right, "another method on the right")
        expect(lower(False) == left, "the left half changes")
        xdotool(it.display, "mousemove", "--window", it.window, 480, 130, "mousedown", "1",
                "mousemove", "--window", it.window, 500, 140, "mouseup", "1")
        wait_for(lambda: lower(False) != left, "a turn of the left half")
        it.changes("b")
        xdotool(it.display, "key", "s")
        saved = os.path.join(path, "l3d-0001.png")
        wait_for(lambda: os.path.exists(saved), "the saved picture")
        wait_for(lambda: harness.read_png(saved) and len(harness.read_png(saved)[0]) == 642, "both halves")
        xdotool(it.display, "key", "q")
        expect_equal(harness.ended(it.process), (0, b"", ""))


def turns_as_far_across_the_line():
    """A drag that leaves its half for the other one is as long as one that does not."""
    with contextlib.ExitStack() as stack:
        it = Window(stack, stack.enter_context(folder()), "--compare", "afd", "--background", "0,0,0",
                    program=BOTH)

        def left():
            return [row[:320] for row in it.picture()[LOWER]]

        def turned_by_drag(x, to):
            xdotool(it.display, "mousemove", "--window", it.window, x, 130, "mousedown", "1",
                    "mousemove", "--window", it.window, to, 130, "mouseup", "1")
            wait_for(lambda: left() != first, "a turn")
            turned = left()
            xdotool(it.display, "key", "r")
            wait_for(lambda: left() == first, "the first view")
            return turned

        it.changes("j")
        first = left()
        expect(turned_by_drag(310, 334) == turned_by_drag(100, 124), "another turn to the right")
        expect(turned_by_drag(334, 310) == turned_by_drag(124, 100), "another turn to the left")
        xdotool(it.display, "key", "q")
        expect_equal(harness.ended(it.process), (0, b"", ""))


def shows_the_status_below_the_caption():
    """The method's name, in the first line of the left caption, can be read with the status."""
    with contextlib.ExitStack() as stack:
        it = Window(stack, stack.enter_context(folder()), "--compare", "fd:3", "--background", "0,0,0",
                    program=BOTH)

        def first_line():
            return [row[160:320] for row in it.picture()[12:20]]

        it.changes("j")
        method = first_line()
        before = [row[:160] for row in it.picture()[:LOWER.stop]]
        xdotool(it.display, "key", "o")
        wait_for(lambda: [row[:160] for row in it.picture()[:LOWER.stop]] != before, "the status")
        expect(first_line() == method, "the status covers the caption")
        xdotool(it.display, "key", "q")
        expect_equal(harness.ended(it.process), (0, b"", ""))


def frames_of(path, *arguments, program=BOTH):
    command = program.command("--backend", "memory", "--turntable", "5", *arguments, "--output", "q%d.ppm",
                              "--report", "r.json")
    expect_equal(run(command, environment(), cwd=path), (0, b"", ""), arguments)
    with open(os.path.join(path, "r.json"), encoding="utf-8") as file:
        return [json.loads(line) for line in file]


def reports_the_left_half_of_each_frame():
    """A frame is one, however often it was drawn to be measured. So it is of the measured error."""
    with folder() as path:
        for options in (("--compare", "fd:3"), ("--shade", "error")):
            lines = frames_of(path, "--frames", "3", *options)
            expect_equal([line["frame"] for line in lines], [0, 1, 2], options)
            expect(all(line["patches"]["left_out"]["unchanged"] == 0 for line in lines), options, lines)
            lines = frames_of(path, "--frames", "2:4", *options)
            expect_equal([line["frame"] for line in lines], [2, 3], options)
        lines = frames_of(path, "--frames", "1", "--compare", "fd:3", "--wireframe")
        expect_equal([(line["frame"], line["pixels_kept"], line["size"]) for line in lines], [(0, 0, "320x260")])


def refuses_frames_that_depend_on_those_before():
    """A part of a sequence is the same as in the whole one."""
    with folder() as path:
        for method in (("--method", "kept"), ("--compare", "kept:4")):
            for option in (("--resume",), ("--frames", "2:4")):
                command = BOTH.command("--backend", "memory", *method, *option, "--output", "o%d.png")
                said = "teapot_afd: %s: not with kept, whose frames depend on those before them\n" % option[0]
                expect_equal(run(command, environment(), cwd=path), (2, b"", said))
        expect_equal(os.listdir(path), [])


def refuses_maps_of_half_a_picture():
    with folder() as path:
        for option in ("--depth-output", "--error-output"):
            command = BOTH.command("--backend", "memory", "--compare", "fd", option, "m.pfm", "--output", "o.png")
            said = "teapot_afd: %s: not with --compare, whose halves are two pictures\n" % option
            expect_equal(run(command, environment(), cwd=path), (2, b"", said))
        expect_equal(os.listdir(path), [])


def says_that_an_error_is_not_known():
    """The exact renderer gives up where the near plane cuts what reaches a million times as far."""
    with folder() as path:
        view = ("--eye", "-1.34,0.44,-1.74", "--target", "-0.79,1.81,-1.99", "--fov", "150", "--near", "1e-6")
        for options in (("--shade", "error", "--legend", "off", "--antialias", "off"), ("--compare", "fd")):
            command = HALF.command("--backend", "memory", *view, *options, "--background", "0,0,0", "--output", "o.png")
            expect_equal(run(command, environment(), cwd=path), (0, b"", ""), options)
            rows = harness.read_png(os.path.join(path, "o.png"))
            if "--shade" in options:
                expect_equal({pixel for row in rows for pixel in row}, {0, 0x606060}, "what is not known is grey")


def measures_no_errors_of_what_is_left_out():
    """The exact picture has both sides of everything, so what is left out on request is no error."""
    with folder() as path:
        def drawn(*arguments):
            command = BOTH.command("--backend", "memory", *arguments, "--output", "o.ppm")
            expect_equal(run(command, environment(), cwd=path), (0, b"", ""), arguments)
            with open(os.path.join(path, "o.ppm"), "rb") as file:
                return file.read()

        for options in (("--far", "8.6"), ("--one-sided", "--eye", "0,-6,3", "--target", "0,1,0")):
            bounds = drawn("--shade", "error", "--legend", "off", "--antialias", "off", *options)
            expect(b"\x60\x60\x60" not in bounds, "grey is not known, but bounds are", options)


def draws_fog_where_a_method_has_it():
    """AFD has, and the others draw without, beside it and after the key m, until AFD comes again."""
    with contextlib.ExitStack() as stack:
        path = stack.enter_context(folder())
        black, fog = ("--background", "0,0,0"), ("--fog", "5,9,255,0,0")

        def lower(program, *arguments):
            command = program.command("--backend", "memory", *black, *arguments, "--output", "o.png")
            expect_equal(run(command, environment(), cwd=path), (0, b"", ""), arguments)
            return harness.read_png(os.path.join(path, "o.png"))[LOWER]

        both = lower(BOTH, "--compare", "fd:3", *fog)
        expect([row[:320] for row in both] == lower(HALF, "--antialias", "off", *fog), "fog on the left")
        expect([row[322:] for row in both] == lower(HALF, "--antialias", "off", "--method", "fd:3"), "no fog on the right")
        it = Window(stack, path, *black, *fog, program=HALF)
        foggy = it.changes("j")[LOWER]
        expect_equal(it.changes("m", "j")[LOWER], lower(HALF, "--method", "fd"), "no fog of fd")
        for _ in range(16):
            xdotool(it.display, "key", "m")
            if it.changes("j")[LOWER] == foggy:
                break
        else:
            raise AssertionError("the fog does not come again")


def draws_nets_over_measured_errors():
    """Edges are those of the centres that are measured, and show no colour of the bound."""
    with folder() as path:
        def pixels_of(*arguments):
            command = HALF.command("--backend", "memory", "--background", "0,0,0", "--legend", "off", *arguments,
                                   "--output", "o.png")
            expect_equal(run(command, environment(), cwd=path), (0, b"", ""), arguments)
            return [pixel for row in harness.read_png(os.path.join(path, "o.png")) for pixel in row]

        sharp = ("--antialias", "off")
        nets = pixels_of("--shade", "flat", "--net", *sharp)
        surface = pixels_of("--shade", "flat", *sharp)
        errors = pixels_of("--shade", "error", *sharp)
        both = pixels_of("--shade", "error", "--net", *sharp)
        net = {pixel for pixel, bare in zip(nets, surface) if pixel != bare}
        expect(both == [over if over in net else below for over, below in zip(nets, errors)], "no net on the errors")
        smooth = pixels_of("--shade", "error")  # of finer steps at outlines, so other errors
        known = set(errors)
        strange = sum(pixel not in known for pixel in smooth)
        expect(strange <= len(smooth) // 1000, "edges have colours of the bound", strange)


def picks_in_the_half_of_the_place():
    def picked(x):
        command = BOTH.command("--backend", "memory", "--compare", "fd", "--pick", "%d,150" % x, "--output", "o.png")
        status, out, said = run(command, environment(), cwd=path)
        expect_equal((status, said), (0, ""))
        return out

    with folder() as path:
        expect(picked(160) != b"nothing there\n", "the left teapot")
        expect_equal(picked(322 + 160), picked(160), "the right teapot")
        for x in (5, 320, 321, 322 + 5):
            expect_equal(picked(x), b"nothing there\n", x)


def hides_a_part_in_both_halves():
    """The body of the left teapot, and of the right one, and of the exact one that errors are measured by."""
    with contextlib.ExitStack() as stack:
        path = stack.enter_context(folder())
        it = Window(stack, path, "--compare", "afd", "--background", "0,0,0", program=BOTH)

        def halves():
            rows = it.picture()[LOWER]
            return [row[:320] for row in rows], [row[322:] for row in rows]

        it.changes("j")
        whole = wait_for(lambda: halves()[0] == halves()[1] and halves()[0], "two whole teapots")
        xdotool(it.display, "key", "e", "d", "j")
        wait_for(lambda: whole not in halves() and halves()[0] == halves()[1], "two teapots without a part")
        xdotool(it.display, "key", "r")
        wait_for(lambda: halves() == (whole, whole), "two whole teapots again")
        xdotool(it.display, "key", "q")
        expect_equal(harness.ended(it.process), (0, b"", ""))


def sheets(path):
    """A model whose exact picture takes longer than harness.PATIENCE."""
    with open(os.path.join(path, "sheets.bpt"), "w", encoding="ascii") as file:
        print(2000, file=file)
        for k in range(2000):
            print("3 3", file=file)
            for i in range(16):
                print(i % 4 * 2 - 3, i // 4 * 2 - 3, -1e-4 * k, file=file)
    return file.name


def quits_while_it_measures():
    """What nobody will see is given up."""
    for options in (("--compare", "fd"), ("--shade", "error", "--antialias", "off")):
        with contextlib.ExitStack() as stack:
            path = stack.enter_context(folder())
            it = Window(stack, path, *options, "--eye", "0,0,2", "--target", "0,0,0", sheets(path),
                        program=Program("teapot_afd", (642, 560)))
            xdotool(it.display, "key", "q")
            expect_equal(harness.ended(it.process), (0, b"", ""))


def tells_no_errors_of_another_view():
    """Those of an empty view are known at once, and those of the sheets behind the eye after minutes."""
    with contextlib.ExitStack() as stack:
        path = stack.enter_context(folder())
        it = Window(stack, path, "--compare", "fd", "--eye", "0,0,-2", "--target", "0,0,-4", "--background", "0,0,0",
                    sheets(path), program=BOTH)

        def last_rows():
            """Where the captions end, above the sheets' uniform grey or above nothing."""
            rows = it.picture()[:LOWER.start]
            return [max((y for y, row in enumerate(rows) if len(set(row[half])) > 1), default=0)
                    for half in (slice(0, 320), slice(322, 642))]

        it.changes("j")
        known = wait_for(lambda: min(last_rows()) > 0 and harness.await_still(it) and last_rows(), "the captions")
        xdotool(it.display, "key", "ctrl+1")
        wait_for(lambda: it.picture()[200][100] != 0, "the sheets")
        wait_for(lambda: all(now < then for now, then in zip(last_rows(), known)), "captions without errors")
        xdotool(it.display, "key", "q")
        expect_equal(harness.ended(it.process), (0, b"", ""))


def leaves_half_of_small_pictures_free():
    """Captions become shorter, until there are none."""
    with folder() as path:
        def rows_of(size, *arguments):
            command = Program("teapot_afd", size).command("--backend", "memory", *arguments, "--output", "o.png")
            expect_equal(run(command, environment(), cwd=path), (0, b"", ""), arguments)
            return harness.read_png(os.path.join(path, "o.png"))

        for width, height, has_caption in ((318, 240, True), (238, 180, True), (198, 600, True), (158, 120, True),
                                           (98, 80, True), (28, 30, False)):
            half = (width - 2) // 2
            both = rows_of((width, height), "--compare", "fd")
            for method, start in (("afd", 0), ("fd", width - half)):
                plain = rows_of((half, height), "--method", method, "--antialias", "off")
                covered = sum(a != b for row, bare in zip(both, plain) for a, b in zip(row[start:start + half], bare))
                expect(covered <= half * height / 2 and (covered > 0) == has_caption, width, height, method, covered)


def main():
    checks = Checks()
    for check in (compares_two_methods, steps_through_the_methods, shows_both_in_a_window,
                  turns_as_far_across_the_line, shows_the_status_below_the_caption,
                  reports_the_left_half_of_each_frame, refuses_maps_of_half_a_picture,
                  refuses_frames_that_depend_on_those_before,
                  draws_fog_where_a_method_has_it, says_that_an_error_is_not_known, measures_no_errors_of_what_is_left_out, draws_nets_over_measured_errors,
                  picks_in_the_half_of_the_place, hides_a_part_in_both_halves, quits_while_it_measures,
                  leaves_half_of_small_pictures_free, tells_no_errors_of_another_view):
        checks.run("compare " + check.__name__, check)
    checks.finish()


if __name__ == "__main__":
    main()
