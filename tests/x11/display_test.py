#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Displays that die, break, crawl or refuse shared memory, and what the programs make of them."""

import contextlib
import os
import random
import signal
import subprocess
import time

import harness
from harness import Checks, Shown, environment, expect, expect_equal, folder, is_quiet, started
from harness import wait_for, x_server, xdotool
from x_proxy import Proxy

BACKENDS = ("ximage", "xshm")
DRAWDOT, TEAPOT = harness.PROGRAMS
MOVING = {DRAWDOT: (), TEAPOT: ("--turntable", "3")}
FRAMES_TO_READ_KEYS = 3  # what a key means: asked for with one, answered by the next, then read
WAKING = {DRAWDOT: "j", TEAPOT: "space"}
DEATHS = {DRAWDOT: range(3, 90, 10), TEAPOT: range(1, 300, 10)}  # the dot comes to the border
PICTURES = ("PutImage", "MIT-SHM.PutImage")
PUTS = {"ximage": 1, "xshm": 1}  # up to the first picture
STARTING = {"ximage": 22, "xshm": 30}  # and eight requests: seven ask, one shares
COLOURED = ("--shade", "normals")
LAST_OF_QUESTION = "GetSelectionOwner"  # and a property follows
LAST_OF_OPENING = "XKEYBOARD.0"  # the last request that XOpenDisplay makes
KEYBOARD = "XKEYBOARD.8"  # GetMap
NO_KEY_OF_OURS = "U2603"  # a snowman: xdotool gives the server a new keyboard to type it
GOODBYE = 5  # seconds to end in: one by the requirement, the rest for sanitizers and a busy machine
SEED = random.randrange(1 << 32)


# ---- death --------------------------------------------------------------------------------------


def dies_with_its_display(program, backend, numbers):
    """From its first request on: exit code 6, and one line."""
    # In fixed steps of time: else a machine that stalls brings the dot to its border early.
    fixed = ("--fps", "500", "--frames", "100000")
    command = program.command("--backend", backend, *fixed, *MOVING[program])
    with x_server() as server:
        last = last_of_opening(server, command)
        for number in numbers:
            with Proxy(server.display, die_after=number) as proxy:
                expect_death(command, proxy, number, number <= last)


def last_of_opening(server, command):
    """The number of the last request with which the display is first opened."""
    with Proxy(server.display) as proxy, started(command, environment(proxy.display)):
        wait_for(lambda: pictures(proxy.mark()), "the first picture")
        names = proxy.mark().requests
    return names.index(LAST_OF_OPENING) + 1


def expect_death(command, proxy, number, opening):
    wanted, what = 6, "request %d" % number
    # Xlib loses what it had begun when the display dies while it is opened.
    sanitizer = {"ASAN_OPTIONS": "detect_leaks=0"} if opening else {}
    with started(command, environment(proxy.display, **sanitizer)) as process:
        wait_for(lambda: not proxy.is_listening or process.poll() is not None, what)
        start = time.monotonic()
        status, out, said = harness.ended(process)
        took = time.monotonic() - start
        expect_equal((status, out, said.count("\n")), (wanted, b"", 1), (what, said))
        expect(took < GOODBYE, what, "seconds", took)
        return process.pid


# ---- rest ---------------------------------------------------------------------------------------

# Of the processor, while nothing is shown: five hundred updates a second, as --fps asks for here,
# take half a per cent of a slow one, a loop that does not sleep all of it.
RESTING = 0.02


def rests_when_paused(program, backend, seconds=2):
    with x_server() as server, Proxy(server.display) as proxy:
        with Shown(program, server, "--backend", backend, *MOVING[program],
                   display=proxy.display) as it:
            it.press("space")
            wait_for(lambda: is_quiet(proxy), "a pause in the requests")
            mark, busy = proxy.mark(), cpu_seconds(it.process)
            time.sleep(seconds)
            passed = proxy.mark() - mark
            share = (cpu_seconds(it.process) - busy) / seconds
            expect_equal(passed.requests, [])
            expect(share < RESTING, "share of the processor", share)
            it.press(WAKING[program])
            wait_for(lambda: proxy.mark().requests[len(mark.requests) :], "life after the pause")
            it.press("q")
            it.expect_end(0)


def cpu_seconds(process):
    """To the nanosecond; /proc/PID/stat counts in hundredths."""
    with open("/proc/%d/schedstat" % process.pid) as file:
        return int(file.read().split()[0]) / 1e9


