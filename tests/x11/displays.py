#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every X server with every window manager that is installed: what a window must do in each.

    displays.py [--server NAME] [--manager NAME] [--write FILE]

Events and pixels judge, never time. The result is a table; --write puts it into a document.
"""

import argparse
import contextlib
import os
import shutil
import subprocess
import sys
import tempfile

import harness
from harness import environment, expect, expect_equal, started, wait_for, x_server, xdotool
from onlooker import Onlooker
from x_proxy import Proxy

TEAPOT = harness.Program("teapot_afd", (320, 240))
MANAGERS = {  # and the word that another workspace is asked for with; none: it has no others
    "none": (None, None),
    "twm": (["twm"], None),
    "openbox": (["openbox"], ["wmctrl", "-s"]),
    "icewm": (["icewm"], ["wmctrl", "-s"]),
    "fluxbox": (["fluxbox"], ["wmctrl", "-s"]),
    "i3": (["i3", "-c"], ["i3-msg", "workspace"]),
    "awesome": (["awesome"], ["wmctrl", "-s"]),
    "xfwm4": (["xfwm4"], ["wmctrl", "-s"]),
    "metacity": (["metacity"], ["wmctrl", "-s"]),
    "mutter": (["mutter", "--x11"], ["wmctrl", "-s"]),
    "kwin": (["kwin_x11"], ["wmctrl", "-s"]),
    "matchbox": (["matchbox-window-manager"], None),
}
# Its usual fonts are packages of their own; this one every server has.
TWM = "RandomPlacement\n" + "".join(
    '%sFont "fixed"\n' % what for what in ("Title", "Resize", "Menu", "Icon", "IconManager")
)
TILING = ("i3", "matchbox")  # they give windows sizes of their own choice


class Unable(Exception):
    """What a cell cannot do, and why."""


# ---- servers ------------------------------------------------------------------------------------


@contextlib.contextmanager
def ready_server(command, env=None, folder=None):
    """A server that writes its number when it is ready."""
    if shutil.which(command[0]) is None:
        raise Unable(command[0] + " is not installed")
    read, write = os.pipe()
    command = [word.replace("{fd}", str(write)) for word in command]
    server = subprocess.Popen(
        command, pass_fds=[write], env=env, cwd=folder, stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )
    os.close(write)
    try:
        number = os.read(read, 16).decode().strip()
        if not number.isdigit():
            raise Unable(command[0] + " does not start here")
        server.display = ":" + number
        yield server
    finally:
        os.close(read)
        if server.poll() is None:
            server.terminate()
        server.wait()


@contextlib.contextmanager
def xephyr():
    with x_server("-screen", "0", "1300x900x24") as outer:
        command = ["Xephyr", "-displayfd", "{fd}", "-screen", "800x600x24", "-noreset"]
        with ready_server(command, environment(outer.display)) as server:
            yield server


def tigervnc():
    number = "%d" % (70 + os.getpid() % 20)
    return ready_server(["Xvnc", "-displayfd", "{fd}", "-geometry", "800x600", "-depth", "24",
                         "-SecurityTypes", "None", "-rfbport", "59" + number])


DUMMY = """
Section "Device"\nIdentifier "d"\nDriver "dummy"\nVideoRam 65536\nEndSection
Section "Monitor"\nIdentifier "m"\nHorizSync 5-1000\nVertRefresh 5-200\nEndSection
Section "Screen"\nIdentifier "s"\nDevice "d"\nMonitor "m"\nDefaultDepth 24
SubSection "Display"\nDepth 24\nModes "800x600"\nVirtual 800 600\nEndSubSection\nEndSection
Section "ServerFlags"\nOption "AutoAddDevices" "false"\nOption "AllowMouseOpenFail" "true"\nEndSection
"""


@contextlib.contextmanager
def xorg():
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "dummy.conf"), "w") as file:
            file.write(DUMMY)
        with ready_server(["Xorg", "-displayfd", "{fd}", "-config", "dummy.conf", "-noreset",
                           "-novtswitch", "-sharevts", "-logfile", "xorg.log"],
                          folder=folder) as server:
            yield server


@contextlib.contextmanager
def xwayland():
    if shutil.which("weston") is None:
        raise Unable("weston is not installed")
    with tempfile.TemporaryDirectory() as folder:
        env = environment(XDG_RUNTIME_DIR=folder)
        weston = ["weston", "--backend=headless-backend.so", "--socket=l3d", "--idle-time=0"]
        with started(weston, env, stdout=subprocess.DEVNULL) as compositor:
            wait_for(lambda: os.path.exists(os.path.join(folder, "l3d")) or compositor.poll(),
                     "weston")
            if compositor.poll() is not None:
                raise Unable("weston does not start here")
            env["WAYLAND_DISPLAY"] = "l3d"
            command = ["Xwayland", "-displayfd", "{fd}", "-noreset", "-geometry", "800x600"]
            with ready_server(command, env) as server:
                yield server


SERVERS = {
    "Xvfb": x_server,
    "Xephyr": xephyr,
    "TigerVNC": tigervnc,
    "Xorg dummy": xorg,
    "Xwayland": xwayland,
}


# ---- managers -----------------------------------------------------------------------------------


@contextlib.contextmanager
def managed(display, name):
    command, _ = MANAGERS[name]
    if command is None:
        yield None
        return
    if shutil.which(command[0]) is None:
        raise Unable(command[0] + " is not installed")
    with Onlooker(display) as eyes:
        wait_for(lambda: not eyes.has_manager(), "the end of the manager before")
    with tempfile.TemporaryDirectory() as home:
        # A configuration of its own: users' keys and rules are no part of the matrix.
        config = os.path.join(home, "config")
        with open(config, "w") as file:
            file.write(TWM if name == "twm" else "workspace 1\n")
        command = command + [config] if name == "i3" else command
        command = command + ["-f", config] if name == "twm" else command
        env = environment(display, HOME=home, XDG_CONFIG_HOME=home, XDG_RUNTIME_DIR=home,
                          XDG_SESSION_TYPE="x11")
        if name in ("mutter", "kwin", "xfwm4", "metacity") and shutil.which("dbus-run-session"):
            command = ["dbus-run-session", "--", *command]
        # What a manager starts may outlive it, and would keep a pipe open.
        command = ["sh", "-c", 'exec "$0" "$@" 2>/dev/null', *command]
        with started(command, env, stdout=subprocess.DEVNULL) as manager:
            with Onlooker(display) as eyes:
                with contextlib.suppress(AssertionError):
                    wait_for(lambda: eyes.has_manager() or manager.poll() is not None, name)
                harness.time.sleep(0.5)  # some give up once they have begun
                if manager.poll() is not None or not eyes.has_manager():
                    raise Unable(name + " does not start here")
            yield manager


# ---- a cell -------------------------------------------------------------------------------------


class Cell:
    """A program under a manager on a server, seen by an onlooker, its requests counted."""

    def __init__(self, display, manager):
        self.display, self.manager = display, manager

    @contextlib.contextmanager
    def program(self, *arguments):
        with contextlib.ExitStack() as stack:
            self.eyes = stack.enter_context(Onlooker(self.display))
            self.proxy = stack.enter_context(Proxy(self.display))
            command = TEAPOT.command("--backend", "ximage", *arguments)
            env = environment(self.proxy.display)
            self.process = stack.enter_context(started(command, env))
            self.window = harness.window_of(self.display, TEAPOT)
            wait_for(lambda: harness.has_picture(self.picture()), "the first picture")
            self.focus()
            yield self
            # The server may be gone, and Xlib would end this program.

    def focus(self):
        if self.manager == "none":
            xdotool(self.display, "windowfocus", self.window)
        else:
            xdotool(self.display, "windowactivate", self.window)
            xdotool(self.display, "windowfocus", self.window)

    def size(self):
        shell = xdotool(self.display, "getwindowgeometry", "--shell", self.window)
        values = dict(line.split("=") for line in shell.split())
        return int(values.get("WIDTH", 0)), int(values.get("HEIGHT", 0))

    def picture(self):
        size = self.size()
        return self.eyes.picture(self.window, *size) if size[0] else None

    def key(self, *keys):
        xdotool(self.display, "key", *keys)

    def tool(self, *command):
        try:
            subprocess.run(list(map(str, command)), env=environment(self.display), check=False,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                           timeout=harness.PATIENCE)
        except FileNotFoundError as error:
            raise Unable(command[0] + " is not installed") from error

    def puts(self, mark):
        return (self.proxy.mark() - mark).requests.count("PutImage")

    def await_drawing(self):
        mark = self.proxy.mark()
        wait_for(lambda: self.puts(mark) > 2, "pictures")

    def await_rest(self):
        def rests():
            mark = self.proxy.mark()
            harness.time.sleep(0.3)
            return not self.puts(mark)

        wait_for(rests, "no more pictures")

    def await_whole(self, whole):
        wait_for(lambda: (self.size() == (800, 600)) == whole, "the size of the screen: %s" % whole)


def maps_and_takes_keys(cell):
    with cell.program():
        before = cell.picture()
        cell.key("Caps_Lock")
        cell.key("h")
        wait_for(lambda: cell.picture() != before, "the help, with Caps Lock on")
        cell.key("Caps_Lock")
        cell.key("ctrl+q", "h")
        cell.key("q")
        expect_equal(harness.ended(cell.process)[0], 0)


def resizes(cell):
    if cell.manager in TILING:
        raise Unable("gives windows sizes of its own")
    with cell.program("--frames", "100000000"):
        steps = []
        for i in range(100):
            steps += ["windowsize", cell.window, 150 + 7 * i % 301, 140 + 11 * i % 211]
        xdotool(cell.display, *steps, "windowsize", cell.window, 333, 244)
        wait_for(lambda: cell.size() == (333, 244), "the last size")
        wanted = harness.memory_picture(harness.Program("teapot_afd", (333, 244)))
        wait_for(lambda: cell.picture() == wanted, "the picture of the last size")


def fullscreen_by_us(cell):
    with cell.program("--turntable", "1"):
        if cell.size() == (800, 600):
            raise Unable("windows cover the screen anyhow")
        for there, back in (("F11", "Escape"), ("F11", "F11")):
            cell.key(there)
            cell.await_whole(True)
            cell.await_drawing()
            cell.key(back)
            cell.await_whole(False)
            cell.await_drawing()  # and the manager's word is heard
        cell.key("Escape")
        expect_equal(harness.ended(cell.process)[0], 0)


def fullscreen_by_manager(cell):
    if cell.manager in ("none", "twm"):
        raise Unable("knows no fullscreen")
    with cell.program("--turntable", "1"):
        if cell.size() == (800, 600):
            raise Unable("windows cover the screen anyhow")
        cell.tool("wmctrl", "-i", "-r", cell.window, "-b", "add,fullscreen")
        cell.await_whole(True)
        cell.await_drawing()
        cell.key("Escape")
        cell.await_whole(False)
        cell.await_drawing()
        expect(cell.process.poll() is None, "the program ended")


def minimises(cell):
    if cell.manager in ("none", "i3", "matchbox"):
        raise Unable("minimises no windows")
    with cell.program("--turntable", "1"):
        cell.await_drawing()
        xdotool(cell.display, "windowminimize", cell.window)
        cell.await_rest()
        xdotool(cell.display, "windowmap", cell.window)
        if cell.manager != "twm":
            cell.tool("wmctrl", "-i", "-a", cell.window)
        cell.await_drawing()


def changes_workspace(cell):
    command = MANAGERS[cell.manager][1]
    if command is None:
        raise Unable("has no workspaces")
    first, second = ("1", "2") if cell.manager == "i3" else ("0", "1")
    with cell.program("--turntable", "1"):
        cell.await_drawing()
        if cell.manager in ("metacity", "mutter", "kwin"):
            cell.tool("wmctrl", "-n", "2")
        cell.tool(*command, second)
        cell.await_rest()
        cell.tool(*command, first)
        cell.await_drawing()


def closes(cell):
    with cell.program():
        if cell.manager in ("none", "twm"):
            cell.eyes.ask_to_close(cell.window)
        else:
            cell.tool("wmctrl", "-i", "-c", cell.window)
        expect_equal(harness.ended(cell.process)[0], 0)


CHECKS = (
    maps_and_takes_keys,
    resizes,
    fullscreen_by_us,
    fullscreen_by_manager,
    minimises,
    changes_workspace,
    closes,
)


def outlives_managers(display, name):
    """The manager is killed, and another comes: F11 works each time."""
    if name == "none":
        raise Unable("has no manager to kill")
    cell = Cell(display, name)
    with contextlib.ExitStack() as stack:
        stack.enter_context(managed(display, name))
        with cell.program("--turntable", "1"):
            stack.close()
            wait_for(lambda: not cell.eyes.has_manager(), "the manager's end")
            cell.await_drawing()
            xdotool(display, "windowfocus", cell.window)
            was_whole = cell.size() == (800, 600)
            cell.key("F11")
            if not was_whole:
                cell.await_whole(True)
                cell.await_drawing()
                cell.key("Escape")
                cell.await_whole(False)
            with managed(display, "openbox"):
                cell.await_drawing()
                cell.focus()
                cell.key("F11")
                cell.await_whole(True)
                cell.await_drawing()
                cell.key("Escape")
                cell.await_drawing()
                expect(cell.process.poll() is None, "the program ended")


def outlives_the_server(server, name):
    with contextlib.ExitStack() as stack:
        stack.enter_context(managed(server.display, name))
        with started(TEAPOT.command("--backend", "xshm"), environment(server.display)) as process:
            harness.window_of(server.display, TEAPOT)
            server.kill()  # nobody looks on: Xlib would end this program
            expect_equal(harness.ended(process)[0], 6)


def run_cell(server_name, name):
    """The words of a row: ok, a reason in brackets, or what failed."""
    row = {}

    def run(check, *arguments):
        title = check.__name__
        try:
            check(*arguments)
            row[title] = "ok"
        except Unable as reason:
            row[title] = "(%s)" % reason
        except Exception as error:  # a check may fail in any way; the others still run
            row[title] = "FAILED: " + (str(error) or type(error).__name__).split("\n")[0]

    try:
        with SERVERS[server_name]() as server:
            with managed(server.display, name):
                for check in CHECKS:
                    run(check, Cell(server.display, name))
            run(outlives_managers, server.display, name)
            run(outlives_the_server, server, name)
    except Unable as reason:
        row["starts"] = "(%s)" % reason
    return row


def table(rows):
    titles = [check.__name__ for check in (*CHECKS, outlives_managers, outlives_the_server)]
    notes = []

    def short(word):
        if word == "ok":
            return "ok"
        if word not in notes:
            notes.append(word)
        return ("FAILED " if word.startswith("FAILED") else "-") + "[%d]" % (1 + notes.index(word))

    lines = ["| server | manager | " + " | ".join(title.replace("_", " ") for title in titles) + " |",
             "|---|---|" + len(titles) * "---|"]
    for (server, manager), row in rows.items():
        words = [short(row.get(title, row.get("starts", "-"))) for title in titles]
        lines.append("| %s | %s | %s |" % (server, manager, " | ".join(words)))
    lines += [""] + ["%d. %s" % (i, note.strip("()")) for i, note in enumerate(notes, 1)]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--server", action="append", choices=SERVERS)
    parser.add_argument("--manager", action="append", choices=MANAGERS)
    parser.add_argument("--write", metavar="FILE")
    asked = parser.parse_args()
    rows = {}
    for server in asked.server or SERVERS:
        for name in asked.manager or MANAGERS:
            row = rows[server, name] = run_cell(server, name)
            for title, word in row.items():
                start = {"o": "ok", "(": "not tested:", "F": "not ok"}[word[0]]
                print(start, "displays.%s.%s.%s" % (server, name, title),
                      "" if word == "ok" else word, flush=True)
    print(table(rows))
    if asked.write:
        with open(asked.write) as file:
            text = file.read()
        begin, end = "<!-- displays -->\n", "<!-- end of displays -->\n"
        head, rest = text.split(begin)
        with open(asked.write, "w") as file:
            file.write(head + begin + "\n" + table(rows) + "\n" + end + rest.split(end)[1])
    sys.exit(any(word.startswith("F") for row in rows.values() for word in row.values()))


if __name__ == "__main__":
    main()
