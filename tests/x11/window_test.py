#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every program in a window: keys, close, resize, expose, signals, a server that dies."""

import os
import signal
import subprocess
import time

import harness
from harness import Checks, Session, await_motion, await_rest, await_still, environment, expect
from harness import expect_equal, folder, run, settle, started, wait_for, window_of, window_size, x_server
from harness import xdotool


def quits_by_key(program):
    with Session(program) as it:
        xdotool(it.display, "key", "q")
        it.expect_end(0)


def quits_by_key_sent_to_the_window(program):
    with Session(program) as it:
        xdotool(it.display, "key", "--window", it.window, "q")
        it.expect_end(0)


def closes_by_the_window_managers_button(program):
    with Session(program) as it:
        it.eyes.ask_to_close(it.window)
        it.expect_end(0)


def survives_the_loss_of_its_window(program):
    with Session(program) as it:
        xdotool(it.display, "windowclose", it.window)  # destroys it
        it.expect_end(0)


def tells_that_it_was_cut_off(program):
    with Session(program) as it:
        xdotool(it.display, "windowkill", it.window)  # cuts the connection
        it.expect_end(6, program.name + ": the display was lost\n")


def tells_that_the_server_died(program):
    with folder() as path, Session(program, "--output", "last.png", cwd=path) as it:
        it.server.kill()
        it.expect_end(6, program.name + ": the display was lost\n")
        rows = harness.read_png(os.path.join(path, "last.png"))
        expect(harness.has_picture(rows), "the last picture is empty")


def dies_by_the_signal(program):
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT):
        with folder() as path, Session(program, "--output", "last.png", cwd=path) as it:
            it.process.send_signal(number)
            it.expect_end(-number)
            rows = harness.read_png(os.path.join(path, "last.png"))
            expect(harness.has_picture(rows), "the last picture is empty")