def waits_for_no_answer(program, backend):
    """In steady state no frame has a round trip. The question about the window's state, once after
    the first picture, has replies that nobody waits for."""
    with x_server() as server, Proxy(server.display) as proxy:
        with Shown(program, server, "--backend", backend, *MOVING[program],
                   display=proxy.display):
            asked = wait_for(lambda: LAST_OF_QUESTION in proxy.mark().requests and proxy.mark(),
                             "the question")
            wait_for(lambda: pictures(proxy.mark() - asked) >= 9, "pictures after it")
            mark = proxy.mark()
            wait_for(lambda: pictures(proxy.mark() - mark) >= 20, "twenty pictures")
            expect_equal((proxy.mark() - mark).replied, [])


def starts_with_few_requests(program, backend):
    """Up to the first picture in the window, the setting up of Xlib among them."""
    with x_server() as server, Proxy(server.display) as proxy:
        with Shown(program, server, "--backend", backend, display=proxy.display):
            wait_for(lambda: pictures(proxy.mark()) >= PUTS[backend], "the first picture")
            names = proxy.mark().requests
            puts = [at for at, name in enumerate(names, 1) if name in PICTURES]
            expect(puts[PUTS[backend] - 1] <= STARTING[backend], names)


def pictures(traffic):
    return sum(name in PICTURES for name in traffic.requests)


# ---- kinds of displays --------------------------------------------------------------------------


def serves(server, display=None, backend="xshm", **how):
    """The teapot in the window is that of memory, and the program ends well."""
    with Shown(TEAPOT, server, "--backend", backend, *harness.COUNTED, *COLOURED, display=display, **how) as it:
        wanted = harness.memory_picture(TEAPOT, *COLOURED)
        wait_for(lambda: it.picture() == wanted, "the picture that memory holds")
        it.press("q")
        status, out, said = harness.ended(it.process)
        expect_equal((status, out, said.count("\n") <= 1), (0, b"", True), said)


def serves_without_shared_memory(backend):
    with x_server("-extension", "MIT-SHM") as server:
        serves(server, backend=backend)


def serves_through(backend, **faults):
    with x_server() as server, Proxy(server.display, **faults) as proxy:
        serves(server, proxy.display, backend)
        expect("PutImage" in proxy.mark().requests, "nothing went over the wire")


def serves_over_tcp(backend):
    with x_server("-listen", "tcp") as server:
        serves(server, "127.0.0.1" + server.display, backend)


NOBODY = ("setpriv", "--reuid=65534", "--regid=65534", "--clear-groups")
APART = ("unshare", "--ipc")


def may(*command):
    """Whether we have the right to start programs so."""
    return subprocess.run([*command, "true"], stderr=subprocess.DEVNULL).returncode == 0


def serves_another_user(backend):
    with x_server("-ac") as server:
        serves(server, backend=backend, before=NOBODY)


# Sixteen segments of other programs, large enough for the picture; then the server.
CROWD = """
import ctypes, os, sys
libc = ctypes.CDLL(None)
libc.shmat.restype = ctypes.c_void_p
for _ in range(16):
    number = libc.shmget(0, 1 << 22, 0o1666)
    ctypes.memset(libc.shmat(number, None, 0), 0x5a, 1 << 22)
os.execvp(sys.argv[1], sys.argv[1:])
"""


def serves_across_namespaces(backend, way="MIT-SHM.PutImage", **faults):
    """A file that is handed over has no number. Segments are numbered from 0 in either namespace:
    the server has others under the same numbers."""
    way = "PutImage" if backend == "ximage" else way
    with x_server(before=(*APART, "python3", "-c", CROWD)) as server:
        with Proxy(server.display, **faults) as proxy:
            serves(server, proxy.display, backend, before=APART)
            expect_equal([name for name in proxy.mark().requests if name in PICTURES][-1], way)


def finds_other_memory_in_another_namespace(backend):
    serves_across_namespaces(backend, "PutImage", shm_no_files=True)


