#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the viewers show: models of any size framed, keys and gestures, picks, empty pictures."""

import contextlib
import math
import os
import select

import harness
from harness import Checks, Onlooker, Program, environment, expect, expect_equal, folder, run
from harness import started, wait_for, window_of, x_server, xdotool

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
VIEWERS = ("teapot_afd", "modelview")
OLD_VIEW = ("--eye", "3.2,3.6,7.4", "--target", "0.2,1.3,0")


def draw(viewer, size, *arguments, cwd):
    command = Program(viewer, size).command("--backend", "memory", *arguments)
    return run(command, environment(), cwd=cwd)


# ---- framing ------------------------------------------------------------------------------------


def turned(degrees, axis):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    i, k = [a for a in range(3) if a != axis]

    def turn(p):
        q = list(p)
        q[i], q[k] = c * p[i] - s * p[k], s * p[i] + c * p[k]
        return q

    return turn


def scaled(x, y, z):
    return lambda p: [p[0] * x, p[1] * y, p[2] * z]


def moved(x, y, z):
    return lambda p: [p[0] + x, p[1] + y, p[2] + z]


MODELS = {
    "tiny": scaled(1e-7, 1e-7, 1e-7),
    "small": scaled(0.01, 0.01, 0.01),
    "large": scaled(300, 300, 300),
    "huge": scaled(1e9, 1e9, 1e9),
    "largest": scaled(2.8e11, 2.8e11, 2.8e11),
    "wide": scaled(20, 1, 1),
    "tall": scaled(1, 15, 1),
    "flat": scaled(1, 1, 0.001),
    "far-away": moved(5e4, -2e4, 7e5),
    "lying": turned(90, 0),
    "askew": turned(130, 1),
}


def teapot_as(change):
    """The text of the shipped teapot, changed point by point."""
    with open(os.path.join(ROOT, "data", "teapot.bpt"), encoding="ascii") as file:
        lines = file.read().split("\n")
    for index, line in enumerate(lines):
        words = line.split()
        if len(words) == 3:
            lines[index] = " ".join("%.17g" % number for number in change([float(w) for w in words]))
    return "\n".join(lines)


def share_of(rows):
    """The part of a picture's width or height that is covered, the larger one of the two, and
    whether anything is cut. What differs from the left end of its row counts as covered."""
    height, width = len(rows), len(rows[0])
    columns = [x for row in rows for x in range(width) if row[x] != row[0]]
    lines = [y for y, row in enumerate(rows) if any(word != row[0] for word in row)]
    expect(lines, "an empty picture")
    is_cut = max(columns) == width - 1 or lines[0] == 0 or lines[-1] == height - 1
    wide = (max(columns) - min(columns) + 1) / width
    tall = (lines[-1] - lines[0] + 1) / height
    return max(wide, tall), is_cut


def frames_any_model():
    with folder() as path:
        for name, change in MODELS.items():
            with open(os.path.join(path, name + ".bpt"), "w", encoding="ascii") as file:
                file.write(teapot_as(change))
            for viewer in VIEWERS:
                for size in ((160, 120), (100, 300), (300, 100)):
                    said = draw(viewer, size, name + ".bpt", "--output", "o.png", cwd=path)
                    expect_equal(said, (0, b"", ""), viewer)
                    share, is_cut = share_of(harness.read_png(os.path.join(path, "o.png")))
                    expect(0.6 <= share <= 0.95 and not is_cut, viewer, name, size, share, is_cut)


def frames_the_teapot_where_it_was_cut():
    with folder() as path:
        for viewer in VIEWERS:
            expect_equal(draw(viewer, (300, 900), "--output", "o.png", cwd=path), (0, b"", ""))
            share, is_cut = share_of(harness.read_png(os.path.join(path, "o.png")))
            expect(0.6 <= share <= 0.95 and not is_cut, viewer, share, is_cut)


def keeps_the_teapots_own_view():
    with folder() as path:
        for size in ((640, 480), (1024, 768), (97, 73)):
            draw("teapot_afd", size, "--output", "a.png", cwd=path)
            draw("teapot_afd", size, *OLD_VIEW, "--output", "b.png", cwd=path)
            with open(os.path.join(path, "a.png"), "rb") as a, open(os.path.join(path, "b.png"), "rb") as b:
                expect(a.read() == b.read(), size)


