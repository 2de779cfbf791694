# SPDX-License-Identifier: MIT
"""What the end-to-end tests share: checks, an X server, a small X client, programs under test."""

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
import zlib

BIN = os.path.abspath(os.environ["L3D_BIN"])
PATIENCE = 20  # seconds that anything may take on a busy machine before it counts as hanging
GREEN = 0x00FF80  # drawdot's dot


class Program:
    """A program under test, and how to start it with a small window."""

    def __init__(self, name, size):
        self.name = name
        self.size = size

    def command(self, *arguments):
        size = "%dx%d" % self.size
        return [os.path.join(BIN, self.name), "--size", size, *arguments]


DRAWDOT = Program("drawdot", (53, 31))
PROGRAMS = [
    program
    for program in (DRAWDOT, Program("teapot_afd", (157, 119)))
    if os.path.exists(os.path.join(BIN, program.name))
]


# ---- checks -------------------------------------------------------------------------------------


class Checks:
    """Runs functions and prints `ok NAME` or `not ok NAME why` for each."""

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

    def finish(self):
        sys.exit(1 if self.failed else 0)


def expect(condition, *facts):
    """A condition that must hold, and what to tell if it does not."""
    if not condition:
        raise AssertionError(" ".join(repr(fact) for fact in facts))


def expect_equal(found, wanted, what=""):
    expect(found == wanted, what, "found", found, "wanted", wanted)


def wait_for(question, what):
    """Asks until the answer is true, and returns it."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        answer = question()
        if answer:
            return answer
        time.sleep(0.02)
    raise AssertionError("waited in vain for " + what)


# ---- processes ----------------------------------------------------------------------------------


def environment(display=None, **more):
    """The environment without what would steer the programs, but for what is named here."""
    kept = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "L3D_BACKEND")}
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
    # A shell may have left SIGINT ignored, which children would inherit.
    process = subprocess.Popen(
        command,
        env=env,
        stderr=subprocess.PIPE,
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


def ended(process):
    """Waits for the end; returns exit status, standard output and messages."""
    out, messages = process.communicate(timeout=PATIENCE)
    return process.returncode, out, messages.decode()


def run(command, env, **options):
    with started(command, env, **options) as process:
        return ended(process)


# ---- the X server and what happens in it --------------------------------------------------------


@contextlib.contextmanager
def x_server(*options):
    """An X server of its own; yields its process with the attribute `display`."""
    read, write = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(write), "-screen", "0", "800x600x24", "-noreset", *options],
        pass_fds=[write],
        stdin=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    os.close(write)
    try:
        number = os.read(read, 16).decode().strip()  # comes when the server is ready
        expect(number.isdigit(), "Xvfb did not start")
        server.display = ":" + number
        yield server
    finally:
        os.close(read)
        if server.poll() is None:
            server.terminate()
        server.wait()


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
    search = ("search", "--onlyvisible", "--name", pattern)
    return int(wait_for(lambda: xdotool(display, *search).split(), "the window")[0])


class ClientMessage(ctypes.Structure):
    """XClientMessageEvent, padded to the size of an XEvent, 24 longs."""

    _fields_ = [
        ("type", ctypes.c_int),
        ("serial", ctypes.c_ulong),
        ("send_event", ctypes.c_int),
        ("display", ctypes.c_void_p),
        ("window", ctypes.c_ulong),
        ("message_type", ctypes.c_ulong),
        ("format", ctypes.c_int),
        ("data", ctypes.c_long * 5),
        ("padding", ctypes.c_long * 12),
    ]


class ImageHead(ctypes.Structure):
    """The beginning of an XImage."""

    _fields_ = [
        (name, ctypes.c_void_p if name == "data" else ctypes.c_int)
        for name in (
            "width height xoffset format data byte_order bitmap_unit bitmap_bit_order bitmap_pad "
            "depth bytes_per_line bits_per_pixel"
        ).split()
    ]


class Onlooker:
    """An X client that looks at windows and does to them what a window manager does."""

    CLIENT_MESSAGE, Z_PIXMAP, ALL_PLANES = 33, 2, ctypes.c_ulong(-1).value

    def __init__(self, display):
        x = self.x = ctypes.CDLL("libX11.so.6")
        for name in ("XOpenDisplay", "XGetImage"):
            getattr(x, name).restype = ctypes.c_void_p
        for name in ("XInternAtom", "XDefaultRootWindow", "XCreateSimpleWindow"):
            getattr(x, name).restype = ctypes.c_ulong
        # The default handler would end the tests; XGetImage then returns nothing.
        self.ignore = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)(
            lambda *_: 0
        )
        x.XSetErrorHandler(self.ignore)
        self.display = ctypes.c_void_p(x.XOpenDisplay(display.encode()))
        expect(self.display, "cannot open", display)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.x.XCloseDisplay(self.display)

    def picture(self, window, width, height):
        """Rows of colours 0xRRGGBB; None if the window is not (or no longer) that large."""
        at = self.x.XGetImage(
            self.display,
            ctypes.c_ulong(window),
            0,
            0,
            width,
            height,
            ctypes.c_ulong(self.ALL_PLANES),
            self.Z_PIXMAP,
        )
        if not at:
            return None
        head = ImageHead.from_address(at)
        expect_equal(head.bits_per_pixel, 32)
        rows = []
        for y in range(height):
            row = ctypes.string_at(head.data + y * head.bytes_per_line, 4 * width)
            rows.append([pixel & 0xFFFFFF for pixel in struct.unpack("<%dI" % width, row)])
        return rows

    def ask_to_close(self, window):
        """What a click on the close button of a window manager's frame does."""
        atom = lambda name: self.x.XInternAtom(self.display, name, False)
        event = ClientMessage(type=self.CLIENT_MESSAGE, window=window, format=32)
        event.message_type = atom(b"WM_PROTOCOLS")
        event.data[0] = atom(b"WM_DELETE_WINDOW")
        self.x.XSendEvent(self.display, ctypes.c_ulong(window), False, 0, ctypes.byref(event))
        self.x.XSync(self.display, False)

    @contextlib.contextmanager
    def cover(self, width, height):
        """A window over the top left of the screen, for a while."""
        root = ctypes.c_ulong(self.x.XDefaultRootWindow(self.display))
        plain = ctypes.c_ulong(0x445566)
        cover = ctypes.c_ulong(
            self.x.XCreateSimpleWindow(self.display, root, 0, 0, width, height, 0, plain, plain)
        )
        self.x.XMapRaised(self.display, cover)
        self.x.XSync(self.display, False)
        yield
        self.x.XDestroyWindow(self.display, cover)
        self.x.XSync(self.display, False)


