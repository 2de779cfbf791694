#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The error report: what each method costs at which error, as text, numbers and diagrams."""

import csv
import json
import os
import struct

import harness
from harness import Checks, environment, expect, expect_equal, folder, run

METHODS = ("afd float", "afd double", "fd 16.16", "isocurves", "subdivision", "tessellation",
           "micropolygons", "scanline", "voxels")
DIAGRAMS = ("work_precision_full", "work_precision_closeup", "work_precision_top",
            "error_by_steps", "chord_error", "arithmetic")

# A report draws with every method at every tolerance: 4 s on two idle cores, 20 s if sanitized.
SANITIZED_TIMES = 5


def report(path, program, *more, env=None):
    command = program.command("--error-report", path, "--quick", *more)
    return run(command, env or environment(), SANITIZED_TIMES * harness.PATIENCE)


def is_whole(program):
    with folder() as path:
        status, _, messages = report(path, program)
        expect_equal(status, 0, messages)
        expect(messages.endswith(path + "/report.md\n"), messages[-200:])
        with open(os.path.join(path, "frames.csv"), newline="") as file:
            rows = list(csv.DictReader(file))
        for method in METHODS:
            expect(any(row["method"].startswith(method) for row in rows), method)
        for row in rows:
            expect(float(row["least_ms"]) > 0, row)
            bound = float("inf" if row["bound_px"] == "none" else row["bound_px"])
            # Of pictures of 52 x 39 pixels, 38 % is at outlines.
            expect(0.5 < float(row["judged_share"]) <= 1, row)
            expect(float(row["outline_px"]) <= bound and float(row["largest_px"]) >= 0, row)
        with open(os.path.join(path, "report.json")) as file:
            expect_equal(len(json.load(file)["frames"]), len(rows))
        for diagram in DIAGRAMS:
            with open(os.path.join(path, diagram + ".svg")) as file:
                text = file.read()
            expect(text.rstrip().endswith("</svg>") and text.count("<path") > 10, diagram)
            with open(os.path.join(path, diagram + ".png"), "rb") as file:
                expect_equal(struct.unpack(">II", file.read(24)[16:]), (1100, 680), diagram)


def keeps_its_numbers_without_gnuplot(program):
    with folder() as path:
        status, _, messages = report(path, program, env={**environment(), "PATH": path})
        expect_equal(status, 0, messages)
        expect("gnuplot cannot be run; the diagrams' scripts are in " + path in messages, messages)
        for name in ("report.md", "frames.csv", "curves.csv", "work_precision_full.gp"):
            expect(os.path.getsize(os.path.join(path, name)) > 0, name)


def refuses_a_folder_that_is_a_file(program):
    with folder() as path:
        name = os.path.join(path, "taken")
        with open(name, "w") as file:
            file.write("mine")
        status, _, messages = report(name, program)
        expect(status != 0 and name in messages, status, messages)
        with open(name) as file:
            expect_equal(file.read(), "mine")


if __name__ == "__main__":
    checks = Checks()
    for program in harness.PROGRAMS:
        if program.name == "teapot_afd":
            for check in (is_whole, keeps_its_numbers_without_gnuplot,
                          refuses_a_folder_that_is_a_file):
                checks.run("report." + check.__name__, check, program)
    checks.finish()
