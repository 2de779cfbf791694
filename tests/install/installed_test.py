#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What `make install` has put into the folder that is named, moved elsewhere, is all one needs: the
examples of README, docs/BOOK.md, docs/TUTORIAL.md and apps/drawdot are built with it, linked in every way, and run."""

import concurrent.futures
import hashlib
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

INSTALLED = pathlib.Path(sys.argv[1]).resolve()
ROOT = pathlib.Path(__file__).resolve().parents[2]
# The same place each time: a compiler's cache then knows the programs that are built there.
MOVED = pathlib.Path(tempfile.gettempdir(), "l3d_moved_%d_%s" % (
    os.getuid(), hashlib.sha256(bytes(INSTALLED)).hexdigest()[:8]))
os.environ["L3D_BIN"] = str(MOVED / "bin")
sys.path.insert(0, str(ROOT / "tests" / "x11"))

import pty_screen
from harness import (Checks, Onlooker, covered, expect, expect_equal, has_picture, read_png, wait_for, x_server,
                     xdotool)

TUTORIAL = (ROOT / "docs" / "TUTORIAL.md").read_text()
README = (ROOT / "README.md").read_text()
BOOK = (ROOT / "docs" / "BOOK.md").read_text()
REALS = {"float": "l3d", "fixed": "l3d-fixed"}
WAYS = ("shared", "static")
MOST_LINES = {"teapot.cpp": 16, "dot.cpp": 25, "spin.cpp": 40, "even.cpp": 110, "terminal.h": 120,
              "three.cpp": 36, "vase.cpp": 27, "arrow.cpp": 24, "turn.cpp": 34, "chart.cpp": 49,
              "heights.cpp": 24, "thumbs.cpp": 30, "xloop.cpp": 38}
# What a file needs beside the tutorial's line.
LINKS_MORE = {"xloop": " -lX11"}
WORKERS = os.cpu_count()
# A pipeline, a surface method and a back-end of one's own, and GLM.
BY_CMAKE = ("dot", "even", "ring", "terminal_spin")


def environment():
    kept = {name: value for name, value in os.environ.items()
            if not name.startswith("L3D_") and name != "DISPLAY"}
    # A file that pkg-config finds elsewhere than its prefix says has been moved with its prefix.
    return {**kept, "PKG_CONFIG_PATH": str(MOVED / "lib" / "pkgconfig"),
            "PATH": "%s:%s" % (MOVED / "tools", os.environ["PATH"]),
            "LD_LIBRARY_PATH": str(MOVED / "lib")}


def run(command, folder, status=0):
    # A static library does not know where its plug-ins lie once the installation has moved.
    plugins = {"L3D_PLUGIN_PATH": str(MOVED / "lib" / "l3d")} if str(folder).endswith("-static") else {}
    done = subprocess.run(command, cwd=folder, env=environment() | plugins, shell=isinstance(command, str),
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=300)
    if status is not None:
        expect_equal(done.returncode, status, "%s: %s" % (command, done.stderr))
    return done


# ---- the tutorial -------------------------------------------------------------------------------


def blocks():
    """The files that README, BOOK and the tutorial print, by the names in their first lines."""
    found = re.findall(r"^```cpp\n(// ([\w.]+): .*?)^```", README + BOOK + TUTORIAL, re.M | re.S)
    return {name: text for text, name in found}


def shown(beginning):
    """The indented command lines that begin so."""
    return [line.strip() for line in TUTORIAL.splitlines() if line.startswith("    " + beginning)]


def build_line(way):
    lines = [line for line in shown("c++ ") if "dot.cpp" in line]
    expect_equal(len(lines), 2, "lines that build:")
    return lines[way == "static"]


def sources(folder):
    for name, text in blocks().items():
        (folder / name).write_text(text)
    run(re.search(r"^```sh\n(.*?)^```", TUTORIAL, re.M | re.S)[1], folder)
    shutil.copy(ROOT / "apps" / "drawdot" / "main.cpp", folder / "drawdot.cpp")
    return sorted(path.stem for path in folder.glob("*.cpp") if "l3d_plugin_interface" not in path.read_text())


def for_real(line, real):
    return line if real == "float" else line.replace(" l3d", " l3d-fixed").replace(
        "-ll3d/-l:libl3d.a", "-ll3d-fixed/-l:libl3d-fixed.a")


def compile_one(folder, name, real):
    """The tutorial's line up to an object, which both ways of linking share."""
    line = build_line("shared").replace("dot.cpp -o dot", "-Wall -Wextra -Werror -MD -c %s.cpp -o %s.%s.o" %
                                        (name, name, real))
    run(for_real(line, real), folder)
    used = (folder / ("%s.%s.d" % (name, real))).read_text().replace("\\\n", " ").split()
    inside = [file for file in used if file.startswith(str(ROOT) + "/")]
    expect_equal(inside, [], "files of the source tree:")