def repairs_what_was_covered(program):
    with Session(program) as it:
        settle(it)
        before = it.picture()
        with it.eyes.cover(program.size[0] // 2, program.size[1] - 7):
            pass
        it.await_picture(lambda rows: rows == before, what="the uncovered picture")


def repairs_with_one_picture(program):
    with Session(program, counted=True) as it:
        settle(it)
        with it.eyes.cover(program.size[0] // 2, program.size[1] - 7):
            await_rest(it)
            mark = it.proxy.mark()
        wait_for(lambda: (it.proxy.mark() - mark).requests, "the repair")
        await_rest(it)
        expect_equal((it.proxy.mark() - mark).requests.count("PutImage"), 1)


def rests_when_nothing_moves(program):
    with Session(program) as it:
        settle(it)
        ticks = lambda: sum(map(int, stat_fields(it.process.pid)[11:13]))  # user and system time
        before = ticks()
        time.sleep(1)
        share = (ticks() - before) / os.sysconf("SC_CLK_TCK")
        expect(share < 0.2, "processor time in one idle second:", share)


def stat_fields(pid):
    with open("/proc/%d/stat" % pid) as file:
        return file.read().rpartition(")")[2].split()


def resizes_its_picture(program):
    """The picture fills the new size: drawdot's dot moves on, the teapot is centred again."""
    for size in ((211, 97), (97, 211), (1, 1), (401, 302)):
        with Session(program) as it:
            xdotool(it.display, "windowsize", it.window, *size)
            if size == (1, 1):
                it.await_picture(lambda rows: rows is not None, size)
            else:
                it.await_picture(lambda rows: fills(program, rows), size, "the new size")
            xdotool(it.display, "key", "--window", it.window, "q")
            it.expect_end(0)


def fills(program, rows):
    if rows is None:
        return False
    if program is harness.DRAWDOT:  # the dot has come past the old border
        edge = min(program.size[0], len(rows[0]) - 2)
        return rows[0][edge] == harness.GREEN
    # Something is drawn in the right half and in the lower half.
    right = [row[len(row) // 2 + 1 :] for row in rows]
    return harness.has_picture(right) and harness.has_picture(rows[len(rows) // 2 + 1 :])


def covers_the_screen_and_goes_back(program):
    whole = (800, 600)
    with Session(program) as it:
        for there, back in (("F11", "Escape"), ("alt+Return", "F11")):
            for key, size in ((there, whole), (back, program.size)):
                xdotool(it.display, "key", key)
                it.await_picture(lambda _: window_size(it) == size, what="the size after " + key)
                it.await_picture(harness.has_picture, size)
        xdotool(it.display, "key", "Escape")
        it.expect_end(0)


def shows_large_pixels(program):
    """Asked to by an option, whatever the display's resources."""
    with Session(program, "--scale", "3") as it:
        expect_large_pixels(it, 3)
    with Session(program, "--scale", "1", prepare=fine(192)) as it:
        expect_equal(window_size(it), program.size)


def draws_at_the_displays_resolution():
    """A fine display has a larger picture, no larger pixels; files are as large as asked for."""
    program = harness.PROGRAMS[-1]
    width, height = program.size
    for dpi in (144, 192):
        size = (round(width * dpi / 96 + 0.01), round(height * dpi / 96 + 0.01))
        with Session(program, prepare=fine(dpi)) as it:
            wait_for(lambda: window_size(it) == size, "the size %dx%d" % size)
            it.await_picture(lambda rows: has_thin_things(rows), size, "pixels of its own size")
        with Session(program, "--frames", "1000000", prepare=fine(dpi)) as it:
            expect_equal(window_size(it), program.size)


def draws_lines_as_wide_as_the_resolution_asks():
    """Pictures twice as fine have lines twice as wide: they cover about the same share. Wireframes have
    some more of them, for steps are chosen in pixels."""
    for lines in (("--wireframe",), ("--wireframe", "--antialias", "off"), ("--net",)):
        shares = []
        for dpi in (96, 192):
            scale = dpi // 96
            program = harness.Program("teapot_afd", (300, 225))
            with Session(program, *lines, "--background", "0,0,0", prepare=fine(dpi)) as it:
                size = tuple(scale * side for side in program.size)
                # Any key makes the word about the help go away.
                xdotool(it.display, "key", "--clearmodifiers", "r")
                it.await_picture(lambda rows: rows and brightness(rows[len(rows) // 2]), size)
                rows = await_still(it, size)
                shares.append(sum(map(brightness, rows)) / scale**2)
        expect(0.85 < shares[1] / shares[0] < 1.3, lines, shares)


def brightness(row):
    return sum(word >> 8 & 255 for word in row)


def has_thin_things(rows):
    """Whether some pixel differs from both neighbours in its row: no doubled pixel does so."""
    return rows and any(
        row[x - 1] != row[x] != row[x + 1] for row in rows for x in range(1, len(row) - 1)
    )


def fine(dpi):
    return lambda display: set_resolution(display, dpi)


def teapot_follows_the_resolution():
    """Letters grow while the program runs, by the display's resources and by XSETTINGS."""
    program = harness.Program("teapot_afd", (640, 400))
    with Session(program) as it:
        bare = it.picture()
        xdotool(it.display, "key", "h")
        # A picture that is just arriving differs as well: it travels in pieces.
        it.await_picture(lambda rows: rows != bare, what="the help")
        small = harness.await_still(it)
        set_resolution(it.display, 192)
        it.await_picture(lambda rows: rows != small, what="larger letters")
        large = harness.await_still(it)
        for dpi, wanted in ((96, small), (192, large)):
            it.eyes.serve_settings(dpi)
            it.await_picture(lambda rows: rows == wanted, what="letters for %d" % dpi)
        expect_equal(window_size(it), program.size)


def set_resolution(display, dpi):
    resources = "Xft.dpi: %d\n" % dpi
    command = ["xprop", "-root", "-f", "RESOURCE_MANAGER", "8s"]
    command += ["-set", "RESOURCE_MANAGER", resources]
    subprocess.run(command, env=environment(display), check=True, timeout=harness.PATIENCE)


def expect_large_pixels(it, scale):
    width, height = it.program.size
    size = (scale * width, scale * height)
    expect_equal(window_size(it), size)
    settle(it)
    rows = it.await_picture(harness.has_picture, size) and it.picture(size)
    for y, row in enumerate(rows):
        first = rows[y - y % scale]
        expect(all(row[x] == first[x - x % scale] for x in range(size[0])), "row", y)


def grows_in_its_own_colours(program):
    """What the server shows until the program comes to draw: the mean of the last column."""
    width, height = program.size
    size = (width + 40, height + 30)
    with Session(program) as it:
        settle(it)
        column = [row[-1] for row in it.picture()]
        means = [sum(word >> shift & 255 for word in column) // height for shift in (16, 8, 0)]
        it.process.send_signal(signal.SIGSTOP)
        xdotool(it.display, "windowsize", it.window, *size)
        rows = wait_for(lambda: it.picture(size), "the larger window")
        it.process.send_signal(signal.SIGCONT)
        margin = {word for row in rows[height:] for word in row}
        margin |= {word for row in rows for word in row[width:]}
        expect_equal(margin, {means[0] << 16 | means[1] << 8 | means[2]}, "new parts")


def tells_who_it_is(program):
    with Session(program) as it:
        for question in (
            ("--classname", "^%s$" % program.name),
            ("--class", "^L3d$"),
            ("--pid", it.process.pid, "--name", "."),
        ):
            search = ("search", "--onlyvisible", "--all", *question)
            wait_for(lambda: xdotool(it.display, *search).split() == [str(it.window)], question)


def has_the_title_that_was_asked_for(program):
    """Else that of the model, if it shows one, and its own name."""
    title = "Teekanne für Öl"
    usual = {"drawdot": "drawdot", "teapot_afd": "Utah teapot - teapot_afd"}
    for options, wanted in (((), usual[program.name]), (("--title", title), title)):
        with Session(program, *options) as it:
            command = ["xprop", "-id", str(it.window), "_NET_WM_NAME"]
            out = run(command, environment(it.display, LC_ALL="C.UTF-8"))[1].decode()
            expect_equal(out, '_NET_WM_NAME(UTF8_STRING) = "%s"\n' % wanted)


def survives_a_storm_of_sizes(program):
    with Session(program) as it:
        steps = []
        for i in range(150):
            steps += ["windowsize", it.window, 60 + 7 * i % 301, 50 + 11 * i % 211]
        xdotool(it.display, *steps, "windowsize", it.window, 233, 144)
        it.await_picture(lambda rows: rows is not None, (233, 144), "the last size")
        it.eyes.ask_to_close(it.window)
        it.expect_end(0)


def shows_what_memory_holds(program):
    """The same frames from the window's back-end and from memory are the same, bit for bit."""
    with x_server() as server:
        streams = []
        for backend in ("ximage", "memory"):
            command = program.command("--backend", backend, "--frames", "4", "--fps", "50")
            status, out, messages = run(
                [*command, "--output", "-"], environment(server.display)
            )
            expect_equal((status, messages), (0, ""), backend)
            streams.append(out)
    expect(streams[0] == streams[1], "the pictures differ")


def starts_without_a_terminal(program):
    """With a display, and nobody to ask, there is a window at once."""
    read, write = os.pipe()  # never written to, never closed
    for name, stdin in (("null", subprocess.DEVNULL), ("silent pipe", read)):
        with x_server() as server:
            env = environment(server.display)
            with started(program.command(), env, stdin=stdin) as process:
                window = window_of(server.display, program)
                xdotool(server.display, "key", "--window", window, "q")
                expect_equal(harness.ended(process), (0, b"", ""), name)
    with x_server() as server:
        command = ["sh", "-c", 'exec "$0" "$@" <&-', *program.command()]
        with started(command, environment(server.display)) as process:
            window = window_of(server.display, program)
            xdotool(server.display, "key", "--window", window, "q")
            expect_equal(harness.ended(process), (0, b"", ""), "closed")
    os.close(read)
    os.close(write)


def keeps_its_words_out_of_the_connection(program):
    """Without standard error, the connection to the server must not get its number, 2."""
    with x_server() as server:
        command = ["sh", "-c", 'exec "$0" "$@" 2>&-', *program.command("--verbose")]
        with started(command, environment(server.display)) as process:
            window = window_of(server.display, program)
            xdotool(server.display, "key", "--window", window, "q")
            expect_equal(harness.ended(process), (0, b"", ""))


CHECKS = (
    quits_by_key,
    quits_by_key_sent_to_the_window,
    closes_by_the_window_managers_button,
    survives_the_loss_of_its_window,
    tells_that_it_was_cut_off,
    tells_that_the_server_died,
    dies_by_the_signal,
    repairs_what_was_covered,
    repairs_with_one_picture,
    rests_when_nothing_moves,
    resizes_its_picture,
    covers_the_screen_and_goes_back,
    shows_large_pixels,
    grows_in_its_own_colours,
    tells_who_it_is,
    has_the_title_that_was_asked_for,
    survives_a_storm_of_sizes,
    shows_what_memory_holds,
    starts_without_a_terminal,
    keeps_its_words_out_of_the_connection,
)


def drawdot_obeys_its_keys():
    """'l', then 'j', then 'h': runs to the right, down and to the left; 'k' back up; space."""
    green = harness.GREEN
    width, height = harness.DRAWDOT.size
    with Session(harness.DRAWDOT) as it:
        for key, x, y in (("l", width - 1, 0), ("j", width - 1, height - 1), ("h", 0, height - 1)):
            xdotool(it.display, "key", key)
            it.await_picture(lambda rows: rows[y][x] == green, what="the border after " + key)
        frame = [0] + (width - 2) * [0] + [green]
        wanted = [width * [green]] + (height - 2) * [frame] + [width * [green]]
        expect_equal(it.picture(), wanted)
        xdotool(it.display, "key", "k")
        it.await_picture(lambda rows: rows[height // 2][0] == green, what="the way up")
        xdotool(it.display, "key", "q")
        it.expect_end(0)


def drawdot_keeps_its_trail_in_a_smaller_window():
    """Running along the bottom when that is taken away, the dot goes on along the new one."""
    green = harness.GREEN
    width, height = harness.DRAWDOT.size
    with Session(harness.DRAWDOT) as it:
        for key, x, y in (("j", None, height - 1), ("l", width - 1, height - 1)):
            xdotool(it.display, "key", key)
            reached = lambda rows: green in rows[y] if x is None else rows[y][x] == green
            it.await_picture(reached, what="the border after " + key)
        turn = it.picture()[0].count(green) - 1
        xdotool(it.display, "windowsize", it.window, width, 20)
        is_back = lambda rows: rows is not None and rows[19][width - 1] == green
        it.await_picture(is_back, (width, 20), "the dot in the smaller window")
        rows = it.picture((width, 20))
        expect_equal(rows[0], (turn + 1) * [green] + (width - turn - 1) * [0])
        down = turn * [0] + [green] + (width - turn - 1) * [0]
        expect_equal(rows[1:19], 18 * [down])
        expect_equal(rows[19], down[:-1] + [green])


def teapot_draws_nothing_that_nobody_sees():
    with Session(harness.PROGRAMS[-1], counted=True) as it:
        xdotool(it.display, "key", "t")
        await_motion(it)
        with it.eyes.cover(800, 600):
            await_rest(it)
        await_motion(it)


if __name__ == "__main__":
    checks = Checks()
    for program in harness.PROGRAMS:
        for check in CHECKS:
            checks.run("window.%s.%s" % (program.name, check.__name__), check, program)
    for check in (
        drawdot_obeys_its_keys,
        drawdot_keeps_its_trail_in_a_smaller_window,
        teapot_draws_nothing_that_nobody_sees,
        draws_at_the_displays_resolution,
        teapot_follows_the_resolution,
        draws_lines_as_wide_as_the_resolution_asks,
    ):
        checks.run("window." + check.__name__, check)
    checks.finish()
