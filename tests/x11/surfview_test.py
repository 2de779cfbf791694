#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""surfview: the list of parts, sections and measures, by keys and by mouse; views that are told and seen again."""

import contextlib
import itertools
import json
import os
import re
import shlex

import harness
from harness import (Checks, Program, Shown, environment, expect, expect_equal, folder, run, started, wait_for,
                     x_server, xdotool)
from viewer_keys_test import rest
from view_test import Window

SIZE = (480, 360)
LIST = 192  # the letters of a window of this size are 12 pixels high, and 16 of them are its least width
PLATE = """v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 1\nv 2 0 1\nv 2 2 1\nv 0 2 1
o floor\nf 4 3 2 1\no roof\nf 5 6 7 8\no walls\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"""


class Viewer(Window):
    """A window whose letters are the same on every machine."""

    def model(self):
        return [row[LIST:] for row in self.picture()]

    def names(self):
        return [row[:LIST] for row in self.picture()]

    def changes(self, what, where, *arguments):
        """Sends a key or a gesture, and returns what follows in `where`, which differs."""
        rest(self)
        before = where()
        xdotool(self.display, *arguments)
        wait_for(lambda: where() != before, "a change by " + what)
        return where()


def models(path):
    with open(os.path.join(path, "house.obj"), "w", encoding="ascii") as file:
        file.write(PLATE)
    return {"teapot": (), "house": (os.path.join(path, "house.obj"),)}


def obeys_its_keys(name):
    with folder() as path, contextlib.ExitStack() as stack:
        it = Viewer(stack, "surfview", *models(path)[name], size=SIZE)
        rest(it)
        expect(harness.has_picture(it.names()), "no list of parts")
        for key in ("e", "E", "d", "d", "e", "C", "u", "u"):
            it.changes(key, it.names, "key", key)
        for key in ("F", "f", "slash", "comma", "period", "semicolon", "slash", "slash", "slash", "c"):
            it.changes(key, it.model, "key", key)
        it.changes("Tab", it.names, "key", "Tab")
        it.changes("Tab", it.names, "key", "Tab")
        it.end()


def obeys_the_mouse(name):
    with folder() as path, contextlib.ExitStack() as stack:
        it = Viewer(stack, "surfview", *models(path)[name], size=SIZE)
        # Half a letter, the title, and half of a line: of a part that is not where a click goes later.
        line = 6 + 14 + 7 + {"teapot": 14, "house": 0}[name]
        it.changes("a click on a square", it.model, *it.at(10, line), "click", 1)
        it.changes("a second one", it.model, *it.at(10, line), "click", 1)
        it.changes("a double click on a name", it.model, *it.at(60, line), "click", "--repeat", 2, "--delay", 30, 1)
        it.changes("a right click", it.names, *it.at(60, line), "click", 3)
        it.changes("u", it.model, "key", "u")
        it.changes("a click on the model", it.names, *it.at(330, 190), "click", 1)
        it.changes("a drag", it.model, *it.at(330, 190), "mousedown", 1, *it.at(360, 170), "mouseup", 1)
        it.changes("a place", it.model, *it.at(330, 190), "keydown", "ctrl", "click", 1, "keyup", "ctrl")
        it.changes("a distance", it.model, *it.at(300, 200), "keydown", "ctrl", "click", 1, "keyup", "ctrl")
        it.end()


def tells_a_view_that_is_seen_again():
    """What g prints draws the same picture into memory: parts, colours, the section and the shade."""
    with folder() as path, contextlib.ExitStack() as stack:
        for name, model in models(path).items():
            it = Viewer(stack, "surfview", *model, size=SIZE)
            for keys in ("e", "C", "e", "d", "slash", "comma", "Left", "Up", "c", "Tab"):
                rest(it)
                xdotool(it.display, "key", keys)
            rest(it)
            shown = it.picture()
            xdotool(it.display, "key", "g")
            rest(it)
            xdotool(it.display, "key", "Escape")
            status, out, said = harness.ended(it.process)
            expect_equal((status, out, said.count("\n")), (0, b"", 1), said)
            options = shlex.split(said)
            for option in ("--eye", "--hide", "--color", "--section", "--section-at", "--shade"):
                expect(option in options, option, said)
            program = Program("surfview", SIZE)
            command = program.command("--backend", "memory", *model, *options, "--output", "again.png")
            expect_equal(run(command, environment(), cwd=path), (0, b"", ""), name)
            expect(harness.read_png(os.path.join(path, "again.png")) == shown, "another picture of " + name)