def link_one(folder, name, real, way):
    target = "%s/%s" % (place(folder, real, way).name, name)
    run(for_real(build_line(way).replace("dot.cpp -o dot", "%s.%s.o -o %s" % (name, real, target)),
                 real) + LINKS_MORE.get(name, ""), folder)


def place(folder, real, way):
    made = folder / ("%s-%s" % (real, way))
    made.mkdir(exist_ok=True)
    return made


# ---- what is installed --------------------------------------------------------------------------


def library_exports_ours_only(name):
    library = MOVED / "lib" / ("lib%s.so" % name)
    dynamic = run(["readelf", "-d", str(library)], MOVED).stdout
    expect("Library soname: [lib%s.so.0]" % name in dynamic, "SONAME", dynamic)
    expect("RPATH" not in dynamic and "RUNPATH" not in dynamic, dynamic)
    symbols = run(["nm", "-D", "--defined-only", "-f", "posix", str(library)], MOVED).stdout
    names = [line.split()[0] for line in symbols.splitlines()]
    ours = re.compile(r"(_Z(T[VIST]|GV|Thn?\d+_)?N?K?\d+)?l3d_")
    expect(len(names) > 500, "only %d exported" % len(names))
    expect_equal([name for name in names if not ours.match(name)], [])
    expect_equal([name for name in names if "10l3d_detail" in name[:20]], [])


def library_exports_the_listed_names(name):
    """Programs may use each: one that is gone breaks them, and one that came shall stay."""
    library = MOVED / "lib" / ("lib%s.so" % name)
    found = run([str(ROOT / "packaging" / "exported_names.sh"), str(library)], MOVED).stdout.splitlines()
    listed = (ROOT / "packaging" / "exported" / name).read_text().splitlines()
    gone, come = sorted(set(listed) - set(found)), sorted(set(found) - set(listed))
    expect(not gone and not come, "gone:", gone, "come:", come, "- `make exported` lists them anew")


def public_headers():
    listed = [line for line in (ROOT / "packaging" / "public_headers").read_text().split("\n")
              if line and not line.startswith("#")]
    return sorted(["l3d.h"] + [pathlib.Path(line).name for line in listed])


def headers_are_the_listed_ones():
    installed = [str(path.relative_to(MOVED / "include")) for path in (MOVED / "include").rglob("*")
                 if path.is_file()]
    expect_equal(sorted(installed), ["l3d/" + name for name in public_headers()])


def headers_stand(folder, ordered):
    """In either order, beside a user's own headers of the names that ours have inside. `make headers`
    compiles each alone."""
    source = folder / "all.cpp"
    source.write_text("".join("#include <l3d/%s>\n" % name for name in ordered))
    run("c++ -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I. %s $(pkg-config --cflags l3d)" % source.name,
        folder)


def includes_public_headers_only(name):
    included = re.findall(r"^#include ([<\"].*[>\"])", (MOVED / "include" / "l3d" / name).read_text(), re.M)
    inside = [file for file in included if file.startswith('"')
              or file.startswith("<l3d/") and file[5:-1] not in public_headers()]
    expect_equal(inside, [], "private headers:")


