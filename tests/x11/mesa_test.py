#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The mesa back-end: with both of its libraries, with either and with none; and its pictures.

With --table it prints the table of docs/DISPLAYS.md: how many pixels of every program differ by GL."""

import array
import json
import os
import re
import shutil
import subprocess
import sys

import harness
import programs_test
from harness import Checks, Onlooker, environment, expect, expect_equal, folder, run, started
from harness import wait_for, window_of, x_server

SHARP = "--antialias", "off"  # GL does not smooth edges
SHADES = ("lambert", "gouraud", "flat", "normals", "error")
NAMES = {"egl": ("libEGL.so.1",), "osmesa": ("libOSMesa.so.8", "libOSMesa.so.6")}


def hidden(path, *libraries):
    """An environment in which these libraries are files that cannot be loaded."""
    for library in libraries:
        for name in NAMES[library]:
            with open(os.path.join(path, name), "w") as file:
                file.write("not a library\n")
    return environment(LD_LIBRARY_PATH=path)


def picture(program, env, *arguments, backend="mesa"):
    """Rows of colours of one frame."""
    with folder() as path:
        command = program.command("--backend", backend, "--output", "o.png", *arguments)
        status, _, messages = run(command, env, cwd=path)
        expect_equal((status, messages), (0, ""), arguments)
        return harness.read_png(os.path.join(path, "o.png"))


def differences(one, other):
    """For every pixel of two pictures of one size, the largest difference of a channel."""
    expect_equal((len(one), len(one[0])), (len(other), len(other[0])))
    return [
        0 if a == b else max(abs((a >> shift & 255) - (b >> shift & 255)) for shift in (0, 8, 16))
        for row, twin in zip(one, other)
        for a, b in zip(row, twin)
    ]


def above(levels, limit):
    """Which part of the pixels differs by more than that."""
    return sum(level > limit for level in levels) / len(levels)


# ---- which libraries are there ------------------------------------------------------------------


def links_with_neither(program):
    listed = subprocess.run(["ldd", program.command()[0]], stdout=subprocess.PIPE, check=True)
    found = re.findall(r"lib(?:EGL|OSMesa|GL|OpenGL|gallium|LLVM)\S*", listed.stdout.decode())
    expect_equal(found, [])


def serves_with(program, *libraries):
    """By the libraries that are there, whichever of them L3D_MESA names; else not, and says so."""
    with folder() as path:
        env = hidden(path, *(library for library in NAMES if library not in libraries))
        for wish in ("auto", "egl", "osmesa"):
            env["L3D_MESA"] = wish
            if libraries and (wish == "auto" or wish in libraries):
                expect(harness.has_picture(picture(program, env)), "one colour only")
                continue
            command = program.command("--backend", "mesa", "--output", "-")
            status, out, messages = run(command, env)
            expect_equal((status, out, messages.count("\n")), (4, b"", 1), messages)
            expect("install libegl1 libegl-mesa0 libgl1-mesa-dri or libosmesa6" in messages, wish)
            for library in NAMES:
                tried = wish in ("auto", library)
                expect_equal(messages.count(NAMES[library][0]), int(tried), messages)


def does_without(program):
    """Without the libraries every other back-end works, and the list says why this does not."""
    with folder() as path:
        env = hidden(path, *NAMES)
        expect(harness.has_picture(picture(program, env, backend="memory")), "one colour only")
        status, out, messages = run(program.command("--list-backends"), env)
        expect_equal((status, messages), (0, ""))
        lines = [line for line in out.decode().splitlines() if line.startswith("mesa")]
        expect_equal(len(lines), 3)
        for line, name in zip(lines, ("mesa", "mesa:egl", "mesa:osmesa")):
            expect(re.match(name + r" +no +no software GL; install libegl1 ", line), line)


def does_without_a_driver(program):
    """libEGL alone is not enough; OSMesa serves then."""
    env = environment(__EGL_VENDOR_LIBRARY_DIRS="/nonexistent")
    expect(harness.has_picture(picture(program, env)), "one colour only")
    command = program.command("--backend", "mesa", "--output", "-")
    status, _, messages = run(command, {**env, "L3D_MESA": "egl"})
    expect_equal(status, 4)
    expect("EGL surfaceless: no EGL_MESA_platform_surfaceless" in messages, messages)


def names_an_unknown_choice(program):
    command = program.command("--backend", "mesa", "--output", "-")
    status, _, messages = run(command, environment(L3D_MESA="vulkan"))
    expect_equal((status, messages.count("\n")), (4, 1), messages)
    expect("L3D_MESA: 'vulkan' is none of auto egl osmesa" in messages, messages)


def needs_no_environment(program):
    with folder() as path:
        command = program.command("--backend", "mesa", "--output", "o.png")
        expect_equal(run(command, {}, cwd=path), (0, b"", ""))


CARD = """
static int words[4];
static const unsigned char* get_string(unsigned name) {
    return (const unsigned char*)(name == 0x1F01 ? "GeForce 4711" : "4.6.0");
}
static void other(void) {}
void* OSMesaCreateContextExt(unsigned f, int d, int s, int a, void* c) { return words; }
void OSMesaDestroyContext(void* c) {}
unsigned char OSMesaMakeCurrent(void* c, void* w, unsigned t, int x, int y) { return 1; }
void* OSMesaGetCurrentContext(void) { return 0; }
void (*OSMesaGetProcAddress(const char* name))(void) {
    return __builtin_strcmp(name, "glGetString") ? other : (void (*)(void))get_string;
}
"""


def refuses_a_graphics_card(program):
    """A stand-in for the library, which says that it draws with a card."""
    compiler = next(filter(shutil.which, ("gcc", "clang", "cc")))
    with folder() as path:
        env = hidden(path, "egl")
        library = os.path.join(path, "libOSMesa.so.8")
        build = [compiler, "-shared", "-fPIC", "-xc", "-", "-o", library]
        subprocess.run(build, input=CARD.encode(), check=True)
        command = program.command("--backend", "mesa", "--output", "-")
        status, _, messages = run(command, env)
        expect_equal((status, messages.count("\n")), (4, 1), messages)
        expect("OSMesa: the renderer 'GeForce 4711' is not software" in messages, messages)


def tells_the_renderer(program):
    status, out, _ = run(program.command("--diagnose"), environment())
    expect_equal(status, 0)
    for way in ("EGL surfaceless", "EGL software device", "OSMesa"):
        expect(re.search(r"^ok +%s: llvmpipe" % way, out.decode(), re.M), way, out)
    _, out, _ = run(program.command("--diagnose"), environment(GALLIUM_DRIVER="softpipe"))
    expect(re.search(r"^ok +EGL surfaceless: softpipe$", out.decode(), re.M), out)


def goes_the_way_that_is_named(program):
    """By --backend, whatever the environment says; --verbose names the GL."""
    with folder() as path:
        for way, name in (("egl", "EGL surfaceless"), ("osmesa", "OSMesa")):
            env = environment(L3D_MESA="egl" if way == "osmesa" else "osmesa")
            command = program.command("--backend", "mesa:" + way, "--verbose", "--output", "o.png")
            status, _, messages = run(command, env, cwd=path)
            expect_equal(status, 0, messages)
            expect(re.search(r"^mesa:%s: GL by %s: llvmpipe" % (way, name), messages, re.M), messages)
        without = hidden(path, "osmesa")
        status, _, messages = run(program.command("--backend", "mesa:osmesa", "--output", "-"), without)
        expect_equal((status, messages.count("\n")), (4, 1), messages)
        expect("libOSMesa.so.8" in messages and "libEGL" not in messages, messages)


# ---- polygons -----------------------------------------------------------------------------------


def modelview_draws_by_the_backend():
    """At most 0.5 % of the pixels differ by more than a level: those at edges and where faces cross."""
    modelview = os.path.join(os.environ["L3D_BIN"], "modelview")
    with folder() as path:
        pictures = {}
        for backend, renderer in (("memory", None), ("mesa:egl", "EGL"), ("mesa:osmesa", "OSMesa"), ("mesa", "EGL")):
            command = [modelview, "--no-input", "--backend", backend, "--pipeline", "zbuffer", "--antialias", "off",
                       "--size", "320x240", "--report", "r.json", "--output", "o.png", "torus"]
            status, _, messages = run(command, environment(), cwd=path)
            expect_equal((status, messages), (0, ""))
            with open(os.path.join(path, "r.json")) as file:
                told = json.loads(file.readline()).get("renderer")
            expect(told.startswith("GL by " + renderer) if renderer else told is None, backend, told)
            pictures[backend] = harness.read_png(os.path.join(path, "o.png"))
        for backend, drawn in pictures.items():
            levels = differences(drawn, pictures["memory"])
            expect(above(levels, 1) <= 0.005, backend, above(levels, 1))


def tells_who_draws():
    """What GL cannot draw is refused or drawn by processors, with one line, and the report names no GL."""
    modelview = os.path.join(os.environ["L3D_BIN"], "modelview")
    with folder() as path:

        def said(*arguments):
            command = [modelview, "--backend", "mesa", "--frames", "2", "--size", "80x60", "--report", "r.json",
                       "--output", "o.png", *arguments]
            return run(command, environment(), cwd=path)

        lights = "--light", "1,1,1", "--light", "0,1,0"
        for arguments, is_gl in (((), True), (("--fog", "1,9"), False), (lights, False), (("--wireframe",), False)):
            status, out, messages = said(*arguments)
            told = ("modelview: processors draw these surfaces, not GL: it has one far light, and no highlights, fog or "
                    "pictures\n")
            is_told = not is_gl and arguments != ("--wireframe",)  # lines are GL's
            expect_equal((status, out, messages), (0, b"", told if is_told else ""), arguments)
            with open(os.path.join(path, "r.json")) as file:
                expect_equal("renderer" in json.loads(file.readline()), is_gl, arguments)
        status, _, messages = said("--pipeline", "zsort")
        expect_equal((status, messages), (2, "modelview: --pipeline zsort: processors paint polygons in order, and "
                                             "--backend mesa asks for GL, which --pipeline zbuffer has\n"))


# ---- every program ------------------------------------------------------------------------------

SIZE = 320, 240
WAYS = "mesa:egl", "mesa:osmesa"
VIEWERS = "gallery", "modelview", "nurbs", "surfview", "teapot_afd"


def every_program():
    """The name of each that draws, how it starts, and how it draws hard edges, if it does."""
    first = {}
    for row in programs_test.table():
        if not row.is_console:
            first.setdefault(row.name, row.arguments)
    for name, arguments in first.items():
        hard = ["--antialias", "off"] if name in VIEWERS else ["--classic"]
        yield name, arguments, None if name == "curves" else [*arguments, *hard]


def is_edge(rows, x, y):
    """Whether a pixel beside this one differs by more than 8 levels, as shades from pixel to pixel do not."""
    around = [rows[v][u] for v in range(max(y - 1, 0), min(y + 2, len(rows)))
              for u in range(max(x - 1, 0), min(x + 2, len(rows[0])))]
    return above(differences([around], [[rows[y][x]] * len(around)]), 8) > 0


def differing(name, arguments):
    """For either GL, how many pixels are more than a level off those of processors: at edges, and elsewhere."""
    program = harness.Program(name, SIZE)
    more = (*arguments, "--frames", str(programs_test.FRAMES))
    by_cpu, *by_gl = (picture(program, environment(L3D_FONT="built-in"), *more, backend=backend)
                      for backend in ("memory", *WAYS))
    for rows in by_gl:
        off = [i for i, level in enumerate(differences(rows, by_cpu)) if level > 1]
        at_edges = sum(is_edge(by_cpu, i % SIZE[0], i // SIZE[0]) for i in off)
        yield at_edges, len(off) - at_edges


def table_rows():
    for name, arguments, hard in every_program():
        cells = [differing(name, each) if each is not None else () for each in (arguments, hard)]
        yield name, [tuple(pairs) for pairs in cells]


def written(name, cells):
    """A row of docs/DISPLAYS.md: EGL's figures and OSMesa's, or both in one where they are the same."""
    texts = [" | ".join(" / ".join(str(n) for n in dict.fromkeys(of)) for of in zip(*pairs)) if pairs else "- | -"
             for pairs in cells]
    return "| `%s` | %s |" % (name, " | ".join(texts))


def every_program_draws_the_same_by_gl():
    """With hard edges, 1 % of the pixels may differ. Smooth ones differ where there is an edge: elsewhere
    0.1 % may, on dim edges. The document has a row for each program."""
    document = (programs_test.ROOT / "docs" / "DISPLAYS.md").read_text()
    pixels = SIZE[0] * SIZE[1]
    for name, (smooth, hard) in table_rows():
        expect(all(inside <= pixels / 1000 for _, inside in (*smooth, *hard)), name, smooth, hard)
        expect(all(edges <= pixels / 100 for edges, _ in hard), name, hard)
        expect("| `%s` | " % name in document.partition("## Mesa")[2], "docs/DISPLAYS.md has no row of", name)


# ---- the pictures -------------------------------------------------------------------------------


def draws_what_the_cpu_draws(program):
    """Points, lines and polygons are the same, word for word."""
    afd = "--wireframe", "--net", "--antialias", "off"
    more = afd if program.name == "teapot_afd" else ("--frames", "40")
    by_cpu = picture(program, environment(), *more, backend="memory")
    for way in NAMES:
        by_gl = picture(program, environment(L3D_MESA=way), *more)
        expect(by_gl == by_cpu, way, above(differences(by_gl, by_cpu), 0))


def is_a_second_opinion(program):
    """Surfaces: at most 2 % of the pixels differ by more than a level, 0.1 % by more than 16.

    The shade `error` shows how far the very picture is off, and GL's is another one: 5 and 1 %.
    """
    for shade in SHADES:
        by_cpu = picture(program, environment(), "--shade", shade, *SHARP, backend="memory")
        by_gl = picture(program, environment(), "--shade", shade, *SHARP)
        levels = differences(by_gl, by_cpu)
        some, few = (0.05, 0.01) if shade == "error" else (0.02, 0.001)
        expect(above(levels, 1) <= some, shade, above(levels, 1))
        expect(above(levels, 16) <= few, shade, above(levels, 16), max(levels))
        if shade == "lambert":  # where ambient light makes no surface black
            expect(harness.covered(by_gl) == harness.covered(by_cpu), "not the same outline")


def depths(program, backend):
    """What a PFM holds: distances, infinite where nothing is."""
    with folder() as path:
        outputs = ("--output", "o.png", "--depth-output", "d.pfm")
        command = program.command("--backend", backend, *outputs)
        expect_equal(run(command, environment(), cwd=path), (0, b"", ""))
        with open(os.path.join(path, "d.pfm"), "rb") as file:
            head = [file.readline() for _ in range(3)]
            expect_equal(head[0], b"Pf\n")
            return array.array("f", file.read())


def has_the_same_depth(program):
    """Quads of 0.25 pixels' tolerance are nearly flat: 1 % of the distance is a wide limit."""
    by_cpu, by_gl = depths(program, "memory"), depths(program, "mesa")
    expect_equal(len(by_gl), len(by_cpu))
    infinite = float("inf")
    expect(1000 < sum(d < infinite for d in by_gl) < len(by_gl) - 1000, "hardly a picture")
    for mine, other in zip(by_cpu, by_gl):
        expect((mine == infinite) == (other == infinite), mine, other)
        expect(mine == infinite or abs(other / mine - 1) < 0.01, mine, other)