def goes_on_when_shared_memory_breaks(**faults):
    """No picture is lost: the last one is in the window."""
    with folder() as path, x_server() as server, Proxy(server.display, **faults) as proxy:
        with Shown(TEAPOT, server, "--backend", "xshm", *harness.COUNTED, *COLOURED,
                   display=proxy.display, cwd=path) as it:
            wait_for(lambda: pictures(proxy.mark()) >= PUTS["xshm"], "the first picture")
            for _ in range(12):
                mark = proxy.mark()
                it.press("Left")
                wait_for(lambda: pictures(proxy.mark() - mark), "the next picture")
            wait_for(lambda: "PutImage" in proxy.mark().requests, "a picture over the wire")
            wait_for(lambda: is_quiet(proxy), "a pause in the requests")
            shown, passed = it.picture(), proxy.mark().requests
            it.press("s")
            file = os.path.join(path, "l3d-0001.png")
            wait_for(lambda: os.path.exists(file) and is_quiet(proxy), "the saved picture")
            expect(shown == harness.read_png(file), "the window has another picture")
            expect(5 <= passed.count("MIT-SHM.PutImage"), "by shared memory", passed)
            it.press("q")
            status, out, said = harness.ended(it.process)
            expect_equal((status, out, said.count("\n")), (0, b"", 1), said)


