#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The error report: what each method costs at which error, as text, numbers and diagrams."""

import csv
import json
import os
import struct
import subprocess
import sys

import harness
from harness import Checks, environment, expect, expect_equal, folder, run

METHODS = ("afd float", "afd double", "afd places only", "fd 16.16", "isocurves", "subdivision", "tessellation",
           "micropolygons", "kept", "scanline", "whitted", "blinn", "lane-carpenter", "voxels", "zsort", "zbuffer")
DIAGRAMS = ("error_time", "picture_time", "error_and_bound", "error_by_steps", "chord_error", "arithmetic")
QUESTIONS = ("Which is fastest at 0.1 px?", "Does fixed point cost anything?", "When does AFD lose?",
             "How many steps do 16.16 bits bear?", "What does certainty cost?")
OTHERS = ("What do failed iterations cost?", "How do scan lines draw folded patches?", "What do diagonal steps from cell to cell save?",
          "What does smoke cost?", "Does it pay to keep micropolygons?")

DATA = os.path.join(os.path.dirname(harness.BIN), "share/l3d")

# A report draws with every method at two settings and more: 15 s on two busy cores.
SANITIZED_TIMES = 5


def report(path, program, *more, env=None):
    command = program.command("--error-report", path, "--quick", *more)
    return run(command, env or environment(), SANITIZED_TIMES * harness.PATIENCE)