def users_own_headers(folder):
    for name in (ROOT / "packaging" / "public_headers").read_text().split():
        own = folder / name
        own.parent.mkdir(parents=True, exist_ok=True)
        own.write_text("#error \"a user's own\"\n")


def needs_cxx20():
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "old.cpp").write_text("#include <l3d/l3d.h>\n")
        done = run("c++ -std=c++17 -fsyntax-only old.cpp $(pkg-config --cflags l3d)", folder, None)
        expect(done.returncode != 0 and "l3d needs C++20" in done.stderr, done.stderr)


def is_told_who_needs_it(real):
    """A program's own line has nothing of what the library alone includes."""
    flags = run(["pkg-config", "--cflags", REALS[real]], MOVED).stdout.split()
    expect_equal(flags, ["-I%s/include" % MOVED, "-DL3D_REAL_" + real.upper()])
    linked = run(["pkg-config", "--libs", REALS[real]], MOVED).stdout.split()
    expect_equal(linked, ["-L%s/lib" % MOVED, "-l" + REALS[real]])


def packed_as(path):
    """Where a package has an installed file: /usr, and libraries in the folder of their architecture."""
    name = path.relative_to(MOVED).as_posix()
    is_of_architecture = name.startswith("lib/") and not re.match("lib/l3d/(?!libl3d_)", name)
    return pathlib.PurePosixPath("usr/lib/x-linux-gnu/" + name[4:] if is_of_architecture else "usr/" + name)


def packages_share_out_all_files():
    """Each installed file is in one package, and each line that fills a package finds something. The module for
    Python is installed by another command, and a plug-in is there if its library is. README names all packages."""
    debian = ROOT / "packaging" / "debian"
    files = [packed_as(path) for path in MOVED.rglob("*") if not path.is_dir() and path.parent != MOVED / "tools"]
    lines = [(lists.stem, line.split()[0]) for lists in [*debian.glob("*.install"), debian / "not-installed"]
             for line in lists.read_text().splitlines() if "/python3/" not in line]
    takers = {file: [] for file in files}
    for package, line in lines:
        found = [file for file in files if any(place.match(line) for place in (file, *file.parents))]
        if not found:
            expect("/libl3d_" in line, package, "finds no", line)
        for file in found:
            takers[file].append(package)
    expect_equal({str(file): by for file, by in takers.items() if len(set(by)) != 1}, {})
    named = re.findall("^Package: (.*)", (debian / "control").read_text(), re.M)
    told = (ROOT / "packaging" / "README.md").read_text()
    expect_equal([package for package in named if "`%s`" % package not in told], [])


def documents_are_there():
    documents = MOVED / "share" / "doc" / "l3d"
    for name in ("README.md", "CHANGELOG.md", "LICENSE", "docs/TUTORIAL.md", "docs/REFERENCE.md"):
        expect((documents / name).is_file(), name)
    pictures = re.findall(r"\((docs/[^)#]+)", README)
    expect_equal([name for name in pictures if not (documents / name).is_file()], [])
    expect_equal([path.name for path in (MOVED / "share" / "l3d").iterdir() if path.suffix in (".py", ".html")], [])


def the_loader_is_told():
    """ldconfig is run where it may be, for the folders that it lists, and is asked for elsewhere."""
    with tempfile.TemporaryDirectory() as tools:
        fake = pathlib.Path(tools, "ldconfig")
        fake.write_text("#!/bin/sh\necho listed anew\n")
        fake.chmod(0o755)

        def said(prefix):
            script = ROOT / "packaging" / "installed.sh"
            places = [prefix + "/" + name for name in ("bin", "lib", "include", "share", "share/doc/l3d")]
            return run("PATH=%s:$PATH DESTDIR= %s %s" % (tools, script, " ".join(places)), MOVED).stdout

        wanted = "listed anew" if os.geteuid() == 0 else "Run ldconfig as root"
        expect(wanted in said("/usr/local"), said("/usr/local"))
        expect("ldconfig" not in said("/elsewhere") and "listed" not in said("/elsewhere"), said("/elsewhere"))


