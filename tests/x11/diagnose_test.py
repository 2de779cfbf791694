#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What --diagnose prints in many environments, line by line; each trouble comes with its remedy."""

import contextlib
import re
import socket
import struct
import subprocess

import harness
from harness import Checks, environment, expect, expect_equal, folder, run, x_server
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
    "     needs an X server with MIT-SHM 1.2; with an older one, an X server in our IPC namespace"
    " (in a container: --ipc=host) and free segments (ipcs -lm)"
)
# What Xlib's own library prints, and nobody can keep it from that.
REASONS = (
    "", "Invalid MIT-MAGIC-COOKIE-1 key", "Maximum number of clients reached",
    "Authorization required, but no authorization protocol specified",
)
CANNOT = "cannot open the display that DISPLAY names, '%s': "
TRUE_COLOR = "ok   visual: TrueColor, depth 24, 32 bits per pixel, low byte first, masks ff0000/ff00/ff"


def diagnosis(display, **more):
    """The lines, without those that depend on the release of the server. A library may print the
    server's reason not to let us in, once."""
    more.setdefault("L3D_MESA", "nothing")  # or the lines would depend on what is installed
    env = environment(display, **more)
    status, out, messages = run(PROGRAM.command("--diagnose"), env)
    expect_equal(status, 0)
    expect(len(messages.split("\n")) <= 3 and messages.strip() in REASONS, messages)
    return [re.sub(r"(ok   display: '[^']*', (?:local|over a network)), .*", r"\1", line)
            for line in out.decode().splitlines()]


def head(display="", no_shm="", mesa="nothing"):
    wanted = "DISPLAY='%s' L3D_BACKEND='' L3D_NO_SHM='%s' L3D_MESA='%s' L3D_FONT='' terminal=no"
    return wanted % (display, no_shm, mesa)


def without_a_display():
    remedy = "     set DISPLAY, or do without: --backend memory --output picture.png"
    expect_equal(diagnosis(None), [
        head(), "bad  display: DISPLAY is not set", remedy, *NO_MESA,
        "xshm    no   DISPLAY is not set", "ximage  no   DISPLAY is not set", MESA_ROW, MEMORY])
    why = CANNOT % ":64321" + "no X server listens at /tmp/.X11-unix/X64321"
    remedy = "     set DISPLAY to another, or do without: --backend memory --output picture.png"
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
            "ok   MIT-SHM: version 1.2",
            "ok   shared memory: the X server sees what we write, in files that it is handed"],
            WINDOW["xshm"])


def on_a_display_that_takes_no_files():
    with x_server() as server, Proxy(server.display, shm_no_files=True) as proxy:
        expect_display(proxy.display, [
            "ok   MIT-SHM: version 1.1",
            "ok   shared memory: the X server sees what we write, in segments of System V"],
            WINDOW["xshm"])


def where_no_segment_is_left():
    """strace has the kernel refuse what System V asks it for: files serve all the same, and what
    refuses both is told."""
    refuse = ("strace", "-f", "-o", "/dev/null", "-e", "inject=shmget:error=ENOSPC")
    with x_server() as server, Proxy(server.display, shm_no_files=True) as proxy:
        told = lambda display, *more: harness.run(
            [*refuse, *more, *PROGRAM.command("--diagnose")],
            environment(display, L3D_MESA="nothing"))[1].decode()
        expect("in files that it is handed" in told(server.display), "no files")
        expect("note shared memory: shmget: No space left on device; pictures" in
               told(proxy.display), "no reason")
        expect("note shared memory: memfd_create: Too many open files in system; shmget: No space "
               "left on device; pictures" in
               told(server.display, "-e", "inject=memfd_create:error=ENFILE"), "not both reasons")


def with_shared_memory_forbidden():
    with x_server() as server:
        expect_display(server.display, [
            "ok   MIT-SHM: version 1.2",
            "note shared memory: L3D_NO_SHM is set; pictures go over the wire",
            "     unset L3D_NO_SHM"],
            "xshm    yes, but pictures go over the wire: L3D_NO_SHM is set", L3D_NO_SHM="1")


