#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The proxy itself: it changes nothing, counts right, and each fault is the one it says."""

import contextlib
import ctypes
import json
import os
import random
import signal
import socket
import struct
import sys
import time

import harness
import x_protocol as x11
from harness import Checks, expect, expect_equal, folder, wait_for, x_server
from x_proxy import Proxy

SIZE = WIDTH, HEIGHT = 37, 11  # three bytes per pixel leave one to pad a row
SEED = random.randrange(1 << 32)
BAD_DRAWABLE = 9


class WireClient:
    """A client that writes every byte itself; little-endian, and it waits for every answer."""

    def __init__(self, display):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.settimeout(harness.PATIENCE)
        self.socket.connect("/tmp/.X11-unix/X" + display.lstrip(":"))
        self.socket.sendall(struct.pack("<BxHHHHxx", ord("l"), 11, 0, 0, 0))
        head = self.read(8)
        self.setup = head + self.read(4 * struct.unpack_from("<H", head, 6)[0])
        self.base = struct.unpack_from("<I", self.setup, 12)[0]
        vendor, self.longest = struct.unpack_from("<HH", self.setup, 24)
        self.byte_order = "big" if self.setup[30] else "little"
        formats = 40 + x11.padded(vendor)
        self.bits = {
            self.setup[at]: self.setup[at + 1]
            for at in range(formats, formats + 8 * self.setup[29], 8)
        }
        screen = formats + 8 * self.setup[29]
        self.root = struct.unpack_from("<I", self.setup, screen)[0]
        self.depth = self.setup[screen + 38]

    def read(self, size):
        data = b""
        while len(data) < size:
            got = self.socket.recv(size - len(data))
            if not got:
                raise EOFError
            data += got
        return data

    def send(self, opcode, detail, body=b"", is_long=False):
        units = 1 + is_long + len(body) // 4
        length = struct.pack("<HI", 0, units) if is_long else struct.pack("<H", units)
        self.socket.sendall(bytes([opcode, detail]) + length + body)

    def answer(self):
        head = self.read(x11.UNIT)
        return head + self.read(x11.answer_size(head, "<") - x11.UNIT)

    def ask(self, *request, **how):
        self.send(*request, **how)
        return self.answer()

    def next_answer(self):
        """The event or error that the last request led to; else the reply that follows it."""
        answers = [self.ask(x11.GET_INPUT_FOCUS, 0)]
        while answers[-1][0] != x11.REPLY:
            answers.append(self.answer())
        return answers[0]

    def extension(self, name):
        """Present, major opcode, first event, first error."""
        body = struct.pack("<Hxx", len(name)) + name.encode().ljust(x11.padded(len(name)), b"\0")
        return tuple(self.ask(x11.QUERY_EXTENSION, 0, body)[8:12])

    def make_pixmap(self, depth):
        """With a graphics context; returns both."""
        pixmap, context = self.base + 1, self.base + 2
        self.send(53, depth, struct.pack("<IIHH", pixmap, self.root, *SIZE))
        self.send(55, 0, struct.pack("<III", context, pixmap, 0))
        return pixmap, context

    def stored(self, rows, bits, byte_order):
        """Rows of pixel values as the bytes of an image."""
        size = bits // 8
        lines = [b"".join(pixel.to_bytes(size, byte_order) for pixel in row) for row in rows]
        return b"".join(line.ljust(x11.padded(len(line)), b"\0") for line in lines)

    def put(self, target, depth, data, **how):
        body = struct.pack("<IIHHhhBBxx", *target, *SIZE, 0, 0, 0, depth)
        self.send(x11.PUT_IMAGE, x11.Z_PIXMAP, body + data, **how)

    def get(self, drawable):
        body = struct.pack("<IhhHHI", drawable, 0, 0, *SIZE, 0xFFFFFFFF)
        return self.ask(x11.GET_IMAGE, x11.Z_PIXMAP, body)

    def hang_up(self):
        self.socket.close()


def colours(depth):
    chance = random.Random(SEED)
    return [[chance.randrange(1 << depth) for _ in range(WIDTH)] for _ in range(HEIGHT)]


# ---- passing on and counting --------------------------------------------------------------------


def conversation(display):
    """Some of everything: replies long and short, an error, a long request."""
    client = WireClient(display)
    _, big_requests, *_ = client.extension("BIG-REQUESTS")
    target = client.make_pixmap(24)
    data = client.stored(colours(24), 32, "little")
    client.put(target, 24, data)
    answers = [client.ask(big_requests, 0), client.get(target[0])]
    client.put(target, 24, data[::-1], is_long=True)
    answers += [client.get(target[0]), client.ask(x11.LIST_EXTENSIONS, 0)]
    answers += [client.ask(14, 0, struct.pack("<I", 1))]  # the geometry of nothing
    client.hang_up()
    return client.setup[:12] + client.setup[16:], answers


CONVERSATION = (
    "QueryExtension CreatePixmap CreateGC PutImage BIG-REQUESTS.0 GetImage PutImage GetImage "
    "ListExtensions GetGeometry"
).split()
REPLIED = "QueryExtension BIG-REQUESTS.0 GetImage GetImage ListExtensions".split()


