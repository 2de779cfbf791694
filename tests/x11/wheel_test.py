#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Wheels that turn by parts of a notch, which the proxy adds to a server without any."""

import struct

import harness
import x_protocol as x11
from harness import Checks, Shown, expect, expect_equal, is_quiet, wait_for, x_server
from x_proxy import Connection, Proxy

TEAPOT = harness.PROGRAMS[-1]
NOTCH = 15  # as X counts it on this wheel
NUMBER, FIRST_VALUE, POINTER = 3, 1000, 2  # of the wheel, where it stands at first, its device
QUERY_DEVICE, SELECT_EVENTS = "XInputExtension.48", "XInputExtension.46"
BUTTON_PRESS, MOTION, MASTER_POINTER = 4, 6, 1


class ConnectionWithWheel(Connection):
    """Has one more wheel on the pointer."""

    latest, time = 0, 1000

    def changed(self, name, request):
        if name == QUERY_DEVICE:
            return request, self.with_wheel
        return super().changed(name, request)

    def with_wheel(self, reply):
        """A class that says how far a notch is, and one that says where the wheel stands."""
        scroll = struct.pack("<HHHHHHIiI", 3, 6, POINTER, NUMBER, 1, 0, 0, NOTCH, 0)
        place = struct.pack("<HHHHIiIiIiIIBxxx", 2, 11, POINTER, NUMBER, 0, 0, 0, 0, 0,
                            FIRST_VALUE, 0, 1, 0)
        at, devices = x11.UNIT, b""
        for _ in range(self.numbers(reply, "H", 8)[0]):
            number, use, attached, classes, name = self.numbers(reply, "HHHHH", at)
            end = at + 12 + x11.padded(name)
            for _ in range(classes):
                end += 4 * self.numbers(reply, "H", end + 2)[0]
            device = reply[at:end]
            if use == MASTER_POINTER:
                head = struct.pack("<HHHH", number, use, attached, classes + 2)
                device = head + device[8:] + scroll + place
            at, devices = end, devices + device
        return self.with_more(reply, devices)

    def pass_answer(self, answer):
        self.latest = x11.sequence_of(answer, self.order)
        super().pass_answer(answer)

    def turn(self, window, value):
        """The wheel stands there now."""
        self.time += 1
        opcode = next(code for code, name in self.extensions.items() if name == "XInputExtension")
        place = (60 << 16, 50 << 16)
        self.down.write(struct.pack(
            "<BBHIHHIIIIIiiiiHHHHI4I4BIiI", x11.GENERIC_EVENT, opcode, self.latest, 15, MOTION,
            POINTER, self.time, 0, 1, window, 0, *place, *place, 0, 1, POINTER, 0, 0, 0, 0, 0, 0,
            0, 0, 0, 0, 1 << NUMBER, int(value // 1), int(value % 1 * 2**32)))

    def click(self, window):
        """What the server makes of a full notch, for those who know no fine wheels."""
        self.down.write(struct.pack("<BBHIIIIhhhhHBx", BUTTON_PRESS, 4, self.latest, self.time, 1,
                                    window, 0, 60, 50, 60, 50, 0, 1))


class ProxyWithWheel(Proxy):
    kind = ConnectionWithWheel


def covered(it):
    return sum(map(sum, harness.covered(it.picture())))


def zooms_by_parts_of_a_notch():
    with x_server() as server, ProxyWithWheel(server.display) as proxy:
        with Shown(TEAPOT, server, "--backend", "ximage", *harness.COUNTED,
                   display=proxy.display) as it:
            wait_for(lambda: proxy.mark().requests.count(SELECT_EVENTS) == 2, "the choice of events")
            wait_for(lambda: is_quiet(proxy), "rest")
            wheel = proxy.connections[-1]

            def after(value):
                before = it.picture()
                wheel.turn(it.window, FIRST_VALUE + value)
                wait_for(lambda: it.picture() != before and is_quiet(proxy), "another picture")
                return covered(it)

            # X counts towards the user: away from him the model comes nearer.
            sizes = [covered(it)] + [after(-NOTCH * part) for part in (0.25, 0.5, 0.75, 1)]
            expect(sizes == sorted(set(sizes)), "not larger each time", sizes)
            mark, near = proxy.mark(), it.picture()
            wheel.click(it.window)
            expect(is_quiet(proxy, 0.5), "a second picture for the notch")
            expect_equal(it.picture() == near, True, "the same picture")
            expect(after(0) < sizes[1], "not back", sizes)
            it.press("q")
            it.expect_end(0)


def hears_of_no_motion_without_such_a_wheel():
    with x_server() as server, Proxy(server.display) as proxy:
        with Shown(TEAPOT, server, "--backend", "ximage", *harness.COUNTED,
                   display=proxy.display) as it:
            wait_for(lambda: QUERY_DEVICE in proxy.mark().requests, "the question")
            wait_for(lambda: is_quiet(proxy), "rest")
            expect_equal(proxy.mark().requests.count(SELECT_EVENTS), 1)
            down = proxy.mark().bytes_down
            harness.xdotool(server.display, "mousemove", "--window", it.window, 20, 30,
                            "mousemove", "--window", it.window, 40, 50)
            expect(is_quiet(proxy), "requests")
            expect_equal(proxy.mark().bytes_down, down, "bytes of events")
            it.press("q")
            it.expect_end(0)


def main():
    checks = Checks()
    for check in (zooms_by_parts_of_a_notch, hears_of_no_motion_without_such_a_wheel):
        checks.run("wheel." + check.__name__, check)
    checks.finish()


if __name__ == "__main__":
    main()
