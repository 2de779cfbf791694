#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A window manager without frames: it maps, resizes and makes fullscreen what asks for it."""

import ctypes
import os

from onlooker import NOTIFY, PROPERTY, REDIRECT, ClientMessage, Onlooker

CONFIGURE_REQUEST, MAP_REQUEST = 23, 20
LONG = ctypes.c_ulong


class Request(ctypes.Structure):
    """XMapRequestEvent, and XConfigureRequestEvent from its beginning to its mask."""

    _fields_ = [
        ("type", ctypes.c_int),
        ("serial", LONG),
        ("send_event", ctypes.c_int),
        ("display", ctypes.c_void_p),
        ("parent", LONG),
        ("window", LONG),
        *((name, ctypes.c_int) for name in "x y width height border".split()),
        ("above", LONG),
        ("detail", ctypes.c_int),
        ("mask", LONG),
    ]


class Changes(ctypes.Structure):
    """XWindowChanges."""

    _fields_ = [
        *((name, ctypes.c_int) for name in "x y width height border".split()),
        ("sibling", LONG),
        ("mode", ctypes.c_int),
    ]


class Event(ctypes.Union):
    _fields_ = [("type", ctypes.c_int), ("message", ClientMessage), ("request", Request)]


class Manager(Onlooker):
    """An onlooker that also decides."""

    ABILITIES = ("_NET_WM_STATE", "_NET_WM_STATE_FULLSCREEN", "_NET_CURRENT_DESKTOP")

    def __init__(self, display):
        super().__init__(display)
        self.before = {}
        mask = ctypes.c_long(REDIRECT | NOTIFY | PROPERTY)
        self.x.XSelectInput(self.display, LONG(self.root), mask)
        check = self.make_window(-9, -9, 1, 1)
        for window in (check, self.root):
            self.set_numbers(window, "_NET_SUPPORTING_WM_CHECK", "WINDOW", [check])
        self.set_atoms(self.root, "_NET_SUPPORTED", self.ABILITIES)
        self.set_numbers(self.root, "_NET_CURRENT_DESKTOP", "CARDINAL", [0])
        self.set_numbers(self.root, "_NET_NUMBER_OF_DESKTOPS", "CARDINAL", [4])

    def serve(self):
        event = (Event * 4)()  # more room than Xlib writes to
        while True:
            self.x.XNextEvent(self.display, event)
            if event[0].type == MAP_REQUEST:
                self.set_numbers(event[0].request.window, "WM_STATE", "WM_STATE", [1, 0])
                self.x.XMapWindow(self.display, LONG(event[0].request.window))
                self.x.XSetInputFocus(self.display, LONG(event[0].request.window), 1, LONG(0))
            elif event[0].type == CONFIGURE_REQUEST:
                self.configure(event[0].request)
            elif event[0].type == self.CLIENT_MESSAGE:
                self.take(event[0].message)

    def configure(self, asked):
        wanted = Changes(asked.x, asked.y, asked.width, asked.height, 0, 0, 0)
        self.before[asked.window] = (asked.x, asked.y, asked.width, asked.height)
        sizes = ctypes.c_uint(asked.mask & 15)
        self.x.XConfigureWindow(self.display, LONG(asked.window), sizes, ctypes.byref(wanted))

    def take(self, message):
        if message.message_type != self.atom("_NET_WM_STATE"):
            return
        if message.data[1] != self.atom("_NET_WM_STATE_FULLSCREEN"):
            return
        on = message.data[0] != 0
        place = (0, 0, 800, 600) if on else self.before.get(message.window, (0, 0, 160, 120))
        self.x.XMoveResizeWindow(self.display, LONG(message.window), *place)
        states = [message.data[1]] if on else []
        self.set_numbers(message.window, "_NET_WM_STATE", "ATOM", states)


if __name__ == "__main__":
    manager = Manager(os.environ["DISPLAY"])
    print("ready", flush=True)
    manager.serve()
