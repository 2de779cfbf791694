#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The same picture on every kind of display, as its pixels allow."""

import functools

import harness
from harness import Checks, Shown, expect_equal, memory_picture, wait_for, x_server
from x_proxy import Proxy

BACKENDS = ("ximage", "xshm")
TEAPOT = harness.PROGRAMS[-1]
# Tells red from blue. A dither of nearly one level, as a gradient has, is less close than of many.
COLOURED = ("--shade", "normals", "--background", "0,0,0")


def threshold(x, y):
    """Which of 64 pixels of a square goes up to the next level first: Bayer's order."""
    rank = 0
    for bit in range(3):
        low = y >> bit & 1
        rank = rank << 2 | (x >> bit & 1 ^ low) << 1 | low
    return rank


def level_of(value, largest, x, y):
    """Below 8 bits the ordered dither of pixel_writer_p.h, else v * max / 255 to nearest."""
    if largest >= 255:
        return (value * largest + 127) // 255
    value_of = lambda level: (2 * 255 * level + largest) // (2 * largest)
    below = max(level for level in range(largest) if value_of(level) <= value)
    gap = value_of(below + 1) - value_of(below)
    raised = (2 * 64 * (value - value_of(below)) + gap) // (2 * gap)
    return below + (threshold(x % 8, y % 8) < raised)


def quantised(rows, depth, masks):
    """What a display with these masks shows."""
    shifts = [(mask & -mask).bit_length() - 1 for mask in masks]
    levels = functools.cache(lambda value, largest, x, y: level_of(value, largest, x, y))
    opaque = 0xFFFFFFFF & ~sum(masks) if depth == 32 else 0
    return [
        [
            opaque | sum(
                levels(word >> at & 255, mask >> shift, x % 8, y % 8) << shift
                for mask, shift, at in zip(masks, shifts, (16, 8, 0))
            )
            for x, word in enumerate(row)
        ]
        for y, row in enumerate(rows)
    ]


def shows_exactly(backend, depth, display_of=None, **faults):
    with x_server("-screen", "0", "300x200x%d" % depth) as server:
        with Proxy(server.display, **faults) as proxy:
            with Shown(TEAPOT, server, "--backend", backend, *harness.COUNTED, *COLOURED,
                       display=proxy.display if faults else None) as it:
                found, _, masks, _ = it.eyes.visual(it.window)
                expect_equal(found, depth)
                wanted = quantised(memory_picture(TEAPOT, *COLOURED), depth, masks)
                pixels = lambda: it.eyes.pixels(it.window, *TEAPOT.size)
                wait_for(lambda: pixels() == wanted, "the picture that memory holds")
                it.press("q")
                it.expect_end(0)


# How far a channel may be off on each class of 8-bit display: less than the step between two of
# its levels, since a dither shows one of the two around a value. In the mean, over a smooth picture,
# it is off by less than a quarter of that. Grays are compared with the brightness of the colour.
THREE_THREE_TWO = (255 / 7, 255 / 7, 255 / 3)
FARTHEST = {
    "StaticGray": (0,),
    "GrayScale": (255 / 31,),
    "StaticColor": THREE_THREE_TWO,
    "PseudoColor": 3 * (255 / 4,),
    "TrueColor": THREE_THREE_TWO,
    "DirectColor": THREE_THREE_TWO,
}
CLASSES = list(FARTHEST)  # in the order of X's numbers


def channels(word, count):
    """Red, green and blue, or, if one is asked for, the brightness by ITU-R BT.601."""
    red, green, blue = word >> 16, word >> 8 & 255, word & 255
    return (red, green, blue) if count > 1 else ((red * 299 + green * 587 + blue * 114 + 500) // 1000,)


def shows_closely(name):
    """Whatever the default is, for a visual with alpha is no better one."""
    number = str(CLASSES.index(name))
    with x_server("-screen", "0", "300x200x8", "-cc", number) as server:
        with Shown(TEAPOT, server, "--backend", "ximage", *harness.COUNTED, *COLOURED) as it:
            depth, kind, _, map_of = it.eyes.visual(it.window)
            expect_equal((depth, CLASSES[kind]), (8, name))
            wanted = memory_picture(TEAPOT, *COLOURED)
            pixels = lambda: it.eyes.pixels(it.window, *TEAPOT.size)
            wait_for(lambda: is_close(pixels(), map_of, wanted, FARTHEST[name]), "a close picture")
            it.press("q")
            it.expect_end(0)


def is_close(pixels, map_of, wanted, farthest):
    """All differences, and their mean; a picture that is not there yet is far."""
    shown = [map_of[pixel] for row in pixels for pixel in row]
    words = [word for row in wanted for word in row]
    for at, limit in enumerate(farthest):
        differences = [
            abs(channels(colour, len(farthest))[at] - channels(word, len(farthest))[at])
            for colour, word in zip(shown, words)
        ]
        if max(differences) > limit or sum(differences) > limit / 4 * len(differences):
            return False
    return True


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
    for name in CLASSES:
        checks.run("visual.closely." + name, shows_closely, name)
    checks.finish()


if __name__ == "__main__":
    main()
