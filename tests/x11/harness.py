# SPDX-License-Identifier: MIT
"""What the end-to-end tests share: checks, an X server, programs under test, pictures."""

import contextlib
import ctypes
import os
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import traceback

from onlooker import POINTER, Onlooker
from x_proxy import Proxy

BIN = os.path.abspath(os.environ["L3D_BIN"])
PATIENCE = 20  # seconds that anything may take on a busy machine before it counts as hanging
GREEN = 0x00FF80  # drawdot's dot


class Program:
    """A program under test, and how to start it with a small window."""

    def __init__(self, name, size, *always):
        self.name = name
        self.size = size
        self.always = always

    def command(self, *arguments):
        size = "%dx%d" % self.size
        return [os.path.join(BIN, self.name), "--size", size, *self.always, *arguments]


# Frames that are counted show what memory holds: no gradient, and no word about the help. These last
# longer than anybody looks.
COUNTED = ("--frames", "1000000")

DRAWDOT = Program("drawdot", (53, 31), "--classic")  # black around a dot of one pixel
PROGRAMS = [
    program
    for program in (DRAWDOT, Program("teapot_afd", (157, 119)))
    if os.path.exists(os.path.join(BIN, program.name))
]


# ---- checks -------------------------------------------------------------------------------------


class Checks:
    """Runs functions and prints `ok NAME` or `not ok NAME why` for each, `skipped NAME: why` for
    those that cannot run here."""

    def __init__(self):
        self.failed = 0

    def run(self, name, function, *arguments):
        try:
            function(*arguments)
            print("ok", name, flush=True)
        except Exception as error:  # a check may fail in any way; the others still run
            self.failed += 1
            line = traceback.extract_tb(error.__traceback__)[-1].lineno
            why = (str(error) or type(error).__name__).replace("\n", " | ")
            print("not ok %s line %d: %s" % (name, line, why), flush=True)

    def skip(self, name, why):
        print("skipped %s: %s" % (name, why), flush=True)

    def finish(self):
        sys.exit(1 if self.failed else 0)


def expect(condition, *facts):
    """A condition that must hold, and what to tell if it does not."""
    if not condition:
        raise AssertionError(" ".join(repr(fact) for fact in facts))


def expect_equal(found, wanted, what=""):
    expect(found == wanted, what, "found", found, "wanted", wanted)


def wait_for(question, what, patience=PATIENCE):
    """Asks until the answer is true, and returns it. The pauses count as patience, but the questions do not: these
    take as long as a busy machine lets them."""
    pause = 0.02
    for _ in range(round(patience / pause)):
        if answer := question():
            return answer
        time.sleep(pause)
    raise AssertionError("waited in vain for %s" % (what,))


# ---- processes ----------------------------------------------------------------------------------


def environment(display=None, **more):
    """The environment without what would steer the programs, but for what is named here."""
    ours = ("DISPLAY", "L3D_BACKEND", "L3D_FONT", "L3D_NO_SHM", "L3D_MESA")
    kept = {name: value for name, value in os.environ.items() if name not in ours}
    if display is not None:
        kept["DISPLAY"] = display
    return {**kept, **more}


@contextlib.contextmanager
def folder():
    path = tempfile.mkdtemp(prefix="l3d_x11_")
    try:
        yield path
    finally:
        shutil.rmtree(path, ignore_errors=True)


@contextlib.contextmanager
def started(command, env, **options):
    """A running process whose output is kept; it and its children are gone at the end."""
    options.setdefault("stdin", subprocess.DEVNULL)
    options.setdefault("stdout", subprocess.PIPE)
    options.setdefault("stderr", subprocess.PIPE)
    # A shell may have left SIGINT ignored, which children would inherit.
    process = subprocess.Popen(
        command,
        env=env,
        start_new_session=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
        **options,
    )
    try:
        yield process
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.communicate()


def ended(process, patience=PATIENCE):
    """Waits for the end; returns exit status, standard output and messages."""
    out, messages = process.communicate(timeout=patience)
    return process.returncode, out, messages.decode()


def run(command, env, patience=PATIENCE, **options):
    with started(command, env, **options) as process:
        return ended(process, patience)


# ---- the X server and what happens in it --------------------------------------------------------


@contextlib.contextmanager
def server_of(command, **options):
    """An X server that writes its number to the descriptor `{fd}` of its command when it is ready;
    yields its process with the attribute `display`."""
    read, write = os.pipe()
    server = subprocess.Popen(
        [word.replace("{fd}", str(write)) for word in command],
        pass_fds=[write],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        **options,
    )
    os.close(write)
    try:
        number = os.read(read, 16).decode().strip()
        expect(number.isdigit(), command[0] + " does not start here")
        server.display = ":" + number
        yield server
    finally:
        os.close(read)
        if server.poll() is None:
            server.terminate()
        server.wait()


def x_server(*options, before=()):
    """An Xvfb of its own."""
    xvfb = ["Xvfb", "-displayfd", "{fd}", "-screen", "0", "800x600x24", "-noreset"]
    return server_of([*before, *xvfb, *options])


def xdotool(display, *arguments):
    done = subprocess.run(
        ["xdotool", *map(str, arguments)],
        env=environment(display),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        timeout=PATIENCE,
    )
    return done.stdout.decode()


def window_of(display, program):
    """The number of the program's window, once it is on the screen."""
    pattern = "^%s$" % program.name
    search = ("search", "--onlyvisible", "--classname", pattern)
    return int(wait_for(lambda: xdotool(display, *search).split(), "the window")[0])