def without_the_extension():
    with x_server("-extension", "MIT-SHM") as server:
        expect_display(server.display, [
            "note MIT-SHM: not there; pictures go over the wire",
            "     Xnest has none, Xephyr has; others have it unless started with"
            " '-extension MIT-SHM'",
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
        expect("BadRequest" in reason or "refuse" in reason, reason)


def on_a_display_of_few_colours():
    with x_server("-screen", "0", "320x200x8", "-cc", "3") as server:
        expect_equal(diagnosis(server.display)[2],
                     "ok   visual: PseudoColor, depth 8, 8 bits per pixel, low byte first")


# ---- displays that let nobody in ----------------------------------------------------------------


def write_cookie(path, cookie):
    """A file of cookies whose only one is for any display."""
    counted = lambda text: struct.pack(">H", len(text)) + text
    texts = map(counted, (b"", b"", b"MIT-MAGIC-COOKIE-1", cookie))
    with open(path, "wb") as file:
        file.write(struct.pack(">H", 0xFFFF) + b"".join(texts))
    return path


def expect_refusal(display, why, remedy, **more):
    """In one line of the program's own; --diagnose has it once, with its remedy."""
    cannot = CANNOT % display + why
    env = environment(display, **more)
    wanted = "%s: %s; without a display use --backend memory --output FILE" % (PROGRAM.name, cannot)
    status, out, messages = run(PROGRAM.command("--no-input"), env)
    expect_equal((status, out), (3, b""))
    said = messages.split("\n")
    expect(wanted in said and all(line in (wanted, "", *REASONS) for line in said), said)
    lines = diagnosis(display, **more)
    expect_equal(lines[1:3], ["bad  display: " + cannot, "     " + remedy])
    expect_equal(sum(line.startswith("bad ") for line in lines), 1)


def that_wants_a_cookie():
    with folder() as path:
        right = write_cookie(path + "/right", bytes(range(16)))
        wrong = write_cookie(path + "/wrong", bytes(range(1, 17)))
        with x_server("-auth", right) as server:
            expect_equal(diagnosis(server.display, XAUTHORITY=right)[2], TRUE_COLOR)
            expect_refusal(
                server.display,
                "the X server does not take the cookie from %s (Invalid MIT-MAGIC-COOKIE-1 key)" % wrong,
                "it is another server's cookie: get the right one from the display's owner, with"
                " 'xauth extract' and 'xauth merge'", XAUTHORITY=wrong)
            missing = path + "/missing"
            expect_refusal(
                server.display,
                "the X server asks for a cookie, and %s has none for it (Authorization required, but"
                " no authorization protocol specified)" % missing,
                "let XAUTHORITY name the file of the display's owner (in a container: mount it), or"
                " log in as the owner", XAUTHORITY=missing)


def that_is_full():
    with contextlib.ExitStack() as stack:
        server = stack.enter_context(x_server("-maxclients", "64"))
        for _ in range(64):
            client = stack.enter_context(socket.socket(socket.AF_UNIX))
            client.connect("/tmp/.X11-unix/X" + server.display.lstrip(":"))
            client.send(b"l\0" + struct.pack("<5H", 11, 0, 0, 0, 0))
            client.recv(1)
        expect_refusal(
            server.display,
            "the X server has no room for one more program (Maximum number of clients reached)",
            "end some that use it, or start it with '-maxclients 2048'")


def of_a_host_that_is_not_there():
    for display, why in (
        ("127.0.0.1:399", "no X server listens at '127.0.0.1', port 6399"),
        ("nohost.invalid:0", "no host of the name 'nohost.invalid' is known"),
        ("foo", "a display's name has a colon and a number, as in ':0'"),
    ):
        expect_refusal(display, why, "set DISPLAY to another, or do without: --backend memory --output"
                       " picture.png")


# ---- displays that are far ----------------------------------------------------------------------


def over_a_network_and_by_ssh():
    with x_server() as server, Proxy(server.display) as proxy:
        for way, more, help_more in (
            ("over a network", {}, ""),
            ("by ssh", {"SSH_CONNECTION": "10.0.0.1 22 10.0.0.2 22"}, "; so does ssh -C on a slow line"),
        ):
            lines = diagnosis(proxy.tcp_display, **more)
            expect_equal(lines[2:4], [
                "note way: %s; --remote auto sends only what changed, coarse while it moves" % way,
                "     a smaller --size and --fps 5 make it lighter" + help_more])
            at = lines.index("note shared memory: the X server is reached over a network; pictures go"
                             " over the wire")
            expect_equal(lines[at + 1], "     none is needed: back-end ximage serves displays of other"
                         " machines")


def that_does_not_trust_us():
    """As by ssh -X: the server hides what could harm others."""
    with folder() as path:
        files = [write_cookie(path + "/owner", bytes(range(16))), path + "/stranger"]
        with x_server("-auth", files[0]) as server:
            made = ["xauth", "-f", files[1], "generate", server.display, ".", "untrusted"]
            env = environment(server.display, XAUTHORITY=files[0])
            subprocess.run(made, env=env, check=True, capture_output=True)
            lines = diagnosis(server.display, XAUTHORITY=files[1])
            expect_equal(lines[2:4], [
                "note trust: the X server does not trust this connection, and hides most of its"
                " extensions", "     ssh -Y in place of ssh -X, if you trust the other machine"])
            expect("     hidden from connections that are not trusted" in lines, lines)


def with_mesa():
    """Where it is installed, each way names its renderer; where not, its packages."""
    ways = ("EGL surfaceless", "EGL software device", "OSMesa")
    lines = diagnosis(None, L3D_MESA="auto")
    for way in ways:
        line = next(line for line in lines if line[5:].startswith(way + ": "))
        if not line.startswith("ok   "):
            remedy = lines[lines.index(line) + 1]
            expect(remedy.startswith("     ") and "lib" in remedy, line, remedy)
        else:
            expect("llvmpipe" in line or "softpipe" in line, line)


if __name__ == "__main__":
    checks = Checks()
    for check in (
        without_a_display,
        on_a_local_display,
        on_a_display_that_takes_no_files,
        where_no_segment_is_left,
        with_shared_memory_forbidden,
        without_the_extension,
        where_no_segment_can_be_attached,
        on_a_display_of_few_colours,
        that_wants_a_cookie,
        that_is_full,
        of_a_host_that_is_not_there,
        over_a_network_and_by_ssh,
        that_does_not_trust_us,
        with_mesa,
    ):
        checks.run("diagnose." + check.__name__, check)
    checks.finish()
