#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every X server with every window manager that is installed: what a window must do in each.

    displays.py [--server NAME] [--manager NAME] [--repeat N] [--record FILE] [--write FILE]

Events and pixels judge, never time. The result is a table; --write puts it into a document. With
--repeat a cell is ok if it was so each time. What a --record has counts as well: a run that was
stopped goes on there, and several at a time, of other servers each, may add to one.
"""

import argparse
import contextlib
import json
import os
import subprocess
import sys
import time

import harness
from harness import await_heard, await_motion, environment, expect, expect_equal, started, wait_for
from harness import window_size, xdotool
from onlooker import Onlooker
from servers import MANAGERS, SERVERS, Unable, managed
from x_proxy import Proxy

TEAPOT = harness.Program("teapot_afd", (320, 240))
TILING = ("i3", "matchbox")  # they give windows sizes of their own choice


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
        """Gives the window the keys. This fails while a manager moves the window into its frame."""
        xdotool(self.display, "windowactivate", self.window)  # nobody hears this without a manager
        focus = "windowfocus", self.window, "getwindowfocus", "-f"
        wait_for(lambda: xdotool(self.display, *focus).split() == [str(self.window)], "the focus")

    def picture(self):
        size = window_size(self)
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

    def await_rest(self):
        def rests():
            mark = self.proxy.mark()
            time.sleep(0.3)
            return not self.puts(mark)

        wait_for(rests, "no more pictures")

    def is_whole(self):
        """Whether the window is as large as the screen, whose mode a manager may change."""
        screen = xdotool(self.display, "getdisplaygeometry").split()
        return window_size(self) == tuple(map(int, screen))

    def await_whole(self, whole):
        wait_for(lambda: self.is_whole() == whole, "the size of the screen: %s" % whole)
        await_heard(self, whole)


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
        wait_for(lambda: window_size(cell) == (333, 244), "the last size")
        wanted = harness.memory_picture(harness.Program("teapot_afd", (333, 244)))
        wait_for(lambda: cell.picture() == wanted, "the picture of the last size")


def fullscreen_by_us(cell):
    with cell.program("--turntable", "1"):
        if cell.is_whole():
            raise Unable("windows cover the screen anyhow")
        for there, back in (("F11", "Escape"), ("F11", "F11")):
            cell.key(there)
            cell.await_whole(True)
            await_motion(cell)
            cell.key(back)
            cell.await_whole(False)
            await_motion(cell)
        cell.key("Escape")
        expect_equal(harness.ended(cell.process)[0], 0)


def fullscreen_by_manager(cell):
    if cell.manager in ("none", "twm"):
        raise Unable("knows no fullscreen")
    with cell.program("--turntable", "1"):
        if cell.is_whole():
            raise Unable("windows cover the screen anyhow")
        cell.tool("wmctrl", "-i", "-r", cell.window, "-b", "add,fullscreen")
        cell.await_whole(True)
        await_motion(cell)
        cell.key("Escape")
        cell.await_whole(False)
        await_motion(cell)
        expect(cell.process.poll() is None, "the program ended")


def minimises(cell):
    if cell.manager in ("none", "i3", "matchbox"):
        raise Unable("minimises no windows")
    with cell.program("--turntable", "1"):
        await_motion(cell)
        xdotool(cell.display, "windowminimize", cell.window)
        cell.await_rest()
        xdotool(cell.display, "windowmap", cell.window)
        if cell.manager != "twm":
            cell.tool("wmctrl", "-i", "-a", cell.window)
        await_motion(cell)


def changes_workspace(cell):
    command = MANAGERS[cell.manager][1]
    if command is None:
        raise Unable("has no workspaces")
    first, second = ("1", "2") if cell.manager == "i3" else ("0", "1")
    with cell.program("--turntable", "1"):
        await_motion(cell)
        if cell.manager in ("metacity", "mutter", "kwin"):
            cell.tool("wmctrl", "-n", "2")
        cell.tool(*command, second)
        cell.await_rest()
        cell.tool(*command, first)
        await_motion(cell)


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
            await_motion(cell)
            cell.focus()
            was_whole = cell.is_whole()
            cell.key("F11")
            if not was_whole:
                cell.await_whole(True)
                await_motion(cell)
                cell.key("Escape")
                cell.await_whole(False)
            with managed(display, "openbox"):
                wait_for(lambda: cell.eyes.has_frame(cell.window), "a frame by the new manager")
                await_motion(cell)
                cell.focus()
                cell.key("F11")
                cell.await_whole(True)
                await_motion(cell)
                cell.key("Escape")
                await_motion(cell)
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


def worse(one, other):
    """A failure counts more than what could not be tried, and that more than success."""
    return max(one, other, key=lambda word: ("o(F").index(word[0]))


class Results:
    """The worst words of each pair of a server and a manager, and how many runs said them."""

    def __init__(self, record):
        self.rows, self.times, self.record = {}, {}, record
        if record and os.path.exists(record):
            with open(record) as file:
                for line in file:
                    self.take(*json.loads(line))

    def take(self, server, manager, found):
        pair = server, manager
        row = self.rows.setdefault(pair, {})
        self.times[pair] = self.times.get(pair, 0) + 1
        for title, word in found.items():
            row[title] = worse(row.get(title, "ok"), word)

    def add(self, server, manager, found):
        self.take(server, manager, found)
        if self.record:
            with open(self.record, "a") as file:
                file.write(json.dumps([server, manager, found]) + "\n")


def table(results):
    titles = [check.__name__ for check in (*CHECKS, outlives_managers, outlives_the_server)]
    notes = []

    def short(word):
        if word == "ok":
            return "ok"
        if word not in notes:
            notes.append(word)
        return ("FAILED " if word.startswith("FAILED") else "-") + "[%d]" % (1 + notes.index(word))

    heads = ["server", "manager", "runs", *(title.replace("_", " ") for title in titles)]
    lines = ["| " + " | ".join(heads) + " |", "|---|---|--:|" + len(titles) * "---|"]
    for server in SERVERS:
        for manager in MANAGERS:
            row = results.rows.get((server, manager))
            if row:
                words = [short(row.get(title, row.get("starts", "-"))) for title in titles]
                cells = [server, manager, "%d" % results.times[server, manager], *words]
                lines.append("| " + " | ".join(cells) + " |")
    lines += [""] + ["%d. %s" % (i, note.strip("()")) for i, note in enumerate(notes, 1)]
    return "\n".join(lines) + "\n"


def write(text, path):
    with open(path) as file:
        document = file.read()
    begin, end = "<!-- displays -->\n", "<!-- end of displays -->\n"
    head, rest = document.split(begin)
    with open(path, "w") as file:
        file.write(head + begin + "\n" + text + "\n" + end + rest.split(end)[1])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--server", action="append", choices=SERVERS)
    parser.add_argument("--manager", action="append", choices=MANAGERS)
    parser.add_argument("--repeat", type=int, default=1, metavar="N")
    parser.add_argument("--record", metavar="FILE")
    parser.add_argument("--write", metavar="FILE")
    asked = parser.parse_args()
    results = Results(asked.record)
    pairs = [(server, name) for server in asked.server or SERVERS
             for name in asked.manager or MANAGERS]
    for runs in range(1, 1 + asked.repeat):
        for pair in pairs:
            if results.times.get(pair, 0) >= runs:
                continue
            found = run_cell(*pair)
            results.add(*pair, found)
            for title, word in found.items():
                start = {"o": "ok", "(": "not tested:", "F": "not ok"}[word[0]]
                print(start, "displays.%s.%s.%s" % (*pair, title), "" if word == "ok" else word,
                      flush=True)
    print(table(results))
    if asked.write:
        write(table(results), asked.write)
    sys.exit(any(word.startswith("F") for row in results.rows.values() for word in row.values()))


if __name__ == "__main__":
    main()