def is_found_by_cmake(real):
    version = run(["pkg-config", "--modversion", REALS[real]], MOVED).stdout.strip()
    lists = """cmake_minimum_required(VERSION 3.16)
project(user CXX)
find_package(l3d %s REQUIRED COMPONENTS %s)
foreach(name %s)
    add_executable(${name} ${name}.cpp)
    target_link_libraries(${name} l3d::%s)
endforeach()
""" % (version, real, " ".join(BY_CMAKE), real)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "CMakeLists.txt").write_text(lists)
        sources(folder)
        run("cmake -S . -B made -DCMAKE_PREFIX_PATH=%s && cmake --build made" % MOVED, folder)
        run("made/dot --no-input --backend memory --frames 3 --output dot.png", folder)
        (folder / "CMakeLists.txt").write_text(lists.replace(version, "99.0"))
        expect(run("cmake -S . -B newer -DCMAKE_PREFIX_PATH=%s" % MOVED, folder, None).returncode != 0,
               "finds version 99")


def nothing_names_the_source_tree():
    """A tree at /l3d is not named by /usr/lib/l3d."""
    trees = b"|".join(re.escape(str(tree).encode()) for tree in (ROOT, INSTALLED))
    named = re.compile(rb"(?<![\w.}/-])(?:" + trees + rb")(?![\w.-])")
    found = [path.name for path in MOVED.rglob("*") if path.is_file() and not path.is_symlink()
             and named.search(path.read_bytes())]
    expect_equal(found, [])


def page_fits(program):
    page = MOVED / "share" / "man" / "man1" / (program.name + ".1")
    lint = run(["mandoc", "-Tlint", str(page)], MOVED, None).stdout
    expect_equal([line for line in lint.splitlines() if "Xr l3d 7" not in line], [])
    text = run([str(program), "--help"], MOVED).stdout
    told = re.findall(r"^  (-\S+)", text, re.M)
    listed = [line[4:].split(" Ar ")[0].split(" Pq ")[0].replace("Fl ", "-").replace(r"\-", "-")
              .replace(" , ", ",") for line in page.read_text().splitlines() if line.startswith(".It Fl ")]
    expect(len(told) > 5, text)
    expect_equal(listed, told)


def overview_fits():
    page = MOVED / "share" / "man" / "man7" / "l3d.7"
    lint = run(["mandoc", "-Tlint", str(page)], MOVED, None).stdout
    expect_equal([line for line in lint.splitlines() if "referenced manual not found" not in line], [])
    named = set(re.findall(r"Xr ([\w-]+) 1\b", page.read_text())) - {"pkg-config"}
    expect_equal(named, {path.name for path in (MOVED / "bin").iterdir()})


def shells_complete_options():
    words = MOVED / "share" / "bash-completion" / "completions" / "teapot_afd"
    script = """. %s; COMP_WORDS=(teapot_afd --shade go); COMP_CWORD=2; _teapot_afd; echo ${COMPREPLY[@]}
COMP_WORDS=(teapot_afd --wire); COMP_CWORD=1; _teapot_afd; echo ${COMPREPLY[@]}""" % shlex.quote(str(words))
    expect_equal(run(["bash", "-c", script], MOVED).stdout.split(), ["gouraud", "--wireframe"])
    for program in (MOVED / "bin").iterdir():
        for file in (words.with_name(program.name),
                     MOVED / "share" / "zsh" / "site-functions" / ("_" + program.name)):
            expect("--backend" in file.read_text(), file)


def programs_share_the_library():
    """All but the one that measures, which looks inside."""
    for program in (MOVED / "bin").iterdir():
        needed = run(["readelf", "-d", str(program)], MOVED).stdout
        shares = re.search(r"\[libl3d(-fixed|-double)?\.so\.0\]", needed) is not None
        expect_equal(shares, program.name != "teapot_afd", program.name)


