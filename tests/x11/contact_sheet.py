#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Pictures made of many, drawn by the programs themselves, into the folder that is named:
programs.png has all programs in the order of tests/golden/programs.txt, polygons.png three models as
lines and surfaces, eight_bits.png the teapot on displays of 8 bits, surfview.png its window."""

import contextlib
import os
import struct
import sys
import zlib

import harness
from harness import Shown, environment, expect_equal, folder, memory_picture, run, wait_for, x_server
from programs_test import FRAMES, table
from view_test import Window
from visual_test import CLASSES, FARTHEST, is_close

PAPER = 0x404040
MODELS = ("thing.asc", "ball.asc", "torus.off")
STYLES = (["--wireframe"], ["--hidden-lines"], ["--shade", "flat"],
          ["--shade", "lambert"])


def tile(size, name, *arguments):
    program = harness.Program(name, size)
    with folder() as path:
        file = os.path.join(path, "tile.png")
        command = program.command(*arguments, "--backend", "memory", "--output", file)
        expect_equal(run(command, environment())[0], 0, command)
        return harness.read_png(file)


def programs():
    """What each shows at the end of the frames that the test compares."""
    rows = {row.title: row for row in table()
            if not row.is_console and "--classic" not in row.arguments}
    return [tile((240, 180), row.name, *row.arguments, "--frames", str(FRAMES))
            for row in rows.values()]


def polygons():
    upright = ["--pipeline", "zsort", "--up", "0,0,1"]
    return [tile((320, 240), "modelview", "--model", model, *upright, *style)
            for model in MODELS for style in STYLES]


def window_of_8_bits(name):
    """What the window shows, in the colours that the display gives its pixels."""
    teapot = harness.Program("teapot_afd", (320, 200))
    black = ("--background", "0,0,0")  # a dither of few levels is less close than of many
    with x_server("-screen", "0", "400x300x8", "-cc", str(CLASSES.index(name))) as server:
        with Shown(teapot, server, "--backend", "ximage", *harness.COUNTED, *black) as it:
            _, _, _, map_of = it.eyes.visual(it.window)
            wanted = memory_picture(teapot, *black)
            pixels = lambda: it.eyes.pixels(it.window, *teapot.size)
            wait_for(lambda: is_close(pixels(), map_of, wanted, FARTHEST[name]), "a picture")
            return [[map_of[pixel] for pixel in row] for row in pixels()]


def eight_bits():
    return [window_of_8_bits(name) for name in CLASSES]


def surfview():
    """A window with its list of parts and a section, and what was measured there."""
    with contextlib.ExitStack() as stack:
        it = Window(stack, "surfview", "--section", "-1,0,-1", "--section-at", "0.9,0,0.9", "--shade", "mean",
                    size=(640, 400))
        it.does("a place", *it.at(300, 180), "keydown", "ctrl", "click", 1, "keyup", "ctrl")
        it.does("a distance", *it.at(400, 240), "keydown", "ctrl", "click", 1, "keyup", "ctrl")
        return [it.picture()]


def sheet(tiles, columns, gap):
    width, height = len(tiles[0][0]), len(tiles[0])
    lines = -(-len(tiles) // columns)
    picture = [
        [PAPER] * (columns * (width + gap) + gap) for _ in range(lines * (height + gap) + gap)
    ]
    for i, rows in enumerate(tiles):
        left = gap + i % columns * (width + gap)
        top = gap + i // columns * (height + gap)
        for y, row in enumerate(rows):
            picture[top + y][left : left + width] = row
    return picture


def write_png(path, picture):
    def chunk(kind, body):
        checked = kind + body
        return struct.pack(">I", len(body)) + checked + struct.pack(">I", zlib.crc32(checked))

    head = struct.pack(">IIBBBBB", len(picture[0]), len(picture), 8, 2, 0, 0, 0)
    lines = (b"\0" + b"".join(p.to_bytes(3, "big") for p in row) for row in picture)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head))
        file.write(chunk(b"IDAT", zlib.compress(b"".join(lines), 9)) + chunk(b"IEND", b""))


if __name__ == "__main__":
    for name, tiles, columns, gap in (("programs", programs(), 4, 6), ("polygons", polygons(), 4, 0),
                                      ("eight_bits", eight_bits(), 3, 6), ("surfview", surfview(), 1, 0)):
        write_png(os.path.join(sys.argv[1], name + ".png"), sheet(tiles, columns, gap))