def changes_nothing():
    with x_server() as server, Proxy(server.display) as proxy:
        direct = conversation(server.display)
        expect_equal(direct[1][4][:2], bytes([x11.ERROR, BAD_DRAWABLE]))
        expect(direct == conversation(proxy.display), "the answers differ")


def counts():
    with x_server() as server, Proxy(server.display) as proxy:
        _, answers = conversation(proxy.display)
        mark = proxy.mark()
        expect_equal((mark.requests, mark.replied), (CONVERSATION, REPLIED))
        picture = 24 + 4 * WIDTH * HEIGHT
        # In order of the conversation; the second picture has the long length.
        up = 20 + 16 + 16 + picture + 4 + 20 + (picture + 4) + 20 + 4 + 8
        expect_equal((mark.bytes_up, mark.bytes_down), (up, 32 + sum(map(len, answers))))
        conversation(proxy.display)
        second = proxy.mark() - mark
        expect_equal((second.requests, second.replied), (CONVERSATION, REPLIED))
        expect_equal((second.bytes_up, second.bytes_down), (mark.bytes_up, mark.bytes_down))
        both = [connection.traffic.requests for connection in proxy.connections]
        expect_equal(both, [CONVERSATION, CONVERSATION])


def runs_by_hand():
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "x_proxy.py")
    with folder() as path, x_server() as server:
        file = os.path.join(path, "counts")
        command = [sys.executable, script, server.display, "--counts", file, "--no-shm"]
        with harness.started(command, harness.environment()) as process:
            display = process.stdout.readline().split()[0].decode()
            conversation(display)
            process.send_signal(signal.SIGUSR1)
            wait_for(lambda: os.path.exists(file) and os.path.getsize(file), "the counts")
            expect_equal(WireClient(display).extension(x11.SHM), (0, 0, 0, 0))
            process.send_signal(signal.SIGTERM)
            process.wait(timeout=harness.PATIENCE)
        with open(file) as lines:
            first, last = map(json.loads, lines)
    expect_equal(first["all"]["requests"], len(CONVERSATION))
    expect_equal(first["all"]["by_name"]["GetImage"], 2)
    expect_equal(last["all"]["requests"], len(CONVERSATION) + 1)
    expect_equal(last["since_last"]["by_name"], {"QueryExtension": 1})


# ---- pictures -----------------------------------------------------------------------------------


def converts_pictures():
    """What an obedient client sends arrives; what one sends that asked nothing does not."""
    for depth in (16, 24, 30):
        with x_server("-screen", "0", "90x50x%d" % depth) as server:
            for told in ({}, {"msb": True}, {"bpp24": True}, {"msb": True, "bpp24": True}):
                with Proxy(server.display, **told) as proxy:
                    expect_conversion(server.display, proxy.display, depth, told)


def expect_conversion(direct, proxied, depth, told):
    rows = colours(depth)
    eyes, client = WireClient(direct), WireClient(proxied)
    native = eyes.bits[depth]
    wanted_bits = 24 if depth == 24 and told.get("bpp24") else native
    expect_equal(client.bits[depth], wanted_bits, (depth, told))
    expect_equal(client.byte_order, "big" if told.get("msb") else "little", told)
    target = client.make_pixmap(depth)

    obedient = client.stored(rows, wanted_bits, client.byte_order)
    client.put(target, depth, obedient)
    heard = client.get(target[0])[x11.UNIT :]
    expect(heard == obedient, depth, told, "the client reads another picture")
    wanted = eyes.stored(rows, native, "little")
    expect(eyes.get(target[0])[x11.UNIT :] == wanted, depth, told, "the server has another")

    naive = client.stored(rows, wanted_bits, "little")
    client.put(target, depth, naive)
    client.get(target[0])
    is_right = eyes.get(target[0])[x11.UNIT :] == wanted
    expect_equal(is_right, not told.get("msb"), (depth, told, "naive"))
    client.hang_up()
    eyes.hang_up()


def converts_bitmaps():
    rows = colours(1)
    line = lambda row, step: int("".join(map(str, row[::step])), 2)
    with x_server() as server, Proxy(server.display, msb=True) as proxy:
        eyes, client = WireClient(server.display), WireClient(proxy.display)
        target = client.make_pixmap(1)
        big = b"".join((line(row, 1) << 64 - WIDTH).to_bytes(8, "big") for row in rows)
        client.put(target, 1, big)
        expect(client.get(target[0])[x11.UNIT :] == big, "the client reads another bitmap")
        little = b"".join(line(row, -1).to_bytes(8, "little") for row in rows)
        expect(eyes.get(target[0])[x11.UNIT :] == little, "the server has another bitmap")


# ---- shared memory ------------------------------------------------------------------------------


@contextlib.contextmanager
def segment(size):
    """The number of a segment of shared memory."""
    libc = ctypes.CDLL(None, use_errno=True)
    number = libc.shmget(0, size, 0o1600)
    expect(number >= 0, "shmget")
    yield number
    libc.shmctl(number, 0, None)


