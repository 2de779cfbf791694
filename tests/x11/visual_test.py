#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The same picture on every kind of display, as its pixels allow."""

import harness
from harness import Checks, Shown, expect, expect_equal, memory_picture, wait_for, x_server
from x_proxy import Proxy

BACKENDS = ("ximage",)
TEAPOT = harness.PROGRAMS[-1]
COLOURED = ("--shade", "normals")  # tells red from blue


def quantised(rows, depth, masks):
    """The rule of screen_info.h: v * max / 255, rounded down below 8 bits, else to nearest."""
    tables = []
    for mask, at in zip(masks, (16, 8, 0)):
        shift = (mask & -mask).bit_length() - 1
        largest = mask >> shift
        rounding = 127 if largest > 255 else 0
        tables.append((at, [(v * largest + rounding) // 255 << shift for v in range(256)]))
    opaque = 0xFFFFFFFF & ~sum(masks) if depth == 32 else 0
    return [
        [opaque | sum(table[word >> at & 255] for at, table in tables) for word in row]
        for row in rows
    ]


def shows_exactly(backend, depth, display_of=None, **faults):
    with x_server("-screen", "0", "300x200x%d" % depth) as server:
        with Proxy(server.display, **faults) as proxy:
            with Shown(TEAPOT, server, "--backend", backend, *COLOURED,
                       display=proxy.display if faults else None) as it:
                found, _, masks, _ = it.eyes.visual(it.window)
                expect_equal(found, depth)
                wanted = quantised(memory_picture(TEAPOT, *COLOURED), depth, masks)
                pixels = lambda: it.eyes.pixels(it.window, *TEAPOT.size)
                wait_for(lambda: pixels() == wanted, "the picture that memory holds")
                it.press("q")
                it.expect_end(0)


def main():
    checks = Checks()
    for backend in BACKENDS:
        for depth in (15, 16, 24, 30):
            name = "visual.%s.depth_%d" % (backend, depth)
            checks.run(name, shows_exactly, backend, depth)
    for told in ({"msb": True}, {"bpp24": True}, {"msb": True, "bpp24": True}):
        for depth in (24,) if "bpp24" in told else (16, 24, 30):
            name = "visual.%s.depth_%d" % ("_".join(told), depth)
            checks.run(name, lambda: shows_exactly("ximage", depth, **told))
    checks.finish()


if __name__ == "__main__":
    main()