def pages(path, env=None):
    """By the script that the program's last line names."""
    script = os.path.join(DATA, "report", "report_pages.py")
    done = subprocess.run([sys.executable, script, path], env=env or environment(), capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr


def rows_of(path):
    with open(os.path.join(path, "frames.csv"), newline="") as file:
        return list(csv.DictReader(file))


def is_whole(program):
    with folder() as path:
        status, _, messages = report(path, program)
        expect_equal(status, 0, messages)
        said = f"the numbers are in {path}; pages of them: python3 {DATA}/report/report_pages.py {path}\n"
        expect(messages.endswith(said), messages[-300:])
        expect(not os.path.exists(os.path.join(path, "report.md")), "pages that nobody asked for")
        expect_equal(pages(path), (0, path + "/report.md\n", ""))
        rows = rows_of(path)
        for method in METHODS:
            expect(any(row["method"].startswith(method) for row in rows), method)
        expect_equal({row["model"] for row in rows}, {"teapot", "band", "folds"}, "models")
        folded = [row for row in rows if row["model"] == "folds" and row["method"] == "blinn"]
        expect(folded and all(int(row["failures"]) > 0 for row in folded), "failures on folds", folded)
        for row in rows:
            expect(float(row["median_ms"]) > 0, row)
            bound = float("inf" if row["bound_px"] == "none" else row["bound_px"])
            # Of pictures of 52 x 39 pixels, 38 % is at outlines; of those of a thin band, nearly all.
            least = 0.5 if row["model"] == "teapot" else 0.1
            expect(least < float(row["judged_share"]) <= 1, row)
            expect(float(row["outline_px"]) <= bound and float(row["rms_levels"]) >= 0, row)
        has_whole_pages(path, rows)


def has_whole_pages(path, rows):
    with open(os.path.join(path, "machine.json")) as file:
        expect(json.load(file)["quick"], "facts")
    with open(os.path.join(path, "report.md")) as file:
        text = file.read()
    first = text.split("\n## ")[0]
    with open(os.path.join(path, "report.html")) as file:
        page = file.read()
    for question in QUESTIONS:
        expect(question in first and question in page, question)
    for question in OTHERS:
        expect_equal(text.count(question), 2, question)
        expect(question in page, question)
    expect_equal(page.count("http://") + page.count("src="), 0, "what needs a network")
    data = json.loads(page.split("const report = ")[1].split(";\nconst element")[0])
    expect_equal(len(data["rows"]), len(rows), "rows in the page")
    for diagram in DIAGRAMS:
        with open(os.path.join(path, diagram + ".svg")) as file:
            text = file.read()
        expect(text.rstrip().endswith("</svg>") and text.count("<path") > 10, diagram)
        with open(os.path.join(path, diagram + ".png"), "rb") as file:
            expect_equal(struct.unpack(">II", file.read(24)[16:]), (1100, 680), diagram)


def goes_on_where_it_was_stopped(program):
    """Stopped between two rows, or within the writing of one. No other program is found meanwhile."""
    with folder() as path:
        alone = {**environment(), "PATH": path}
        command = program.command("--error-report", path, "--quick")
        part = os.path.join(path, "frames.part.csv")
        with subprocess.Popen(command, env=alone, stderr=subprocess.PIPE, text=True) as stopped:
            for line in stopped.stderr:
                if line.startswith("[6/"):
                    stopped.kill()
                    break
        with open(part) as file:
            measured = file.read().splitlines()[1:]
        expect(len(measured) >= 5, "rows", len(measured))
        with open(part, "a") as file:
            file.write("teapot,full,subdivision,1 px,28,3.3")
        status, _, messages = report(path, program, env=alone)
        expect_equal(status, 0, messages)
        expect(f"{len(measured)} of " in messages and "are there already" in messages, messages[:300])
        expect(not os.path.exists(part), "rows in between")
        kept = [row["median_ms"] for row in rows_of(path)][:5]
        expect_equal(kept, [line.split(",")[5] for line in measured[:5]], "rows measured before")
        for name in ("frames.csv", "curves.csv", "limits.csv", "steps.csv", "scan_lines.csv", "cells.csv", "smoke.csv", "kept.csv",
                     "smoke.png", "scan_folds.png", "machine.json"):
            expect(os.path.getsize(os.path.join(path, name)) > 0, name)
        makes_pages_without_gnuplot(path)


def makes_pages_without_gnuplot(path):
    """The page for browsers draws its own diagrams; the other says nothing of those that are not there."""
    with folder() as tools:
        status, _, messages = pages(path, {**environment(), "PATH": tools})
        expect_equal(status, 0, messages)
        expect("gnuplot cannot be run; the diagrams' scripts are in " + path in messages, messages)
        with open(os.path.join(path, "report.md")) as file:
            expect("error_time" not in file.read(), "a diagram that is not there")
        expect(os.path.getsize(os.path.join(path, "error_time.gp")) > 0, "script")


def leaves_out_what_the_exact_renderer_gives_up_on(program):
    """The near plane cuts what reaches a million times as far; each row says so, and the rest is there."""
    with folder() as path:
        view = ("--eye", "-1.34,0.44,-1.74", "--target", "-0.79,1.81,-1.99", "--fov", "150", "--near", "1e-6")
        status, _, messages = report(path, harness.Program("teapot_afd", (24, 18)), *view)
        expect_equal(status, 1, messages)
        out = "model, view, %s, n = 2: left out: exact region: the nearest point needs too many pieces\n"
        for method in ("tessellation", "zsort"):
            expect(out % method in messages, messages)
        *_, numbers, last = messages.splitlines()
        expect(numbers.startswith("the numbers are in " + path), numbers)
        left_out = messages.count(": left out: ")
        expect_equal(last, f"teapot_afd: --error-report: {left_out} of {left_out + len(rows_of(path))} rows are left out, "
                           "for the reasons above")
        for name in ("curves.csv", "machine.json"):
            expect(os.path.getsize(os.path.join(path, name)) > 0, name)
        if not rows_of(path):
            expect_equal(pages(path), (1, "", f"report_pages.py: {path}/frames.csv has no rows\n"))


def refuses_a_folder_that_is_a_file(program):
    with folder() as path:
        name = os.path.join(path, "taken")
        with open(name, "w") as file:
            file.write("mine")
        status, _, messages = report(name, program)
        expect(status != 0 and name in messages, status, messages)
        with open(name) as file:
            expect_equal(file.read(), "mine")


def refuses_what_it_would_not_do(program):
    with folder() as path:
        for option in ("--output", "--report", "--depth-output", "--error-output"):
            name = os.path.join(path, "o.pfm" if "-" in option[2:] else "o.png")
            status, out, messages = report(os.path.join(path, "report"), program, option, name)
            expect_equal((status, out, messages), (2, b"", f"teapot_afd: {option}: not with --error-report, which draws nothing\n"))
        expect_equal(os.listdir(path), [], "files")
    for wish in (("--pick", "3,3"), ("--explain",), ("--statistics",), ("--compare", "fd"), ("--frames", "2")):
        said = run(program.command("--error-report", "report", *wish), environment())
        expect_equal(said, (2, b"", f"teapot_afd: {wish[0]}: not with --error-report, which draws nothing\n"))
    small = harness.Program("teapot_afd", (400, 5))
    said = run(small.command("--error-report", "report"), environment())
    expect_equal(said, (2, b"", "teapot_afd: --size: '400x5' is too small for --error-report, which needs 6x6\n"))
    said = run(program.command("--backend", "memory", "--quick"), environment())
    expect_equal((said[0], said[2]), (2, "teapot_afd: --quick: goes with --error-report\n"))


if __name__ == "__main__":
    checks = Checks()
    for program in harness.PROGRAMS:
        if program.name == "teapot_afd":
            for check in (is_whole, goes_on_where_it_was_stopped, leaves_out_what_the_exact_renderer_gives_up_on,
                          refuses_a_folder_that_is_a_file, refuses_what_it_would_not_do):
                checks.run("report." + check.__name__, check, program)
    checks.finish()
