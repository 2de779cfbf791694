#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Frames a second of the book's programs with a world, 1024 x 768: as the book paints them, and by depth.

It counts processor time, and takes away that of a run of one frame, so that neither other programs nor
the start count. Worlds are drawn by one thread, so one processor has as many frames in a second. Nothing
is shown. The runs of a program follow each other in turns; the figures are medians."""

import os
import resource
import statistics
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "x11"))

from harness import BIN, environment

PROGRAMS = "spikes", "rotspikes", "camspikes", "clipz", "fltsim", "objcopy", "vidflat"
FRAMES, TURNS = 300, 5


def processor_seconds(name, frames, *arguments):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([os.path.join(BIN, name), "--no-input", "--backend", "memory", "--size", "1024x768", "--frames",
                    str(frames), *arguments], env=environment(), stderr=subprocess.DEVNULL, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


if __name__ == "__main__":
    print("%-10s %18s %18s" % ("program", "painter, frames/s", "by depth, frames/s"))
    for name in PROGRAMS:
        rates = {arguments: [] for arguments in (("--classic",), ())}
        for _ in range(TURNS):
            for arguments, found in rates.items():
                spent = processor_seconds(name, FRAMES + 1, *arguments) - processor_seconds(name, 1, *arguments)
                found.append(FRAMES / spent)
        print("%-10s %18.0f %18.0f" % (name, *(statistics.median(found) for found in rates.values())), flush=True)
