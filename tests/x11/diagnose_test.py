#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What --diagnose prints in seven environments, line by line; each trouble comes with its remedy."""

import re

import harness
from harness import Checks, environment, expect_equal, run, x_server
from x_proxy import Proxy

PROGRAM = harness.PROGRAMS[-1]
MEMORY = "memory  yes  no display: pictures into files"
WINDOW = {
    "xshm": "xshm    yes  window, pixels in shared memory: a local display, the fast one",
    "ximage": "ximage  yes  window, pixels sent over the wire: any display, remote too",
}
NO_MESA = [
    "note EGL surfaceless: left out by L3D_MESA=nothing",
    "note EGL software device: left out by L3D_MESA=nothing",
    "note OSMesa: left out by L3D_MESA=nothing",
]
MESA_ROW = "mesa    no   L3D_MESA: 'nothing' is none of auto egl osmesa"
NO_MANAGER = [
    "note window manager: none; the window takes the keyboard itself and has no frame",
    "     start a window manager if you want frames",
]
SHARING_REMEDY = (
    "     needs a local X server in our IPC namespace (in a container: --ipc=host), free segments"
    " (ipcs -lm), and L3D_NO_SHM unset"
)
TRUE_COLOR = "ok   visual: TrueColor, depth 24, 32 bits per pixel, low byte first, masks ff0000/ff00/ff"


def diagnosis(display, **more):
    """The lines, without those that depend on the release of the server."""
    more.setdefault("L3D_MESA", "nothing")  # or the lines would depend on what is installed
    env = environment(display, **more)
    status, out, messages = run(PROGRAM.command("--diagnose"), env)
    expect_equal((status, messages), (0, ""))
    return [re.sub(r"(ok   display: '[^']*', (?:local|over a network)), .*", r"\1", line)
            for line in out.decode().splitlines()]


def head(display="", no_shm="", mesa="nothing"):
    wanted = "DISPLAY='%s' L3D_BACKEND='' L3D_NO_SHM='%s' L3D_MESA='%s' terminal=no"
    return wanted % (display, no_shm, mesa)


def without_a_display():
    remedy = "     set DISPLAY, or do without: --backend memory --output picture.png"
    expect_equal(diagnosis(None), [
        head(), "bad  display: DISPLAY is not set", remedy, *NO_MESA,
        "xshm    no   DISPLAY is not set", "ximage  no   DISPLAY is not set", MESA_ROW, MEMORY])
    why = "cannot open the display that DISPLAY names, ':64321'"
    expect_equal(diagnosis(":64321"), [
        head(":64321"), "bad  display: " + why, remedy, *NO_MESA,
        "xshm    no   " + why, "ximage  no   " + why, MESA_ROW, MEMORY])


def expect_display(display, sharing, xshm, **more):
    expect_equal(diagnosis(display, **more), [
        head(display, more.get("L3D_NO_SHM", "")), "ok   display: '%s', local" % display,
        TRUE_COLOR, *NO_MANAGER, *sharing, *NO_MESA, xshm, WINDOW["ximage"], MESA_ROW, MEMORY])


def on_a_local_display():
    with x_server() as server:
        expect_display(server.display, [
            "ok   MIT-SHM: version 1.2", "ok   shared memory: the X server sees what we write"],
            WINDOW["xshm"])


def with_shared_memory_forbidden():
    with x_server() as server:
        expect_display(server.display, [
            "ok   MIT-SHM: version 1.2",
            "note shared memory: L3D_NO_SHM is set; pictures go over the wire", SHARING_REMEDY],
            "xshm    yes, but pictures go over the wire: L3D_NO_SHM is set", L3D_NO_SHM="1")


def without_the_extension():
    with x_server("-extension", "MIT-SHM") as server:
        expect_display(server.display, [
            "note MIT-SHM: not there; pictures go over the wire",
            "     start the X server without '-extension MIT-SHM'",
            "note shared memory: the X server does not have MIT-SHM; pictures go over the wire",
            SHARING_REMEDY],
            "xshm    yes, but pictures go over the wire: the X server does not have MIT-SHM")


def where_no_segment_can_be_attached():
    with x_server() as server, Proxy(server.display, shm_badrequest=True) as proxy:
        lines = diagnosis(proxy.display)
        why = next(line for line in lines if line.startswith("note shared memory: "))
        expect_equal(lines[lines.index(why) + 1], SHARING_REMEDY)
        reason = why.removeprefix("note shared memory: ").removesuffix("; pictures go over the wire")
        expect_equal(lines[-4], "xshm    yes, but pictures go over the wire: " + reason)
        harness.expect("BadRequest" in reason or "refuse" in reason, reason)


def on_a_display_of_few_colours():
    with x_server("-screen", "0", "320x200x8", "-cc", "3") as server:
        expect_equal(diagnosis(server.display)[2],
                     "ok   visual: PseudoColor, depth 8, 8 bits per pixel, low byte first")


def with_mesa():
    """Where it is installed, each way names its renderer; where not, its packages."""
    ways = ("EGL surfaceless", "EGL software device", "OSMesa")
    lines = diagnosis(None, L3D_MESA="auto")
    for way in ways:
        line = next(line for line in lines if line[5:].startswith(way + ": "))
        if not line.startswith("ok   "):
            remedy = lines[lines.index(line) + 1]
            harness.expect(remedy.startswith("     ") and "lib" in remedy, line, remedy)
        else:
            harness.expect("llvmpipe" in line or "softpipe" in line, line)


if __name__ == "__main__":
    checks = Checks()
    for check in (
        without_a_display,
        on_a_local_display,
        with_shared_memory_forbidden,
        without_the_extension,
        where_no_segment_can_be_attached,
        on_a_display_of_few_colours,
        with_mesa,
    ):
        checks.run("diagnose." + check.__name__, check)
    checks.finish()