def programs_find_their_files():
    with tempfile.TemporaryDirectory() as folder:
        for command in ("modelview --model torus.off --pipeline zsort", "l3d-vidflat", "l3d-fltsim",
                        "teapot_afd --model teapot_bottom.bpt"):
            run("%s/bin/%s --no-input --backend memory --size 97x61 --output a.png" % (MOVED, command), folder)
            colors = {color for row in read_png(folder + "/a.png") for color in row}
            expect(len(colors) > 1, command, "drew nothing")


# ---- what was built -----------------------------------------------------------------------------


def page_and_a_half(name):
    expect(blocks()[name].count("\n") <= MOST_LINES[name], "lines of", name)


def refuses_the_other(folder, name):
    line = build_line("shared").replace("dot.cpp -o dot", "%s.float.o -o none" % name)
    done = run(for_real(line, "fixed") + LINKS_MORE.get(name, ""), folder, None)
    expect(done.returncode != 0 and "l3d_built_with_float_real" in done.stderr, done.stderr)


def drawn(file):
    """How many pixels differ from the background at the left of their row."""
    return sum(map(sum, covered(read_png(file))))


def runs_as_told(made):
    for line in shown("./"):
        if "--backend terminal" not in line and "--list" not in line:
            run(line, made)
    said = run("./teapot", made).stdout
    bound = re.fullmatch(r"off by (0\.\d+) pixels at most\n", said)
    expect(bound and float(bound[1]) <= 0.1, said)
    expect(drawn(made / "teapot.png") > 30000, "no teapot")
    dot = read_png(made / "dot.png")
    expect_equal([x for x, color in enumerate(dot[100]) if color == 0x00FF80], list(range(1, 101)), "dot at")
    spin = read_png(made / "spin.png")
    grey = sum(color & 255 == color >> 16 for row in spin for color in row)
    expect(30000 < grey < 200000 and 0xFFE080 in spin[8], "a teapot of", grey, "pixels")
    told = run("./probe", made).stdout
    expect(re.search(r"^patch \d+\n", told) and re.search(r"^distance 0\.\d+, off by \S+ at most$", told, re.M), told)
    filled = [x for row in covered(read_png(made / "probe.png")) for x in range(640) if row[x]]
    expect(0.8 < (max(filled) - min(filled) + 1) / 640 < 0.9, "a framed teapot")
    expect(6000 < drawn(made / "sail.png") < 60000, "the sail")
    expect(8000 < drawn(made / "even.png") < 50000, "a teapot")
    for name, least in (("three", 20000), ("arrow", 10000), ("turn", 10000), ("heights", 30000), ("ring", 15000),
                        ("chart", 10000), ("small/spaceship.obj", 2000)):
        expect(drawn(made / (name + ".png")) > least, name)
    chart = read_png(made / "chart.png")
    expect_equal((len(chart), len(chart[0]), chart[0][0], chart[67][650]), (500, 800, 0xFFFFFF, 0x1F77B4), "a chart")
    expect(any(color >> 8 & 255 == 0 and color >> 16 > 2 * (color & 255) for row in read_png(made / "heights.png")
               for color in row), "nothing is high")
    three = {color for row in read_png(made / "three.png") for color in row}
    for channel in (16, 0): # the first is red, the last blue
        expect(any(color >> channel & 255 > 2 * (color >> (16 - channel) & 255) + 40 for color in three), "colours")
    worlds_are_whole(made)
    walks_by_keys_and_mouse(made)
    shows_by_xlib(made)
    leaf = read_png(made / "leaf.png")
    expect(16000 < sum(color != 0 for row in leaf for color in row) < 19000, "a leaf on its ground")
    drawing_is_the_picture(made)


def plugin_is_shown(folder):
    """By the line that builds it, which links no library of ours, and by a program that loads it."""
    for line in shown("c++ "):
        if "-shared" in line:
            run(line, folder)
    for line in shown("l3d-vidflat "):
        run("%s/bin/%s" % (MOVED, line), folder)
    picture = read_png(folder / "plugged.png")
    expect(sum(color != picture[0][0] for row in picture for color in row) > 300, "no model")