class Shown:
    """A program with its window, which is looked at through `server` whatever `display` it uses."""

    def __init__(self, program, server, *arguments, display=None, before=(), cwd=None, **variables):
        self.program, self.server = program, server
        self.command = [*before, *program.command(*arguments)]
        self.environment = environment(display or server.display, **variables)
        self.cwd = cwd

    def __enter__(self):
        with contextlib.ExitStack() as stack:
            self.eyes = self.onlooker(stack)
            self.process = stack.enter_context(
                started(self.command, self.environment, cwd=self.cwd)
            )
            self.window = window_of(self.server.display, self.program)
            self.stack = stack.pop_all()
        return self

    def __exit__(self, *error):
        self.stack.__exit__(*error)

    def onlooker(self, stack):
        return stack.enter_context(Onlooker(self.server.display))

    def press(self, *keys):
        xdotool(self.server.display, "key", "--window", self.window, *keys)

    def picture(self, size=None):
        return self.eyes.picture(self.window, *(size or self.program.size))

    def await_picture(self, question, size=None, what="the picture"):
        return wait_for(lambda: question(self.picture(size)), what)

    def expect_end(self, status, messages=""):
        expect_equal(ended(self.process), (status, b"", messages))


class Session(Shown):
    """A program in a window of a server of its own, which has drawn its first picture.

    `prepare` is called with the display before the program starts; if `counted`, a proxy stands
    between, which counts requests, and has what `faults` name.
    """

    def __init__(self, program, *arguments, prepare=lambda _: None, counted=False, faults=None, **more):
        self.asked = program, arguments, more
        self.prepare, self.counted, self.proxy = prepare, counted, None
        self.faults = faults or {}

    def __enter__(self):
        program, arguments, more = self.asked
        with contextlib.ExitStack() as stack:
            self.server = stack.enter_context(x_server())
            self.display = self.server.display
            self.prepare(self.display)
            if self.counted:
                self.proxy = stack.enter_context(Proxy(self.display, **self.faults))
                more = {"display": self.proxy.display, **more}
            super().__init__(program, self.server, "--backend", "ximage", *arguments, **more)
            stack.push(super().__enter__().stack)
            self.await_picture(has_picture)
            self.stack = stack.pop_all()
        return self

    def onlooker(self, _):
        """Stays: its connection is gone if the server is, and Xlib would end the tests."""
        return Onlooker(self.display)


def window_size(it):
    shell = xdotool(it.display, "getwindowgeometry", "--shell", it.window)
    values = dict(line.split("=") for line in shell.split())
    return int(values.get("WIDTH", 0)), int(values.get("HEIGHT", 0))


def is_quiet(proxy, seconds=0.3):
    """Whether no request passes for a while."""
    mark = proxy.mark()
    time.sleep(seconds)
    return not (proxy.mark() - mark).requests


def await_rest(it, seconds=0.3):
    wait_for(lambda: is_quiet(it.proxy, seconds), "no more requests")


def await_motion(it):
    """Returns when pictures come."""
    mark = it.proxy.mark()
    wait_for(lambda: (it.proxy.mark() - mark).requests.count("PutImage") > 2, "pictures")


def await_heard(it, on):
    """Returns when the program knows whether it covers the screen: it watches the pointer as long as it does."""
    wait_for(lambda: it.eyes.is_watched(it.window, POINTER) == on, "the program to hear of its size: %s" % on)


def settle(it):
    """Stops what moves."""
    xdotool(it.display, "key", "space")
    await_still(it)


def await_still(it, size=None):
    """A picture that stays: what keys and seconds change in it has changed."""
    pictures = []

    def is_still(rows):
        pictures.append(rows)
        return len(pictures) > 5 and all(each == rows for each in pictures[-5:]) and rows

    return it.await_picture(is_still, size, "a picture that stays")


# ---- pictures -----------------------------------------------------------------------------------


def memory_picture(program, *arguments):
    """The picture that the program makes without a display."""
    with folder() as path:
        file = os.path.join(path, "picture.png")
        command = program.command("--backend", "memory", "--output", file, *arguments)
        expect_equal(run(command, environment()), (0, b"", ""))
        return read_png(file)


class PngImage(ctypes.Structure):
    """libpng's png_image, of its simplified way of reading."""

    _fields_ = [("inner", ctypes.c_void_p),
                *((name, ctypes.c_uint32) for name in "version width height format flags entries failed".split()),
                ("message", ctypes.c_char * 64)]
    VERSION, BGRA = 1, 0x13


def read_png(path):
    """Rows of colours 0xRRGGBB of an 8-bit RGB or RGBA file that is not interlaced; alpha is left out. libpng
    undoes the filters, which takes Python half a second a picture."""
    with open(path, "rb") as file:
        head = file.read(29)
    expect_equal(head[:16], b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", path)
    width, height, depth, colours, interlaced = struct.unpack(">IIBB2xB", head[16:])
    expect_equal((depth, colours in (2, 6), interlaced), (8, True, 0), path)
    png, image = ctypes.CDLL("libpng16.so.16"), PngImage(version=PngImage.VERSION)
    pixels = bytearray(4 * width * height)
    begun = png.png_image_begin_read_from_file(ctypes.byref(image), os.fsencode(path))
    image.format = PngImage.BGRA
    whole = (ctypes.c_char * len(pixels)).from_buffer(pixels)
    done = begun and png.png_image_finish_read(ctypes.byref(image), None, whole, 0, None)
    expect(done, path, image.message)
    pixels[3::4] = bytes(width * height)
    return [list(row) for row in struct.iter_unpack("<%dI" % width, pixels)]


def has_picture(rows):
    """Whether a row has more than one colour, or is drawdot's line from side to side: a background alone has one colour
    for each row."""
    return rows is not None and any(len(set(row)) > 1 or row[0] == GREEN for row in rows)


def covered(rows):
    """Where something is drawn, if the background is seen at the left side of each row."""
    return [[pixel != row[0] for pixel in row] for row in rows]
