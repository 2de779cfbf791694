# SPDX-License-Identifier: MIT
"""The wire of X11, as far as a proxy must know it: messages, names, pictures.

Source: X Window System Protocol, X Version 11, appendix B (encoding).
"""

import array
import contextlib
import os
import queue
import socket
import struct
import threading
import time
from dataclasses import dataclass

ERROR, REPLY, GENERIC_EVENT = 0, 1, 35
LONGEST_READ = 1 << 14  # bytes; of a slow wire also the grain
UNIT = 32  # bytes of an event, an error, a reply without more
PUT_IMAGE, GET_IMAGE, QUERY_EXTENSION, LIST_EXTENSIONS = 72, 73, 98, 99
GET_INPUT_FOCUS, NO_OPERATION = 43, 127
BAD_REQUEST, BAD_ACCESS = 1, 10
Z_PIXMAP = 2

# The core requests from 1 on; GetModifierMapping, 119, is the last before NoOperation.
CORE = """
CreateWindow ChangeWindowAttributes GetWindowAttributes DestroyWindow DestroySubwindows
ChangeSaveSet ReparentWindow MapWindow MapSubwindows UnmapWindow UnmapSubwindows ConfigureWindow
CirculateWindow GetGeometry QueryTree InternAtom GetAtomName ChangeProperty DeleteProperty
GetProperty ListProperties SetSelectionOwner GetSelectionOwner ConvertSelection SendEvent
GrabPointer UngrabPointer GrabButton UngrabButton ChangeActivePointerGrab GrabKeyboard
UngrabKeyboard GrabKey UngrabKey AllowEvents GrabServer UngrabServer QueryPointer GetMotionEvents
TranslateCoordinates WarpPointer SetInputFocus GetInputFocus QueryKeymap OpenFont CloseFont
QueryFont QueryTextExtents ListFonts ListFontsWithInfo SetFontPath GetFontPath CreatePixmap
FreePixmap CreateGC ChangeGC CopyGC SetDashes SetClipRectangles FreeGC ClearArea CopyArea CopyPlane
PolyPoint PolyLine PolySegment PolyRectangle PolyArc FillPoly PolyFillRectangle PolyFillArc PutImage
GetImage PolyText8 PolyText16 ImageText8 ImageText16 CreateColormap FreeColormap CopyColormapAndFree
InstallColormap UninstallColormap ListInstalledColormaps AllocColor AllocNamedColor AllocColorCells
AllocColorPlanes FreeColors StoreColors StoreNamedColor QueryColors LookupColor CreateCursor
CreateGlyphCursor FreeCursor RecolorCursor QueryBestSize QueryExtension ListExtensions
ChangeKeyboardMapping GetKeyboardMapping ChangeKeyboardControl GetKeyboardControl Bell
ChangePointerControl GetPointerControl SetScreenSaver GetScreenSaver ChangeHosts ListHosts
SetAccessControl SetCloseDownMode KillClient RotateProperties ForceScreenSaver SetPointerMapping
GetPointerMapping SetModifierMapping GetModifierMapping
""".split()

SHM = "MIT-SHM"
SHM_REQUESTS = "QueryVersion Attach Detach PutImage GetImage CreatePixmap AttachFd CreateSegment"


def request_name(request, extensions):
    """CreateWindow, or MIT-SHM.PutImage; `extensions` gives names by major opcode."""
    major, minor = request[0], request[1]
    if major <= len(CORE):
        return CORE[major - 1]
    if major == NO_OPERATION:
        return "NoOperation"
    extension = extensions.get(major, str(major))
    if extension == SHM and minor < len(SHM_REQUESTS.split()):
        return "%s.%s" % (SHM, SHM_REQUESTS.split()[minor])
    return "%s.%d" % (extension, minor)


def picture_box(name, request, order):
    """Left, top, width and height of what the request puts into a window; None if it is another."""
    if name == "PutImage":
        body = 4 if struct.unpack_from(order + "H", request, 2)[0] else 8
        width, height, left, top = struct.unpack_from(order + "HHhh", request, body + 8)
    elif name == SHM + ".PutImage":
        width, height, left, top = struct.unpack_from(order + "HHhh", request, 20)
    else:
        return None
    return left, top, width, height


# ---- messages -----------------------------------------------------------------------------------


def padded(length):
    return (length + 3) & ~3


def greeting_size(data):
    """Bytes of the client's first message, or None if too little is there to tell."""
    if len(data) < 12:
        return None
    name, secret = struct.unpack_from(order_of(data) + "HH", data, 6)
    return 12 + padded(name) + padded(secret)


def order_of(greeting):
    """The byte order in which this client speaks, as struct wants it."""
    return ">" if greeting[:1] == b"B" else "<"


def setup_size(data, order):
    """Bytes of the server's first message."""
    return None if len(data) < 8 else 8 + 4 * struct.unpack_from(order + "H", data, 6)[0]


def request_size(data, order):
    """Bytes of a request; those longer than 65535 units have an 0 and then 32 bits of length."""
    if len(data) < 4:
        return None
    units = struct.unpack_from(order + "H", data, 2)[0]
    if units == 0 and len(data) >= 8:
        units = struct.unpack_from(order + "I", data, 4)[0]
    return 4 * units or None