def puts_by_shm(display, count):
    """Kinds of the answers to an attachment and to so many pictures: 0 is an error."""
    with segment(4 * WIDTH * HEIGHT) as number:
        client = WireClient(display)
        present, shm, event, error = client.extension(x11.SHM)
        if not present:
            return "absent"
        version = client.ask(shm, 0)
        expect_equal(version[0], x11.REPLY)
        target, name = client.make_pixmap(24), client.base + 9
        client.send(shm, 1, struct.pack("<IIxxxx", name, number))
        answers = [client.next_answer()]
        for _ in range(count):
            if answers[-1][0] == x11.ERROR:
                break
            body = struct.pack("<IIHHHHHHhhBBBxII", *target, *SIZE, 0, 0, *SIZE, 0, 0, 24, 2, 1,
                               name, 0)
            client.send(shm, 3, body)
            answers.append(client.next_answer())
        meanings = {x11.BAD_REQUEST: "BadRequest", x11.BAD_ACCESS: "BadAccess", error: "BadShmSeg"}
        kinds = {x11.REPLY: "no answer", event: "completion"}
        client.hang_up()
        return [
            meanings[each[1]] if each[0] == x11.ERROR else kinds[each[0] & 127] for each in answers
        ]


def breaks_shared_memory():
    good = ["no answer", "completion", "completion", "completion"]
    cases = (
        ({}, good),
        ({"hide": (x11.SHM,)}, "absent"),
        ({"msb": True}, "absent"),
        ({"hide": ("BIG-REQUESTS",)}, good),
        ({"shm_badrequest": True}, ["BadRequest"]),
        ({"shm_badaccess": True}, ["BadAccess"]),
        ({"shm_break": 2}, good[:2] + ["BadShmSeg"]),
        ({"shm_swallow": 3}, good[:3] + ["no answer"]),
    )
    with x_server() as server:
        for faults, wanted in cases:
            with Proxy(server.display, **faults) as proxy:
                expect_equal(puts_by_shm(proxy.display, 3), wanted, faults)


# ---- the wire -----------------------------------------------------------------------------------


def hides_from_the_list():
    with x_server() as server, Proxy(server.display, hide=("XTEST",)) as proxy:
        direct = WireClient(server.display).ask(x11.LIST_EXTENSIONS, 0)
        hidden = WireClient(proxy.display).ask(x11.LIST_EXTENSIONS, 0)
    expect(b"\5XTEST" in direct and b"\5XTEST" not in hidden, direct, hidden)
    expect_equal(hidden[1], direct[1] - 1)
    expect_equal(len(hidden), x11.answer_size(hidden, "<"))


def is_slow():
    """A hundred pictures at a rate at which they take a second."""
    client_bytes = 100 * (24 + 4 * WIDTH * HEIGHT)
    with x_server() as server, Proxy(server.display, rate=client_bytes) as proxy:
        client = WireClient(proxy.display)
        target, start = client.make_pixmap(24), time.monotonic()
        for _ in range(100):
            client.put(target, 24, bytes(4 * WIDTH * HEIGHT))
        client.get(target[0])
        expect(time.monotonic() - start > 0.9, "too fast")


def dies():
    with x_server() as server, Proxy(server.display, die_after=3) as proxy:
        client = WireClient(proxy.display)
        client.ask(x11.GET_INPUT_FOCUS, 0)
        client.ask(x11.GET_INPUT_FOCUS, 0)
        expect_gone(lambda: client.ask(x11.GET_INPUT_FOCUS, 0))
        expect_gone(lambda: WireClient(proxy.display))
        conversation(server.display)


def expect_gone(action):
    try:
        action()
    except TimeoutError:
        pass
    except (OSError, EOFError):
        return
    raise AssertionError("no end of the connection")


def kills_the_server():
    with x_server() as server:
        with Proxy(server.display, die_after=2, kill_server=server.pid) as proxy:
            client = WireClient(proxy.display)
            client.ask(x11.GET_INPUT_FOCUS, 0)
            expect_gone(lambda: client.ask(x11.GET_INPUT_FOCUS, 0))
            expect_equal(server.wait(timeout=harness.PATIENCE), -signal.SIGKILL)


def freezes():
    with x_server() as server, Proxy(server.display, freeze_after=2) as proxy:
        client = WireClient(proxy.display)
        client.ask(x11.GET_INPUT_FOCUS, 0)
        client.socket.settimeout(0.3)
        try:
            client.ask(x11.GET_INPUT_FOCUS, 0)
        except socket.timeout:
            return
        raise AssertionError("there is still an answer")


def main():
    print("seed", SEED)
    checks = Checks()
    for check in (
        changes_nothing, counts, runs_by_hand, converts_pictures, converts_bitmaps,
        breaks_shared_memory, hides_from_the_list, is_slow, dies, kills_the_server, freezes,
    ):
        checks.run("x_proxy." + check.__name__, check)
    checks.finish()


if __name__ == "__main__":
    main()
