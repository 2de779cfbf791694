#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""teapot_afd: models that are wrong, reports, depth, repeatability, and its keys in a window."""

import contextlib
import json
import os
import re
import struct

import harness
from harness import Checks, Onlooker, Program, environment, expect, expect_equal, folder, run
from harness import memory_picture, started, wait_for, window_of, x_server, xdotool

TEAPOT = Program("teapot_afd", (157, 119))
ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


def memory(*arguments, cwd):
    return run(TEAPOT.command("--backend", "memory", *arguments), environment(), cwd=cwd)


def wrong_models():
    """Name, text, and what the message must start with after the program's name."""
    patch = "3 3\n" + "".join("%d %d 1\n" % (i % 4, i // 4) for i in range(16))
    return [
        ("empty.bpt", "", "empty.bpt:1: "),
        ("word.bpt", "1\n" + patch.replace("1 0 1", "1 zero 1"), "word.bpt:4: "),
        ("cut.bpt", "1\n3 3\n0 0 0\n1 0 0\n", "cut.bpt:"),
        ("huge.bpt", "999999999\n" + patch, "huge.bpt:1: "),
        ("more.bpt", "99999999999999999999\n" + patch, "more.bpt:1: "),
        ("nan.bpt", "1\n" + patch.replace("2 2 1", "2 nan 1"), "nan.bpt:13: "),
        ("infinite.bpt", "1\n" + patch.replace("3 1 1", "3 inf 1"), "infinite.bpt:10: "),
        ("degree.bpt", "1\n99 3\n" + patch, "degree.bpt:2: "),
        ("far.bpt", "1\n" + patch.replace("1 0 1", "1e13 0 1"), "far.bpt:4: "),
        ("trailing.bpt", "1\n" + patch + "7\n", "trailing.bpt:19: "),
        ("words.bpt", "Hello, world\n", "words.bpt:1: 'Hello,' begins none of "),
        ("mesh.bpt", "OFF 3 1 0\n1 2 3\n4 5 7\n7 8 9\n3 0 1 2\n",
         "mesh.bpt: holds 1 polygon and no patches; modelview "),
        ("cut.step", "ISO-10303-21;\nHEADER;\n", "cut.step: it is cut off: "),
        ("weight.bez", "BEZ114\n" + "1 2 3 1\n" * 3 + "1 2 3 -0.5\n", "weight.bez:5: "),
        ("weight.bpt", "1\n1 1 rational\n" + "1 2 3 1\n" * 3 + "1 2 3 0\n", "weight.bpt:6: "),
    ]


def teapot_in_every_format():
    """The shipped teapot's patches: name of a file, text."""
    with open(os.path.join(ROOT, "data", "teapot.bpt"), encoding="ascii") as file:
        lines = file.read().split("\n")[1:]
    patches = [lines[first + 1 : first + 17] for first in range(0, 28 * 17, 17)]
    surface = "surf 0 1 0 1 " + " ".join("-%d" % back for back in range(16, 0, -1))
    surfaces = {
        "bezier": surface + "\nparm u 0 1\nparm v 0 1\nend\n",
        "bspline": surface + "\nparm u 0 0 0 0 1 1 1 1\nparm v 0 0 0 0 1 1 1 1\nend\n",
    }
    yield "teapot.bbp", "BBP\n" + "\n".join(point for patch in patches for point in patch)
    for kind, statements in surfaces.items():
        body = ["".join("v %s\n" % point for point in patch) + statements for patch in patches]
        yield kind + ".obj", "cstype %s\ndeg 3 3\n%s" % (kind, "".join(body))


def draws_the_same_patches_from_every_format():
    with folder() as path:
        size = ("--size", "157x119")
        expect_equal(memory(*size, "--output", "teapot.png", cwd=path), (0, b"", ""))
        with open(os.path.join(path, "teapot.png"), "rb") as file:
            expected = file.read()
        for name, text in teapot_in_every_format():
            with open(os.path.join(path, name), "w", encoding="ascii") as file:
                file.write(text)
            said = memory(*size, "--model", name, "--output", "o.png", cwd=path)
            expect_equal(said, (0, b"", ""), name)
            with open(os.path.join(path, "o.png"), "rb") as file:
                expect(file.read() == expected, name)


def refuses_wrong_models():
    with folder() as path:
        for name, text, start in wrong_models():
            with open(os.path.join(path, name), "w", encoding="ascii") as file:
                file.write(text)
            status, out, said = memory("--model", name, "--output", "o.png", cwd=path)
            expect_equal((status, out), (5, b""), name)
            expect(said.startswith("teapot_afd: " + start), name, said)
            expect_equal(said.count("\n"), 1, name)
        expect(not os.path.exists(os.path.join(path, "o.png")), "a picture of nothing")
        for name in ("missing.bpt", "."):
            status, _, said = memory("--model", name, "--output", "o.png", cwd=path)
            expect_equal(status, 5, name)
            expect(said.startswith("teapot_afd: " + name + ": "), said)


def draws_a_model_cut_at_no_byte():
    """A file cut anywhere is refused, or was complete: it never crashes."""
    with open(os.path.join(ROOT, "data", "teapot.bpt"), "rb") as file:
        text = file.read()
    with folder() as path:
        for length in range(0, len(text), 397):
            with open(os.path.join(path, "cut.bpt"), "wb") as file:
                file.write(text[:length])
            status, _, said = memory("--model", "cut.bpt", "--output", "o.png", cwd=path)
            expect_equal(status, 5, length)
            expect(said.startswith("teapot_afd: cut.bpt:"), said)


def reports_every_frame():
    with folder() as path:
        arguments = ("--frames", "3", "--turntable", "7", "--tolerance", "0.5")
        arguments += ("--report", "r.json", "--output", "o%d.png")
        expect_equal(memory(*arguments, cwd=path), (0, b"", ""))
        with open(os.path.join(path, "r.json"), encoding="utf-8") as file:
            lines = [json.loads(line) for line in file]
        expect_equal([line["frame"] for line in lines], [0, 1, 2])
        expect_equal(len({line["hash"] for line in lines}), 3, "hashes")
        for line in lines:
            expect_equal((line["method"], line["size"], line["threads"]), ("afd", "157x119", min(os.cpu_count(), 8)))
            expect(line["real"] in ("float", "double", "fixed"), line["real"])
            expect_equal(line["patches"]["all"], 28)
            expect(0 < line["error_bound_px"] <= 0.5, line["error_bound_px"])
            expect(line["pixels_covered"] <= line["pixels_written"] <= line["pixels_tested"])
            times = line["time_ms"]
            expect({"total", "dice", "raster", "show", "write"} <= set(times), times)
            expect(times["dice"] + times["raster"] <= times["total"], times)


def reports_to_the_standard_output():
    with folder() as path:
        status, out, said = memory("--report", "-", "--output", "o.png", cwd=path)
        expect_equal((status, said), (0, ""))
        expect_equal(json.loads(out)["frame"], 0)


def reports_into_an_open_file():
    """A standard output that is a file keeps what is in it, and goes on after the report."""
    with folder() as path:
        name = os.path.join(path, "log")
        with open(name, "wb") as log:
            log.write(b"before\n")
            log.flush()
            command = TEAPOT.command("--backend", "memory", "--report", "-", "--output", "o.png")
            done = run(command, environment(), cwd=path, stdout=log)
            expect_equal(done, (0, None, ""))
            log.write(b"after\n")
        with open(name, "rb") as log:
            lines = log.read().splitlines()
        expect_equal((lines[0], lines[-1], len(lines)), (b"before", b"after", 3))
        expect_equal(json.loads(lines[1])["frame"], 0)


def modelview_reports_as_well():
    """Of patches what the teapot's program writes; of polygons what there is."""
    modelview = Program("modelview", TEAPOT.size)
    with folder() as path:
        run_it = lambda *more: run(
            modelview.command("--backend", "memory", "--report", "-", "--explain", *more),
            environment(), cwd=path)
        status, out, said = run_it("--pipeline", "afd", "--eye", "1,2,3", "--depth-output", "d.pfm")
        expect_equal((status, json.loads(out)["method"]), (0, "afd"))
        expect("of 28 patches (offscreen)" in said, said)
        expect(os.path.getsize(os.path.join(path, "d.pfm")) > 4 * 157 * 119, "no distances")
        status, out, said = run_it("--pipeline", "zsort", "--one-sided")
        triangles = json.loads(out)["triangles"]
        wanted = "left out %d of %d triangles (back): " % (triangles["left_out"]["back"], triangles["all"])
        expect(status == 0 and said.startswith(wanted), said)
        status, out, said = run_it("--pipeline", "zsort", "--depth-output", "d.pfm")
        expect_equal((status, out), (2, b""))
        expect(said.startswith("modelview: --depth-output: "), said)


def tells_polygons_a_second():
    """At the end, over all frames: of triangles, and of quads of patches."""
    modelview = Program("modelview", TEAPOT.size)
    with folder() as path:
        for pipeline, least in (("zsort", 200), ("zbuffer", 200), ("afd", 1000)):
            command = modelview.command("--backend", "memory", "--frames", "3", "--output", "f.png", "--turntable", "10", "--statistics",
                                        "--pipeline", pipeline)
            status, _, said = run(command, environment(), cwd=path)
            found = re.fullmatch(r"3 frames, (\S+) s, (\d+) polygons, (\d+) polygons a second\n", said)
            expect(status == 0 and found, said)
            seconds, polygons, rate = map(float, found.groups())
            expect(polygons >= 3 * least and abs(rate * seconds / polygons - 1) < 0.01, said)
        with open(os.path.join(path, "one.off"), "w", encoding="ascii") as file:
            file.write("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        command = modelview.command("--backend", "memory", "--frames", "1", "--output", "f.png", "--statistics", "one.off")
        said = run(command, environment(), cwd=path)[2]
        expect(said.startswith("1 frame, ") and " s, 1 polygon, " in said, said)


def writes_the_map_of_errors():
    """A level for each pixel; the report tells the largest inside surfaces; wires have no map."""
    with folder() as path:
        done = memory("--output", "o.png", "--error-output", "e.pfm", "--report", "r.json", cwd=path)
        expect_equal(done, (0, b"", ""))
        with open(os.path.join(path, "e.pfm"), "rb") as file:
            expect_equal([file.readline() for _ in range(3)], [b"Pf\n", b"157 119\n", b"-1.0\n"])
            levels = struct.unpack("<%df" % (157 * 119), file.read())
        expect(all(0 <= level <= 255 for level in levels), "levels")
        expect(levels[0] < 0.01, "the background in a corner is certain")
        with open(os.path.join(path, "r.json"), encoding="utf-8") as file:
            report = json.loads(file.readline())
        expect(0 < report["color_error_bound"] <= max(levels), report)
        expect(0 < report["coverage_error_bound"] <= 1, report)
        status, out, said = memory("--wireframe", "--error-output", "w.pfm", cwd=path)
        expect_equal((status, out), (2, b""))
        expect("--error-output: " in said, said)


def writes_distances():
    """The PFM has a distance exactly where a pixel's centre shows a surface."""
    with folder() as path:
        done = memory("--antialias", "off", "--background", "0,0,0", "--output", "o.png",
                      "--depth-output", "d.pfm", cwd=path)
        expect_equal(done, (0, b"", ""))
        rows = harness.read_png(os.path.join(path, "o.png"))
        with open(os.path.join(path, "d.pfm"), "rb") as file:
            expect_equal([file.readline() for _ in range(3)], [b"Pf\n", b"157 119\n", b"-1.0\n"])
            values = struct.unpack("<%df" % (157 * 119), file.read())
        for y, row in enumerate(rows):
            below = 157 * (118 - y)  # the bottom row comes first
            for x, colour in enumerate(row):
                distance = values[below + x]
                expect((colour != 0) == (distance < float("inf")), x, y)
                expect(colour == 0 or 4 < distance < 12, x, y, distance)


def repeats_itself():
    """Runs, numbers of threads and what is left out do not change a bit of the picture, but for unit
    normals, which gouraud has none of."""
    away = ("--eye", "1,2,3.1", "--target", "-0.3,1.9,0")  # part of it outside the window
    same = ((), (), ("--threads", "3"))
    for shade, runs in (("lambert", same), ("gouraud", same + (("--keep-all",),))):
        with folder() as path:
            pictures = []
            for more in runs:
                expect_equal(memory(*away, "--shade", shade, *more, "--output", "o.png", cwd=path),
                             (0, b"", ""))
                with open(os.path.join(path, "o.png"), "rb") as file:
                    pictures.append(file.read())
            expect_equal(len(set(pictures)), 1, "different pictures")


def explains_what_it_left_out():
    with folder() as path:
        near = ("--eye", "1,2,3", "--output", "o.png", "--explain")
        status, out, said = memory(*near, cwd=path)
        expect_equal((status, out), (0, b""))
        expect("of 28 patches (offscreen)" in said, said)


def refuses_wrong_values():
    wrong = [
        ("--tolerance", "nan"), ("--tolerance", "-1"), ("--tolerance", "0"), ("--fov", "180"),
        ("--eye", "1,2"), ("--eye", "2e15,0,0"), ("--target", "2e12,0,0"), ("--target", "3.2,3.6,7.4"), ("--up", "0,0,0"),
        ("--light", "0,0,0"), ("--method", "fd:x"), ("--method", "afd:3"), ("--method", "magic"), ("--shade", "green"),
        ("--near", "0"), ("--far", "0.05"), ("--threads", "0"), ("--most-samples", "0"), ("--turntable", "1e9"),
    ]
    with folder() as path:
        for option, value in wrong:
            status, out, said = memory(option, value, cwd=path)
            expect_equal((status, out), (2, b""), option)
            expect(option in said and value.replace("e1", "e+1") in said, said)
            expect_equal(said.count("\n"), 1, said)


def takes_lights_of_any_length():
    with folder() as path:
        pictures = []
        for light in ("1,2,0", "1e300,2e300,0", "1e-300,2e-300,0"):
            expect_equal(memory("--light", light, "--output", "o.png", cwd=path), (0, b"", ""), light)
            with open(os.path.join(path, "o.png"), "rb") as file:
                pictures.append(file.read())
        expect_equal(len(set(pictures)), 1, "different pictures")


def refuses_fog_that_a_method_draws_without():
    with folder() as path:
        for method in ("fd", "fd:8", "subdivision"):
            said = memory("--method", method, "--fog", "1,9", cwd=path)
            expect_equal(said, (2, b"", "teapot_afd: --fog: --method " + method + " draws without; afd has it\n"))


def refuses_what_lines_and_scales_do_not_show():
    with folder() as path:
        for shade in ("flat", "gouraud", "normals", "error", "zebra", "mean"):
            said = memory("--wireframe", "--shade", shade, cwd=path)
            expect_equal(said, (2, b"", "teapot_afd: --wireframe: lines have one colour, and show nothing of --shade %s\n"
                                % shade))
        for pipeline in ("zsort", "zbuffer"):
            for style in ("--hidden-lines", "--wireframe"):
                def drawn(shade):
                    lines = Program("modelview", TEAPOT.size).command(
                        "--backend", "memory", "--pipeline", pipeline, style, "--shade", shade, "--output", "o.png")
                    return run(lines, environment(), cwd=path)

                for shade in ("flat", "gouraud", "normals"):
                    said = "modelview: %s: lines have one colour, and show nothing of --shade %s\n" % (style, shade)
                    expect_equal(drawn(shade), (2, b"", said))
                expect_equal(drawn("lambert"), (0, b"", ""), "the usual shade is no wish")
        said = memory("--point-light", "1,2", cwd=path)
        expect_equal(said, (2, b"", "teapot_afd: --point-light: '1,2' is neither X,Y,Z,REACH nor X,Y,Z,REACH,COLOR\n"))
        for shade in ("error", "zebra"):
            said = memory("--shade", shade, "--fog", "1,9", cwd=path)
            expect_equal(said, (2, b"", "teapot_afd: --fog: the scale of --shade %s has no colours for it\n" % shade))


def refuses_a_tolerance_that_nobody_keeps():
    """Where a method's steps are its own, and the tolerance is not the scale of the error's colours."""
    with folder() as path:
        for method in ("isocurves", "micropolygons", "tessellation", "fd:8", "voxels", "kept"):
            status, out, said = memory("--method", method, "--tolerance", "0.3", cwd=path)
            expect_equal((status, out), (2, b""), method)
            expect("--tolerance" in said and method in said and "subdivision" in said, said)
            expect_equal(said.count("\n"), 1, said)
        done = memory("--method", "tessellation", "--tolerance", "0.3", "--shade", "error", cwd=path)
        expect_equal(done[0], 0, "colours")


def keeps_all_frames():
    with folder() as path:
        status, _, said = memory("--keep-all", "--frames", "5", "--report", "r.json", cwd=path)
        expect_equal((status, said), (0, ""))
        with open(os.path.join(path, "r.json")) as report:
            expect_equal(len(report.readlines()), 5)


def shows_the_error_where_it_is_bounded():
    """With other methods, --shade error is refused by a line that names those that have a bound."""
    bounded = ("afd", "fd", "subdivision", "tessellation", "micropolygons")
    with folder() as path:
        for method in bounded:
            done = memory("--shade", "error", "--method", method, "--antialias", "off",
                          "--background", "0,0,0", "--output", "o.png", cwd=path)
            expect_equal(done, (0, b"", ""), method)
            rows = harness.read_png(os.path.join(path, "o.png"))
            drawn = {pixel for row in rows for pixel in row if pixel}
            known = drawn - {0x606060}
            expect(known and all(max(p >> 16, p >> 8 & 255) == 255 and p & 255 == 0 for p in known),
                   method, "colours", drawn)
            # Measured errors differ from pixel to pixel, while a piece has one bound.
            expect(len(known) > 10, method, len(known))
        for method in ("isocurves", "scanline", "whitted", "blinn", "lane-carpenter", "kept", "voxels", "mesa"):
            status, out, said = memory("--shade", "error", "--method", method, "--output", "p.png", cwd=path)
            expect_equal((status, out, said.count("\n")), (2, b"", 1), method)
            wanted = "--shade: error ", "--method " + method, ", ".join(bounded)
            expect(all(words in said for words in wanted), said)
        modelview = Program("modelview", TEAPOT.size)
        for pipeline in ("zsort", "zbuffer", "mesa"):
            command = modelview.command("--backend", "memory", "--output", "m.png", "--shade", "error", "--pipeline")
            status, out, said = run([*command, pipeline], environment(), cwd=path)
            expect_equal((status, out, said.count("\n")), (2, b"", 1), pipeline)
            expect(said.startswith("modelview: --shade: only --pipeline afd "), said)


def modelview_refuses_what_its_pipeline_has_not():
    """What is given as its default is no wish."""
    viewer = Program("modelview", (97, 73))
    of_patches = (("--net",), ("--tolerance", "50"), ("--lateral-only",), ("--keep-all",))
    of_polygons = (("--rotate", "30,0,0"), ("--hidden-lines",), ("--to-origin",),
                   ("--facets", "4"), ("--rotate-order", "zyx"), ("--crease-angle", "10"))
    usual = ("--rotate", "0,0,0")
    with folder() as path:
        for pipeline, refused, taken in (("zbuffer", of_patches, of_polygons), ("zsort", of_patches, of_polygons),
                                         ("afd", of_polygons, (*of_patches, usual))):
            for words in (*refused, *taken):
                command = viewer.command("--backend", "memory", "--pipeline", pipeline, *words, "--output", "o.png")
                status, out, said = run(command, environment(), cwd=path)
                expect_equal((status, out), (2 if words in refused else 0, b""), (pipeline, words, said))
                if words in refused:
                    expect(said.startswith("modelview: %s: " % words[0]) and said.count("\n") == 1, said)


def says_what_is_wrong_before_where_the_picture_goes():
    """Without a display nor --output, a run that goes well begins with a word about its file."""
    parts = "body, handle, spout, lid"
    with folder() as path:
        for name, option, value, code, why in (
                ("modelview", "--hide", "nosuch", 2, "--hide: 'nosuch' names no part; there are " + parts),
                ("teapot_afd", "--color", "nosuch=1,2,3", 2, "--color: 'nosuch' names no part; there are " + parts),
                *((name, "--model", "./nosuch.bpt", 5, "./nosuch.bpt: No such file or directory")
                  for name in ("modelview", "teapot_afd", "gallery"))):
            said = run(Program(name, TEAPOT.size).command(option, value), environment(), cwd=path)
            expect_equal(said, (code, b"", "%s: %s\n" % (name, why)))
        expect_equal(os.listdir(path), [])


class Window:
    """The program in a window, and what is in it."""

    def __init__(self, stack, path, *arguments, program=TEAPOT):
        self.size = program.size
        self.display = stack.enter_context(x_server()).display
        self.eyes = stack.enter_context(Onlooker(self.display))
        command = program.command("--backend", "ximage", *arguments)
        self.process = stack.enter_context(started(command, environment(self.display), cwd=path))
        self.window = window_of(self.display, program)
        wait_for(lambda: harness.has_picture(self.picture()), "the first picture")

    def picture(self):
        return self.eyes.picture(self.window, *self.size)

    def changes(self, *keys):
        """Presses keys and returns the picture that follows: a different one, and whole."""
        before = self.picture()
        xdotool(self.display, "key", *keys)
        wait_for(lambda: self.picture() != before, "a change by " + " ".join(keys))
        return harness.await_still(self)

    def await_picture(self, question, _, what):
        return wait_for(lambda: question(self.picture()), what)


def greets_a_person():
    """A word about the help, and a title that names the model. Counted frames have no such word."""
    with contextlib.ExitStack() as stack:
        path = stack.enter_context(folder())
        it = Window(stack, path)
        title = xdotool(it.display, "getwindowname", it.window).strip()
        expect_equal(title, "Utah teapot - teapot_afd", "the title")
        counted = memory_picture(TEAPOT)
        expect(it.picture() != counted, "no word about the help")
        expect_equal(it.changes("j"), counted, "the picture without it")
        xdotool(it.display, "key", "q")


def obeys_its_keys():
    with contextlib.ExitStack() as stack:
        path = stack.enter_context(folder())
        it = Window(stack, path)
        first = it.changes("j")  # a key that nobody has takes away the word about the help
        for key in ("Left", "Right", "Up", "Down", "Prior", "Next", "plus", "minus"):
            it.changes(key)
        xdotool(it.display, "key", "Left", "r")
        wait_for(lambda: it.picture() == first, "the first view again")
        for key in ("w", "n", "c", "c", "c", "c", "o", "h"):
            it.changes(key)
        xdotool(it.display, "key", "s")
        saved = os.path.join(path, "l3d-0001.png")
        wait_for(lambda: os.path.exists(saved), "the saved picture")
        expect(harness.has_picture(harness.read_png(saved)), "the saved picture is empty")
        resting = it.picture()
        xdotool(it.display, "key", "t")
        turning = wait_for(lambda: it.picture() != resting and it.picture(), "the turntable")
        wait_for(lambda: it.picture() != turning, "its next picture")
        xdotool(it.display, "key", "q")
        expect_equal(harness.ended(it.process), (0, b"", ""))


def obeys_the_mouse():
    with contextlib.ExitStack() as stack:
        it = Window(stack, stack.enter_context(folder()))
        before = it.picture()
        at = ("mousemove", "--window", it.window)
        xdotool(it.display, *at, 70, 60, "mousedown", "1", *at, 110, 75, "mouseup", "1")
        wait_for(lambda: it.picture() != before, "a change by dragging")
        before = it.picture()
        xdotool(it.display, "click", "4")
        wait_for(lambda: it.picture() != before, "a change by the wheel")
        xdotool(it.display, "key", "Escape")
        expect_equal(harness.ended(it.process), (0, b"", ""))


def main():
    checks = Checks()
    for check in (
        refuses_wrong_models, draws_a_model_cut_at_no_byte,
        draws_the_same_patches_from_every_format, reports_every_frame,
        reports_to_the_standard_output, reports_into_an_open_file,
        modelview_reports_as_well, tells_polygons_a_second, writes_distances, writes_the_map_of_errors,
        repeats_itself, explains_what_it_left_out, refuses_wrong_values,
        takes_lights_of_any_length, refuses_fog_that_a_method_draws_without,
        refuses_what_lines_and_scales_do_not_show,
        refuses_a_tolerance_that_nobody_keeps, keeps_all_frames,
        shows_the_error_where_it_is_bounded,
        modelview_refuses_what_its_pipeline_has_not, says_what_is_wrong_before_where_the_picture_goes, greets_a_person, obeys_its_keys,
        obeys_the_mouse,
    ):
        checks.run("teapot " + check.__name__, check)
    checks.finish()


if __name__ == "__main__":
    main()