def a_thousand_parts_stay_usable():
    """Each key is answered at once; the wheel scrolls, and the list stays beside the model."""
    with folder() as path, contextlib.ExitStack() as stack:
        file_name = os.path.join(path, "many.obj")
        with open(file_name, "w", encoding="ascii") as file:
            for i in range(1000):
                x, y = i % 32, i // 32
                file.write("v %d %d 0\nv %g %d 0\nv %d %g 0\n" % (x, y, x + 0.8, y, x, y + 0.8))
                file.write("o a part with a name that is much too long for its line, number %d\nf -3 -2 -1\n" % i)
        it = Viewer(stack, "surfview", file_name, size=SIZE)
        it.changes("the wheel", it.names, *it.at(60, 100), "click", 5)
        it.changes("a click", it.names, *it.at(60, 100), "click", 1)
        it.changes("u", it.model, "key", "u")
        it.changes("E", it.names, "key", "E")
        it.end()


def refuses_what_is_no_section():
    program = Program("surfview", (60, 40))
    with folder() as path:
        house = models(path)["house"][0]
        for words, said in (
            (("--section", "0,0,0"), "--section: no direction"),
            (("--section-at", "0,0,0"), "--section-at: --section says across which direction"),
            (("--section", "1,0,0", "--error-output", "e.pfm"), "--section: --error-output has bounds of whole "
                                                               "surfaces alone"),
            (("--list-edges", "--audit", house), "--list-edges: --audit prints, too"),
            (("--list-edges", "--list-parts"), "--list-edges: --list-parts prints, too"),
            ((house, "--hide", "cellar"), "--hide: 'cellar' names no part; there are floor, roof, walls"),
            ((house, "--opacity", "roof=0.5"), "--opacity: polygons are opaque; only --pipeline afd, which draws "
                                               "patches, has it"),
        ):
            command = program.command("--backend", "memory", *words, "--output", "o.png")
            status, out, messages = run(command, environment(), cwd=path)
            expect_equal((status, out, messages), (2, b"", "surfview: %s\n" % said))
            expect(not os.path.exists(os.path.join(path, "o.png")), words)