def looks_through_a_files_camera():
    """As by options: the lens of 18 mm sees 90 degrees of the width, and a picture's height in proportion."""
    with open(os.path.join(ROOT, "data", "thing.asc"), encoding="ascii") as file:
        scene = file.read()
    scene += 'Named object: "Side"\nCamera (18mm)\nPosition: X:300 Y:60 Z:90\nTarget: X:30 Y:60 Z:70\n'
    with folder() as path:
        with open(os.path.join(path, "scene.asc"), "w", encoding="ascii") as file:
            file.write(scene)
        fov = "%.15g" % math.degrees(2 * math.atan(120 / 160))
        by_options = ("--eye", "300,60,90", "--target", "30,60,70", "--up", "0,0,1")

        def picture(*arguments):
            status, _, said = draw("modelview", (160, 120), "scene.asc", *arguments, "--output", "o.png", cwd=path)
            expect_equal((status, said), (0, "scene.asc:1: ambient light is skipped\n"), arguments)
            return harness.read_png(os.path.join(path, "o.png"))

        by_file = picture("--file-camera", "Side")
        expect(harness.has_picture(by_file), "nothing is seen")
        expect(by_file == picture(*by_options, "--fov", fov), "not the camera's view")
        own_eye = picture("--file-camera", "Side", "--eye", "300,-60,90", "--fov", "50")
        expect(own_eye == picture(*by_options, "--eye", "300,-60,90", "--fov", "50"), "options do not come first")
        for arguments, why in (
            (("scene.asc", "--file-camera", "Top"), "is no camera of scene.asc, which has 'Side'"),
            (("torus", "--file-camera", "Top"), "is no camera of torus, which has none"),
            (("--file-camera", "Top"), "is sought in a FILE, and none is given"),
        ):
            said = draw("modelview", (80, 60), *arguments, "--output", "o.png", cwd=path)
            expect_equal(said, (2, b"", "modelview: --file-camera: 'Top' " + why + "\n"))


def says_at_a_terminal_what_it_reads():
    """A pipe gives half of a model, and the rest after the terminal has shown two lines; then these are gone."""
    with open(os.path.join(ROOT, "data", "thing.asc"), encoding="ascii") as file:
        scene = file.read()
    with folder() as path:
        os.mkfifo(os.path.join(path, "slow.asc"))
        master, slave = os.openpty()
        command = Program("modelview", (80, 60)).command("--backend", "memory", "slow.asc", "--output", "o.png")
        text = ""

        def has_told(what):
            nonlocal text
            while select.select([master], [], [], 0)[0]:
                text += os.read(master, 4096).decode()
            return what in text

        with started(command, environment(), cwd=path, stderr=slave) as process:
            with open(os.path.join(path, "slow.asc"), "w", encoding="ascii") as pipe:
                pipe.write(scene[:500])
                pipe.flush()
                wait_for(lambda: has_told("reading slow.asc, 1 s"), "a line")
                pipe.write(scene[500:])
            expect_equal(process.wait(harness.PATIENCE), 0)
            has_told("")
        os.close(slave)
        os.close(master)
        expect(text.startswith("\r\x1b[Kreading slow.asc\r\x1b[Kreading slow.asc, 1 s"), text)
        expect(text.endswith(" s\r\x1b[Kslow.asc:1: ambient light is skipped\r\n"), text)


# ---- empty pictures and picks -------------------------------------------------------------------


def says_why_a_picture_is_empty():
    cases = (
        (("--eye", "0,0,9", "--target", "0,0,20"), "behind the eye", "leave out --eye"),
        (("--eye", "0,0,9", "--target", "9,0,9"), "outside of the picture", "leave out --eye"),
        (("--eye", "0,0,9e5", "--target", "0,0,0"), "smaller than a pixel", "leave out --eye"),
        (("--far", "2"), "beyond the far plane", "leave out --near and --far"),
        (("--near", "1000"), "nearer than the near plane", "leave out --near and --far"),
    )
    with folder() as path:
        for viewer in VIEWERS:
            for arguments, why, mend in cases:
                status, out, said = draw(viewer, (80, 60), *arguments, "--output", "o.png", cwd=path)
                expect_equal((status, out, said.count("\n")), (0, b"", 1), why)
                wanted = viewer + ": the picture is empty, as the model is " + why + "; " + mend
                expect(said.startswith(wanted), said)