def agrees_with_itself(program):
    """One level at most; on at most 0.01 % of the pixels by EGL and by OSMesa, 1 % by softpipe."""
    by_egl = picture(program, environment(L3D_MESA="egl"))
    for limit, other in ((0.0001, {"L3D_MESA": "osmesa"}), (0.01, {"GALLIUM_DRIVER": "softpipe"})):
        levels = differences(picture(program, environment(**other)), by_egl)
        expect(max(levels) <= 1, other, max(levels))
        expect(above(levels, 0) <= limit, other, above(levels, 0))


def shows_it_in_a_window(program):
    expected = picture(program, environment(), "--frames", "1")
    with x_server() as server, Onlooker(server.display) as eyes:
        counted = () if program.name == "drawdot" else harness.COUNTED
        command = program.command("--backend", "mesa", "--fps", "1", *counted)
        with started(command, environment(server.display)) as process:
            window = window_of(server.display, program)
            shown = lambda: eyes.picture(window, *program.size)
            if program.name == "drawdot":
                wait_for(lambda: harness.has_picture(shown()), "the dot")
            else:
                wait_for(lambda: shown() == expected, "the picture")
            harness.xdotool(server.display, "key", "q")
            expect_equal(harness.ended(process), (0, b"", ""))


if sys.argv[1:] == ["--table"]:
    for line in table_rows():
        print(written(*line), flush=True)
    sys.exit()
checks = Checks()
for each in harness.PROGRAMS:
    name = "_of_" + each.name
    checks.run("links_with_neither" + name, links_with_neither, each)
    for present in (("egl", "osmesa"), ("egl",), ("osmesa",), ()):
        called = "serves_with_" + ("_and_".join(present) or "neither")
        checks.run(called + name, serves_with, each, *present)
    for check in (
        does_without,
        does_without_a_driver,
        names_an_unknown_choice,
        needs_no_environment,
        refuses_a_graphics_card,
        tells_the_renderer,
        goes_the_way_that_is_named,
        draws_what_the_cpu_draws,
        shows_it_in_a_window,
    ):
        checks.run(check.__name__ + name, check, each)
    if each.name == "teapot_afd":
        for check in (is_a_second_opinion, has_the_same_depth, agrees_with_itself):
            checks.run(check.__name__ + name, check, each)
for check in (modelview_draws_by_the_backend, tells_who_draws, every_program_draws_the_same_by_gl):
    checks.run(check.__name__, check)
checks.finish()