def worlds_are_whole(made):
    """The bodies with the sparks, and the cone that stands in the next room."""
    orbits = read_png(made / "orbits.png")
    colors = {color for row in orbits for color in row}
    expect(any(c >> 16 > 2 * (c & 255) + 40 for c in colors) and any(c & 255 > 2 * (c >> 16) + 40 for c in colors),
           "no sun or no planet")
    rooms = read_png(made / "rooms.png")
    green = [(x, y) for y, row in enumerate(rooms) for x, c in enumerate(row)
             if (c >> 8 & 255) > 1.3 * max(c >> 16, c & 255) and y > 150]
    expect(500 < len(green) < 5000 and all(250 < x < 340 for x, _ in green), "cone seen through the door", len(green))


def walks_by_keys_and_mouse(made):
    """A held key walks, the pointer looks around, and each alone changes the picture."""
    expect(len({color for row in read_png(made / "walk.png") for color in row}) > 5, "no hall")
    with x_server() as server:
        where = {**environment(), "DISPLAY": server.display}
        process = subprocess.Popen([str(made / "walk"), "--backend", "ximage"], env=where)
        try:
            named = ("search", "--onlyvisible", "--name", "walk")
            window = int(wait_for(lambda: xdotool(server.display, *named).split(), "the window")[0])
            with Onlooker(server.display) as eyes:
                seen = lambda: eyes.picture(window, 640, 480)
                wait_for(lambda: has_picture(seen()), "a hall")
                for deed in (("keydown", "w", "sleep", "0.3", "keyup", "w"), ("mousemove_relative", "60", "0"),
                             ("mousemove_relative", "0", "30")):
                    before = seen()
                    xdotool(server.display, *deed)
                    wait_for(lambda: seen() != before, deed)
                xdotool(server.display, "key", "q")
                expect_equal(process.wait(20), 0)
        finally:
            process.kill()


def shows_by_xlib(made):
    """The window of xloop has a teapot, any key turns it, and q ends it."""
    with x_server() as server:
        where = {**environment(), "DISPLAY": server.display}
        process = subprocess.Popen([str(made / "xloop")], env=where)
        try:
            named = ("search", "--onlyvisible", "--name", "^xloop$")
            window = int(wait_for(lambda: xdotool(server.display, *named).split(), "the window")[0])
            with Onlooker(server.display) as eyes:
                seen = lambda: eyes.picture(window, 640, 480)
                wait_for(lambda: has_picture(seen()), "a teapot")
                first = seen()
                xdotool(server.display, "key", "x")
                wait_for(lambda: seen() != first, "another view")
            xdotool(server.display, "key", "q")
            expect_equal(process.wait(20), 0)
        finally:
            process.kill()


def drawing_is_the_picture(made):
    """Shapes of the SVG file, filled by a rule of our own, are the picture."""
    wanted = read_png(made / "star.png")
    shapes = [([[tuple(map(float, corner.split())) for corner in re.split("L", outline)]
                for outline in re.split("M", path) if outline], int(color, 16))
              for path, color in re.findall(r'd="(M[^Z]+)Z".*?="#(\w{6})"', (made / "drawing.svg").read_text())]
    expect(len(shapes) > 10, "shapes")

    def color_at(x, y):
        for outlines, color in reversed(shapes):
            crossings = 0
            for outline in outlines:
                for (x0, y0), (x1, y1) in zip(outline, outline[1:] + outline[:1]):
                    if (y0 > y) != (y1 > y) and x0 + (y - y0) * (x1 - x0) / (y1 - y0) > x:
                        crossings += 1
            if crossings % 2:
                return color
        return 0

    # Pixels are sampled at whole coordinates, which the edges of letters go through: a little off.
    off = sum(color_at(x + 1e-3, y + 2e-3) != wanted[y][x] for y in range(120) for x in range(120))
    expect(off <= 8, off, "pixels differ")