# ---- pictures -----------------------------------------------------------------------------------


def read_png(path):
    """Rows of colours 0xRRGGBB of an 8-bit RGB file that is not interlaced."""
    with open(path, "rb") as file:
        data = file.read()
    expect_equal(data[:8], b"\x89PNG\r\n\x1a\n", path)
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colours, _, _, interlaced = struct.unpack(">IIBBBBB", body)
            expect_equal((depth, colours, interlaced), (8, 2, 0), path)
        elif kind == b"IDAT":
            packed += body
        at += length + 12
    return [
        [int.from_bytes(row[3 * x : 3 * x + 3], "big") for x in range(width)]
        for row in unfiltered(zlib.decompress(packed), width, height)
    ]


def unfiltered(data, width, height):
    """The rows of bytes that PNG's five filters were applied to."""
    before = bytearray(3 * width)
    for y in range(height):
        start = y * (3 * width + 1)
        kind, row = data[start], bytearray(data[start + 1 : start + 1 + 3 * width])
        for i in range(3 * width):
            left, up = row[i - 3] if i >= 3 else 0, before[i]
            corner = before[i - 3] if i >= 3 else 0
            guess = left + up - corner
            nearest = min((left, up, corner), key=lambda value: abs(guess - value))
            row[i] = (row[i] + (0, left, up, (left + up) // 2, nearest)[kind]) & 255
        yield row
        before = row


def has_picture(rows):
    """Whether there is more than one colour."""
    return rows is not None and len({pixel for row in rows for pixel in row}) > 1