def audits_a_mesh():
    """An octahedron in the unit sphere: its faces are 1 - 1 / sqrt(3) away from it. The picture has the mark."""
    program = Program("surfview", (200, 150))
    corners = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    with folder() as path:
        for scale, hint in ((1, None), (1000, "1000 times: millimetres in place of metres")):
            with open(os.path.join(path, "eight.obj"), "w", encoding="ascii") as file:
                for corner in corners:
                    file.write("v %g %g %g\n" % tuple(scale * x for x in corner))
                for x, y, z in itertools.product((1, 2), (3, 4), (5, 6)):
                    file.write("f %d %d %d\n" % ((x, y, z) if (x + y + z) % 2 else (x, z, y)))
            command = program.command("--backend", "memory", "sphere", "--audit", "eight.obj", "--audit-tolerance", "1e-3",
                                      "--output", "o.png")
            status, out, messages = run(command, environment(), cwd=path)
            expect_equal(status, 0)
            found = json.loads(out)
            expect_equal((found["mesh"], found["triangles"], found["pieces"]), ("eight.obj", 8, 8))
            exact = 1 - 3 ** -0.5 if scale == 1 else scale - 1
            way = found["mesh_to_surface"]
            expect(way["least"] <= exact <= way["most"], way)
            expect(way["most"] - way["least"] <= found["tolerance"], way)
            expect((hint or "") in found.get("hint", "") and (hint is None) == ("hint" not in found), out)
            expect_equal(hint is None, messages == "")
            expect(os.path.exists(os.path.join(path, "o.png")), "a picture")
        for name, text, said in (("none.stl", "", "none.stl"), ("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "nan.obj:1"),
                                 ("missing.stl", None, "missing.stl")):
            if text is not None:
                with open(os.path.join(path, name), "w", encoding="ascii") as file:
                    file.write(text)
            status, out, messages = run(program.command("--backend", "memory", "sphere", "--audit", name), environment(),
                                        cwd=path)
            expect_equal((status, out, messages.count("\n")), (5, b"", 1))
            expect(messages.startswith("surfview: " + said), messages)


def lists_edges_that_are_off():
    """Hinges of two squares. The second one begins beside the first one's border, by 0 to 11 of 64."""
    program = Program("surfview", (97, 73))

    def off(hinge):
        return 5 * hinge % 12 / 64

    with folder() as path:
        with open(os.path.join(path, "hinges.obj"), "w", encoding="ascii") as file:
            file.write("vp 0 0\nvp 1 0\nvp 1 1\nvp 0 1\ncstype bspline\ndeg 1\n"
                       "curv2 1 2 3 4 1\nparm u 0 0 1 2 3 4 4\nend\ncstype bezier\ndeg 1 1\n")
            for i in range(12):
                corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 0, off(i)), (1, 0, off(i)), (0, 0, 1), (1, 0, 1)]
                file.writelines("v %g %g %g\n" % (x, y + 2 * i, z) for x, y, z in corners)
                for first in (1, 5):
                    file.write("surf 0 1 0 1 %d %d %d %d\nparm u 0 1\nparm v 0 1\ntrim 0 4 1\nend\n" %
                               tuple(8 * i + first + k for k in range(4)))
                file.write("con %d 0 1 1 %d 0 1 1\n" % (2 * i + 1, 2 * i + 2))
        command = program.command("--backend", "memory", "hinges.obj", "--list-edges")
        status, out, _ = run(command, environment(), cwd=path)
        expect_equal(status, 0)
        told = re.sub("not [0-9.]+e-1[6-9],", "not 0,", out.decode())  # how exact the edge of con is
        worst = sorted(range(12), key=lambda i: -off(i))[:10]
        expect_equal(told, "".join("edge %d: off by %s, not 0, at 0,%d,0, piece %d, piece %d\n" %
                                   (i + 1, off(i), 2 * i, 2 * i + 1, 2 * i + 2) for i in worst))


def tells_how_far_a_file_is(key):
    """A window of its own before the model's: its name, a percentage, an end by Escape or by q."""
    points = 300000  # which the kernel reads for a second at least
    with folder() as path:
        with open(os.path.join(path, "long.step"), "w", encoding="ascii") as file:
            file.write("ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n")
            file.writelines("#%d=CARTESIAN_POINT('',(%d.,0.,0.));\n" % (i + 1, i) for i in range(points))
            file.write("ENDSEC;\nEND-ISO-10303-21;\n")
        with x_server() as server, Shown(Program("surfview", (480, 64)), server, "--backend", "ximage", "long.step",
                                         cwd=path) as it:
            expect_equal(xdotool(server.display, "getwindowname", it.window).strip(), "long.step - surfview")
            it.await_picture(harness.has_picture, what="letters")
            it.press(key)
            it.expect_end(1, "surfview: long.step: reading was stopped\n")


def main():
    checks = Checks()
    for name in ("teapot", "house"):
        checks.run("surfview.%s.obeys_its_keys" % name, obeys_its_keys, name)
        checks.run("surfview.%s.obeys_the_mouse" % name, obeys_the_mouse, name)
    for check in (tells_a_view_that_is_seen_again, a_thousand_parts_stay_usable, refuses_what_is_no_section,
                  audits_a_mesh, lists_edges_that_are_off):
        checks.run("surfview." + check.__name__, check)
    for key in ("Escape", "q"):
        if os.path.exists(os.path.join(os.environ["L3D_BIN"], "..", "lib", "l3d", "libl3d_cad.so")):
            checks.run("surfview.tells_how_far_a_file_is.%s" % key, tells_how_far_a_file_is, key)
        else:
            checks.skip("surfview.tells_how_far_a_file_is.%s" % key, "no Open CASCADE")
    checks.finish()


if __name__ == "__main__":
    main()
