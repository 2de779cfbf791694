#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A display that stands before an X server, counts what passes, and misbehaves as told.

A test writes `with Proxy(":1", msb=True) as proxy:` and starts a program on `proxy.display`; by
hand, `x_proxy.py :1 --msb` prints the display to use and stays until Ctrl-C.
"""

import argparse
import collections
import contextlib
import json
import os
import signal
import socket
import struct
import threading
import time
from dataclasses import dataclass, field, replace

import x_protocol as x11

FIRST_DISPLAY, LAST_DISPLAY = 1000, 1999  # Xvfb counts from 0
FIRST_PORT = 6000


@dataclass
class Faults:
    """What the proxy does otherwise than a good wire to a good server."""

    msb: bool = False  # tell and convert: most significant byte first
    bpp24: bool = False  # tell and convert: depth 24 in 24 bits
    hide: tuple = ()  # names of extensions that are not there
    shm_badrequest: bool = False  # as Xorg for the clients of ssh
    shm_badaccess: bool = False  # no segment can be attached
    shm_no_files: bool = False  # as servers before MIT-SHM 1.2
    shm_break: int = 0  # from this ShmPutImage on they are answered with BadShmSeg
    shm_swallow: int = 0  # from this ShmPutImage on they vanish without completion
    rate: float = 0  # bytes per second from the client; 0: no limit
    delay: float = 0  # seconds that all takes in each direction
    die_after: int = -1  # the display goes away after so many requests of all clients
    freeze_after: int = -1  # nothing passes any more, and nobody is told
    kill_server: int = 0  # process number of the server, to be killed when the display goes away

    def hides(self, name):
        # Shared memory would bypass the conversion.
        return name in self.hide or (name == x11.SHM and (self.msb or self.bpp24))


@dataclass
class Traffic:
    """What passed so far; one can be subtracted from a later one."""

    requests: list = field(default_factory=list)  # names in order
    times: list = field(default_factory=list)  # of the requests, in seconds
    replied: list = field(default_factory=list)  # those that had a reply: round trips
    boxes: list = field(default_factory=list)  # of pictures: left, top, width, height
    bytes_up: int = 0
    bytes_down: int = 0

    def copy(self):
        lists = ("requests", "times", "replied", "boxes")
        return replace(self, **{name: getattr(self, name)[:] for name in lists})

    def add_request(self, name, size, box):
        self.requests.append(name)
        self.times.append(time.monotonic())
        self.boxes.extend([box] if box else [])
        self.bytes_up += size

    def add_answer(self, replied, size):
        self.replied.extend(replied)
        self.bytes_down += size

    def __sub__(self, earlier):
        return Traffic(
            self.requests[len(earlier.requests) :],
            self.times[len(earlier.times) :],
            self.replied[len(earlier.replied) :],
            self.boxes[len(earlier.boxes) :],
            self.bytes_up - earlier.bytes_up,
            self.bytes_down - earlier.bytes_down,
        )

    def summary(self):
        return {
            "requests": len(self.requests),
            "round_trips": len(self.replied),
            "bytes_up": self.bytes_up,
            "bytes_down": self.bytes_down,
            "by_name": dict(collections.Counter(self.requests)),
        }


class Connection:
    """One client: a thread for each direction."""

    def __init__(self, proxy, client, server):
        self.proxy, self.faults, self.sockets = proxy, proxy.faults, (client, server)
        self.up = x11.Pipe(client, server, proxy.faults.delay)
        self.down = x11.Pipe(server, client, proxy.faults.delay)
        self.picture_format = x11.PictureFormat(self.faults.msb, self.faults.bpp24)
        self.traffic = Traffic()
        self.asked = {}  # low 16 bits of the number of a request: its name, how to change a reply
        self.extensions, self.first_errors = {}, {}  # by major opcode

    def start(self):
        threading.Thread(target=self.guarded, args=(self.greet_and_pass_requests,)).start()

    def guarded(self, work):
        """Works until either side ends; then both do."""
        try:
            with contextlib.suppress(OSError, EOFError):
                work()
        finally:
            self.close()

    def close(self):
        for each in self.sockets:
            with contextlib.suppress(OSError):
                each.shutdown(socket.SHUT_RDWR)

    def greet_and_pass_requests(self):
        self.proxy.await_permission()
        greeting = self.up.first(x11.greeting_size)
        self.order = x11.order_of(greeting)
        self.up.write(greeting)
        setup = self.down.first(lambda data: x11.setup_size(data, self.order))
        if setup[0] == 1:  # accepted
            setup, self.bits = self.picture_format.tell(setup, self.order)
        self.down.write(setup)
        threading.Thread(target=self.guarded, args=(self.pass_answers,)).start()
        self.pass_requests()

    # ---- from the client ----

    def pass_requests(self):
        more = True
        while more:
            while request := x11.take(self.up.data, x11.request_size(self.up.data, self.order)):
                self.pass_request(request)
            more = self.up.read()
            if self.faults.rate:
                time.sleep(more / self.faults.rate)

    def pass_request(self, request):
        name = x11.request_name(request, self.extensions)
        sent, change = self.changed(name, request)
        noted = name, len(request), x11.picture_box(name, request, self.order)
        self.traffic.add_request(*noted)
        self.asked[len(self.traffic.requests) & 0xFFFF] = name, change
        if sent is not request:
            self.up.drop_files()  # which no other request would take
        is_last = self.proxy.note(*noted)
        self.up.write(sent)
        if is_last:
            self.proxy.die()
        self.proxy.await_permission()

    def changed(self, name, request):
        """What goes to the server in place of a request, and how to change the reply."""
        if name.startswith(x11.SHM):
            return self.changed_shm(name, request)
        if name == "PutImage":
            return self.converted(request), None
        if name == "GetImage":
            kind, width = request[1], self.numbers(request, "H", 12)[0]
            return request, lambda reply: self.converted_reply(reply, kind, width)
        if name == "QueryExtension":
            asked = request[8 : 8 + self.numbers(request, "H", 4)[0]].decode("latin-1")
            return request, lambda reply: self.learned(reply, asked)
        if name == "ListExtensions":
            return request, self.without_hidden
        if name == "BIG-REQUESTS.0" and self.faults.bpp24:
            return request, self.shortened
        return request, None

    def changed_shm(self, name, request):
        faults = self.faults
        # A request with a short reply keeps the place in the sequence; the reply becomes an error.
        harmless = struct.pack(self.order + "BBH", x11.GET_INPUT_FOCUS, 0, 1)
        error = lambda code: (
            harmless, lambda reply: x11.error_like(reply, self.order, code, request))
        if faults.shm_badrequest and name != x11.SHM + ".QueryVersion":
            return error(x11.BAD_REQUEST)
        if faults.shm_badaccess and name.startswith(x11.SHM + ".Attach"):
            return error(x11.BAD_ACCESS)
        if faults.shm_no_files and name == x11.SHM + ".AttachFd":
            return error(x11.BAD_REQUEST)
        if faults.shm_no_files and name == x11.SHM + ".QueryVersion":
            return request, lambda reply: reply[:10] + struct.pack(self.order + "H", 1) + reply[12:]
        if name == x11.SHM + ".PutImage":
            number = 1 + self.proxy.traffic.requests.count(name)
            if 0 < faults.shm_break <= number:
                return error(self.first_errors[request[0]])
            if 0 < faults.shm_swallow <= number:
                return struct.pack(self.order + "BBH", x11.NO_OPERATION, 0, 1), None
        return request, None

    def converted(self, request):
        is_long = self.numbers(request, "H", 2)[0] == 0
        body = 8 if is_long else 4  # behind opcode, format and length
        width = self.numbers(request, "H", body + 8)[0]
        kind, depth = request[1], request[body + 17]
        data = self.picture_format.to_server(
            request[body + 20 :], kind, depth, self.bits[depth], width
        )
        units = (body + 20 + len(data)) // 4
        length = struct.pack(self.order + ("xxI" if is_long else "H"), units)
        return request[:2] + length + request[body : body + 20] + data

    # ---- from the server ----

    def pass_answers(self):
        more = True
        while more:
            while answer := x11.take(self.down.data, x11.answer_size(self.down.data, self.order)):
                self.pass_answer(answer)
            more = self.down.read()

    def pass_answer(self, answer):
        self.proxy.await_permission()
        replied = []
        if answer[0] == x11.REPLY:
            number = x11.sequence_of(answer, self.order)
            name, change = self.asked.get(number, ("", None))
            answer = change(answer) if change else answer
            replied.append(name)
        for traffic in (self.traffic, self.proxy.traffic):
            traffic.add_answer(replied, len(answer))
        self.down.write(answer)

    def converted_reply(self, reply, kind, width):
        depth = reply[1]
        data = self.picture_format.to_client(
            reply[x11.UNIT :], kind, depth, self.bits.get(depth), width
        )
        return self.with_more(reply, data)

    def learned(self, reply, name):
        """QueryExtension's reply tells present, major opcode, first event, first error."""
        if self.faults.hides(name):
            return reply[:8] + bytes(4) + reply[12:]
        if reply[8]:
            self.extensions[reply[9]] = name
            self.first_errors[reply[9]] = reply[11]
        return reply

    def without_hidden(self, reply):
        at, kept = x11.UNIT, []
        for _ in range(reply[1]):
            name = reply[at + 1 : at + 1 + reply[at]]
            if not self.faults.hides(name.decode("latin-1")):
                kept.append(reply[at : at + 1 + reply[at]])
            at += 1 + reply[at]
        names = b"".join(kept)
        names = names.ljust(x11.padded(len(names)), b"\0")
        return self.with_more(reply[:1] + bytes([len(kept)]) + reply[2:], names)

    def shortened(self, reply):
        """The longest request, which the conversion may lengthen by a third."""
        longest = self.numbers(reply, "I", 8)[0] * 3 // 4
        return reply[:8] + struct.pack(self.order + "I", longest) + reply[12:]

    # ---- both ----

    def numbers(self, message, layout, at):
        return struct.unpack_from(self.order + layout, message, at)

    def with_more(self, reply, data):
        length = struct.pack(self.order + "I", len(data) // 4)
        return reply[:4] + length + reply[8 : x11.UNIT] + data


class Proxy:
    """Listens as `display`, and over TCP as `tcp_display`, until the end of the block."""

    kind = Connection

    def __init__(self, server_display, **faults):
        self.server_display = server_display
        self.faults = Faults(**faults)
        self.traffic = Traffic()
        self.connections = []
        self.lock = threading.Lock()
        self.is_listening = False
        self.running = threading.Event()
        self.running.set()
        if self.faults.freeze_after == 0:
            self.running.clear()

    def __enter__(self):
        self.listen()
        for listener in self.listeners:
            threading.Thread(target=self.accept_all, args=(listener,)).start()
        if self.faults.die_after == 0:
            self.die()
        return self

    def __exit__(self, *_):
        self.close()

    def listen(self):
        first = FIRST_DISPLAY + os.getpid() % 500
        number = next(each for each in range(first, LAST_DISPLAY) if self.takes(each))
        self.display = ":%d" % number
        self.tcp_display = "127.0.0.1:%d" % number
        for listener in self.listeners:
            listener.listen(8)
        self.is_listening = True

    def takes(self, number):
        """Makes the sockets of this display, unless there is one already."""
        self.path = "/tmp/.X11-unix/X%d" % number
        self.listeners = tcp, unix = socket.socket(), socket.socket(socket.AF_UNIX)
        try:
            # A port is given back by the kernel, a path by us: whoever has the port has both.
            tcp.bind(("127.0.0.1", FIRST_PORT + number))
            unix.bind(self.path)
        except OSError:
            tcp.close()
            unix.close()
            return False
        return True

    def accept_all(self, listener):
        with contextlib.suppress(OSError):
            while True:
                client, _ = listener.accept()
                server = socket.socket(socket.AF_UNIX)
                self.connections.append(self.kind(self, client, server))
                with contextlib.suppress(OSError):  # a dead server: the client will see the end
                    server.connect("/tmp/.X11-unix/X" + self.server_display.lstrip(":"))
                self.connections[-1].start()

    def close(self):
        with self.lock:
            was_listening, self.is_listening = self.is_listening, False
        if was_listening:
            os.unlink(self.path)  # while we have the port; then both are somebody else's
            for listener in self.listeners:
                with contextlib.suppress(OSError):
                    listener.shutdown(socket.SHUT_RDWR)
                listener.close()
        for connection in self.connections:
            connection.close()
        self.running.set()

    def note(self, name, size, box):
        """Counts a request that is about to pass. Returns whether the display dies of it; then,
        and when all freezes, nothing comes back any more."""
        with self.lock:
            self.traffic.add_request(name, size, box)
            count = len(self.traffic.requests)
        if count in (self.faults.die_after, self.faults.freeze_after):
            self.running.clear()
        return count == self.faults.die_after

    def await_permission(self):
        """Returns at once unless the wire is frozen."""
        self.running.wait()

    def die(self):
        if self.faults.kill_server:
            os.kill(self.faults.kill_server, signal.SIGKILL)
        self.close()

    def mark(self):
        """What passed so far, to be subtracted from what will have."""
        with self.lock:
            return self.traffic.copy()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("server", help="display of the real server, such as :1")
    parser.add_argument("--counts", help="JSON lines on SIGUSR1 and at the end: all, since last")
    parser.add_argument("--hide", action="append", default=[], metavar="EXTENSION")
    parser.add_argument("--no-shm", action="append_const", dest="hide", const=x11.SHM)
    for name, value in vars(Faults()).items():
        option = "--" + name.replace("_", "-")
        if isinstance(value, bool):
            parser.add_argument(option, action="store_true")
        elif name != "hide":
            parser.add_argument(option, type=type(value), default=value, metavar="N")
    faults = vars(parser.parse_args())
    server, counts = faults.pop("server"), faults.pop("counts")
    signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGUSR1, signal.SIGINT, signal.SIGTERM])
    with Proxy(server, **faults) as proxy:
        print(proxy.display, proxy.tcp_display, flush=True)
        last, number = Traffic(), 0
        while number not in (signal.SIGINT, signal.SIGTERM):
            number = signal.sigwait([signal.SIGUSR1, signal.SIGINT, signal.SIGTERM])
            if (now := proxy.mark()) and counts:
                with open(counts, "a") as file:
                    json.dump({"all": now.summary(), "since_last": (now - last).summary()}, file)
                    file.write("\n")
            last = now


if __name__ == "__main__":
    main()
