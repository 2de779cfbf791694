#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""One picture of all programs, in the order of tests/golden/programs.txt: each draws its own tile."""

import os
import struct
import sys
import zlib

import harness
from harness import environment, expect_equal, folder, run
from programs_test import FRAMES, table

TILE = (240, 180)
GAP = 6
COLUMNS = 4
PAPER = 0x404040


def tile(row):
    """What the program shows at the end of the frames that the test compares."""
    program = harness.Program(row.name, TILE)
    with folder() as path:
        file = os.path.join(path, "tile.png")
        options = ["--backend", "memory", "--frames", str(FRAMES), "--output", file]
        command = program.command(*row.arguments, *options)
        expect_equal(run(command, environment())[0], 0, row.title)
        return harness.read_png(file)


def sheet(tiles):
    width, height = TILE
    lines = -(-len(tiles) // COLUMNS)
    picture = [
        [PAPER] * (COLUMNS * (width + GAP) + GAP) for _ in range(lines * (height + GAP) + GAP)
    ]
    for i, rows in enumerate(tiles):
        left = GAP + i % COLUMNS * (width + GAP)
        top = GAP + i // COLUMNS * (height + GAP)
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
    one_of_each = {row.title: row for row in table() if not row.is_console}
    write_png(sys.argv[1], sheet([tile(row) for row in one_of_each.values()]))