def answer_size(data, order):
    """Bytes of a reply, an error or an event."""
    if len(data) < UNIT:
        return None
    has_more = data[0] in (REPLY, GENERIC_EVENT)
    return UNIT + (4 * struct.unpack_from(order + "I", data, 4)[0] if has_more else 0)


def take(data, size):
    """Cuts the first message off a bytearray, or returns None if it is not complete."""
    if size is None or len(data) < size:
        return None
    message = bytes(data[:size])
    del data[:size]
    return message


def sequence_of(answer, order):
    return struct.unpack_from(order + "H", answer, 2)[0]


def error_like(answer, order, code, request):
    """An error in the place of an answer to that request."""
    head = struct.pack(order + "BBHIHB", ERROR, code, sequence_of(answer, order), 0, request[1],
                       request[0])
    return head.ljust(UNIT, b"\0")


class Pipe:
    """Two sockets, read from one and written to the other, with the files that go along.

    What is written arrives `delay` seconds later.
    """

    def __init__(self, source, target, delay=0):
        self.source, self.target, self.delay = source, target, delay
        self.data, self.files = bytearray(), array.array("i")
        self.late = queue.SimpleQueue()
        if delay:
            threading.Thread(target=self.deliver, daemon=True).start()

    def read(self):
        """Returns how many bytes came; none at the end of the stream."""
        got, files, _, _ = socket.recv_fds(self.source, LONGEST_READ, 8)
        self.data += got
        self.files.extend(files)
        return len(got)

    def drop_files(self):
        for file in self.files:
            os.close(file)
        self.files = array.array("i")

    def write(self, message):
        files, self.files = self.files, array.array("i")
        if self.delay:
            self.late.put((time.monotonic() + self.delay, bytes(message), files))
        else:
            self.send(message, files)

    def deliver(self):
        with contextlib.suppress(OSError):  # the other end is gone
            while True:
                due, message, files = self.late.get()
                time.sleep(max(0, due - time.monotonic()))
                self.send(message, files)

    def send(self, message, files):
        if files:
            sent = socket.send_fds(self.target, [message], files)
            for file in files:
                os.close(file)
            message = message[sent:]
        self.target.sendall(message)

    def first(self, size_of):
        """The first message, once it is there; `size_of` tells its size from its beginning."""
        while (message := take(self.data, size_of(self.data))) is None:
            if not self.read():
                raise EOFError
        return message


# ---- pictures -----------------------------------------------------------------------------------

REVERSED_BITS = bytes(int("{:08b}".format(byte)[::-1], 2) for byte in range(256))


@dataclass(frozen=True)
class PictureFormat:
    """How the clients of a little-endian server are made to store pixels.

    Shape:   rows start at multiples of 32 bits, theirs and the server's.
    """

    msb: bool = False  # most significant byte, and leftmost bit, first
    bpp24: bool = False  # depth 24 in three bytes instead of four

    def tell(self, setup, order):
        """The server's first message, changed to say so; and its bits per pixel by depth."""
        told = bytearray(setup)
        vendor, longest = struct.unpack_from(order + "HH", setup, 24)
        if self.msb:
            told[30:32] = b"\1\1"
        if self.bpp24:
            struct.pack_into(order + "H", told, 26, longest * 3 // 4)  # it will grow by a third
        bits = {}
        for i in range(setup[29]):
            at = 40 + padded(vendor) + 8 * i
            bits[setup[at]] = setup[at + 1]
            if self.bpp24 and setup[at] == 24:
                told[at + 1] = 24
        return bytes(told), bits

    def packs(self, depth, kind):
        return self.bpp24 and depth == 24 and kind == Z_PIXMAP

    def to_server(self, data, kind, depth, bits, width):
        if self.packs(depth, kind):
            return self.unpacked(data, width)
        return self.swapped(data, bits if kind == Z_PIXMAP else 1)

    def to_client(self, data, kind, depth, bits, width):
        if self.packs(depth, kind):
            return self.packed(data, width)
        return self.swapped(data, bits if kind == Z_PIXMAP else 1)

    def swapped(self, data, bits):
        """Which is its own reverse. Bits: in bytes, those of a bitmap in reverse order."""
        if not self.msb or bits == 8:
            return data
        if bits == 1:
            return data.translate(REVERSED_BITS)
        units = array.array({16: "H", 32: "I"}[bits], data)
        units.byteswap()
        return units.tobytes()

    def packed(self, data, width):
        rows = []
        for at in range(0, len(data), 4 * width):
            row = bytearray(padded(3 * width))
            for byte in range(3):
                row[self.place(byte) : 3 * width : 3] = data[at + byte : at + 4 * width : 4]
            rows.append(row)
        return b"".join(rows)

    def unpacked(self, data, width):
        rows = []
        for at in range(0, len(data), padded(3 * width)):
            row = bytearray(4 * width)
            for byte in range(3):
                row[byte::4] = data[at + self.place(byte) : at + 3 * width : 3]
            rows.append(row)
        return b"".join(rows)

    def place(self, byte):
        return 2 - byte if self.msb else byte
