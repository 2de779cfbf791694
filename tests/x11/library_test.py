#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The library reports; whether a program ends is the program's decision."""

import os
import subprocess

import harness
from harness import Checks, expect, expect_equal

LAYERS = ("geom", "tool_2d", "raster", "dice", "pipeline", "system")
ENDS_A_PROGRAM = {"exit", "_exit", "_Exit", "quick_exit", "abort"}


def never_ends_the_program():
    folder = os.path.dirname(harness.BIN)
    archives = [os.path.join(folder, "libl3d_%s.a" % layer) for layer in LAYERS]
    found, seen = [], set()
    for archive in archives:
        for line in listed("--undefined-only", archive):
            seen.add(line[-1])
            if line[-1] in ENDS_A_PROGRAM:
                found.append((os.path.basename(archive), line[-1]))
    expect("XOpenDisplay" in seen, "nm shows less than the library calls")
    expect_equal(found, [])


def listed(*arguments):
    """The lines of nm that name a symbol, as words; a version after @ is dropped."""
    done = subprocess.run(["nm", *arguments], stdout=subprocess.PIPE, text=True, check=True)
    return [line.split("@")[0].split() for line in done.stdout.splitlines() if " U " in line]


if __name__ == "__main__":
    checks = Checks()
    checks.run("library.never_ends_the_program", never_ends_the_program)
    checks.finish()