def leaves_no_segment(program, runs):
    """However early or late it is killed; segments are told apart by the process that made them.

    System V cannot make a segment and take its name away in one call: of a hundred programs, one or
    two may have been killed between the two on a busy machine. If names stayed, most would leave one.
    """
    chance = random.Random(SEED)
    with x_server() as server, Proxy(server.display, shm_no_files=True) as proxy:
        killed = []
        for _ in range(runs):
            command = program.command("--backend", "xshm", *MOVING[program])
            with started(command, environment(proxy.display)) as process:
                time.sleep(chance.uniform(0, 0.3))
                process.kill()
                killed.append(process.pid)
        # What the server still has ends with its connection; what nobody has would stay for ever.
        attached = lambda row: row["nattch"] != "0"
        wait_for(lambda: not any(map(attached, segments_of(killed))), "the end of the segments")
        left = segments_of(killed)
        for row in left:
            subprocess.run(["ipcrm", "-m", row["shmid"]], check=True)
        expect(len(left) <= runs // 20, "segments left", left)


def segments_of(makers):
    with open("/proc/sysvipc/shm") as file:
        columns = file.readline().split()
        rows = [dict(zip(columns, line.split())) for line in file]
    return [row for row in rows if int(row["cpid"]) in makers]


# ---- displays that do not answer ----------------------------------------------------------------


@contextlib.contextmanager
def stopped(server):
    """The server sleeps, and what was under way to it is done."""
    server.send_signal(signal.SIGSTOP)
    time.sleep(0.3)
    try:
        yield
    finally:
        server.send_signal(signal.SIGCONT)


def waits_for_a_stopped_server(program, backend, seconds=1.5):
    with x_server() as server:
        with Shown(program, server, "--backend", backend, *MOVING[program]) as it:
            with stopped(server):
                busy = cpu_seconds(it.process)
                time.sleep(seconds)
                share = (cpu_seconds(it.process) - busy) / seconds
                expect(share < RESTING, "share of the processor", share)
            before = it.picture()
            it.press("j")  # drawdot may have come to the right border
            for _ in range(FRAMES_TO_READ_KEYS):
                wait_for(lambda: it.picture() != before, "life after the stop")
                before = it.picture()
            with stopped(server):
                start = time.monotonic()
                it.process.send_signal(signal.SIGINT)
                it.expect_end(-signal.SIGINT)
                took = time.monotonic() - start
                expect(took < GOODBYE, "seconds", took)


def hears_signals_with_a_key_unread(backend, *keys):
    """The server told of keys before it stopped. What they mean is known by then, or they wait."""
    with x_server() as server, Proxy(server.display) as proxy:
        xdotool(server.display, "key", "j")  # the server's first key tells of a keyboard, too
        with Shown(TEAPOT, server, "--backend", backend, display=proxy.display) as it:
            wait_for(lambda: KEYBOARD in proxy.mark().requests, "a question for the keyboard")
            it.process.send_signal(signal.SIGSTOP)
            it.press(*keys)
            with stopped(server):
                it.process.send_signal(signal.SIGCONT)
                time.sleep(0.3)  # the keys are read first
                it.process.send_signal(signal.SIGINT)
                it.expect_end(-signal.SIGINT)


def obeys_keys_after_a_new_keyboard(backend):
    """In one go: the change waits for an answer of the server, and the keys wait for the change."""
    with x_server() as server:
        with Shown(TEAPOT, server, "--backend", backend) as it:
            for _ in range(5):
                before = it.picture()
                it.press(NO_KEY_OF_OURS, "Left")
                wait_for(lambda: it.picture() != before, "another view")
            it.press(NO_KEY_OF_OURS, "q")
            it.expect_end(0)


def obeys_on_a_slow_wire():
    """At two megabytes per second a frame takes more than half a second. Less than two follow a key."""
    program, frame = harness.Program("teapot_afd", (640, 480)), 4 * 640 * 480
    with x_server() as server, Proxy(server.display, rate=2e6) as proxy:
        with Shown(program, server, "--backend", "ximage", *MOVING[TEAPOT],
                   display=proxy.display) as it:
            wait_for(lambda: pictures(proxy.mark()) >= 2, "two pictures")
            size = resident_bytes(it.process)
            wait_for(lambda: pictures(proxy.mark()) >= 6, "six pictures")
            grown = resident_bytes(it.process) - size
            expect(grown < frame, "bytes more in memory", grown)
            mark = proxy.mark()
            it.eyes.press_key(it.window, "q")
            it.expect_end(0)
            sent = (proxy.mark() - mark).bytes_up
            expect(sent < 2 * frame, "bytes after the key", sent)


def resident_bytes(process):
    with open("/proc/%d/statm" % process.pid) as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def names_the_display_it_cannot_open(program):
    start = time.monotonic()
    with contextlib.ExitStack() as stack:
        for value in (None, "", ":99999", "foo", "no.such.host.invalid:0", "192.0.2.1:7"):
            command = program.command("--no-input", "--backend", "ximage")
            process = stack.enter_context(started(command, environment(value)))
            stack.callback(expect_no_display, process, value, start)


def expect_no_display(process, value, start):
    status, out, said = harness.ended(process)
    expect_equal((status, out, said.count("\n")), (3, b"", 1), (value, said))
    expect("DISPLAY" in said and (value or "") in said, value, said)
    took = time.monotonic() - start
    expect(took < 5, value, took)


# ---- all of them --------------------------------------------------------------------------------


def check_program(checks, program, backend):
    for check, *arguments in (
        (starts_with_few_requests,),
        (waits_for_no_answer,),
        (rests_when_paused,),
        (waits_for_a_stopped_server,),
        (dies_with_its_display, DEATHS[program]),
    ):
        name = "display.%s.%s.%s" % (program.name, backend, check.__name__)
        checks.run(name, check, program, backend, *arguments)


def check_backend(checks, backend):
    for check, right in (
        (serves_without_shared_memory, ()),
        (serves_over_tcp, ()),
        (serves_another_user, NOBODY),
        (serves_across_namespaces, APART),
        (finds_other_memory_in_another_namespace, APART),
    ):
        name = "display.%s.%s" % (backend, check.__name__)
        if may(*right):
            checks.run(name, check, backend)
        else:
            checks.skip(name, "it needs the right to " + " ".join(map(str, right)))
    for what, keys in (("a_key", ("Left",)), ("a_new_keyboard", (NO_KEY_OF_OURS, "Left"))):
        name = "display.%s.hears_signals_with_%s_unread" % (backend, what)
        checks.run(name, hears_signals_with_a_key_unread, backend, *keys)
    checks.run("display.%s.obeys_keys_after_a_new_keyboard" % backend,
               obeys_keys_after_a_new_keyboard, backend)
    for fault in ({"hide": ("MIT-SHM",)}, {"shm_badrequest": True}, {"shm_badaccess": True}):
        name = "display.%s.serves_through.%s" % (backend, *fault)
        checks.run(name, lambda: serves_through(backend, **fault))


def main():
    print("seed", SEED)
    checks = Checks()
    for program in harness.PROGRAMS:
        name = "display.%s." % program.name
        checks.run(name + "names", names_the_display_it_cannot_open, program)
        checks.run(name + "leaves_no_segment", leaves_no_segment, program, 10)
        for backend in BACKENDS:
            check_program(checks, program, backend)
    for backend in BACKENDS:
        check_backend(checks, backend)
    # At the 13th, the first picture among them, no other picture follows.
    for fault in ({"shm_break": 7}, {"shm_break": 13}, {"shm_swallow": 13}):
        name = "display.goes_on.%s.%d" % next(iter(fault.items()))
        checks.run(name, lambda: goes_on_when_shared_memory_breaks(**fault))
    checks.run("display.obeys_on_a_slow_wire", obeys_on_a_slow_wire)
    checks.finish()


if __name__ == "__main__":
    main()
