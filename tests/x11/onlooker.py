# SPDX-License-Identifier: MIT
"""A small X client, by Xlib, that looks at the windows of programs under test."""

import contextlib
import ctypes
import struct
import time

# What others may be told, or asked: masks of events.
POINTER, STRUCTURE, NOTIFY, REDIRECT, PROPERTY = (1 << bit for bit in (6, 17, 19, 20, 22))


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


class Configured(ctypes.Structure):
    """XConfigureEvent, padded to the size of an XEvent."""

    _fields_ = [
        ("type", ctypes.c_int),
        ("serial", ctypes.c_ulong),
        ("send_event", ctypes.c_int),
        ("display", ctypes.c_void_p),
        ("event", ctypes.c_ulong),
        ("window", ctypes.c_ulong),
        *((name, ctypes.c_int) for name in "x y width height border".split()),
        ("above", ctypes.c_ulong),
        ("override_redirect", ctypes.c_int),
        ("padding", ctypes.c_long * 12),
    ]


class KeyEvent(ctypes.Structure):
    """XKeyEvent, padded to the size of an XEvent."""

    _fields_ = [
        ("type", ctypes.c_int),
        ("serial", ctypes.c_ulong),
        ("send_event", ctypes.c_int),
        ("display", ctypes.c_void_p),
        *((name, ctypes.c_ulong) for name in "window root subwindow time".split()),
        *((name, ctypes.c_int) for name in "x y x_root y_root".split()),
        *((name, ctypes.c_uint) for name in "state code".split()),
        ("same_screen", ctypes.c_int),
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


class Visual(ctypes.Structure):
    """The beginning of Xlib's Visual."""

    _fields_ = [
        ("extensions", ctypes.c_void_p),
        ("visual_id", ctypes.c_ulong),
        ("kind", ctypes.c_int),
        ("red_mask", ctypes.c_ulong),
        ("green_mask", ctypes.c_ulong),
        ("blue_mask", ctypes.c_ulong),
    ]


class WindowAttributes(ctypes.Structure):
    """XWindowAttributes."""

    _fields_ = [
        *((name, ctypes.c_int) for name in "x y width height border depth".split()),
        ("visual", ctypes.POINTER(Visual)),
        ("root", ctypes.c_ulong),
        *((name, ctypes.c_int) for name in "kind bit_gravity gravity backing_store".split()),
        ("backing_planes", ctypes.c_ulong),
        ("backing_pixel", ctypes.c_ulong),
        ("save_under", ctypes.c_int),
        ("colormap", ctypes.c_ulong),
        ("is_installed", ctypes.c_int),
        ("state", ctypes.c_int),
        ("all_masks", ctypes.c_long),
        ("rest", ctypes.c_long * 6),
    ]


class Color(ctypes.Structure):
    """XColor."""

    _fields_ = [
        ("pixel", ctypes.c_ulong),
        *((name, ctypes.c_ushort) for name in "red green blue".split()),
        ("flags", ctypes.c_char),
        ("padding", ctypes.c_char),
    ]


class Onlooker:
    """An X client that looks at windows and does to them what a window manager does."""

    seen = None
    settings = served = 0
    VIEWABLE, CLIENT_MESSAGE, Z_PIXMAP, ALL_PLANES = 2, 33, 2, ctypes.c_ulong(-1).value

    def __init__(self, display):
        x = self.x = ctypes.CDLL("libX11.so.6")
        for name in ("XOpenDisplay", "XGetImage", "XGetAtomName"):
            getattr(x, name).restype = ctypes.c_void_p
        for name in ("XInternAtom", "XDefaultRootWindow", "XCreateSimpleWindow"):
            getattr(x, name).restype = ctypes.c_ulong
        # The default handler would end the tests; XGetImage then returns nothing.
        self.ignore = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)(
            lambda *_: 0
        )
        x.XSetErrorHandler(self.ignore)
        self.display = ctypes.c_void_p(x.XOpenDisplay(display.encode()))
        if not self.display:
            raise RuntimeError("cannot open " + display)
        self.root = x.XDefaultRootWindow(self.display)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.x.XCloseDisplay(self.display)

    def picture(self, window, width, height):
        """Rows of colours 0xRRGGBB of a window that stores them so; or None."""
        return self.pixels(window, width, height, has_top=False)

    def pixels(self, window, width, height, has_top=True):
        """Rows of pixel values, those of four bytes without their top one unless `has_top`; None if the window is
        not (or no longer) that large."""
        found = self.image(window, width, height)
        if not found:
            return None
        pitch, size, data = found
        if size == 4 and not has_top:
            data = bytearray(data)
            data[3::4] = bytes(len(data) // 4)
        layout = "<%d%s" % (width, {1: "B", 2: "H", 4: "I"}[size])
        return [list(struct.unpack_from(layout, data, at)) for at in range(0, len(data), pitch)]

    def image(self, window, width, height, left=0, top=0):
        """Of a part of a window: bytes of a row, bytes of a pixel, all rows; None if it has no such part."""
        at = self.x.XGetImage(
            self.display, ctypes.c_ulong(window), left, top, width, height,
            ctypes.c_ulong(self.ALL_PLANES), self.Z_PIXMAP,
        )
        if not at:
            return None
        head = ImageHead.from_address(at)
        data = ctypes.string_at(head.data, height * head.bytes_per_line)
        self.x.XDestroyImage(ctypes.c_void_p(at))
        return head.bytes_per_line, head.bits_per_pixel // 8, data

    def has_changed(self, window, width, height):
        """Whether the window's pixels are others than at the last call."""
        before, self.seen = self.seen, self.image(window, width, height)
        return self.seen != before

    def visual(self, window):
        """Of a window: depth, class, masks; and the colours 0xRRGGBB of its map, if few."""
        found = self.attributes(window)
        kind = found.visual.contents
        masks = kind.red_mask, kind.green_mask, kind.blue_mask
        colours = []
        if found.depth <= 8:
            cells = (Color * (1 << found.depth))()
            for pixel, cell in enumerate(cells):
                cell.pixel = pixel
            self.x.XQueryColors(self.display, ctypes.c_ulong(found.colormap), cells, len(cells))
            colours = [cell.red >> 8 << 16 | cell.green >> 8 << 8 | cell.blue >> 8 for cell in cells]
        return found.depth, kind.kind, masks, colours

    def ask_to_close(self, window):
        """What a click on the close button of a window manager's frame does."""
        event = self.message(window, "WM_PROTOCOLS", self.atom("WM_DELETE_WINDOW"))
        self.send(window, event)

    def atom(self, name):
        return self.x.XInternAtom(self.display, name.encode(), False)

    def message(self, window, kind, *words):
        event = ClientMessage(type=self.CLIENT_MESSAGE, window=window, format=32)
        event.message_type = self.atom(kind)
        event.data[: len(words)] = words
        return event

    def send(self, window, event, mask=0):
        """Sends an event, by way of the server, to those who selected it; else to the owner."""
        mask = ctypes.c_long(mask)
        self.x.XSendEvent(self.display, ctypes.c_ulong(window), False, mask, ctypes.byref(event))
        self.x.XSync(self.display, False)

    def has_manager(self):
        """Whether somebody redirects the requests of windows."""
        return self.is_watched(self.root, REDIRECT)

    def is_served(self):
        """Whether a manager has put a window of ours on the screen. One that has just begun may miss the request,
        so each call asks anew."""
        if not self.has_manager():
            return False
        self.served = self.served or self.make_window(0, 0, 9, 9)
        self.x.XMapWindow(self.display, ctypes.c_ulong(self.served))
        return self.attributes(self.served).state == self.VIEWABLE

    def attributes(self, window):
        found = WindowAttributes()
        self.x.XGetWindowAttributes(self.display, ctypes.c_ulong(window), ctypes.byref(found))
        return found

    def is_watched(self, window, mask):
        """Whether somebody wants to hear of such events of a window."""
        return bool(self.attributes(window).all_masks & mask)

    def has_frame(self, window):
        """Whether a window manager has put a window into one of its own."""
        root, parent, count = ctypes.c_ulong(), ctypes.c_ulong(), ctypes.c_uint()
        children = ctypes.c_void_p()
        found = map(ctypes.byref, (root, parent, children, count))
        self.x.XQueryTree(self.display, ctypes.c_ulong(window), *found)
        self.x.XFree(children)
        return parent.value != root.value

    def set_numbers(self, window, name, kind, values):
        """A property that is a list of 32-bit numbers, as a window manager would set it."""
        data = (ctypes.c_long * max(1, len(values)))(*values)
        name, kind = ctypes.c_ulong(self.atom(name)), ctypes.c_ulong(self.atom(kind))
        self.x.XChangeProperty(
            self.display, ctypes.c_ulong(window), name, kind, 32, 0, data, len(values)
        )
        self.x.XSync(self.display, False)

    def set_atoms(self, window, name, texts):
        self.set_numbers(window, name, "ATOM", [self.atom(text) for text in texts])

    def atoms(self, window, name):
        """The names in a property that lists them."""
        kind, size = ctypes.c_ulong(), ctypes.c_int()
        count, after, data = ctypes.c_ulong(), ctypes.c_ulong(), ctypes.POINTER(ctypes.c_ulong)()
        self.x.XGetWindowProperty(
            self.display, ctypes.c_ulong(window), ctypes.c_ulong(self.atom(name)), ctypes.c_long(0),
            ctypes.c_long(99), False, ctypes.c_ulong(0), ctypes.byref(kind), ctypes.byref(size),
            ctypes.byref(count), ctypes.byref(after), ctypes.byref(data),
        )
        names = []
        for i in range(count.value):
            at = self.x.XGetAtomName(self.display, ctypes.c_ulong(data[i]))
            names.append(ctypes.string_at(at).decode() if at else "")
        return names

    def ask_manager(self, window, state, action):
        """Asks the window manager to take a state away (0) or to add it (1), as a pager does."""
        event = self.message(window, "_NET_WM_STATE", action, self.atom(state), 0, 2)
        self.send(self.root, event, REDIRECT | NOTIFY)

    def press_key(self, window, name):
        """Sends the window the two events of a key, and notes when."""
        code = self.x.XKeysymToKeycode(self.display, ctypes.c_ulong(self.x.XStringToKeysym(name.encode())))
        for kind in (2, 3):
            event = KeyEvent(type=kind, window=window, root=self.root, code=code, same_screen=1)
            self.x.XSendEvent(
                self.display, ctypes.c_ulong(window), False, ctypes.c_long(kind - 1), ctypes.byref(event)
            )
            self.pressed = time.monotonic()
            self.x.XFlush(self.display)

    def serve_settings(self, dpi):
        """What a desktop's manager of settings does: owns the selection, and writes Xft/DPI."""
        if not self.settings:
            self.settings = self.make_window(-9, -9, 1, 1)
        text = struct.pack("<B3xIIBxH7sxII", 0, 1, 1, 0, 7, b"Xft/DPI", 1, dpi * 1024)
        name = ctypes.c_ulong(self.atom("_XSETTINGS_SETTINGS"))
        window, selection = ctypes.c_ulong(self.settings), self.atom("_XSETTINGS_S0")
        self.x.XChangeProperty(self.display, window, name, name, 8, 0, text, len(text))
        self.x.XSetSelectionOwner(self.display, ctypes.c_ulong(selection), window, ctypes.c_ulong(0))
        self.send(self.root, self.message(self.root, "MANAGER", 0, selection, self.settings), STRUCTURE)

    def send_size(self, window, width, height):
        """Tells the window, as a window manager might, that it has a size."""
        self.send(window, Configured(type=22, event=window, window=window, width=width, height=height))

    def expose(self, window, x, y, width, height):
        """Has the server say that this part of a window is to be drawn again."""
        self.x.XClearArea(self.display, ctypes.c_ulong(window), x, y, width, height, True)
        self.x.XSync(self.display, False)

    def make_window(self, x, y, width, height):
        plain = ctypes.c_ulong(0x445566)
        root = ctypes.c_ulong(self.root)
        return self.x.XCreateSimpleWindow(self.display, root, x, y, width, height, 0, plain, plain)

    @contextlib.contextmanager
    def cover(self, width, height):
        """A window over the top left of the screen, for a while."""
        cover = ctypes.c_ulong(self.make_window(0, 0, width, height))
        self.x.XMapRaised(self.display, cover)
        self.x.XSync(self.display, False)
        yield
        self.x.XDestroyWindow(self.display, cover)
        self.x.XSync(self.display, False)