def flat_model(path, name):
    """A model that has something to draw, and no area: a patch or faces on one line. Its name."""
    texts = {
        "line.bpt": "1\n3 3\n" + "0 0 0\n0.3333333333333333 0.1 0\n0.6666666666666666 0.2 0\n1 0.3 0\n" * 4,
        "point.bpt": "1\n3 3\n" + "1 2 3\n" * 16,
        "faces.obj": "v 0 0 0\nv 1 0 0\nv 0 0 0\nf 1 1 1\nf 1 2 3\n",
    }
    with open(os.path.join(path, name), "w", encoding="ascii") as file:
        file.write(texts[name])
    return name


def says_that_a_model_has_no_area():
    """No view and no option shows it, so none is recommended."""
    empty = ": the picture is empty, as the model is without any area\n"
    with folder() as path:
        for viewer, name, *more in (
            ("teapot_afd", "line.bpt"), ("teapot_afd", "point.bpt"), ("modelview", "line.bpt", "--pipeline", "afd"),
            ("modelview", "faces.obj"), ("modelview", "faces.obj", "--one-sided"),
        ):
            said = draw(viewer, (80, 60), flat_model(path, name), *more, "--output", "o.png", cwd=path)
            expect_equal(said, (0, b"", viewer + empty), " ".join((name, *more)))
        for name in ("line.bpt", "point.bpt"):
            said = draw("modelview", (80, 60), "--pipeline", "zbuffer", name, "--output", "o.png", cwd=path)
            expect_equal(said, (5, b"", "modelview: " + name + ": no polygons, and patches without any area\n"))
        said = draw("teapot_afd", (80, 60), "line.bpt", "--wireframe", "--output", "o.png", cwd=path)
        expect_equal(said, (0, b"", ""), "its lines are seen")
        said = draw("modelview", (80, 60), "faces.obj", "--one-sided", "--explain", "--output", "o.png", cwd=path)[2]
        expect("2 of 2 triangles (back): the eye lies behind the planes of their faces, or these have no area" in said,
               said)