def terminal_shows(made):
    commands = [line.split() for line in shown("./terminal_spin")]
    listed = run(commands[0], made).stdout
    expect("terminal    no   standard input and output are no terminal" in listed, listed)
    more = ["--no-input", "--frames", "3"]
    status, picture = pty_screen.picture(commands[1] + more, made, environment(), 61, 20)
    expect_equal(status, 0)
    run("./terminal_spin %s --size 61x40 --backend memory --output same.png" % shlex.join(more), made)
    expect(picture == read_png(made / "same.png"), "another picture than in memory")
    expect_equal(pty_screen.picture(commands[1], made, environment(), 61, 20, b"x q")[0], 0, "after q:")


def drawdot_draws(made):
    run("./drawdot --no-input --classic --backend memory --size 53x31 --frames 20 --output d.png", made)
    row = read_png(made / "d.png")[0]
    expect_equal([x for x, color in enumerate(row) if color == 0x00FF80], list(range(21)))


def same_either_way(folder, real):
    for name in ("spin.png", "sail.png", "even.png"):
        shared, static = ((place(folder, real, way) / name).read_bytes() for way in WAYS)
        expect(shared == static, name, "differs")


def main():
    checks = Checks()
    for name in REALS.values():
        checks.run("install.%s.exports" % name, library_exports_ours_only, name)
        checks.run("install.%s.exports_the_list" % name, library_exports_the_listed_names, name)
    for check in (documents_are_there, the_loader_is_told, headers_are_the_listed_ones, needs_cxx20, nothing_names_the_source_tree, overview_fits,
                  packages_share_out_all_files, programs_find_their_files, programs_share_the_library, shells_complete_options):
        checks.run("install." + check.__name__, check)
    for real in REALS:
        checks.run("install.cmake." + real, is_found_by_cmake, real)
        checks.run("install.pkg_config." + real, is_told_who_needs_it, real)
    alone = MOVED / "alone"
    alone.mkdir()
    users_own_headers(alone)
    checks.run("install.headers.upwards", headers_stand, alone, public_headers())
    checks.run("install.headers.downwards", headers_stand, alone, public_headers()[::-1])
    for name in public_headers():
        checks.run("install.header." + name, includes_public_headers_only, name)
    for program in sorted((MOVED / "bin").iterdir()):
        checks.run("install.page." + program.name, page_fits, program)
    for name in MOST_LINES:
        checks.run("tutorial.%s.length" % name, page_and_a_half, name)
    folder = MOVED / "examples"
    folder.mkdir()
    names = sources(folder)
    with concurrent.futures.ThreadPoolExecutor(WORKERS) as pool:
        compiled = {(name, real): pool.submit(compile_one, folder, name, real)
                    for name in names for real in REALS}
    for (name, real), made in compiled.items():
        checks.run("tutorial.%s.%s.compiles" % (name, real), made.result)
    for real in REALS:
        for way in WAYS:
            label = "tutorial.%s.%s." % (real, way)
            made = place(folder, real, way)
            for name in names:
                checks.run(label + name + ".links", link_one, folder, name, real, way)
            for check in (runs_as_told, terminal_shows, drawdot_draws):
                checks.run(label + check.__name__, check, made)
        checks.run("tutorial.%s.same_either_way" % real, same_either_way, folder, real)
    checks.run("tutorial.plugin", plugin_is_shown, folder)
    for name in names:
        checks.run("tutorial.%s.refuses_the_other" % name, refuses_the_other, folder, name)
    checks.finish()


if __name__ == "__main__":
    shutil.rmtree(MOVED, ignore_errors=True)
    MOVED.mkdir(mode=0o700)  # fails if it is somebody else's
    try:
        shutil.copytree(INSTALLED, MOVED, symlinks=True, dirs_exist_ok=True)
        tools = MOVED / "tools"
        tools.mkdir()
        # The tutorial's lines name neither the compiler of this run nor where things were moved to.
        for name, line in (("c++", os.environ.get("CXX", "c++")),
                           ("pkg-config", shutil.which("pkg-config") + " --define-prefix")):
            (tools / name).write_text('#!/bin/sh\nexec %s "$@"\n' % line)
            (tools / name).chmod(0o755)
        main()
    finally:
        shutil.rmtree(MOVED, ignore_errors=True)