def says_that_no_view_shows_a_tiny_model():
    """An eye may be 1e-32 from its target, and no nearer. What is larger is framed."""
    empty = ": the picture is empty, as the model is "
    with folder() as path:
        for length, why in ((1e-40, "too small for any view, whose eye is 1e-32 away at least"),
                            (1e-30, "smaller than a pixel; leave out --eye and --target, or press f in a window")):
            with open(os.path.join(path, "tiny.bpt"), "w", encoding="ascii") as file:
                print("1\n3 3", file=file)
                for i in range(16):
                    print(i % 4 / 3 * length, i // 4 / 3 * length, 0, file=file)
            for viewer, *more in (("teapot_afd",), ("modelview",), ("modelview", "--parallel")):
                def said(*eye):
                    return draw(viewer, (80, 60), "tiny.bpt", *more, *eye, "--output", "o.png", cwd=path)

                expect_equal(said("--eye", "0,0,9", "--target", "0,0,0"), (0, b"", viewer + empty + why + "\n"))
                expect_equal(said(), (0, b"", "" if length == 1e-30 else viewer + empty + why + "\n"))


def says_nothing_of_a_small_model_that_is_seen():
    with folder() as path:
        for viewer in VIEWERS:
            said = draw(viewer, (1, 1), "--background", "0,0,0", "--output", "o.png", cwd=path)
            expect_equal(said, (0, b"", ""), viewer)
            expect(harness.read_png(os.path.join(path, "o.png"))[0][0] & 0xFFFFFF, "a black pixel")


def shows_models_on_a_gradient():
    """Files and windows alike, from dark above to light below; a colour of the user's is in its place."""
    top, bottom = 0x333B46, 0x707A86
    with folder() as path:
        for viewer in VIEWERS:
            for more, ends in (((), (top, bottom)), (("--background", "0,0,255"), (255, 255))):
                said = draw(viewer, (80, 60), *more, "--output", "o.png", cwd=path)
                expect_equal(said, (0, b"", ""), (viewer, *more))
                rows = harness.read_png(os.path.join(path, "o.png"))
                expect_equal((rows[0][0], rows[-1][0]), ends, (viewer, *more))
                expect(harness.has_picture(rows), "no model", viewer, more)


def shows_both_sides():
    """A sheet has the same picture from the side that it turns to the eye and from the other, unless one is left out."""
    with folder() as path:
        for pipeline in ("zbuffer", "zsort", "mesa"):
            pictures = []
            for corners, is_back in (("0 1 2", True), ("0 2 1", False)):
                with open(os.path.join(path, "sheet.off"), "w", encoding="ascii") as file:
                    file.write("OFF\n3 1 0\n0 0 0\n0 1 0\n1 0 0\n3 " + corners + "\n")
                command = ("modelview", (80, 60), "sheet.off", "--pipeline", pipeline, "--output", "o.png")
                expect_equal(draw(*command, cwd=path), (0, b"", ""), is_back)
                pictures.append(harness.read_png(os.path.join(path, "o.png")))
                empty = ("modelview: the picture is empty, as the model is turning its back; leave out --one-sided, "
                         "or press b in a window\n")
                expect_equal(draw(*command, "--one-sided", cwd=path), (0, b"", empty if is_back else ""), pipeline)
            expect_equal(pictures[0], pictures[1], pipeline)
            expect(harness.has_picture(pictures[0]), "a black picture", pipeline)


def shows_a_whole_teapot_from_behind():
    """Half of its patches turn the other way: its polygons are where its patches are."""
    behind = ("--eye", "-4,4,-8", "--target", "0,1.3,0", "--antialias", "off", "--background", "0,0,0")
    with folder() as path:
        shown = {}
        for pipeline in ("afd", "zbuffer", "zsort"):
            draw("modelview", (240, 180), "--pipeline", pipeline, *behind, "--output", "o.png", cwd=path)
            rows = harness.read_png(os.path.join(path, "o.png"))
            shown[pipeline] = {(x, y) for y, row in enumerate(rows) for x, word in enumerate(row) if word & 0xFFFFFF}
        for pipeline in ("zbuffer", "zsort"):
            missing = len(shown["afd"] ^ shown[pipeline])
            expect(missing * 100 < len(shown["afd"]), pipeline, missing, "of", len(shown["afd"]))


def lights_every_side():
    """The light goes with the eye. One that --light places stays, and so does that of --headlight off."""
    behind = ("--eye", "-4,4,-8", "--target", "0,1.3,0", "--background", "0,0,0")
    with folder() as path:
        def dark(viewer, *more):
            said = draw(viewer, (240, 180), *behind, *more, "--output", "o.png", cwd=path)
            expect_equal(said, (0, b"", ""), (viewer, *more))
            rows = harness.read_png(os.path.join(path, "o.png"))
            levels = [word >> 8 & 255 for row in rows for word in row if word & 0xFFFFFF]
            return sum(level <= 26 for level in levels) / len(levels)

        for viewer, *more in (("teapot_afd",), ("modelview",), ("modelview", "--pipeline", "zsort")):
            expect(dark(viewer, *more) < 0.1, viewer, more, dark(viewer, *more))
            for other in (("--headlight", "off"), ("--light", "0.4,0.8,0.45")):
                expect(dark(viewer, *more, *other) > 0.5, viewer, more, other, dark(viewer, *more, *other))
        said = draw("teapot_afd", (80, 60), "--headlight", "on", "--light", "1,0,0", "--output", "o.png", cwd=path)
        expect_equal(said, (2, b"", "teapot_afd: --light: nothing is seen of it beside --headlight on, the only "
                                    "light\n"))


def picks_from_the_command_line():
    with folder() as path:
        names = {
            "teapot_afd": ["patch", "part", "u", "v", "point", "depth", "normal", "gaussian-curvature",
                           "mean-curvature", "proven"],
            "modelview": ["face", "part", "vertices", "weights", "point", "normal"],
        }
        for viewer in VIEWERS:
            for place in ("320,260", "320.25,260.75"):
                status, out, said = draw(viewer, (640, 480), *OLD_VIEW, "--pick", place, cwd=path)
                expect_equal((status, said), (0, ""))
                lines = out.decode().splitlines()
                expect_equal([line.split()[0] for line in lines], names[viewer])
                point = next(line for line in lines if line.startswith("point ")).split()
                expect_equal(point[4], "+-")
                expect(float(point[5]) < 1e-9, point)
            expect_equal(draw(viewer, (640, 480), "--pick", "1,1", cwd=path), (0, b"nothing there\n", ""))
            for wrong in ("1", "1,2,3", "1,x", "nan,3"):
                status, out, said = draw(viewer, (64, 48), "--pick", wrong, cwd=path)
                expect_equal((status, out), (2, b""), wrong)
                expect(said.startswith(viewer + ": --pick: '" + wrong + "' is not two numbers X,Y"), said)
            for outside in ("999,999", "65,1", "1,48.5", "-1,1"):
                said = draw(viewer, (64, 48), "--pick=" + outside, cwd=path)
                expect_equal(said, (2, b"", viewer + ": --pick: '" + outside + "' is outside of the picture, 64x48\n"))


# ---- keys and gestures --------------------------------------------------------------------------


class Window:
    """A viewer in a window, and what is in it."""

    def __init__(self, stack, viewer, *arguments, size=(157, 119)):
        self.program = Program(viewer, size)
        self.size = self.program.size
        self.display = stack.enter_context(x_server()).display
        self.eyes = stack.enter_context(Onlooker(self.display))
        command = self.program.command("--backend", "ximage", *arguments)
        self.process = stack.enter_context(started(command, environment(self.display)))
        self.window = window_of(self.display, self.program)
        wait_for(lambda: harness.has_picture(self.picture()), "the first picture")

    def picture(self):
        return self.eyes.picture(self.window, *self.size)

    def does(self, what, *arguments):
        """Sends keys or gestures, and returns the picture that follows, a different one."""
        before = self.picture()
        xdotool(self.display, *arguments)
        wait_for(lambda: self.picture() != before, "a change by " + what)
        return self.picture()

    def at(self, x, y):
        return ("mousemove", "--window", self.window, x, y)

    def drag(self, button, *keys):
        held = [word for key in keys for word in ("keydown", key)]
        free = [word for key in keys for word in ("keyup", key)]
        there = (*self.at(70, 60), *held, "mousedown", button, *self.at(95, 48), "mouseup", button)
        return self.does("a drag with button %d" % button, *there, *free)

    def end(self):
        xdotool(self.display, "key", "Escape")
        expect_equal(harness.ended(self.process), (0, b"", ""))


def obeys_every_key_of_the_view():
    for viewer in VIEWERS:
        with contextlib.ExitStack() as stack:
            it = Window(stack, viewer)
            it.does("f", "key", "f")  # a key ends the line that names h
            first = it.does("r", "key", "r")
            for key in ("f", "1", "ctrl+1", "3", "ctrl+3", "7", "ctrl+7", "9", "Left", "Prior"):
                it.does(key, "key", key)
            xdotool(it.display, "key", "r")
            wait_for(lambda: it.picture() == first, "the first view again")
            it.end()


def obeys_every_gesture():
    for viewer in VIEWERS:
        with contextlib.ExitStack() as stack:
            it = Window(stack, viewer)
            it.drag(1)
            it.drag(2)
            it.drag(1, "shift")
            it.drag(3)
            it.does("the wheel", *it.at(60, 50), "click", 4)
            it.does("the wheel", "click", 5, "click", 5)
            it.does("a double click", *it.at(90, 62), "click", "--repeat", 2, "--delay", 30, 1)
            it.does("a click with Ctrl", "keydown", "ctrl", *it.at(70, 60), "click", 1)
            it.does("a second one", *it.at(80, 62), "click", 1, "keyup", "ctrl")
            it.end()


def tells_the_view_as_options():
    """The key g prints options that show the same picture again, whatever has moved, turned or zoomed it."""
    keys_of = {"teapot_afd": ("Left", "Left", "Up", "Prior"), "modelview": ("x", "Y", "v", "Down", "Next")}
    for viewer in VIEWERS:
        with contextlib.ExitStack() as stack:
            it = Window(stack, viewer, "--background", "0,0,0")
            it.does("f", "key", "f")
            it.drag(1)
            it.drag(3)
            for key in keys_of[viewer]:
                it.does(key, "key", key)
            it.does("g", "key", "g")
            said = it.process.stderr.readline().decode()
            expect(said.startswith("--eye "), said)
            again = harness.memory_picture(it.program, "--background", "0,0,0", *said.split())
            xdotool(it.display, "key", "j")  # a key that nobody has ends the line in the window
            wait_for(lambda: it.picture() == again, "the picture of " + said)
            it.end()


def marks_what_is_chosen():
    """Places that are clicked on get rings, and a part its borders: in a colour that is in no picture."""
    mark = 0xFFD873
    with contextlib.ExitStack() as stack:
        it = Window(stack, "teapot_afd", "--background", "0,0,0", size=(640, 480))

        def marked():
            return {(x, y) for y, row in enumerate(it.picture()[:400]) for x, word in enumerate(row) if word == mark}

        def around(x, y):
            return {(x0, y0) for x0, y0 in marked() if abs(x0 - x) <= 6 and abs(y0 - y) <= 6}

        it.does("f", "key", "f")
        it.does("r", "key", "r")
        expect_equal(marked(), set(), "before")
        it.does("a click with Ctrl", "keydown", "ctrl", *it.at(300, 240), "click", 1)
        wait_for(lambda: around(300, 240) and around(300, 240) == marked(), "a ring")
        it.does("a second one", *it.at(360, 260), "click", 1, "keyup", "ctrl")
        wait_for(lambda: around(360, 260) and around(330, 250), "a ring, and a line to the first")
        xdotool(it.display, "key", "j")
        wait_for(lambda: not marked(), "no marks after a key")
        it.does("e", "key", "e")
        wait_for(lambda: len(marked()) > 100, "the borders of a part")
        xdotool(it.display, "key", "j")
        wait_for(lambda: not marked(), "no borders after a key")
        it.end()


def has_one_name_in_its_title():
    """Not "gallery - gallery"; a model's name comes first."""
    # A server begins anew when its last client goes, and may lose the next one's first key.
    for name, arguments, title in (("gallery", (), "gallery"), ("teapot_afd", (), "Utah teapot - teapot_afd")):
        program = Program(name, (157, 119))
        with x_server() as server, started(program.command("--backend", "ximage", *arguments),
                                           environment(server.display)) as process:
            window = window_of(server.display, program)
            wait_for(lambda: xdotool(server.display, "getwindowname", window).strip() == title, title)
            xdotool(server.display, "key", "--window", window, "q")
            harness.ended(process)


def frames_a_flat_model_from_its_front():
    """It has no depth there, and is framed by its width and height."""
    for viewer in VIEWERS:
        with contextlib.ExitStack() as stack:
            file = os.path.join(stack.enter_context(folder()), "flat.bpt")
            with open(file, "w", encoding="ascii") as out:
                print("1\n3 3", *("%r %r 0" % (i % 4 * 1e-3, i // 4 * 1e-3) for i in range(16)), sep="\n", file=out)
            it = Window(stack, viewer, file)
            it.does("f", "key", "f")
            it.does("1", "key", "1")
            xdotool(it.display, *it.at(78, 59), "click", "--repeat", 9, 5)
            wait_for(lambda: share_of(it.picture())[0] < 0.5, "the sheet from farther away")
            xdotool(it.display, "key", "f")
            wait_for(lambda: 0.6 <= share_of(it.picture())[0] <= 0.97, "the whole sheet")
            it.end()


def keeps_the_model_in_a_window_of_another_size():
    for viewer in VIEWERS:
        with contextlib.ExitStack() as stack:
            it = Window(stack, viewer)
            for size in ((120, 400), (400, 120), (157, 119)):
                xdotool(it.display, "windowsize", "--sync", it.window, *size)
                it.size = size

                def fits():
                    rows = it.picture()
                    if not harness.has_picture(rows):
                        return False
                    share, is_cut = share_of(rows)
                    return 0.6 <= share <= 0.97 and not is_cut

                wait_for(fits, "the whole model at %dx%d" % size)
            it.end()


def says_in_the_window_that_it_is_empty():
    with contextlib.ExitStack() as stack:
        program = Program("teapot_afd", (640, 200))
        display = stack.enter_context(x_server()).display
        eyes = stack.enter_context(Onlooker(display))
        command = program.command("--backend", "ximage", "--eye", "0,0,9", "--target", "0,0,20")
        process = stack.enter_context(started(command, environment(display)))
        window = window_of(display, program)
        text = lambda: eyes.picture(window, *program.size)
        wait_for(lambda: harness.has_picture(text()), "a line of text")
        said = text()
        xdotool(display, "key", "f")
        wait_for(lambda: text() != said, "the model after f")
        xdotool(display, "key", "Escape")
        expect_equal(harness.ended(process), (0, b"", ""))


def main():
    checks = Checks()
    for check in (
        frames_any_model, frames_the_teapot_where_it_was_cut, keeps_the_teapots_own_view,
        looks_through_a_files_camera, says_at_a_terminal_what_it_reads,
        says_why_a_picture_is_empty, says_that_a_model_has_no_area,
        says_that_no_view_shows_a_tiny_model, says_nothing_of_a_small_model_that_is_seen,
        shows_models_on_a_gradient,
        shows_both_sides, shows_a_whole_teapot_from_behind, lights_every_side, picks_from_the_command_line,
        obeys_every_key_of_the_view, tells_the_view_as_options, marks_what_is_chosen, has_one_name_in_its_title,
        obeys_every_gesture, keeps_the_model_in_a_window_of_another_size, frames_a_flat_model_from_its_front,
        says_in_the_window_that_it_is_empty,
    ):
        checks.run("view " + check.__name__, check)
    checks.finish()


if __name__ == "__main__":
    main()
